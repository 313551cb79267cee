//! Reads the reference cases and runs a model on them.
#![expect(
    unreachable_pub,
    clippy::expect_used,
    clippy::wildcard_enum_match_arm,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a test's own module: it has the heap and files, and fails aloud"
)]

use std::fs;
use std::path::PathBuf;

use models::Described;
use pode::series::{INPUT_TERMS, add_bell};
use pode::stepper::Stepper;
use pode::{Event, Limits, Motion, Piece, Signal, Simulator, Watch};
use serde_json::Value;

/// An event of a reference case.
#[derive(Clone, Debug)]
pub struct Expected {
    pub t: f64,
    pub guard: String,
    pub from: String,
    pub to: String,
    /// State before and after, in the order of the model's state names.
    pub before: Vec<f64>,
    pub after: Vec<f64>,
}

/// What a reference's input is a sum of.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// A exp(−((t − tc)/w)²).
    Bells,
    /// A (1 + tanh((t − tc)/w))/2.
    Presses,
}

/// A reference case: parameters, input, events and the sampled trajectory.
#[derive(Clone, Debug)]
pub struct Case {
    pub parameters: Vec<(String, f64)>,
    /// What s(t) is a sum of.
    pub shape: Shape,
    /// (A, tc, w) of each.
    pub terms: Vec<[f64; 3]>,
    /// Whether the start is the rest under s = 0 rather than under s(0).
    pub starts_at_zero: bool,
    pub t_end: f64,
    pub events: Vec<Expected>,
    /// Rows of the trajectory, by column name.
    pub columns: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

impl Case {
    pub fn load<M: Described + Default>(name: &str) -> Self {
        let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../models/tests/reference");
        let text = fs::read_to_string(folder.join(format!("{name}.json"))).expect("the case");
        let json: Value = serde_json::from_str(&text).expect("JSON");
        let mut reader =
            csv::Reader::from_path(folder.join(format!("{name}.csv"))).expect("the trajectory");
        let columns = reader.headers().expect("a header").iter().map(String::from).collect();
        let rows = reader
            .records()
            .map(|row| row.expect("a row").iter().map(String::from).collect())
            .collect();
        let parameters = json["parameters"].as_object().expect("parameters");
        let terms = json["input"]["A_tc_w"].as_array().expect("an input");
        let formula = json["input"]["s"].as_str().expect("a formula");
        Self {
            parameters: parameters
                .iter()
                .map(|(key, value)| (key.clone(), number(value)))
                .collect(),
            shape: if formula.contains("tanh") { Shape::Presses } else { Shape::Bells },
            terms: terms.iter().map(|term| [0, 1, 2].map(|i| number(&term[i]))).collect(),
            starts_at_zero: json["start"].as_str().is_some_and(|it| it.contains("s = 0")),
            t_end: number(&json["t_end"]),
            events: json["events"].as_array().expect("events").iter().map(event::<M>).collect(),
            columns,
            rows,
        }
    }

    /// The model with the case's parameters.
    pub fn model<M: Described + Default>(&self) -> M {
        let model = M::default();
        let entry = model.entry();
        let values: Vec<f64> = entry
            .parameters
            .iter()
            .enumerate()
            .map(|(index, parameter)| {
                let given = self.parameters.iter().find(|(name, _)| name == parameter.name);
                given.map_or_else(|| entry.default_value(index), |(_, value)| *value)
            })
            .collect();
        model.with_values(&values)
    }

    /// The exact input at `t` (s).
    pub fn input(&self, t: f64) -> Motion {
        match self.shape {
            Shape::Bells => crate::stroke::bells(&self.terms, t),
            Shape::Presses => crate::stroke::presses(&self.terms, t),
        }
    }

    /// Mode and state of `model` at the start.
    pub fn start<M: Described>(&self, model: &M) -> (M::Mode, M::State) {
        model.at_rest(&if self.starts_at_zero {
            crate::stroke::still(0.0)
        } else {
            self.input(0.0)
        })
    }

    /// The value in `column` of `row`.
    pub fn value(&self, row: usize, column: &str) -> f64 {
        let index = self.columns.iter().position(|name| name == column).expect("a column");
        self.rows[row][index].parse().expect("a number")
    }
}

fn number(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().expect("a number"),
        other => other.as_f64().expect("a number"),
    }
}

fn event<M: Described + Default>(json: &Value) -> Expected {
    let names = M::default().entry().states;
    let state = |which: &str| names.iter().map(|name| number(&json[which][name])).collect();
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

/// What a run gave.
#[derive(Debug)]
pub struct Trace<M: Described> {
    pub h: f64,
    pub events: Vec<(f64, &'static str, M::Mode, M::Mode)>,
    /// States before and after each.
    pub before: Vec<M::State>,
    pub after: Vec<M::State>,
    /// State and mode at the end of each tick.
    pub ends: Vec<(M::Mode, M::State)>,
    /// Largest mean-square energy residual (J).
    pub audit: pode::EnergyAudit,
}

impl<M: Described> Watch<M> for Trace<M> {
    fn piece<S: Signal<Motion>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        self.audit.piece(model, piece);
    }

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        self.audit.event(model, event);
        let t = (event.tick as f64 + event.theta) * self.h;
        self.events.push((t, event.cause.name(), event.before.0, event.after.0));
        self.before.push(event.before.1);
        self.after.push(event.after.1);
    }
}

/// The exact input over one tick of `h` (s), with its series where it has one.
struct CaseTick<'a> {
    case: &'a Case,
    tick: f64,
    h: f64,
}

impl Signal<Motion> for CaseTick<'_> {
    fn at(&self, theta: f64) -> Motion {
        self.case.input((self.tick + theta) * self.h)
    }

    fn series(&self, theta: f64, span: f64, out: &mut [Motion]) -> bool {
        let (t, dt) = ((self.tick + theta) * self.h, span * self.h);
        let mut terms = [0.0; INPUT_TERMS];
        for [height, tc, w] in &self.case.terms {
            add_bell(&mut terms, *height, (t - tc) / w, dt / w);
        }
        for (out, position) in out.iter_mut().zip(terms) {
            *out = Motion { position, ..Motion::default() };
        }
        matches!(self.case.shape, Shape::Bells)
    }
}

/// Runs `case` with ticks of `h` (s) and the exact input.
pub fn run<M: Described + Default, T: Stepper>(case: &Case, stepper: T, h: f64) -> Trace<M> {
    let model: M = case.model();
    let (mode, state) = case.start(&model);
    let mut simulator = Simulator::new(model, stepper, Limits::default(), mode, state);
    let mut trace = Trace {
        h,
        events: Vec::new(),
        before: Vec::new(),
        after: Vec::new(),
        ends: vec![(mode, state)],
        audit: <_>::default(),
    };
    let ticks = (case.t_end / h).round() as u64;
    for tick in 0..ticks {
        let signal = CaseTick { case, tick: tick as f64, h };
        let done = simulator.advance(h, &signal, &mut trace);
        assert_eq!(done.advance, pode::Advance::Completed, "tick {tick}");
        trace.ends.push((simulator.mode(), *simulator.state()));
    }
    trace
}

/// The name of a mode.
pub fn mode_name<M: Described + Default>(mode: M::Mode) -> &'static str {
    M::default().modes().find(|(known, _)| *known == mode).expect("a mode").1
}
