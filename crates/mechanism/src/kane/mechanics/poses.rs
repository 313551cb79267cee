use crate::kane::graph::{Graph, Node, UnaryFunction};
use crate::kane::mechanism::{Mechanism, MechanismOutput};

/// Adds the poses of the drawn frames to the outputs: x, y (m) and angle (rad) of each.
pub(super) fn add(graph: &mut Graph, mechanism: &mut Mechanism) {
    for drawn in mechanism.instrument.drawing.frames.clone() {
        let mut poses = Vec::new();
        for frame in &drawn.frames {
            poses.push(pose(graph, mechanism, *frame));
        }
        for (which, (what, unit)) in [("x", "m"), ("y", "m"), ("angle", "rad")].iter().enumerate() {
            mechanism.outputs.push(MechanismOutput {
                name: format!("{}.{what}", drawn.name),
                unit: (*unit).to_owned(),
                values: poses.iter().map(|pose| pose[which]).collect(),
            });
        }
    }
}

/// Returns the pose of a frame in the ground's axes, seen along z.
fn pose(graph: &mut Graph, mechanism: &Mechanism, frame: usize) -> [Node; 3] {
    let zero = graph.constant(0.0);
    let mut pose = [zero; 3];
    // From the frame outwards: each parent rotates and moves the pose so far.
    let mut at = frame;
    for _ in 0..mechanism.frames.len() {
        let Some(own) = mechanism.frames.get(at).filter(|_| at != 0) else { break };
        let angle = own.turn.filter(|(axis, _)| *axis == 2).map_or(zero, |(_, angle)| angle);
        let turned = turned(graph, [pose[0], pose[1]], angle);
        let origin = [own.origin[0], own.origin[1]].map(|it| it.unwrap_or(zero));
        pose = [
            graph.add(turned[0], origin[0]),
            graph.add(turned[1], origin[1]),
            graph.add(pose[2], angle),
        ];
        at = own.parent;
    }
    pose
}

pub(crate) fn turned(graph: &mut Graph, [x, y]: [Node; 2], angle: Node) -> [Node; 2] {
    let (sin, cos) =
        (graph.unary(UnaryFunction::Sin, angle), graph.unary(UnaryFunction::Cos, angle));
    let [xc, xs] = [cos, sin].map(|it| graph.multiply(x, it));
    let [yc, ys] = [cos, sin].map(|it| graph.multiply(y, it));
    [graph.subtract(xc, ys), graph.add(xs, yc)]
}
