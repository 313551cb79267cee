//! The first crossing of a step.

use core::cell::Cell;

use super::Simulator;
use super::field::ModeField;
use crate::crossing::{Crossing, Span};
use crate::dense::Dense as _;
use crate::guard::{GuardSet, GuardSpec, MAX_GUARDS};
use crate::input::Signal;
use crate::locate::{locate, most_evaluations};
use crate::model::Resets;
use crate::outcome::{Cap, Fault};
use crate::run::Run;
use crate::stepper::{Step, Stepper};

/// The first crossing of a step: which guard, where in the step, and who else is there.
#[derive(Clone, Copy)]
pub(super) struct First {
    pub(super) index: usize,
    pub(super) tau: f64,
    /// All guards that cross there, this one included.
    pub(super) crossed: GuardSet,
}

/// Where in the step a guard crosses: `tau` ± `radius`.
#[derive(Clone, Copy)]
struct Place {
    tau: f64,
    radius: f64,
}

impl Place {
    const NOWHERE: Self = Self { tau: f64::INFINITY, radius: 0.0 };
}

impl<M: Resets, T: Stepper> Simulator<M, T> {
    /// The earliest crossing within the step; ties go to the lower priority number.
    #[inline]
    pub(super) fn first_crossing<S: Signal<M::Input>, W>(
        &mut self,
        run: &mut Run<'_, S, W>,
        step: &mut Step<M::State, T::Dense<M::State>>,
        theta_end: f64,
    ) -> Result<Option<First>, Fault> {
        let specs = self.model.guards(self.mode);
        let end_input = run.signal.at(theta_end);
        let end_state = self.model.constrain(self.mode, step.dense.end(), &end_input);
        let h = (theta_end - run.theta) * run.h;
        let mut places = [Place::NOWHERE; MAX_GUARDS];
        let mut any = false;
        for (index, spec) in specs.iter().enumerate().take(MAX_GUARDS) {
            if !run.spend_guards(1) {
                return Ok(None);
            }
            let end = self.model.guard(self.mode, spec.id, &end_state, &end_input);
            if !end.value.is_finite() || !end.rate.is_finite() {
                return Err(Fault::Guard);
            }
            let (stand, start) = self.guards[index];
            self.guards[index].1 = end;
            let span = Span { spec, stand, start, end, h };
            if span.may_cross() {
                if !any {
                    self.refine(run, step, theta_end);
                }
                places[index] = self.crossing_place(run, step, theta_end, &span)?;
                any = true;
            }
        }
        Ok(if any { earliest(specs, &places) } else { None })
    }

    /// Has the stepper bring the step's dense output to its full order.
    #[inline]
    fn refine<S: Signal<M::Input>, W>(
        &self,
        run: &mut Run<'_, S, W>,
        step: &mut Step<M::State, T::Dense<M::State>>,
        theta_end: f64,
    ) {
        let span = theta_end - run.theta;
        let mut field = ModeField::new(&self.model, self.mode, run.signal, (run.theta, span));
        self.stepper.refine(&mut field, &mut step.dense, span * run.h);
        field.count(&mut run.work);
    }

    /// Where in the step one guard crosses, if it does.
    #[inline(never)]
    fn crossing_place<S: Signal<M::Input>, W>(
        &self,
        run: &mut Run<'_, S, W>,
        step: &Step<M::State, T::Dense<M::State>>,
        theta_end: f64,
        span: &Span<'_>,
    ) -> Result<Place, Fault> {
        // The tolerance is a fraction of the tick; the step is a part of it.
        let tolerance = (run.limits.event_tolerance / (theta_end - run.theta)).min(0.5);
        if !run.affords_guards(Span::LOOKS + most_evaluations(tolerance)) {
            run.cap(Cap::Guards);
            return Ok(Place::NOWHERE);
        }
        let (model, mode, signal, start) = (&self.model, self.mode, run.signal, run.theta);
        let looks = Cell::new(0);
        let mut guard = |tau: f64| {
            looks.set(looks.get() + 1);
            let input = signal.at(start + tau * (theta_end - start));
            let x = model.constrain(mode, &step.dense.at(tau), &input);
            model.guard(mode, span.spec.id, &x, &input).value
        };
        let place = match span.crossing(&mut guard) {
            Crossing::None => Ok(Place::NOWHERE),
            Crossing::AtStart => Ok(Place { tau: 0.0, radius: 0.5 * tolerance }),
            Crossing::Within { bracket, level, seed } => {
                let located = locate(|tau| guard(tau) - level, bracket, seed, tolerance);
                let slope = seed.map_or(bracket.at_hi - bracket.at_lo, |(_, slope)| slope);
                let radius = 0.5 * tolerance + slack(span.spec, slope);
                let place = Place { tau: located.tau, radius };
                if located.not_finite { Err(Fault::Guard) } else { Ok(place) }
            }
        };
        run.work.guards += looks.get();
        place
    }
}

/// How far rounding alone can move a crossing with `slope` [1/step], as a part of the step.
fn slack(spec: &GuardSpec, slope: f64) -> f64 {
    /// 1 ns at 1 ms; a touch without a slope is as sharp as that.
    const MOST: f64 = 1.0 / 1_048_576.0;
    // A slope of zero gives infinity, or NaN without a band, and `min` takes the other.
    (spec.band() / slope.abs()).min(MOST)
}

/// The earliest crossing; among those that cannot be told from it, the lowest priority.
///
/// Depends on the set of guards only, not on their order.
fn earliest(specs: &[GuardSpec], places: &[Place; MAX_GUARDS]) -> Option<First> {
    let limit = specs
        .iter()
        .zip(places)
        .map(|(_, place)| place.tau + place.radius)
        .fold(f64::INFINITY, f64::min);
    if limit.is_infinite() {
        return None;
    }
    let meets = |place: &Place| place.tau - place.radius <= limit;
    let mut crossed = GuardSet::EMPTY;
    for (spec, _) in specs.iter().zip(places).filter(|(_, place)| meets(place)) {
        crossed.insert(spec.id);
    }
    let simultaneous = specs.iter().zip(places).enumerate().filter(|(_, (_, place))| meets(place));
    simultaneous
        .min_by_key(|(_, (spec, _))| (spec.priority, spec.id.0))
        .map(|(index, (_, place))| First { index, tau: place.tau, crossed })
}
