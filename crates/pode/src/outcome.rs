//! All that an advance can report.

/// How a tick ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[must_use]
pub enum Advance {
    /// The whole tick was advanced.
    Completed,
    /// A declared maximum was reached: the state was held for the rest of the tick.
    Capped(Cap),
    /// The model or its input failed: the last finite state was kept.
    Faulty(Fault),
}

/// Which declared maximum was reached.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Cap {
    /// Events in one tick.
    Events,
    /// Transitions at one instant.
    Cascade,
    /// Guard evaluations in one tick.
    Guards,
    /// Pieces (steps and parts of steps) in one tick.
    Pieces,
}

/// Why the model could not be advanced.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    /// The period is not a positive, finite number.
    Period,
    /// The derivative or the state left the set of finite numbers.
    State,
    /// A guard left the set of finite numbers, or a mode has more than
    /// [`MAX_GUARDS`](crate::MAX_GUARDS) of them.
    Guard,
    /// The readout or an impulse left the set of finite numbers.
    Readout,
}

/// Evaluations that a tick took; independent of the machine.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Work {
    /// Steps and parts of steps.
    pub pieces: u32,
    /// Evaluations of the derivative, those for a Jacobian apart.
    pub derivatives: u32,
    /// Evaluations of the Jacobian.
    pub jacobians: u32,
    /// Evaluations of one guard each.
    pub guards: u32,
    /// Evaluations of the readout.
    pub readouts: u32,
    pub events: u32,
    /// Steps of which it is certain that they hide no pair of roots, see [`StepCertainty`].
    pub certified: u32,
    /// Steps of which it is likely.
    pub likely: u32,
    /// Steps of which nothing is known.
    pub unknown: u32,
}

/// Whether a step can hide a pair of roots of one guard: two crossings, of which the values at
/// the step's ends show nothing.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum StepCertainty {
    /// No: every guard has a bound on its curvature, and stays positive within it.
    Certified,
    /// Hardly: the step resolves the mode's fastest motion, so each guard is close to its
    /// cubic, and the true guard was looked at where the cubic is lowest.
    Likely,
    /// The mode's rates are not known, or the step is longer than they are.
    Unknown,
}

impl Work {
    /// Counts a step with this verdict.
    #[inline]
    pub(crate) const fn judge(&mut self, verdict: StepCertainty) {
        match verdict {
            StepCertainty::Certified => self.certified += 1,
            StepCertainty::Likely => self.likely += 1,
            StepCertainty::Unknown => self.unknown += 1,
        }
    }

    /// Sum of two counts.
    #[must_use]
    pub const fn plus(self, other: Self) -> Self {
        Self {
            pieces: self.pieces + other.pieces,
            derivatives: self.derivatives + other.derivatives,
            jacobians: self.jacobians + other.jacobians,
            guards: self.guards + other.guards,
            readouts: self.readouts + other.readouts,
            events: self.events + other.events,
            certified: self.certified + other.certified,
            likely: self.likely + other.likely,
            unknown: self.unknown + other.unknown,
        }
    }
}

/// What one tick gave.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tick {
    pub advance: Advance,
    /// The readout's mean over the tick, impulses included.
    pub mean_readout: f64,
    /// The readout at the end of the tick.
    pub end_readout: f64,
    /// Impulses alone (readout × s).
    pub impulse: f64,
    /// Largest local error that the stepper estimated; 0 if it has no estimate.
    pub local_error: f64,
    pub work: Work,
}
