//! The paper's model B as a graph, by hand, and the series in the crate `models` that comes of it.

use expressions::graph::{Graph, Node, Place, UnaryFunction};
use expressions::tape::{Argument, ArgumentLayout, Tape};
use expressions::taylor::{Recursion, SeriesNames, SeriesStart, TapeSeries, emit};
use hand_written::KeyHammerSprings;
use hand_written::key_hammer_springs::Mode;
use models::Described as _;
use pode::series::{Expansion, INPUT_TERMS};
use pode::{GuardId, Guarded as _, Model as _, Motion};

/// The constants of the series, in this order: lengths L1, L3, L4 (m), the angular accelerations
/// of the weights (rad/s²), k2/JH, k2/JK, k1/JK, b1/JK, and the string's angle (rad).
pub(crate) const CONSTANTS: usize = 10;

/// The parts of model B's equations.
pub(crate) struct ModelB {
    pub(crate) graph: Graph,
    layout: ArgumentLayout,
    sines: [Node; 3],
    cosines: [Node; 3],
    constants: [Node; CONSTANTS],
}

impl ModelB {
    pub(crate) fn new() -> Self {
        let (mut graph, mut layout) = (Graph::new(), ArgumentLayout::default());
        let places = [Place::Coordinate(0), Place::Coordinate(1), Place::Speed(0), Place::Speed(1)];
        for (index, place) in (0..).zip(places) {
            layout.place(place, Argument::State(index));
        }
        for rate in 0..2 {
            layout.place(Place::Input(rate), Argument::Input(rate));
        }
        let constants = std::array::from_fn(|index| {
            let index = u16::try_from(index).unwrap_or(u16::MAX);
            layout.place(Place::Parameter(index), Argument::Constant(index));
            graph.symbol(Place::Parameter(index))
        });
        let [h, k] = [0, 1].map(|index| graph.symbol(Place::Coordinate(index)));
        let angles = [h, k, graph.subtract(k, h)];
        let mut of = |function| angles.map(|angle| graph.unary(function, angle));
        let (sines, cosines) = (of(UnaryFunction::Sin), of(UnaryFunction::Cos));
        Self { graph, layout, sines, cosines, constants }
    }

    /// L1 sin δ − L4 cos θh + L3 sin θh: −gap.
    fn overlap(&mut self) -> Node {
        let [l1, l3, l4, ..] = self.constants;
        let ([sin_h, _, sin_d], [cos_h, ..]) = (self.sines, self.cosines);
        let terms = [(l1, sin_d), (l4, cos_h), (l3, sin_h)].map(|(a, b)| self.graph.multiply(a, b));
        self.graph.sum(&[(terms[0], 1.0), (terms[1], -1.0), (terms[2], 1.0)])
    }

    /// θh'' and θk'' without the contact: weight, and the coupling to the manipulandum.
    fn free(&mut self) -> [Node; 2] {
        let [_, _, _, hammer, key, _, _, k1, b1, _] = self.constants;
        let [cos_h, cos_k, _] = self.cosines;
        let g = &mut self.graph;
        let [s, s_rate] = [0, 1].map(|rate| g.symbol(Place::Input(rate)));
        let (twist, slip) = (g.symbol(Place::Coordinate(1)), g.symbol(Place::Speed(1)));
        let (twist, slip) = (g.subtract(s, twist), g.subtract(s_rate, slip));
        let terms = [(hammer, cos_h), (key, cos_k), (k1, twist), (b1, slip)];
        let [hammer, key, spring, damper] = terms.map(|(a, b)| g.multiply(a, b));
        [g.negate(hammer), g.sum(&[(spring, 1.0), (damper, 1.0), (key, -1.0)])]
    }

    /// θh'' and θk'' of the contact k2: with q4 = overlap/C and q3 = below/C, C = cos δ, they are
    /// overlap below/C³ and −overlap (L1 C² + overlap sin δ)/C³ times k2 by the inertias.
    fn pushed(&mut self) -> [Node; 2] {
        let [l1, l3, l4, _, _, by_hammer, by_key, ..] = self.constants;
        let ([_, sin_k, sin_d], [_, cos_k, cos_d]) = (self.sines, self.cosines);
        let overlap = self.overlap();
        let g = &mut self.graph;
        let (a, b) = (g.multiply(l3, cos_k), g.multiply(l4, sin_k));
        let below = g.sum(&[(l1, 1.0), (a, -1.0), (b, -1.0)]);
        let (a, b) = (g.product(&[(l1, 1), (cos_d, 2)]), g.multiply(overlap, sin_d));
        let lever = g.add(a, b);
        let hammer = g.product(&[(by_hammer, 1), (overlap, 1), (below, 1), (cos_d, -3)]);
        let key = g.product(&[(by_key, 1), (overlap, 1), (lever, 1), (cos_d, -3)]);
        [hammer, g.negate(key)]
    }

    fn speeds(&mut self) -> [Node; 2] {
        [0, 1].map(|index| self.graph.symbol(Place::Speed(index)))
    }

    fn below_string(&mut self) -> Node {
        let hammer = self.graph.symbol(Place::Coordinate(0));
        self.graph.subtract(self.constants[9], hammer)
    }

    /// The derivative and the guards of B1 (release, string) or B2 (land, string).
    pub(crate) fn outputs(&mut self, mode: Mode) -> [Node; 6] {
        let (speeds, free, overlap) = (self.speeds(), self.free(), self.overlap());
        let string = self.below_string();
        if mode == Mode::B2 {
            let gap = self.graph.negate(overlap);
            return [speeds[0], speeds[1], free[0], free[1], gap, string];
        }
        let pushed = self.pushed();
        let rates = [0, 1].map(|index| self.graph.add(free[index], pushed[index]));
        [speeds[0], speeds[1], rates[0], rates[1], overlap, string]
    }

    pub(crate) fn tape(&mut self, mode: Mode) -> Tape {
        let outputs = self.outputs(mode);
        Tape::lower(&self.graph, &self.layout, &outputs).unwrap_or_default()
    }
}

/// The file of the crate `models`.
fn file() -> String {
    let mut text = String::from(
        "//! Taylor series of model B, written by `expressions::taylor` from its equations; not by hand.\n\
         //!\n\
         //! `UPDATE=1 cargo test -p expressions --test all taylor` writes it again.\n\n\
         #![expect(clippy::pedantic, reason = \"generated\")]\n\n\
         use pode::series::lanes::{SeriesLanes, SeriesPair};\n\
         use pode::series::rows::PER_ORDER;\n\
         use pode::series::{Expansion, INPUT_TERMS};\n\
         use pode::{Motion, math};\n",
    );
    for (mode, function, doc) in [
        (Mode::B1, "coupled", "B1 without a felt: derivative, release, string."),
        (Mode::B2, "apart", "B2: derivative, landing, string."),
    ] {
        let recursion = Recursion::new(&ModelB::new().tape(mode), 4);
        let names = SeriesNames { function, doc, constants: CONSTANTS };
        text = text + "\n" + &emit(&recursion, &names);
    }
    text
}

#[test]
fn the_series_of_the_crate_models_is_what_is_emitted() {
    let path =
        concat!(env!("CARGO_MANIFEST_DIR"), "/../hand-written/src/key_hammer_springs/series.rs");
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(path, file()).expect("a folder");
    }
    let there = std::fs::read_to_string(path).expect("the file");
    assert!(there == file(), "{path} is out of date");
}

/// The paper's parameters, with a damper in the coupling.
fn model() -> KeyHammerSprings {
    let written = KeyHammerSprings::default();
    let preset = &written.entry().presets[0];
    let value = |(index, it): (usize, &models::Parameter)| {
        if it.name == "b1" { 0.02 } else { (preset.value)(index, 0) }
    };
    let values: Vec<_> = written.entry().parameters.iter().enumerate().map(value).collect();
    written.with_values(&values)
}

/// A hand that moves as a polynomial, in units of `scale` (s).
const INPUT: [f64; 4] = [0.05, 0.02, -0.01, 0.004];

const STATE: [f64; 4] = [-0.1, 0.03, 1.5, -1.6];

fn expanded(mode: Mode, order: usize, scale: f64) -> Expansion<[f64; 4]> {
    let mut input = [Motion::default(); INPUT_TERMS];
    for (input, position) in input.iter_mut().zip(INPUT) {
        input.position = position;
    }
    let mut out = Expansion::of(&STATE, order, scale);
    assert!(model().series(mode, &input, &mut out));
    out
}

#[test]
fn the_series_of_the_model_solves_the_equations_of_the_model() {
    let (model, scale) = (model(), 0.03);
    for mode in [Mode::B1, Mode::B2] {
        let out = expanded(mode, 24, scale);
        for tau in [0.0, 0.1, 0.35] {
            let sum =
                |of: &dyn Fn(usize) -> f64| (0..=24).rev().fold(0.0, |sum, k| of(k) + tau * sum);
            let x: [f64; 4] = std::array::from_fn(|i| sum(&|k| out.terms[k][i]));
            let rate = |i: usize| {
                (1..=24).rev().fold(0.0, |sum, k| k as f64 * out.terms[k][i] + tau * sum) / scale
            };
            let [c0, c1, c2, c3] = INPUT;
            let input = Motion {
                position: c0 + tau * (c1 + tau * (c2 + tau * c3)),
                rate: (c1 + tau * (2.0 * c2 + tau * 3.0 * c3)) / scale,
                ..Motion::default()
            };
            for (i, expected) in model.derivative(mode, &x, &input).into_iter().enumerate() {
                let error = (rate(i) - expected).abs();
                assert!(error < 1e-12 * expected.abs().max(1.0), "{mode:?}: {error:e}");
            }
            for (index, spec) in model.guards(mode).iter().enumerate() {
                let guard = model.guard(mode, GuardId(spec.id.0), &x, &input).value;
                let error = (sum(&|k| out.guards[index][k]) - guard).abs();
                assert!(error < 1e-15, "{mode:?}, {}: {error:e}", spec.name);
            }
        }
    }
}

#[test]
fn the_emitted_series_is_the_interpreted_one_to_rounding() {
    let values = *model().values();
    let (hammer, key) = (values.m2 * values.g * values.l2, values.m1 * values.g * values.ck);
    let constants = [
        values.l1,
        values.l3,
        values.l4,
        hammer / values.jh,
        key / values.jk,
        values.k2 / values.jh,
        values.k2 / values.jk,
        values.k1 / values.jk,
        values.b1 / values.jk,
        values.string_angle,
    ];
    let scale = 0.03;
    for mode in [Mode::B1, Mode::B2] {
        let start = SeriesStart { constants: &constants, state: &STATE, input: &INPUT, scale };
        let series = TapeSeries::new(&ModelB::new().tape(mode), 4).expand(&start, 20);
        let out = expanded(mode, 20, scale);
        for k in 0..=20 {
            let found = out.terms[k].into_iter().chain([out.guards[0][k], out.guards[1][k]]);
            for (found, expected) in found.zip(&series) {
                let size = expected[k].abs().max(1e-3 * 0.25_f64.powf(k as f64));
                assert!((found - expected[k]).abs() <= 1e-12 * size, "{mode:?}, order {k}");
            }
        }
    }
}
