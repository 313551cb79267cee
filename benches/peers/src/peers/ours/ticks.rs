//! The tick of a key, repeated: `Simulator::advance` with a stepper.

use pode::stepper::Stepper;
use pode::{Advance, Event, EventCause, Guarded, Limits, Piece, Resets, Signal, Simulator, Watch};

use super::Ours;
use crate::log::Log;

struct OfTick<'a, I> {
    input: &'a I,
    tick: f64,
    h: f64,
}

impl<T, I: Fn(f64) -> T> Signal<T> for OfTick<'_, I> {
    #[inline]
    fn at(&self, theta: f64) -> T {
        (self.input)((self.tick + theta) * self.h)
    }
}

/// Writes events into the log, and with `INSIDE` the wanted states inside the steps.
struct Scribe<'a, const INSIDE: bool> {
    log: &'a mut Log,
    h: f64,
    failed: Result<(), String>,
}

impl<const N: usize, const INSIDE: bool, M> Watch<M> for Scribe<'_, INSIDE>
where
    M: Guarded<State = [f64; N]>,
{
    const LOOKS_INSIDE: bool = INSIDE;

    #[inline]
    fn piece<S: Signal<M::Input>>(&mut self, _model: &M, piece: &Piece<'_, M, S>) {
        let at = |theta: f64| (piece.tick as f64 + theta) * self.h;
        let (start, whole) = (at(piece.theta.0), at(piece.theta.1) - at(piece.theta.0));
        self.log.sample(at(piece.theta_end()), |t| piece.dense.at((t - start) / whole));
    }

    #[inline]
    fn event(&mut self, _model: &M, event: &Event<'_, M>) {
        let name = match event.cause {
            EventCause::Guard(spec) => spec.name,
            cause => cause.name(),
        };
        let t = (event.tick as f64 + event.theta) * self.h;
        let written = self.log.event(t, name);
        if self.failed.is_ok() {
            self.failed = written;
        }
    }
}

pub(super) fn run<const N: usize, M, I, T>(
    ours: &Ours<M, I>,
    method: (T, Limits),
    h: f64,
    t_end: f64,
    log: &mut Log,
) -> Result<(), String>
where
    M: Resets<State = [f64; N]> + Clone,
    I: Fn(f64) -> M::Input,
    T: Stepper,
{
    if log.wants_states() {
        follow::<true, N, M, I, T>(ours, method, h, t_end, log)
    } else {
        follow::<false, N, M, I, T>(ours, method, h, t_end, log)
    }
}

/// Like [`run`], with states inside the steps if `INSIDE`; like the peers it computes no force.
fn follow<const INSIDE: bool, const N: usize, M, I, T>(
    ours: &Ours<M, I>,
    (stepper, limits): (T, Limits),
    h: f64,
    t_end: f64,
    log: &mut Log,
) -> Result<(), String>
where
    M: Resets<State = [f64; N]> + Clone,
    I: Fn(f64) -> M::Input,
    T: Stepper,
{
    let (mode, state) = ours.start;
    let simulator = Simulator::new(ours.model.clone(), stepper, limits, mode, state);
    let mut simulator = simulator.without_readout();
    let mut scribe = Scribe::<INSIDE> { log, h, failed: Ok(()) };
    let mut evaluations = 0;
    let ticks = (0_u32..).map(f64::from).take_while(|tick| (tick + 0.5) * h < t_end);
    for tick in ticks {
        let signal = OfTick { input: &ours.input, tick, h };
        let done = simulator.advance(h, &signal, &mut scribe);
        evaluations += u64::from(done.work.derivatives);
        if done.advance != Advance::Completed {
            return Err(format!("tick {tick}: {:?}", done.advance));
        }
    }
    scribe.failed?;
    log.count(evaluations);
    Ok(())
}
