//! Search for a pose within reach of the rest pose where dependent speeds lose their pivot.

use std::collections::BTreeMap;

use super::closing::least_step;
use super::coordinates::replacement;
use super::kinematics::number;
use super::numeric::NumericPose;
use super::speeds::{SpeedMap, is_moving};
use crate::kane::graph::{Graph, Node, Place};
use crate::kane::mechanism::{ConstraintKind, Mechanism, Mode};

/// Place that moves, its typical size, and its range.
type Movable = (Place, f64, (f64, f64));

/// Fraction of the pivot's share at rest below which it counts as sunk.
const SUNK: f64 = 0.05;
/// Steps of a walk, and the longest one, as a fraction of the ranges.
const STEPS: usize = 64;
const LONGEST: f64 = 0.03;
/// Walks beside those along the first coordinates.
const OBLIQUE: usize = 6;
const STRAIGHT: usize = 8;

/// Returns `true` if the pivot of the dependent speeds sinks on walks along the constraints from
/// the rest pose, within the coordinates' ranges.
pub(super) fn sinks(
    graph: &Graph,
    (mechanism, mode): (&Mechanism, &Mode),
    pose: &NumericPose,
    stated: &BTreeMap<usize, Node>,
    speeds: &SpeedMap,
) -> bool {
    let chosen = &speeds.chosen;
    let mut entries = speeds.open.iter().flat_map(|row| chosen.iter().map(|j| row.slopes[*j]));
    if chosen.len() != speeds.open.len() || !entries.any(|entry| is_moving(graph, entry)) {
        return false;
    }
    // New expressions would change the order of later ones.
    let mut graph = graph.clone();
    Walks::new(&mut graph, (mechanism, mode), stated, speeds).sink(&graph, pose)
}

struct Walks {
    places: Vec<Movable>,
    zeros: Vec<Node>,
    /// Slopes of the zeros by the places, times their sizes.
    slopes: Vec<Vec<Node>>,
    rows: Vec<Vec<Node>>,
    /// Columns of the dependent speeds in the rows.
    pivots: Vec<usize>,
}

impl Walks {
    fn new(
        graph: &mut Graph,
        (mechanism, mode): (&Mechanism, &Mode),
        stated: &BTreeMap<usize, Node>,
        speeds: &SpeedMap,
    ) -> Self {
        let mut places = vec![(Place::Input(0), 1.0, (f64::NEG_INFINITY, f64::INFINITY))];
        for (i, it) in mechanism.coordinates.iter().enumerate() {
            let width = it.range.1 - it.range.0;
            let size = if it.unit == "rad" { width.min(core::f64::consts::TAU) } else { width };
            if !stated.contains_key(&i) {
                places.push((Place::Coordinate(number(i)), size, it.range));
            }
        }
        let mut placed = replacement(stated);
        let active = mode.constraints.iter().map(|c| &mechanism.constraints[*c]);
        let holonomic = active.filter(|it| it.kind == ConstraintKind::Holonomic);
        let zeros: Vec<Node> = holonomic.map(|it| placed.of(graph, it.zero)).collect();
        let mut slopes = Vec::new();
        for zero in &zeros {
            let sized = places.iter().map(|(place, size, _)| {
                let slope = graph.partial(*zero, *place);
                graph.scale(slope, *size)
            });
            slopes.push(sized.collect());
        }
        let n = mechanism.speeds.len();
        let open = speeds.open.iter();
        let rows = open.map(|row| row.slopes[..n].iter().map(|it| placed.of(graph, *it)).collect());
        let rows = rows.collect();
        Self { places, zeros, slopes, rows, pivots: speeds.chosen.clone() }
    }

    /// Returns `true` if the pivot sinks on a walk along a place, or along several together.
    fn sink(&self, graph: &Graph, start: &NumericPose) -> bool {
        let Some(rest) = self.share(graph, start) else { return false };
        let n = self.places.len();
        let straight = (0..n.min(STRAIGHT)).map(|k| {
            let mut direction = vec![0.0; n];
            direction[k] = 1.0;
            direction
        });
        // Fractional parts of multiples of the golden ratio never coincide.
        let part = |k: usize| (0.618_033_988_75 * (k as f64 + 1.0)).fract() - 0.5;
        let oblique = (0..OBLIQUE).map(|w| (0..n).map(|k| part(w * n + k)).collect());
        straight.chain(oblique).any(|direction: Vec<f64>| {
            let back = direction.iter().map(|it| -it).collect();
            [direction, back].into_iter().any(|it| self.sinks_along(graph, start, it, rest))
        })
    }

    fn sinks_along(
        &self,
        graph: &Graph,
        start: &NumericPose,
        mut direction: Vec<f64>,
        rest: f64,
    ) -> bool {
        let (mut pose, mut length) = (start.clone(), LONGEST);
        for _ in 0..STEPS {
            let Some(tangent) = self.tangent(graph, &pose, &direction) else { return false };
            let Some(next) = self.moved(graph, &pose, &tangent, length) else {
                length *= 0.5;
                continue;
            };
            (pose, direction, length) = (next, tangent, LONGEST.min(1.5 * length));
            let is_inside = |(place, _, range): &Movable| {
                let value = pose.get(*place);
                range.0 <= value && value <= range.1
            };
            if !self.places.iter().all(is_inside) {
                return false;
            }
            match self.share(graph, &pose) {
                Some(share) if share / rest < SUNK => return true,
                Some(_) => {}
                None => return false,
            }
        }
        false
    }

    /// Returns the part of a direction along the constraints, of length 1.
    fn tangent(&self, graph: &Graph, pose: &NumericPose, direction: &[f64]) -> Option<Vec<f64>> {
        const NOTHING: f64 = 1e-6;
        let slopes = pose.matrix(graph, &self.slopes);
        let rates: Vec<f64> = slopes.iter().map(|row| dot(row, direction)).collect();
        let across = least_step(&slopes, &rates).unwrap_or_else(|| vec![0.0; direction.len()]);
        let along: Vec<f64> = direction.iter().zip(across).map(|(x, y)| x - y).collect();
        let length = dot(&along, &along).sqrt();
        (length > NOTHING).then(|| along.iter().map(|it| it / length).collect())
    }

    /// Returns the pose behind a step, back on the constraints; `None` if it is far from them.
    fn moved(
        &self,
        graph: &Graph,
        pose: &NumericPose,
        tangent: &[f64],
        length: f64,
    ) -> Option<NumericPose> {
        const ROUNDS: usize = 3;
        /// Length of the way back as a fraction of the step's.
        const FAR: f64 = 0.25;
        let mut pose = pose.clone();
        self.shift(&mut pose, tangent, length);
        for _ in 0..ROUNDS {
            let slopes = pose.matrix(graph, &self.slopes);
            let Some(back) = least_step(&slopes, &pose.all(graph, &self.zeros)) else { break };
            if dot(&back, &back).sqrt() > FAR * length {
                return None;
            }
            self.shift(&mut pose, &back, -1.0);
        }
        Some(pose)
    }

    fn shift(&self, pose: &mut NumericPose, by: &[f64], factor: f64) {
        for ((place, size, _), by) in self.places.iter().zip(by) {
            pose.set(*place, pose.get(*place) + factor * size * by);
        }
    }

    /// Returns the share of the dependent speeds' determinant in the volume of the rows, with its
    /// sign; `None` if the rows depend on one another.
    fn share(&self, graph: &Graph, pose: &NumericPose) -> Option<f64> {
        const DEPENDENT: f64 = 1e-12;
        let rows = pose.matrix(graph, &self.rows);
        let own = rows.iter().map(|row| self.pivots.iter().map(|j| row[*j]).collect());
        let squares = rows.iter().map(|row| rows.iter().map(|other| dot(row, other)).collect());
        let sizes: f64 = rows.iter().map(|row| dot(row, row)).product();
        let volume = determinant(squares.collect());
        (volume > DEPENDENT * sizes).then(|| determinant(own.collect()) / volume.sqrt())
    }
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

fn determinant(mut matrix: Vec<Vec<f64>>) -> f64 {
    let mut product = 1.0;
    for k in 0..matrix.len() {
        let size = |r: &usize| matrix[*r][k].abs();
        let Some(largest) = (k..matrix.len()).max_by(|x, y| size(x).total_cmp(&size(y))) else {
            return product;
        };
        if largest != k {
            matrix.swap(k, largest);
            product = -product;
        }
        let pivot = matrix[k].clone();
        product *= pivot[k];
        for row in &mut matrix[k + 1..] {
            let factor = row[k] / pivot[k];
            row.iter_mut().zip(&pivot).for_each(|(entry, by)| *entry -= factor * by);
        }
    }
    product
}
