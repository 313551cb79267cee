//! Keys to press with the mouse, and with the computer keyboard.

use std::collections::BTreeMap;

use eframe::egui::{
    Align2, Color32, DragValue, FontId, Key, Rect, Response, Sense, Stroke, StrokeKind, Ui,
    WidgetInfo, accesskit::Role, pos2, vec2,
};
use telemetry::Request;

use super::nothing_ui;
use crate::desk::AppState;
use crate::{look, names, number};

/// Keys of the computer from a C on: white ones in the middle row, black ones above.
const ROW: [Key; 17] = [
    Key::A,
    Key::W,
    Key::S,
    Key::E,
    Key::D,
    Key::F,
    Key::T,
    Key::G,
    Key::Y,
    Key::H,
    Key::U,
    Key::J,
    Key::K,
    Key::O,
    Key::L,
    Key::P,
    Key::Semicolon,
];

/// Semitones that are drawn.
const SPAN: u8 = 29;

/// What the panel remembers.
#[derive(Clone, Debug)]
pub(crate) struct View {
    /// The computer keyboard plays.
    pub(crate) plays: bool,
    /// The lowest key that is drawn: a C.
    lowest: u8,
    /// How hard the computer keyboard presses, and the mouse at a key's front (N).
    newtons: f64,
    /// What is pressed now (N).
    pressed: BTreeMap<u8, f64>,
    /// Whether the panel was drawn since this was asked last.
    is_shown: bool,
}

impl Default for View {
    fn default() -> Self {
        Self { plays: false, lowest: 27, newtons: 6.0, pressed: BTreeMap::new(), is_shown: false }
    }
}

/// Draws the panel.
pub(super) fn keyboard_ui(ui: &mut Ui, desk: &mut AppState) {
    if !desk.store.catalogue.as_ref().is_some_and(|catalogue| catalogue.fingers) {
        nothing_ui(ui, "There are no simulated fingers here: press the real keys.");
        return;
    }
    desk.views.keyboard.is_shown = true;
    controls_ui(ui, desk);
    let size = vec2(ui.available_width(), (ui.available_height()).clamp(60.0, 200.0));
    let (area, _) = ui.allocate_exact_size(size, Sense::hover());
    let view = &desk.views.keyboard;
    let (lowest, newtons) = (view.lowest, view.newtons);
    let mut now: BTreeMap<u8, f64> = BTreeMap::new();
    let keys = lowest..=(lowest + SPAN - 1).min(names::LAST);
    let (black, white) = keys.partition::<Vec<u8>, _>(|key| names::is_black(*key));
    for key in white.into_iter().chain(black) {
        let rect = rect(area, lowest, key);
        let response = key_ui(ui, desk, key, rect);
        if let Some(at) =
            response.interact_pointer_pos().filter(|_| response.is_pointer_button_down_on())
        {
            let depth = f64::from(((at.y - rect.top()) / rect.height()).clamp(0.1, 1.0));
            now.insert(key, (newtons * depth * 10.0).round() / 10.0);
        }
    }
    if desk.views.keyboard.plays && !ui.ctx().text_edit_focused() {
        // A key with Ctrl is a shortcut and no note.
        let held = ui.input(|input| {
            let is_shortcut = input.modifiers.command || input.modifiers.ctrl;
            ROW.map(|key| !is_shortcut && input.key_down(key))
        });
        let played = (0..).zip(held).filter(|(_, is_held)| *is_held);
        now.extend(played.map(|(i, _)| ((lowest + i).min(names::LAST), newtons)));
    }
    tell(desk, now);
}

/// Lets go of all keys, and plays no more, once the panel is not to be seen.
pub(crate) fn leave_if_hidden(desk: &mut AppState) {
    if !std::mem::take(&mut desk.views.keyboard.is_shown) {
        desk.views.keyboard.plays = false;
        release(desk);
    }
}

/// Lets go of all keys.
pub(crate) fn release(desk: &mut AppState) {
    tell(desk, BTreeMap::new());
}

fn controls_ui(ui: &mut Ui, desk: &mut AppState) {
    ui.horizontal_wrapped(|ui| {
        let view = &mut desk.views.keyboard;
        ui.toggle_value(&mut view.plays, "Computer keyboard plays")
            .on_hover_text("A S D F … are white keys, W E T Y U … black ones.");
        let newtons = DragValue::new(&mut view.newtons).speed(0.05).range(0.5..=20.0).suffix(" N");
        ui.add(newtons).on_hover_text("How hard, at a key's front.").accessible_name("newtons");
        if ui.button("Octave down").clicked() {
            view.lowest = view.lowest.saturating_sub(12).max(3);
        }
        if ui.button("Octave up").clicked() {
            view.lowest = (view.lowest + 12).min(63);
        }
        ui.weak(names::range_name(&(view.lowest..=(view.lowest + SPAN - 1).min(names::LAST))));
    });
}

/// Where a key is drawn.
fn rect(area: Rect, lowest: u8, key: u8) -> Rect {
    let last = (lowest + SPAN - 1).min(names::LAST);
    let from = names::whites_below(lowest);
    let whites = (names::whites_below(last) + 1 - from).max(1);
    let width = area.width() / number::f32(number::f64(whites));
    let left = area.left() + number::f32(number::f64(names::whites_below(key) - from)) * width;
    if names::is_black(key) {
        let top = pos2(left - width * 0.31, area.top());
        Rect::from_min_size(top, vec2(width * 0.62, area.height() * 0.6))
    } else {
        Rect::from_min_size(pos2(left, area.top()), vec2(width - 1.0, area.height()))
    }
}

fn key_ui(ui: &Ui, desk: &AppState, key: u8, rect: Rect) -> Response {
    let response = ui.interact(rect, ui.scope_id().with(("press", key)), Sense::click_and_drag());
    let name = format!("press {}", names::name(key));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    let view = &desk.views.keyboard;
    let pressed = view.pressed.get(&key).copied();
    let plain = if names::is_black(key) {
        Color32::from_rgb(0x2A, 0x2E, 0x35)
    } else {
        Color32::from_rgb(0xEC, 0xEA, 0xE2)
    };
    let fill = if pressed.is_some() { look::blend(plain, look::ORANGE, 0.7) } else { plain };
    let painter = ui.painter_at(rect.expand(1.0));
    painter.rect_filled(rect, 2.0, fill);
    let edge = Stroke::new(1.0, look::faint(Color32::BLACK, 0.6));
    painter.rect_stroke(rect, 2.0, edge, StrokeKind::Inside);
    let letter = ROW.get(usize::from(key - view.lowest)).filter(|_| view.plays);
    let text = match (pressed, letter) {
        (Some(newtons), _) => format!("{newtons:.1} N"),
        (None, Some(letter)) => letter.symbol_or_name().to_owned(),
        (None, None) if key % 12 == 3 => names::name(key),
        (None, None) => return response,
    };
    let ink = if names::is_black(key) { Color32::WHITE } else { Color32::BLACK };
    let at = rect.center_bottom() + vec2(0.0, -5.0);
    painter.text(at, Align2::CENTER_BOTTOM, text, FontId::proportional(11.0), ink);
    response
}

/// Asks for what has changed: pressed keys, and those let go.
fn tell(desk: &mut AppState, now: BTreeMap<u8, f64>) {
    let before = std::mem::replace(&mut desk.views.keyboard.pressed, now.clone());
    for key in before.keys().filter(|key| !now.contains_key(key)) {
        desk.ask(Request::Press { key: *key, newtons: 0.0 });
    }
    for (key, newtons) in now {
        if before.get(&key).is_none_or(|old| 0.05 < (old - newtons).abs()) {
            desk.ask(Request::Press { key, newtons });
        }
    }
}
