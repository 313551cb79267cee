//! Summary of a simulation: one JSON object for a program, a few lines for people.

use std::io::{self, Write};

use documents::shown;
use instruments::ModelEntry;
use pode::stepper::Choice;
use pode::{Cap, EnergyAudit, Fault, Limits};
use serde::Serialize;
use serde_json::{Map, Value, json};

use super::args::SimulateArgs;
use super::error::SimulateError;
use super::input::HeldInput;

#[derive(Debug)]
pub(super) struct SimulationReport {
    pub(super) model: &'static str,
    pub(super) method: &'static str,
    /// Length of a tick (s).
    pub(super) step: f64,
    /// Requested end (s).
    pub(super) until: f64,
    pub(super) counts: RunCounts,
    pub(super) capped: Capped,
    /// Reached end (s).
    pub(super) t: f64,
    pub(super) mode: String,
    /// Choice of `by-need` in each mode, at its shortest step; empty with any other method.
    pub(super) choices: Vec<(String, Choice)>,
    /// Modes that the method delegates, each with the name of the other method.
    pub(super) handed_on: Vec<(&'static str, &'static str)>,
    pub(super) moved: RunMoves,
    pub(super) state: Vec<(&'static str, f64)>,
    pub(super) audit: EnergyAudit,
    /// Times of held end values, where the rows of the input end before the run.
    pub(super) held: Vec<HeldInput>,
    pub(super) failure: Option<RunFailure>,
}

/// What moved in a run beyond the steps.
#[derive(Clone, Debug, Default)]
pub(super) struct RunMoves {
    /// Largest move of a coordinate onto a constraint by an event.
    pub(super) projection: f64,
    /// Remark on the farthest move of a coordinate by an input that jumped.
    pub(super) leap: Option<String>,
    /// The most energy that moved, or was stored and released (J).
    pub(super) energy: f64,
}

/// A coordinate that an event moved, since the input jumped through its guard.
#[derive(Clone, Copy, Debug)]
pub(super) struct GuardLeap {
    pub(super) guard: &'static str,
    /// Time (s).
    pub(super) t: f64,
    /// Number of the coordinate.
    pub(super) entry: usize,
    pub(super) far: f64,
}

impl GuardLeap {
    pub(super) fn told(&self, model: &ModelEntry) -> String {
        let Self { guard, t, entry, far } = self;
        let name = model.states.get(*entry).copied().unwrap_or_default();
        let unit = model.state_units.get(*entry).copied().unwrap_or_default();
        format!(
            "{name} by {far:.2e} {unit} at t = {t:?} s, by {guard}: the input jumped through its \
             guard, and the energy of the move stands under sampling"
        )
    }
}

/// Work of all ticks, equal on every machine.
#[derive(Clone, Copy, Default, Debug, Serialize)]
pub(super) struct RunCounts {
    pub(super) ticks: u64,
    pub(super) steps: u64,
    pub(super) evaluations: ModelEvaluations,
    pub(super) events: u64,
    /// Events whose reset map left its own guard below zero or falling.
    pub(super) ineffective_events: u64,
    /// Impacts in closed form, many in one move, short of the sequence's end.
    pub(super) impacts_in_closed_form: f64,
    /// Sequences of impacts in closed form to their rest.
    pub(super) settled: u64,
    pub(super) verdicts: Verdicts,
}

/// Steps by the chance that they missed a root of a guard on the computed orbit.
#[derive(Clone, Copy, Default, Debug, Serialize)]
pub(super) struct Verdicts {
    pub(super) certain: u64,
    pub(super) unknown: u64,
}

#[derive(Clone, Copy, Default, Debug, Serialize)]
pub(super) struct ModelEvaluations {
    pub(super) derivatives: u64,
    /// Rates of single entries of the state in these.
    pub(super) rates: u64,
    pub(super) jacobians: u64,
    pub(super) guards: u64,
    pub(super) readouts: u64,
}

/// Ticks that reached a declared maximum, and then held their state.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug, Serialize)]
pub(super) struct Capped {
    pub(super) events: u64,
    pub(super) cascade: u64,
    pub(super) guards: u64,
    pub(super) pieces: u64,
}

impl Capped {
    fn told(&self) -> String {
        let Self { events, cascade, guards, pieces } = *self;
        let limits = Limits::default();
        let all = [
            (Cap::Events, events),
            (Cap::Cascade, cascade),
            (Cap::Guards, guards),
            (Cap::Pieces, pieces),
        ];
        let occurred = all.into_iter().filter(|(_, ticks)| *ticks > 0).map(|(cap, ticks)| {
            format!("{ticks} times {} {}", limits.reached(cap).maximum, cap.unit())
        });
        occurred.collect::<Vec<_>>().join(", ")
    }

    fn occurred(&self) -> Vec<(&'static str, u64)> {
        let Self { events, cascade, guards, pieces } = *self;
        let all =
            [("events", events), ("cascade", cascade), ("guards", guards), ("pieces", pieces)];
        all.into_iter().filter(|(_, ticks)| *ticks > 0).collect()
    }
}

/// Cause of a failed run.
#[derive(Clone, Copy, Debug)]
pub(super) enum RunFailure {
    /// The input, or a derivative of it, was not finite.
    Input,
    /// The model, under a finite input.
    Model(Fault),
    /// The energy audit has a sum that is not finite.
    Energy,
}

impl RunFailure {
    const fn kind(self) -> &'static str {
        match self {
            Self::Input => "input",
            Self::Model(Fault::Period) => "period",
            Self::Model(Fault::State) => "state",
            Self::Model(Fault::Guard) => "guard",
            Self::Model(Fault::Readout) => "readout",
            Self::Model(Fault::Projection) => "projection",
            Self::Energy => "energy",
        }
    }

    const fn sentence(self) -> &'static str {
        match self {
            Self::Input => "the input s or a derivative of it is not finite there",
            Self::Model(Fault::Period) => "the tick has no length; take a longer --step",
            Self::Model(Fault::State) => "the state is not finite any more; take a shorter --step",
            Self::Model(Fault::Guard) => {
                "a guard is not finite; the last rows of --out show how it came there"
            }
            Self::Model(Fault::Readout) => {
                "the force is not finite; the last rows of --out show how it came there"
            }
            Self::Model(Fault::Projection) => {
                "an event moved a coordinate onto its constraint by more than the model allows; \
                 take a shorter --step, or an input that does not jump"
            }
            Self::Energy => {
                "the energy is not finite, so that nothing tells whether the motion is right; the \
                 last rows of --out show how it came there"
            }
        }
    }
}

/// Error of the audit, as a share of the energy that went through, that triggers a warning.
pub const MOST_ENERGY_ERROR: f64 = 0.01;

impl SimulationReport {
    pub(super) fn into_result(self, args: &SimulateArgs) -> Result<(), SimulateError> {
        let Self { model, t, mode, .. } = self;
        let capped = self.capped.occurred();
        match self.failure {
            Some(why) => Err(SimulateError::Fault { model, t, mode, why: why.sentence() }),
            None if capped.is_empty() => Ok(()),
            None => Err(SimulateError::Capped {
                model,
                capped: capped.iter().map(|(_, ticks)| ticks).sum(),
                ticks: self.counts.ticks,
                kinds: self.capped.told(),
                tolerance: args.tolerance.is_some(),
            }),
        }
    }

    /// Returns `completed`, `capped: events 3, guards 1` or `fault: state`.
    fn outcome(&self) -> String {
        let capped = self.capped.occurred();
        match self.failure {
            Some(why) => format!("fault: {}", why.kind()),
            None if capped.is_empty() => "completed".to_owned(),
            None => format!("capped: {}", list(&capped)),
        }
    }

    pub(super) fn json(&self) -> Value {
        let state: Map<_, _> =
            self.state.iter().map(|(name, value)| ((*name).to_owned(), json!(value))).collect();
        let EnergyAudit { supplied, dissipated, jumps, sampling, integration, stored, .. } =
            self.audit;
        json!({
            "model": self.model,
            "method": self.method,
            "step": self.step,
            "until": self.until,
            "counts": self.counts,
            "final": { "t": self.t, "mode": self.mode, "state": state },
            "energy_audit": {
                "supplied": supplied,
                "dissipated": dissipated,
                "jumps": jumps,
                "sampling": sampling,
                "integration": integration,
                "stored": stored,
                "residual": self.audit.residual(),
                "turned_over": self.moved.energy,
                "error": self.energy_error(),
            },
            "moved_by_input": self.moved.leap,
            "projection": self.moved.projection,
            "held_input": self.held,
            "handed_on": self.handed_on,
            "choices": self.choices.iter().map(choice_json).collect::<Vec<_>>(),
            "outcome": self.outcome(),
            "capped_ticks": self.capped,
        })
    }

    fn remarks(&self) -> String {
        let mut lines: Vec<_> = self
            .handed_on
            .iter()
            .map(|(mode, taken)| {
                format!("mode    {mode}: {taken}, since {} is not for it\n", self.method)
            })
            .collect();
        lines.extend(self.moved.leap.iter().map(|leap| format!("moved   {leap}\n")));
        if self.moved.projection > 1e-9 {
            let moved = self.moved.projection;
            lines.push(format!("moved   by {moved:.1e} onto a constraint, by an event, at most\n"));
        }
        let ineffective = self.counts.ineffective_events;
        if ineffective > 0 {
            lines.push(format!(
                "events  {ineffective} of them left their own guard below zero or falling: a reset \
                 map may have a wrong sign\n"
            ));
        }
        let RunCounts { impacts_in_closed_form: impacts, settled, .. } = self.counts;
        if impacts > 0.0 || settled > 0 {
            lines.push(format!(
                "impacts {impacts} more in closed form, many in one event; {settled} events stand \
                 for all that were left, without number, until rest\n"
            ));
        }
        let share = self.energy_error();
        if MOST_ENERGY_ERROR < share {
            lines.push(format!(
                "wrong   the method made or lost {:.1} % of the energy that went through: take a \
                 shorter --step\n",
                100.0 * share
            ));
        }
        lines.concat()
    }

    /// Returns the method's energy error, as a share of the largest energy that moved, was stored and
    /// released, or went in or out.
    fn energy_error(&self) -> f64 {
        let EnergyAudit { supplied, dissipated, jumps, sampling, integration, .. } = self.audit;
        let through = [supplied, dissipated, jumps, sampling, self.moved.energy].map(f64::abs);
        let through = through.into_iter().fold(f64::MIN_POSITIVE, f64::max);
        integration.abs() / through
    }

    fn text(&self) -> String {
        let RunCounts { ticks, steps, evaluations, events, verdicts, .. } = self.counts;
        let Verdicts { certain, unknown } = verdicts;
        let choices: String = self.choices.iter().map(choice_text).collect();
        let state: Vec<_> =
            self.state.iter().map(|(name, value)| format!("{name} = {value:.6e}")).collect();
        let state = if state.is_empty() { "no state".to_owned() } else { state.join(", ") };
        let EnergyAudit { supplied, dissipated, jumps, sampling, integration, stored, .. } =
            self.audit;
        format!(
            "{} with {}: {} at t = {:?} s\n\
             work    {ticks} ticks of {:?} s, {steps} steps, {events} events; evaluations: \
             {} derivatives, {} guards, {} readouts\n\
             certain {certain} steps: no crossing of the computed orbit was missed there, however \
             far it is from the true one; not known of {unknown}\n{choices}{}\
             final   mode {}, {state}\n\
             energy  supplied {supplied:.6e} J, dissipated {dissipated:.6e} J, jumps {jumps:.6e} J, \
             sampling {sampling:.6e} J, integration {integration:.1e} J, stored {stored:.6e} J",
            self.model,
            self.method,
            self.outcome(),
            self.t,
            self.step,
            evaluations.derivatives,
            evaluations.guards,
            evaluations.readouts,
            self.remarks(),
            self.mode,
        )
    }
}

fn list(capped: &[(&'static str, u64)]) -> String {
    let counts: Vec<_> = capped.iter().map(|(kind, ticks)| format!("{kind} {ticks}")).collect();
    counts.join(", ")
}

/// Returns the choice in a mode for a program; an unknown error is null.
fn choice_json((mode, choice): &(String, Choice)) -> Value {
    let Choice { method, step, error } = *choice;
    json!({ "mode": mode, "method": method.name(), "step": step, "error_per_radian": error })
}

fn choice_text((mode, choice): &(String, Choice)) -> String {
    let Choice { method, step, error } = *choice;
    format!(
        "mode    {mode}: {}, steps up to {step:.2e} s, error {error:.0e} per radian\n",
        method.name()
    )
}

pub(super) fn write(
    report: &SimulationReport,
    args: &SimulateArgs,
    out: &mut dyn Write,
) -> io::Result<()> {
    if args.output.json {
        let mut json = report.json();
        json.as_object_mut().into_iter().for_each(|json| json.extend(args.caller.header.clone()));
        serde_json::to_writer_pretty(&mut *out, &json)?;
        return writeln!(out);
    }
    writeln!(out, "{}", report.text())?;
    for (what, path) in
        [("rows", &args.output.out), ("events", &args.output.events), ("plot", &args.output.plot)]
    {
        if let Some(path) = path {
            writeln!(out, "{what:<7} {}", shown(path))?;
        }
    }
    out.flush()
}
