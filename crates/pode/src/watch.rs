//! What follows a simulation: a log, a plot, an audit.

use crate::dense::Dense;
use crate::guard::GuardSpec;
use crate::input::Signal;
use crate::model::{Guarded, Model};
use crate::outcome::Tick;

/// A stretch of one tick in which one mode held, with its dense output.
#[derive(Debug)]
pub struct Piece<'a, M: Model, S> {
    /// Mode in which the piece was computed.
    pub mode: M::Mode,
    /// Dense output over the step of which this piece is the first part.
    pub dense: &'a dyn Dense<M::State>,
    /// Length of that whole step (s).
    pub h: f64,
    /// How much of the step was kept, 0 ..= 1.
    pub tau: f64,
    /// State at the start of the piece.
    pub start: M::State,
    /// State at the end of the piece.
    pub end: M::State,
    /// Input at both ends.
    pub inputs: [M::Input; 2],
    /// State and input in the middle, if the readout's mean took them.
    pub(crate) middle: Option<(M::State, M::Input)>,
    /// Where the piece begins within its tick, and where the whole step would end.
    pub theta: (f64, f64),
    pub tick: u64,
    /// The input over the tick.
    pub signal: &'a S,
}

impl<M: Guarded, S: Signal<M::Input>> Piece<'_, M, S> {
    /// State and input at the fraction `part` of the piece, 0 ..= 1.
    #[inline]
    pub fn at(&self, part: f64) -> (M::State, M::Input) {
        self.at_in(self.dense, part)
    }

    /// The same by the piece's dense output with its type, which costs no call.
    #[inline]
    pub(crate) fn at_in<D: Dense<M::State> + ?Sized>(
        &self,
        dense: &D,
        part: f64,
    ) -> (M::State, M::Input) {
        let tau = part * self.tau;
        (dense.at(tau), self.signal.at(self.theta_at(tau)))
    }

    /// State, with what is slaved in place, and input in the middle of the piece.
    #[inline]
    pub fn middle(&self, model: &M) -> (M::State, M::Input) {
        self.middle.unwrap_or_else(|| {
            let (x, input) = self.at(0.5);
            (model.constrain(self.mode, &x, &input), input)
        })
    }

    /// Length of the piece (s).
    #[inline]
    pub fn duration(&self) -> f64 {
        self.tau * self.h
    }

    /// Times (s) at which the piece begins and ends, where all ticks have the length `h` (s).
    pub fn times(&self, h: f64) -> [f64; 2] {
        [self.theta.0, self.theta_end()].map(|theta| (self.tick as f64 + theta) * h)
    }

    /// Where the piece ends within its tick, 0 ..= 1.
    pub fn theta_end(&self) -> f64 {
        self.theta_at(self.tau)
    }

    /// Where the fraction `tau` of the whole step is, to the bit where the simulator has it.
    #[inline]
    fn theta_at(&self, tau: f64) -> f64 {
        let (start, end) = self.theta;
        if tau < 1.0 { start + tau * (end - start) } else { end }
    }
}

/// Why an event happened.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum EventCause<'a> {
    Guard(&'a GuardSpec),
    /// Impacts of a declared Zeno sequence, this many in one move.
    Impacts(f64),
    /// A declared Zeno sequence came to its end.
    Settled,
}

impl EventCause<'_> {
    /// Its name in logs and files.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Guard(spec) => spec.name,
            Self::Impacts(_) => "impacts",
            Self::Settled => "settled",
        }
    }
}

/// A transition, with the reset map's effect.
#[derive(Debug)]
pub struct Event<'a, M: Model> {
    pub tick: u64,
    /// Where in the tick, 0 ..= 1.
    pub theta: f64,
    pub cause: EventCause<'a>,
    /// Mode and state before.
    pub before: (M::Mode, M::State),
    /// Mode and state after.
    pub after: (M::Mode, M::State),
    pub input: M::Input,
    /// Impulse on what drives the input (readout × s).
    pub impulse: f64,
    /// How far its time may be wrong on the orbit as it was computed (s): the width to which it
    /// was located, or what the impacts of a sequence leave open.
    pub error: f64,
    /// How far a coordinate was moved onto the constraint of the mode after it, at most.
    pub projection: f64,
}

impl<M: Model> Event<'_, M> {
    /// Time (s) of the event, where all ticks have the length `h` (s).
    pub fn time(&self, h: f64) -> f64 {
        (self.tick as f64 + self.theta) * h
    }
}

/// Follows a simulation; everything is optional.
pub trait Watch<M: Model> {
    /// Whether pieces are looked at between their ends: their dense output then has its full
    /// order, which costs some methods evaluations.
    const LOOKS_INSIDE: bool = true;

    /// A piece was advanced.
    fn piece<S: Signal<M::Input>>(&mut self, _model: &M, _piece: &Piece<'_, M, S>) {}

    /// Takes a transition that has happened.
    fn event(&mut self, _model: &M, _event: &Event<'_, M>) {}

    /// Takes what a tick gave; [`Simulator::run`](crate::Simulator::run) calls it after each.
    fn tick(&mut self, _model: &M, _tick: &Tick) {}
}

/// A watch that ignores everything.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl<M: Model> Watch<M> for Silent {
    const LOOKS_INSIDE: bool = false;
}

impl<M: Model, A: Watch<M>, B: Watch<M>> Watch<M> for (A, B) {
    const LOOKS_INSIDE: bool = A::LOOKS_INSIDE || B::LOOKS_INSIDE;

    #[expect(clippy::inline_always, reason = "a call takes the piece through memory")]
    #[inline(always)]
    fn piece<S: Signal<M::Input>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        self.0.piece(model, piece);
        self.1.piece(model, piece);
    }

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        self.0.event(model, event);
        self.1.event(model, event);
    }

    fn tick(&mut self, model: &M, tick: &Tick) {
        self.0.tick(model, tick);
        self.1.tick(model, tick);
    }
}

impl<M: Model, W: Watch<M>> Watch<M> for &mut W {
    const LOOKS_INSIDE: bool = W::LOOKS_INSIDE;

    #[expect(clippy::inline_always, reason = "a call takes the piece through memory")]
    #[inline(always)]
    fn piece<S: Signal<M::Input>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        (**self).piece(model, piece);
    }

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        (**self).event(model, event);
    }

    fn tick(&mut self, model: &M, tick: &Tick) {
        (**self).tick(model, tick);
    }
}
