//! Switches at random against an event machine in closed form.
//!
//! The rates are lines in the time, so x is a parabola on each side: the reference solves
//! successive quadratics, without any step.

use pode::contacts::ContactState::{self, SlideDown, SlideUp, Stick};
use pode::{Advance, Limits};
use proptest::prelude::*;

use crate::common::two_sided::{TwoSided as _, side, start, states};
use crate::driven::{Clock, run_driven};
use crate::sliding::Fields;

fn line([a, b]: [f64; 2]) -> [f64; 4] {
    [a, b, 0.0, 0.0]
}

fn first_root([c0, c1, c2]: [f64; 3], from: f64) -> Option<f64> {
    let roots = if c2 == 0.0 {
        [-c0 / c1, f64::NAN]
    } else {
        let d = (c1 * c1 - 4.0 * c0 * c2).sqrt();
        let q = -0.5 * (c1 + d.copysign(c1));
        [q / c2, c0 / q]
    };
    roots.into_iter().filter(|t| *t > from).min_by(f64::total_cmp)
}

#[derive(Clone, Copy, Debug)]
struct Epoch {
    from: f64,
    mode: ContactState,
    /// Smallest rate in the decision for it.
    margin: f64,
}

fn rate([a, b]: [f64; 2], t: f64) -> f64 {
    a + b * t
}

fn reference(lines: &Fields, x: f64, until: f64) -> Vec<Epoch> {
    let [up, down] = [lines.above, lines.below].map(|[a, b, ..]| [a - lines.drift, b]);
    let begin = if x > 0.0 { SlideUp } else { SlideDown };
    let mut epochs = vec![Epoch { from: 0.0, mode: begin, margin: 1.0 }];
    let mut height = x;
    while let Some(&Epoch { from, mode, .. }) = epochs.last() {
        let ahead = from + 1e-7;
        let next = if mode == Stick {
            let exits = [up, down].map(|line| first_root([line[0], line[1], 0.0], ahead));
            let ends = exits.map(|t| t.unwrap_or(f64::INFINITY));
            let (t, mode) =
                if ends[0] < ends[1] { (ends[0], SlideUp) } else { (ends[1], SlideDown) };
            t.is_finite().then(|| Epoch { from: t, mode, margin: (ends[0] - ends[1]).abs() })
        } else {
            let [a, b] = if mode == SlideUp { up } else { down };
            let at_zero = height - a * from - 0.5 * b * from * from;
            first_root([at_zero, a, 0.5 * b], ahead).map(|t| meet(up, down, t))
        };
        height = 0.0;
        match next {
            Some(epoch) if epoch.from < until => epochs.push(epoch),
            _ => return epochs,
        }
    }
    epochs
}

fn meet(up: [f64; 2], down: [f64; 2], t: f64) -> Epoch {
    let [above, below] = [rate(up, t), rate(down, t)];
    let mode = match (above < 0.0, below > 0.0) {
        (true, true) => Stick,
        (true, false) => SlideDown,
        (false, _) => SlideUp,
    };
    Epoch { from: t, mode, margin: above.abs().min(below.abs()) }
}

prop_compose! {
    fn lines()(
        above in prop::array::uniform2(-2.0..2.0),
        below in prop::array::uniform2(-2.0..2.0),
        drift in prop_oneof![Just(0.0), -1.0..1.0],
        exponent in -3..1_i32,
    ) -> Fields {
        Fields { above: line(above), below: line(below), drift, size: 10_f64.powi(exponent) }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn modes_and_times_are_those_of_the_closed_form(
        lines in lines(),
        x in prop_oneof![-1.0..-0.01, 0.01..1.0],
        h in prop_oneof![Just(1e-3), Just(7e-3), 1e-3..5e-2],
        phase in prop_oneof![Just(0.0), Just(1.0 / 3.0), Just(0.999)],
    ) {
        let expected = reference(&lines, x, 4.0);
        // Where a decision hangs on a margin of 1e-6, rounding may decide.
        prop_assume!(expected.iter().all(|epoch| epoch.margin > 1e-6 && (epoch.from - 4.0).abs() > 1e-6));
        let mut it = start(lines, [lines.size * x, 0.0], &Clock(0.0), Limits::default());
        let (recorder, ticks) = run_driven(&mut it, (h, phase), 4.0, Clock);
        prop_assert!(ticks.iter().all(|tick| tick.advance == Advance::Completed));
        let modes: Vec<_> = expected[1..].iter().map(|epoch| epoch.mode).collect();
        prop_assert_eq!(states(recorder.events()), modes, "{:?} {:?}", recorder.times(), &expected);
        for (t, epoch) in recorder.times().iter().zip(&expected[1..]) {
            // Rounding of some 4000 steps over the rate with which the surface is met.
            let tolerance = 1e-11 / epoch.margin.min(1.0);
            prop_assert!((t - epoch.from).abs() < tolerance, "{} is not {}", t, epoch.from);
        }
    }

    #[test]
    fn coincidences_are_bounded_and_keep_to_their_sides(
        above in prop::array::uniform2(-2..3_i32),
        below in prop::array::uniform2(-2..3_i32),
        drift in -1..2_i32,
        exponent in -3..1_i32,
        x in -2..3_i32,
        h in prop_oneof![Just(1e-3), Just(7e-3), Just(0.125)],
        phase in prop_oneof![Just(0.0), Just(1.0 / 3.0), Just(0.999)],
    ) {
        // Halves, so that rates, hits and exits coincide to the bit.
        let halves = |it: [i32; 2]| it.map(|n| 0.5 * f64::from(n));
        let lines = Fields {
            above: line(halves(above)),
            below: line(halves(below)),
            drift: 0.5 * f64::from(drift),
            size: 10_f64.powi(exponent),
        };
        let x = [0.5 * lines.size * f64::from(x), 0.0];
        let mut it = start(lines, x, &Clock(0.0), Limits::default());
        let (recorder, ticks) = run_driven(&mut it, (h, phase), 4.0, Clock);
        prop_assert!(ticks.iter().all(|tick| tick.advance == Advance::Completed), "{:?}", recorder.events());
        // A parabola meets its surface twice at most, on either side, and is let go twice.
        prop_assert!(recorder.events().len() <= 6, "{:?}", recorder.events());
        let height = lines.condition(it.state(), &Clock(4.0)).value / lines.size.max(1.0);
        let state = side(it.mode());
        let beyond = if state == Stick { height.abs() } else { -state.slip_sign() * height };
        prop_assert!(beyond < 1e-12, "{:?} at {:e}", state, height);
    }
}
