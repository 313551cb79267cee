//! The guard of the reduced grand's hammer on its jack, apart from a constant.

use hand_written::reduced_grand;
use kane::assemble::Program;
use kane::graph::{BinaryFunction, Graph, Node, UnaryFunction};

use super::{Draft, guard};

/// mh R/mk (F − S) + ch R u over the grand's own parameters and state.
pub fn program() -> Program {
    let parameters: Vec<_> =
        reduced_grand::ENTRY.parameters.iter().map(|it| (it.name, 1.0)).collect();
    let mut draft = Draft::new(&parameters, &["y", "z"]);
    let [y, u] = draft.state(0);
    let load = load(&mut draft);
    let [k1, b1, mh, mk, ch, ratio] =
        ["k1", "b1", "mh", "mk", "ch", "R"].map(|name| draft.parameter(name));
    let [s, rate, ..] = draft.input();
    let graph = draft.graph();
    let [twist, slip] = [(s, y), (rate, u)].map(|(a, b)| graph.subtract(a, b));
    let [spring, damper] = [(k1, twist), (b1, slip)].map(|(a, b)| graph.multiply(a, b));
    let push = graph.sum(&[(spring, 1.0), (damper, 1.0), (load, -1.0)]);
    let driven = graph.product(&[(mh, 1), (mk, -1), (ratio, 1), (push, 1)]);
    let own = graph.product(&[(ch, 1), (ratio, 1), (u, 1)]);
    let value = graph.add(driven, own);
    let zero = graph.constant(0.0);
    let same = draft.same();
    let mode = draft.mode("ACC", &[zero; 4]);
    mode.guards = vec![guard("lift-off", [value, zero], Draft::way(0, &same, zero))];
    draft.program()
}

/// S: dry and viscous friction, jack, bed and rail (N).
fn load(draft: &mut Draft) -> Node {
    let [y, u] = draft.state(0);
    let [dry, slow, viscous, jack, width, button] =
        ["Fc", "vc", "ck", "kj", "wj", "yb"].map(|name| draft.parameter(name));
    let [bed, kb, ab, kr, ar, wide] =
        ["ybed", "Kb", "ab", "Kr", "ar", "wf"].map(|name| draft.parameter(name));
    let graph = draft.graph();
    let speed = graph.divide(u, slow);
    let rubbing = graph.unary(UnaryFunction::Tanh, speed);
    let rubbing = graph.multiply(dry, rubbing);
    let drag = graph.multiply(viscous, u);
    let deep = graph.subtract(y, button);
    let deep = graph.divide(deep, width);
    let soft = graph.unary(UnaryFunction::Softplus, deep);
    let jack = graph.product(&[(jack, 1), (width, 1), (soft, 1)]);
    let in_bed = graph.subtract(y, bed);
    let bed = felt(graph, [kb, ab, wide], [in_bed, u]);
    let (up, back) = (graph.negate(y), graph.negate(u));
    let rail = felt(graph, [kr, ar, wide], [up, back]);
    graph.sum(&[(rubbing, 1.0), (drag, 1.0), (jack, 1.0), (bed, 1.0), (rail, -1.0)])
}

/// k w² softplus(x/w)² max(1 + a x', 0).
fn felt(graph: &mut Graph, [k, a, w]: [Node; 3], [depth, rate]: [Node; 2]) -> Node {
    let deep = graph.divide(depth, w);
    let soft = graph.unary(UnaryFunction::Softplus, deep);
    let (one, zero) = (graph.constant(1.0), graph.constant(0.0));
    let loss = graph.multiply(a, rate);
    let factor = graph.add(one, loss);
    let factor = graph.binary(BinaryFunction::Max, factor, zero);
    graph.product(&[(k, 1), (w, 2), (soft, 2), (factor, 1)])
}
