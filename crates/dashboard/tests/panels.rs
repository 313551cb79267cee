//! Somebody at the window: what is clicked, dragged and typed, and what the source is asked.

use std::time::Duration;

use dashboard::{Pane, SavedWindow};
use eframe::egui::accesskit::Role;
use eframe::egui::{self, Key, Modifiers, PointerButton, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use telemetry::{Catalogue, Model, Request, Signal, Update, signal};

use crate::common::{Behind, Stage, stage, stage_with};

const C4: u8 = 39;

fn near(found: f64, expected: f64, within: f64) -> bool {
    (found - expected).abs() <= within
}

/// A parameter's slider is dragged to this share of its track.
fn slide(stage: &mut Stage, name: &str, share: f32) {
    let slider = stage.harness.get_by_role_and_label(Role::Slider, name);
    let track = slider.rect();
    let from = track.left_center() + vec2(track.width() * 0.5, 0.0);
    let to = track.left_center() + vec2(track.width() * share, 0.0);
    stage.drag(from, to, PointerButton::Primary);
}

/// `text` is typed into what is called `label`.
fn write(stage: &mut Stage, label: &str, text: &str) {
    stage.harness.get_by_label(label).click();
    stage.settle();
    write_here(stage, text);
}

/// `text` replaces what stands where somebody writes.
fn write_here(stage: &mut Stage, text: &str) {
    stage.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    stage.harness.event(egui::Event::Text(text.into()));
    stage.settle();
    stage.harness.key_press(Key::Enter);
    stage.settle();
}

#[test]
fn a_key_is_selected_with_a_click_and_a_range_with_shift() {
    let mut stage = stage(Pane::Overview, Behind::Live);
    // Under the black keys, which lie over the white ones.
    let front = |stage: &Stage, name: &str| stage.rect(name).center_bottom() - vec2(0.0, 12.0);
    let at = front(&stage, "key E4");
    stage.press_at(at);
    stage.harness.drop_at(at);
    stage.settle();
    assert!(stage.says("E4 · grand-springs"));
    stage.harness.get_by_label("key A4").click_modifiers(Modifiers::SHIFT);
    stage.settle();
    stage.harness.state_mut().open(Pane::Instruments);
    stage.settle();
    stage.click("upright-light");
    let expected =
        Request::UseInstrument { instrument: "upright-light".into(), keys: Some("E4..A4".into()) };
    assert_eq!(stage.asked().last(), Some(&expected));
}

#[test]
fn every_key_says_its_name() {
    let stage = stage(Pane::Overview, Behind::Live);
    for key in 0..=dashboard::names::LAST {
        assert!(stage.has(&format!("key {}", dashboard::names::name(key))), "{key}");
    }
}

#[test]
fn a_slider_is_dragged_and_the_host_is_asked() {
    let mut stage = stage(Pane::Tuning, Behind::Live);
    slide(&mut stage, "restitution", 0.8);
    let asked = stage.set(C4, "restitution");
    assert!(asked.last().is_some_and(|it| near(*it, 0.76, 0.03)), "{asked:?}");
    // One drag is one step back.
    stage.click("Undo");
    assert!(stage.set(C4, "restitution").last().is_some_and(|it| near(*it, 0.4, 1e-9)));
    stage.click("Redo");
    assert!(stage.set(C4, "restitution").last().is_some_and(|it| near(*it, 0.76, 0.03)));
}

#[test]
fn any_step_is_one_click_away() {
    let mut stage = stage(Pane::Tuning, Behind::Live);
    for value in ["7250", "8000", "9000"] {
        write(&mut stage, "k2 value", value);
    }
    stage.click("History");
    stage.click("k2 of C4: from 6000 to 7250 N/m");
    assert_eq!(stage.set(C4, "k2").last(), Some(&7250.0));
    // Steps that were taken back stay in the list.
    stage.click("k2 of C4: from 8000 to 9000 N/m");
    assert_eq!(stage.set(C4, "k2").last(), Some(&9000.0));
    stage.click("as it was before");
    assert_eq!(stage.set(C4, "k2").last(), Some(&6000.0));
    let first = stage.harness.get_by_label("as it was before");
    assert_eq!(first.accesskit_node().toggled(), Some(egui::accesskit::Toggled::True));
}

#[test]
fn a_step_of_many_keys_says_which() {
    let mut stage = stage(Pane::Tuning, Behind::Live);
    stage.click("link");
    stage.click("same value");
    stage.click("All keys");
    write(&mut stage, "m_h value", "0.02");
    stage.click("Store A");
    write(&mut stage, "m_h value", "0.01");
    write(&mut stage, "k2 value", "9000");
    stage.click("A");
    stage.click("History");
    for step in [
        "m_h of A0..C8, same value: from 0.007..0.011 to 0.02 kg",
        "k2 of A0..C8, same value: from 6000 to 9000 N/m",
        "A: 176 values of A0..C8",
    ] {
        assert!(stage.has(step), "{step}");
    }
}

#[test]
fn a_field_that_is_left_as_it_was_changes_nothing() {
    let mut stage = stage(Pane::Tuning, Behind::Live);
    // More digits than it shows.
    write(&mut stage, "m_h value", "0.01234567");
    let before = stage.set(C4, "m_h");
    stage.harness.get_by_label("m_h value").click();
    stage.settle();
    stage.harness.key_press(Key::Enter);
    stage.settle();
    assert_eq!((before.last(), stage.set(C4, "m_h")), (Some(&0.012_345_67), before.clone()));
}

#[test]
fn a_value_is_typed_and_taken_back_with_the_keyboard() {
    let mut stage = stage(Pane::Tuning, Behind::Live);
    write(&mut stage, "k2 value", "7250");
    assert_eq!(stage.set(C4, "k2").last(), Some(&7250.0));
    write(&mut stage, "k2 value", "1e9");
    assert_eq!(stage.set(C4, "k2").last(), Some(&20_000.0));
    stage.harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    stage.settle();
    assert_eq!(stage.set(C4, "k2").last(), Some(&7250.0));
    stage.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    stage.settle();
    assert_eq!(stage.set(C4, "k2").last(), Some(&20_000.0));
}

#[test]
fn a_value_goes_back_to_the_instrument_s() {
    let mut stage = stage(Pane::Tuning, Behind::Live);
    write(&mut stage, "k2 value", "7250");
    stage.click("reset k2");
    assert_eq!(stage.set(C4, "k2").last(), Some(&6000.0));
}

#[test]
fn a_locked_parameter_does_not_move() {
    let mut stage = stage(Pane::Tuning, Behind::Live);
    stage.click("lock restitution");
    slide(&mut stage, "restitution", 0.9);
    assert!(stage.set(C4, "restitution").is_empty());
    stage.click("lock restitution");
    slide(&mut stage, "restitution", 0.9);
    assert!(!stage.set(C4, "restitution").is_empty());
}

#[test]
fn a_range_follows_one_slider() {
    let mut stage = stage(Pane::Tuning, Behind::Live);
    stage.click("link");
    stage.click("same value");
    stage.click("All keys");
    write(&mut stage, "r2 value", "8");
    for key in [0, C4, 87] {
        assert_eq!(stage.set(key, "r2").last(), Some(&8.0), "{key}");
    }
}

#[test]
fn a_and_b_are_compared() {
    let mut stage = stage(Pane::Tuning, Behind::Live);
    stage.click("Store A");
    write(&mut stage, "k2 value", "10000");
    stage.click("Store B");
    stage.click("A");
    assert_eq!(stage.set(C4, "k2").last(), Some(&6000.0));
    stage.click("B");
    assert_eq!(stage.set(C4, "k2").last(), Some(&10_000.0));
    slide(&mut stage, "morph", 0.75);
    let asked = stage.set(C4, "k2");
    assert!(asked.last().is_some_and(|it| near(*it, 9000.0, 200.0)), "{asked:?}");
}

#[test]
fn a_snapshot_is_kept_and_recalled() {
    let mut stage = stage(Pane::Tuning, Behind::Live);
    stage.harness.get_by_label("snapshot").focus();
    stage.settle();
    let field = stage.harness.get_by_role_and_label(Role::TextInput, "snapshot");
    field.click();
    stage.settle();
    stage.harness.event(egui::Event::Text("soft".into()));
    stage.settle();
    stage.click("Keep");
    write(&mut stage, "k2 value", "10000");
    stage.click("Recall soft");
    assert_eq!(stage.set(C4, "k2").last(), Some(&6000.0));
}

#[test]
fn a_scene_and_a_preset_are_shown_as_files() {
    let mut stage = stage(Pane::Tuning, Behind::Live);
    stage.click("Save scene");
    assert_eq!(stage.asked().last(), Some(&Request::Scene {}));
    stage.settle();
    let file = stage.harness.get_by_label("file").value().unwrap_or_default();
    assert!(file.contains("title = \"Demonstration\""), "{file}");
    stage.click("Save preset");
    let file = stage.harness.get_by_label("file").value().unwrap_or_default();
    assert!(file.contains("model = \"key-hammer-springs\""), "{file}");
    let path = std::env::temp_dir().join(format!("letoff-preset-{}.toml", std::process::id()));
    let field = stage.harness.get_by_role_and_label(Role::TextInput, "to");
    field.click();
    stage.settle();
    stage.harness.event(egui::Event::Text(path.display().to_string()));
    stage.settle();
    stage.click("Write");
    assert_eq!(std::fs::read_to_string(&path).expect("it is written"), file);
    // Nothing that is there is overwritten.
    stage.click("Write");
    assert!(stage.says("cannot be written"));
    std::fs::remove_file(&path).expect("it was there");
}

#[test]
fn an_instrument_is_used_for_a_typed_range() {
    let mut stage = stage(Pane::Instruments, Behind::Live);
    let field = stage.harness.get_by_role_and_label(Role::TextInput, "for keys");
    field.click();
    stage.settle();
    stage.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    stage.harness.event(egui::Event::Text("C4..B5".into()));
    stage.settle();
    stage.harness.get_by_role_and_label(Role::Button, "spring-wall").click();
    stage.settle();
    let expected = |keys: Option<&str>| Request::UseInstrument {
        instrument: "spring-wall".into(),
        keys: keys.map(str::to_owned),
    };
    assert_eq!(stage.asked().last(), Some(&expected(Some("C4..B5"))));
    stage.click("All");
    stage.harness.get_by_role_and_label(Role::Button, "spring-wall").click();
    stage.settle();
    assert_eq!(stage.asked().last(), Some(&expected(None)));
}

#[test]
fn stop_is_one_click_away_in_every_panel() {
    for pane in Pane::ALL {
        let mut stage = stage(pane, Behind::Live);
        let stop = stage.harness.get_by_label_contains("STOP");
        stop.click();
        stage.settle();
        assert_eq!(stage.asked().last(), Some(&Request::Stop {}), "{pane:?}");
    }
}

#[test]
fn stop_has_a_shortcut_that_is_heard_whatever_is_done() {
    let mut stage = stage(Pane::Keyboard, Behind::Live);
    let stops = |stage: &Stage| {
        let is_stop = |it: &&Request| matches!(it, Request::Stop {});
        stage.asked().iter().filter(is_stop).count()
    };
    stage.click("Computer keyboard plays");
    stage.harness.key_press_modifiers(Modifiers::COMMAND, Key::Period);
    stage.settle();
    assert_eq!(stops(&stage), 1, "while the computer keyboard plays");
    stage.harness.get_by_label("newtons").focus();
    stage.settle();
    stage.harness.key_press_modifiers(Modifiers::COMMAND, Key::Period);
    stage.settle();
    assert_eq!(stops(&stage), 2, "while somebody types");
    let mut stage = self::stage(Pane::Log, Behind::Live);
    stage.harness.key_press(Key::F1);
    stage.settle();
    assert!(stage.says("STOP: no force on any key"), "it stands in the help");
}

#[test]
fn a_stop_says_in_large_letters_what_became_of_it() {
    let mut stage = stage(Pane::Log, Behind::Live);
    assert!(!stage.says("STOPPED"));
    stage.harness.get_by_label_contains("STOP").click();
    stage.settle();
    let title = "STOPPED, boards told: 8 of 8";
    assert!(stage.has(title) && stage.says("No force on any key."));
    assert!(stage.rect(title).height() > 25.0, "large");
    stage.click("Dismiss");
    assert!(!stage.says("STOPPED"));
}

#[test]
fn a_stop_that_is_not_confirmed_says_to_cut_the_power() {
    let mut stage = stage(Pane::Log, Behind::Vanishing);
    stage.harness.get_by_label_contains("STOP").click();
    stage.settle();
    let title = "STOP NOT CONFIRMED: CUT THE POWER";
    assert!(stage.has(title) && stage.says("the connection was lost before the host answered"));
    // Each in its own place, and none over another.
    let texts = [title, "the host ended the connection", "Dismiss", "lost", "demonstration"];
    let rects = texts.map(|text| stage.rect(text));
    for (i, a) in rects.iter().enumerate() {
        let is_over = |b: &egui::Rect| a.shrink(1.0).intersects(b.shrink(1.0));
        assert!(!rects[i + 1..].iter().any(is_over), "{} is printed over", texts[i]);
    }
    // A recording has no keys that could have forces.
    let mut stage = self::stage(Pane::Log, Behind::Recording);
    stage.harness.get_by_label_contains("STOP").click();
    stage.settle();
    assert!(!stage.has(title) && stage.says("A recording cannot be changed"));
}

#[test]
fn a_board_shows_its_light() {
    let mut stage = stage(Pane::Links, Behind::Live);
    stage.click("Identify board 5 of /dev/ttyACM0");
    assert_eq!(stage.asked().last(), Some(&Request::Identify { line: 1, board: 5 }));
    // The answer stands in the bar, and beside the board.
    assert_eq!(stage.harness.query_all_by_label("It shows its light.").count(), 2);
}

#[test]
fn a_light_that_is_refused_says_why_beside_its_board() {
    let mut stage = stage(Pane::Links, Behind::Recording);
    stage.click("Identify board 2 of can0");
    assert_eq!(stage.harness.query_all_by_label("A recording cannot be changed.").count(), 2);
}

#[test]
fn a_recording_is_begun_and_ended() {
    let mut stage = stage(Pane::Log, Behind::Live);
    stage.click("Record");
    let file = match stage.asked().last() {
        Some(Request::Record { file }) => file.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!(file.as_deref(), Some("2026-11-22-09-00-00-3s.mcap"));
    stage.click("Record");
    assert_eq!(stage.asked().last(), Some(&Request::Record { file: None }));
}

#[test]
fn everything_stands_still_until_it_is_let_go() {
    let mut stage = stage(Pane::Scope(0), Behind::Live);
    let time = |stage: &Stage, text: &str| stage.says(text);
    stage.harness.key_press(Key::Space);
    stage.settle();
    assert!(time(&stage, "2.976 s"));
    stage.hand.set(5.0);
    stage.settle();
    assert!(time(&stage, "2.976 s"));
    stage.click("Freeze");
    assert!(time(&stage, "4.992 s"));
}

#[test]
fn a_scope_that_was_moved_follows_again() {
    let mut stage = stage(Pane::Scope(0), Behind::Live);
    stage.drag(egui::pos2(400.0, 300.0), egui::pos2(500.0, 300.0), PointerButton::Primary);
    let follows = |stage: &Stage| {
        let follow = stage.harness.get_by_label("Follow");
        follow.accesskit_node().toggled() == Some(egui::accesskit::Toggled::True)
    };
    assert!(!follows(&stage));
    stage.harness.key_press(Key::F);
    stage.settle();
    assert!(follows(&stage));
}

#[test]
fn the_wheel_and_the_right_button_zoom() {
    let mut stage = stage(Pane::Scope(0), Behind::Live);
    let window = |stage: &Stage| {
        let window = stage.harness.get_by_label("window");
        window.accesskit_node().numeric_value().unwrap_or_default()
    };
    assert!(near(window(&stage), 2.0, 1e-9));
    stage.drag(egui::pos2(300.0, 300.0), egui::pos2(500.0, 300.0), PointerButton::Secondary);
    let zoomed = window(&stage);
    assert!((0.3..0.7).contains(&zoomed), "{zoomed}");
    stage.harness.hover_at(egui::pos2(400.0, 300.0));
    stage.harness.step();
    stage.harness.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: vec2(0.0, 100.0),
        modifiers: Modifiers::NONE,
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
    });
    stage.harness.run_steps(20);
    assert!(window(&stage) < 0.95 * zoomed, "{}", window(&stage));
}

#[test]
fn cursors_are_dragged_and_say_the_difference() {
    let mut stage = stage(Pane::Scope(0), Behind::Live);
    stage.click("Cursors");
    let at = |stage: &Stage, name: &str| {
        let cursor = stage.harness.get_by_label(name);
        cursor.accesskit_node().numeric_value().unwrap_or_default()
    };
    let (a, b) = (at(&stage, "cursor A in plot 1"), at(&stage, "cursor B in plot 1"));
    assert!(near(b - a, 2.0 / 3.0, 1e-6), "{a} {b}");
    let from = stage.rect("cursor A in plot 1").center();
    stage.drag(from, from - vec2(84.0, 0.0), PointerButton::Primary);
    let moved = at(&stage, "cursor A in plot 2");
    assert!(moved < a - 0.15, "{a} {moved}");
    assert!(stage.says("Δt"));
}

#[test]
fn several_keys_are_seen_in_one_scope() {
    let mut stage = stage(Pane::Scope(0), Behind::Live);
    assert!(stage.has("position [mm]"));
    stage.click("Compare");
    stage.harness.get_by_role_and_label(Role::TextInput, "with").click();
    stage.settle();
    write_here(&mut stage, "E4, H9");
    assert!(stage.says("write E4") && !stage.has("Remove E4"));
    stage.harness.get_by_role_and_label(Role::TextInput, "with").click();
    stage.settle();
    write_here(&mut stage, "E4, G4");
    assert!(stage.has("Remove E4") && stage.has("Remove G4"));
    // Their rows are followed from now on.
    stage.play_on(3.0, 4.5);
    for title in ["C4 position [mm]", "E4 position [mm]", "G4 position [mm]"] {
        assert!(stage.has(title), "{title}");
    }
    stage.click("Remove G4");
    assert!(stage.has("E4 position [mm]") && !stage.has("G4 position [mm]"));
    stage.click("Remove E4");
    assert!(stage.has("position [mm]"));
}

#[test]
fn a_signal_without_a_unit_has_no_brackets() {
    let mut stage = stage(Pane::Scope(0), Behind::Live);
    let kind = signal::Kind::Guard.into();
    let bare = Signal { name: "lift".into(), kind, ..Signal::default() };
    let model =
        Model { name: "key-hammer-springs".into(), signals: vec![bare], ..Model::default() };
    let catalogue = Catalogue { models: vec![model], tick_hz: 1000, ..Catalogue::default() };
    stage.harness.state_mut().take(0, Update::Catalogue(catalogue));
    stage.settle();
    assert!(stage.has("sent [N]") && stage.says("lift ×"));
    stage.click("Channels");
    assert!(stage.has("lift") && stage.has("speed [m/s]"));
    assert!(!stage.says("[]"));
}

/// How much plot 1 shows of its values.
fn height(stage: &Stage) -> f64 {
    let axis = stage.harness.get_by_label("y axis of plot 1");
    axis.accesskit_node().numeric_value().unwrap_or_default()
}

#[test]
fn the_y_axis_is_dragged_and_fits_again() {
    let mut stage = stage(Pane::Scope(0), Behind::Live);
    let all = height(&stage);
    let axis = stage.rect("y axis of plot 1").center();
    stage.drag(axis, axis - vec2(0.0, 80.0), PointerButton::Primary);
    let zoomed = height(&stage);
    assert!((0.35..0.65).contains(&(zoomed / all)), "{zoomed} of {all}");
    // What was chosen stays while time goes by.
    stage.play_on(3.0, 4.0);
    assert!(near(height(&stage), zoomed, 1e-9));
    stage.click("Fit y");
    assert!(1.5 * zoomed < height(&stage));
    stage.drag(axis, axis + vec2(0.0, 80.0), PointerButton::Primary);
    assert!(1.5 * all < height(&stage));
    for _ in 0..2 {
        stage.press_at(axis);
        stage.harness.drop_at(axis);
        stage.harness.step();
    }
    stage.settle();
    assert!(height(&stage) < 1.2 * all, "{} of {all}", height(&stage));
}

#[test]
fn shift_and_the_wheel_zoom_in_values_and_not_in_time() {
    let mut stage = stage(Pane::Scope(0), Behind::Live);
    let all = height(&stage);
    stage.harness.hover_at(egui::pos2(400.0, 300.0));
    stage.harness.event(egui::Event::ModifiersChanged(Modifiers::SHIFT));
    stage.harness.step();
    stage.harness.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: vec2(0.0, 100.0),
        modifiers: Modifiers::SHIFT,
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
    });
    stage.harness.run_steps(20);
    assert!(height(&stage) < 0.8 * all, "{} of {all}", height(&stage));
    let window = stage.harness.get_by_label("window");
    assert_eq!(window.accesskit_node().numeric_value(), Some(2.0));
}

#[test]
fn a_trigger_holds_the_scope_at_a_strike() {
    let mut stage = stage_with(Behind::Live, None, |app| app.show_only(Pane::Scope(0)));
    stage.play(0.3);
    stage.click("trigger");
    stage.click("strike");
    stage.click("normal");
    assert!(stage.says("waiting"));
    stage.play(2.6);
    assert!(!stage.says("waiting"));
}

#[test]
fn a_level_is_chosen_for_a_channel() {
    let mut stage = stage_with(Behind::Live, None, |app| app.show_only(Pane::Scope(0)));
    stage.play(0.3);
    stage.click("trigger");
    stage.click("level");
    stage.click("trigger channel");
    stage.click("position");
    write(&mut stage, "level", "5");
    stage.click("single");
    stage.click("Arm");
    assert!(stage.says("waiting"));
    stage.play(1.2);
    assert!(!stage.says("waiting"));
}

#[test]
fn channels_are_chosen_from_the_menu() {
    let mut stage = stage(Pane::Scope(0), Behind::Live);
    stage.click("Channels");
    stage.click("speed in plot 3");
    stage.settle();
    stage.click("Channels");
    stage.click("Cursors");
    assert!(stage.has("cursor A in plot 3"));
}

#[test]
fn a_key_is_pressed_with_the_mouse_as_hard_as_it_is_far_out() {
    let mut stage = stage(Pane::Keyboard, Behind::Live);
    let key = stage.rect("press C4");
    let at = key.center_top() + vec2(0.0, key.height() * 0.9);
    stage.press_at(at);
    stage.settle();
    let hard = match stage.asked().last() {
        Some(Request::Press { key: C4, newtons }) => *newtons,
        other => panic!("{other:?}"),
    };
    assert!(near(hard, 5.4, 0.11), "{hard}");
    stage.harness.drop_at(at);
    stage.settle();
    assert_eq!(stage.asked().last(), Some(&Request::Press { key: C4, newtons: 0.0 }));
}

#[test]
fn the_computer_keyboard_plays_only_when_it_is_asked_to() {
    let mut stage = stage(Pane::Keyboard, Behind::Live);
    stage.harness.key_down(Key::D);
    stage.settle();
    stage.harness.key_up(Key::D);
    stage.settle();
    assert!(stage.asked().is_empty());
    stage.click("Computer keyboard plays");
    stage.harness.key_down(Key::D);
    stage.settle();
    // The third white key from C3 on.
    assert_eq!(stage.asked().last(), Some(&Request::Press { key: 31, newtons: 6.0 }));
    stage.harness.key_up(Key::D);
    stage.settle();
    assert_eq!(stage.asked().last(), Some(&Request::Press { key: 31, newtons: 0.0 }));
}

/// A stage whose computer keyboard holds D, which is E3.
fn holding_a_key() -> Stage {
    let mut stage = stage(Pane::Keyboard, Behind::Live);
    stage.click("Computer keyboard plays");
    stage.harness.key_down(Key::D);
    stage.settle();
    assert_eq!(stage.asked(), [Request::Press { key: 31, newtons: 6.0 }]);
    stage
}

/// E3 is let go.
const LET_GO: Request = Request::Press { key: 31, newtons: 0.0 };

#[test]
fn a_key_that_is_held_is_let_go_when_its_panel_is_hidden() {
    let mut stage = holding_a_key();
    stage.harness.state_mut().show_only(Pane::Log);
    stage.settle();
    assert_eq!(stage.asked().last(), Some(&LET_GO));
    // The keyboard is not a piano any more: shortcuts are heard again.
    stage.harness.key_press(Key::F1);
    stage.harness.key_press(Key::Space);
    stage.settle();
    let freeze = stage.harness.get_by_label("Freeze");
    assert_eq!(freeze.accesskit_node().toggled(), Some(egui::accesskit::Toggled::True));
    stage.harness.state_mut().show_only(Pane::Keyboard);
    stage.settle();
    let n = stage.asked().len();
    stage.harness.key_down(Key::F);
    stage.settle();
    assert_eq!(stage.asked().len(), n, "it plays only when it is asked to, again");
}

#[test]
fn a_key_that_is_held_is_let_go_when_the_window_loses_the_keyboard() {
    let mut stage = holding_a_key();
    stage.harness.event(egui::Event::WindowFocused(false));
    stage.settle();
    assert_eq!(stage.asked().last(), Some(&LET_GO));
}

#[test]
fn a_key_that_is_held_is_let_go_when_the_computer_keyboard_plays_no_more() {
    let mut stage = holding_a_key();
    stage.click("Computer keyboard plays");
    assert_eq!(stage.asked().last(), Some(&LET_GO));
}

#[test]
fn a_key_that_is_held_is_let_go_when_the_window_closes() {
    let mut stage = holding_a_key();
    eframe::App::on_exit(stage.harness.state_mut(), None);
    assert_eq!(stage.asked().last(), Some(&LET_GO));
}

#[test]
fn typing_into_a_field_plays_no_keys() {
    let mut stage = stage_with(Behind::Live, None, |app| {
        app.show_row(vec![Pane::Keyboard, Pane::Midi]);
    });
    stage.play(1.0);
    stage.click("Computer keyboard plays");
    stage.harness.get_by_role_and_label(Role::TextInput, "only with").focus();
    stage.settle();
    stage.harness.key_down(Key::D);
    stage.harness.event(egui::Event::Text("d".to_owned()));
    stage.settle();
    stage.harness.key_up(Key::D);
    stage.settle();
    assert!(stage.asked().iter().all(|it| !matches!(it, Request::Press { .. })));
}

#[test]
fn a_recording_is_scrubbed_paused_and_found_again() {
    let mut stage = stage(Pane::Timeline, Behind::Recording);
    stage.click("Pause");
    assert!(stage.has("Play"));
    let line = stage.rect("time line");
    let to = line.left_center() + vec2(line.width() * 0.5, 0.0);
    stage.drag(line.left_center() + vec2(4.0, 0.0), to, PointerButton::Primary);
    assert!(stage.says("12.") && stage.says("of 24.0 s"));
    let mark = stage.harness.get_by_label_contains("instrument changed");
    mark.click();
    stage.settle();
    assert!(stage.says("8.000 s of 24.0 s"));
}

#[test]
fn a_recording_cannot_be_changed_and_says_so() {
    let mut stage = stage(Pane::Tuning, Behind::Recording);
    write(&mut stage, "k2 value", "7250");
    assert!(stage.says("A recording cannot be changed."));
    assert!(!stage.has("Record"));
}

#[test]
fn a_fault_is_explained_and_its_key_is_found() {
    let mut stage = stage(Pane::Faults, Behind::Live);
    assert!(stage.says("capped"));
    assert!(stage.says("The model wanted more work"));
    stage.click("Show F#4");
    stage.harness.state_mut().open(Pane::Tuning);
    stage.settle();
    assert!(stage.says("F#4 · grand-springs"));
}

#[test]
fn midi_is_filtered_and_cleared() {
    let mut stage = stage(Pane::Midi, Behind::Live);
    assert!(stage.says("note on C4") && stage.says("note off C4"));
    let field = stage.harness.get_by_role_and_label(Role::TextInput, "only with");
    field.click();
    stage.settle();
    stage.harness.event(egui::Event::Text("note off".into()));
    stage.settle();
    assert!(!stage.says("note on C4") && stage.says("note off C4"));
    stage.click("Clear");
    assert!(!stage.says("note off C4"));
}

#[test]
fn deadlines_show_which_distribution_is_asked_for() {
    let mut stage = stage(Pane::Deadlines, Behind::Live);
    assert!(stage.says("p50 116 µs"));
    stage.click("lateness");
    assert!(stage.says("p50 15 µs"));
    assert!(stage.says("2 missed"));
}

#[test]
fn force_and_travel_say_what_a_technician_wants_to_know() {
    let stage = stage(Pane::Phase, Behind::Live);
    for text in ["down ", "up ", "balance ", "friction "] {
        assert!(stage.says(text), "{text}");
    }
}

#[test]
fn a_mechanism_says_its_mode() {
    let stage = stage(Pane::Mechanism, Behind::Live);
    assert!(stage.has("mechanism of C4"));
    assert!(stage.says("B1 on the key") || stage.says("B2 in flight"));
}

#[test]
fn a_mechanism_of_a_key_without_rows_is_not_drawn_but_waited_for() {
    let waits = "Waiting for this key's first row: how it stands is not known yet.";
    let mut stage = stage_with(Behind::Live, None, |app| app.show_only(Pane::Mechanism));
    stage.settle();
    assert!(stage.has(waits), "nothing has come yet");
    stage.play(3.0);
    assert!(!stage.has(waits));
}

#[test]
fn a_panel_is_closed_and_opened_from_the_menu() {
    let mut stage = stage(Pane::Log, Behind::Live);
    assert!(!stage.has("Computer keyboard plays"));
    stage.click("Panels");
    stage.click("Keyboard (closed)");
    assert!(stage.has("Computer keyboard plays"));
    stage.click("Panels");
    stage.click("Another scope");
    assert!(stage.has("Scope 2"));
    stage.click("Panels");
    stage.click("Reset layout");
    assert!(stage.has("STOP") || stage.says("STOP"));
    assert!(stage.has("key C4"));
}

#[test]
fn dark_light_and_scale_are_chosen() {
    let mut stage = stage(Pane::Log, Behind::Live);
    stage.click("View");
    stage.click("Light");
    assert_eq!(stage.harness.ctx.theme(), egui::Theme::Light);
    stage.click("View");
    stage.click("Dark");
    assert_eq!(stage.harness.ctx.theme(), egui::Theme::Dark);
}

#[test]
fn the_help_lists_the_shortcuts() {
    let mut stage = stage(Pane::Log, Behind::Live);
    stage.harness.key_press(Key::F1);
    stage.settle();
    assert!(stage.says("follow what comes"));
    stage.harness.key_press_modifiers(Modifiers::COMMAND, Key::Num9);
    stage.settle();
    assert!(stage.has("Computer keyboard plays"));
}

#[test]
fn the_window_remembers_how_it_was_left() {
    let mut before = stage(Pane::Tuning, Behind::Live);
    before.click("lock k2");
    before.click("Store A");
    let ctx = before.harness.ctx.clone();
    let text = before.harness.state().memory(&ctx).text().to_owned();
    let mut after = stage_with(Behind::Live, Some(SavedWindow::read(text)), |_| {});
    after.play(1.0);
    assert!(after.has("lock k2") && !after.has("key C4"));
    let lock = after.harness.get_by_label("lock k2");
    assert_eq!(lock.accesskit_node().toggled(), Some(egui::accesskit::Toggled::True));
    let stale = stage_with(Behind::Live, Some(SavedWindow::read("no memory at all")), |_| {});
    assert!(stale.has("key C4"));
}

#[test]
fn nothing_is_painted_again_when_nothing_has_changed() {
    let mut stage = stage(Pane::Scope(0), Behind::Live);
    stage.settle();
    let delay = stage.harness.output().viewport_output[&egui::ViewportId::ROOT].repaint_delay;
    assert_eq!(delay, Duration::MAX);
}

#[test]
fn a_scope_is_popped_out_and_put_back() {
    let mut stage = stage(Pane::Scope(0), Behind::Live);
    stage.click("Cursors");
    stage.click("Pop out");
    assert!(stage.says("This scope is a window of its own."));
    stage.click("Put it back");
    assert!(stage.has("cursor A in plot 1"));
}

#[test]
fn everything_is_within_reach_in_a_narrow_tile() {
    let of_panes: [(Pane, &[&str]); 6] = [
        (Pane::Deadlines, &["bare timer", "p50 116 µs", "most 308 µs", "0 skipped"]),
        (
            Pane::Tuning,
            &["k2", "k2 value", "reset k2", "lock k2", "morph", "History", "Save preset"],
        ),
        (Pane::Midi, &["only with", "Clear"]),
        (Pane::Timeline, &["Pause", "0.01×", "8×", "+ 1 s", "time line"]),
        (Pane::Faults, &["F#4 is faulty now: capped", "Show F#4"]),
        (Pane::Mechanism, &["mechanism of C4"]),
    ];
    for (pane, labels) in of_panes {
        let others = [Pane::Log, Pane::Phase];
        let behind = if pane == Pane::Timeline { Behind::Recording } else { Behind::Live };
        let mut stage = stage_with(behind, None, move |app| {
            app.show_row([pane].into_iter().chain(others).collect());
        });
        stage.harness.set_size(vec2(786.0, 420.0));
        stage.play(3.0);
        for label in labels {
            for found in stage.harness.get_all_by_label(label) {
                let rect = found.rect();
                assert!(rect.right() <= 260.0, "{label} of {pane:?} ends at {}", rect.right());
            }
        }
    }
}
