//! A ball on a floor that the input moves.

use kane::assemble::Program;
use kane::mechanism::{Constraint, ConstraintKind, Impact};

use super::{Draft, guard};

/// Parameters g, e, m, y0; modes flight and rest.
pub fn program() -> Program {
    let parameters = [("g", 9.81), ("e", 0.8), ("m", 1.0), ("y0", 1.0)];
    let mut draft = Draft::new(&parameters, &["y"]);
    let [g, e, m, y0] = ["g", "e", "m", "y0"].map(|name| draft.parameter(name));
    let [y, v] = draft.state(0);
    let [s, rate, acceleration, jerk] = draft.input();
    let graph = draft.graph();
    let zero = graph.constant(0.0);
    let fall = graph.negate(g);
    let (gap, parting) = (graph.subtract(y, s), graph.subtract(v, rate));
    let push = graph.add(g, acceleration);
    let weight = graph.multiply(m, push);
    let supplied = graph.multiply(weight, rate);
    let energy = {
        let square = graph.product(&[(m, 1), (v, 2)]);
        let height = graph.product(&[(m, 1), (g, 1), (y, 1)]);
        graph.sum(&[(square, 0.5), (height, 1.0)])
    };
    let back = graph.multiply(e, parting);
    let rebound = [s, graph.subtract(rate, back)];
    let one = graph.constant(1.0);
    let more = graph.add(one, e);
    let impulse = graph.product(&[(m, 1), (more, 1), (parting, 1)]);
    let impulse = graph.negate(impulse);
    let start = graph.add(s, y0);

    let mut bounce = Draft::way(0, &rebound, impulse);
    bounce.branch.impact =
        Some(Impact { separation: parting, restitution: e, within: None, settles: None });
    let flight = draft.mode("flight", &[v, fall]);
    flight.energy = Some(energy);
    flight.guards.push(guard("floor", [gap, parting], bounce));

    let off = Draft::way(0, &draft.same(), zero);
    let rest = draft.mode("rest", &[rate, acceleration]);
    rest.slaved = vec![s, rate];
    rest.is_free = vec![false, false];
    rest.readout = Some(weight);
    rest.energy = Some(energy);
    rest.supplied = Some(supplied);
    rest.guards.push(guard("lift", [push, jerk], off));
    rest.guards[0].scale = 10.0;
    draft.output("F", &[zero, weight]);

    draft.mechanism.constraints.push(Constraint {
        name: "floor".to_owned(),
        kind: ConstraintKind::Holonomic,
        zero: gap,
        rate: parting,
    });
    draft.mechanism.modes[1].constraints.push(0);
    draft.mechanism.rest.coordinates[0] = Some(start);
    draft.mechanism.rest.is_start = true;
    draft.program()
}
