use instruments::SmallModel;
use pode::{Guarded as _, Motion};
use serde::Serialize;

use super::closed_loop::{ClosedLoop, Pace, RigRow, closed_loop};
use super::judge::{StepErrors, Truth, compare, truth};
use super::model_run::{ModelRun, RunEvent};
use crate::scenario::{BadFile, Scenario as _, figure_6};

/// Content of the report.
#[derive(Clone, PartialEq, Debug)]
pub struct Figure6 {
    /// Model time is slower than the hand's, as in the paper.
    pub slow_motion: ClosedLoop,
    /// Model time equals the hand's.
    pub real_time: ClosedLoop,
    /// Angle of the hammer at the string (rad).
    pub string: f64,
    pub truth: Truth,
    pub errors: Vec<StepErrors>,
}

/// Runs the paper's experiment twice: with `pace`, and with equal times.
///
/// # Errors
/// If the embedded reference cannot be read.
#[expect(clippy::large_stack_frames, reason = "once for a study")]
pub fn figure6(pace: Pace) -> Result<Figure6, BadFile> {
    let stroke = figure_6()?;
    let (model, ..): (SmallModel, _, _) = stroke.start();
    let until = stroke.plan().until;
    let run = |pace| closed_loop(&model, pace, until, |t| stroke.input(t));
    let truth = truth(&stroke);
    Ok(Figure6 {
        slow_motion: run(pace),
        real_time: run(Pace::SAME),
        string: string_angle(&model),
        errors: compare(&stroke, &truth),
        truth,
    })
}

fn string_angle(model: &SmallModel) -> f64 {
    let input = Motion::default();
    let (mode, state) = model.at_rest(&input);
    let string = model.guards(mode).iter().find(|spec| spec.name == STRING);
    // The guard is the remaining angle.
    string.map_or(f64::NAN, |spec| state[0] + model.guard(mode, spec.id, &state, &input).value)
}

pub(super) const STRING: &str = "string";

/// Figures of the report, for programs.
#[derive(Debug, Serialize)]
pub struct Figure6Summary<'a> {
    readings: [ReadingSummary<'a>; 2],
    reference: &'a Truth,
    errors: &'a [StepErrors],
}

#[derive(Debug, Serialize)]
struct ReadingSummary<'a> {
    name: &'static str,
    time_scale: f64,
    /// Time between samples (s of the hand).
    servo: f64,
    events: Vec<EventTimes<'a>>,
    /// `true` if located events, and those of the exact motion, have the order of the paper's step.
    same_sequence: [bool; 2],
    /// Largest energy that the paper's step generated (J).
    energy_made: f64,
    /// Lowest and highest force of the motor (N).
    motor: (f64, f64),
    /// Lowest and highest force on the hand (N).
    hand: (f64, f64),
}

#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct EventTimes<'a> {
    pub(super) guard: &'a str,
    pub(super) from: &'a str,
    pub(super) to: &'a str,
    /// End of the step that detected it (s).
    pub(super) paper: f64,
    /// Time of the located event under the same samples (s), while the order is equal.
    pub(super) located: Option<f64>,
    /// Time under the handle's true motion (s), while the order is equal.
    pub(super) exact: Option<f64>,
}

impl Figure6 {
    pub fn summary(&self) -> Figure6Summary<'_> {
        let readings =
            [("slow-motion", &self.slow_motion), ("real-time", &self.real_time)].map(reading);
        Figure6Summary { readings, reference: &self.truth, errors: &self.errors }
    }
}

fn reading<'a>((name, it): (&'static str, &'a ClosedLoop)) -> ReadingSummary<'a> {
    let is_same = |run: &ModelRun| {
        common(&it.paper, run) == it.paper.events.len() && run.events.len() == it.paper.events.len()
    };
    let range = |forces: fn(&RigRow) -> f64| {
        let ends = it.rig.iter().map(|row| (forces(row), forces(row)));
        let ends = ends.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
        ends.unwrap_or_default()
    };
    ReadingSummary {
        name,
        time_scale: it.pace.time_scale(),
        servo: it.pace.servo(),
        events: event_times(it),
        same_sequence: [&it.located, &it.exact].map(is_same),
        energy_made: it.paper.made,
        motor: range(|row| row.motor),
        hand: range(|row| row.hand),
    }
}

pub(super) fn event_times(it: &ClosedLoop) -> Vec<EventTimes<'_>> {
    let times = |run: &ModelRun| -> Vec<f64> {
        run.events.iter().take(common(&it.paper, run)).map(|event| event.t).collect()
    };
    let (located, exact) = (times(&it.located), times(&it.exact));
    let event = |(index, event): (usize, &RunEvent)| EventTimes {
        guard: event.guard,
        from: event.from,
        to: event.to,
        paper: event.t,
        located: located.get(index).copied(),
        exact: exact.get(index).copied(),
    };
    it.paper.events.iter().enumerate().map(event).collect()
}

fn common(one: &ModelRun, other: &ModelRun) -> usize {
    /// Largest distance in time of one bounce in two runs (s).
    const NEAR: f64 = 50e-3;
    let is_same = |(a, b): &(&RunEvent, &RunEvent)| {
        (a.guard, a.to) == (b.guard, b.to) && (a.t - b.t).abs() < NEAR
    };
    one.events.iter().zip(&other.events).take_while(is_same).count()
}
