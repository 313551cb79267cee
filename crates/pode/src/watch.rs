//! Observers of a simulation: a log, a plot, an audit.

use crate::dense::Dense;
use crate::guard::GuardSpec;
use crate::input::Signal;
use crate::model::{Guarded, Model};
use crate::outcome::Tick;
use crate::state::State as _;
use crate::stepper::PowerRule;

/// A stretch of one tick in one mode, with its dense output.
#[derive(Debug)]
pub struct Piece<'a, M: Model, S> {
    pub mode: M::Mode,
    /// Dense output over the whole step; the piece is its first part.
    pub dense: &'a dyn Dense<M::State>,
    /// Length of the whole step (s).
    pub h: f64,
    /// Kept fraction of the step, 0 ..= 1.
    pub tau: f64,
    pub start: M::State,
    pub end: M::State,
    pub inputs: [M::Input; 2],
    pub(crate) middle: Option<(M::State, M::Input)>,
    pub(crate) powers: PowerRule,
    /// Begin of the piece within its tick, and end of the whole step.
    pub theta: (f64, f64),
    pub tick: u64,
    pub signal: &'a S,
}

impl<M: Guarded, S: Signal<M::Input>> Piece<'_, M, S> {
    /// Returns state and input at the fraction `part` of the piece, 0 ..= 1.
    #[inline]
    pub fn at(&self, part: f64) -> (M::State, M::Input) {
        self.at_in(self.dense, part)
    }

    /// Like [`Self::at`], by the typed dense output, which costs no call.
    #[inline]
    pub(crate) fn at_in<D: Dense<M::State> + ?Sized>(
        &self,
        dense: &D,
        part: f64,
    ) -> (M::State, M::Input) {
        let tau = part * self.tau;
        (dense.at(tau), self.signal.at(self.theta_at(tau)))
    }

    /// Returns state, with slaved entries in place, and input in the middle of the piece.
    #[inline]
    pub fn middle(&self, model: &M) -> (M::State, M::Input) {
        self.middle.unwrap_or_else(|| {
            let (x, input) = self.at(0.5);
            (model.constrain(self.mode, &x, &input), input)
        })
    }

    /// Returns the length of the piece (s).
    #[inline]
    pub fn duration(&self) -> f64 {
        self.tau * self.h
    }

    /// Returns the times (s) of the piece's begin and end, where all ticks have the length `h` (s).
    pub fn times(&self, h: f64) -> [f64; 2] {
        [self.theta.0, self.theta_end()].map(|theta| (self.tick as f64 + theta) * h)
    }

    /// Returns the end of the piece within its tick, 0 ..= 1.
    pub fn theta_end(&self) -> f64 {
        self.theta_at(self.tau)
    }

    /// Returns θ at the fraction `tau` of the whole step, equal to the simulator's to the bit.
    #[inline]
    fn theta_at(&self, tau: f64) -> f64 {
        let (start, end) = self.theta;
        if tau < 1.0 { start + tau * (end - start) } else { end }
    }
}

/// Cause of an event.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum EventCause<'a> {
    Guard(&'a GuardSpec),
    /// Impacts of a declared Zeno sequence: their number in one move.
    Impacts(f64),
    Settled,
}

impl EventCause<'_> {
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Guard(spec) => spec.name,
            Self::Impacts(_) => "impacts",
            Self::Settled => "settled",
        }
    }
}

/// A transition, with the effect of its reset map.
#[derive(Debug)]
pub struct Event<'a, M: Model> {
    pub tick: u64,
    /// Place in the tick, 0 ..= 1.
    pub theta: f64,
    pub cause: EventCause<'a>,
    pub before: (M::Mode, M::State),
    pub after: (M::Mode, M::State),
    pub input: M::Input,
    /// Impulse on the input's driver (readout × s).
    pub impulse: f64,
    /// Error of its time on the computed orbit (s): the located width, or an open sequence's end.
    pub error: f64,
    /// Largest distance by which a coordinate was moved onto the constraint of the next mode.
    pub projection: f64,
}

impl<M: Model> Event<'_, M> {
    /// Returns the time (s) of the event, where all ticks have the length `h` (s).
    pub fn time(&self, h: f64) -> f64 {
        (self.tick as f64 + self.theta) * h
    }
}

impl<M: Guarded> Event<'_, M> {
    /// Returns the coordinate that moved farthest, and how far, where the guard fired well below
    /// zero: where the input jumped through it.
    pub fn leap(&self, model: &M) -> Option<(usize, f64)> {
        let EventCause::Guard(spec) = self.cause else { return None };
        let ((mode, before), (_, after)) = (&self.before, &self.after);
        let moves = before.entries().iter().zip(after.entries()).map(|(is, was)| (is - was).abs());
        let moves = moves.take(model.coordinates()).enumerate();
        let farthest =
            moves.max_by(|(_, a), (_, b)| a.total_cmp(b)).filter(|(_, far)| *far > 0.0)?;
        let guard = model.guard(*mode, spec.id, before, &self.input);
        let located = spec.band() + guard.rate.abs() * self.error;
        (guard.value < -located).then_some(farthest)
    }
}

/// An observer of a simulation; all functions are optional.
pub trait Watch<M: Model> {
    /// `true` if pieces are evaluated inside: full dense order, at a cost for some methods.
    const LOOKS_INSIDE: bool = true;

    /// Observes an advanced piece, with its dense output.
    fn piece<S: Signal<M::Input>>(&mut self, _model: &M, _piece: &Piece<'_, M, S>) {}

    /// Observes a transition after its reset map.
    fn event(&mut self, _model: &M, _event: &Event<'_, M>) {}

    /// Observes a finished tick; [`Simulator::run`](crate::Simulator::run) calls it after each.
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

impl<M: Model, W: Watch<M>> Watch<M> for Option<W> {
    const LOOKS_INSIDE: bool = W::LOOKS_INSIDE;

    #[expect(clippy::inline_always, reason = "a call takes the piece through memory")]
    #[inline(always)]
    fn piece<S: Signal<M::Input>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        if let Some(watch) = self {
            watch.piece(model, piece);
        }
    }

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        if let Some(watch) = self {
            watch.event(model, event);
        }
    }

    fn tick(&mut self, model: &M, tick: &Tick) {
        if let Some(watch) = self {
            watch.tick(model, tick);
        }
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
