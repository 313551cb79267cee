//! The window around the panels.
//!
//! A frame: take what has arrived, heed the keyboard, draw the bar and the panels, send what was
//! changed.
//! The next frame comes when something arrives, or while something moves by itself.

mod bar;
mod help;
mod memory;
mod shortcuts;

use std::time::Duration;

use eframe::egui;
use egui_tiles::{Behavior, SimplificationOptions, TileId, Tiles, UiResponse};
use telemetry::{Source, Update};

pub use memory::SavedWindow;

use crate::desk::AppState;
use crate::layout::{self, Layout, Pane};
use crate::{WallClock, look, panels};

/// At most sixty pictures a second.
const FRAME: Duration = Duration::from_millis(16);

/// How large things can be made.
const ZOOM: std::ops::RangeInclusive<f32> = 0.6..=2.5;

/// The window.
pub struct App {
    desk: AppState,
    layout: Layout,
    zoom: f32,
    theme: egui::ThemePreference,
}

impl std::fmt::Debug for App {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("App").field("source", &self.desk.source).finish_non_exhaustive()
    }
}

impl App {
    /// A window onto `source`, with what it remembers of the last time.
    ///
    /// `clock` says what time it is; nothing here reads another.
    pub fn new(
        source: Box<dyn Source>,
        clock: WallClock,
        memory: Option<SavedWindow>,
        ctx: &egui::Context,
    ) -> Self {
        look::dress(ctx);
        let mut app = Self {
            desk: AppState::new(source, clock),
            layout: layout::first(),
            zoom: 1.0,
            theme: ctx.options(|options| options.theme_preference),
        };
        if let Some(memory) = memory {
            memory.restore(&mut app, ctx);
        }
        app
    }

    /// Draws everything.
    pub fn draw(&mut self, ui: &mut egui::Ui) {
        self.desk.take();
        shortcuts::heed(ui.ctx(), self);
        self.ui_of_panels(ui);
        panels::keyboard::leave_if_hidden(&mut self.desk);
        self.desk.flush();
        self.ask_for_frames(ui.ctx());
    }

    fn ui_of_panels(&mut self, ui: &mut egui::Ui) {
        bar::bar_ui(ui, self);
        egui::CentralPanel::no_frame().show(ui, |ui| {
            let mut panes = Panes { desk: &mut self.desk, closed: None };
            self.layout.ui(&mut panes, ui);
            if let Some(pane) = panes.closed {
                layout::close(&mut self.layout, pane);
            }
        });
        panels::scope::popped_ui(ui.ctx(), &mut self.desk);
        help::help_ui(ui.ctx(), &mut self.desk);
        panels::tuning::scene_ui(ui.ctx(), &mut self.desk);
    }

    /// Another frame soon, where something moves that nobody wakes us for.
    fn ask_for_frames(&mut self, ctx: &egui::Context) {
        let plays = self.desk.source.timeline().is_some_and(|timeline| {
            0.0 < timeline.speed().abs() && timeline.at() < timeline.span().1
        });
        if plays {
            ctx.request_repaint_after(FRAME);
        }
    }

    /// Shows a panel: brings it to the front, or opens it.
    pub fn open(&mut self, pane: Pane) {
        layout::open(&mut self.layout, pane);
    }

    /// Shows this panel alone.
    pub fn show_only(&mut self, pane: Pane) {
        self.layout = Layout::new_tabs(egui::Id::unique("panels"), vec![pane]);
    }

    /// Shows these panels beside each other.
    pub fn show_grid(&mut self, panes: Vec<Pane>) {
        self.layout = Layout::new_grid(egui::Id::unique("panels"), panes);
    }

    /// Shows these panels beside each other, from the left.
    pub fn show_row(&mut self, panes: Vec<Pane>) {
        self.layout = Layout::new_horizontal(egui::Id::unique("panels"), panes);
    }

    /// Selects a key.
    pub fn select(&mut self, key: u8) {
        self.desk.select(key);
    }

    /// What it would remember.
    pub fn memory(&self, ctx: &egui::Context) -> SavedWindow {
        SavedWindow::of(self, ctx)
    }

    /// Takes a message as if the source had given it: for measurements.
    pub fn take(&mut self, at: u64, update: Update) {
        self.desk.take_update(at, update);
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        // Also while the window is hidden: what arrives does not pile up, and no key stays down.
        self.desk.take();
        let is_away = ctx.input(|input| {
            let viewport = input.viewport();
            let is_hidden = viewport.minimized == Some(true) || viewport.occluded == Some(true);
            is_hidden || viewport.close_requested()
        });
        if is_away {
            panels::keyboard::release(&mut self.desk);
        }
    }

    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.draw(ui);
    }

    fn on_exit(&mut self, _graphics: Option<&eframe::glow::Context>) {
        panels::keyboard::release(&mut self.desk);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        // The window's own context is not at hand here; the theme was noted when it changed.
        SavedWindow::of_window(self).store(storage);
    }
}

/// Draws panels for the layout.
struct Panes<'a> {
    desk: &'a mut AppState,
    closed: Option<Pane>,
}

impl Behavior<Pane> for Panes<'_> {
    fn pane_ui(&mut self, ui: &mut egui::Ui, _tile: TileId, pane: &mut Pane) -> UiResponse {
        let frame = egui::Frame::new().inner_margin(6.0).fill(ui.visuals().panel_fill);
        frame.show(ui, |ui| {
            ui.take_available_space();
            ui.push_id(*pane, |ui| panels::panel_ui(ui, *pane, self.desk));
        });
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, pane: &Pane) -> egui::WidgetText {
        let faults = if *pane == Pane::Faults { self.desk.store.faulty().len() } else { 0 };
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
