//! The window around the panels.
//!
//! A frame takes the arrivals, handles the keyboard, draws the bar and the panels, and sends the
//! changes. The next frame comes with an arrival, or while something moves by itself.

mod bar;
mod help;
mod saved_window;
mod shortcuts;

use std::time::Duration;

use eframe::egui;
use egui_tiles::{Behavior, SimplificationOptions, TileId, Tiles, UiResponse};
use telemetry::{Source, Update};

pub use saved_window::SavedWindow;

use crate::layout::{self, Layout};
use crate::panels::{Pane, Panels};
use crate::{WallClock, app_state::AppState, panels, theme, toast::ToastAction};

/// Shortest time between two frames.
const FRAME: Duration = Duration::from_millis(16);

const ZOOM: std::ops::RangeInclusive<f32> = 0.6..=2.5;

/// Time after an input in which a paused recording is drawn (s): some frames.
const SETTLE: f64 = 0.2;

/// The window: panels, their layout, and their source.
pub struct App {
    state: AppState,
    panels: Panels,
    layout: Layout,
    zoom: f32,
    theme: egui::ThemePreference,
    /// Time of the last input (s).
    touched: f64,
}

impl std::fmt::Debug for App {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("App").field("source", &self.state.source).finish_non_exhaustive()
    }
}

impl App {
    /// Creates a window for `source`, restored from `memory`; reads no clock but `clock`.
    pub fn new(
        source: Box<dyn Source>,
        clock: WallClock,
        memory: Option<SavedWindow>,
        ctx: &egui::Context,
    ) -> Self {
        theme::apply(ctx);
        let mut app = Self {
            state: AppState::new(source, clock),
            panels: Panels::default(),
            layout: layout::first(),
            zoom: 1.0,
            theme: ctx.options(|options| options.theme_preference),
            touched: 0.0,
        };
        if let Some(memory) = memory {
            memory.restore(&mut app, ctx);
        }
        app
    }

    /// Takes the arrivals, draws a frame, and sends the changes.
    pub fn draw(&mut self, ui: &mut egui::Ui) {
        self.state.take();
        shortcuts::handle(ui.ctx(), self);
        self.ui_of_panels(ui);
        let now = (self.state.clock)();
        if let Some(action) = self.state.toasts.ui(ui.ctx(), now) {
            self.perform(&action);
        }
        self.panels.release_if_hidden(&mut self.state);
        self.state.flush();
        self.ask_for_frames(ui.ctx());
    }

    fn perform(&mut self, action: &ToastAction) {
        match action {
            ToastAction::ShowLinks => self.open(Pane::Links),
        }
    }

    fn ui_of_panels(&mut self, ui: &mut egui::Ui) {
        bar::bar_ui(ui, self);
        egui::CentralPanel::no_frame().show(ui, |ui| {
            let mut panes =
                Panes { panels: &mut self.panels, state: &mut self.state, closed: None };
            self.layout.ui(&mut panes, ui);
            if let Some(pane) = panes.closed {
                layout::close(&mut self.layout, pane);
            }
        });
        panels::scope::popped_ui(ui.ctx(), &mut self.state);
        help::help_ui(ui.ctx(), &mut self.state);
        self.panels.file_ui(ui.ctx(), &mut self.state);
    }

    fn ask_for_frames(&mut self, ctx: &egui::Context) {
        let (now, has_input) = ctx.input(|input| (input.time, !input.events.is_empty()));
        self.touched = if has_input { now } else { self.touched };
        // A paused recording wakes no window, but answers a move or another key with rows.
        let is_touched = now - self.touched < SETTLE;
        let plays = self.state.source.timeline().is_some_and(|timeline| {
            is_touched || 0.0 < timeline.speed().abs() && timeline.at() < timeline.span().1
        });
        if plays {
            ctx.request_repaint_after(FRAME);
        }
    }

    /// Brings a panel to the front, or opens it.
    pub fn open(&mut self, pane: Pane) {
        layout::open(&mut self.layout, pane);
    }

    pub fn show_only(&mut self, pane: Pane) {
        self.layout = Layout::new_tabs(egui::Id::unique("panels"), vec![pane]);
    }

    pub fn show_grid(&mut self, panes: Vec<Pane>) {
        self.layout = Layout::new_grid(egui::Id::unique("panels"), panes);
    }

    pub fn show_row(&mut self, panes: Vec<Pane>) {
        self.layout = Layout::new_horizontal(egui::Id::unique("panels"), panes);
    }

    pub fn select(&mut self, key: u8) {
        self.state.select(key);
    }

    /// Returns the state that is saved when the window closes.
    pub fn memory(&self, ctx: &egui::Context) -> SavedWindow {
        SavedWindow::of(self, ctx)
    }

    /// Takes a message as if from the source, for measurements.
    pub fn take(&mut self, at: u64, update: Update) {
        self.state.take_update(at, update);
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        // Also while the window is hidden: no arrivals pile up, and no key stays pressed.
        self.state.take();
        let is_away = ctx.input(|input| {
            let viewport = input.viewport();
            let is_hidden = viewport.minimized == Some(true) || viewport.occluded == Some(true);
            is_hidden || viewport.close_requested()
        });
        if is_away {
            self.panels.release(&mut self.state);
        }
    }

    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.draw(ui);
    }

    fn on_exit(&mut self, _graphics: Option<&eframe::glow::Context>) {
        self.panels.release(&mut self.state);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        // The window's own context is not at hand here; the theme was stored when it changed.
        SavedWindow::of_window(self).store(storage);
    }
}

struct Panes<'a> {
    panels: &'a mut Panels,
    state: &'a mut AppState,
    closed: Option<Pane>,
}

impl Behavior<Pane> for Panes<'_> {
    fn pane_ui(&mut self, ui: &mut egui::Ui, _tile: TileId, pane: &mut Pane) -> UiResponse {
        let frame = egui::Frame::new().inner_margin(6.0).fill(ui.visuals().panel_fill);
        frame.show(ui, |ui| {
            ui.take_available_space();
            ui.push_id(*pane, |ui| self.panels.ui(*pane, ui, self.state));
        });
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, pane: &Pane) -> egui::WidgetText {
        let faults = if *pane == Pane::Faults { self.state.store.faulty().len() } else { 0 };
        match faults {
            0 => pane.title().into(),
            faults => format!("{} ({faults})", pane.title()).into(),
        }
    }

    fn is_tab_closable(&self, _tiles: &Tiles<Pane>, _tile: TileId) -> bool {
        true
    }

    fn on_tab_close(&mut self, tiles: &mut Tiles<Pane>, tile: TileId) -> bool {
        self.closed = tiles.get_pane(&tile).copied();
        false
    }

    fn simplification_options(&self) -> SimplificationOptions {
        SimplificationOptions { all_panes_must_have_tabs: true, ..Default::default() }
    }

    fn tab_bar_color(&self, visuals: &egui::Visuals) -> egui::Color32 {
        visuals.extreme_bg_color
    }

    fn gap_width(&self, _style: &egui::Style) -> f32 {
        3.0
    }
}
