//! Typical sizes of guards, from the terms of their expressions over the ranges of motion.
//!
//! The size of a sum is that of its terms, however much these cancel: rounding follows it.

use std::collections::HashMap;

use super::kinematics::number;
use super::numeric::NumericPose;
use crate::kane::graph::{Graph, Node, NodeOperation, Place};
use crate::kane::mechanism::Mechanism;
use crate::kane::system::ModeEquations;

/// Places in the ranges at which sizes are taken; the middle size counts.
const PLACES: usize = 15;

/// Travel (m) of the key front and its rates, where a guard depends on the input.
const INPUT: [f64; 4] = [0.01, 0.5, 50.0, 5000.0];

/// Sets the scale of each guard that states none: one for all guards of a name, the largest.
pub(super) fn settle(graph: &Graph, mechanism: &Mechanism, modes: &mut [ModeEquations]) {
    let poses = poses(graph, mechanism);
    let mut known: HashMap<String, f64> = HashMap::new();
    for (mode, equations) in mechanism.modes.iter().zip(modes.iter()) {
        let open = mode.guards.iter().zip(&equations.guards).filter(|it| it.0.scale.is_none());
        for (guard, found) in open {
            let size = middle_size(graph, &poses, found.value);
            let largest = known.entry(guard.name.clone()).or_insert(size);
            *largest = largest.max(size);
        }
    }
    for (mode, equations) in mechanism.modes.iter().zip(modes) {
        for (guard, found) in mode.guards.iter().zip(&mut equations.guards) {
            let own = known.get(&guard.name).copied().filter(|size| *size > 0.0);
            found.scale = guard.scale.or(own).unwrap_or(1.0);
        }
    }
}

/// Returns poses all over the ranges, no two coordinates in step.
fn poses(graph: &Graph, mechanism: &Mechanism) -> Vec<NumericPose> {
    let rest = NumericPose::at_rest(graph, mechanism);
    let per_metre = mechanism.input.per_metre.map_or(0.0, |it| rest.value(graph, it));
    let coordinates = mechanism.coordinates.iter().enumerate();
    let coordinates = coordinates.map(|(i, it)| (Place::Coordinate(number(i)), it.range));
    let speeds = mechanism.speeds.iter().enumerate();
    let ranges: Vec<_> =
        coordinates.chain(speeds.map(|(j, it)| (Place::Speed(number(j)), it.range))).collect();
    let at = |index: usize| {
        let mut pose = rest.clone();
        for (k, (place, (low, high))) in (2_u32..).zip(&ranges) {
            // Multiples of roots of whole numbers, most of them irrational.
            let part = ((index as f64 + 0.5) * f64::from(k).sqrt()).fract();
            pose.set(*place, low + part * (high - low));
        }
        for (rate, travel) in (0..).zip(INPUT) {
            pose.set(Place::Input(rate), per_metre * travel);
        }
        pose
    };
    (0..PLACES).map(at).collect()
}

fn middle_size(graph: &Graph, poses: &[NumericPose], node: Node) -> f64 {
    let sizes = poses.iter().map(|pose| size(graph, pose, node));
    let mut sizes: Vec<f64> = sizes.filter(|size| size.is_finite() && *size > 0.0).collect();
    sizes.sort_unstable_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(0.0)
}

fn size(graph: &Graph, pose: &NumericPose, node: Node) -> f64 {
    let NodeOperation::Sum(first, terms) = graph.operation(node) else {
        return pose.value(graph, node).abs();
    };
    let nodes: Vec<Node> = terms.iter().map(|it| it.0).collect();
    let values = pose.all(graph, &nodes).into_iter().zip(terms);
    let sizes = values.map(|(value, (_, by))| (value * f64::from_bits(*by)).abs());
    f64::from_bits(*first).abs() + sizes.sum::<f64>()
}
