//! Vectors as components along the axes of several frames.
//!
//! A sum of vectors of different frames stays a sum: components are rotated only where a product
//! needs common axes, and then by the angle between the two frames alone.

use std::collections::BTreeMap;

use crate::kane::graph::{Graph, Node, UnaryFunction};
use crate::kane::mechanism::ReferenceFrame;

pub(super) type Components = [Node; 3];

/// Sum of vectors, each along the axes of its frame.
#[derive(Clone, Debug, Default)]
pub(super) struct FrameVector {
    pub(super) parts: BTreeMap<usize, Components>,
}

impl FrameVector {
    pub(super) fn of(frame: usize, components: Components) -> Self {
        Self { parts: BTreeMap::from([(frame, components)]) }
    }

    pub(super) fn plus(&self, graph: &mut Graph, other: &Self) -> Self {
        let mut sum = self.clone();
        for (frame, components) in &other.parts {
            let Some(own) = sum.parts.get_mut(frame) else {
                sum.parts.insert(*frame, *components);
                continue;
            };
            *own = [0, 1, 2].map(|i| graph.add(own[i], components[i]));
        }
        sum
    }

    pub(super) fn map(
        &self,
        graph: &mut Graph,
        mut change: impl FnMut(&mut Graph, Node) -> Node,
    ) -> Self {
        let parts = self.parts.iter().map(|(frame, components)| {
            (*frame, components.map(|component| change(graph, component)))
        });
        Self { parts: parts.collect() }
    }
}

#[derive(Debug)]
pub(super) struct Orientations<'a> {
    frames: &'a [ReferenceFrame],
    known: BTreeMap<(usize, usize), [Components; 3]>,
}

impl<'a> Orientations<'a> {
    pub(super) const fn new(frames: &'a [ReferenceFrame]) -> Self {
        Self { frames, known: BTreeMap::new() }
    }

    /// Returns the matrix that converts components along `from` to those along `to`.
    pub(super) fn matrix(&mut self, graph: &mut Graph, from: usize, to: usize) -> [Components; 3] {
        if let Some(known) = self.known.get(&(from, to)) {
            return *known;
        }
        let mut matrix = identity(graph);
        for (axis, angle) in self.turns(graph, from, to) {
            let turn = about(graph, axis, angle);
            matrix = product(graph, &turn, &matrix);
        }
        self.known.insert((from, to), matrix);
        matrix
    }

    /// Returns the rotations from one frame to the other; those about one axis are merged.
    fn turns(&self, graph: &mut Graph, from: usize, to: usize) -> Vec<(usize, Node)> {
        let (up, down) = (self.ancestors(from), self.ancestors(to));
        let up_only = up.iter().filter(|frame| !down.contains(frame));
        let down_only = down.iter().rev().filter(|frame| !up.contains(frame));
        let mut turns: Vec<(usize, Node)> = Vec::new();
        let path = up_only.map(|it| (*it, 1.0)).chain(down_only.map(|it| (*it, -1.0)));
        for (frame, sign) in path {
            let Some((axis, angle)) = self.frames[frame].turn else { continue };
            let angle = graph.scale(angle, sign);
            match turns.pop() {
                Some((last, other)) if last == axis => {
                    let sum = graph.add(other, angle);
                    turns.extend((!graph.is_zero(sum)).then_some((axis, sum)));
                }
                other => turns.extend(other.into_iter().chain([(axis, angle)])),
            }
        }
        turns
    }

    /// Returns the frame, its parent, and so on, without the ground.
    fn ancestors(&self, frame: usize) -> Vec<usize> {
        let mut all = Vec::new();
        let mut at = frame;
        while at != 0 && all.len() < self.frames.len() {
            all.push(at);
            at = self.frames[at].parent;
        }
        all
    }

    pub(super) fn express(
        &mut self,
        graph: &mut Graph,
        vector: &FrameVector,
        frame: usize,
    ) -> Components {
        let mut sums: [Vec<(Node, f64)>; 3] = Default::default();
        for (from, components) in &vector.parts {
            let matrix = self.matrix(graph, *from, frame);
            for (row, sum) in matrix.iter().zip(&mut sums) {
                let terms = row.iter().zip(components);
                sum.extend(terms.map(|(factor, it)| (graph.multiply(*factor, *it), 1.0)));
            }
        }
        sums.map(|terms| graph.sum(&terms))
    }

    pub(super) fn dot(&mut self, graph: &mut Graph, x: &FrameVector, y: &FrameVector) -> Node {
        let mut terms = Vec::new();
        for (frame, left) in &x.parts {
            // Ends the loops early, which are long with many bodies.
            if graph.given_up().is_some() {
                break;
            }
            for (other, right) in &y.parts {
                let matrix = self.matrix(graph, *other, *frame);
                terms.extend(bilinear(graph, left, &matrix, right));
            }
        }
        graph.sum(&terms)
    }
}

fn bilinear(
    graph: &mut Graph,
    x: &Components,
    matrix: &[Components; 3],
    y: &Components,
) -> Vec<(Node, f64)> {
    let places = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
    places.map(|(i, j)| (graph.product(&[(x[i], 1), (matrix[i][j], 1), (y[j], 1)]), 1.0)).collect()
}

pub(super) fn cross(graph: &mut Graph, x: Components, y: Components) -> Components {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        let (a, b) = (graph.multiply(x[i], y[j]), graph.multiply(x[j], y[i]));
        graph.subtract(a, b)
    })
}

fn identity(graph: &mut Graph) -> [Components; 3] {
    let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
}

/// Returns the rotation matrix from a child's components to the parent's.
fn about(graph: &mut Graph, axis: usize, angle: Node) -> [Components; 3] {
    let (sin, cos) =
        (graph.unary(UnaryFunction::Sin, angle), graph.unary(UnaryFunction::Cos, angle));
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut matrix = identity(graph);
    matrix[i][i] = cos;
    matrix[j][j] = cos;
    matrix[i][j] = graph.negate(sin);
    matrix[j][i] = sin;
    matrix
}

fn product(graph: &mut Graph, x: &[Components; 3], y: &[Components; 3]) -> [Components; 3] {
    let mut entry = |i: usize, j: usize| {
        let terms = [0, 1, 2].map(|k| (graph.multiply(x[i][k], y[k][j]), 1.0));
        graph.sum(&terms)
    };
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
}
