//! Colours that colour-blind people distinguish (Okabe and Ito), and the window's style.

use eframe::egui::{self, Color32, CornerRadius, FontId, Style, TextStyle, Theme, Visuals};
use telemetry::Severity;

use crate::grid;

pub(crate) const ORANGE: Color32 = Color32::from_rgb(0xE6, 0x9F, 0x00);
pub(crate) const SKY: Color32 = Color32::from_rgb(0x56, 0xB4, 0xE9);
pub(crate) const GREEN: Color32 = Color32::from_rgb(0x00, 0x9E, 0x73);
pub(crate) const YELLOW: Color32 = Color32::from_rgb(0xF0, 0xE4, 0x42);
pub(crate) const BLUE: Color32 = Color32::from_rgb(0x00, 0x72, 0xB2);
pub(crate) const VERMILLION: Color32 = Color32::from_rgb(0xD5, 0x5E, 0x00);
pub(crate) const PURPLE: Color32 = Color32::from_rgb(0xCC, 0x79, 0xA7);

/// Colours of modes: the paper's two come first.
const MODES: [Color32; 6] = [SKY, ORANGE, GREEN, PURPLE, YELLOW, BLUE];

/// Colours of lines on dark ground, and on light.
const LINES: [[Color32; 2]; 6] = [
    [SKY, BLUE],
    [ORANGE, Color32::from_rgb(0xB8, 0x7A, 0x00)],
    [Color32::from_rgb(0x2C, 0xC4, 0x96), GREEN],
    [PURPLE, Color32::from_rgb(0xA8, 0x4E, 0x80)],
    [YELLOW, Color32::from_rgb(0x8C, 0x82, 0x00)],
    [Color32::from_rgb(0xFF, 0x84, 0x3D), VERMILLION],
];

pub(crate) fn mode(mode: u8) -> Color32 {
    MODES[usize::from(mode) % MODES.len()]
}

pub(crate) fn line(i: usize, ui: &egui::Ui) -> Color32 {
    let of_theme = LINES[i % LINES.len()];
    if ui.visuals().dark_mode { of_theme[0] } else { of_theme[1] }
}

pub(crate) fn grid(ui: &egui::Ui) -> Color32 {
    faint(ui.visuals().weak_text_color(), 0.45)
}

/// Returns a spacer that draws about `lines` grid lines, at round numbers.
pub(crate) fn spacer(
    lines: f64,
) -> impl Fn(egui_plot::GridInput) -> Vec<egui_plot::GridMark> + 'static {
    egui_plot::uniform_grid_spacer(move |input: egui_plot::GridInput| {
        let step = grid::step(input.bounds, lines);
        [step, 10.0 * step, 100.0 * step]
    })
}

pub(crate) fn spacer_across(
    points: f32,
) -> impl Fn(egui_plot::GridInput) -> Vec<egui_plot::GridMark> + 'static {
    spacer(grid::lines_across(points))
}

pub(crate) fn spacer_up(
    points: f32,
) -> impl Fn(egui_plot::GridInput) -> Vec<egui_plot::GridMark> + 'static {
    spacer(grid::lines_up(points))
}

pub(crate) const fn selected(visuals: &Visuals) -> Color32 {
    if visuals.dark_mode { YELLOW } else { BLUE }
}

pub(crate) fn fault(ui: &egui::Ui) -> Color32 {
    if ui.visuals().dark_mode { Color32::from_rgb(0xFF, 0x84, 0x3D) } else { VERMILLION }
}

pub(crate) fn warning(ui: &egui::Ui) -> Color32 {
    if ui.visuals().dark_mode { ORANGE } else { Color32::from_rgb(0x8A, 0x5A, 0x00) }
}

pub(crate) fn well(ui: &egui::Ui) -> Color32 {
    if ui.visuals().dark_mode { Color32::from_rgb(0x2C, 0xC4, 0x96) } else { GREEN }
}

pub(crate) fn severity(severity: Severity, ui: &egui::Ui) -> Color32 {
    match severity {
        Severity::Well => well(ui),
        Severity::Degraded => warning(ui),
        Severity::Lost => fault(ui),
    }
}

pub(crate) fn faint(color: Color32, share: f32) -> Color32 {
    color.gamma_multiply(share)
}

pub(crate) fn blend(from: Color32, to: Color32, share: f32) -> Color32 {
    from.lerp_to_gamma(to, share.clamp(0.0, 1.0))
}

pub(crate) fn apply(ctx: &egui::Context) {
    ctx.style_mut_of(Theme::Dark, |style| {
        style.visuals = dark();
        sizes(style);
    });
    ctx.style_mut_of(Theme::Light, |style| {
        style.visuals = light();
        sizes(style);
    });
}

fn sizes(style: &mut Style) {
    let sizes = [
        (TextStyle::Small, 10.5),
        (TextStyle::Body, 13.0),
        (TextStyle::Button, 13.0),
        (TextStyle::Heading, 17.0),
    ];
    for (text, size) in sizes {
        style.text_styles.insert(text, FontId::proportional(size));
    }
    style.text_styles.insert(TextStyle::Monospace, FontId::monospace(12.0));
    style.spacing.item_spacing = egui::vec2(6.0, 4.0);
    style.spacing.button_padding = egui::vec2(7.0, 2.0);
    style.spacing.slider_width = 150.0;
    let rounded = CornerRadius::same(3);
    let widgets = &mut style.visuals.widgets;
    for visuals in [
        &mut widgets.noninteractive,
        &mut widgets.inactive,
        &mut widgets.hovered,
        &mut widgets.active,
        &mut widgets.open,
    ] {
        visuals.corner_radius = rounded;
    }
}

fn dark() -> Visuals {
    let mut visuals = Visuals::dark();
    visuals.panel_fill = Color32::from_rgb(0x17, 0x1A, 0x1F);
    visuals.window_fill = Color32::from_rgb(0x1E, 0x22, 0x28);
    visuals.extreme_bg_color = Color32::from_rgb(0x10, 0x12, 0x16);
    visuals.faint_bg_color = Color32::from_rgb(0x1E, 0x22, 0x28);
    visuals.widgets.noninteractive.bg_stroke.color = Color32::from_rgb(0x30, 0x36, 0x3E);
    visuals.widgets.noninteractive.fg_stroke.color = Color32::from_rgb(0xC4, 0xCA, 0xD2);
    visuals.widgets.inactive.weak_bg_fill = Color32::from_rgb(0x2B, 0x31, 0x39);
    visuals.widgets.inactive.bg_fill = Color32::from_rgb(0x34, 0x3B, 0x45);
    visuals.widgets.inactive.fg_stroke.color = Color32::from_rgb(0xD8, 0xDD, 0xE3);
    visuals.selection.bg_fill = Color32::from_rgb(0x1D, 0x5C, 0x86);
    visuals
}

fn light() -> Visuals {
    let mut visuals = Visuals::light();
    visuals.panel_fill = Color32::from_rgb(0xF5, 0xF6, 0xF8);
    visuals.window_fill = Color32::from_rgb(0xFC, 0xFC, 0xFD);
    visuals.extreme_bg_color = Color32::WHITE;
    visuals.faint_bg_color = Color32::from_rgb(0xEB, 0xEE, 0xF1);
    visuals.widgets.noninteractive.bg_stroke.color = Color32::from_rgb(0xCF, 0xD4, 0xDA);
    visuals.widgets.noninteractive.fg_stroke.color = Color32::from_rgb(0x30, 0x36, 0x3E);
    visuals.widgets.inactive.weak_bg_fill = Color32::from_rgb(0xE1, 0xE5, 0xEA);
    visuals.selection.bg_fill = Color32::from_rgb(0xA9, 0xD4, 0xF0);
    visuals
}
