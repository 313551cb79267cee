//! Consistency checks of a mode's constraints.

use super::error::DerivationObstacle;
use super::generalised::inner;
use super::numeric;
use super::speeds::{SpeedMap, SpeedProblem, VelocityRow};
use crate::kane::graph::{Node, Place};

/// Rate of a constraint (per unit of speed) from which on it is not met.
const UNMET: f64 = 1e-6;

impl SpeedProblem<'_> {
    pub(super) fn check_rank(&self, rows: &[VelocityRow]) -> Result<(), Vec<DerivationObstacle>> {
        let n = self.mechanism.speeds.len();
        let slopes: Vec<Vec<Node>> = rows.iter().map(|row| row.slopes[..n].to_vec()).collect();
        let values = self.pose.matrix(self.graph, &slopes);
        let rank = numeric::pivots(values, &[(0..n).collect()]).len();
        if rank == rows.len() { Ok(()) } else { Err(self.dependent(rows)) }
    }

    pub(super) fn dependent(&self, rows: &[VelocityRow]) -> Vec<DerivationObstacle> {
        vec![DerivationObstacle::DependentConstraints { constraints: self.names(rows) }]
    }

    pub(super) fn names(&self, rows: &[VelocityRow]) -> Vec<String> {
        let constraints = rows.iter().filter_map(|row| row.constraint);
        constraints.map(|c| self.mechanism.constraints[c].name.clone()).collect()
    }

    /// Checks that stated coordinates in constraints follow from these, not as a further condition.
    pub(super) fn check_stated(
        &self,
        rows: &[VelocityRow],
        count: usize,
    ) -> Result<(), Vec<DerivationObstacle>> {
        let mut unmet = Vec::new();
        for more in &rows[count..] {
            let Some(speed) = more.stated else { continue };
            let touching = rows[..count].iter().find(|row| !self.graph.is_zero(row.slopes[speed]));
            if let Some(constraint) = touching.and_then(|row| row.constraint) {
                let constraint = self.mechanism.constraints[constraint].name.clone();
                unmet.push(DerivationObstacle::UnmetConstraint { constraint });
            }
        }
        if unmet.is_empty() { Ok(()) } else { Err(unmet) }
    }

    /// Checks that the speeds meet every constraint, also those that stated coordinates replace.
    pub(super) fn check_met(&mut self, map: &SpeedMap) -> Result<(), Vec<DerivationObstacle>> {
        let mut moving = self.nearby.clone();
        moving.set(Place::Input(1), 1.0);
        let mut unmet = Vec::new();
        for row in &map.rows {
            let Some(constraint) = row.constraint else { continue };
            if map.held.iter().any(|it| it.constraint == row.constraint) {
                continue;
            }
            let columns = (0..map.independent.len())
                .map(|k| map.slopes.iter().map(|it| it[k]).collect::<Vec<_>>());
            let mut left: Vec<Node> = Vec::new();
            for column in columns {
                left.push(inner(self.graph, &row.slopes, &column));
            }
            let moved = inner(self.graph, &row.slopes, &map.offset);
            left.push(self.graph.add(moved, row.rest));
            let size =
                moving.all(self.graph, &row.slopes).iter().fold(1.0, |m, it| f64::max(m, it.abs()));
            let worst =
                moving.all(self.graph, &left).iter().fold(0.0, |m, it| f64::max(m, it.abs()));
            if worst.is_nan() || worst > UNMET * size {
                let constraint = self.mechanism.constraints[constraint].name.clone();
                unmet.push(DerivationObstacle::UnmetConstraint { constraint });
            }
        }
        if unmet.is_empty() { Ok(()) } else { Err(unmet) }
    }
}
