//! Runs all ticks, with the energy audit and the files.

use instruments::{Described, Playable};
use pode::stepper::{Any, ByNeed, Choice};
use pode::{
    Advance, Cap, EnergyAudit, Event, EventCause, Motion, Nature, Piece, Signal, Simulator,
};
use pode::{State as _, Tick, Watch};

use super::check::{Start, TickClock};
use super::error::SimulateError;
use super::input::{InputSignal, is_finite};
use super::mode::mode_name;
use super::output::OutputFiles;
use super::summary::{Capped, GuardLeap, RunCounts, RunFailure, RunMoves, SimulationReport};

/// Runs a model with the method of the clock, and reports the choices of `by-need`.
pub(super) fn run<M: Playable>(
    start: &Start<M>,
    plan: (&TickClock, &InputSignal),
    files: &mut OutputFiles,
) -> Result<SimulationReport, SimulateError> {
    let TickClock { method, step, .. } = *plan.0;
    let report = drive(start, plan, files)?;
    Ok(if let Any::ByNeed(by_need) = method {
        let mut all = choices(&by_need, &start.model, step);
        for (name, choice) in &report.choices {
            match all.iter_mut().find(|it| it.0 == *name) {
                Some(known) => known.1 = *choice,
                None => all.push((name.clone(), *choice)),
            }
        }
        SimulationReport { choices: all, ..report }
    } else {
        SimulationReport { handed_on: handed_on(&method, &start.model), ..report }
    })
}

/// Returns modes with equations that `method` delegates to another, by its name.
fn handed_on<M: Playable>(method: &Any, model: &M) -> Vec<(&'static str, &'static str)> {
    let moves = model.modes().filter(|(mode, _)| !model.parts(*mode).is_empty());
    let taken = moves.map(|(mode, name)| (name, method.name_in(&model.nature(mode))));
    taken.filter(|(_, taken)| *taken != method.name()).collect()
}

fn choices<M: Playable>(by_need: &ByNeed, model: &M, step: f64) -> Vec<(String, Choice)> {
    let choice = |mode: M::Mode| chosen(by_need, &model.nature(mode), step);
    model.modes().map(|(mode, name)| (name.to_owned(), choice(mode))).collect()
}

fn chosen(by_need: &ByNeed, nature: &Nature, step: f64) -> Choice {
    let choice = by_need.choice(nature, nature.longest_step.min(step));
    Choice { step: choice.step.min(step), ..choice }
}

/// Advances a model from 0 to the clock's end, or to its first fault.
fn drive<M: Playable>(
    start: &Start<M>,
    (clock, input): (&TickClock, &InputSignal),
    files: &mut OutputFiles,
) -> Result<SimulationReport, SimulateError> {
    let Start { model, mode, state } = start;
    let (model, mode, state) = (model.clone(), *mode, *state);
    let audit = EnergyAudit::default();
    let last = (0.0, mode, state);
    let mut follower = Follower {
        model: model.clone(),
        clock,
        audit,
        scale: EnergyScale::default(),
        last,
        closed_form: (0.0, 0),
        leap: None,
        files,
        taken: Vec::new(),
    };
    let mut tally = RunTally::default();
    let simulator = Simulator::new(model, clock.method, clock.limits, mode, state);
    let mut simulator = simulator.with_tick(clock.first);
    if start.model.entry().input.is_empty() {
        simulator = simulator.without_readout();
    }
    follower.files.row(simulator.model(), 0.0, (mode, &state), &input.at(0.0), &audit)?;
    for tick in 0..clock.ticks {
        let signal = TickSignal { clock, input, tick };
        let done = simulator.advance(clock.length(tick), &signal, &mut follower);
        tally.add(&done);
        follower.files.check()?;
        if let Advance::Faulty(fault) = done.advance {
            let why = if is_driven(clock, input, tick) {
                RunFailure::Model(fault)
            } else {
                RunFailure::Input
            };
            tally.failure = Some(why);
            break;
        }
        let t = clock.time(tick, 1.0);
        let (mode, state) = (simulator.mode(), simulator.state());
        follower.last = (t, mode, *state);
        let audit = follower.audit;
        follower.files.row(simulator.model(), t, (mode, state), &signal.at(1.0), &audit)?;
        if !audit.residual().is_finite() {
            tally.failure = Some(RunFailure::Energy);
            break;
        }
    }
    let report = tally.report(clock, &follower);
    Ok(SimulationReport { held: input.held(clock.until), ..report })
}

struct TickSignal<'a> {
    clock: &'a TickClock,
    input: &'a InputSignal,
    tick: u64,
}

impl Signal<Motion> for TickSignal<'_> {
    fn at(&self, theta: f64) -> Motion {
        self.input.at(self.clock.time(self.tick, theta))
    }

    fn bound(&self, from: f64, to: f64) -> Option<Motion> {
        let [from, to] = [from, to].map(|theta| self.clock.time(self.tick, theta));
        self.input.bound(from, to)
    }
}

/// Returns `true` if the input was finite where a tick failed.
fn is_driven(clock: &TickClock, input: &InputSignal, tick: u64) -> bool {
    /// Number of points, close to every evaluation of any method in a tick without events.
    const PLACES: u32 = 64;
    let mut places = (0..=PLACES).map(|n| f64::from(n) / f64::from(PLACES));
    places.all(|theta| is_finite(&input.at(clock.time(tick, theta))))
}

/// Audits the energy of a tick, and forwards its pieces and events.
struct Follower<'a, M: Described> {
    model: M,
    clock: &'a TickClock,
    audit: EnergyAudit,
    scale: EnergyScale,
    /// Last good instant: t (s), mode, state.
    last: (f64, M::Mode, M::State),
    /// Impacts in one move short of their sequence's end, and sequences to their end.
    closed_form: (f64, u64),
    /// Farthest move of a coordinate by an event whose guard the input jumped through.
    leap: Option<GuardLeap>,
    files: &'a mut OutputFiles,
    /// Choice of `by-need` in each mode of the motion, where its step was shortest.
    taken: Vec<(M::Mode, Choice)>,
}

impl<M: Described> Follower<'_, M> {
    fn note_choice<S: Signal<Motion>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        let Any::ByNeed(by_need) = self.clock.method else { return };
        let nature = model.nature(piece.mode);
        let own = model.longest_step_at(piece.mode, &piece.start, &piece.inputs[0]);
        let choice = chosen(&by_need, &nature.faster(nature.excess(own)), self.clock.step);
        match self.taken.iter_mut().find(|it| it.0 == piece.mode) {
            Some(known) if choice.step < known.1.step => known.1 = choice,
            Some(_) => {}
            None => self.taken.push((piece.mode, choice)),
        }
    }
}

impl<M: Described> Watch<M> for Follower<'_, M> {
    fn piece<S: Signal<Motion>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        self.audit.piece(model, piece);
        let [start, end] = &piece.inputs;
        for (x, input) in [(piece.start, start), (piece.end, end)] {
            self.scale.see(model, (piece.mode, x), input, self.audit.stored);
        }
        self.note_choice(model, piece);
        let tick = piece.tick - self.clock.first;
        let t = self.clock.time(tick, piece.theta_end());
        self.last = (t, piece.mode, piece.end);
        let start = self.clock.time(tick, piece.theta.0);
        self.files.piece(model, (start, t), piece);
    }

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        self.audit.event(model, event);
        let t = self.clock.time(event.tick - self.clock.first, event.theta);
        self.last = (t, event.after.0, event.after.1);
        match event.cause {
            EventCause::Impacts(n) => self.closed_form.0 += n,
            EventCause::Settled => self.closed_form.1 += 1,
            EventCause::Guard(_) => {}
        }
        if let Some((entry, far)) = event.leap(model)
            && self.leap.is_none_or(|farthest| farthest.far < far)
        {
            self.leap = Some(GuardLeap { guard: event.cause.name(), t, entry, far });
        }
        self.files.event(model, t, event);
    }
}

/// Size of the energies of a run (J), against which its error is judged.
#[derive(Clone, Copy, Default, Debug)]
struct EnergyScale {
    kinetic: f64,
    /// Least and largest rise of the stored energy since the start.
    stored: (f64, f64),
}

impl EnergyScale {
    fn see<M: Described>(
        &mut self,
        model: &M,
        (mode, x): (M::Mode, M::State),
        input: &Motion,
        stored: f64,
    ) {
        let mut still = x;
        for speed in still.as_mut().iter_mut().skip(model.coordinates()) {
            *speed = 0.0;
        }
        let at_rest = model.energy(mode, &still, &Motion { rate: 0.0, ..*input });
        self.kinetic = self.kinetic.max(model.energy(mode, &x, input) - at_rest);
        self.stored = (self.stored.0.min(stored), self.stored.1.max(stored));
    }

    /// Returns the most that moved or was stored and released.
    const fn turned_over(&self) -> f64 {
        self.kinetic.max(self.stored.1 - self.stored.0)
    }
}

#[derive(Clone, Copy, Default)]
struct RunTally {
    counts: RunCounts,
    capped: Capped,
    projection: f64,
    failure: Option<RunFailure>,
}

impl RunTally {
    fn add(&mut self, tick: &Tick) {
        self.projection = self.projection.max(tick.projection);
        let RunCounts { ticks, steps, evaluations, events, ineffective_events, verdicts, .. } =
            &mut self.counts;
        *ineffective_events += u64::from(tick.work.ineffective);
        evaluations.rates += u64::from(tick.work.rates);
        *ticks += 1;
        *steps += u64::from(tick.work.pieces);
        evaluations.derivatives += u64::from(tick.work.derivatives);
        evaluations.jacobians += u64::from(tick.work.jacobians);
        evaluations.guards += u64::from(tick.work.guards);
        evaluations.readouts += u64::from(tick.work.readouts);
        *events += u64::from(tick.work.events);
        verdicts.certain += u64::from(tick.work.certain);
        verdicts.unknown += u64::from(tick.work.unknown);
        let Capped { events, cascade, guards, pieces } = &mut self.capped;
        match tick.advance {
            Advance::Capped(Cap::Events) => *events += 1,
            Advance::Capped(Cap::Cascade) => *cascade += 1,
            Advance::Capped(Cap::Guards) => *guards += 1,
            Advance::Capped(Cap::Pieces) => *pieces += 1,
            Advance::Capped(Cap::Work(_)) | Advance::Completed | Advance::Faulty(_) => {}
        }
    }

    fn report<M: Described>(
        self,
        clock: &TickClock,
        follower: &Follower<'_, M>,
    ) -> SimulationReport {
        let (t, mode, state) = &follower.last;
        let model = &follower.model;
        let entry = model.entry();
        let leap = follower.leap.map(|it| it.told(entry));
        let state = entry.states.iter().copied().zip(state.entries().iter().copied()).collect();
        SimulationReport {
            model: entry.name,
            method: clock.method.name(),
            step: clock.step,
            until: clock.until,
            counts: RunCounts {
                impacts_in_closed_form: follower.closed_form.0,
                settled: follower.closed_form.1,
                ..self.counts
            },
            capped: self.capped,
            t: *t,
            mode: mode_name(model, *mode),
            choices: follower
                .taken
                .iter()
                .map(|(mode, choice)| (mode_name(model, *mode), *choice))
                .collect(),
            handed_on: Vec::new(),
            moved: RunMoves {
                projection: self.projection,
                leap,
                energy: follower.scale.turned_over(),
            },
            state,
            audit: follower.audit,
            held: Vec::new(),
            failure: self.failure,
        }
    }
}
