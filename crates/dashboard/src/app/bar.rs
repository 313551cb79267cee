//! The bar above the panels: how the source stands, and Stop.

use eframe::egui::{self, Align, Button, Color32, Layout, Panel, RichText, Ui};
use telemetry::{Request, Standing};

use super::App;
use crate::desk::Desk;
use crate::layout::{self, Pane};
use crate::{look, unit};

/// How old messages may be before it is shown as a fault [s].
const OLD: f64 = 0.5;

/// Draws the bar.
pub(super) fn bar_ui(ui: &mut Ui, app: &mut App) {
    Panel::top("bar").show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.strong("Letoff");
            panels_menu_ui(ui, app);
            view_menu_ui(ui, app);
            ui.separator();
            standing_ui(ui, &app.desk);
            run_ui(ui, &app.desk);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                stop_ui(ui, &mut app.desk);
                freeze_ui(ui, &mut app.desk);
                record_ui(ui, &mut app.desk);
                figures_ui(ui, &app.desk);
                notice_ui(ui, &mut app.desk);
            });
        });
    });
}

/// No force on any key: always here, always one click.
fn stop_ui(ui: &mut Ui, desk: &mut Desk) {
    let text = RichText::new("  STOP  ").strong().color(Color32::WHITE);
    let button = Button::new(text).fill(Color32::from_rgb(0xB4, 0x2A, 0x00));
    let stop = ui.add(button).on_hover_text("No force on any key from the next tick on.");
    if stop.clicked() {
        desk.ask(Request::Stop {});
    }
}

fn freeze_ui(ui: &mut Ui, desk: &mut Desk) {
    let mut is_frozen = desk.views.frozen.is_some();
    let frozen = ui.toggle_value(&mut is_frozen, "Freeze");
    if frozen.on_hover_text("Lets the picture stand still; the host goes on. (space)").clicked() {
        desk.toggle_freeze();
    }
}

fn record_ui(ui: &mut Ui, desk: &mut Desk) {
    if desk.source.standing() != Standing::Live {
        return;
    }
    let mut records = desk.views.recording.is_some();
    if ui.toggle_value(&mut records, "Record").clicked() {
        let file = records.then(|| {
            let run = desk.store.catalogue.as_ref().map_or("run", |it| it.run.as_str());
            let name: String =
                run.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
            format!("{name}-{:.0}s.mcap", desk.store.newest())
        });
        desk.views.recording.clone_from(&file);
        desk.ask(Request::Record { file });
    }
}

/// Connection, and why it is as it is.
fn standing_ui(ui: &mut Ui, desk: &Desk) {
    let (color, text, why) = match desk.source.standing() {
        Standing::Connecting => (look::YELLOW, "connecting", None),
        Standing::Live => (look::GREEN, "live", None),
        Standing::Lost(why) => (look::VERMILLION, "lost", Some(why)),
        Standing::Refused(why) => (look::VERMILLION, "refused", Some(why)),
        Standing::Recording => (look::SKY, "recording", None),
    };
    let (rect, _) = ui.allocate_exact_size(egui::vec2(10.0, 10.0), egui::Sense::hover());
    ui.painter().circle_filled(rect.center(), 4.5, color);
    ui.label(text);
    ui.weak(desk.source.name());
    if let Some(why) = why {
        ui.colored_label(look::fault(ui), why);
    }
}

fn run_ui(ui: &mut Ui, desk: &Desk) {
    if let Some(catalogue) = &desk.store.catalogue {
        ui.separator();
        ui.label(&catalogue.scene).on_hover_text(format!(
            "run of {}, version {}, {} ticks a second, at most {} N",
            catalogue.run, catalogue.version, catalogue.tick_hz, catalogue.force_limit
        ));
    }
}

/// Latency, and what was dropped.
fn figures_ui(ui: &mut Ui, desk: &Desk) {
    let dropped = desk.store.glances.dropped;
    if 0 < dropped {
        ui.colored_label(look::fault(ui), format!("{dropped} dropped"));
    }
    if let Some(latency) = desk.latency() {
        let text = format!("{:.0} ms", latency * 1e3);
        let color = if OLD < latency { look::fault(ui) } else { ui.visuals().weak_text_color() };
        ui.colored_label(color, text).on_hover_text("How old the newest message is.");
    }
    let kept = desk.store.bytes() as f64 / f64::from(1 << 20);
    ui.weak(format!("{kept:.1} MiB")).on_hover_text("Rows that are kept here.");
    ui.weak(unit::seconds(desk.now())).on_hover_text("Time of the run that is shown.");
}

fn notice_ui(ui: &mut Ui, desk: &mut Desk) {
    let Some(notice) = desk.views.notice.clone() else { return };
    let is_read = match notice {
        Ok(text) => ui.add(egui::Label::new(text).sense(egui::Sense::click())).clicked(),
        Err(text) => {
            let text = RichText::new(text).color(look::fault(ui));
            ui.add(egui::Label::new(text).sense(egui::Sense::click())).clicked()
        }
    };
    if is_read {
        desk.views.notice = None;
    }
}

fn panels_menu_ui(ui: &mut Ui, app: &mut App) {
    ui.menu_button("Panels", |ui| {
        for pane in Pane::ALL {
            pane_item_ui(ui, app, pane);
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
            app.desk.store.clear();
            ui.close();
        }
        if ui.button("Shortcuts").clicked() {
            app.desk.views.shows_help = true;
            ui.close();
        }
    });
}
