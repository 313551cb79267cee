//! The contract of a tick: the most work of each kind.

use crate::quadrature::looks;
use crate::stepper::Stepper;

/// Declared maxima of one tick, and how finely events are located.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Limits {
    /// Events in one tick.
    pub events: u32,
    /// Transitions at one instant.
    pub cascade: u32,
    /// Events in one tick after which a declared Zeno sequence is taken in one move.
    pub followed: u32,
    /// Guard evaluations in one tick.
    pub guards: u32,
    /// Pieces (steps and parts of steps) in one tick.
    pub pieces: u32,
    /// Evaluations of derivatives and guards together in one tick.
    pub work: WorkLimit,
    /// Longest step (s), whatever the model allows.
    pub longest_step: f64,
    /// How much longer than the model asks for its steps are: 1 as it asks; 2 halves the work of a
    /// method with fixed steps, whose error at order `p` grows by 2ᵖ.
    pub stretch: f64,
    /// Whether what is known of the guards' future is used: guards that are far for certain are
    /// left alone, and a step ends just behind an event that is expected.
    pub forecast: bool,
    /// Width to which an event is bracketed, as a fraction of the tick.
    pub event_tolerance: f64,
}

/// Limit of the evaluations of derivatives and guards together in one tick; a search for a crossing
/// that was begun before is finished.
///
/// Unlike the other limits it follows from the time that a caller has, and may change between ticks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WorkLimit {
    /// Evaluations in the first quarter of a tick: a model that needs far too many steps is cut off
    /// there, and one with an impact is not.
    pub early: u32,
    /// Evaluations in the whole tick.
    pub most: u32,
}

impl WorkLimit {
    /// No limit.
    pub const NONE: Self = Self::of(u32::MAX);

    /// Returns one limit for the whole tick.
    pub const fn of(evaluations: u32) -> Self {
        Self { early: evaluations, most: evaluations }
    }

    /// Returns the evaluations that a tick may take until `theta` of it.
    pub(crate) fn until(self, theta: f64) -> u32 {
        const EARLY: f64 = 0.25;
        if theta < EARLY { self.early } else { self.most }
    }
}

impl Default for Limits {
    /// 64 events, 32 at one instant, and work that this allows; 2⁻⁴⁰ of a tick.
    ///
    /// A Newton's cradle of five balls whose pairs know nothing of each other fits in.
    /// [`Limits::reached`] says which limit to raise when a tick is capped.
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

/// What follows from the limits for a method: no tick does more, whatever the model does.
impl Limits {
    /// Most evaluations of the derivative in one tick with the method `T`, those for Jacobians
    /// apart: each piece is one step, that may be refined once.
    pub const fn most_derivatives<T: Stepper>(&self) -> u32 {
        self.pieces.saturating_mul(T::EVALUATIONS + T::REFINEMENT)
    }

    /// Most evaluations of the Jacobian in one tick with the method `T`.
    pub const fn most_jacobians<T: Stepper>(&self) -> u32 {
        self.pieces.saturating_mul(T::JACOBIANS)
    }

    /// Most evaluations of the readout in one tick with the method `T`: in each piece those
    /// inside and at its end; at the start of the tick and after each event; at its end; and
    /// for each two events one more, if they are an event and a move over impacts.
    pub const fn most_readouts<T: Stepper>(&self) -> u32 {
        let pieces = self.pieces.saturating_mul(1 + looks(T::DENSE));
        pieces.saturating_add(self.events).saturating_add(self.events / 2).saturating_add(2)
    }
}

/// 2⁻⁴⁰ of a tick: 1e-15 s at 1 ms. The dense output is a cubic, so finer location
/// costs a guard evaluation or two and no derivative.
const DEFAULT_EVENT_TOLERANCE: f64 = 1.0 / ((1_u64 << 40) as f64);
