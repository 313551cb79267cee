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
    /// Evaluations of derivatives and guards together, with the limit that was reached.
    Work(u32),
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
    /// An event moved a coordinate onto its constraint by more than
    /// [`Nature::longest_projection`](crate::Nature::longest_projection).
    Projection,
}

/// Evaluations that a tick took; independent of the machine.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Work {
    /// Steps and parts of steps.
    pub pieces: u32,
    /// Evaluations of the derivative, of each part on its own, those for a Jacobian apart.
    pub derivatives: u32,
    /// Rates of the state's entries in these evaluations: of a part only its own entries count.
    pub rates: u32,
    /// Evaluations of the Jacobian.
    pub jacobians: u32,
    /// Evaluations of one guard each.
    pub guards: u32,
    /// Evaluations of the readout.
    pub readouts: u32,
    pub events: u32,
    /// Events whose reset map left the guard that had fired below zero or falling from it, in the
    /// same mode: it does not fire again until it has been positive. A reset map with a wrong sign
    /// does so.
    pub ineffective: u32,
    /// Steps in which no root of a guard can have been missed: each guard is bounded, and the
    /// bound leaves no room for one on the orbit as it was computed.
    pub certain: u32,
    /// Steps of which that is not known.
    pub unknown: u32,
}

/// Whether a root of a guard can have been missed in a step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Certainty {
    Certain,
    Unknown,
}

impl Work {
    /// Returns the evaluations of derivatives and guards.
    #[inline]
    pub const fn evaluations(&self) -> u32 {
        self.derivatives.saturating_add(self.guards)
    }

    /// Counts a step that was kept, whole or up to its first event.
    #[inline]
    pub(crate) const fn judge(&mut self, certainty: Certainty) {
        match certainty {
            Certainty::Certain => self.certain += 1,
            Certainty::Unknown => self.unknown += 1,
        }
    }

    /// Sum of two counts.
    #[must_use]
    pub const fn plus(self, other: Self) -> Self {
        Self {
            pieces: self.pieces + other.pieces,
            derivatives: self.derivatives + other.derivatives,
            rates: self.rates + other.rates,
            jacobians: self.jacobians + other.jacobians,
            guards: self.guards + other.guards,
            readouts: self.readouts + other.readouts,
            events: self.events + other.events,
            ineffective: self.ineffective + other.ineffective,
            certain: self.certain + other.certain,
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
    /// How far an event moved a coordinate onto the constraint of the mode that it led to, at
    /// most, in the unit of that coordinate; 0 where nothing is slaved.
    pub projection: f64,
    pub work: Work,
}
