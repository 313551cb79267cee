//! The state of a window that is saved between starts.

use eframe::egui;
use serde::{Deserialize, Serialize};

use super::App;
use crate::panels::{Pane, Panels};
use crate::{app_state::SharedView, layout::Layout, tune::SavedTuning};

const NAME: &str = "letoff-dashboard";

/// Saved state of the window, as a text, so that no change of ours makes an old one unreadable.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SavedWindow {
    text: String,
}

#[derive(Serialize, Deserialize)]
struct Remembered {
    layout: Layout,
    theme: egui::ThemePreference,
    zoom: f32,
    views: SharedView,
    #[serde(default)]
    panels: Panels,
    kept: SavedTuning,
}

impl SavedWindow {
    pub fn load(storage: &dyn eframe::Storage) -> Option<Self> {
        storage.get_string(NAME).map(|text| Self { text })
    }

    pub fn read(text: impl Into<String>) -> Self {
        Self { text: text.into() }
    }

    pub fn text(&self) -> &str {
        &self.text
    }

    pub(super) fn store(&self, storage: &mut dyn eframe::Storage) {
        if !self.text.is_empty() {
            storage.set_string(NAME, self.text.clone());
        }
    }

    pub(super) fn of(app: &App, ctx: &egui::Context) -> Self {
        Self::with_theme(app, ctx.options(|options| options.theme_preference))
    }

    pub(super) fn of_window(app: &App) -> Self {
        Self::with_theme(app, app.theme)
    }

    fn with_theme(app: &App, theme: egui::ThemePreference) -> Self {
        let remembered = Remembered {
            layout: app.layout.clone(),
            theme,
            zoom: app.zoom,
            views: app.state.view.clone(),
            panels: app.panels.clone(),
            kept: app.state.tuner.kept.clone(),
        };
        // An unwritable state is not saved: the window continues without.
        Self { text: serde_json::to_string(&remembered).unwrap_or_default() }
    }

    /// Restores the window; an unreadable state counts as none.
    pub(super) fn restore(&self, app: &mut App, ctx: &egui::Context) {
        let Ok(remembered) = serde_json::from_str::<Remembered>(&self.text) else { return };
        let is_whole = remembered.layout.tiles.find_pane(&Pane::Overview).is_some()
            || !remembered.layout.is_empty();
        if is_whole {
            app.layout = remembered.layout;
        }
        app.zoom = remembered.zoom.clamp(*super::ZOOM.start(), *super::ZOOM.end());
        app.theme = remembered.theme;
        app.state.view = remembered.views;
        app.panels = remembered.panels;
        app.state.tuner.kept = remembered.kept;
        ctx.set_theme(remembered.theme);
        ctx.set_zoom_factor(app.zoom);
    }
}
