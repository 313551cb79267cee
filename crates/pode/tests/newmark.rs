//! Newmark's method on oscillators in mechanical form.

use pode::stepper::Newmark;
use pode::{
    Dense as _, EntryRole, Field, MechanicalLayout, MechanicalPoint, MechanicalValues, Nature,
    Stepper as _,
};

/// A unit mass on a spring of ω² (N/m), pulled by sin(t); `loss` is its damper (N·s/m).
#[derive(Clone, Copy, Debug)]
struct Oscillator {
    omega: f64,
    loss: f64,
    pull: f64,
    /// Start and length of the step (s).
    t: f64,
    h: f64,
    evaluations: u32,
    layout: MechanicalLayout,
}

impl Oscillator {
    fn new(omega: f64) -> Self {
        let mut layout = MechanicalLayout { speeds: 1, slope_count: 1, ..MechanicalLayout::EMPTY };
        layout.roles[0] = EntryRole::Coordinate(0);
        layout.roles[1] = EntryRole::Speed(0);
        layout.entries[0] = 1;
        Self { omega, loss: 0.0, pull: 0.0, t: 0.0, h: 0.0, evaluations: 0, layout }
    }

    fn force(&self, tau: f64, [q, u]: &[f64; 2]) -> f64 {
        self.pull * (self.t + tau * self.h).sin() - self.omega.powi(2) * q - self.loss * u
    }
}

impl Field<[f64; 2]> for Oscillator {
    fn coords(&self) -> usize {
        1
    }

    fn nature(&self) -> Nature {
        Nature::default()
    }

    fn derivative(&mut self, tau: f64, x: &[f64; 2]) -> [f64; 2] {
        [x[1], self.force(tau, x)]
    }

    fn layout(&self) -> Option<&MechanicalLayout> {
        Some(&self.layout)
    }

    fn mechanics(
        &mut self,
        tau: f64,
        point: &MechanicalPoint<'_, [f64; 2]>,
        out: &mut MechanicalValues,
    ) {
        self.evaluations += 1;
        let k = self.omega.powi(2);
        let values = [1.0, self.force(tau, point.state), k, self.loss, k];
        out.numbers[..values.len()].copy_from_slice(&values);
        out.contacts = None;
    }
}

/// Returns the states at the ends of `n` steps of `h`, from q = 1 at rest.
fn run(oscillator: &mut Oscillator, h: f64, n: usize) -> Vec<[f64; 2]> {
    let (method, mut memory) = (Newmark { tolerance: f64::INFINITY }, Default::default());
    let mut x = [1.0, 0.0];
    let one = |step: usize| {
        (oscillator.t, oscillator.h) = (step as f64 * h, h);
        x = *method.step(oscillator, &x, &mut memory, h).dense.end();
        x
    };
    (0..n).map(one).collect()
}

/// Returns the rate of an undamped motion in steps of `h`: 2 cos ωh = (q₊ + q₋)/q.
fn rate(states: &[[f64; 2]], h: f64) -> f64 {
    let (mut over, mut under) = (0.0, 0.0);
    for window in states.windows(3) {
        over += (window[0][0] + window[2][0]) * window[1][0];
        under += 2.0 * window[1][0].powi(2);
    }
    (over / under).acos() / h
}

#[test]
fn a_forced_and_damped_motion_has_order_two_with_one_evaluation_a_step() {
    // q'' + 2 q' + 25 q = 3 sin t; with q(0) = 1, q'(0) = 0 in closed form.
    let exact = |t: f64| {
        let (a, b) = (3.0 * 24.0 / 580.0, -3.0 * 2.0 / 580.0);
        let w = 24.0_f64.sqrt();
        let c = 1.0 - b;
        let d = (c - a) / w;
        (-t).exp() * (c * (w * t).cos() + d * (w * t).sin()) + a * t.sin() + b * t.cos()
    };
    let error = |n: usize| {
        let mut oscillator = Oscillator { loss: 2.0, pull: 3.0, ..Oscillator::new(5.0) };
        let states = run(&mut oscillator, 1.0 / n as f64, n);
        assert_eq!(oscillator.evaluations as usize, n + 1, "one more finds the acceleration");
        (states[n - 1][0] - exact(1.0)).abs()
    };
    let errors = [64, 128, 256].map(error);
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "{errors:?}: order {order}");
    }
}

#[test]
fn the_frequency_of_an_oscillator_errs_by_the_fourth_power_of_the_step() {
    for radians in [0.4, 0.8] {
        let states = run(&mut Oscillator::new(100.0), radians / 100.0, 400);
        let error = rate(&states, radians / 100.0) / 100.0 - 1.0;
        let expected = radians.powi(4) / 480.0;
        assert!((error.abs() / expected - 1.0).abs() < 0.1, "{radians}: {error} for {expected}");
    }
}

#[test]
fn a_spring_of_any_stiffness_is_stable_and_loses_nothing() {
    for radians in [2.0, 2.4, 2.5, 3.0, 10.0, 1e3, 1e6] {
        let (omega, h) = (radians / 5e-4, 5e-4);
        let states = run(&mut Oscillator::new(omega), h, 2000);
        let most = states.iter().fold(0.0, |most: f64, x| most.max(x[0].abs()));
        assert!(most < 3.0, "{radians} rad a step: {most}");
        let last = states[1000..].iter().fold(0.0, |most: f64, x| most.max(x[0].abs()));
        assert!(last > 0.3, "{radians} rad a step: {last} is left");
    }
}

#[test]
fn a_large_correction_is_undone_once_and_leads_to_short_steps() {
    let mut field = Oscillator { pull: 1e6, ..Oscillator::new(3000.0) };
    let (method, mut memory) = (Newmark { tolerance: 1e-9 }, Default::default());
    (field.t, field.h) = (0.0, 5e-4);
    let x = [1e-3, 0.0];
    let first = method.step(&mut field, &x, &mut memory, 5e-4);
    assert!(!first.is_accepted, "the correction moves the spring's force by more than 8e-9 N");
    assert_eq!(pode::stepper::Memory::reach(&memory), 2.5e-4);
    let again = method.step(&mut field, &x, &mut memory, 5e-4);
    assert!(again.is_accepted, "a step is undone once");
    assert_eq!(field.evaluations, 3, "the acceleration of the start is kept");
}
