//! Our own part of a frame: the panels drawn and cut into triangles, without a graphics card.
//!
//! `cargo run --release -p dashboard --example frame_cost`: 88 keys and 8 scopes, each with 2,000
//! points of three channels, in a window of 1280 × 800.

#![forbid(unsafe_code)]

use std::{sync::Arc, time::Instant};

use dashboard::{App, Pane, demonstration};
use eframe::egui;
use telemetry::{KeyBlock, Overview, Update, recording::OpenError};

/// Measured frames, after some to warm up.
const FRAMES: usize = 400;
const WARM: usize = 50;

const KEY: u32 = 39;

fn main() -> Result<(), OpenError> {
    let take = demonstration(Box::new(|| 0.0))?;
    let ctx = egui::Context::default();
    let mut app = App::new(Box::new(take), Arc::new(|| 0), None, &ctx);
    let mut panes = vec![Pane::Overview];
    panes.extend((0..8).map(Pane::Scope));
    app.show_grid(panes);
    frame(&ctx, &mut app, 0);
    for chunk in 0..65 {
        feed(&mut app, chunk);
    }
    let mut costs: Vec<[f64; 2]> = (0..WARM + FRAMES)
        .map(|i| {
            feed(&mut app, 65 + i as u64);
            frame(&ctx, &mut app, i)
        })
        .skip(WARM)
        .collect();
    let mut both: Vec<f64> = costs.iter().map(|[draw, cut]| draw + cut).collect();
    both.sort_by(f64::total_cmp);
    let at = |share: usize| both[both.len() * share / 100];
    costs.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let draw = costs[costs.len() / 2][0];
    #[expect(clippy::print_stdout, reason = "this is what it is for")]
    {
        println!("88 keys and 8 scopes of 2,000 points, 1280 x 800, {FRAMES} frames");
        println!("our own part of a frame: median {:.2} ms, p95 {:.2} ms", at(50), at(95));
        println!("of which panels {draw:.2} ms, the rest triangles");
    }
    Ok(())
}

/// Draws one frame; returns the times of panels and triangles (ms).
fn frame(ctx: &egui::Context, app: &mut App, i: usize) -> [f64; 2] {
    let size = egui::vec2(1280.0, 800.0);
    let input = egui::RawInput {
        screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, size)),
        time: Some(i as f64 / 60.0),
        ..egui::RawInput::default()
    };
    let began = Instant::now();
    let mut output = ctx.run_ui(input, |ui| app.draw(ui));
    let drawn = began.elapsed().as_secs_f64() * 1e3;
    let primitives = ctx.tessellate(std::mem::take(&mut output.shapes), 1.0);
    let all = began.elapsed().as_secs_f64() * 1e3;
    assert!(!primitives.is_empty(), "something is drawn");
    output.textures_delta.clear();
    [drawn, all - drawn]
}

fn feed(app: &mut App, chunk: u64) {
    let from = chunk * 32;
    let wave = |tick: u64, period: f64| (tick as f64 / period).sin();
    let ticks = from..from + 32;
    let column = |f: &dyn Fn(u64) -> f64| ticks.clone().map(f).collect::<Vec<f64>>();
    let signals =
        ticks.clone().flat_map(|tick| (0..8).map(move |i| (tick as f32 / (9.0 + i as f32)).sin()));
    let block = KeyBlock {
        key: KEY,
        tick: from,
        after: (0..32).collect(),
        position: column(&|tick| 5e-3 + 4e-3 * wave(tick, 40.0)),
        force: column(&|tick| 2.0 + wave(tick, 7.0)),
        sent: column(&|tick| 2.0 + wave(tick, 7.0)),
        mode: ticks.clone().map(|tick| u8::from(tick % 200 < 100)).collect(),
        signals: signals.collect(),
        ..KeyBlock::default()
    };
    app.take(from, Update::Block(block));
    let keys = |f: &dyn Fn(u32) -> f32| (0..88).map(f).collect::<Vec<f32>>();
    let phase = from as f32 / 50.0;
    app.take(
        from,
        Update::Overview(Overview {
            tick: from + 32,
            ticks: 32,
            position_min: vec![0.0; 88],
            position_max: keys(&|key| 5e-3 + 4e-3 * (phase + key as f32).sin()),
            force_min: vec![0.0; 88],
            force_max: keys(&|key| 3.0 + 2.0 * (phase + key as f32).cos()),
            mode: vec![0; 88],
            flags: vec![0; 88],
            fault: vec![0; 88],
            dropped: 0,
        }),
    );
}
