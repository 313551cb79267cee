//! Memory of Taylor's method before and after a step.

use crate::series::{Expansion, GuardSeries};
use crate::state::State;
use crate::stepper::{Control, EndDerivative, Memory};

/// The series of the present step, and the length of steps.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TaylorMemory<S> {
    pub(super) expansion: Expansion<S>,
    pub(super) substitute: Control<EndDerivative<S>>,
    stage: SeriesStage,
    /// Longest present step (s).
    reach: f64,
    /// Length of the last step that was not cut short (s); infinite before the first.
    scale: f64,
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum SeriesStage {
    Ahead,
    Expanded,
    Singular,
    /// It was taken along its series, over this fraction of the scale.
    Taken(f64),
}

impl<S: State> Default for TaylorMemory<S> {
    fn default() -> Self {
        Self {
            expansion: Expansion::EMPTY,
            substitute: Control::default(),
            stage: SeriesStage::Ahead,
            reach: f64::INFINITY,
            scale: f64::INFINITY,
        }
    }
}

impl<S: State> TaylorMemory<S> {
    /// Notes that the step was expanded, may be as long as the first of `reaches` (s), and has a
    /// series up to the second; or that it has no series.
    pub(super) fn expand(&mut self, reaches: Option<(f64, f64)>) {
        (self.stage, (self.reach, self.scale)) = match reaches {
            Some(reaches) => (SeriesStage::Expanded, reaches),
            None => (SeriesStage::Singular, (self.substitute.reach(), self.substitute.reach())),
        };
    }

    pub(super) const fn is_prepared(&self) -> bool {
        matches!(self.stage, SeriesStage::Expanded | SeriesStage::Singular)
    }

    /// Takes the step of `h` (s) along its series, if any; returns its fraction of the scale.
    pub(super) fn take(&mut self, h: f64) -> Option<f64> {
        let is_expanded = self.stage == SeriesStage::Expanded;
        let ratio = h / self.expansion.scale;
        self.stage = if is_expanded { SeriesStage::Taken(ratio) } else { SeriesStage::Ahead };
        is_expanded.then_some(ratio)
    }

    /// Notes that the step was taken otherwise, and the next one may be `reach` (s) long.
    pub(super) const fn follow(&mut self, reach: f64) {
        (self.reach, self.scale) = (reach, reach);
    }
}

impl<S: State> Memory for TaylorMemory<S> {
    #[inline]
    fn guards(&self) -> Option<GuardSeries<'_>> {
        let SeriesStage::Taken(ratio) = self.stage else { return None };
        Some(GuardSeries {
            terms: &self.expansion.guards,
            known: self.expansion.known_guards,
            order: self.expansion.order,
            ratio,
        })
    }

    #[inline]
    fn restart(&mut self) {
        self.stage = SeriesStage::Ahead;
        self.substitute.restart();
    }

    #[inline]
    fn begin_tick(&mut self) {
        self.substitute.begin_tick();
    }

    #[inline]
    fn reach(&self) -> f64 {
        self.reach
    }

    #[inline]
    fn scale(&self) -> f64 {
        self.scale
    }
}
