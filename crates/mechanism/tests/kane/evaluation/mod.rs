use std::path::Path;

use mechanism::kane::graph::{Node, Place};
use mechanism::kane::mechanism::Mechanism;
use mechanism::kane::system::EquationSystem;
use mechanism::kane::tape::{Argument, ArgumentLayout, Tape, TapeArguments};

use crate::kane::builder::{MechanismBuilder, number};
use crate::kane::runnable::{Runnable, runnable};
use crate::kane::shipped::Folder;

pub(crate) struct Derived {
    pub(crate) system: EquationSystem,
    pub(crate) values: Vec<f64>,
}

impl Derived {
    pub(crate) fn from(builder: MechanismBuilder) -> Self {
        let values = builder.values;
        let system = mechanism::kane::mechanics::derive(builder.it);
        let system = system.unwrap_or_else(|errors| {
            let lines: Vec<_> = errors.iter().map(ToString::to_string).collect();
            panic!("{}", lines.join("\n"))
        });
        Self { system, values }
    }

    pub(crate) fn built_in(folder: &str, preset: usize) -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        Self::file(&root.join(format!("../instruments/src/{folder}/model.toml")), preset)
    }

    pub(crate) fn shipped(name: &str) -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        Self::file(&root.join(format!("../../configs/models/{name}.toml")), 0)
    }

    fn file(file: &Path, preset: usize) -> Self {
        let text = std::fs::read_to_string(file).expect("a description");
        Self::described(&text, preset)
    }

    pub(crate) fn described(text: &str, preset: usize) -> Self {
        let read = mechanism::kane::description::read("described.toml", text, &Folder);
        let mechanism = read.unwrap_or_else(|mistakes| panic!("{mistakes}")).mechanism;
        let values = preset_values(&mechanism, preset);
        let system = mechanism::kane::mechanics::derive(mechanism);
        let system = system.unwrap_or_else(|errors| panic!("{errors:?}"));
        Self { system, values }
    }

    pub(crate) fn set(&mut self, name: &str, value: f64) {
        let index = self.parameter(name);
        self.values[index] = value;
    }

    pub(crate) fn value_of(&self, name: &str) -> f64 {
        self.values[self.parameter(name)]
    }

    fn parameter(&self, name: &str) -> usize {
        let mut parameters = self.system.mechanism.parameters.iter();
        let index = parameters.position(|it| it.name == name);
        index.unwrap_or_else(|| panic!("there is no parameter {name}"))
    }

    pub(crate) fn model<const N: usize>(&self) -> Runnable<N> {
        runnable(self.system.clone().assemble().expect("a program"), &self.values)
    }

    /// Returns the values of `nodes`, which are over state, parameters and input.
    pub(crate) fn all(&self, nodes: &[Node], state: &[f64], input: [f64; 4]) -> Vec<f64> {
        assert_eq!(state.len(), self.system.state.len(), "{:?}", self.system.state);
        let mut layout = ArgumentLayout::default();
        for i in 0..self.values.len() {
            layout.place(Place::Parameter(number(i)), Argument::Constant(number(i)));
        }
        for (i, place) in self.system.state.iter().enumerate() {
            layout.place(*place, Argument::State(number(i)));
        }
        for k in 0..4 {
            layout.place(Place::Input(k), Argument::Input(k));
        }
        // No friction acts.
        layout.place(Place::Friction(0), Argument::Extra(0));
        let tape = Tape::lower(&self.system.mechanism.graph, &layout, nodes).expect("explicit");
        tape.evaluate(&TapeArguments { constants: &self.values, state, input, extra: &[0.0] })
    }

    pub(crate) fn one(&self, node: Node, state: &[f64], input: [f64; 4]) -> f64 {
        self.all(&[node], state, input)[0]
    }

    pub(crate) fn derivative(&self, mode: usize, state: &[f64], input: [f64; 4]) -> Vec<f64> {
        self.all(&self.system.modes[mode].derivative, state, input)
    }

    /// Returns the state with slaved entries in place, after Newton's steps onto the constraints.
    #[track_caller]
    pub(crate) fn consistent(&self, mode: usize, state: &[f64], input: [f64; 4]) -> Vec<f64> {
        self.near(mode, state, input).expect("a state on the constraints")
    }

    /// Like [`Self::consistent`], but returns `None` where Newton's steps miss the constraints.
    pub(crate) fn near(&self, mode: usize, state: &[f64], input: [f64; 4]) -> Option<Vec<f64>> {
        let equations = &self.system.modes[mode];
        let mut state = state.to_vec();
        if !equations.projection.is_empty() {
            for _ in 0..30 {
                state = self.all(&equations.projection, &state, input);
            }
            let drift = self.all(&equations.drift, &state, input);
            if !drift.iter().all(|it| it.abs() < 1e-12) {
                return None;
            }
        }
        Some(self.all(&equations.slaved, &state, input))
    }
}

fn preset_values(mechanism: &Mechanism, preset: usize) -> Vec<f64> {
    let mut layout = ArgumentLayout::default();
    layout.place(Place::Key, Argument::Extra(0));
    let preset = &mechanism.instrument.presets[preset];
    let tape = Tape::lower(&mechanism.graph, &layout, &preset.values).expect("over the key");
    tape.evaluate(&TapeArguments { extra: &[40.0], ..TapeArguments::default() })
}

/// Pseudorandom numbers in −1 ..= 1: xorshift.
#[derive(Clone, Debug)]
pub(crate) struct Numbers(u64);

impl Numbers {
    pub(crate) const fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub(crate) fn next(&mut self) -> f64 {
        for shift in [13, -7, 17_i32] {
            let by = shift.unsigned_abs();
            self.0 ^= if shift > 0 { self.0 << by } else { self.0 >> by };
        }
        (self.0 >> 11) as f64 / 2_f64.powi(52) - 1.0
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * 0.5 * (1.0 + self.next())
    }

    pub(crate) fn list<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.next())
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        let part = (self.next() + 1.0) * 0.5 * n as f64;
        (1..n).filter(|k| *k as f64 <= part).count()
    }
}

#[track_caller]
pub(crate) fn close(found: f64, expected: f64, relative: f64, what: &str) {
    let scale = expected.abs().max(1.0);
    assert!((found - expected).abs() <= relative * scale, "{what}: {found} is not {expected}");
}

/// Returns dE/dt − supplied + dissipated in a mode, relative to the terms.
pub(crate) fn imbalance(derived: &mut Derived, mode: usize, state: &[f64], input: [f64; 4]) -> f64 {
    use mechanism::kane::graph::Tangent;
    let equations = derived.system.modes[mode].clone();
    let graph = &mut derived.system.mechanism.graph;
    let places = derived.system.state.iter().copied();
    let mut seeds: Vec<_> = places.zip(equations.derivative.iter().copied()).collect();
    for k in 0..3 {
        seeds.push((Place::Input(k), graph.symbol(Place::Input(k + 1))));
    }
    let rate = Tangent::new(seeds).of(graph, equations.balance.energy.expect("energy"));
    let nodes = [
        rate,
        equations.balance.supplied.expect("supplied"),
        equations.balance.dissipated.expect("lost"),
    ];
    let [rate, supplied, lost] = derived.all(&nodes, state, input)[..] else { unreachable!() };
    (rate - supplied + lost) / (1.0 + rate.abs() + supplied.abs() + lost.abs())
}
