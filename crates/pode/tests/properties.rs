//! Properties of every ball, not only of those with known digits.

use pode::stepper::Rk4;
use pode::{Advance, Energetic, EnergyAudit, GuardSpec, GuardValue, Limits, RunRecorder};
use proptest::prelude::*;

use crate::common::{Ball, G, ON_CROSSING, OneMode, close, no_input};

const A: GuardSpec = GuardSpec::new(0, "a");
const B: GuardSpec = GuardSpec::new(1, "b");
const C: GuardSpec = GuardSpec::new(2, "c");
static ORDERS: [[GuardSpec; 3]; 6] =
    [[A, B, C], [A, C, B], [B, A, C], [B, C, A], [C, A, B], [C, B, A]];

fn balls(guards: &'static [GuardSpec], restitution: f64) -> OneMode<f64, 6> {
    OneMode {
        readout: |_, x| x[0] + x[1] + x[2],
        guards,
        guard: |_, id, x| GuardValue::new(x[usize::from(id.0)], x[usize::from(id.0) + 3]),
        reset: |restitution, id, x| {
            let (ball, mut after) = (usize::from(id.0), *x);
            (after[ball], after[ball + 3]) = (0.0, -restitution * x[ball + 3]);
            after
        },
        ..OneMode::new(restitution, |_, x| [x[3], x[4], x[5], -G, -G, -G])
    }
}

fn bits(guards: &'static [GuardSpec], heights: [f64; 3], e: f64, h: f64) -> Vec<u64> {
    let [a, b, c] = heights;
    let mut balls = balls(guards, e).start(Rk4, [a, b, c, 0.0, 0.0, 0.0]);
    let mut recorder = RunRecorder::new(h);
    let readouts: Vec<u64> = (0..500)
        .map(|_| balls.advance(h, &no_input, &mut recorder).mean_readout.to_bits())
        .collect();
    let events = recorder.events().iter().flat_map(|it| it.after.map(f64::to_bits));
    readouts.into_iter().chain(events).chain(balls.state().map(f64::to_bits)).collect()
}

impl Energetic for Ball {
    fn energy(&self, _: crate::common::BallMode, x: &[f64; 2], (): &()) -> f64 {
        self.mass * (G * x[0] + 0.5 * x[1] * x[1])
    }

    fn supplied(&self, _: crate::common::BallMode, _: &[f64; 2], (): &()) -> f64 {
        0.0
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_order_of_the_guards_never_matters(
        heights in prop::array::uniform3(0.1..3.0),
        together in any::<bool>(),
        e in 0.5..1.0,
        h in 1e-4..7e-3,
    ) {
        let heights = if together { [heights[0]; 3] } else { heights };
        let first = bits(&ORDERS[0], heights, e, h);
        for order in &ORDERS[1..] {
            prop_assert!(first == bits(order, heights, e, h), "{heights:?}, e {e}, h {h}");
        }
    }

    #[test]
    fn how_ticks_cut_the_time_does_not_matter(
        height in 0.1..3.0,
        e in 0.5..0.95,
        h in 1e-3..7e-3,
        parts in 2_u32..12,
    ) {
        let events = |h: f64, ticks: u32| {
            let mut ball = Ball::dropped(e, height, Limits::default());
            let mut recorder = RunRecorder::new(h);
            for _ in 0..ticks {
                let _ = ball.advance(h, &no_input, &mut recorder);
            }
            recorder.events().to_vec()
        };
        let whole = events(h, 300);
        let cut = events(h / f64::from(parts), 300 * parts);
        // Up to the first ten: one of the two may take later ones in one move.
        for (n, (a, b)) in whole.iter().zip(&cut).take(10).enumerate() {
            if a.name != "floor" || b.name != "floor" {
                break;
            }
            // A parabola is followed exactly: each of some 3600 sums rounds the height by 2e-16, at
            // a speed of 0.5 m/s at least.
            let speed = a.before[1].abs();
            close(format_args!("impact {n}"), a.t, b.t, 3600.0 * 4.5e-16 * height.max(1.0) / speed);
        }
    }

    #[test]
    fn impacts_never_add_energy(height in 0.01..5.0, e in 0.0..1.0, h in 1e-4..7e-3) {
        let mut ball = Ball::dropped(e, height, Limits::default());
        for _ in 0..500 {
            let mut audit = EnergyAudit::default();
            let tick = ball.advance(h, &no_input, &mut audit);
            prop_assert_eq!(tick.advance, Advance::Completed);
            prop_assert!(audit.jumps <= 0.0, "an impact added {} J", audit.jumps);
            // Flight conserves: what is left is the rounding of one tick.
            let rounding = 1e-14 * G * height;
            prop_assert!(audit.integration.abs() <= rounding, "{:e} J", audit.integration);
        }
    }

    #[test]
    fn a_wave_fires_once_per_fall(omega in 1.0..400.0, h in 1e-4..7e-3) {
        // ω h stays below 3: one fall per step at most, at every place of the step.
        let wave = OneMode {
            guards: &ON_CROSSING,
            guard: |omega: &f64, _, x| {
                let (sin, cos) = (omega * x[0]).sin_cos();
                GuardValue::new(cos, -omega * sin)
            },
            ..OneMode::new(omega, |_, _| [1.0])
        };
        let mut wave = wave.start(Rk4, [0.0]);
        let mut recorder = RunRecorder::new(h);
        for _ in 0..400 {
            let _ = wave.advance(h, &no_input, &mut recorder);
        }
        let turns = 400.0 * h * omega / std::f64::consts::TAU;
        let falls = (0_u32..1000).take_while(|n| f64::from(*n) + 0.25 <= turns).count();
        prop_assert_eq!(recorder.events().len(), falls);
    }
}
