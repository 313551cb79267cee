//! Small systems of linear equations, solved on the graph.
//!
//! Entries that are 0 by structure cost nothing. For the last two unknowns, determinants give
//! shorter expressions than elimination; pivots are the largest at the rest pose.

use super::numeric::NumericPose;
use crate::kane::graph::{Graph, Node};

/// Equations A x = B with one column of B per right side.
pub(super) struct LinearSystem<'a> {
    graph: &'a mut Graph,
    pose: &'a NumericPose,
    a: Vec<Vec<Node>>,
    b: Vec<Vec<Node>>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// Rows and the unknowns to be found from them, in reverse order.
    later: Vec<(usize, usize)>,
    solution: Vec<Option<Vec<Node>>>,
}

/// Returns x of the square system A x = B, a row per unknown; `None` if A is singular at `pose`.
pub(super) fn solve(
    graph: &mut Graph,
    pose: &NumericPose,
    a: Vec<Vec<Node>>,
    b: Vec<Vec<Node>>,
) -> Option<Vec<Vec<Node>>> {
    let n = a.len();
    let rows: Vec<usize> = (0..n).collect();
    let mut system = LinearSystem {
        graph,
        pose,
        a,
        b,
        columns: rows.clone(),
        rows,
        later: Vec::new(),
        solution: vec![None; n],
    };
    while !system.rows.is_empty() {
        system.advance()?;
    }
    system.finish()
}

impl LinearSystem<'_> {
    /// Finds an unknown, or a row that gives it later.
    fn advance(&mut self) -> Option<()> {
        if let Some((row, column)) = self.single_unknown() {
            let value = self.quotient(row, column)?;
            self.take(row, column);
            self.put_in(column, &value);
            self.solution[column] = Some(value);
            return Some(());
        }
        if let Some((row, column)) = self.single_row() {
            self.take(row, column);
            self.later.push((row, column));
            return Some(());
        }
        if self.rows.len() == 2 { self.determinants() } else { self.eliminate() }
    }

    fn is_zero(&self, row: usize, column: usize) -> bool {
        self.graph.is_zero(self.a[row][column])
    }

    fn single_unknown(&self) -> Option<(usize, usize)> {
        self.rows.iter().find_map(|row| {
            let mut filled = self.columns.iter().filter(|column| !self.is_zero(*row, **column));
            let first = filled.next()?;
            filled.next().is_none().then_some((*row, *first))
        })
    }

    fn single_row(&self) -> Option<(usize, usize)> {
        self.columns.iter().find_map(|column| {
            let mut filled = self.rows.iter().filter(|row| !self.is_zero(**row, *column));
            let first = filled.next()?;
            filled.next().is_none().then_some((*first, *column))
        })
    }

    fn take(&mut self, row: usize, column: usize) {
        self.rows.retain(|it| *it != row);
        self.columns.retain(|it| *it != column);
    }

    fn quotient(&mut self, row: usize, column: usize) -> Option<Vec<Node>> {
        let pivot = self.a[row][column];
        if !self.is_regular(pivot) {
            return None;
        }
        let right = self.b[row].clone();
        Some(right.into_iter().map(|it| self.graph.divide(it, pivot)).collect())
    }

    fn is_regular(&self, pivot: Node) -> bool {
        let value = self.pose.value(self.graph, pivot);
        value != 0.0 && value.is_finite()
    }

    fn put_in(&mut self, column: usize, value: &[Node]) {
        for row in self.rows.clone() {
            if self.is_zero(row, column) {
                continue;
            }
            for (k, value) in value.iter().enumerate() {
                let known = self.graph.multiply(self.a[row][column], *value);
                self.b[row][k] = self.graph.subtract(self.b[row][k], known);
            }
        }
    }

    /// Solves x = (b1 a22 − b2 a12)/det and y = (a11 b2 − a21 b1)/det.
    fn determinants(&mut self) -> Option<()> {
        let ([r, s], [c, d]) = ([self.rows[0], self.rows[1]], [self.columns[0], self.columns[1]]);
        let [[a11, a12], [a21, a22]] = [r, s].map(|row| [c, d].map(|column| self.a[row][column]));
        let determinant = self.minor([a11, a22], [a12, a21]);
        if !self.is_regular(determinant) {
            return None;
        }
        let (mut first, mut second) = (Vec::new(), Vec::new());
        for k in 0..self.b[r].len() {
            let (b1, b2) = (self.b[r][k], self.b[s][k]);
            let x = self.minor([b1, a22], [b2, a12]);
            let y = self.minor([a11, b2], [a21, b1]);
            first.push(self.graph.divide(x, determinant));
            second.push(self.graph.divide(y, determinant));
        }
        self.solution[c] = Some(first);
        self.solution[d] = Some(second);
        self.rows.clear();
        self.columns.clear();
        Some(())
    }

    fn minor(&mut self, [a, b]: [Node; 2], [c, d]: [Node; 2]) -> Node {
        let (plus, minus) = (self.graph.multiply(a, b), self.graph.multiply(c, d));
        self.graph.subtract(plus, minus)
    }

    fn eliminate(&mut self) -> Option<()> {
        let (row, column) = self.largest()?;
        self.take(row, column);
        let pivot = self.a[row][column];
        for other in self.rows.clone() {
            if self.is_zero(other, column) {
                continue;
            }
            let factor = self.graph.divide(self.a[other][column], pivot);
            for c in self.columns.clone() {
                let by = self.graph.multiply(factor, self.a[row][c]);
                self.a[other][c] = self.graph.subtract(self.a[other][c], by);
            }
            for k in 0..self.b[row].len() {
                let by = self.graph.multiply(factor, self.b[row][k]);
                self.b[other][k] = self.graph.subtract(self.b[other][k], by);
            }
        }
        self.later.push((row, column));
        Some(())
    }

    fn largest(&self) -> Option<(usize, usize)> {
        let places = self.rows.iter().flat_map(|r| self.columns.iter().map(|c| (*r, *c)));
        let places: Vec<(usize, usize)> = places.collect();
        let entries: Vec<Node> = places.iter().map(|(r, c)| self.a[*r][*c]).collect();
        let sizes = self.pose.all(self.graph, &entries).into_iter().map(f64::abs);
        let regular = places.into_iter().zip(sizes).filter(|(_, size)| *size > 0.0);
        regular.rev().max_by(|x, y| x.1.total_cmp(&y.1)).map(|it| it.0)
    }

    fn finish(mut self) -> Option<Vec<Vec<Node>>> {
        while let Some((row, column)) = self.later.pop() {
            for other in 0..self.solution.len() {
                self.put_back(row, other);
            }
            let value = self.quotient(row, column)?;
            self.solution[column] = Some(value);
        }
        self.solution.into_iter().collect()
    }

    fn put_back(&mut self, row: usize, column: usize) {
        let Some(known) = self.solution[column].clone() else { return };
        if self.is_zero(row, column) {
            return;
        }
        for (k, value) in known.into_iter().enumerate() {
            let by = self.graph.multiply(self.a[row][column], value);
            self.b[row][k] = self.graph.subtract(self.b[row][k], by);
        }
    }
}
