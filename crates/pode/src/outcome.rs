/// End of a tick.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[must_use]
pub enum Advance {
    Completed,
    /// A declared maximum was reached, and the state held for the rest of the tick.
    Capped(Cap),
    /// The model or its input failed, and the last finite state was kept.
    Faulty(Fault),
}

/// A declared maximum that was reached.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Cap {
    Events,
    Cascade,
    Guards,
    Pieces,
    /// Limit of derivatives and guards together.
    Work(u32),
}

/// Reason for which the model could not be advanced.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    Period,
    /// The derivative or the state is not finite.
    State,
    /// A guard is not finite, or a mode has more than [`MAX_GUARDS`](crate::MAX_GUARDS) of them.
    Guard,
    /// The readout or an impulse is not finite.
    Readout,
    /// An event moved a coordinate onto its constraint by more than
    /// [`Nature::longest_projection`](crate::Nature::longest_projection).
    Projection,
}

/// Evaluations of a tick; independent of the machine.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Work {
    pub pieces: u32,
    /// Evaluations of the derivative, of each part on its own, without those for a Jacobian.
    pub derivatives: u32,
    /// Rates of the state's entries in these evaluations: for a part only its own entries.
    pub rates: u32,
    pub jacobians: u32,
    pub guards: u32,
    pub readouts: u32,
    pub events: u32,
    /// Events with a reset map, perhaps of the wrong sign, that left the fired guard below zero or
    /// falling from it in the same mode: it does not fire again until it has been positive.
    pub ineffective: u32,
    /// Steps in which no root of a guard can have been missed on the computed orbit.
    pub certain: u32,
    pub unknown: u32,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Certainty {
    Certain,
    Unknown,
}

impl Work {
    #[inline]
    pub const fn evaluations(&self) -> u32 {
        self.derivatives.saturating_add(self.guards)
    }

    #[inline]
    pub(crate) const fn judge(&mut self, certainty: Certainty) {
        match certainty {
            Certainty::Certain => self.certain += 1,
            Certainty::Unknown => self.unknown += 1,
        }
    }

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

/// Result of one tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tick {
    pub advance: Advance,
    /// Mean of the readout over the tick, impulses included.
    pub mean_readout: f64,
    pub end_readout: f64,
    /// Impulses alone (readout × s).
    pub impulse: f64,
    /// Largest local error by the stepper's estimate; 0 if it has none.
    pub local_error: f64,
    /// Largest move of a coordinate by an event onto the next constraint, in its unit; else 0.
    pub projection: f64,
    pub work: Work,
}
