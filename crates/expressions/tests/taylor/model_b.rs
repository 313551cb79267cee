//! The paper's model B as a graph, by hand, and the series in the crate `models` that comes of it.

use expressions::graph::{Graph, Node, Place, UnaryFunction};
use expressions::tape::{Argument, ArgumentLayout, Tape};
use expressions::taylor::{Recursion, SeriesNames, emit};

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
            let index = u16::try_from(index).expect("few");
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
    pub(crate) fn outputs(&mut self, is_coupled: bool) -> [Node; 6] {
        let (speeds, free, overlap) = (self.speeds(), self.free(), self.overlap());
        let string = self.below_string();
        if !is_coupled {
            let gap = self.graph.negate(overlap);
            return [speeds[0], speeds[1], free[0], free[1], gap, string];
        }
        let pushed = self.pushed();
        let rates = [0, 1].map(|index| self.graph.add(free[index], pushed[index]));
        [speeds[0], speeds[1], rates[0], rates[1], overlap, string]
    }

    pub(crate) fn tape(&mut self, is_coupled: bool) -> Tape {
        let outputs = self.outputs(is_coupled);
        Tape::lower(&self.graph, &self.layout, &outputs).expect("every symbol has an argument")
    }
}

/// The file of the crate `models`.
fn file() -> String {
    let mut text = String::from(
        "//! Taylor series of model B, written by `expressions::taylor` from its equations; not by hand.\n\
         //!\n\
         //! `UPDATE=1 cargo test -p expressions --test all taylor` writes it again.\n\n\
         #![expect(clippy::all, clippy::pedantic, reason = \"generated\")]\n\n\
         use pode::series::lanes::{SeriesLanes, SeriesPair};\n\
         use pode::series::rows::PER_ORDER;\n\
         use pode::series::{Expansion, INPUT_TERMS};\n\
         use pode::{Motion, math};\n",
    );
    for (is_coupled, function, doc) in [
        (true, "coupled", "B1 without a felt: derivative, release, string."),
        (false, "apart", "B2: derivative, landing, string."),
    ] {
        let recursion = Recursion::new(&ModelB::new().tape(is_coupled), 4);
        let names = SeriesNames { function, doc, constants: CONSTANTS };
        text = text + "\n" + &emit(&recursion, &names);
    }
    text
}

#[test]
fn the_series_of_the_crate_models_is_what_is_emitted() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/src/key_hammer_springs/series.rs");
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(path, file()).expect("a folder");
    }
    let there = std::fs::read_to_string(path).expect("the file");
    assert!(there == file(), "{path} is out of date");
}
