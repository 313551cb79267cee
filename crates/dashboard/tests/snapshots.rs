//! Pictures of the window, panel by panel, drawn without a graphics card.

use dashboard::{App, Pane, SavedWindow};
use eframe::egui::{Event, Key, Modifiers, Theme};

use crate::common::{Behind, TestClock, snapshot::Canvas, source, wrong_description};

fn canvas(
    size: [usize; 2],
    theme: Theme,
    behind: Behind,
    seconds: f64,
    set: impl FnOnce(&mut App),
) -> Canvas {
    let time = TestClock::default();
    let (source, _) = source(&time, behind);
    let mut canvas = Canvas::new(size, theme, |ctx| {
        let mut app = App::new(source, time.clock(), None, ctx);
        set(&mut app);
        app
    });
    canvas.play(&time, seconds);
    canvas
}

#[test]
fn the_window_on_dark_and_on_light_ground() {
    for (theme, name) in [(Theme::Dark, "window_dark"), (Theme::Light, "window_light")] {
        canvas([1280, 800], theme, Behind::Live, 3.0, |_| {}).check(name);
    }
}

fn stopped(behind: Behind, size: [usize; 2], theme: Theme) -> Canvas {
    let mut canvas = canvas(size, theme, behind, 1.0, |app| app.show_only(Pane::Overview));
    canvas.step(vec![Event::Key {
        key: Key::Period,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::COMMAND,
    }]);
    for _ in 0..3 {
        canvas.step(Vec::new());
    }
    canvas
}

#[test]
fn a_stop_that_was_done() {
    stopped(Behind::Live, [760, 420], Theme::Dark).check("stop_confirmed");
}

#[test]
fn a_stop_that_may_not_have_been_done() {
    stopped(Behind::Vanishing, [620, 420], Theme::Light).check("stop_unconfirmed");
}

#[test]
fn every_panel() {
    let shows_nothing = [Pane::Descriptions, Pane::Timeline];
    for pane in Pane::ALL.iter().filter(|pane| !shows_nothing.contains(pane)) {
        let set = |app: &mut App| app.show_only(*pane);
        let name = format!("{pane:?}").to_lowercase().replace("(0)", "");
        canvas([760, 420], Theme::Dark, Behind::Live, 3.0, set).check(&name);
    }
}

#[test]
fn descriptions() {
    let set = |app: &mut App| app.show_only(Pane::Descriptions);
    let mut canvas = canvas([760, 420], Theme::Dark, Behind::Live, 3.0, set);
    for update in wrong_description() {
        canvas.app().take(0, update);
    }
    canvas.step(Vec::new());
    canvas.step(Vec::new());
    canvas.check("descriptions");
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
fn scope_of_two_keys() {
    let time = TestClock::default();
    let mut canvas = Canvas::new([760, 420], Theme::Dark, |ctx| {
        let window = |memory| {
            let (source, _) = source(&time, Behind::Live);
            App::new(source, time.clock(), memory, ctx)
        };
        let mut app = window(None);
        app.show_only(Pane::Scope(0));
        window(Some(compared(app.memory(ctx).text())))
    });
    canvas.play(&time, 3.0);
    canvas.check("scope_compared");
}

fn compared(memory: &str) -> SavedWindow {
    let mut memory: serde_json::Value = serde_json::from_str(memory).unwrap_or_default();
    memory["views"]["scopes"] = serde_json::json!({
        "0": { "compared": [43], "lanes": [["sent", "string"], ["position"]] }
    });
    SavedWindow::read(memory.to_string())
}

#[test]
fn tuning_with_its_steps() {
    let set = |app: &mut App| app.show_only(Pane::Tuning);
    let mut canvas = canvas([760, 420], Theme::Dark, Behind::Live, 3.0, set);
    for (y, to) in [(147.0, 220.0), (172.0, 120.0), (247.0, 260.0)] {
        canvas.drag([180.0, y], [to, y]);
    }
    // Undo, then the list.
    canvas.drag([26.0, 90.0], [26.0, 90.0]);
    canvas.drag([131.0, 90.0], [131.0, 90.0]);
    canvas.check("tuning_steps");
}

#[test]
fn links_of_a_board_that_shows_its_light() {
    let set = |app: &mut App| app.show_only(Pane::Links);
    let mut canvas = canvas([860, 420], Theme::Light, Behind::Live, 3.0, set);
    canvas.drag([80.0, 347.0], [80.0, 347.0]);
    canvas.check("links_light");
}

#[test]
fn timeline() {
    let set = |app: &mut App| app.show_only(Pane::Timeline);
    canvas([760, 420], Theme::Dark, Behind::Recording, 3.0, set).check("timeline");
}

#[test]
fn panels_in_narrow_tiles() {
    for (panes, name) in [
        ([Pane::Deadlines, Pane::Links, Pane::Tuning], "narrow_deadlines"),
        ([Pane::Faults, Pane::Midi, Pane::Timeline], "narrow_faults"),
        ([Pane::Scope(0), Pane::Mechanism, Pane::Instruments], "narrow_scope"),
    ] {
        let set = |app: &mut App| app.show_row(panes.to_vec());
        canvas([786, 460], Theme::Dark, Behind::Recording, 3.0, set).check(name);
    }
}
