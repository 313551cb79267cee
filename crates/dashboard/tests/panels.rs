//! A user who clicks, drags and types in the window, and the requests to the source.

use std::time::Duration;

use dashboard::{Pane, SavedWindow};
use eframe::egui::{self, Key, Modifiers, PointerButton, accesskit::Role, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use telemetry::{Catalogue, Model, Request, Signal, Update, signal};

use crate::common::{Behind, TestWindow, open, open_with, wrong_description};

const C4: u8 = 39;

fn near(found: f64, expected: f64, within: f64) -> bool {
    (found - expected).abs() <= within
}

fn slide(window: &mut TestWindow, name: &str, share: f32) {
    let slider = window.harness.get_by_role_and_label(Role::Slider, name);
    let track = slider.rect();
    let from = track.left_center() + vec2(track.width() * 0.5, 0.0);
    let to = track.left_center() + vec2(track.width() * share, 0.0);
    window.drag(from, to, PointerButton::Primary);
}

fn write(window: &mut TestWindow, label: &str, text: &str) {
    window.click(label);
    write_here(window, text);
}

fn write_here(window: &mut TestWindow, text: &str) {
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.type_in(text);
    window.press(Modifiers::NONE, Key::Enter);
}

#[test]
fn a_key_is_selected_with_a_click_and_a_range_with_shift() {
    let mut window = open(Pane::Overview, Behind::Live);
    // Under the black keys, which lie over the white ones.
    let front =
        |window: &TestWindow, name: &str| window.rect(name).center_bottom() - vec2(0.0, 12.0);
    let at = front(&window, "key E4");
    window.press_at(at);
    window.harness.drop_at(at);
    window.settle();
    assert!(window.says("E4 · viennese"));
    window.harness.get_by_label("key A4").click_modifiers(Modifiers::SHIFT);
    window.settle();
    window.harness.state_mut().open(Pane::Instruments);
    window.settle();
    window.click_role(Role::Button, "upright");
    let expected =
        Request::UseInstrument { instrument: "upright".into(), keys: Some("E4..A4".into()) };
    assert_eq!(window.asked().last(), Some(&expected));
}

#[test]
fn every_key_says_its_name() {
    let window = open(Pane::Overview, Behind::Live);
    for key in 0..=dashboard::names::LAST {
        assert!(window.has(&format!("key {}", dashboard::names::name(key))), "{key}");
    }
}

#[test]
fn a_slider_is_dragged_and_the_host_is_asked() {
    let mut window = open(Pane::Tuning, Behind::Live);
    slide(&mut window, "rebound", 0.8);
    let asked = window.set(C4, "rebound");
    // A slider reaches 25 steps to each side, here of 0.002: the recording has none.
    assert!(asked.last().is_some_and(|it| near(*it, 0.43, 0.003)), "{asked:?}");
    window.click("Undo");
    assert!(window.set(C4, "rebound").last().is_some_and(|it| near(*it, 0.4, 1e-9)));
    window.click("Redo");
    assert!(window.set(C4, "rebound").last().is_some_and(|it| near(*it, 0.43, 0.003)));
}

#[test]
fn any_step_is_one_click_away() {
    let mut window = open(Pane::Tuning, Behind::Live);
    for value in ["7.25", "8,0", "9000 N/m"] {
        write(&mut window, "lever leather value", value);
    }
    window.click("History");
    window.click("lever leather of C4: from 1 N/mm to 7.25 N/mm");
    assert_eq!(window.set(C4, "k_drive").last(), Some(&7250.0));
    window.click("lever leather of C4: from 8 N/mm to 9 N/mm");
    assert_eq!(window.set(C4, "k_drive").last(), Some(&9000.0));
    window.click("as it was before");
    assert_eq!(window.set(C4, "k_drive").last(), Some(&1000.0));
    assert!(window.is_on("as it was before"));
}

#[test]
fn a_step_of_many_keys_says_which() {
    let mut window = open(Pane::Tuning, Behind::Live);
    window.click("link");
    window.click("same value");
    window.click("All keys");
    write(&mut window, "hammer mass value", "5");
    window.click("Store A");
    write(&mut window, "hammer mass value", "4 g");
    write(&mut window, "lever leather value", "9");
    window.click("A");
    window.click("History");
    for step in [
        "hammer mass of A0..C8, same value: from 1.331 g..1.2828 g to 5 g",
        "lever leather of A0..C8, same value: from 1 N/mm to 9 N/mm",
        "A: 6 values of C4..G4",
    ] {
        assert!(window.has(step), "{step}");
    }
}

#[test]
fn a_field_that_is_left_as_it_was_changes_nothing() {
    let mut window = open(Pane::Tuning, Behind::Live);
    write(&mut window, "hammer mass value", "2.34567");
    let before = window.set(C4, "mh");
    window.click("hammer mass value");
    window.press(Modifiers::NONE, Key::Enter);
    assert!(before.last().is_some_and(|it| near(*it, 0.002_345_67, 1e-12)), "{before:?}");
    assert_eq!(window.set(C4, "mh"), before);
}

#[test]
fn a_value_is_typed_and_taken_back_with_the_keyboard() {
    let mut window = open(Pane::Tuning, Behind::Live);
    write(&mut window, "lever leather value", "7.25");
    assert_eq!(window.set(C4, "k_drive").last(), Some(&7250.0));
    write(&mut window, "lever leather value", "100 N/mm");
    assert_eq!(window.set(C4, "k_drive").last(), Some(&100_000.0));
    window.press(Modifiers::COMMAND, Key::Z);
    assert_eq!(window.set(C4, "k_drive").last(), Some(&7250.0));
    window.press(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(window.set(C4, "k_drive").last(), Some(&100_000.0));
}

fn field(window: &TestWindow, label: &str) -> (String, Option<String>) {
    let node = window.harness.get_by_label(label);
    (node.value().unwrap_or_default(), node.accesskit_node().description())
}

#[test]
fn a_refused_text_stays_with_its_reason_and_is_not_sent() {
    let mut window = open(Pane::Tuning, Behind::Live);
    for (wrong, why) in [
        ("1 kg", "\"kg\" is another unit; write a number of N/mm."),
        ("many", "This is not a number; write a number of N/mm."),
        ("1e9", "It must be 0.05 to 100 N/mm."),
    ] {
        write(&mut window, "lever leather value", wrong);
        let expected = (wrong.to_owned(), Some(why.to_owned()));
        assert_eq!(field(&window, "lever leather value"), expected);
        window.click("hammer mass value");
        assert_eq!(field(&window, "lever leather value"), expected);
    }
    assert!(window.asked().is_empty(), "{:?}", window.asked());
    window.click("lever leather value");
    window.press(Modifiers::NONE, Key::Escape);
    assert_eq!(field(&window, "lever leather value"), ("1 N/mm".to_owned(), None));
}

#[test]
fn arrow_keys_and_the_wheel_move_a_focused_field_by_steps() {
    let mut window = open(Pane::Tuning, Behind::Live);
    let last = |window: &TestWindow| window.set(C4, "k_drive").last().copied().unwrap_or_default();
    window.click("lever leather value");
    window.press(Modifiers::NONE, Key::ArrowUp);
    assert!(near(last(&window), 1200.0, 1e-6), "{}", last(&window));
    window.press(Modifiers::SHIFT, Key::ArrowDown);
    assert!(near(last(&window), 1180.0, 1e-6), "{}", last(&window));
    let before = last(&window);
    window.harness.hover_at(window.rect("lever leather value").center());
    window.harness.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Line,
        delta: vec2(0.0, 1.0),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Unknown,
        modifiers: Modifiers::NONE,
    });
    window.settle();
    assert!(near(last(&window), before + 200.0, 1e-6), "{}", last(&window));
}

#[test]
fn a_click_on_a_slider_changes_nothing_and_arrow_keys_move_it() {
    let mut window = open(Pane::Tuning, Behind::Live);
    let track = window.harness.get_by_role_and_label(Role::Slider, "rebound").rect();
    for share in [0.1, 0.5, 0.9] {
        let at = track.left_center() + vec2(track.width() * share, 0.0);
        window.drag(at, at, PointerButton::Primary);
    }
    assert!(window.asked().is_empty(), "{:?}", window.asked());
    window.harness.get_by_role_and_label(Role::Slider, "rebound").focus();
    window.settle();
    window.press(Modifiers::NONE, Key::ArrowRight);
    let asked = window.set(C4, "rebound");
    assert!(asked.last().is_some_and(|it| near(*it, 0.402, 1e-9)), "{asked:?}");
}

#[test]
fn a_value_goes_back_to_the_instrument_s() {
    let mut window = open(Pane::Tuning, Behind::Live);
    write(&mut window, "lever leather value", "7.25");
    window.click("reset lever leather");
    assert_eq!(window.set(C4, "k_drive").last(), Some(&1000.0));
}

#[test]
fn a_and_b_are_compared() {
    let mut window = open(Pane::Tuning, Behind::Live);
    window.click("Store A");
    write(&mut window, "lever leather value", "10");
    window.click("Store B");
    window.click("A");
    assert_eq!(window.set(C4, "k_drive").last(), Some(&1000.0));
    window.click("B");
    assert_eq!(window.set(C4, "k_drive").last(), Some(&10_000.0));
    slide(&mut window, "morph", 0.75);
    let asked = window.set(C4, "k_drive");
    assert!(asked.last().is_some_and(|it| near(*it, 7750.0, 460.0)), "{asked:?}");
}

#[test]
fn a_snapshot_is_kept_and_recalled() {
    let mut window = open(Pane::Tuning, Behind::Live);
    window.harness.get_by_label("snapshot").focus();
    window.settle();
    window.click_role(Role::TextInput, "snapshot");
    window.type_in("soft");
    window.click("Keep");
    write(&mut window, "lever leather value", "10");
    window.click("Recall soft");
    assert_eq!(window.set(C4, "k_drive").last(), Some(&1000.0));
}

#[test]
fn a_scene_is_shown_as_a_file_and_replaces_another_only_by_a_button_that_says_so() {
    let mut window = open(Pane::Tuning, Behind::Live);
    window.click("Save scene");
    assert_eq!(window.asked().last(), Some(&Request::Scene {}));
    window.settle();
    let file = window.harness.get_by_label("file").value().unwrap_or_default();
    assert!(file.contains("title = \"Demonstration\""), "{file}");
    let path = std::env::temp_dir().join(format!("letoff-scene-{}.toml", std::process::id()));
    window.click_role(Role::TextInput, "to");
    window.type_in(path.display().to_string());
    window.click("Write");
    assert_eq!(std::fs::read_to_string(&path).expect("it is written"), file);
    assert!(window.has("Replace") && !window.has("Write"));
    std::fs::remove_file(&path).expect("it was there");
}

#[test]
fn an_instrument_is_used_for_a_typed_range() {
    let mut window = open(Pane::Instruments, Behind::Live);
    window.click_role(Role::TextInput, "for keys");
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.type_in("C4..B5");
    window.click_role(Role::Button, "harpsichord");
    let expected = |keys: Option<&str>| Request::UseInstrument {
        instrument: "harpsichord".into(),
        keys: keys.map(str::to_owned),
    };
    assert_eq!(window.asked().last(), Some(&expected(Some("C4..B5"))));
    window.click("All");
    window.click_role(Role::Button, "harpsichord");
    assert_eq!(window.asked().last(), Some(&expected(None)));
}

#[test]
fn a_description_shows_its_mistakes_and_is_read_again_or_opened() {
    let mut window = open(Pane::Descriptions, Behind::Live);
    assert!(window.says("Only models of the program play"));
    let [catalogue, voice] = wrong_description();
    window.harness.state_mut().take(0, catalogue);
    window.settle();
    assert!(window.says("Only models of the program play"));
    window.harness.state_mut().take(0, voice);
    window.settle();
    assert!(window.says("version 2 plays on 1 key since 3.0 s; its files are watched"));
    assert!(!window.says("version 1"), "no key plays it");
    assert!(window.says("this version plays on:") && window.says("there is no \"kk\""));
    window.click("Reload");
    let load = |description: &str, keys: Option<&str>| Request::Load {
        description: description.into(),
        keys: keys.map(str::to_owned),
    };
    assert_eq!(window.asked().last(), Some(&load("/home/me/feel.toml", None)));
    write(&mut window, "file", "other.toml");
    write(&mut window, "on keys", "C4..B5");
    window.click("Open");
    assert_eq!(window.asked().last(), Some(&load("other.toml", Some("C4..B5"))));
}

#[test]
fn stop_is_one_click_away_in_every_panel() {
    for pane in Pane::ALL {
        let mut window = open(*pane, Behind::Live);
        window.click_any("STOP");
        assert_eq!(window.asked().last(), Some(&Request::Stop {}), "{pane:?}");
    }
}

#[test]
fn stop_has_a_shortcut_that_is_heard_whatever_is_done() {
    let mut window = open(Pane::Keyboard, Behind::Live);
    let stops = |window: &TestWindow| {
        let is_stop = |it: &&Request| matches!(it, Request::Stop {});
        window.asked().iter().filter(is_stop).count()
    };
    window.click("Computer keyboard plays");
    window.press(Modifiers::COMMAND, Key::Period);
    assert_eq!(stops(&window), 1, "while the computer keyboard plays");
    window.harness.get_by_label("newtons").focus();
    window.settle();
    window.press(Modifiers::COMMAND, Key::Period);
    assert_eq!(stops(&window), 2, "while somebody types");
    let mut window = open(Pane::Log, Behind::Live);
    window.press(Modifiers::NONE, Key::F1);
    assert!(window.says("STOP: no force on any key"), "it stands in the help");
}

#[test]
fn a_stop_says_in_large_letters_what_became_of_it() {
    let mut window = open(Pane::Log, Behind::Live);
    assert!(!window.says("STOPPED"));
    window.click_any("STOP");
    let title = "STOPPED, boards told: 8 of 8";
    assert!(window.has(title) && window.says("No force on any key."));
    assert!(window.rect(title).height() > 25.0, "large");
    window.click("Dismiss");
    assert!(!window.says("STOPPED"));
}

#[test]
fn a_stop_that_is_not_confirmed_says_to_cut_the_power() {
    let mut window = open(Pane::Log, Behind::Vanishing);
    window.click_any("STOP");
    let title = "STOP NOT CONFIRMED: CUT THE POWER";
    assert!(window.has(title) && window.says("the connection was lost before the host answered"));
    // Each label has its own place, and none covers another.
    let texts =
        [title, "the host ended the connection", "Dismiss", "No host", "demonstration.mcap"];
    let rects = texts.map(|text| window.rect(text));
    for (i, a) in rects.iter().enumerate() {
        let is_over = |b: &egui::Rect| a.shrink(1.0).intersects(b.shrink(1.0));
        assert!(!rects[i + 1..].iter().any(is_over), "{} is printed over", texts[i]);
    }
    let mut window = open(Pane::Log, Behind::Recording);
    window.click_any("STOP");
    assert!(!window.has(title) && window.says("this is a recording"));
}

#[test]
fn a_board_shows_its_light() {
    let mut window = open(Pane::Links, Behind::Live);
    window.click("Identify board 5 of /dev/ttyACM0");
    assert_eq!(window.asked().last(), Some(&Request::Identify { line: 1, board: 5 }));
    // The answer is in the bar and beside the board.
    assert_eq!(window.harness.query_all_by_label("It shows its light.").count(), 2);
}

#[test]
fn a_recording_is_begun_and_ended() {
    let mut window = open(Pane::Log, Behind::Live);
    window.click("Record");
    let file = match window.asked().last() {
        Some(Request::Record { file }) => file.clone(),
        other => panic!("{other:?}"),
    };
    assert!(file.as_deref().is_some_and(|it| it.ends_with("-3s.mcap")), "{file:?}");
    window.click("Record");
    assert_eq!(window.asked().last(), Some(&Request::Record { file: None }));
}

#[test]
fn everything_stands_still_until_it_is_let_go() {
    let mut window = open(Pane::Scope(0), Behind::Live);
    let time = |window: &TestWindow, text: &str| window.says(text);
    window.press(Modifiers::NONE, Key::Space);
    assert!(time(&window, "3.006 s"));
    window.time.set(4.0);
    window.settle();
    assert!(time(&window, "3.006 s"));
    window.click("Freeze");
    assert!(!time(&window, "3.006 s"));
}

#[test]
fn a_scope_that_was_moved_follows_again() {
    let mut window = open(Pane::Scope(0), Behind::Live);
    window.drag(egui::pos2(400.0, 300.0), egui::pos2(500.0, 300.0), PointerButton::Primary);
    assert!(!window.is_on("Follow"));
    window.press(Modifiers::NONE, Key::F);
    assert!(window.is_on("Follow"));
}

fn turn_wheel(window: &mut TestWindow, modifiers: Modifiers) {
    window.harness.step();
    window.harness.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: vec2(0.0, 100.0),
        modifiers,
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
    });
    window.harness.run_steps(20);
}

#[test]
fn the_wheel_and_the_right_button_zoom() {
    let mut window = open(Pane::Scope(0), Behind::Live);
    assert!(near(window.number("window"), 2.0, 1e-9));
    window.drag(egui::pos2(300.0, 300.0), egui::pos2(500.0, 300.0), PointerButton::Secondary);
    let zoomed = window.number("window");
    assert!((0.3..0.7).contains(&zoomed), "{zoomed}");
    window.harness.hover_at(egui::pos2(400.0, 300.0));
    turn_wheel(&mut window, Modifiers::NONE);
    assert!(window.number("window") < 0.95 * zoomed, "{}", window.number("window"));
}

#[test]
fn cursors_are_dragged_and_say_the_difference() {
    let mut window = open(Pane::Scope(0), Behind::Live);
    window.click("Cursors");
    let [a, b] = ["cursor A in plot 1", "cursor B in plot 1"].map(|name| window.number(name));
    assert!(near(b - a, 2.0 / 3.0, 1e-6), "{a} {b}");
    let from = window.rect("cursor A in plot 1").center();
    window.drag(from, from - vec2(84.0, 0.0), PointerButton::Primary);
    let moved = window.number("cursor A in plot 2");
    assert!(moved < a - 0.15, "{a} {moved}");
    assert!(window.says("Δt"));
}

#[test]
fn several_keys_are_seen_in_one_scope() {
    let mut window = open(Pane::Scope(0), Behind::Live);
    assert!(window.has("position [mm]"));
    window.click("Compare");
    window.click_role(Role::TextInput, "with");
    write_here(&mut window, "E4, H9");
    assert!(window.says("write E4") && !window.has("Remove E4"));
    window.click_role(Role::TextInput, "with");
    write_here(&mut window, "E4, G4");
    assert!(window.has("Remove E4") && window.has("Remove G4"));
    window.play_on(3.0, 4.2);
    for title in ["C4 position [mm]", "E4 position [mm]", "G4 position [mm]"] {
        assert!(window.has(title), "{title}");
    }
    window.click("Remove G4");
    assert!(window.has("E4 position [mm]") && !window.has("G4 position [mm]"));
    window.click("Remove E4");
    assert!(window.has("position [mm]"));
}

#[test]
fn a_signal_without_a_unit_has_no_brackets() {
    let mut window = open(Pane::Scope(0), Behind::Live);
    let kind = signal::Kind::Guard.into();
    let bare = Signal { name: "lift".into(), kind, ..Signal::default() };
    let model = Model { name: "viennese".into(), signals: vec![bare], ..Model::default() };
    let catalogue = Catalogue { models: vec![model], tick_hz: 1000, ..Catalogue::default() };
    window.harness.state_mut().take(0, Update::Catalogue(catalogue));
    window.settle();
    assert!(window.has("sent [N]") && window.says("lift ×"));
    window.click("Channels");
    assert!(window.has("lift") && window.has("speed [m/s]"));
    assert!(!window.says("[]"));
}

fn height(window: &TestWindow) -> f64 {
    window.number("y axis of plot 1")
}

#[test]
fn the_y_axis_is_dragged_and_fits_again() {
    let mut window = open(Pane::Scope(0), Behind::Live);
    let all = height(&window);
    let axis = window.rect("y axis of plot 1").center();
    window.drag(axis, axis - vec2(0.0, 80.0), PointerButton::Primary);
    let zoomed = height(&window);
    assert!((0.35..0.65).contains(&(zoomed / all)), "{zoomed} of {all}");
    window.play_on(3.0, 4.0);
    assert!(near(height(&window), zoomed, 1e-9));
    window.click("Fit y");
    assert!(1.5 * zoomed < height(&window));
    window.drag(axis, axis + vec2(0.0, 80.0), PointerButton::Primary);
    assert!(1.5 * all < height(&window));
    for _ in 0..2 {
        window.press_at(axis);
        window.harness.drop_at(axis);
        window.harness.step();
    }
    window.settle();
    assert!(height(&window) < 1.2 * all, "{} of {all}", height(&window));
}

#[test]
fn shift_and_the_wheel_zoom_in_values_and_not_in_time() {
    let mut window = open(Pane::Scope(0), Behind::Live);
    let all = height(&window);
    window.harness.hover_at(egui::pos2(400.0, 300.0));
    window.harness.event(egui::Event::ModifiersChanged(Modifiers::SHIFT));
    turn_wheel(&mut window, Modifiers::SHIFT);
    assert!(height(&window) < 0.8 * all, "{} of {all}", height(&window));
    assert!(near(window.number("window"), 2.0, f64::EPSILON));
}

#[test]
fn a_trigger_holds_the_scope_at_a_strike() {
    let mut window = open_with(Behind::Live, None, |app| app.show_only(Pane::Scope(0)));
    window.play(0.3);
    window.click("trigger");
    window.click("strike");
    window.click("normal");
    assert!(window.says("waiting"));
    window.play(2.6);
    assert!(!window.says("waiting"));
}

#[test]
fn a_level_is_chosen_for_a_channel() {
    let mut window = open_with(Behind::Live, None, |app| app.show_only(Pane::Scope(0)));
    window.play(0.3);
    window.click("trigger");
    window.click("level");
    window.click("trigger channel");
    window.click("position");
    write(&mut window, "level", "3");
    window.click("single");
    window.click("Arm");
    assert!(window.says("waiting"));
    window.play(1.4);
    assert!(!window.says("waiting"));
}

#[test]
fn channels_are_chosen_from_the_menu() {
    let mut window = open(Pane::Scope(0), Behind::Live);
    window.click("Channels");
    window.click("speed in plot 3");
    window.settle();
    window.click("Channels");
    window.click("Cursors");
    assert!(window.has("cursor A in plot 3"));
}

#[test]
fn a_key_is_pressed_with_the_mouse_as_hard_as_it_is_far_out() {
    let mut window = open(Pane::Keyboard, Behind::Live);
    let key = window.rect("press C4");
    let at = key.center_top() + vec2(0.0, key.height() * 0.9);
    window.press_at(at);
    window.settle();
    let hard = match window.asked().last() {
        Some(Request::Press { key: C4, newtons }) => *newtons,
        other => panic!("{other:?}"),
    };
    assert!(near(hard, 5.4, 0.11), "{hard}");
    window.harness.drop_at(at);
    window.settle();
    assert_eq!(window.asked().last(), Some(&Request::Press { key: C4, newtons: 0.0 }));
}

#[test]
fn a_key_is_held_where_the_mouse_drags_it_and_let_go_with_the_mouse() {
    let mut window = open(Pane::Keyboard, Behind::Live);
    window.click("Grip");
    let key = window.rect("press C4");
    let at = |part: f32| key.center_top() + vec2(0.0, key.height() * part);
    window.press_at(at(0.5));
    window.settle();
    assert_eq!(window.asked().last(), Some(&Request::Grip { key: C4, depth: Some(0.5) }));
    // Above the key its front is pulled up.
    window.harness.hover_at(at(-0.2));
    window.settle();
    assert_eq!(window.asked().last(), Some(&Request::Grip { key: C4, depth: Some(-0.48) }));
    window.harness.drop_at(at(-0.2));
    window.settle();
    assert_eq!(window.asked().last(), Some(&Request::Grip { key: C4, depth: None }));
}

#[test]
fn the_computer_keyboard_plays_only_when_it_is_asked_to() {
    let mut window = open(Pane::Keyboard, Behind::Live);
    window.hold(Key::D);
    window.harness.key_up(Key::D);
    window.settle();
    assert!(window.asked().is_empty());
    window.click("Computer keyboard plays");
    window.hold(Key::D);
    // The third white key from C3 on.
    assert_eq!(window.asked().last(), Some(&Request::Press { key: 31, newtons: 6.0 }));
    window.harness.key_up(Key::D);
    window.settle();
    assert_eq!(window.asked().last(), Some(&Request::Press { key: 31, newtons: 0.0 }));
}

fn holding_a_key() -> TestWindow {
    let mut window = open(Pane::Keyboard, Behind::Live);
    window.click("Computer keyboard plays");
    window.hold(Key::D);
    assert_eq!(window.asked(), [Request::Press { key: 31, newtons: 6.0 }]);
    window
}

const LET_GO: Request = Request::Press { key: 31, newtons: 0.0 };

#[test]
fn a_key_that_is_held_is_let_go_when_its_panel_is_hidden() {
    let mut window = holding_a_key();
    window.harness.state_mut().show_only(Pane::Log);
    window.settle();
    assert_eq!(window.asked().last(), Some(&LET_GO));
    // The keyboard is no longer a piano: shortcuts act again.
    window.harness.key_press(Key::F1);
    window.press(Modifiers::NONE, Key::Space);
    assert!(window.is_on("Freeze"));
    window.harness.state_mut().show_only(Pane::Keyboard);
    window.settle();
    let n = window.asked().len();
    window.hold(Key::F);
    assert_eq!(window.asked().len(), n, "it plays only when it is asked to, again");
}

#[test]
fn a_key_that_is_held_is_let_go() {
    type End = (&'static str, fn(&mut TestWindow));
    let ends: [End; 3] = [
        ("the window loses the keyboard", |window| {
            window.harness.event(egui::Event::WindowFocused(false));
            window.settle();
        }),
        ("the computer keyboard plays no more", |window| window.click("Computer keyboard plays")),
        ("the window closes", |window| eframe::App::on_exit(window.harness.state_mut(), None)),
    ];
    for (when, end) in ends {
        let mut window = holding_a_key();
        end(&mut window);
        assert_eq!(window.asked().last(), Some(&LET_GO), "{when}");
    }
}

#[test]
fn typing_into_a_field_plays_no_keys() {
    let mut window = open_with(Behind::Live, None, |app| {
        app.show_row(vec![Pane::Keyboard, Pane::Midi]);
    });
    window.play(1.0);
    window.click("Computer keyboard plays");
    window.harness.get_by_role_and_label(Role::TextInput, "only with").focus();
    window.settle();
    window.harness.key_down(Key::D);
    window.type_in("d".to_owned());
    window.harness.key_up(Key::D);
    window.settle();
    assert!(window.asked().iter().all(|it| !matches!(it, Request::Press { .. })));
}

#[test]
fn a_recording_is_scrubbed_paused_and_found_again() {
    let mut window = open(Pane::Timeline, Behind::Recording);
    window.click("Pause");
    assert!(window.has("Play"));
    let line = window.rect("time line");
    let to = line.left_center() + vec2(line.width() * 0.5, 0.0);
    window.drag(line.left_center() + vec2(4.0, 0.0), to, PointerButton::Primary);
    assert!(window.says("2.") && window.says("of 4.5 s"));
    window.click_any("F#4 recovered");
    assert!(window.says("2.000 s of 4.5 s"));
}

#[test]
fn a_recording_cannot_be_changed_and_says_so() {
    let mut window = open(Pane::Tuning, Behind::Recording);
    let field = window.harness.get_by_label("lever leather value");
    assert!(field.accesskit_node().is_disabled());
    write(&mut window, "lever leather value", "7.25");
    assert_eq!(window.set(C4, "k_drive"), [0.0; 0]);
    assert!(window.says("Recording file") && !window.has("Record"));
}

#[test]
fn a_fault_is_explained_and_its_key_is_found() {
    let mut window = open(Pane::Faults, Behind::Live);
    assert!(window.says("capped"));
    assert!(window.says("The model wanted more work"));
    window.click("Show F#4");
    window.harness.state_mut().open(Pane::Tuning);
    window.settle();
    assert!(window.says("F#4"));
}

#[test]
fn midi_is_filtered_and_cleared() {
    let mut window = open(Pane::Midi, Behind::Live);
    assert!(window.says("note-on 60") && window.says("note-off 60"));
    window.click_role(Role::TextInput, "only with");
    window.type_in("note-off");
    assert!(!window.says("note-on 60") && window.says("note-off 60"));
    window.click("Clear");
    assert!(!window.says("note-off 60"));
}

#[test]
fn deadlines_show_which_distribution_is_asked_for() {
    let mut window = open(Pane::Deadlines, Behind::Live);
    assert!(window.says("p50 116 µs"));
    window.click("lateness");
    assert!(window.says("p50 15 µs"));
    assert!(window.says("2 missed"));
}

#[test]
fn a_mechanism_of_a_key_without_rows_is_not_drawn_but_waited_for() {
    let waits = "Waiting for this key's first row: how it stands is not known yet.";
    let mut window = open_with(Behind::Live, None, |app| app.show_only(Pane::Mechanism));
    assert!(window.has(waits), "nothing has come yet");
    window.play(3.0);
    assert!(!window.has(waits));
}

#[test]
fn a_panel_is_closed_and_opened_from_the_menu() {
    let mut window = open(Pane::Log, Behind::Live);
    assert!(!window.has("Computer keyboard plays"));
    window.click("Panels");
    window.click("Keyboard (closed)");
    assert!(window.has("Computer keyboard plays"));
    window.click("Panels");
    window.click("Another scope");
    assert!(window.has("Scope 2"));
    window.click("Panels");
    window.click("Reset layout");
    assert!(window.has("STOP") || window.says("STOP"));
    assert!(window.has("key C4"));
}

#[test]
fn the_help_lists_the_shortcuts() {
    let mut window = open(Pane::Log, Behind::Live);
    window.press(Modifiers::NONE, Key::F1);
    assert!(window.says("follow what comes"));
    window.press(Modifiers::COMMAND, Key::Num9);
    assert!(window.has("Computer keyboard plays"));
}

#[test]
fn the_window_remembers_how_it_was_left() {
    let mut before = open(Pane::Tuning, Behind::Live);
    before.click("lock lever leather");
    before.click("Store A");
    let ctx = before.harness.ctx.clone();
    let text = before.harness.state().memory(&ctx).text().to_owned();
    let mut after = open_with(Behind::Live, Some(SavedWindow::read(text)), |_| {});
    after.harness.set_size(vec2(900.0, 1100.0));
    after.play(1.0);
    assert!(after.has("lock lever leather") && !after.has("key C4"));
    assert!(after.is_on("lock lever leather"));
    let stale = open_with(Behind::Live, Some(SavedWindow::read("no memory at all")), |_| {});
    assert!(stale.has("key C4"));
}

#[test]
fn nothing_is_painted_again_when_nothing_has_changed() {
    let mut window = open(Pane::Scope(0), Behind::Live);
    window.settle();
    let delay = window.harness.output().viewport_output[&egui::ViewportId::ROOT].repaint_delay;
    assert_eq!(delay, Duration::MAX);
}

#[test]
fn a_scope_is_popped_out_and_put_back() {
    let mut window = open(Pane::Scope(0), Behind::Live);
    window.click("Cursors");
    window.click("Pop out");
    assert!(window.says("This scope is a window of its own."));
    window.click("Put it back");
    assert!(window.has("cursor A in plot 1"));
}

#[test]
fn everything_is_within_reach_in_a_narrow_tile() {
    let of_panes: [(Pane, &[&str]); 6] = [
        (Pane::Deadlines, &["bare timer", "p50 116 µs", "most 308 µs", "0 skipped"]),
        (
            Pane::Tuning,
            &[
                "gravity",
                "gravity value",
                "reset gravity",
                "lock gravity",
                "morph",
                "History",
                "Save instrument",
            ],
        ),
        (Pane::Midi, &["only with", "Clear"]),
        (Pane::Timeline, &["Pause", "0.01×", "8×", "+ 1 s", "time line"]),
        (Pane::Faults, &["F#4 is faulty now: capped", "Show F#4"]),
        (Pane::Mechanism, &["mechanism of C4"]),
    ];
    for (pane, labels) in of_panes {
        let others = [Pane::Log, Pane::Phase];
        let behind = if pane == Pane::Timeline { Behind::Recording } else { Behind::Live };
        let mut window = open_with(behind, None, move |app| {
            app.show_row([pane].into_iter().chain(others).collect());
        });
        window.harness.set_size(vec2(786.0, 420.0));
        window.play(3.0);
        for label in labels {
            for found in window.harness.get_all_by_label(label) {
                let rect = found.rect();
                assert!(rect.right() <= 260.0, "{label} of {pane:?} ends at {}", rect.right());
            }
        }
    }
}
