//! What a drawing needs: points by the parameters; the poses of drawn frames are the last outputs.

use instruments::equations::table::{BodyTable, DrawingTable, OutlineTable, SpringTable};

use super::functions::FunctionList;
use super::{AssemblyError, names};
use crate::kane::graph::{Graph, Node};
use crate::kane::mechanism::{self, Mechanism};

/// The drawing of a mechanism; the poses are the outputs from `first_pose` on.
pub(super) fn table(
    graph: &mut Graph,
    functions: &mut FunctionList,
    mechanism: &Mechanism,
    first_pose: usize,
) -> Result<DrawingTable, AssemblyError> {
    let drawing = &mechanism.instrument.drawing;
    let zero = graph.constant(0.0);
    let mut numbers: Vec<Node> = drawing.view.map_or(vec![zero; 4], |view| view.to_vec());
    let mut bodies = Vec::new();
    for body in &drawing.bodies {
        let outlines = body.outlines.iter().map(|it| outline(&mut numbers, it)).collect();
        bodies.push(BodyTable {
            name: names::name(&body.name),
            output: body.frame.map(|frame| first_pose + 3 * frame),
            outlines,
        });
    }
    let springs = drawing.springs.iter().map(|spring| {
        let mut end = |(body, point): (usize, [Node; 2])| {
            numbers.extend(point);
            (body, numbers.len() - 2)
        };
        SpringTable {
            name: names::name(&spring.name),
            from: end(spring.from),
            to: end(spring.to),
            modes: modes(&spring.modes),
        }
    });
    let springs = springs.collect();
    let count = if drawing.view.is_some() { numbers.len() } else { 0 };
    let numbers = functions.add_whole(graph, "drawing", &numbers)?;
    Ok(DrawingTable { numbers, count, bodies, springs })
}

fn outline(numbers: &mut Vec<Node>, outline: &mechanism::Outline) -> OutlineTable {
    let first = numbers.len();
    numbers.extend(outline.points.iter().flatten());
    OutlineTable {
        material: outline.material,
        is_closed: outline.is_closed,
        points: (first, outline.points.len()),
        modes: modes(&outline.modes),
    }
}

fn modes(modes: &[usize]) -> Vec<u8> {
    modes.iter().filter_map(|mode| u8::try_from(*mode).ok()).collect()
}
