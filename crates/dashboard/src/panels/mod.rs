//! One file for each panel: its saved state and its drawing.
//!
//! The list below generates [`Pane`], the menu, and [`Panels`]; a new panel is a line in it.

mod deadlines;
mod descriptions;
mod faults;
mod instruments;
mod keyboard;
mod links;
mod log;
mod mechanism;
mod midi;
mod overview;
mod passivity;
mod phase;
pub(crate) mod scope;
mod timeline;
mod tuning;

use eframe::egui::{Color32, Label, ProgressBar, Response, RichText, ScrollArea, Ui};
use serde::{Deserialize, Serialize};

use crate::app_state::AppState;

/// Saved state of a panel. Fields without `#[serde(skip)]` survive until the next start.
trait View {
    /// Draws the panel from `state`, and sends requests through it.
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState);
}

/// Generates [`Pane`] and [`Panels`] from a list: pane, module with its `View`, title.
macro_rules! panels {
    ($($pane:ident: $module:ident, $title:literal;)*) => {
        /// A panel of the window.
        #[derive(
            Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize,
        )]
        pub enum Pane {
            $($pane,)*
            /// A scope, by its number.
            Scope(u8),
        }

        impl Pane {
            /// Every panel; of the scopes, the first.
            pub const ALL: &[Self] = &[$(Self::$pane,)* Self::Scope(0)];

            pub fn title(self) -> String {
                match self {
                    $(Self::$pane => $title.to_owned(),)*
                    Self::Scope(0) => "Scope".to_owned(),
                    Self::Scope(number) => format!("Scope {}", number + 1),
                }
            }
        }

        #[derive(Clone, Debug, Default, Serialize, Deserialize)]
        #[serde(default)]
        pub(crate) struct Panels {
            $($module: $module::View,)*
        }

        impl Panels {
            pub(crate) fn ui(&mut self, pane: Pane, ui: &mut Ui, state: &mut AppState) {
                match pane {
                    $(Pane::$pane => self.$module.ui(ui, state),)*
                    Pane::Scope(number) => scope::scope_ui(ui, number, state),
                }
            }
        }
    };
}

panels! {
    Overview: overview, "Keys";
    Mechanism: mechanism, "Mechanism";
    Phase: phase, "Force and travel";
    Passivity: passivity, "Passivity";
    Tuning: tuning, "Tuning";
    Instruments: instruments, "Instruments";
    Descriptions: descriptions, "Descriptions";
    Deadlines: deadlines, "Deadlines";
    Links: links, "Links";
    Midi: midi, "MIDI";
    Faults: faults, "Faults";
    Timeline: timeline, "Timeline";
    Keyboard: keyboard, "Keyboard";
    Log: log, "Log";
}

impl Panels {
    /// Returns `true` if keys of the computer play notes instead of being shortcuts.
    pub(crate) const fn takes_letters(&self) -> bool {
        self.keyboard.plays()
    }

    pub(crate) fn release_if_hidden(&mut self, state: &mut AppState) {
        self.keyboard.release_if_hidden(state);
    }

    pub(crate) fn release(&mut self, state: &mut AppState) {
        self.keyboard.release(state);
    }

    pub(crate) fn file_ui(&mut self, ctx: &eframe::egui::Context, state: &mut AppState) {
        self.tuning.file_ui(ctx, state);
    }
}

/// Draws the reason why there is nothing to show: the source's state, or else `text`.
fn nothing_ui(ui: &mut Ui, state: &AppState, text: &str) {
    let text = match state.source_state().why_empty() {
        Some(why) => why,
        None if state.store.catalogue.is_none() => "The host has sent nothing yet.".to_owned(),
        None => text.to_owned(),
    };
    ui.centered_and_justified(|ui| ui.weak(text));
}

/// Draws a few unbroken words: without room in a row they begin the next one.
fn piece_ui(ui: &mut Ui, text: RichText) -> Response {
    ui.add(Label::new(text).extend())
}

/// Draws the contents of a menu, which scroll if the window is too low for them.
pub(crate) fn scrolled_ui<R>(ui: &mut Ui, contents: impl FnOnce(&mut Ui) -> R) -> R {
    let window = ui.ctx().content_rect();
    // Below the button if most of the window is there, and without the menu's own frame.
    let below = window.bottom() - ui.cursor().top() - 16.0;
    let height =
        below.clamp(0.4 * window.height(), (window.height() - 80.0).max(0.4 * window.height()));
    // A menu has the height of its last frame; its list needs more if it has grown.
    let area = ScrollArea::vertical().max_height(height).min_scrolled_height(height);
    area.show(ui, contents).inner
}

/// Draws a share of a whole as a bar; NaN is unknown. The number is beside the bar for readability.
fn share_ui(ui: &mut Ui, share: f64, color: Color32) {
    if !share.is_finite() {
        ui.weak("–").on_hover_text("not known: nothing tells how much it can carry");
        return;
    }
    let part = crate::number::f32(share.clamp(0.0, 1.0));
    ui.horizontal(|ui| {
        ui.add(ProgressBar::new(part).desired_width(80.0).desired_height(12.0).fill(color));
        ui.label(format!("{:.1} %", share * 100.0));
    });
}
