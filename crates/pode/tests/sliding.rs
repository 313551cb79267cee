//! Case C7 and its family: a surface that attracts, is crossed, or repels.
//!
//! Error model: the fields are polynomials of the time, of degree 3 at most, which RK4 integrates
//! exactly. What is left is rounding: each step rounds a state of size 4 at most by 4.5e-16, and an
//! event's time errs by the state over the rate at which it is met.

use pode::contacts::ContactState::{self, SlideDown, SlideUp, Stick};
use pode::contacts::Surface;
use pode::stepper::Rk4;
use pode::{Limits, RecordedEvent, Simulator, Tick};

use crate::common::two_sided::{self, Switched, TwoSided, states};
use crate::common::{all_completed, close, each_step_and_phase};
use crate::driven::{Clock, run_driven};

/// Two fields that depend on the time alone, on either side of x = size c t: x' = size r₊(t) above
/// and size r₋(t) below; y' = +1 above and −1 below, so that y shows the share of each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fields {
    /// Coefficients of r₊ by power of t.
    pub above: [f64; 4],
    pub below: [f64; 4],
    pub drift: f64,
    pub size: f64,
}

fn polynomial(c: [f64; 4], t: f64) -> f64 {
    c[0] + t * (c[1] + t * (c[2] + t * c[3]))
}

impl TwoSided for Fields {
    type State = [f64; 2];
    type Input = Clock;
    const COORDS: usize = 2;

    fn flow(&self, side: f64, _: &[f64; 2], t: &Clock) -> [f64; 2] {
        let c = if side > 0.0 { self.above } else { self.below };
        [self.size * polynomial(c, t.0), side]
    }

    fn condition(&self, x: &[f64; 2], t: &Clock) -> Surface<[f64; 2]> {
        let drift = self.size * self.drift;
        Surface { value: x[0] - drift * t.0, gradient: [1.0, 0.0], drift: -drift }
    }
}

type Slide = Simulator<Switched<Fields>, Rk4>;

fn start(above: [f64; 4], below: [f64; 4], x: f64) -> Slide {
    let fields = Fields { above, below, drift: 0.0, size: 1.0 };
    two_sided::start(fields, [x, 0.0], &Clock(0.0), Limits::default())
}

fn rounding(h: f64, t: f64) -> f64 {
    (t / h + 10.0) * 4.5e-16
}

fn events(
    it: &mut Slide,
    at: (f64, f64),
    until: f64,
) -> (Vec<RecordedEvent<Switched<Fields>>>, Vec<Tick>) {
    let (recorder, ticks) = run_driven(it, at, until, Clock);
    all_completed(&ticks);
    (recorder.events().to_vec(), ticks)
}

#[track_caller]
fn check(above: [f64; 4], below: [f64; 4], x: f64, until: f64, expected: &[(f64, ContactState)]) {
    each_step_and_phase(|h, phase| {
        let (seen, _) = events(&mut start(above, below, x), (h, phase), until);
        let modes = states(&seen);
        let wanted: Vec<_> = expected.iter().map(|it| it.1).collect();
        assert_eq!(modes, wanted, "h {h}, phase {phase}: {:?}", seen[0].t);
        for (seen, (t, _)) in seen.iter().zip(expected) {
            close(format_args!("h {h}, phase {phase}"), seen.t, *t, rounding(h, *t));
        }
    });
}

const C7: [[f64; 4]; 2] = [[-2.0, 1.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0]];

#[test]
fn c7_slides_from_its_hit_to_t_2_and_leaves_tangentially() {
    let hit = 2.0 - 2.0_f64.sqrt();
    check(C7[0], C7[1], 1.0, 3.0, &[(hit, Stick), (2.0, SlideUp)]);
    each_step_and_phase(|h, phase| {
        let mut it = start(C7[0], C7[1], 1.0);
        let (seen, ticks) = events(&mut it, (h, phase), 3.0);
        close("y(2)", seen[1].after[1], 4.0 / 3.0, rounding(h, 2.0));
        close("x(3)", it.state()[0], 0.5, rounding(h, 3.0));
        close("y(3)", it.state()[1], 7.0 / 3.0, rounding(h, 3.0));
        assert_eq!(ticks.iter().map(|tick| tick.work.events).max(), Some(1), "h {h}");
    });
}

#[test]
fn c7_reads_out_the_share_of_each_side() {
    let mut it = start(C7[0], C7[1], 1.0);
    let (_, ticks) = events(&mut it, (1e-3, 0.0), 1.5);
    // y' = (2t − 1)/3, which Simpson's rule integrates exactly.
    for n in [700, 1000, 1499_u32] {
        let middle = (f64::from(n) + 0.5) * 1e-3;
        let found = ticks[n as usize].mean_readout;
        close(format_args!("tick {n}"), found, (2.0 * middle - 1.0) / 3.0, 1e-14);
    }
}

#[test]
fn a_surface_that_repels_is_left_upwards_for_good() {
    each_step_and_phase(|h, phase| {
        let mut it = start([1.0, 0.0, 0.0, 0.0], [-1.0, 0.0, 0.0, 0.0], 0.0);
        let (seen, _) = events(&mut it, (h, phase), 1.0);
        assert!(seen.is_empty(), "h {h}, phase {phase}: {seen:?}");
        close("x", it.state()[0], 1.0, rounding(h, 1.0));
    });
}

#[test]
fn a_surface_that_turns_from_attracting_to_repelling_is_left_where_it_turns() {
    // r₊ = t − 1 and r₋ = 2 − 2t vanish together, and then their mean leads down.
    let [above, below] = [[-1.0, 1.0, 0.0, 0.0], [2.0, -2.0, 0.0, 0.0]];
    check(above, below, 0.125, 2.0, &[(1.0 - 0.75_f64.sqrt(), Stick), (1.0, SlideDown)]);
}

#[test]
fn a_touch_of_an_attracting_surface_is_held_and_let_go() {
    // x = (t − 1)²/2 touches from above, where the other side pushes up.
    let above = [-1.0, 1.0, 0.0, 0.0];
    for x in [0.5, 0.5 + 1e-9] {
        check(above, [1.0, 0.0, 0.0, 0.0], x, 2.0, &[]);
    }
    // 1e-6 deeper: it slides from 1 − √2e-6 to 1.
    let hit = 1.0 - (2e-6_f64).sqrt();
    each_step_and_phase(|h, phase| {
        let it = &mut start(above, [1.0, 0.0, 0.0, 0.0], 0.5 - 1e-6);
        let (seen, _) = events(it, (h, phase), 2.0);
        assert_eq!(states(&seen), [Stick, SlideUp], "h {h}, phase {phase}");
        close("hit", seen[0].t, hit, rounding(h, 1.0) / 1.4e-3);
        close("exit", seen[1].t, 1.0, 1e-14);
    });
}

#[test]
fn a_slide_that_ends_with_a_flat_rate_ends_once() {
    // r₊ = 8 (t − 1)³ = −8 + 24 t − 24 t² + 8 t³: h and its first three derivatives are zero
    // at the exit. x = 1/2 falls to zero at 1 − (3/4)^¼.
    let above = [-8.0, 24.0, -24.0, 8.0];
    each_step_and_phase(|h, phase| {
        // A quartic is beyond the dense output by 2 h⁴ / 10: that must be below rounding.
        let limits = Limits { longest_step: 1e-4, ..Limits::default() };
        let fields = Fields { above, below: [1.0, 0.0, 0.0, 0.0], drift: 0.0, size: 1.0 };
        let mut it = two_sided::start(fields, [0.5, 0.0], &Clock(0.0), limits);
        let (seen, _) = events(&mut it, (h, phase), 2.0);
        assert_eq!(states(&seen), [Stick, SlideUp], "h {h}, phase {phase}: {seen:?}");
        close("hit", seen[0].t, 1.0 - 0.75_f64.powf(0.25), rounding(1e-4, 1.0));
        // Where the cubic leaves the rounding of its terms, 24 × 16 ε: within ∛1e-14.
        close("exit", seen[1].t, 1.0, 3e-5);
    });
}

#[test]
fn a_rate_of_zero_at_the_surface_is_decided_by_its_change() {
    // Both meet x = 0 at t = 1, exactly where r₋ vanishes.
    let fall = [-1.0, 0.0, 0.0, 0.0];
    // r₋ = t − 1 turns up: it slides on.
    check(fall, [-1.0, 1.0, 0.0, 0.0], 1.0, 2.0, &[(1.0, Stick)]);
    // r₋ = 1 − t turns down: it is crossed.
    check(fall, [1.0, -1.0, 0.0, 0.0], 1.0, 2.0, &[(1.0, SlideDown)]);
}
