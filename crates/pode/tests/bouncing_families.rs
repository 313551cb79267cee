//! Case C1 and its family: a ball of any restitution and height, whose bounces accumulate (Zeno).
//!
//! Flights are parabolas, which RK4 and its dense output follow exactly: what is left is rounding,
//! of each step's sum and of the time at the speed of the impact.

use pode::{Limits, Piece, Signal, Silent, Watch};
use proptest::prelude::*;

use crate::common::{
    Ball, BallMode, G, STEPS, all_completed, close, each_step_and_phase, no_input, run,
};

#[derive(Debug)]
struct Lowest(f64);

impl Watch<Ball> for Lowest {
    fn piece<S: Signal<()>>(&mut self, _: &Ball, piece: &Piece<'_, Ball, S>) {
        for part in 0..=16_u8 {
            self.0 = self.0.min(piece.at(f64::from(part) / 16.0).0[0]);
        }
    }
}

#[test]
fn c1_the_ball_is_never_below_its_floor_not_even_between_ticks() {
    for e in [0.5, 0.8, 0.9] {
        for h in STEPS {
            let mut ball = Ball::dropped(e, 1.0, Limits::default());
            let mut lowest = Lowest(1.0);
            while ball.mode() == BallMode::Flight {
                let _ = ball.advance(h, &no_input, &mut lowest);
            }
            // Rounding of 1 m.
            assert!(lowest.0 > -2e-15, "e {e}, h {h}: {:e}", lowest.0);
        }
    }
}

#[test]
fn c1_an_elastic_ball_keeps_its_energy_at_every_step() {
    for (h, most) in [(7e-3, 100_000), (1e-3, 10_000), (1e-4, 1000)] {
        let mut ball = Ball::dropped(1.0, 1.0, Limits::default());
        let mut bounces = 0;
        while bounces < most {
            bounces += ball.advance(h, &no_input, &mut Silent).work.events;
        }
        let [y, v] = *ball.state();
        let drift = (y * G + 0.5 * v * v) / G - 1.0;
        let limit = 1e-10 * f64::from(most) / 1e5;
        assert!(drift.abs() < limit, "h {h}: relative drift {drift:e}, over {limit:e}");
    }
}

#[test]
fn a_ball_that_does_not_bounce_at_all_rests_at_once() {
    each_step_and_phase(|h, phase| {
        let mut ball = Ball::dropped(0.0, 1.0, Limits::default());
        let (recorder, ticks) = run(&mut ball, h, phase, 0.6);
        all_completed(&ticks);
        assert_eq!(ball.mode(), BallMode::Rest, "h {h}, phase {phase}");
        let fall = (2.0 / G).sqrt();
        close("rest", recorder.events()[recorder.events().len() - 1].t, fall, 1e-12);
        let impulse: f64 = ticks.iter().map(|tick| tick.impulse).sum();
        close("impulse", impulse, (2.0 * G).sqrt(), 1e-12);
    });
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_ball_bounces_and_rests_at_the_times_of_its_closed_form(
        e in 0.05..0.95_f64,
        height in 0.05..2.0_f64,
        h in prop_oneof![Just(1e-4), Just(1e-3), Just(7e-3), 1e-4..7e-3],
        phase in prop_oneof![Just(0.0), Just(1.0 / 3.0), Just(0.999)],
    ) {
        let first = (2.0 * height / G).sqrt();
        let rest = first * (1.0 + e) / (1.0 - e);
        let mut ball = Ball::dropped(e, height, Limits::default());
        let (recorder, ticks) = run(&mut ball, h, phase, rest + 0.05);
        all_completed(&ticks);
        for (n, seen) in (1..).zip(recorder.events()).take(10) {
            if seen.name != "floor" {
                break;
            }
            let expected = first * (1.0 + 2.0 * e * (1.0 - e.powi(n - 1)) / (1.0 - e));
            // The sums round the height by some 1e-15, which the speed makes a time.
            let speed = G * first * e.powi(n - 1);
            close(format_args!("bounce {n} of {}", recorder.events().len()), seen.t, expected, 1e-12 + 1e-14 / speed);
        }
        let last = &recorder.events()[recorder.events().len() - 1];
        prop_assert_eq!((last.name, ball.mode()), ("settled", BallMode::Rest));
        prop_assert_eq!(ball.state().map(f64::to_bits), [0, 0], "at rest on the floor");
        close("weight", ticks[ticks.len() - 1].mean_readout, G, 1e-15 * G);
        close("rest", last.t, rest, 1e-9);
        let impulse: f64 = ticks.iter().map(|tick| tick.impulse).sum();
        let expected = G * first * (1.0 + e) / (1.0 - e);
        close("impulse", impulse, expected, 1e-9 * expected);
    }
}
