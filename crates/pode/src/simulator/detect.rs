use core::cell::Cell;

use super::parts::ModeStep;
use super::{Simulator, TakenStep};
use crate::crossing::{Crossing, GuardSpan};
use crate::dense::{Dense as _, DenseBounds};
use crate::enclosure::{Enclosure, GuardBound};
use crate::epoch::Stand;
use crate::guard::{GuardSet, GuardSpec, GuardValue, MAX_GUARDS};
use crate::input::Signal;
use crate::locate::{locate, most_evaluations};
use crate::model::Resets;
use crate::outcome::{Certainty, Fault};
use crate::run::TickRun;
use crate::stepper::Stepper;

#[derive(Clone, Copy)]
pub(super) struct First {
    pub(super) index: usize,
    pub(super) tau: f64,
    /// All guards that cross there, `index` included.
    pub(super) crossed: GuardSet,
}

/// Time of a guard's crossing in the step: `tau` ± `radius`.
#[derive(Clone, Copy)]
struct CrossingTime {
    tau: f64,
    radius: f64,
}

impl CrossingTime {
    const NOWHERE: Self = Self { tau: f64::INFINITY, radius: 0.0 };
}

#[derive(Clone, Copy)]
pub(super) struct Suspicion {
    /// A bit for each guard that may cross, by its index in the mode.
    pub(super) candidates: u32,
    pub(super) certainty: Certainty,
}

impl<M: Resets, T: Stepper> Simulator<M, T> {
    /// Evaluates the guards at the end of a step where they can have reached zero, and judges all.
    #[expect(clippy::inline_always, reason = "a call takes the step through memory")]
    #[inline(always)]
    pub(super) fn suspicion<S: Signal<M::Input>, W>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        taken: &TakenStep<M, T>,
    ) -> Result<Suspicion, Fault> {
        let mut found = Suspicion { candidates: 0, certainty: Certainty::Certain };
        let enclosure = self.enclosure(run, taken);
        let aims = self.stepper.aims(&self.model.nature(self.mode));
        for index in 0..self.model.guards(self.mode).len().min(MAX_GUARDS) {
            let spec = self.model.guards(self.mode)[index];
            if self.guards[index].stand == Stand::Unwatched {
                continue;
            }
            let slot = &mut self.guards[index];
            let bound = match &enclosure {
                Some(over) if !slot.is_doubted => self.model.guard_bound(self.mode, spec.id, over),
                _ => GuardBound::UNKNOWN,
            };
            if run.limits.forecast && slot.is_asleep(&bound) {
                slot.pass(&bound);
                continue;
            }
            let Some(span) = self.look(run, taken, (index, spec), &bound)? else { continue };
            if !aims {
                self.guards[index].curvature = f64::INFINITY;
            }
            let is_candidate = span.may_cross() || span.stand == Stand::Spent;
            if is_candidate {
                found.candidates |= 1 << index;
            } else {
                found.certainty = Certainty::Unknown;
            }
        }
        Ok(found)
    }

    /// Evaluates a guard after a step with `bound`; returns it if it may have reached zero.
    #[expect(clippy::inline_always, reason = "a call takes the step through memory")]
    #[inline(always)]
    fn look<S: Signal<M::Input>, W>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        taken: &TakenStep<M, T>,
        (index, spec): (usize, GuardSpec),
        bound: &GuardBound,
    ) -> Result<Option<GuardSpan>, Fault> {
        let mut slot = self.guards[index];
        let is_clear = slot.is_clear_of(bound);
        let needs_start = !slot.is_fresh && !is_clear;
        if !run.spend_guards(1 + u32::from(needs_start)) {
            return Ok(None);
        }
        let guard = |x: &M::State, input: &M::Input| self.model.guard(self.mode, spec.id, x, input);
        if needs_start {
            slot.value = guard(&self.state, &run.input());
            slot.is_fresh = true;
        }
        let is_doubted = slot.step_to(guard(&taken.end, &taken.input), bound, taken.h, &spec);
        if ![slot.value, slot.start].iter().all(GuardValue::is_finite) {
            return Err(Fault::Guard);
        }
        self.guards[index] = slot;
        let span = slot.span(spec, taken.h);
        let is_clear = (is_clear && !is_doubted) || span.is_clear();
        Ok((!is_clear).then_some(span))
    }

    /// Bounds the orbit and the input over the step, if the method and the signal can.
    #[inline]
    fn enclosure<S: Signal<M::Input>, W>(
        &self,
        run: &TickRun<'_, S, W>,
        taken: &TakenStep<M, T>,
    ) -> Option<Enclosure<M::State, M::Input>> {
        let DenseBounds { moves, speeds, bends } = taken.step.dense.bounds()?;
        let input = run.signal.bound(run.theta, taken.theta_end);
        let (h, start, input_start) = (taken.h, self.state, taken.input_start);
        Some(Enclosure { h, start, moves, speeds, bends, input_start, input })
    }

    /// Finds the earliest crossing of the candidates within the step, with the certainty that none
    /// before it was missed; ties go to the lower priority number.
    pub(super) fn first_crossing<S: Signal<M::Input>, W>(
        &self,
        run: &mut TickRun<'_, S, W>,
        taken: &mut TakenStep<M, T>,
        found: Suspicion,
    ) -> Result<(Option<First>, Certainty), Fault> {
        self.refine(run, taken);
        let mut places = [CrossingTime::NOWHERE; MAX_GUARDS];
        let mut certainty = found.certainty;
        let specs = self.model.guards(self.mode);
        for (index, spec) in specs.iter().enumerate().take(MAX_GUARDS) {
            if found.candidates & (1 << index) == 0 {
                continue;
            }
            let mut span = self.guards[index].span(*spec, taken.h);
            if self.would_turn(run, (taken.end, taken.input), &span) {
                span.stand = Stand::Sinking;
            }
            let (place, is_sure) = if span.may_cross() {
                self.crossing_place(run, taken, &span)?
            } else {
                (CrossingTime::NOWHERE, false)
            };
            places[index] = place;
            if !is_sure && !span.is_first(place.tau) {
                certainty = Certainty::Unknown;
            }
        }
        let first = match specs {
            [only] => alone(only, places[0]),
            specs => earliest(specs, &places),
        };
        Ok((first, certainty))
    }

    fn would_turn<S, W>(
        &self,
        run: &mut TickRun<'_, S, W>,
        (x, input): (M::State, M::Input),
        span: &GuardSpan,
    ) -> bool {
        let sinks = span.end.value < -span.spec.band() && span.end.rate < 0.0;
        if span.stand != Stand::Spent || !sinks || !run.spend_guards(1) {
            return false;
        }
        let reset = self.model.reset(self.mode, span.spec.id, &x, &input);
        let after = self.model.guard(self.mode, span.spec.id, &reset.state, &input);
        reset.mode != self.mode || after.rate >= 0.0
    }

    #[inline]
    pub(super) fn refine<S: Signal<M::Input>, W>(
        &self,
        run: &mut TickRun<'_, S, W>,
        taken: &mut TakenStep<M, T>,
    ) {
        if taken.is_refined || T::REFINEMENT == 0 {
            return;
        }
        taken.is_refined = true;
        let mode_step = ModeStep {
            model: &self.model,
            stepper: &self.stepper,
            mode: self.mode,
            signal: run.signal,
            theta: (run.theta, taken.theta_end),
            input: run.input(),
            excess: 1.0,
            h: taken.h,
            rest: taken.h,
            longest: taken.h,
        };
        mode_step.refine(&self.memory, &mut taken.step.dense, &mut run.work);
    }

    #[inline]
    fn crossing_place<S: Signal<M::Input>, W>(
        &self,
        run: &mut TickRun<'_, S, W>,
        taken: &TakenStep<M, T>,
        span: &GuardSpan,
    ) -> Result<(CrossingTime, bool), Fault> {
        let (dense, theta_end) = (&taken.step.dense, taken.theta_end);
        // The tolerance is a fraction of the tick; the step is a part of it.
        let tolerance = (run.limits.event_tolerance / (theta_end - run.theta)).min(0.5);
        if !run.affords_guards(GuardSpan::LOOKS + most_evaluations(tolerance)) {
            return Ok((CrossingTime::NOWHERE, false));
        }
        let (model, mode, signal, start) = (&self.model, self.mode, run.signal, run.theta);
        let (looks, is_finite) = (Cell::new(0), Cell::new(true));
        let guard = |tau: f64| {
            let input = signal.at(start + tau * (theta_end - start));
            let x = model.constrain(mode, &dense.at(tau), &input);
            model.guard(mode, span.spec.id, &x, &input).value
        };
        let counted = |tau: f64| {
            let value = guard(tau);
            looks.set(looks.get() + 1);
            is_finite.set(is_finite.get() && value.is_finite());
            value
        };
        let (crossing, is_sure) = span.crossing(counted);
        let place = match crossing {
            Crossing::None => CrossingTime::NOWHERE,
            Crossing::AtStart => CrossingTime { tau: 0.0, radius: 0.5 * tolerance },
            Crossing::Within { bracket, level, seed } => {
                let located = locate(|tau| guard(tau) - level, bracket, seed, tolerance);
                looks.set(looks.get() + located.evaluations);
                is_finite.set(is_finite.get() && !located.not_finite);
                let slope = seed.map_or(bracket.at_hi - bracket.at_lo, |(_, slope)| slope);
                let radius = 0.5 * tolerance + slack(&span.spec, slope);
                CrossingTime { tau: located.tau, radius }
            }
        };
        run.work.guards += looks.get();
        if is_finite.get() { Ok((place, is_sure)) } else { Err(Fault::Guard) }
    }
}

/// Returns the move of a crossing with `slope` (1/step) by rounding alone, in steps.
fn slack(spec: &GuardSpec, slope: f64) -> f64 {
    /// 1 ns at 1 ms, also for a touch without a slope.
    const MOST: f64 = 1.0 / 1_048_576.0;
    // A slope of zero gives infinity, or NaN without a band, and `min` takes the other.
    (spec.band() / slope.abs()).min(MOST)
}

#[inline]
fn alone(spec: &GuardSpec, place: CrossingTime) -> Option<First> {
    let mut crossed = GuardSet::EMPTY;
    crossed.insert(spec.id);
    place.tau.is_finite().then_some(First { index: 0, tau: place.tau, crossed })
}

/// Returns the crossing of lowest priority among the indistinguishably earliest, in any order.
fn earliest(specs: &[GuardSpec], places: &[CrossingTime; MAX_GUARDS]) -> Option<First> {
    let limit = specs
        .iter()
        .zip(places)
        .map(|(_, place)| place.tau + place.radius)
        .fold(f64::INFINITY, f64::min);
    if limit.is_infinite() {
        return None;
    }
    let meets = |place: &CrossingTime| place.tau - place.radius <= limit;
    let mut crossed = GuardSet::EMPTY;
    for (spec, _) in specs.iter().zip(places).filter(|(_, place)| meets(place)) {
        crossed.insert(spec.id);
    }
    let simultaneous = specs.iter().zip(places).enumerate().filter(|(_, (_, place))| meets(place));
    simultaneous
        .min_by_key(|(_, (spec, _))| (spec.priority, spec.id.0))
        .map(|(index, (_, place))| First { index, tau: place.tau, crossed })
}
