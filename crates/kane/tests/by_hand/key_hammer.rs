//! The paper's model B: key and hammer with springs in the contacts.

use kane::assemble::Program;
use kane::graph::{BinaryFunction, Graph, Node, UnaryFunction};
use kane::mechanism::Fires;

use super::{Draft, guard};

/// The parameters that the hand-written model has, in its order.
pub const NAMES: [&str; 17] = [
    "L1",
    "L2",
    "L3",
    "L4",
    "M1",
    "M2",
    "k1",
    "k2",
    "cK",
    "JK",
    "JH",
    "g",
    "string_angle",
    "restitution",
    "b1",
    "c2",
    "r",
];

/// The parts of the equations.
struct Terms {
    coupling: Node,
    /// θh'' and θk'' without the contact.
    free: [Node; 2],
    /// What the contact adds to them.
    pushed: [Node; 2],
    /// gap and its rate.
    gap: [Node; 2],
    q4: Node,
    force: Node,
    energy: [Node; 2],
    supplied: Node,
    lost: [Node; 2],
}

/// Model B with the modes B1 and B2.
pub fn program() -> Program {
    let mut draft = Draft::new(&NAMES.map(|name| (name, 1.0)), &["theta_h", "theta_k"]);
    let [l2, string, restitution, r] =
        ["L2", "string_angle", "restitution", "r"].map(|name| draft.parameter(name));
    let [[h, wh], [k, wk]] = [0, 1].map(|number| draft.state(number));
    let [s, ..] = draft.input();
    let terms = terms(&mut draft);
    let graph = draft.graph();
    let zero = graph.constant(0.0);
    let coupled = [0, 1].map(|i| graph.add(terms.free[i], terms.pushed[i]));
    let opposite = terms.gap.map(|it| graph.negate(it));
    let below = [graph.subtract(string, h), graph.negate(wh)];
    let thrown = graph.multiply(restitution, wh);
    let thrown = [string, k, graph.negate(thrown), wk];
    let speed = graph.unary(UnaryFunction::Abs, wh);
    let speed = graph.multiply(l2, speed);
    let energy = graph.add(terms.energy[0], terms.energy[1]);
    let lost = graph.add(terms.lost[0], terms.lost[1]);
    let per_metre = graph.power(r, -1);

    let same = draft.same();
    let strike = |to: usize| {
        let mut strike = guard("string", below, Draft::way(to, &thrown, zero));
        (strike.fires, strike.priority, strike.sounds) = (Fires::OnCrossing, 2, Some(speed));
        strike
    };
    let b1 = draft.mode("B1", &[wh, wk, coupled[0], coupled[1]]);
    b1.guards = vec![guard("release", opposite, Draft::way(1, &same, zero)), strike(0)];
    (b1.energy, b1.dissipated) = (Some(energy), Some(lost));
    let b2 = draft.mode("B2", &[wh, wk, terms.free[0], terms.free[1]]);
    let mut land = guard("land", terms.gap, Draft::way(0, &same, zero));
    land.priority = 1;
    b2.guards = vec![land, strike(1)];
    (b2.energy, b2.dissipated) = (Some(terms.energy[0]), Some(terms.lost[0]));
    for mode in &mut draft.modes {
        (mode.readout, mode.supplied) = (Some(terms.coupling), Some(terms.supplied));
    }
    draft.output("F_KH", &[terms.force, zero]);
    draft.output("T_KU", &[terms.coupling; 2]);
    draft.output("gap", &[terms.gap[0]; 2]);
    draft.output("q4", &[terms.q4, zero]);
    draft.mechanism.input.per_metre = Some(per_metre);
    draft.mechanism.rest.coordinates = vec![Some(s), Some(s)];
    draft.program()
}

fn terms(draft: &mut Draft) -> Terms {
    let [l1, l2, l3, l4] = ["L1", "L2", "L3", "L4"].map(|name| draft.parameter(name));
    let [m1, m2, ck, g] = ["M1", "M2", "cK", "g"].map(|name| draft.parameter(name));
    let [k1, k2, b1, c2] = ["k1", "k2", "b1", "c2"].map(|name| draft.parameter(name));
    let [jk, jh] = ["JK", "JH"].map(|name| draft.parameter(name));
    let [[h, wh], [k, wk]] = [0, 1].map(|number| draft.state(number));
    let [s, rate, ..] = draft.input();
    let graph = draft.graph();
    let delta = graph.subtract(k, h);
    let [sin_h, sin_k, sin_d] = [h, k, delta].map(|it| graph.unary(UnaryFunction::Sin, it));
    let [cos_h, cos_k, cos_d] = [h, k, delta].map(|it| graph.unary(UnaryFunction::Cos, it));
    // gap = L4 cos θh − L3 sin θh − L1 sin δ = −q4 cos δ.
    let [a, b, c] = [(l4, cos_h), (l3, sin_h), (l1, sin_d)].map(|(x, y)| graph.multiply(x, y));
    let gap = graph.sum(&[(a, 1.0), (b, -1.0), (c, -1.0)]);
    let turned = graph.subtract(wk, wh);
    let rates = [
        (graph.product(&[(l4, 1), (sin_h, 1), (wh, 1)]), -1.0),
        (graph.product(&[(l3, 1), (cos_h, 1), (wh, 1)]), -1.0),
        (graph.product(&[(l1, 1), (cos_d, 1), (turned, 1)]), -1.0),
    ];
    let gap = [gap, graph.sum(&rates)];
    let q4 = graph.divide(gap[0], cos_d);
    let q4 = graph.negate(q4);
    let [x, y] = [(l3, cos_k), (l4, sin_k)].map(|(x, y)| graph.multiply(x, y));
    let q3 = graph.sum(&[(l1, 1.0), (x, -1.0), (y, -1.0)]);
    let per_hammer = graph.product(&[(q3, 1), (cos_d, -2)]);
    let per_hammer = graph.negate(per_hammer);
    let tangent = graph.product(&[(q4, 1), (sin_d, 1), (cos_d, -1)]);
    let per_key = graph.add(l1, tangent);
    let [x, y] = [(per_hammer, wh), (per_key, wk)].map(|(x, y)| graph.multiply(x, y));
    let q4_rate = graph.add(x, y);
    let spring = graph.multiply(k2, q4);
    let force = felt(graph, spring, [c2, q4_rate]);
    let [twist, slip] = [(s, k), (rate, wk)].map(|(x, y)| graph.subtract(x, y));
    let [x, y] = [(k1, twist), (b1, slip)].map(|(x, y)| graph.multiply(x, y));
    let coupling = graph.add(x, y);
    let hammer = graph.product(&[(m2, 1), (g, 1), (l2, 1), (cos_h, 1), (jh, -1)]);
    let key = graph.product(&[(m1, 1), (g, 1), (ck, 1), (cos_k, 1)]);
    let key = graph.subtract(coupling, key);
    let free = [graph.negate(hammer), graph.divide(key, jk)];
    let pushed = [(per_hammer, jh), (per_key, jk)].map(|(per, inertia)| {
        let push = graph.product(&[(force, 1), (per, 1), (inertia, -1)]);
        graph.negate(push)
    });
    let own = [
        (graph.product(&[(jh, 1), (wh, 2)]), 0.5),
        (graph.product(&[(jk, 1), (wk, 2)]), 0.5),
        (graph.product(&[(k1, 1), (twist, 2)]), 0.5),
        (graph.product(&[(m2, 1), (g, 1), (l2, 1), (sin_h, 1)]), 1.0),
        (graph.product(&[(m1, 1), (g, 1), (ck, 1), (sin_k, 1)]), 1.0),
    ];
    let stored = graph.product(&[(k2, 1), (q4, 2)]);
    let energy = [graph.sum(&own), graph.scale(stored, 0.5)];
    let more = graph.subtract(force, spring);
    let lost = [graph.product(&[(b1, 1), (slip, 2)]), graph.multiply(more, q4_rate)];
    let supplied = graph.multiply(coupling, rate);
    Terms { coupling, free, pushed, gap, q4, force, energy, supplied, lost }
}

/// spring (1 + c2 q4'), never a pull by the felt's factor.
fn felt(graph: &mut Graph, spring: Node, [c2, rate]: [Node; 2]) -> Node {
    let (one, zero) = (graph.constant(1.0), graph.constant(0.0));
    let loss = graph.multiply(c2, rate);
    let factor = graph.add(one, loss);
    let factor = graph.binary(BinaryFunction::Max, factor, zero);
    graph.multiply(spring, factor)
}
