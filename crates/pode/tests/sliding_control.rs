//! Sliding along surfaces that are oblique, curved, or move.
//!
//! Error model: RK4, with r the radians (or time constants) per step, errs by r⁴/120 of the
//! followed motion; the hold on the surface errs by rounding only.

use pode::contacts::ContactState::{self, SlideDown, SlideUp, Stick};
use pode::contacts::Surface;
use pode::{Limits, Nature, State as _};

use crate::common::two_sided::{TwoSided, start, states};
use crate::common::{all_completed, close, each_step_and_phase, run};
use crate::driven::{Clock, root, run_driven};

#[derive(Clone, Copy, Debug, PartialEq)]
struct Controlled {
    force: f64,
    lambda: f64,
}

impl TwoSided for Controlled {
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn flow(&self, side: f64, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], -side * self.force]
    }

    fn condition(&self, x: &[f64; 2], (): &()) -> Surface<[f64; 2]> {
        let value = x[1] + self.lambda * x[0];
        Surface { value, gradient: [self.lambda, 1.0], drift: 0.0 }
    }

    fn nature(&self) -> Nature {
        Nature::default().with_longest_step(0.02 / self.lambda)
    }
}

#[test]
fn a_switched_mass_slides_home_along_its_line() {
    let sides = Controlled { force: 10.0, lambda: 3.0 };
    // From rest at 1 under −10: x = 1 − 5t², v = −10t, on the line at 15t² + 10t = 3.
    let hit = (-10.0 + 280.0_f64.sqrt()) / 30.0;
    let x_hit = 1.0 - 5.0 * hit * hit;
    each_step_and_phase(|h, phase| {
        let mut it = start(sides, [1.0, 0.0], &(), Limits::default());
        let (recorder, ticks) = run(&mut it, h, phase, 2.0);
        all_completed(&ticks);
        assert_eq!(states(recorder.events()), [Stick], "h {h}, phase {phase}");
        close(format_args!("h {h}: hit"), recorder.events()[0].t, hit, 1e-13);
        let [x, v] = *it.state();
        close(format_args!("h {h}: on the line"), v + 3.0 * x, 0.0, 1e-15);
        let t = recorder.time(it.tick(), 0.0);
        let home = x_hit * (-3.0 * (t - hit)).exp();
        close(format_args!("h {h}: x"), x, home, home * 3.0 * t * 0.02_f64.powi(4) / 120.0 + 1e-14);
        close(
            format_args!("h {h}: force"),
            -10.0 * ticks[ticks.len() - 1].end_readout,
            9.0 * x,
            1e-12,
        );
    });
}

#[test]
fn a_line_too_steep_for_its_force_is_crossed_before_it_is_slid_along() {
    // It holds where λ |v| < u: from x = 1 it is met at v = −2.6, and 5 × 2.6 > 4.
    let sides = Controlled { force: 4.0, lambda: 5.0 };
    each_step_and_phase(|h, phase| {
        let mut it = start(sides, [1.0, 0.0], &(), Limits::default());
        let (recorder, ticks) = run(&mut it, h, phase, 4.0);
        all_completed(&ticks);
        let seen = recorder.events();
        let reference = crossings(4.0, 5.0);
        let modes: Vec<_> = reference.iter().map(|it| it.1).collect();
        assert_eq!(states(seen), modes, "h {h}, phase {phase}");
        for (seen, (t, _)) in seen.iter().zip(&reference) {
            close(format_args!("h {h}"), seen.t, *t, 1e-12);
        }
        close("home", it.state()[0], 0.0, 1e-4);
    });
}

fn crossings(u: f64, lambda: f64) -> Vec<(f64, ContactState)> {
    let (mut t, mut x, mut v, mut sign) = (0.0, 1.0, 0.0, 1.0);
    let mut found = Vec::new();
    loop {
        let at = |s: f64| (x + s * (v - 0.5 * sign * u * s), v - sign * u * s);
        let height = |s: f64| {
            let (x, v) = at(s);
            sign * (v + lambda * x)
        };
        let mut s = 1e-4;
        while height(s) > 0.0 {
            s += 1e-4;
        }
        let hit = root(s - 1e-4, s, height);
        ((x, v), t) = (at(hit), t + hit);
        if lambda * v.abs() < u {
            found.extend([(t, Stick)]);
            return found;
        }
        sign = -sign;
        found.extend([(t, if sign > 0.0 { SlideUp } else { SlideDown })]);
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Ring;

fn radius(t: f64) -> [f64; 2] {
    let (sin, cos) = (3.0 * t).sin_cos();
    [1.0 + 0.1 * sin, 0.3 * cos]
}

impl TwoSided for Ring {
    type State = [f64; 2];
    type Input = Clock;
    const COORDS: usize = 2;

    fn flow(&self, side: f64, x: &[f64; 2], _: &Clock) -> [f64; 2] {
        let turn = [-x[1], x[0]];
        turn.plus(-side, x)
    }

    fn condition(&self, x: &[f64; 2], t: &Clock) -> Surface<[f64; 2]> {
        let [r, rate] = radius(t.0);
        Surface {
            value: x[0] * x[0] + x[1] * x[1] - r * r,
            gradient: [2.0 * x[0], 2.0 * x[1]],
            drift: -2.0 * r * rate,
        }
    }
}

#[test]
fn a_curved_surface_that_moves_is_followed_to_rounding() {
    // From r = 2 it falls like e⁻ᵗ onto 1 + 0.1 sin 3t.
    let hit = root(0.0, 1.0, |t| 2.0 * (-t).exp() - radius(t)[0]);
    each_step_and_phase(|h, phase| {
        let mut it = start(Ring, [2.0, 0.0], &Clock(0.0), Limits::default());
        let (recorder, ticks) = run_driven(&mut it, (h, phase), 5.0, Clock);
        all_completed(&ticks);
        assert_eq!(states(recorder.events()), [Stick], "h {h}, phase {phase}");
        close(format_args!("h {h}: hit"), recorder.events()[0].t, hit, 1e-13 + h.powi(4));
        let [x, y] = *it.state();
        close(format_args!("h {h}: radius"), x.hypot(y), radius(5.0)[0], 4e-16);
        // α r − (1 − α) r = −r': the sum in the readout.
        let [r, rate] = radius(5.0);
        let share = ticks[ticks.len() - 1].end_readout;
        close(format_args!("h {h}: share"), share, -rate / r, 1e-14);
        let angle = (y * 5.0_f64.cos() - x * 5.0_f64.sin()) / r;
        close(format_args!("h {h}: angle"), angle, 0.0, 1e-12 + 5.0 * (3.0 * h).powi(4));
    });
}

/// A mass of 1 kg that 1 N drives to x = 0 from either side: x' is the same on both.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Notch;

impl TwoSided for Notch {
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn flow(&self, side: f64, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], -side]
    }

    fn condition(&self, x: &[f64; 2], (): &()) -> Surface<[f64; 2]> {
        Surface { value: x[0], gradient: [1.0, 0.0], drift: 0.0 }
    }

    fn kept(&self, x: &[f64; 2], (): &()) -> Option<Surface<[f64; 2]>> {
        Some(Surface { value: x[1], gradient: [0.0, 1.0], drift: 0.0 })
    }
}

#[test]
fn a_notch_is_crossed_at_speed_and_holds_a_mass_that_hardly_moves() {
    each_step_and_phase(|h, phase| {
        let mut it = start(Notch, [0.5, 0.0], &(), Limits::default());
        let (recorder, ticks) = run(&mut it, h, phase, 6.5);
        all_completed(&ticks);
        assert_eq!(states(recorder.events()), [SlideDown, SlideUp, SlideDown], "h {h}");
        // At ±1 m/s, every 2 s.
        for (t, expected) in recorder.times().iter().zip([1.0, 3.0, 5.0]) {
            close(format_args!("h {h}"), *t, expected, 1e-11);
        }
        // From 1e-10 m it meets the edge at 14 µm/s, and would be back in 28 µs.
        let mut it = start(Notch, [1e-10, 0.0], &(), Limits::default());
        let (recorder, ticks) = run(&mut it, h, phase, 1.0);
        all_completed(&ticks);
        assert_eq!(states(recorder.events()), [Stick], "h {h}, phase {phase}");
        close("held", it.state()[1], 0.0, f64::EPSILON);
    });
}
