//! Machine beside the keys: ticks, deadlines, links. Chance comes from a counter, so that each
//! run is the same.

use telemetry::{Board, Deadlines, Line, Links, Spread, Ticks};

/// Returns a number in 0..1 that looks like chance and is always the same for `n`.
fn chance(n: u64) -> f64 {
    let mut x = n.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x5DEE_CE66;
    x = (x ^ (x >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((x ^ (x >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

fn outcome(tick: u64) -> u8 {
    match tick % 4001 {
        1900 => 1,
        2600 => 2,
        3300 => 3,
        _ => 0,
    }
}

/// Returns when the ticks `from..to` were done.
pub(super) fn ticks(from: u64, to: u64) -> Ticks {
    let late = |tick: u64| 8.0 + 14.0 * chance(tick) + if outcome(tick) == 1 { 900.0 } else { 0.0 };
    let work =
        |tick: u64| 90.0 + 40.0 * chance(tick + 7) + if outcome(tick) == 3 { 950.0 } else { 0.0 };
    let pause = |tick: u64| if outcome(tick) == 2 { 990.0 } else { 6.0 };
    let float = crate::number::f32;
    Ticks {
        tick: from,
        after: (0..u32::try_from(to - from).unwrap_or(0)).collect(),
        lateness: (from..to).map(|tick| float(late(tick))).collect(),
        turnaround: (from..to).map(|tick| float(work(tick) + pause(tick))).collect(),
        work: (from..to).map(|tick| float(work(tick))).collect(),
        outcome: (from..to).map(outcome).collect(),
        evaluations: (from..to).map(|tick| 800 + u32::try_from(tick % 97).unwrap_or(0)).collect(),
    }
}

fn spread(middle: f64, width: f64, ticks: u64) -> Spread {
    let edge: Vec<f64> = (1..=24).map(|i| f64::from(i) * width).collect();
    let share = |edge: &f64| {
        let off = (edge - middle) / (2.0 * width);
        (-0.5 * off * off).exp() + 2e-4 * (-(edge - middle).abs() / (6.0 * width)).exp()
    };
    let sum: f64 = edge.iter().map(share).sum();
    let count =
        edge.iter().map(|it| crate::number::floor(share(it) / sum * ticks as f64)).collect();
    let (p99, p999) = (middle + 4.5 * width, middle + 7.0 * width);
    Spread { p50: middle, p99, p999, max: middle + 16.0 * width, edge, count }
}

/// Returns the distributions of the ticks so far.
pub(super) fn deadlines(ticks: u64) -> Deadlines {
    let passed = |at: u64| ticks / 4001 + u64::from(at < ticks % 4001);
    let (woken_late, preempted, own_work) = (passed(1900), passed(2600), passed(3300));
    Deadlines {
        ticks,
        missed: woken_late + preempted + own_work,
        own_work,
        woken_late,
        preempted,
        skipped: 0,
        lateness: Some(spread(15.0, 4.0, ticks)),
        turnaround: Some(spread(116.0, 12.0, ticks)),
        work: Some(spread(110.0, 12.0, ticks)),
        baseline: Some(spread(12.0, 4.0, ticks)),
    }
}

/// Boards and links after so many ticks.
pub(super) fn links(ticks: u64) -> Links {
    let line = |name: &str, planned: f64, state: &str| Line {
        name: name.into(),
        planned,
        seen: planned * (0.97 + 0.05 * chance(ticks)),
        corrupt: ticks / 9000,
        state: state.into(),
        ..Line::default()
    };
    let board = |i: u32| Board {
        line: i / 4,
        id: i,
        first_key: 11 * i,
        keys: 11,
        samples: ticks,
        gaps: if i == 5 { ticks / 700 } else { 0 },
        armings: if i == 5 { 2 } else { 1 },
        round_trip: 180.0 + 20.0 * chance(ticks + u64::from(i)),
        state: if i == 5 { "armed; its cable loses frames".into() } else { "armed".into() },
        ..Board::default()
    };
    // A USB device takes any rate, so its load is unknown.
    Links {
        lines: vec![line("can0", 0.62, "active"), line("/dev/ttyACM0", f64::NAN, "active")],
        boards: (0..8).map(board).collect(),
    }
}
