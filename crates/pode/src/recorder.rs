//! A watch that keeps events, samples and work, with times in seconds; for offline use: it grows.
#![expect(clippy::disallowed_methods, reason = "not for the tick: a record grows")]

use std::fmt::{self, Display, Formatter};
use std::vec::Vec;

use crate::input::Signal;
use crate::model::{Guarded, Model};
use crate::outcome::{Tick, Work};
use crate::watch::{Event, Piece, Watch};

/// An event with its time in seconds.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordedEvent<M: Model> {
    /// Time (s); late in a long run, its last digits are rounded.
    pub t: f64,
    /// Tick, and the place in it, 0 ..= 1: the time with all its digits.
    pub tick: u64,
    pub theta: f64,
    pub name: &'static str,
    pub from: M::Mode,
    pub to: M::Mode,
    pub before: M::State,
    pub after: M::State,
    pub input: M::Input,
    /// Impulse on what drives the input (readout × s).
    pub impulse: f64,
    /// Error of its time on the computed orbit (s).
    pub error: f64,
    /// Largest distance by which a coordinate was moved onto the constraint of the next mode.
    pub projection: f64,
}

impl<M: Model> Display for RecordedEvent<M> {
    /// As in `0.451523641 s  floor: true [0.0, -4.4] -> true [0.0, 3.5]`.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { t, name, from, to, before, after, .. } = self;
        write!(f, "{t:.9} s  {name}: {from:?} {before:?} -> {to:?} {after:?}")
    }
}

/// A row of samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample<M: Model> {
    /// Time (s).
    pub t: f64,
    pub mode: M::Mode,
    pub state: M::State,
    pub input: M::Input,
    pub readout: f64,
}

/// Keeps events, samples and work; used in `examples/bouncing_ball.rs`.
#[derive(Clone, Debug)]
pub struct RunRecorder<M: Model> {
    h: f64,
    /// Time (s) at which tick 0 would have begun, had all ticks had this length.
    origin: f64,
    /// Interval between two samples (s), if any are taken.
    every: Option<f64>,
    next_sample: u64,
    events: Vec<RecordedEvent<M>>,
    samples: Vec<Sample<M>>,
    ticks: Vec<Tick>,
}

impl<M: Guarded> RunRecorder<M> {
    /// Builds a recorder of events for ticks of `h` (s); tick 0 begins at the time 0.
    pub const fn new(h: f64) -> Self {
        Self {
            h,
            origin: 0.0,
            every: None,
            next_sample: 0,
            events: Vec::new(),
            samples: Vec::new(),
            ticks: Vec::new(),
        }
    }

    /// Returns the recorder, also taking samples from dense output at the multiples of `every` (s).
    ///
    /// At an event's time it samples the state before it. Times within a move over accumulating
    /// impacts, or held after a maximum was reached, have no sample.
    #[must_use]
    pub fn sampled(self, every: f64) -> Self {
        Self { every: Some(every).filter(|it| *it > 0.0), ..self }
    }

    /// Sets the begin (s) of `tick`, and the length `h` (s) from then on; recorded times stay.
    pub fn place_tick(&mut self, tick: u64, begin: f64, h: f64) {
        self.h = h;
        self.origin = begin - tick as f64 * h;
    }

    pub fn events(&self) -> &[RecordedEvent<M>] {
        &self.events
    }

    /// Returns the times of all events (s).
    pub fn times(&self) -> Vec<f64> {
        self.events.iter().map(|event| event.t).collect()
    }

    /// Returns the times (s) of the events of this `name`.
    pub fn times_of(&self, name: &str) -> Vec<f64> {
        let named = self.events.iter().filter(|event| event.name == name);
        named.map(|event| event.t).collect()
    }

    pub fn samples(&self) -> &[Sample<M>] {
        &self.samples
    }

    /// Returns the results of all ticks, from [`Simulator::run`](crate::Simulator::run) or, when
    /// advancing tick by tick, from the caller's [`Watch::tick`].
    pub fn ticks(&self) -> &[Tick] {
        &self.ticks
    }

    pub fn work(&self) -> Work {
        self.ticks.iter().fold(Work::default(), |sum, tick| sum.plus(tick.work))
    }

    /// Returns the impulse of all events together (readout × s).
    pub fn impulse(&self) -> f64 {
        self.events.iter().map(|event| event.impulse).sum()
    }

    /// Returns the time (s) at `theta` of `tick`.
    pub fn time(&self, tick: u64, theta: f64) -> f64 {
        self.origin + (tick as f64 + theta) * self.h
    }

    /// Takes the samples within a piece, without its start except for the very first piece.
    fn sample<S: Signal<M::Input>>(&mut self, every: f64, model: &M, piece: &Piece<'_, M, S>) {
        /// Fraction of a tick beyond the end in which a sample still belongs to it.
        const CRUMB: f64 = 1e-9;
        let start = self.time(piece.tick, piece.theta.0);
        let end = self.time(piece.tick, piece.theta_end());
        let crumb = CRUMB * self.h;
        if self.samples.is_empty() || (self.next_sample as f64) * every < start - crumb {
            // Skips samples before the first piece, or jumped over.
            let first = ((start - crumb) / every).ceil().max(0.0);
            #[expect(clippy::cast_possible_truncation, reason = "a count of samples")]
            #[expect(clippy::cast_sign_loss, reason = "not negative")]
            let first = first as u64;
            self.next_sample = first;
        }
        while self.next_sample as f64 * every <= end + crumb {
            let t = self.next_sample as f64 * every;
            let part =
                if end > start { ((t - start) / (end - start)).clamp(0.0, 1.0) } else { 1.0 };
            let (x, input) = piece.at(part);
            let state = model.constrain(piece.mode, &x, &input);
            let readout = model.readout(piece.mode, &state, &input);
            self.samples.push(Sample { t, mode: piece.mode, state, input, readout });
            self.next_sample += 1;
        }
    }
}

impl<M: Guarded> Watch<M> for RunRecorder<M> {
    fn piece<S: Signal<M::Input>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        if let Some(every) = self.every {
            self.sample(every, model, piece);
        }
    }

    fn event(&mut self, _model: &M, event: &Event<'_, M>) {
        self.events.push(RecordedEvent {
            t: self.time(event.tick, event.theta),
            tick: event.tick,
            theta: event.theta,
            name: event.cause.name(),
            from: event.before.0,
            to: event.after.0,
            before: event.before.1,
            after: event.after.1,
            input: event.input,
            impulse: event.impulse,
            error: event.error,
            projection: event.projection,
        });
    }

    fn tick(&mut self, _model: &M, tick: &Tick) {
        self.ticks.push(*tick);
    }
}
