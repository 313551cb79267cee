//! Draws a model by its table.

use crate::equations::EquationModel;
use crate::equations::table::{BodyTable, Equations, OutlineTable};

use crate::model::draw::{Body, Coil, Ends, Follow, Sketch};

/// Maximum count of numbers in a drawing: its view, and 510 points.
const MOST: usize = 1024;

/// Draws `model` from the side; draws nothing if its drawing has too many numbers.
pub(super) fn draw<F: Equations + Clone, const N: usize, const C: usize>(
    model: &EquationModel<F, N, C>,
    sketch: &mut dyn Sketch,
) {
    let drawing = &model.table().drawing;
    let mut numbers = [0.0; MOST];
    if drawing.count == 0 || drawing.count > MOST {
        return;
    }
    model.drawing_numbers(&mut numbers);
    let (view, _) = numbers.split_at(4);
    sketch.view([view[0], view[1], view[2], view[3]]);
    let outputs = |output: usize| model.table().outputs.get(output).map(|it| it.name);
    for body in &drawing.bodies {
        draw_body(body, &outputs, &numbers, sketch);
    }
    for spring in &drawing.springs {
        let end = |(body, point): (usize, usize)| {
            let before = drawing.bodies.iter().take(body).map(drawn).sum();
            (before, [0, 1].map(|i| numbers.get(point + i).copied().unwrap_or(0.0)))
        };
        let (from, to) = (end(spring.from), end(spring.to));
        sketch.coil(Coil { name: spring.name, from, to, modes: &spring.modes });
    }
}

/// Returns the number of sketch bodies: one for permanent lines, one for each line of some modes.
fn drawn(body: &BodyTable) -> u32 {
    body.outlines.iter().filter(|outline| !outline.modes.is_empty()).map(|_| 1).sum::<u32>() + 1
}

fn draw_body(
    body: &BodyTable,
    outputs: &dyn Fn(usize) -> Option<&'static str>,
    numbers: &[f64; MOST],
    sketch: &mut dyn Sketch,
) {
    let follow = |which: usize| match body.output.and_then(|output| outputs(output + which)) {
        Some(signal) => Follow::of(0.0, 1.0, signal),
        None => Follow::fixed(0.0),
    };
    let [x, y, angle] = [0, 1, 2].map(follow);
    let (always, sometimes) = (|it: &&OutlineTable| it.modes.is_empty(), body.outlines.iter());
    sketch.body(Body { name: body.name, x, y, angle, modes: &[] });
    for outline in body.outlines.iter().filter(always) {
        draw_outline(outline, numbers, sketch);
    }
    for outline in sometimes.filter(|it| !it.modes.is_empty()) {
        sketch.body(Body { name: body.name, x, y, angle, modes: &outline.modes });
        draw_outline(outline, numbers, sketch);
    }
}

fn draw_outline(outline: &OutlineTable, numbers: &[f64; MOST], sketch: &mut dyn Sketch) {
    let (first, count) = outline.points;
    let last = first.saturating_add(count.saturating_mul(2));
    let (points, _) = numbers.get(first..last).unwrap_or_default().as_chunks();
    let ends = if outline.is_closed { Ends::Closed } else { Ends::Open };
    sketch.outline(outline.material, points, ends);
}
