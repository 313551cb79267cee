//! Common parts of all benches: short measurements, and the machine.
#![allow(dead_code, unreachable_pub, reason = "each bench uses its own part")]

use std::f64::consts::TAU;
use std::fs;
use std::hint::black_box;
use std::time::Duration;

use criterion::Criterion;

/// Short measurements: all benches together take a minute or two; prints machine and kernel.
#[expect(clippy::print_stderr, reason = "a bench reports to people")]
pub fn criterion() -> Criterion {
    eprintln!("machine: {}", machine());
    let mut criterion = Criterion::default()
        .without_plots()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_millis(1500))
        .configure_from_args();
    calibrate(&mut criterion);
    criterion
}

/// Measures a loop that no change of ours makes slower: `cargo xtask bench` keeps the others as
/// multiples of it, so that machines can differ. It mixes dependent arithmetic, divisions and
/// dependent reads about like a voice.
fn calibrate(criterion: &mut Criterion) {
    let table: Vec<f64> = (0..4096).map(|n| 1.0 + f64::from(n * 2654 % 4096) / 4096.0).collect();
    criterion.bench_function("calibration", |bencher| {
        bencher.iter(|| {
            let (mut sum, mut place) = (black_box(1.0_f64), black_box(1_usize));
            for _ in 0..1000 {
                let read = table[place];
                sum = (sum * 0.75 + read).sqrt() + read / (1.0 + sum);
                place = (place * 5 + usize::from(sum < 2.0)) % table.len();
            }
            sum
        });
    });
}

fn machine() -> String {
    let processors = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let names: Vec<_> = processors
        .lines()
        .filter_map(|line| line.strip_prefix("model name")?.split_once(": "))
        .map(|(_, name)| name)
        .collect();
    let kernel = fs::read_to_string("/proc/sys/kernel/osrelease").unwrap_or_default();
    let name = names.first().unwrap_or(&"unknown");
    format!("{} x {name}, kernel {}", names.len(), kernel.trim())
}

/// Period of a motion in ticks.
pub const TICKS: usize = 512;

/// Key positions (m) of one slow swing between 1 and 4 mm, `phase` of it ahead, in steps of
/// `quantum` (m): so slow that a hammer stays on its key and no event occurs.
pub fn swing(phase: f64, quantum: f64) -> [f64; TICKS] {
    swing_between((1e-3, 4e-3), 1, phase, quantum)
}

/// Key positions (m) of several swings between two of them.
pub fn swing_between(
    (least, most): (f64, f64),
    swings: usize,
    phase: f64,
    quantum: f64,
) -> [f64; TICKS] {
    std::array::from_fn(|tick| {
        let angle = TAU * ((swings * tick) as f64 / TICKS as f64 + phase);
        let position = 0.5 * (least + most) - 0.5 * (most - least) * angle.cos();
        (position / quantum).round() * quantum
    })
}
