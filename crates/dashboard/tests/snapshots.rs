//! How the window looks, panel by panel, drawn without a graphics card.

mod common;

use common::snapshot::Canvas;
use common::{Behind, Hand, source};
use dashboard::{App, Pane};
use eframe::egui::{Event, Key, Modifiers, Theme};

/// A canvas after `seconds` of the demonstration.
fn canvas(
    size: [usize; 2],
    theme: Theme,
    behind: Behind,
    seconds: f64,
    set: impl FnOnce(&mut App),
) -> Canvas {
    let hand = Hand::default();
    let (source, _) = source(&hand, behind);
    let mut canvas = Canvas::new(size, theme, |ctx| {
        let mut app = App::new(source, hand.clock(), None, ctx);
        set(&mut app);
        app
    });
    canvas.play(&hand, seconds);
    canvas
}

#[track_caller]
fn check_panel(pane: Pane, name: &str) {
    let mut canvas = canvas([760, 420], Theme::Dark, Behind::Live, 3.0, |app| app.show_only(pane));
    canvas.check(name);
}

#[test]
fn the_window_on_dark_ground() {
    canvas([1280, 800], Theme::Dark, Behind::Live, 3.0, |_| {}).check("window_dark");
}

#[test]
fn the_window_on_light_ground() {
    canvas([1280, 800], Theme::Light, Behind::Live, 3.0, |_| {}).check("window_light");
}

#[test]
fn overview() {
    check_panel(Pane::Overview, "overview");
}

#[test]
fn mechanism() {
    check_panel(Pane::Mechanism, "mechanism");
}

#[test]
fn scope() {
    check_panel(Pane::Scope(0), "scope");
}

#[test]
fn scope_with_cursors() {
    let set = |app: &mut App| app.show_only(Pane::Scope(0));
    let mut canvas = canvas([760, 420], Theme::Light, Behind::Live, 3.0, set);
    canvas.step(vec![Event::Key {
        key: Key::C,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    }]);
    canvas.step(Vec::new());
    canvas.check("scope_cursors");
}

#[test]
fn phase() {
    check_panel(Pane::Phase, "phase");
}

#[test]
fn tuning() {
    check_panel(Pane::Tuning, "tuning");
}

#[test]
fn instruments() {
    check_panel(Pane::Instruments, "instruments");
}

#[test]
fn deadlines() {
    check_panel(Pane::Deadlines, "deadlines");
}

#[test]
fn links() {
    check_panel(Pane::Links, "links");
}

#[test]
fn midi() {
    check_panel(Pane::Midi, "midi");
}

#[test]
fn faults() {
    check_panel(Pane::Faults, "faults");
}

#[test]
fn timeline() {
    let set = |app: &mut App| app.show_only(Pane::Timeline);
    canvas([760, 420], Theme::Dark, Behind::Recording, 3.0, set).check("timeline");
}

#[test]
fn keyboard() {
    check_panel(Pane::Keyboard, "keyboard");
}

#[test]
fn log() {
    check_panel(Pane::Log, "log");
}
