//! The range of a rig: a spring, a dashpot and a mass are raised until the key shakes.
//!
//! ```text
//! raise     one of them, with its value; a pulse of the motor sets the key in motion. If it comes
//!           to rest, the value is multiplied by 1.25
//! let go    otherwise: no force from that exchange on, until the key is at rest
//! place     a soft spring returns it to the middle of its dip, for a spring
//! confirm   the value before, by the same pulse; if the key shakes again, the one before that
//! ```
//!
//! A constant push that carries the key's weight, and the spring, hold the key in the middle of its
//! dip without a hand. A finger on the key takes energy and raises the stable values.

mod object;
#[cfg(test)]
mod tests;
mod tried_value;

use haptics::{AnyEstimator, EnergyBound, Estimator as _, PassivityObserver};

use self::tried_value::{KeyResponse, TriedValue};
use super::{CalibrationFault, Next, Rested, Travelled, key_push::KeyPush};

pub use object::RangedObject;

/// Largest force (N).
pub const MOST_FORCE: f64 = 8.0;
/// Ratio of successive values (1).
pub const STEP: f64 = 1.25;
/// Pulse that sets the key in motion (N), and its length (s).
const PULSE: (f64, f64) = (2.0, 8e-3);
/// Time at rest after which a key has been let go (s).
const LET_GO: f64 = 0.2;

/// Conditions of rendering during a range: time between exchanges (s), and largest force (N).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RangeTerms {
    pub period: f64,
    pub limit: f64,
    pub estimator: AnyEstimator,
}

/// End of an object's rise, with the value at which it occurred.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum RangeEnd {
    /// The key did not come to rest, or returned more energy than it received.
    Shook(f64),
    /// It needed more than the largest force.
    ForceLimit(f64),
    /// The largest tried value passed.
    Highest,
}

/// Result of one object.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RangeFound {
    pub object: RangedObject,
    /// Largest value with which the key came to rest, twice if the rise ended; `None` if it shook.
    pub good: Option<f64>,
    pub end: RangeEnd,
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum RangePhase {
    Trying(TriedValue),
    LettingGo,
    Placing(TriedValue),
}

/// The measurement of one object on one key.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RangeMeasurement {
    object: RangedObject,
    terms: RangeTerms,
    key: KeyPush,
    /// Middle and length of the key's travel (m), and the push under which it floats (N).
    middle: f64,
    dip: f64,
    float: f64,
    phase: RangePhase,
    value: f64,
    end: Option<RangeEnd>,
    observer: PassivityObserver,
    /// Time of the last position (s), and number of periods since.
    last: Option<f64>,
    tick: u64,
}

impl RangeMeasurement {
    pub fn new(
        object: RangedObject,
        terms: RangeTerms,
        rested: &Rested,
        travelled: &Travelled,
    ) -> Self {
        let dip = travelled.bottom - rested.position;
        let bound = EnergyBound::of_force_limit(terms.limit, dip);
        Self {
            object,
            key: KeyPush::new(rested.position, rested.spread),
            middle: rested.position + 0.5 * dip,
            dip,
            float: travelled.float,
            phase: RangePhase::Trying(TriedValue::default()),
            value: object.first(),
            end: None,
            observer: PassivityObserver::new(bound, terms.period),
            last: None,
            tick: 0,
            terms,
        }
    }

    /// Returns `true` if the key shook, and feels no force until it is at rest.
    pub fn is_letting_go(&self) -> bool {
        self.phase == RangePhase::LettingGo
    }

    /// Processes the key's position at `t` (s, m); returns the next push, or the result.
    ///
    /// # Errors
    /// The readings are not those of a key, or the key does not come to rest.
    pub fn advance(&mut self, t: f64, position: f64) -> Result<Next<RangeFound>, CalibrationFault> {
        let elapsed = self.elapse(t, position);
        self.key.update(t, position)?;
        let motion = self.terms.estimator.update(position, elapsed);
        let is_passive = self.observer.is_passive(self.tick, position);
        let (RangePhase::Trying(mut tried) | RangePhase::Placing(mut tried)) = self.phase else {
            return Ok(self.let_go());
        };
        let wanted = self.object.push(self.rendered(), &motion, self.middle);
        let verdict = tried.advance(t, position, self.dip);
        if self.terms.limit < wanted.abs() {
            tried.limit(elapsed);
        }
        if !is_passive || verdict == KeyResponse::Shakes {
            return Ok(self.lower(RangeEnd::Shook(self.value)));
        }
        let push = self.push(wanted, t, position, &tried);
        let found = match (verdict, &mut self.phase) {
            (KeyResponse::Moves, RangePhase::Trying(it) | RangePhase::Placing(it)) => {
                *it = tried;
                None
            }
            (KeyResponse::Rests, RangePhase::Trying(_)) if tried.is_limited() => {
                return Ok(self.lower(RangeEnd::ForceLimit(self.value)));
            }
            (KeyResponse::Rests, RangePhase::Trying(_)) => self.raise(),
            (KeyResponse::Rests, RangePhase::Placing(_)) => {
                self.begin(self.value);
                None
            }
            (_, RangePhase::LettingGo) | (KeyResponse::Shakes, _) => None,
        };
        Ok(found.map_or(Next::Push(push), Next::Done))
    }

    /// Returns the rendered value: while the key is placed, for at most 1/4 of the largest force.
    fn rendered(&self) -> f64 {
        match (self.phase, self.object) {
            (RangePhase::Placing(_), RangedObject::Spring) => {
                self.value.min(0.5 * self.terms.limit / self.dip)
            }
            (RangePhase::Placing(_) | RangePhase::Trying(_) | RangePhase::LettingGo, _) => {
                self.value
            }
        }
    }

    /// Counts the periods since the last position; returns their time (s).
    fn elapse(&mut self, t: f64, position: f64) -> f64 {
        let Some(last) = self.last.replace(t) else {
            self.terms.estimator.reset(position);
            return self.terms.period;
        };
        let periods = ((t - last) / self.terms.period).round().max(1.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
        let whole = periods as u64;
        self.tick += whole;
        periods * self.terms.period
    }

    /// Returns the push on the key (N): the object's, against its weight, and the pulse.
    fn push(&mut self, wanted: f64, t: f64, position: f64, tried: &TriedValue) -> f64 {
        let limit = self.terms.limit;
        let held = wanted.clamp(-limit, limit);
        self.observer.hold(self.tick, position, -held);
        let (force, length) = PULSE;
        let has_pulse = matches!(self.phase, RangePhase::Trying(_)) && tried.age(t) < length;
        let pulse = if has_pulse { force.copysign(self.middle - tried.began_at()) } else { 0.0 };
        (held + self.float + pulse).clamp(-limit, limit)
    }

    fn raise(&mut self) -> Option<RangeFound> {
        let next = self.value * STEP;
        if self.end.is_some() || self.object.most() < next {
            let end = self.end.unwrap_or(RangeEnd::Highest);
            return Some(RangeFound { object: self.object, good: Some(self.value), end });
        }
        self.begin(next);
        None
    }

    /// Removes the force, and continues with the value before, which must be confirmed.
    fn lower(&mut self, end: RangeEnd) -> Next<RangeFound> {
        self.end = Some(end);
        self.phase = RangePhase::LettingGo;
        Next::Push(0.0)
    }

    fn let_go(&mut self) -> Next<RangeFound> {
        if LET_GO <= self.key.still_for() {
            let lower = self.value / STEP;
            if lower < 0.99 * self.object.first() {
                let end = self.end.unwrap_or(RangeEnd::Highest);
                return Next::Done(RangeFound { object: self.object, good: None, end });
            }
            self.begin(lower);
            self.phase = RangePhase::Placing(TriedValue::default());
        }
        Next::Push(0.0)
    }

    fn begin(&mut self, value: f64) {
        self.value = value;
        self.phase = RangePhase::Trying(TriedValue::default());
        self.observer.reset();
    }
}
