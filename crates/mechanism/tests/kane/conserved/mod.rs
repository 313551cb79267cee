//! Energy and momentum of described motions, by independent formulas.
//!
//! A method under a tolerance has that error in each step, in the mean square of the state's
//! entries; a conserved quantity may drift by its steps times its slope by the entries.

mod built_in;
mod planar;
mod spatial;

use instruments::equations::ModeNumber;
use pode::stepper::{Controlled, Tolerance, Tsitouras5};
use pode::{Limits, Motion, RunRecorder, Simulator};

use crate::kane::evaluation::Derived;

const TOLERANCES: [f64; 2] = [1e-8, 1e-11];

type Conserved<'a, const N: usize> = &'a dyn Fn(&[f64; N]) -> f64;

struct Free<const N: usize> {
    states: Vec<[f64; N]>,
    steps: u32,
}

/// Runs from a state with the input at rest, 10 ms at a time.
fn free<const N: usize>(
    derived: &Derived,
    (mode, start): (u8, [f64; N]),
    (input, until): (f64, f64),
    tolerance: f64,
) -> Free<N> {
    let model = derived.model::<N>();
    let still = Motion { position: input, ..Motion::default() };
    let method = Controlled { method: Tsitouras5, tolerance: Tolerance::both(tolerance) };
    let mut simulator = Simulator::new(model, method, Limits::default(), ModeNumber(mode), start);
    let mut recorder = RunRecorder::new(1e-2).sampled(1e-2);
    let outcome = simulator.run(until, 1e-2, |_| still, &mut recorder);
    assert!(outcome.is_completed(), "{outcome:?}");
    let states = recorder.samples().iter().map(|it| it.state).collect();
    Free { states, steps: outcome.work.pieces }
}

/// Returns the error of `quantity` if each entry is off by one unit of the tolerance, 1 + |x|, as
/// far as the mean square of all allows.
fn slope<const N: usize>(quantity: Conserved<'_, N>, x: &[f64; N]) -> f64 {
    let small = 1e-6;
    let by = |entry: usize| {
        let values = [small, -small].map(|part| {
            let mut moved = *x;
            moved[entry] += part * (1.0 + x[entry].abs());
            quantity(&moved)
        });
        0.5 * (values[0] - values[1]).abs() / small
    };
    let sum: f64 = (0..N).map(|entry| by(entry).powi(2)).sum();
    (sum * N as f64).sqrt()
}

#[track_caller]
fn conserved<const N: usize>(
    derived: &Derived,
    start: (u8, [f64; N]),
    (input, until): (f64, f64),
    quantities: &[(&str, Conserved<'_, N>)],
) {
    for tolerance in TOLERANCES {
        let run = free(derived, start, (input, until), tolerance);
        let first = run.states[0];
        let last = run.states.last().expect("states");
        assert!(first.iter().zip(last).any(|(a, b)| (a - b).abs() > 0.01), "it moves");
        for (name, quantity) in quantities {
            let before = quantity(&first);
            let drifts = run.states.iter().map(|it| (quantity(it) - before).abs());
            let drift = drifts.fold(0.0, f64::max);
            let slopes = run.states.iter().map(|it| slope(quantity, it));
            let steepest = slopes.fold(0.0, f64::max);
            let bound = tolerance * f64::from(run.steps) * steepest;
            println!("{name}: {drift:.1e} of {before:.3} in {} steps, {bound:.1e}", run.steps);
            assert!(drift <= bound, "{name} of {before} drifts by {drift:e}, not {bound:e}");
        }
    }
}
