//! What a drawing needs: points by the parameters, and the pose of each drawn frame as outputs.

use equations::table::{BodyTable, DrawingTable, Material, OutlineTable, Quantity, SpringTable};

use super::functions::FunctionList;
use super::modes::ModeBuilder;
use super::{AssemblyError, leak};
use crate::graph::{Graph, Node, Place, Substitution, UnaryFunction};
use crate::mechanism::{self, Mechanism};

/// The frames that are drawn, the ground included where it is, in the order of their numbers.
fn drawn(mechanism: &Mechanism) -> Vec<usize> {
    let drawing = &mechanism.drawing;
    let lines = drawing.outlines.iter().map(|outline| outline.frame);
    let ends = drawing.springs.iter().flat_map(|spring| [spring.from.0, spring.to.0]);
    let mut frames: Vec<_> = lines.chain(ends).collect();
    frames.sort_unstable();
    frames.dedup();
    frames.retain(|frame| *frame < mechanism.frames.len());
    frames
}

/// The outputs that are the poses of the drawn frames: x, y (m) and angle (rad) of each.
pub(super) fn quantities(mechanism: &Mechanism) -> Vec<Quantity> {
    let frames = drawn(mechanism).into_iter().filter(|frame| *frame != 0);
    let of = |frame: usize| {
        let name = &mechanism.frames[frame].name;
        [("x", "m"), ("y", "m"), ("angle", "rad")]
            .map(|(what, unit)| Quantity { name: leak::text(&format!("{name}.{what}")), unit })
    };
    frames.flat_map(of).collect()
}

/// Their expressions in a mode, in the same order.
pub(super) fn poses(graph: &mut Graph, builder: &ModeBuilder<'_>) -> Vec<Node> {
    let mechanism = builder.context.mechanism;
    let mut nodes = Vec::new();
    for frame in drawn(mechanism).into_iter().filter(|frame| *frame != 0) {
        nodes.extend(pose(graph, mechanism, frame));
    }
    solved(graph, builder, nodes)
}

/// The pose of a frame in the ground's axes, seen along z.
fn pose(graph: &mut Graph, mechanism: &Mechanism, frame: usize) -> [Node; 3] {
    let zero = graph.constant(0.0);
    let mut pose = [zero; 3];
    // From the frame outwards: each parent turns and moves what was found so far.
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

/// A point turned about the origin.
fn turned(graph: &mut Graph, [x, y]: [Node; 2], angle: Node) -> [Node; 2] {
    let (sin, cos) =
        (graph.unary(UnaryFunction::Sin, angle), graph.unary(UnaryFunction::Cos, angle));
    let [xc, xs] = [cos, sin].map(|it| graph.multiply(x, it));
    let [yc, ys] = [cos, sin].map(|it| graph.multiply(y, it));
    [graph.subtract(xc, ys), graph.add(xs, yc)]
}

/// `nodes` with the coordinates that are no entries of the state replaced by what they are.
fn solved(graph: &mut Graph, builder: &ModeBuilder<'_>, mut nodes: Vec<Node>) -> Vec<Node> {
    let context = builder.context;
    let Some(mode) = context.mechanism.modes.get(builder.number) else { return nodes };
    let places = |(number, by): &(usize, Node)| {
        let place = Place::Coordinate(u16::try_from(*number).unwrap_or(u16::MAX));
        (!context.places.contains(&place)).then_some((place, *by))
    };
    let by: Vec<_> = mode.solved.iter().filter_map(places).collect();
    let mut substitution = Substitution::new(by.iter().copied());
    // One may follow from another, as many times as there are.
    for _ in 0..by.len() {
        nodes = nodes.iter().map(|node| substitution.of(graph, *node)).collect();
    }
    nodes
}

/// The drawing of a mechanism; the poses are the outputs from `first_pose` on.
pub(super) fn table(
    graph: &mut Graph,
    functions: &mut FunctionList,
    mechanism: &Mechanism,
    first_pose: usize,
) -> Result<DrawingTable, AssemblyError> {
    let drawing = &mechanism.drawing;
    let zero = graph.constant(0.0);
    let mut numbers: Vec<Node> = drawing.view.map_or(vec![zero; 4], |view| view.to_vec());
    let frames = drawn(mechanism);
    let mut bodies = Vec::new();
    for frame in &frames {
        let moving = frames.iter().filter(|it| **it != 0 && *it < frame).count();
        let outlines = drawing.outlines.iter().filter(|outline| outline.frame == *frame);
        let outlines = outlines.map(|outline| self::outline(&mut numbers, outline)).collect();
        bodies.push(BodyTable {
            name: leak::text(&mechanism.frames[*frame].name),
            output: (*frame != 0).then_some(first_pose + 3 * moving),
            outlines: leak::list(outlines),
        });
    }
    let springs = drawing.springs.iter().map(|spring| {
        let mut end = |(frame, point): (usize, [Node; 2])| {
            numbers.extend(point);
            (frames.iter().position(|it| *it == frame).unwrap_or(0), numbers.len() - 2)
        };
        SpringTable {
            name: leak::text(&spring.name),
            from: end(spring.from),
            to: end(spring.to),
            modes: modes(&spring.modes),
        }
    });
    let springs = leak::list(springs.collect());
    let count = if drawing.view.is_some() { numbers.len() } else { 0 };
    let numbers = functions.add_whole(graph, "drawing", &numbers)?;
    Ok(DrawingTable { numbers, count, bodies: leak::list(bodies), springs })
}

/// A line, whose points are added to the numbers.
fn outline(numbers: &mut Vec<Node>, outline: &mechanism::Outline) -> OutlineTable {
    let first = numbers.len();
    numbers.extend(outline.points.iter().flatten());
    OutlineTable {
        material: material(outline.material),
        is_closed: outline.is_closed,
        points: (first, outline.points.len()),
        modes: modes(&outline.modes),
    }
}

fn modes(modes: &[usize]) -> &'static [u8] {
    leak::list(modes.iter().filter_map(|mode| u8::try_from(*mode).ok()).collect())
}

const fn material(material: mechanism::Material) -> Material {
    match material {
        mechanism::Material::Wood => Material::Wood,
        mechanism::Material::Felt => Material::Felt,
        mechanism::Material::Metal => Material::Metal,
        mechanism::Material::String => Material::String,
        mechanism::Material::Ground => Material::Ground,
        mechanism::Material::Finger => Material::Finger,
    }
}
