//! The contract of a tick: a maximum of each kind of work.

use crate::quadrature::looks;
use crate::stepper::Stepper;

/// Declared maxima of one tick, and the tolerance of event location.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Limits {
    pub events: u32,
    /// Transitions at one instant.
    pub cascade: u32,
    /// Events in one tick after which a declared Zeno sequence is taken in one move.
    pub followed: u32,
    pub guards: u32,
    /// Pieces (steps and parts of steps) in one tick.
    pub pieces: u32,
    pub work: WorkLimit,
    /// Longest step (s); overrides longer steps of the model.
    pub longest_step: f64,
    /// Factor on the model's own steps; 2 halves the work with fixed steps, at 2ᵖ times the error.
    pub stretch: f64,
    /// `true` if forecasts are used: far guards are skipped, steps end behind predicted events.
    pub forecast: bool,
    /// Width to which an event is bracketed, as a fraction of the tick.
    pub event_tolerance: f64,
}

/// Limit of the derivatives and guards evaluated in one tick; a running search is finished.
///
/// Unlike the other limits it depends on the caller's time, and may change between ticks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WorkLimit {
    /// Evaluations in the first quarter of a tick: stops a model with far too many steps.
    pub early: u32,
    pub most: u32,
}

impl WorkLimit {
    pub const NONE: Self = Self::of(u32::MAX);

    pub const fn of(evaluations: u32) -> Self {
        Self { early: evaluations, most: evaluations }
    }

    pub(crate) fn until(self, theta: f64) -> u32 {
        const EARLY: f64 = 0.25;
        if theta < EARLY { self.early } else { self.most }
    }
}

impl Default for Limits {
    /// 64 events, 32 at one instant, and the work that these need; 2⁻⁴⁰ of a tick. A Newton's
    /// cradle of five balls, all pairs independent, fits in. [`Limits::reached`] names the limit to
    /// raise when a tick is capped.
    fn default() -> Self {
        Self {
            events: 64,
            cascade: 32,
            followed: 6,
            guards: 8192,
            pieces: 1024,
            work: WorkLimit::NONE,
            longest_step: f64::INFINITY,
            stretch: 1.0,
            forecast: true,
            event_tolerance: DEFAULT_EVENT_TOLERANCE,
        }
    }
}

impl Limits {
    /// Returns the maximum of derivatives in one tick with the method `T`, those for Jacobians
    /// apart: each piece is one step, refined at most once.
    pub const fn most_derivatives<T: Stepper>(&self) -> u32 {
        self.pieces.saturating_mul(T::EVALUATIONS + T::REFINEMENT)
    }

    pub const fn most_jacobians<T: Stepper>(&self) -> u32 {
        self.pieces.saturating_mul(T::JACOBIANS)
    }

    /// Returns the maximum of readouts in one tick with the method `T`: inside and at the end of
    /// each piece; at the start and end of the tick and after each event; and one more for each two
    /// events, if they are an event and a move over impacts.
    pub const fn most_readouts<T: Stepper>(&self) -> u32 {
        let pieces = self.pieces.saturating_mul(1 + looks(T::DENSE));
        pieces.saturating_add(self.events).saturating_add(self.events / 2).saturating_add(2)
    }
}

/// 2⁻⁴⁰ of a tick: 1e-15 s at 1 ms. Finer location costs one or two guard evaluations.
const DEFAULT_EVENT_TOLERANCE: f64 = 1.0 / ((1_u64 << 40) as f64);
