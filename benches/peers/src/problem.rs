//! What every code is given: equations, guards and reset maps, and nothing else.

use pode::Nature;

/// A piecewise-continuous problem with `N` states and `G` guards.
///
/// The events' meaning is the same for everyone: the first guard that falls through zero
/// fires, at the time at which it is zero; its reset map gives the state and the mode from
/// which the code goes on.
pub(crate) trait Problem<const N: usize, const G: usize>: Copy + 'static {
    /// Contact configuration.
    type Mode: Copy + 'static;

    /// Names of the guards, as in the reference; by mode.
    fn names(mode: Self::Mode) -> [&'static str; G];

    /// Mode and state at t = 0.
    fn start(&self) -> (Self::Mode, [f64; N]);

    /// x' at `t` (s).
    fn derivative(&self, mode: Self::Mode, t: f64, x: &[f64; N]) -> [f64; N];

    /// The guards, positive while the mode is valid.
    fn guards(&self, mode: Self::Mode, x: &[f64; N]) -> [f64; G];

    /// Rates of the guards along the motion (1/s): the states hold the speeds.
    fn guard_rates(&self, mode: Self::Mode, x: &[f64; N]) -> [f64; G];

    /// The value of one guard, and its rate (1/s), where a code asks for one alone.
    #[inline]
    fn guard(&self, mode: Self::Mode, guard: usize, x: &[f64; N]) -> (f64, f64) {
        (self.guards(mode, x)[guard], self.guard_rates(mode, x)[guard])
    }

    /// Mode and state after guard `guard` has fired.
    fn fire(&self, mode: Self::Mode, guard: usize, x: &[f64; N]) -> (Self::Mode, [f64; N]);

    /// The state put clearly on the valid side of the guard that has just fired, for codes
    /// whose documentation asks for that; the same state where nothing is asked for.
    fn nudged(&self, x: [f64; N]) -> [f64; N] {
        x
    }

    /// Longest step (s) with which nothing of the input is jumped over, for codes that can
    /// be given one.
    fn longest_step(&self) -> f64;

    /// What the equations are like, for codes that treat linear ones apart.
    fn nature(&self) -> Nature {
        Nature::default()
    }
}

/// A guard that is zero within this stands on its threshold, as after its own reset.
const ON_THRESHOLD: f64 = 1e-9;

/// Which guards can fire: those that are positive, or that leave their threshold upwards.
///
/// For codes without event semantics of their own.
pub(crate) fn armed<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: &P,
    mode: P::Mode,
    x: &[f64; N],
) -> [bool; G] {
    let (values, rates) = (problem.guards(mode, x), problem.guard_rates(mode, x));
    std::array::from_fn(|i| {
        if values[i].abs() < ON_THRESHOLD { rates[i] > 0.0 } else { values[i] > 0.0 }
    })
}
