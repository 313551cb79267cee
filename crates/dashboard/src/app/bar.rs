//! The bar above the panels: state of the source, and Stop.

use std::time::Duration;

use eframe::egui::{
    self, Align, Area, Button, Color32, Frame, Id, Layout, Margin, Panel, RichText, Sense, Ui,
    pos2, vec2,
};
use telemetry::{Request, stream::Role};

use super::{App, shortcuts};
use crate::app_state::{AppState, StopState};
use crate::{layout, panels::Pane, theme, unit};

/// Age of messages above which it is shown as a fault (s).
const OLD: f64 = 0.5;

/// Width of the pill (points), for its longest usual text: what follows does not move.
const PILL: f32 = 150.0;

pub(super) fn bar_ui(ui: &mut Ui, app: &mut App) {
    let bar = Panel::top("bar").show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.strong("Letoff");
            pill_ui(ui, &app.state);
            panels_menu_ui(ui, app);
            view_menu_ui(ui, app);
            ui.separator();
            // The right side gets its room first; the rest is cut at its edge.
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                stop_ui(ui, &mut app.state);
                freeze_ui(ui, &mut app.state);
                record_ui(ui, &mut app.state);
                figures_ui(ui, &app.state);
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| status_ui(ui, app));
            });
        });
    });
    stop_state_ui(ui.ctx(), &mut app.state, bar.response.rect);
}

fn status_ui(ui: &mut Ui, app: &mut App) {
    ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Truncate);
    ui.weak(app.state.source.name());
    run_ui(ui, &app.state);
    let shown = app.state.source_state();
    if let Some(why) = shown.why_apart() {
        ui.separator();
        ui.colored_label(theme::fault(ui), why);
    }
}

fn pill_ui(ui: &mut Ui, state: &AppState) {
    let shown = state.source_state();
    let color = shown.severity().map_or(theme::line(0, ui), |it| theme::severity(it, ui));
    let role = state.source.role().filter(|role| *role != Role::Owner);
    let role = role.map_or_else(String::new, |role| format!(" · {}", role.name()));
    let text = format!("{}{role}", shown.label());
    let frame = Frame::new().fill(theme::faint(color, 0.2)).corner_radius(8);
    let pill = frame.inner_margin(Margin::symmetric(8, 1)).show(ui, |ui| {
        ui.set_min_width(PILL);
        let (rect, _) = ui.allocate_exact_size(vec2(10.0, 10.0), Sense::hover());
        ui.painter().circle_filled(rect.center(), 4.5, color);
        ui.label(text);
    });
    let why = shown.why_empty().unwrap_or_else(|| "The host plays.".to_owned());
    let apart = shown.why_apart().map_or_else(String::new, |why| format!("\n{why}"));
    pill.response.on_hover_text(format!("{why}{apart}"));
}

/// Time for the host's answer to a stop, after which its silence is shown (ns).
const SILENCE: u64 = 1_500_000_000;

/// Draws the state of a stop in letters that can be read from the keyboard.
fn stop_state_ui(ctx: &egui::Context, state: &mut AppState, bar: egui::Rect) {
    let Some(stop) = state.stop.clone() else { return };
    let now = (state.clock)();
    let cut = || "STOP NOT CONFIRMED: CUT THE POWER".to_owned();
    let (color, title, text) = match stop {
        StopState::Asked { at } if now.saturating_sub(at) < SILENCE => {
            ctx.request_repaint_after(Duration::from_nanos(SILENCE));
            (theme::VERMILLION, "STOPPING".to_owned(), "The host has been asked.".to_owned())
        }
        StopState::Asked { .. } => (STOP, cut(), "The host does not answer.".to_owned()),
        StopState::Confirmed { told, text } => {
            let told = told.map(|(told, boards)| format!(", boards told: {told} of {boards}"));
            (theme::GREEN, format!("STOPPED{}", told.unwrap_or_default()), text)
        }
        StopState::Unconfirmed(why) => (STOP, cut(), format!("Keys may have forces: {why}")),
        StopState::RunsAgain(why) => {
            let text = format!("This window is not connected to it: {why}");
            (theme::BLUE, "A HOST RUNS AGAIN".to_owned(), text)
        }
    };
    let frame = Frame::new().fill(color).inner_margin(Margin::symmetric(10, 6));
    // It lies over the panels and does not move them.
    let area = Area::new(Id::unique("stop")).order(egui::Order::Foreground);
    area.fixed_pos(pos2(bar.left(), bar.bottom())).show(ctx, |ui| {
        frame.show(ui, |ui| {
            ui.set_width(bar.width() - 20.0);
            ui.horizontal(|ui| {
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    let is_dismissed = ui.button("Dismiss").clicked();
                    ui.with_layout(Layout::top_down(Align::Min), |ui| large_ui(ui, &title, &text));
                    state.stop = state.stop.take().filter(|_| !is_dismissed);
                });
            });
        });
    });
}

fn large_ui(ui: &mut Ui, title: &str, text: &str) {
    let white = |text: RichText| text.color(Color32::WHITE);
    ui.label(white(RichText::new(title).size(30.0).strong()));
    ui.label(white(RichText::new(text).size(15.0)));
}

/// Colour of Stop, and of an unconfirmed one.
const STOP: Color32 = Color32::from_rgb(0xB4, 0x2A, 0x00);

/// Draws the button that removes all forces: always here, always one click.
fn stop_ui(ui: &mut Ui, state: &mut AppState) {
    let text = RichText::new("  STOP  ").strong().color(Color32::WHITE);
    let button = Button::new(text).fill(STOP);
    let hint =
        format!("No force on any key from the next tick on. ({})", shortcuts::stop(ui.ctx()));
    if ui.add(button).on_hover_text(hint).clicked() {
        state.stop();
    }
}

fn freeze_ui(ui: &mut Ui, state: &mut AppState) {
    let mut is_frozen = state.view.frozen.is_some();
    let frozen = ui.toggle_value(&mut is_frozen, "Freeze");
    if frozen.on_hover_text("Lets the picture stand still; the host goes on. (space)").clicked() {
        state.toggle_freeze();
    }
}

fn record_ui(ui: &mut Ui, state: &mut AppState) {
    if state.source.timeline().is_some() {
        return;
    }
    let mut records = state.view.recording.is_some();
    let button = Button::selectable(records, "Record");
    if ui.add_enabled(state.may(Role::Owner), button).clicked() {
        records = !records;
        let file = records.then(|| {
            let run = state.store.catalogue.as_ref().map_or("run", |it| it.run.as_str());
            let name: String =
                run.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
            format!("{name}-{:.0}s.mcap", state.store.newest())
        });
        state.view.recording.clone_from(&file);
        state.ask(Request::Record { file });
    }
    if let Some(status) = state.store.status.as_ref().filter(|it| !it.recording.is_empty()) {
        let seconds = ((state.clock)() / 1_000_000_000).saturating_sub(status.recording_since);
        let text = format!("● {}:{:02}", seconds / 60, seconds % 60);
        ui.colored_label(theme::fault(ui), text).on_hover_text(&status.recording);
    }
}

fn run_ui(ui: &mut Ui, state: &AppState) {
    if let Some(catalogue) = &state.store.catalogue {
        ui.separator();
        ui.label(&catalogue.scene).on_hover_text(format!(
            "run of {}, version {}, {} ticks a second, at most {} N",
            catalogue.run, catalogue.version, catalogue.tick_hz, catalogue.force_limit
        ));
    }
}

fn figures_ui(ui: &mut Ui, state: &AppState) {
    let dropped = state.store.summaries.dropped;
    if 0 < dropped {
        ui.colored_label(theme::fault(ui), format!("{dropped} dropped"));
    }
    if let Some(latency) = state.latency() {
        let text = format!("{:.0} ms", latency * 1e3);
        let color = if OLD < latency { theme::fault(ui) } else { ui.visuals().weak_text_color() };
        ui.colored_label(color, text).on_hover_text("How old the newest message is.");
    }
    let kept = state.store.bytes() as f64 / f64::from(1 << 20);
    ui.weak(format!("{kept:.1} MiB")).on_hover_text("Rows that are kept here.");
    ui.weak(unit::seconds(state.now())).on_hover_text("Time of the run that is shown.");
}

fn panels_menu_ui(ui: &mut Ui, app: &mut App) {
    ui.menu_button("Panels", |ui| {
        for pane in Pane::ALL {
            pane_item_ui(ui, app, *pane);
        }
        ui.separator();
        let number =
            (1..=u8::MAX).find(|number| !layout::is_open(&app.layout, Pane::Scope(*number)));
        if let Some(number) = number
            && ui.button("Another scope").clicked()
        {
            layout::open(&mut app.layout, Pane::Scope(number));
            ui.close();
        }
        if ui.button("Reset layout").clicked() {
            app.layout = layout::first();
            ui.close();
        }
    });
}

fn pane_item_ui(ui: &mut Ui, app: &mut App, pane: Pane) {
    let is_open = layout::is_open(&app.layout, pane);
    let mark = if is_open { "" } else { " (closed)" };
    if ui.button(format!("{}{mark}", pane.title())).clicked() {
        layout::open(&mut app.layout, pane);
        ui.close();
    }
}

fn view_menu_ui(ui: &mut Ui, app: &mut App) {
    ui.menu_button("View", |ui| {
        let themes = [
            (egui::ThemePreference::Dark, "Dark"),
            (egui::ThemePreference::Light, "Light"),
            (egui::ThemePreference::System, "As the system"),
        ];
        for (theme, text) in themes {
            if ui.radio(app.theme == theme, text).clicked() {
                app.theme = theme;
                ui.ctx().set_theme(theme);
            }
        }
        ui.separator();
        ui.label("Scale");
        let slider = egui::Slider::new(&mut app.zoom, super::ZOOM).step_by(0.1).text("scale");
        let scale = ui.add(slider);
        if scale.drag_stopped() || (scale.changed() && !scale.dragged()) {
            ui.ctx().set_zoom_factor(app.zoom);
        }
        ui.separator();
        if ui.button("Clear rows and messages").clicked() {
            app.state.store.clear();
            ui.close();
        }
        if ui.button("Shortcuts").clicked() {
            app.state.view.shows_help = true;
            ui.close();
        }
    });
}
