//! Tuning with the mouse, on the keys of a real host.

use std::fs;

use dashboard::Pane;
use dashboard::open::WindowTarget;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, vec2};
use host::control::{Reply, Request};
use scene::{Instrument, KeyVoice, Library, Scene};

use super::program::HostProgram;
use super::user::UserWindow;
use crate::letoff::folder;

fn playing(host: &HostProgram) -> Vec<Vec<u64>> {
    let Ok(Ok(Reply::Scene { toml })) = host.ask(&Request::Scene {}) else { panic!("no scene") };
    let file = host.folder().join("playing.toml");
    fs::write(&file, toml).expect("a file");
    let scene = Scene::load(&Library::default(), &file.to_string_lossy(), &[]);
    let scene = scene.unwrap_or_else(|mistakes| panic!("{mistakes}"));
    let bits = |voice: &KeyVoice| voice.values.iter().map(|it| it.to_bits()).collect();
    scene.keys.iter().flatten().map(bits).collect()
}

fn open(host: &HostProgram) -> UserWindow {
    let mut window = UserWindow::open(&WindowTarget::Socket(host.socket()));
    window.app().show_row(vec![Pane::Overview, Pane::Tuning, Pane::Instruments]);
    window.app().select(39);
    window.wait("a host that plays", |window| window.has("Playing"));
    window.wait("the parameters of C4", |window| window.has("Undo"));
    window.settle();
    window
}

fn select(window: &mut UserWindow, low: &str, high: &str) {
    let front = |window: &UserWindow, key: &str| {
        window.rect(&format!("key {key}")).center_bottom() - vec2(0.0, 4.0)
    };
    let at = front(window, low);
    window.click_at(at);
    let at = front(window, high);
    window.shift_click_at(at);
}

fn drag(window: &mut UserWindow, name: &str, by: f32) {
    window.wait(name, |window| window.has(name));
    let from = window.rect_of(Role::Slider, name).center();
    window.drag(from, from + vec2(by, 0.0));
}

/// Drags the hammer mass by `by` points; returns the values that play once the host has answered.
fn tune(window: &mut UserWindow, host: &HostProgram, by: f32) -> Vec<Vec<u64>> {
    let before = playing(host);
    drag(window, "hammer mass", by);
    window.wait("the value", |_| playing(host) != before);
    window.wait("the last value", |window| !window.has("…"));
    playing(host)
}

#[test]
fn twenty_drags_are_twenty_undo_steps() {
    let host = HostProgram::start("window-drags", &["--performance", "none"]);
    let mut window = open(&host);
    let before = playing(&host);
    let mut states = vec![before.clone()];
    for i in 0_u16..20 {
        let by = if i % 2 == 0 { 6.0 + f32::from(i) } else { -5.0 };
        states.push(tune(&mut window, &host, by));
    }
    for state in states.iter().rev().skip(1) {
        window.click("Undo");
        window.wait("the value before", |_| playing(&host) == *state);
    }
    assert!(window.is_disabled(Role::Button, "Undo"), "more than twenty steps");
    assert_eq!(playing(&host), before);
}

#[test]
fn undo_takes_an_instrument_back_and_shows_the_keys_that_it_changes() {
    let host = HostProgram::start("window-instrument", &["--performance", "none"]);
    let mut window = open(&host);
    let before = playing(&host);
    let tuned = tune(&mut window, &host, 9.0);
    select(&mut window, "C7", "C8");
    window.click_role(Role::Button, "viennese");
    window.wait("the instrument", |window| window.says("plays C7..C8"));
    window.app().select(39);
    window.settle();
    window.click("Undo");
    window.wait("the instrument before", |_| playing(&host) == tuned);
    window.wait("the changed keys", |window| window.says("C7 ·"));
    window.click("Undo");
    window.wait("the value before", |_| playing(&host) == before);
}

#[test]
fn an_untouched_and_a_graded_instrument_are_saved_as_they_play() {
    let own = folder("window-saving-own");
    for entry in fs::read_dir(&own).expect("a folder").flatten() {
        fs::remove_file(entry.path()).expect("a file of an earlier run");
    }
    let path = own.to_string_lossy();
    let arguments = ["--performance", "none", "--instruments", &*path];
    let host = HostProgram::start("window-saving", &arguments);
    let mut window = open(&host);
    for (name, is_graded) in [("untouched", false), ("graded", true)] {
        if is_graded {
            select(&mut window, "A0", "C8");
            window.click_role(Role::ComboBox, "link");
            window.click("fading change");
            tune(&mut window, &host, 12.0);
        }
        window.click("Save instrument");
        window.click_role(Role::TextInput, "as");
        window.key(Modifiers::COMMAND, Key::A);
        window.type_in(name);
        window.click_role(Role::Button, "Save");
        window.wait("the saved instrument", |window| window.has(name));
        let path = own.join(name).with_extension("toml");
        let saved = Instrument::load(&Library::default(), &path.to_string_lossy());
        let saved = saved.unwrap_or_else(|mistakes| panic!("{mistakes}"));
        let bits = |key| saved.values(key).iter().map(|it| it.to_bits()).collect::<Vec<_>>();
        assert_eq!((0..88).map(bits).collect::<Vec<_>>(), playing(&host), "{name}");
    }
    // It is in the list and plays what was saved; its own name is replaced only by name.
    let tuned = playing(&host);
    select(&mut window, "A0", "C8");
    window.scroll_to(Role::Button, "grand-springs");
    window.click_role(Role::Button, "grand-springs");
    window.wait("the instrument itself", |_| playing(&host) != tuned);
    window.scroll_to(Role::Button, "graded");
    window.click_role(Role::Button, "graded");
    window.wait("the saved one", |_| playing(&host) == tuned);
    window.click("Save instrument");
    window.wait("the question", |window| window.has("Replace graded"));
}

#[test]
fn a_restarted_host_is_offered_the_changes() {
    let mut host = HostProgram::start("window-offer", &["--performance", "none"]);
    let mut window = open(&host);
    let before = playing(&host);
    let tuned = tune(&mut window, &host, 9.0);
    host.kill();
    host.start_again();
    window.wait("the offer", |window| window.says("lack 1 change"));
    assert_eq!(playing(&host), before);
    window.click("Put back");
    window.wait("the change", |_| playing(&host) == tuned);
    window.click("Undo");
    window.wait("the value before", |_| playing(&host) == before);
}

#[test]
fn let_off_moves_by_two_steps_over_the_top_octave_and_no_hammer_blocks() {
    let host = HostProgram::start_scene("window-let-off", "default", &["--performance", "none"]);
    let mut window = open(&host);
    select(&mut window, "C7", "C8");
    window.click_role(Role::ComboBox, "link");
    window.click("same change");
    let reading = |window: &UserWindow| {
        let value = window.value(Role::TextInput, "let-off value");
        value.trim_end_matches(" mm").parse::<f64>().expect("a length in mm")
    };
    window.wait("the let-off", |window| window.has("let-off value"));
    let before = reading(&window);
    // A point of the slider moves less than a step: the field shows each step.
    let from = window.rect_of(Role::Slider, "let-off").center();
    window.press(from);
    let mut at = from;
    while (reading(&window) - before).abs() < 0.19 {
        at.x += 1.0;
        assert!(at.x < from.x + 40.0, "let-off stays at {before} mm");
        window.move_to(at);
        // The field shows the value of the frame before.
        window.settle();
    }
    window.release(at);
    assert!(((reading(&window) - before).abs() - 0.2).abs() < 0.01, "{}", reading(&window));
    window.wait("the values", |window| !window.has("…"));
    window.wait("the figures of both ends", |window| {
        window.says("C7, C8: figures as expected") || window.says("blocks")
    });
    assert!(!window.says("blocks"), "{:?}", window.text_with("blocks"));
    // Each key is pressed slowly, held, and let go: one strike, whatever let-off does.
    for key in (75..=87).step_by(6) {
        let strikes = strikes_of_a_press(&host, key);
        assert!(strikes <= 1, "{strikes} strikes of key {key}");
    }
}

/// Presses a key with 3 N for half a second; returns the strikes meanwhile.
fn strikes_of_a_press(host: &HostProgram, key: u8) -> u64 {
    let strikes = || {
        let Ok(Ok(Reply::Status { status })) = host.ask(&Request::Status {}) else {
            panic!("no status")
        };
        status.run.strikes
    };
    let before = strikes();
    for newtons in [3.0, 0.0] {
        let pressed = host.ask(&Request::Press { key, newtons });
        assert!(matches!(pressed, Ok(Ok(_))), "{pressed:?}");
        std::thread::park_timeout(std::time::Duration::from_millis(800));
    }
    strikes() - before
}
