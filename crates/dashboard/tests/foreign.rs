//! Senseless messages do not stop the window.

#![expect(clippy::cast_possible_truncation, reason = "what is too large becomes infinite")]

use dashboard::{App, Pane};
use eframe::egui::{self, Theme};
use telemetry::{
    Board, Body, Coil, Deadlines, Drawing, Event, Follower, KeyBlock, Line, Links, Midi, Outline,
    Overview, Spread, Status, Ticks, Update, Voice,
};

use crate::common::{Behind, TestClock, snapshot::Canvas, source};

const KEY: u32 = 39;

const ODD: [f64; 4] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300];

fn block(odd: f64, tick: u64) -> Update {
    let float = odd as f32;
    Update::Block(KeyBlock {
        key: KEY,
        tick,
        after: vec![0, 1, 2, u32::MAX],
        position: vec![odd, 0.0, odd],
        force: vec![odd; 5],
        sent: vec![0.0, odd, 1.0, odd],
        mode: vec![0, 255, 7, 1],
        signals: vec![float; 32],
        ..KeyBlock::default()
    })
}

fn voice(odd: f64) -> Update {
    let follower = |signal: &str| Some(Follower { offset: odd, scale: odd, signal: signal.into() });
    let outline = Outline { x: vec![odd, 0.0, 1.0], y: vec![0.0, odd], ..Outline::default() };
    let body = Body {
        x: follower("position"),
        angle: follower("nothing"),
        outlines: vec![outline],
        ..Body::default()
    };
    let coil = Coil { from: 0, to: 9, from_x: odd, ..Coil::default() };
    let drawing = Drawing {
        left: 0.0,
        bottom: odd,
        right: odd,
        top: 1.0,
        bodies: vec![body],
        coils: vec![coil],
    };
    Update::Voice(Voice {
        key: KEY,
        revision: 9,
        model: "key-hammer-springs".into(),
        values: vec![odd; 3],
        drawing: Some(drawing),
        ..Voice::default()
    })
}

fn overview(odd: f64) -> Update {
    let float = odd as f32;
    Update::Overview(Overview {
        tick: 2_000,
        position_max: vec![float; 7],
        force_min: vec![float; 88],
        force_max: vec![float; 100],
        mode: vec![200; 88],
        fault: vec![99; 88],
        ..Overview::default()
    })
}

fn machine(odd: f64) -> Vec<Update> {
    let spread = Spread {
        p50: odd,
        p99: odd,
        edge: vec![odd, 1.0, -1.0],
        count: vec![1, u64::MAX],
        ..Spread::default()
    };
    let line = Line { planned: odd, seen: odd, ..Line::default() };
    vec![
        Update::Ticks(Ticks {
            tick: u64::MAX,
            after: vec![0, 9, 9],
            lateness: vec![odd as f32; 2],
            outcome: vec![250; 9],
            ..Ticks::default()
        }),
        Update::Deadlines(Deadlines { turnaround: Some(spread), ..Deadlines::default() }),
        Update::Links(Links { lines: vec![line], ..Links::default() }),
        Update::Event(Event { kind: 5, theta: odd, key: 4000, speed: odd, ..Event::default() }),
        Update::Event(Event { kind: 77, tick: u64::MAX, key: KEY, ..Event::default() }),
        Update::Status(Status {
            state: 99,
            boards: vec![Board { line: 7, first_key: 80, keys: u32::MAX, ..Board::default() }],
            muted: vec![88, u32::MAX],
            absent: vec![u32::MAX, 87],
            ..Status::default()
        }),
        Update::Midi(Midi { at: odd, bytes: vec![0; 3], ..Midi::default() }),
    ]
}

#[test]
fn messages_that_make_no_sense_do_not_stop_the_window() {
    for odd in ODD {
        let time = TestClock::default();
        let (source, _) = source(&time, Behind::Live);
        let mut canvas = Canvas::new([900, 600], Theme::Dark, |ctx: &egui::Context| {
            App::new(source, time.clock(), None, ctx)
        });
        canvas.play(&time, 1.0);
        for update in [block(odd, 2_000), overview(odd), voice(odd)] {
            canvas.app().take(u64::MAX, update);
        }
        for update in machine(odd) {
            canvas.app().take(0, update);
        }
        canvas.app().take(0, block(odd, u64::MAX - 1));
        for pane in Pane::ALL {
            canvas.app().show_only(*pane);
            assert!(!canvas.step(Vec::new()).is_empty() && !canvas.step(Vec::new()).is_empty());
        }
    }
}
