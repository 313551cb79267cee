//! Functions of a lever with a hammer, as large as those of pianos: something to compile.

use mechanism::expressions::graph::{BinaryFunction, Graph, Node, Place, UnaryFunction};
use mechanism::expressions::tape::{Argument, ArgumentLayout, Tape};

fn layout() -> ArgumentLayout {
    let mut layout = ArgumentLayout::default();
    for at in 0..8 {
        layout.place(Place::Parameter(at), Argument::Constant(at));
    }
    for at in 0..2 {
        layout.place(Place::Coordinate(at), Argument::State(at));
        layout.place(Place::Speed(at), Argument::State(2 + at));
    }
    for at in 0..4 {
        layout.place(Place::Input(at), Argument::Input(at));
    }
    layout.place(Place::Extra(0), Argument::Extra(0));
    layout
}

/// Returns the derivative of a lever on springs, and a hammer that slides on it behind felt.
pub fn derivative(g: &mut Graph) -> Vec<Node> {
    let [l1, m1, j1, j2, k1, k2] = [0, 1, 2, 3, 4, 5].map(|at| g.symbol(Place::Parameter(at)));
    let [q1, q2] = [0, 1].map(|at| g.symbol(Place::Coordinate(at)));
    let [u1, u2] = [0, 1].map(|at| g.symbol(Place::Speed(at)));
    let [s, ds] = [0, 1].map(|at| g.symbol(Place::Input(at)));
    let delta = g.subtract(q1, q2);
    let (sd, cd) = (g.unary(UnaryFunction::Sin, delta), g.unary(UnaryFunction::Cos, delta));
    let (s1, c1) = (g.unary(UnaryFunction::Sin, q1), g.unary(UnaryFunction::Cos, q1));
    // Mass matrix [[a, b], [b, d]].
    let ml2 = g.product(&[(m1, 1), (l1, 2)]);
    let a = g.sum(&[(j1, 1.0), (ml2, 1.0)]);
    let b = g.product(&[(ml2, 1), (cd, 1)]);
    let d = g.sum(&[(j2, 1.0), (ml2, 0.25)]);
    // Forces: input spring with damping, felt, gravity, centrifugal terms.
    let stretch = g.subtract(s, q1);
    let rate = g.subtract(ds, u1);
    let spring = g.product(&[(k1, 1), (stretch, 1)]);
    let damping = g.product(&[(k1, 1), (rate, 1)]);
    let height = g.sum(&[(s1, 0.4), (q2, -0.1), (sd, 0.05)]);
    let zero = g.constant(0.0);
    let compression = g.binary(BinaryFunction::Max, height, zero);
    let exponent = g.constant(2.5);
    let power = g.binary(BinaryFunction::Power, compression, exponent);
    let felt = g.product(&[(k2, 1), (power, 1)]);
    let soft = g.scale(height, 300.0);
    let soft = g.unary(UnaryFunction::Softplus, soft);
    let (uu1, uu2) = (g.power(u1, 2), g.power(u2, 2));
    let turn1 = g.product(&[(ml2, 1), (sd, 1), (uu2, 1)]);
    let turn2 = g.product(&[(ml2, 1), (sd, 1), (uu1, 1)]);
    let weight = g.product(&[(m1, 1), (l1, 1), (c1, 1)]);
    let felt1 = g.multiply(felt, c1);
    let f1 = g.sum(&[
        (spring, 1.0),
        (damping, 0.01),
        (felt1, -0.4),
        (turn1, -1.0),
        (weight, -9.81),
        (soft, -1e-3),
    ]);
    let felt2 = g.multiply(felt, cd);
    let f2 = g.sum(&[(felt2, 0.1), (turn2, 1.0), (soft, 1e-3), (u2, -0.02)]);
    let (ad, bb) = (g.multiply(a, d), g.power(b, 2));
    let determinant = g.subtract(ad, bb);
    let solve = |g: &mut Graph, [x, fx, y, fy]: [Node; 4]| {
        let (x, y) = (g.multiply(x, fx), g.multiply(y, fy));
        let above = g.subtract(x, y);
        g.divide(above, determinant)
    };
    let first = solve(g, [d, f1, b, f2]);
    let second = solve(g, [a, f2, b, f1]);
    vec![u1, u2, first, second]
}

pub fn functions() -> Vec<Tape> {
    let mut graph = Graph::new();
    let g = &mut graph;
    let f = derivative(g);
    let [l1, m1, k1] = [0, 1, 4].map(|at| g.symbol(Place::Parameter(at)));
    let third = g.constant(1.0 / 3.0);
    let pi = g.constant(core::f64::consts::PI);
    let weight = g.product(&[(l1, 1), (m1, 1), (pi, 1)]);
    let [q1, q2, s, key] =
        [Place::Coordinate(0), Place::Coordinate(1), Place::Input(0), Place::Extra(0)]
            .map(|place| g.symbol(place));
    let stretch = g.subtract(s, q1);
    let readout = g.multiply(k1, stretch);
    let states = [Place::Coordinate(0), Place::Coordinate(1), Place::Speed(0), Place::Speed(1)];
    let slopes = f.iter().flat_map(|row| states.map(|place| (*row, place)));
    let jacobian: Vec<Node> = slopes.map(|(row, place)| g.partial(row, place)).collect();
    let about_pi = g.constant(314.0 / 100.0);
    let chosen = g.select(readout, about_pi, q2);
    let angle = g.binary(BinaryFunction::Atan2, q1, q2);
    let graded = g.product(&[(key, 1), (third, 1)]);
    let (small, big) = (g.constant(1.5e-9), g.constant(123_456_789.0));
    let lists: [Vec<Node>; 9] = [
        vec![weight],
        f,
        vec![readout],
        vec![readout, weight, stretch],
        vec![chosen],
        jacobian,
        vec![angle, stretch],
        vec![q1, q2, third, small],
        vec![graded, big, third, pi, q1, q1],
    ];
    let layout = layout();
    lists.map(|outputs| Tape::lower(&graph, &layout, &outputs).unwrap_or_default()).to_vec()
}
