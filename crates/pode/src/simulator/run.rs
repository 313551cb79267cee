//! Many ticks in one call, for offline use.

use super::Simulator;
use crate::math;
use crate::model::Resets;
use crate::outcome::{Advance, Work};
use crate::stepper::Stepper;
use crate::watch::Watch;

/// Result of a run of many ticks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[must_use]
pub struct RunOutcome {
    /// End of the last tick: the run stops at the first one that is not completed.
    pub advance: Advance,
    pub ticks: u64,
    pub work: Work,
}

impl RunOutcome {
    pub fn is_completed(&self) -> bool {
        self.advance == Advance::Completed
    }
}

impl<M: Resets, T: Stepper> Simulator<M, T> {
    /// Advances in ticks of `h` (s) to the tick boundary nearest to `until` (s), or to the first
    /// tick that is not completed.
    ///
    /// Tick n begins at n h, so the time inside it is (n + θ) h, never a sum. `input` is a function
    /// of that time (s), with the same argument at the end of a tick and at the start of the next
    /// one. Every tick has the whole length `h`; an `until` that has passed advances nothing.
    ///
    /// # Real-time
    /// Each tick is bounded by [`Limits`](crate::Limits), but their number is `until / h`.
    ///
    /// # Examples
    ///
    /// ```
    /// use pode::{Guarded, Limits, Model, Resets, Silent, Simulator, stepper::Rk4};
    ///
    /// /// x' = −x + t, from 1.
    /// struct Lag;
    ///
    /// impl Model for Lag {
    ///     type Mode = ();
    ///     type State = [f64; 1];
    ///     type Input = f64;
    ///     const COORDS: usize = 1;
    ///     fn derivative(&self, (): (), x: &[f64; 1], input: &f64) -> [f64; 1] {
    ///         [input - x[0]]
    ///     }
    /// }
    /// impl Guarded for Lag {}
    /// impl Resets for Lag {}
    ///
    /// let mut lag = Simulator::new(Lag, Rk4, Limits::default(), (), [1.0]);
    /// let report = lag.run(1.0, 0.01, |t| t, &mut Silent);
    /// assert!(report.is_completed() && report.ticks == 100);
    /// assert!((lag.state()[0] - 2.0 * (-1.0_f64).exp()).abs() < 1e-9);
    /// ```
    pub fn run<F, W>(&mut self, until: f64, h: f64, input: F, watch: &mut W) -> RunOutcome
    where
        F: Fn(f64) -> M::Input,
        W: Watch<M>,
    {
        let mut report =
            RunOutcome { advance: Advance::Completed, ticks: 0, work: Work::default() };
        let lines = math::floor(until / h + 0.5);
        // The tick itself reports an invalid length.
        let is_length = h > 0.0 && h < f64::INFINITY;
        while report.is_completed() && ((self.tick() as f64) < lines || !is_length) {
            let begin = self.tick() as f64;
            let tick = self.advance(h, &|theta: f64| input((begin + theta) * h), watch);
            watch.tick(&self.model, &tick);
            report.advance = tick.advance;
            report.ticks += 1;
            report.work = report.work.plus(tick.work);
        }
        report
    }
}
