//! The error of a step on the stroke of the reference.

use instruments::SmallModel;
use pode::{Energetic as _, Motion};
use serde::Serialize;

use super::model_run::{Mode, ModelRun, RunEvent, mode_name, still};
use super::{closed_loop::STEP, located::located, sampled::SampledModel};
use crate::scenario::{ExpectedEvent, Reference, ReferenceSample, Scenario};

/// Method of stepping a model under a sampled input.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum StepKind {
    /// The paper's: input held, guards checked once a step.
    Paper,
    /// Input held, events located.
    Held,
    /// Input extrapolated by a straight line through the last two samples, events located.
    Linear,
    /// Input extrapolated by a parabola through the last three samples, events located.
    Quadratic,
    /// The true input inside the step, events located.
    Exact,
}

impl StepKind {
    /// All, from the worst to the best.
    pub const ALL: [Self; 5] =
        [Self::Paper, Self::Held, Self::Linear, Self::Quadratic, Self::Exact];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::Held => "held",
            Self::Linear => "linear",
            Self::Quadratic => "quadratic",
            Self::Exact => "exact",
        }
    }

    pub(super) const fn short(self) -> &'static str {
        match self {
            Self::Paper => "the paper's step",
            Self::Held => "located, input held",
            Self::Linear => "located, line through samples",
            Self::Quadratic => "located, parabola through samples",
            Self::Exact => "located, exact input",
        }
    }

    pub const fn title(self) -> &'static str {
        match self {
            Self::Paper => "the paper's step: input held, guards seen once a step",
            Self::Held => "input held, events located",
            Self::Linear => "input extrapolated by a line, events located",
            Self::Quadratic => "input extrapolated by a parabola, events located",
            Self::Exact => "exact input, events located",
        }
    }
}

/// Errors of a run of the reference's stroke.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct StepErrors {
    pub kind: StepKind,
    pub is_whole: bool,
    /// Time error of each event in order (s).
    pub events: Vec<f64>,
    /// Largest magnitude of `events` (s).
    pub event_largest: f64,
    /// Error of the force on the hand at each sample of the reference: time (s) and error (N).
    #[serde(skip)]
    pub forces: Vec<(f64, f64)>,
    /// Largest error of the force on the hand away from events (N).
    pub force_largest: f64,
    /// Root mean square of the force's error away from events (N).
    pub force_rms: f64,
    /// Largest error of the stored energy away from events (J).
    pub energy_largest: f64,
    /// Largest energy generated or lost without work of the hand (J).
    pub energy_made: f64,
}

/// Values of the reference with which runs are compared.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Truth {
    /// Model time (s) and guard of each event.
    pub events: Vec<(f64, String)>,
    /// Largest force on the hand at the samples (N).
    pub force_largest: f64,
    /// Largest stored energy at the samples, above that at the start (J).
    pub energy_largest: f64,
    #[serde(skip)]
    samples: Vec<TrueSample>,
}

#[derive(Clone, Copy, PartialEq, Debug)]
struct TrueSample {
    t: f64,
    force: f64,
    energy: f64,
}

pub(super) fn truth(scenario: &impl Scenario<Model = SmallModel>) -> Truth {
    let (model, first, state) = scenario.start();
    let reference: &Reference<SmallModel> = scenario.reference();
    let mode_at = |t: f64| -> Mode {
        let before = reference.events.iter().take_while(|event| event.t <= t);
        before.last().map_or(first, |event| event.to)
    };
    let sample = |it: &ReferenceSample<_>| TrueSample {
        t: it.t,
        force: it.force * model.input_per_metre(),
        energy: model.energy(mode_at(it.t), &it.state, &scenario.input(it.t)),
    };
    let samples: Vec<_> = reference.samples.iter().map(sample).collect();
    let rest = model.energy(first, &state, &still(0.0));
    let largest =
        |of: fn(&TrueSample) -> f64| samples.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
    Truth {
        events: reference.events.iter().map(|event| (event.t, event.guard.clone())).collect(),
        force_largest: largest(|it| it.force.abs()),
        energy_largest: largest(|it| it.energy) - rest,
        samples,
    }
}

pub(super) fn compare(
    scenario: &impl Scenario<Model = SmallModel>,
    truth: &Truth,
) -> Vec<StepErrors> {
    let (model, ..) = scenario.start();
    let ticks = steps(scenario.plan().until);
    let judged = |kind| {
        let run = run(kind, &model, ticks, |t| scenario.input(t));
        judge(kind, &run, scenario.reference(), truth, |mode| mode_name(&model, mode))
    };
    StepKind::ALL.map(judged).into()
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand")]
pub(super) fn steps(until: f64) -> usize {
    (until / STEP).round() as usize
}

fn run(
    kind: StepKind,
    model: &SmallModel,
    ticks: usize,
    input: impl Fn(f64) -> Motion,
) -> ModelRun {
    let sample = |tick: usize, back: f64| input((tick as f64 - back) * STEP).position;
    let span = (STEP, ticks);
    match kind {
        StepKind::Paper => {
            let mut sampled = SampledModel::new(model, STEP);
            for tick in 0..ticks {
                sampled.advance(sample(tick, 0.0));
            }
            sampled.finish()
        }
        StepKind::Held => located(model, span, |tick, _| still(sample(tick, 0.0))),
        StepKind::Linear => located(model, span, |tick, x| {
            let [now, before] = [0.0, 1.0].map(|back| sample(tick, back));
            let slope = now - before;
            Motion { rate: slope / STEP, ..still(now + x * slope) }
        }),
        StepKind::Quadratic => located(model, span, |tick, x| {
            let [now, before, first] = [0.0, 1.0, 2.0].map(|back| sample(tick, back));
            let slope = 0.5 * (3.0 * now - 4.0 * before + first);
            let bend = 0.5 * (now - 2.0 * before + first);
            let rate = (slope + 2.0 * x * bend) / STEP;
            Motion { rate, ..still(now + x * (slope + x * bend)) }
        }),
        StepKind::Exact => located(model, span, |tick, x| input((tick as f64 + x) * STEP)),
    }
}

fn judge(
    kind: StepKind,
    run: &ModelRun,
    reference: &Reference<SmallModel>,
    truth: &Truth,
    name: impl Fn(Mode) -> &'static str,
) -> StepErrors {
    let pairs = run.events.iter().zip(&reference.events);
    let is_right = |(found, right): &(&RunEvent, &ExpectedEvent<SmallModel>)| {
        found.guard == right.guard && found.to == name(right.to)
    };
    let events: Vec<_> =
        pairs.take_while(is_right).map(|(found, right)| found.t - right.t).collect();
    let is_whole =
        events.len() == reference.events.len() && run.events.len() == reference.events.len();
    let rows =
        truth.samples.iter().filter_map(|right| Some((right, run.rows.get(steps(right.t))?)));
    let forces: Vec<_> =
        rows.clone().map(|(right, row)| (right.t, row.f_ku - right.force)).collect();
    let squares = forces.iter().map(|it| it.1 * it.1).sum::<f64>();
    StepErrors {
        kind,
        is_whole,
        event_largest: largest(events.iter().copied()),
        events,
        force_largest: largest(forces.iter().map(|it| it.1)),
        force_rms: (squares / forces.len().max(1) as f64).sqrt(),
        energy_largest: largest(rows.map(|(right, row)| row.energy - right.energy)),
        energy_made: run.made,
        forces,
    }
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |largest, value| value.abs().max(largest))
}
