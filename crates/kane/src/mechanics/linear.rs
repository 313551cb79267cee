//! Small systems of linear equations, solved on the graph.
//!
//! Entries that are 0 by structure cost nothing. Of two unknowns that remain, determinants give
//! shorter expressions than elimination; pivots are the largest at the rest pose.

use super::numeric::NumericPose;
use crate::graph::{Graph, Node};

/// Equations A x = B with one column of B per right side.
pub(super) struct LinearSystem<'a> {
    graph: &'a mut Graph,
    pose: &'a NumericPose,
    a: Vec<Vec<Node>>,
    b: Vec<Vec<Node>>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// Rows and the unknowns to be found from them, backwards.
    later: Vec<(usize, usize)>,
    solution: Vec<Option<Vec<Node>>>,
}

/// Returns x of the square system A x = B, a row per unknown; none where A is singular at `pose`.
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
    /// Finds an unknown, or a row from which it follows later.
    fn advance(&mut self) -> Option<()> {
        if let Some((row, column)) = self.single(true) {
            let value = self.quotient(row, column)?;
            self.take(row, column);
            self.put_in(column, &value);
            self.solution[column] = Some(value);
            return Some(());
        }
        if let Some((row, column)) = self.single(false) {
            self.take(row, column);
            self.later.push((row, column));
            return Some(());
        }
        if self.rows.len() == 2 { self.determinants() } else { self.eliminate() }
    }

    fn is_zero(&self, row: usize, column: usize) -> bool {
        self.graph.is_zero(self.a[row][column])
    }

    /// A row with one unknown, or an unknown in one row.
    fn single(&self, is_row: bool) -> Option<(usize, usize)> {
        let (lines, others) =
            if is_row { (&self.rows, &self.columns) } else { (&self.columns, &self.rows) };
        lines.iter().find_map(|line| {
            let place = |other: &usize| if is_row { (*line, *other) } else { (*other, *line) };
            let mut filled = others.iter().map(place).filter(|(r, c)| !self.is_zero(*r, *c));
            let first = filled.next()?;
            filled.next().is_none().then_some(first)
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

    /// Puts a known unknown into the rows that remain.
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

    /// x = (b1 a22 − b2 a12)/det and y = (a11 b2 − a21 b1)/det.
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

    /// a b − c d.
    fn minor(&mut self, [a, b]: [Node; 2], [c, d]: [Node; 2]) -> Node {
        let (plus, minus) = (self.graph.multiply(a, b), self.graph.multiply(c, d));
        self.graph.subtract(plus, minus)
    }

    /// Takes the largest pivot out of the other rows.
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
        let mut best = (0.0, None);
        for row in &self.rows {
            let entries: Vec<Node> = self.columns.iter().map(|c| self.a[*row][*c]).collect();
            let sizes = self.pose.all(self.graph, &entries);
            for (column, size) in self.columns.iter().zip(sizes) {
                if size.abs() > best.0 {
                    best = (size.abs(), Some((*row, *column)));
                }
            }
        }
        best.1
    }

    /// What was put off, backwards.
    fn finish(mut self) -> Option<Vec<Vec<Node>>> {
        while let Some((row, column)) = self.later.pop() {
            let mut right = self.b[row].clone();
            for (other, known) in self.solution.iter().enumerate() {
                let (false, Some(known)) = (self.graph.is_zero(self.a[row][other]), known) else {
                    continue;
                };
                for (entry, value) in right.iter_mut().zip(known) {
                    let by = self.graph.multiply(self.a[row][other], *value);
                    *entry = self.graph.subtract(*entry, by);
                }
            }
            let pivot = self.a[row][column];
            if !self.is_regular(pivot) {
                return None;
            }
            let value = right.into_iter().map(|it| self.graph.divide(it, pivot)).collect();
            self.solution[column] = Some(value);
        }
        self.solution.into_iter().collect()
    }
}
