//! End of the next step: on the mode's grid, within the method's reach, or just behind an event.

use super::Simulator;
use super::parts::PartMemory;
use crate::epoch::Stand;
use crate::math;
use crate::model::Resets;
use crate::nature::Nature;
use crate::run::TickRun;
use crate::stepper::Stepper;

impl<M: Resets, T: Stepper> Simulator<M, T> {
    /// Returns the end of the next step (θ), and the excess of the present rate over the mode's.
    #[inline]
    pub(super) fn step_end<S, W>(
        &self,
        run: &mut TickRun<'_, S, W>,
        input: &M::Input,
    ) -> (f64, f64) {
        let sets_steps = self.memory.iter().any(PartMemory::sets_steps);
        let own = if sets_steps {
            f64::INFINITY
        } else {
            self.model.longest_step_at(self.mode, &self.state, input)
        };
        let nature = self.model.nature(self.mode);
        let excess = nature.excess(own);
        let nature = nature.faster(excess);
        let end = self.line(run, (own, &nature));
        // A dense output as good as the end leaves nothing to gain.
        let may_aim =
            run.limits.forecast && !run.has_aimed && !sets_steps && self.stepper.aims(&nature);
        (if may_aim { self.aimed(run, end) } else { end }, excess)
    }

    /// Returns a place just behind the first event predicted before `end`, otherwise `end`.
    #[inline]
    fn aimed<S, W>(&self, run: &mut TickRun<'_, S, W>, end: f64) -> f64 {
        /// Fraction by which the predicted time may be short.
        const MARGIN: f64 = 0.02;
        /// Fraction of the step before which it is not worth while.
        const WORTH: f64 = 0.02;
        let h = (end - run.theta) * run.h;
        let present = self.guards.iter().zip(self.model.guards(self.mode));
        let armed = present.filter(|(slot, _)| slot.stand == Stand::Armed);
        let first = armed.map(|(slot, _)| slot.due_within(h)).fold(f64::INFINITY, f64::min);
        let due = first * (1.0 + MARGIN);
        if due < WORTH * h || due >= h {
            return end;
        }
        run.has_aimed = true;
        run.theta + due / run.h
    }

    /// Returns the next line of the mode's grid, limited by the method's reach.
    #[inline]
    fn line<S, W>(&self, run: &TickRun<'_, S, W>, (own, nature): (f64, &Nature)) -> f64 {
        /// A rest shorter than this fraction of a step joins the next one.
        const CRUMB: f64 = 1e-9;
        const MOST_LINES: f64 = 1e12;
        let longest = self.stepper.longest_step(nature, run.limits.stretch * own);
        let longest = longest.min(run.limits.longest_step);
        // An invalid length requests more pieces than there are.
        let longest = if longest > 0.0 { longest } else { 0.0 };
        let reaches = self.memory.iter().map(|it| it.reach(run.limits.stretch));
        let reach = reaches.fold(f64::INFINITY, f64::min) / run.h;
        if reach < 1.0 - run.theta {
            return reached(run, reach, longest / run.h);
        }
        if longest >= run.h {
            return 1.0;
        }
        let n = math::ceil(run.h / longest * (1.0 - CRUMB)).clamp(1.0, MOST_LINES);
        let rounding = 4.0 * f64::EPSILON * n;
        let k = math::floor(run.theta * n + CRUMB + rounding) + 1.0;
        if k >= n { 1.0 } else { k / n }
    }
}

/// Returns the end of a step of at most `reach`, a fraction of the tick.
fn reached<S, W>(run: &TickRun<'_, S, W>, reach: f64, longest: f64) -> f64 {
    // Never so short that the time would not advance.
    let reach = reach.min(longest).max(f64::EPSILON);
    let rest = 1.0 - run.theta;
    // Two even steps rather than a long one and a crumb.
    let part = if reach < rest && 2.0 * reach > rest { 0.5 * rest } else { reach };
    if part < rest { run.theta + part } else { 1.0 }
}
