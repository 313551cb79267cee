use std::time::{Duration, Instant};

use pode::{Advance, EnergyAudit, Event, Fault, Limits, Model, Piece, Signal, Watch, Work};

use super::{job::RunJob, stepped::Stepped};
use crate::scenario::{ForceKind, Plan, Scenario, StateOf, Studied};

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct SeenEvent<M: Model> {
    /// Time of the event (s).
    pub(super) t: f64,
    pub(super) guard: &'static str,
    pub(super) to: M::Mode,
}

pub(super) type FoundSamples<S> = (S, f64);

/// Events, states at sample times and work of a run, for the judge.
#[derive(Clone, Debug)]
pub(super) struct ObservedRun<M: Model> {
    pub(super) events: Vec<SeenEvent<M>>,
    /// Last mode that was entered, and its time (s).
    pub(super) entered: Option<(f64, M::Mode)>,
    /// One per sample of the reference; `None` where no tick ended there.
    pub(super) samples: Vec<Option<FoundSamples<M::State>>>,
    pub(super) work: Vec<Work>,
    /// Time of each tick, in a run without a watch.
    pub(super) ticks: Vec<Duration>,
    /// Energy that the method generated (J).
    pub(super) residual: f64,
    /// Time (s) and cause of a fault or an exceeded limit.
    pub(super) trouble: Option<(f64, String)>,
}

pub(super) fn observe<S: Scenario>(job: &RunJob<'_, S>) -> ObservedRun<S::Model> {
    let mut log = EventRecorder::<S::Model>::new(job.tick);
    let mut samples = Samples::new(job.scenario, job.tick);
    let mut trouble = None;
    let mut simulator = job.simulator();
    for tick in 0..job.ticks() {
        let done = job.advance(&mut simulator, &mut log);
        samples.add(tick + 1, simulator.state(), [done.mean_readout, done.end_readout]);
        if trouble.is_none() {
            trouble = failure(done.advance, &job.limits).map(|why| (tick as f64 * job.tick, why));
        }
        if matches!(done.advance, Advance::Faulty(_)) {
            break;
        }
    }
    let (work, ticks) = work(job);
    ObservedRun {
        events: log.events,
        entered: log.entered,
        samples: samples.found,
        work,
        ticks,
        residual: log.audit.integration,
        trouble,
    }
}

fn work<S: Scenario>(job: &RunJob<'_, S>) -> (Vec<Work>, Vec<Duration>) {
    let mut simulator = job.simulator();
    let (mut work, mut ticks) = (Vec::new(), Vec::new());
    for _ in 0..job.ticks() {
        let began = Instant::now();
        let done = job.advance_alone(&mut simulator);
        ticks.push(began.elapsed());
        work.push(done.work);
        if matches!(done.advance, Advance::Faulty(_)) {
            break;
        }
    }
    (work, ticks)
}

fn failure(advance: Advance, limits: &Limits) -> Option<String> {
    Some(match advance {
        Advance::Completed => return None,
        Advance::Capped(cap) => limits.reached(cap).to_string(),
        Advance::Faulty(Fault::Period) => "the tick has no length".into(),
        Advance::Faulty(Fault::State) => "the state is not finite".into(),
        Advance::Faulty(Fault::Guard) => "a guard is not finite".into(),
        Advance::Faulty(Fault::Readout) => "the readout is not finite".into(),
        Advance::Faulty(Fault::Projection) => "an event moved the state too far".into(),
    })
}

struct EventRecorder<M: Model> {
    tick: f64,
    events: Vec<SeenEvent<M>>,
    entered: Option<(f64, M::Mode)>,
    audit: EnergyAudit,
}

impl<M: Model> EventRecorder<M> {
    fn new(tick: f64) -> Self {
        Self { tick, events: Vec::new(), entered: None, audit: EnergyAudit::default() }
    }
}

impl<M: Studied> Watch<Stepped<M>> for EventRecorder<M> {
    fn piece<S: Signal<M::Input>>(&mut self, model: &Stepped<M>, piece: &Piece<'_, Stepped<M>, S>) {
        self.audit.piece(model, piece);
    }

    fn event(&mut self, model: &Stepped<M>, event: &Event<'_, Stepped<M>>) {
        self.audit.event(model, event);
        let t = (event.tick as f64 + event.theta) * self.tick;
        let (from, to) = (event.before.0, event.after.0);
        self.events.push(SeenEvent { t, guard: event.cause.name(), to });
        if from != to {
            self.entered = Some((t, to));
        }
    }
}

struct Samples<S: Scenario + ?Sized> {
    felt: ForceKind,
    tick: f64,
    /// Number of the tick that ends at each sample, in their order.
    due: Vec<Option<u64>>,
    found: Vec<Option<FoundSamples<StateOf<S>>>>,
    impulse: f64,
    next: usize,
}

impl<S: Scenario> Samples<S> {
    fn new(scenario: &S, tick: f64) -> Self {
        let Plan { felt, .. } = scenario.plan();
        let samples = &scenario.reference().samples;
        let due = samples.iter().map(|sample| whole(sample.t / tick)).collect();
        Self { felt, tick, due, found: vec![None; samples.len()], impulse: 0.0, next: 0 }
    }

    /// Adds the sample after `ticks`, whose last had these mean and end values of the readout.
    fn add(&mut self, ticks: u64, state: &StateOf<S>, [mean, end]: [f64; 2]) {
        self.impulse += mean * self.tick;
        while let Some(None) = self.due.get(self.next) {
            self.next += 1;
        }
        if self.due.get(self.next) == Some(&Some(ticks)) {
            let force = match self.felt {
                ForceKind::Readout => end,
                ForceKind::Impulse => self.impulse,
            };
            self.found[self.next] = Some((*state, force));
            self.next += 1;
        }
    }
}

/// Converts `ticks` to a whole number; `None` if it lies between two.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count of ticks")]
fn whole(ticks: f64) -> Option<u64> {
    ((ticks - ticks.round()).abs() < 1e-6).then(|| ticks.round() as u64)
}
