//! The input of every code: equations, guards and reset maps.

use pode::Nature;

/// A piecewise-continuous problem with `N` states and `G` guards.
///
/// The first guard that falls through zero fires, at the time of its zero; its reset map returns
/// the mode and state from which the code continues.
pub(crate) trait Problem<const N: usize, const G: usize>: Copy + 'static {
    type Mode: Copy + 'static;

    fn names(mode: Self::Mode) -> [&'static str; G];

    fn start(&self) -> (Self::Mode, [f64; N]);

    fn derivative(&self, mode: Self::Mode, t: f64, x: &[f64; N]) -> [f64; N];

    /// Returns the guards, positive while the mode is valid.
    fn guards(&self, mode: Self::Mode, x: &[f64; N]) -> [f64; G];

    /// Returns the rates of the guards along the motion (1/s): the states contain the speeds.
    fn guard_rates(&self, mode: Self::Mode, x: &[f64; N]) -> [f64; G];

    /// Returns the value of one guard, and its rate (1/s), for codes that ask for one alone.
    #[inline]
    fn guard(&self, mode: Self::Mode, guard: usize, x: &[f64; N]) -> (f64, f64) {
        (self.guards(mode, x)[guard], self.guard_rates(mode, x)[guard])
    }

    fn fire(&self, mode: Self::Mode, guard: usize, x: &[f64; N]) -> (Self::Mode, [f64; N]);

    /// Moves the state clearly to the valid side of the guard that has just fired, for codes whose
    /// documentation asks for that; the default does not move it.
    fn nudged(&self, x: [f64; N]) -> [f64; N] {
        x
    }

    /// Returns the longest step (s) that misses nothing of the input, for codes that accept one.
    fn longest_step(&self) -> f64;

    /// Describes the equations, for codes that distinguish linear ones.
    fn nature(&self) -> Nature {
        Nature::default()
    }
}

/// Magnitude below which a guard is on its threshold, as after its own reset.
const ON_THRESHOLD: f64 = 1e-9;

/// Marks the guards that can fire: those that are positive or leave their threshold upwards.
/// For codes without event semantics.
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
