//! Scopes and the time line, as a user sees and uses them.

use std::{path::Path, time::Duration};

use dashboard::{App, Pane, demonstration};
use eframe::egui::epaint::ColorMode;
use eframe::egui::{
    Color32, Context, Event, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, Shape,
    TouchPhase, ViewportId, vec2,
};
use egui_kittest::{Harness, kittest::Queryable as _};
use telemetry::recording::{Playback, Recording, marks};
use telemetry::{Catalogue, KeyBlock, Model, Signal, Update, Voice, event::Kind, signal};

use crate::common::{Behind, TestClock, TestWindow, open, open_with};

/// Colour of the second curve of a plot on dark ground.
const ORANGE: Color32 = Color32::from_rgb(0xE6, 0x9F, 0x00);

#[expect(clippy::large_stack_frames, reason = "a window, once")]
fn torn() -> TestWindow {
    let mut window = open_with(Behind::Live, None, |app| app.show_only(Pane::Scope(0)));
    window.settle();
    let kind = signal::Kind::Guard.into();
    let guard = Signal { name: "trip".into(), kind, ..Signal::default() };
    let model = Model { name: "torn".into(), signals: vec![guard], ..Model::default() };
    let catalogue = Catalogue { models: vec![model], tick_hz: 1000, ..Catalogue::default() };
    let voice = Voice { key: 39, model: "torn".into(), ..Voice::default() };
    let value = |tick: u16| if (700..1300).contains(&tick) { f32::NAN } else { f32::from(tick) };
    let block = KeyBlock {
        key: 39,
        after: (0..2000).collect(),
        position: vec![0.001; 2000],
        force: vec![1.0; 2000],
        sent: vec![1.0; 2000],
        mode: vec![0; 2000],
        flags: vec![0; 2000],
        signals: (0..2000).map(value).collect(),
        ..KeyBlock::default()
    };
    let app = window.harness.state_mut();
    for update in [Update::Catalogue(catalogue), Update::Voice(voice), Update::Block(block)] {
        app.take(0, update);
    }
    window.settle();
    window
}

fn ends(shape: &Shape, color: Color32, found: &mut Vec<(f32, f32)>) {
    if let Shape::Vec(shapes) = shape {
        for shape in shapes {
            ends(shape, color, found);
        }
    } else if let Shape::Path(path) = shape
        && path.stroke.color == ColorMode::Solid(color)
    {
        let x = path.points.iter().map(|point| point.x);
        found.push((x.clone().fold(f32::MAX, f32::min), x.fold(f32::MIN, f32::max)));
    }
}

#[test]
fn nothing_is_drawn_through_times_without_values() {
    let mut window = torn();
    window.click("Cursors");
    let mut found = Vec::new();
    for clipped in &window.harness.output().shapes {
        ends(&clipped.shape, ORANGE, &mut found);
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let [before, after] = &found[..] else { panic!("{found:?}") };
    // The cursors are at the thirds of the window of two seconds.
    let [a, b] = ["A", "B"].map(|it| window.rect(&format!("cursor {it} in plot 1")).center().x);
    let second = (b - a) * 1.5;
    let missing = after.0 - before.1;
    assert!((missing / second - 0.601).abs() < 0.01, "{missing} points of {second}");
    assert!(window.has("cursor A in plot 2"));
}

#[track_caller]
fn check_edges(window: &TestWindow) {
    for cursor in ["A", "B"] {
        let x = [1, 2].map(|i| window.rect(&format!("cursor {cursor} in plot {i}")).center().x);
        assert!((x[0] - x[1]).abs() < 0.01, "{x:?}");
    }
}

#[test]
fn all_plots_have_one_left_edge() {
    let mut window = open(Pane::Scope(0), Behind::Live);
    window.click("Cursors");
    for size in [[900.0, 640.0], [640.0, 420.0], [800.0, 600.0], [1440.0, 900.0]] {
        window.harness.set_size(size.into());
        window.settle();
        check_edges(&window);
    }
    // A zoom to long labels in one plot only.
    for _ in 0..12 {
        let axis = window.rect("y axis of plot 1").center();
        window.drag(axis, axis - vec2(0.0, 100.0), PointerButton::Primary);
        check_edges(&window);
    }
    assert!(window.number("y axis of plot 1") < 1e-3 * window.number("y axis of plot 2"));
}

#[test]
fn a_key_at_rest_does_not_fill_the_plot_with_its_noise() {
    let mut window = open_with(Behind::Live, None, |app| app.show_only(Pane::Scope(0)));
    window.play(0.5);
    assert!(0.5 <= window.number("y axis of plot 1"), "{}", window.number("y axis of plot 1"));
    assert!(0.1 <= window.number("y axis of plot 2"), "{}", window.number("y axis of plot 2"));
}

#[test]
fn the_last_channel_is_reached_with_the_wheel_in_a_low_window() {
    let mut window = torn();
    let signal = |i: u32| Signal { name: format!("signal {i}"), ..Signal::default() };
    let signals = (0..40).map(signal).collect();
    let model = Model { name: "torn".into(), signals, ..Model::default() };
    let catalogue = Catalogue { models: vec![model], tick_hz: 1000, ..Catalogue::default() };
    window.harness.state_mut().take(0, Update::Catalogue(catalogue));
    window.harness.set_size(vec2(800.0, 600.0));
    window.settle();
    window.click("Channels");
    assert!(window.has("new plot") && window.has("travel of the key's front"));
    let pointer = window.rect("position in plot 2").center();
    window.harness.event(Event::PointerMoved(pointer));
    for _ in 0..60 {
        window.harness.event(Event::MouseWheel {
            unit: MouseWheelUnit::Point,
            delta: vec2(0.0, -60.0),
            modifiers: eframe::egui::Modifiers::NONE,
            phase: TouchPhase::Move,
            source: MouseWheelSource::Wheel,
        });
        window.harness.step();
    }
    let last = window.rect("signal 39 in plot 3");
    assert!(last.bottom() < 600.0 && last.right() < 800.0, "{last:?}");
    click_at(&mut window, last.center());
    // The menu covers no button above it.
    window.click("Cursors");
    assert!(window.has("cursor A in plot 3") && !window.has("new plot"));
}

fn click_at(window: &mut TestWindow, at: Pos2) {
    window.press_at(at);
    window.harness.drop_at(at);
    window.settle();
}

#[test]
fn all_strikes_of_the_take_are_marks() {
    let take = demonstration(Box::new(|| 0.0)).expect("a take of this version");
    let is_strike =
        |update: &Update| matches!(update, Update::Event(event) if event.kind() == Kind::Strike);
    let messages = take.recording().messages().filter_map(Result::ok);
    let strikes = messages.filter(|(_, update)| is_strike(update)).count();
    let listed = marks(take.recording()).filter(|mark| mark.text.ends_with(" struck")).count();
    assert_eq!(listed, strikes);
    assert!(1 < strikes, "{strikes}");
}

fn draws_on(window: &TestWindow) -> bool {
    window.harness.output().viewport_output[&ViewportId::ROOT].repaint_delay < Duration::MAX
}

#[test]
fn a_scope_shows_the_rows_before_the_position_after_a_seek() {
    let mut window = open_with(Behind::Recording, None, |app| app.show_only(Pane::Timeline));
    window.play(4.0);
    window.click("Pause");
    for share in [0.9, 0.5, 0.7] {
        let line = window.rect("time line");
        click_at(&mut window, line.left_center() + vec2(line.width() * share, 0.0));
        // The rows of a key come a frame after the scope wants them, without any waker.
        window.harness.state_mut().show_only(Pane::Scope(0));
        window.harness.event(Event::PointerMoved(Pos2::new(500.0, 300.0)));
        window.harness.step();
        assert!(draws_on(&window));
        window.harness.run_steps(20);
        assert!(!draws_on(&window));
        assert!(!window.says("Nothing has moved"), "at {share}");
        assert!(window.has("y axis of plot 1") && window.is_on("Follow"), "at {share}");
        window.drag(Pos2::new(500.0, 300.0), Pos2::new(800.0, 300.0), PointerButton::Primary);
        assert!(!window.is_on("Follow"));
        window.harness.state_mut().show_only(Pane::Timeline);
        window.settle();
    }
}

#[test]
fn a_recording_at_its_end_is_played_again() {
    let time = TestClock::default();
    let clock = time.clock();
    let seconds = Box::new(move || clock() as f64 * 1e-9);
    let take = concat!(env!("CARGO_MANIFEST_DIR"), "/demonstration/demonstration.mcap");
    let recording = Recording::open(Path::new(take)).expect("a take of this version");
    let source = Box::new(Playback::new(recording, seconds));
    let mut app = App::new(source, time.clock(), None, &Context::default());
    app.show_only(Pane::Timeline);
    let mut harness = Harness::builder().build_ui_state(|ui, app: &mut App| app.draw(ui), app);
    harness.run_steps(2);
    assert!(harness.query_by_label("Pause").is_some());
    time.set(60.0);
    harness.run_steps(2);
    assert!(harness.query_by_label("Pause").is_none());
    harness.get_by_label("Play").click();
    harness.run_steps(4);
    assert!(harness.query_by_label("Pause").is_some());
    assert!(harness.query_by_label_contains("0.000 s of 4.5 s").is_some());
}
