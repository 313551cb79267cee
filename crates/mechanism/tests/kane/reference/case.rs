use std::fs;
use std::path::PathBuf;

use instruments::equations::ModeNumber;
use pode::stepper::Rk4;
use pode::{Event, Limits, Motion, Piece, Signal, Simulator, Watch};
use serde_json::Value;

use crate::kane::runnable::{Runnable, ShippedModel, mode_name};
use crate::kane::stroke::{bells, presses, still};

#[derive(Clone, Debug)]
pub(crate) struct Expected {
    pub(crate) t: f64,
    pub(crate) guard: String,
    pub(crate) from: String,
    pub(crate) to: String,
    pub(crate) before: Vec<f64>,
    pub(crate) after: Vec<f64>,
}

#[derive(Clone, Copy, Debug)]
enum Shape {
    /// Terms A exp(−((t − tc)/w)²).
    Bells,
    /// Terms A (1 + tanh((t − tc)/w))/2.
    Presses,
}

/// Reference case: parameters, input, events and the sampled trajectory.
pub(crate) struct Case<const N: usize> {
    pub(crate) model: Runnable<N>,
    pub(crate) states: Vec<&'static str>,
    shape: Shape,
    /// Values (A, tc, w) of each term.
    terms: Vec<[f64; 3]>,
    /// `true` if the start is the rest under s = 0 rather than under s(0).
    starts_at_zero: bool,
    pub(crate) t_end: f64,
    pub(crate) events: Vec<Expected>,
    columns: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

impl<const N: usize> Case<N> {
    pub(crate) fn load(shipped: &ShippedModel, name: &str) -> Self {
        let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
        let file = root.join("../instruments/tests/reference").join(name);
        let text = fs::read_to_string(file.with_extension("json")).expect("the case");
        let json: Value = serde_json::from_str(&text).expect("JSON");
        let text = fs::read_to_string(file.with_extension("csv")).expect("the trajectory");
        let cells = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
        let mut lines = text.lines().map(cells);
        let columns = lines.next().expect("a header");
        let states: Vec<_> = shipped.table.states.iter().map(|it| it.name).collect();
        let terms = json["input"]["A_tc_w"].as_array().expect("an input");
        let formula = json["input"]["s"].as_str().expect("a formula");
        let events = json["events"].as_array().expect("events");
        Self {
            model: shipped.valued(&values(shipped, &json["parameters"])),
            shape: if formula.contains("tanh") { Shape::Presses } else { Shape::Bells },
            terms: terms.iter().map(|term| [0, 1, 2].map(|i| number(&term[i]))).collect(),
            starts_at_zero: json["start"].as_str().is_some_and(|it| it.contains("s = 0")),
            t_end: number(&json["t_end"]),
            events: events.iter().map(|it| event(it, &states)).collect(),
            states,
            columns,
            rows: lines.collect(),
        }
    }

    pub(crate) fn input(&self, t: f64) -> Motion {
        match self.shape {
            Shape::Bells => bells(&self.terms, t),
            Shape::Presses => presses(&self.terms, t),
        }
    }

    pub(crate) fn start(&self) -> (ModeNumber, [f64; N]) {
        self.model.at_rest(&if self.starts_at_zero { still(0.0) } else { self.input(0.0) })
    }

    pub(crate) fn value(&self, row: usize, column: &str) -> f64 {
        let index = self.columns.iter().position(|name| name == column).expect("a column");
        self.rows[row][index].parse().expect("a number")
    }

    #[track_caller]
    pub(crate) fn run(&self, h: f64) -> Trace<N> {
        let (mode, state) = self.start();
        let mut simulator = Simulator::new(self.model, Rk4, Limits::default(), mode, state);
        let (events, audit) = (Vec::new(), pode::EnergyAudit::default());
        let mut trace = Trace { h, events, ends: vec![(mode, state)], audit };
        let ticks = (0_u32..).map(f64::from).take_while(|tick| (tick + 0.5) * h < self.t_end);
        for tick in ticks {
            let signal = |theta: f64| self.input((tick + theta) * h);
            let done = simulator.advance(h, &signal, &mut trace);
            assert_eq!(done.advance, pode::Advance::Completed, "tick {tick}");
            trace.ends.push((simulator.mode(), *simulator.state()));
        }
        trace
    }
}

/// Returns the values of the first preset, replaced where the case states others.
fn values(shipped: &ShippedModel, given: &Value) -> Vec<f64> {
    let mut values = shipped.values(0, 0);
    for (parameter, value) in shipped.table.parameters.iter().zip(&mut values) {
        if let Some(given) = given.get(parameter.name) {
            *value = number(given);
        }
    }
    values
}

/// Reads a number, in quotes where all its digits are kept.
pub(crate) fn number(value: &Value) -> f64 {
    let text = value.as_str().map(|text| text.parse().expect("a number"));
    text.unwrap_or_else(|| value.as_f64().expect("a number"))
}

fn event(json: &Value, states: &[&str]) -> Expected {
    let state = |which: &str| states.iter().map(|name| number(&json[which][name])).collect();
    let text = |which: &str| json[which].as_str().expect("a name").to_owned();
    Expected {
        t: number(&json["t"]),
        guard: text("guard"),
        from: text("from"),
        to: text("to"),
        before: state("before"),
        after: state("after"),
    }
}

#[derive(Debug)]
pub(crate) struct Met<const N: usize> {
    pub(crate) t: f64,
    pub(crate) guard: &'static str,
    pub(crate) modes: [&'static str; 2],
    pub(crate) states: [[f64; N]; 2],
}

#[derive(Debug)]
pub(crate) struct Trace<const N: usize> {
    h: f64,
    pub(crate) events: Vec<Met<N>>,
    pub(crate) ends: Vec<(ModeNumber, [f64; N])>,
    pub(crate) audit: pode::EnergyAudit,
}

impl<const N: usize> Watch<Runnable<N>> for Trace<N> {
    fn piece<S: Signal<Motion>>(&mut self, model: &Runnable<N>, piece: &Piece<'_, Runnable<N>, S>) {
        self.audit.piece(model, piece);
    }

    fn event(&mut self, model: &Runnable<N>, event: &Event<'_, Runnable<N>>) {
        self.audit.event(model, event);
        self.events.push(Met {
            t: (event.tick as f64 + event.theta) * self.h,
            guard: event.cause.name(),
            modes: [event.before.0, event.after.0].map(|mode| mode_name(model, mode)),
            states: [event.before.1, event.after.1],
        });
    }
}
