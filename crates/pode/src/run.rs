//! What is summed up over one tick.

use crate::guard::GuardSet;
use crate::input::Signal;
use crate::limits::Limits;
use crate::outcome::{Advance, Cap, Fault, Tick, Work};

#[derive(Debug)]
pub(crate) struct TickRun<'a, S, W> {
    /// Length of the tick (s).
    pub(crate) h: f64,
    pub(crate) signal: &'a S,
    pub(crate) watch: &'a mut W,
    pub(crate) limits: Limits,
    /// How far the tick has been advanced, 0 ..= 1.
    pub(crate) theta: f64,
    pub(crate) work: Work,
    /// Transitions since time last moved.
    pub(crate) cascade: u32,
    /// Width (s) to which an event at the present instant was located, or 0.
    pub(crate) since_event: f64,
    /// Guards that have crossed at the present instant and have not fired yet.
    pub(crate) due: GuardSet,
    /// Whether a step was made to end behind an expected event, since the last event.
    pub(crate) has_aimed: bool,
    /// ∫ readout dt so far, without impulses.
    pub(crate) integral: f64,
    pub(crate) impulse: f64,
    pub(crate) readout: Option<f64>,
    pub(crate) errors: TickErrors,
    pub(crate) advance: Advance,
}

/// The largest errors of a tick so far.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct TickErrors {
    /// Estimate of an entry's error in one step, in the unit of the entry.
    pub(crate) local: f64,
    pub(crate) projection: f64,
}

impl<'a, S, W> TickRun<'a, S, W> {
    pub(crate) fn new(h: f64, signal: &'a S, watch: &'a mut W, limits: Limits) -> Self {
        Self {
            h,
            signal,
            watch,
            limits,
            theta: 0.0,
            work: Work::default(),
            cascade: 0,
            since_event: 0.0,
            due: GuardSet::EMPTY,
            has_aimed: false,
            integral: 0.0,
            impulse: 0.0,
            readout: None,
            errors: TickErrors::default(),
            advance: Advance::Completed,
        }
    }

    pub(crate) fn is_going(&self) -> bool {
        self.advance == Advance::Completed && self.theta < 1.0
    }

    pub(crate) fn input<I>(&self) -> I
    where
        S: Signal<I>,
    {
        self.signal.at(self.theta)
    }

    /// The width to which events are located, in time (s).
    pub(crate) fn resolution(&self) -> f64 {
        self.limits.event_tolerance * self.h
    }

    /// How much of the tick is left (s).
    pub(crate) fn rest(&self) -> f64 {
        (1.0 - self.theta) * self.h
    }

    /// Moves to `theta`; what happened at the instant before is over.
    #[inline]
    pub(crate) fn move_to(&mut self, theta: f64) {
        if theta > self.theta {
            self.theta = theta;
            self.cascade = 0;
        }
        self.since_event = 0.0;
        self.due = GuardSet::EMPTY;
    }

    pub(crate) fn cap(&mut self, cap: Cap) {
        self.advance = Advance::Capped(cap);
    }

    /// The maximum that one more event would exceed.
    pub(crate) const fn most_events(&self) -> Option<Cap> {
        if self.cascade >= self.limits.cascade {
            Some(Cap::Cascade)
        } else if self.work.events >= self.limits.events {
            Some(Cap::Events)
        } else {
            None
        }
    }

    pub(crate) fn fail(&mut self, fault: Fault) {
        self.advance = Advance::Faulty(fault);
    }

    /// Whether the tick has `n` more guard evaluations; caps it if not.
    #[inline]
    pub(crate) fn affords_guards(&mut self, n: u32) -> bool {
        let affords = n <= self.limits.guards.saturating_sub(self.work.guards);
        if !affords {
            self.cap(Cap::Guards);
        }
        // What a search may take at most is far more than it takes.
        affords && self.affords_work(1)
    }

    /// Whether the tick has `n` more evaluations; caps it if not.
    #[inline]
    pub(crate) fn affords_work(&mut self, n: u32) -> bool {
        let limit = self.limits.work.until(self.theta);
        let affords = n <= limit.saturating_sub(self.work.evaluations());
        if !affords {
            self.cap(Cap::Work(limit));
        }
        affords
    }

    /// Counts `n` guard evaluations ahead; `false` when the tick has no more of them.
    #[inline]
    pub(crate) fn spend_guards(&mut self, n: u32) -> bool {
        let affords = self.affords_guards(n);
        if affords {
            self.work.guards += n;
        }
        affords
    }

    pub(crate) fn into_tick(self, end_readout: f64) -> Tick {
        // What was not advanced is held: the readout stays where it was.
        let held = (1.0 - self.theta) * end_readout;
        let moved = self.integral + self.impulse;
        // No division where nothing moved: there the period itself may be at fault.
        let mean_readout = if moved == 0.0 { held } else { held + moved / self.h };
        Tick {
            advance: self.advance,
            mean_readout,
            end_readout,
            impulse: self.impulse,
            local_error: self.errors.local,
            projection: self.errors.projection,
            work: self.work,
        }
    }
}
