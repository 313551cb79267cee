//! Sliding along surfaces that are oblique, curved, or move.
//!
//! Error model: RK4, with r the radians (or time constants) per step, errs by r⁴/120 of the
//! followed motion; the hold on the surface errs by rounding only.

use pode::filippov::{Branch, Filippov, Mode, Sided, Surface, SurfaceSide};
use pode::stepper::Rk4;
use pode::{Limits, Nature, Simulator, State as _};

use crate::common::{all_completed, close, each_step_and_phase, run};
use crate::driven::{Clock, root, run_driven};

#[derive(Clone, Copy, Debug, PartialEq)]
struct Switched {
    force: f64,
    lambda: f64,
}

impl Sided for Switched {
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;
    const SIZE: f64 = 1.0;
    const RATE: f64 = 10.0;

    fn derivative(&self, branch: Branch, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], self.readout(branch, x, &())]
    }

    fn readout(&self, branch: Branch, _: &[f64; 2], (): &()) -> f64 {
        -branch.side.sign() * self.force
    }

    fn surface(&self, x: &[f64; 2], (): &()) -> Surface<[f64; 2]> {
        let value = x[1] + self.lambda * x[0];
        Surface { value, gradient: [self.lambda, 1.0], drift: 0.0 }
    }

    fn nature(&self, _: SurfaceSide) -> Nature {
        Nature::default().with_longest_step(0.02 / self.lambda)
    }
}

#[test]
fn a_switched_mass_slides_home_along_its_line() {
    let model = Filippov(Switched { force: 10.0, lambda: 3.0 });
    // From rest at 1 under −10: x = 1 − 5t², v = −10t, on the line at 15t² + 10t = 3.
    let hit = (-10.0 + 280.0_f64.sqrt()) / 30.0;
    let x_hit = 1.0 - 5.0 * hit * hit;
    each_step_and_phase(|h, phase| {
        let (mode, state) = model.start(&[1.0, 0.0], &());
        let mut it = Simulator::new(model, Rk4, Limits::default(), mode, state);
        let (recorder, ticks) = run(&mut it, h, phase, 2.0);
        all_completed(&ticks);
        let modes: Vec<_> = recorder.events().iter().map(|seen| seen.to).collect();
        assert_eq!(modes, [Mode::Sliding], "h {h}, phase {phase}");
        close(format_args!("h {h}: hit"), recorder.events()[0].t, hit, 1e-13);
        let [x, v] = *it.state();
        close(format_args!("h {h}: on the line"), v + 3.0 * x, 0.0, 1e-15);
        let t = recorder.time(it.tick(), 0.0);
        let home = x_hit * (-3.0 * (t - hit)).exp();
        close(format_args!("h {h}: x"), x, home, home * 3.0 * t * 0.02_f64.powi(4) / 120.0 + 1e-14);
        close(format_args!("h {h}: force"), ticks[ticks.len() - 1].end_readout, 9.0 * x, 1e-12);
    });
}

#[test]
fn a_line_too_steep_for_its_force_is_crossed_before_it_is_slid_along() {
    // It holds where λ |v| < u: from x = 1 it is met at v = −2.6, and 5 × 2.6 > 4.
    let model = Filippov(Switched { force: 4.0, lambda: 5.0 });
    each_step_and_phase(|h, phase| {
        let (mode, state) = model.start(&[1.0, 0.0], &());
        let mut it = Simulator::new(model, Rk4, Limits::default(), mode, state);
        let (recorder, ticks) = run(&mut it, h, phase, 4.0);
        all_completed(&ticks);
        let seen = recorder.events();
        let reference = crossings(4.0, 5.0);
        assert_eq!(seen.len(), reference.len(), "h {h}, phase {phase}");
        for (seen, (t, mode)) in seen.iter().zip(&reference) {
            assert_eq!(seen.to, *mode, "h {h}, phase {phase}");
            close(format_args!("h {h}"), seen.t, *t, 1e-12);
        }
        close("home", it.state()[0], 0.0, 1e-4);
    });
}

fn crossings(u: f64, lambda: f64) -> Vec<(f64, Mode)> {
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
            found.extend([(t, Mode::Sliding)]);
            return found;
        }
        sign = -sign;
        found.extend([(t, if sign > 0.0 { Mode::Above } else { Mode::Below })]);
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Ring;

fn radius(t: f64) -> [f64; 2] {
    let (sin, cos) = (3.0 * t).sin_cos();
    [1.0 + 0.1 * sin, 0.3 * cos]
}

impl Sided for Ring {
    type State = [f64; 2];
    type Input = Clock;
    const COORDS: usize = 2;
    const SIZE: f64 = 1.0;
    const RATE: f64 = 2.0;

    fn derivative(&self, branch: Branch, x: &[f64; 2], _: &Clock) -> [f64; 2] {
        let turn = [-x[1], x[0]];
        turn.plus(-branch.side.sign(), x)
    }

    fn readout(&self, branch: Branch, _: &[f64; 2], _: &Clock) -> f64 {
        branch.side.sign()
    }

    fn surface(&self, x: &[f64; 2], t: &Clock) -> Surface<[f64; 2]> {
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
        let model = Filippov(Ring);
        let (mode, state) = model.start(&[2.0, 0.0], &Clock(0.0));
        let mut it = Simulator::new(model, Rk4, Limits::default(), mode, state);
        let (recorder, ticks) = run_driven(&mut it, (h, phase), 5.0, Clock);
        all_completed(&ticks);
        let modes: Vec<_> = recorder.events().iter().map(|seen| seen.to).collect();
        assert_eq!(modes, [Mode::Sliding], "h {h}, phase {phase}");
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
