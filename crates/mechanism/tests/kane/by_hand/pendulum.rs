//! A pendulum on an arm that holds it at an angle, without an input.

use mechanism::kane::assemble::Program;
use mechanism::kane::graph::UnaryFunction;

use super::Draft;

/// Parameters g, l, b: θ'' = −g/l sin θ − b θ'; energy per kg.
pub fn program() -> Program {
    let mut draft = Draft::new(&[("g", 9.81), ("l", 0.5), ("b", 0.0)], &["theta"]);
    let [g, l, b] = ["g", "l", "b"].map(|name| draft.parameter(name));
    let [angle, rate] = draft.state(0);
    let graph = draft.graph();
    let sine = graph.unary(UnaryFunction::Sin, angle);
    let pull = graph.product(&[(g, 1), (l, -1), (sine, 1)]);
    let drag = graph.multiply(b, rate);
    let acceleration = graph.sum(&[(pull, -1.0), (drag, -1.0)]);
    let cosine = graph.unary(UnaryFunction::Cos, angle);
    let height = graph.product(&[(g, 1), (l, 1), (cosine, 1)]);
    let moving = graph.product(&[(l, 2), (rate, 2)]);
    let energy = graph.sum(&[(moving, 0.5), (height, -1.0)]);
    let lost = graph.product(&[(b, 1), (l, 2), (rate, 2)]);
    let start = graph.constant(0.3);
    let mode = draft.mode("swing", &[rate, acceleration]);
    (mode.balance.energy, mode.balance.dissipated) = (Some(energy), Some(lost));
    draft.mechanism.rest.coordinates[0] = Some(start);
    draft.program()
}
