//! Keys to press with the mouse and the computer keyboard.

use std::{collections::BTreeMap, ops::RangeInclusive};

use eframe::egui::{
    Align2, Color32, DragValue, FontId, Key, Rect, Response, Sense, Stroke, StrokeKind, Ui,
    WidgetInfo, accesskit::Role, pos2, vec2,
};
use serde::{Deserialize, Serialize};
use telemetry::Request;

use super::nothing_ui;
use crate::{app_state::AppState, names, number, theme};

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

const SPAN: u8 = 29;

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(default)]
pub(super) struct View {
    /// `true` if keys of the computer play notes.
    #[serde(skip)]
    plays: bool,
    #[serde(skip)]
    lowest: u8,
    /// Force of the computer keyboard, and of the mouse at a key's front (N).
    #[serde(skip)]
    newtons: f64,
    /// `true` if the mouse grips keys instead of pressing them.
    #[serde(skip)]
    grips: bool,
    #[serde(skip)]
    pressed: BTreeMap<u8, Hand>,
    /// `true` if the panel was drawn since [`View::release_if_hidden`].
    #[serde(skip)]
    is_shown: bool,
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Hand {
    /// It presses (N).
    Presses(f64),
    /// It leads the key to a depth, as a fraction of its dip.
    Grips(f64),
}

impl Hand {
    const fn request(self, key: u8) -> Request {
        match self {
            Self::Presses(newtons) => Request::Press { key, newtons },
            Self::Grips(depth) => Request::Grip { key, depth: Some(depth) },
        }
    }

    const fn lets_go(self, key: u8) -> Request {
        match self {
            Self::Presses(_) => Request::Press { key, newtons: 0.0 },
            Self::Grips(_) => Request::Grip { key, depth: None },
        }
    }
}

impl Default for View {
    fn default() -> Self {
        Self {
            plays: false,
            lowest: 27,
            newtons: 6.0,
            grips: false,
            pressed: BTreeMap::new(),
            is_shown: false,
        }
    }
}

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        if !state.store.catalogue.as_ref().is_some_and(|catalogue| catalogue.fingers) {
            nothing_ui(ui, state, "There are no simulated fingers here: press the real keys.");
            return;
        }
        self.is_shown = true;
        let may_press = state.may_change();
        let mut pressed = ui.add_enabled_ui(may_press, |ui| {
            self.controls_ui(ui);
            self.keys_ui(ui)
        });
        if may_press && self.plays && !ui.ctx().text_edit_focused() {
            pressed.inner.extend(self.played(ui));
        }
        self.send(state, pressed.inner);
    }
}

impl View {
    pub(super) const fn plays(&self) -> bool {
        self.plays
    }

    /// Releases all keys and stops playing, unless the panel was drawn since the last call.
    pub(super) fn release_if_hidden(&mut self, state: &mut AppState) {
        if !std::mem::take(&mut self.is_shown) {
            self.plays = false;
            self.release(state);
        }
    }

    pub(super) fn release(&mut self, state: &mut AppState) {
        self.send(state, BTreeMap::new());
    }

    fn controls_ui(&mut self, ui: &mut Ui) {
        ui.horizontal_wrapped(|ui| {
            ui.toggle_value(&mut self.plays, "Computer keyboard plays")
                .on_hover_text("A S D F … are white keys, W E T Y U … black ones.");
            ui.toggle_value(&mut self.grips, "Grip")
                .on_hover_text("The mouse holds a key, and throws and catches its hammer.");
            let newtons =
                DragValue::new(&mut self.newtons).speed(0.05).range(0.5..=20.0).suffix(" N");
            ui.add(newtons).on_hover_text("How hard, at a key's front.").accessible_name("newtons");
            if ui.button("Octave down").clicked() {
                self.lowest = self.lowest.saturating_sub(12).max(3);
            }
            if ui.button("Octave up").clicked() {
                self.lowest = (self.lowest + 12).min(63);
            }
            ui.weak(names::range_name(&self.keys()));
        });
    }

    fn keys(&self) -> RangeInclusive<u8> {
        self.lowest..=(self.lowest + SPAN - 1).min(names::LAST)
    }

    fn keys_ui(&self, ui: &mut Ui) -> BTreeMap<u8, Hand> {
        let size = vec2(ui.available_width(), (ui.available_height()).clamp(60.0, 200.0));
        let (area, _) = ui.allocate_exact_size(size, Sense::hover());
        let mut pressed = BTreeMap::new();
        let (black, white) = self.keys().partition::<Vec<u8>, _>(|key| names::is_black(*key));
        for key in white.into_iter().chain(black) {
            let rect = rect(area, self.lowest, key);
            let response = self.key_ui(ui, key, rect);
            if let Some(at) =
                response.interact_pointer_pos().filter(|_| response.is_pointer_button_down_on())
            {
                pressed.insert(key, self.hand(f64::from((at.y - rect.top()) / rect.height())));
            }
        }
        pressed
    }

    /// Returns the mouse's action on a key at `place`, 0 at its back and 1 at its front.
    fn hand(&self, place: f64) -> Hand {
        if self.grips {
            // A little more than the full travel, so that a key is also pulled up.
            let depth = (1.4 * place - 0.2).clamp(-1.0, 2.0);
            Hand::Grips((100.0 * depth).round() / 100.0)
        } else {
            Hand::Presses((self.newtons * place.clamp(0.1, 1.0) * 10.0).round() / 10.0)
        }
    }

    /// Returns the keys that the computer keyboard presses, with their forces.
    fn played(&self, ui: &Ui) -> impl Iterator<Item = (u8, Hand)> {
        // A key with Ctrl is a shortcut and no note.
        let held = ui.input(|input| {
            let is_shortcut = input.modifiers.command || input.modifiers.ctrl;
            ROW.map(|key| !is_shortcut && input.key_down(key))
        });
        let (lowest, newtons) = (self.lowest, self.newtons);
        let played = (0..).zip(held).filter(|(_, is_held)| *is_held);
        played.map(move |(i, _)| ((lowest + i).min(names::LAST), Hand::Presses(newtons)))
    }

    fn key_ui(&self, ui: &Ui, key: u8, rect: Rect) -> Response {
        let response =
            ui.interact(rect, ui.scope_id().with(("press", key)), Sense::click_and_drag());
        let name = format!("press {}", names::name(key));
        response.widget_info(|| WidgetInfo::labeled(Role::Button, ui.is_enabled(), &name));
        let pressed = self.pressed.get(&key).copied();
        let plain = if names::is_black(key) {
            Color32::from_rgb(0x2A, 0x2E, 0x35)
        } else {
            Color32::from_rgb(0xEC, 0xEA, 0xE2)
        };
        let fill = if pressed.is_some() { theme::blend(plain, theme::ORANGE, 0.7) } else { plain };
        let painter = ui.painter_at(rect.expand(1.0));
        painter.rect_filled(rect, 2.0, fill);
        let edge = Stroke::new(1.0, theme::faint(Color32::BLACK, 0.6));
        painter.rect_stroke(rect, 2.0, edge, StrokeKind::Inside);
        let letter = ROW.get(usize::from(key - self.lowest)).filter(|_| self.plays);
        let text = match (pressed, letter) {
            (Some(Hand::Presses(newtons)), _) => format!("{newtons:.1} N"),
            (Some(Hand::Grips(depth)), _) => format!("{:.0} %", 100.0 * depth),
            (None, Some(letter)) => letter.symbol_or_name().to_owned(),
            (None, None) if key % 12 == 3 => names::name(key),
            (None, None) => return response,
        };
        let ink = if names::is_black(key) { Color32::WHITE } else { Color32::BLACK };
        let at = rect.center_bottom() + vec2(0.0, -5.0);
        painter.text(at, Align2::CENTER_BOTTOM, text, FontId::proportional(11.0), ink);
        response
    }

    fn send(&mut self, state: &mut AppState, pressed: BTreeMap<u8, Hand>) {
        let before = std::mem::replace(&mut self.pressed, pressed);
        for (key, hand) in before.iter().filter(|(key, _)| !self.pressed.contains_key(key)) {
            state.ask(hand.lets_go(*key));
        }
        for (key, hand) in &self.pressed {
            if before.get(key) != Some(hand) {
                state.ask(hand.request(*key));
            }
        }
    }
}

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
