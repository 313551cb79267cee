use super::numeric::NumericPose;
use crate::kane::graph::{Graph, Node, NodeOperation};

/// Fraction of the largest generalised mass below which a pivot counts as 0.
const NEGLIGIBLE: f64 = 1e-13;

/// Mass matrix as L D Lᵀ in an order of its rows that keeps L sparse.
#[derive(Clone, Debug, Default)]
pub(super) struct MassFactor {
    order: Vec<usize>,
    pivots: Vec<Node>,
    /// Entries of L below the diagonal, by original rows and columns.
    lower: Vec<Vec<Option<Node>>>,
}

impl MassFactor {
    /// Returns the factors of `matrix`, or the row without a pivot at `pose`.
    pub(super) fn of(
        graph: &mut Graph,
        pose: &NumericPose,
        mut matrix: Vec<Vec<Node>>,
    ) -> Result<Self, usize> {
        let n = matrix.len();
        let diagonal: Vec<Node> = (0..n).map(|i| matrix[i][i]).collect();
        let sizes: Vec<f64> = pose.all(graph, &diagonal).into_iter().map(f64::abs).collect();
        let mut left: Vec<usize> = (0..n).collect();
        let mut factor =
            Self { order: Vec::new(), pivots: Vec::new(), lower: vec![vec![None; n]; n] };
        while let Some(row) = next(graph, &matrix, &left) {
            left.retain(|it| *it != row);
            let pivot = matrix[row][row];
            let value = pose.value(graph, pivot);
            if value.is_nan() || value <= NEGLIGIBLE * sizes[row] || value <= f64::MIN_POSITIVE {
                return Err(row);
            }
            for i in
                left.iter().copied().filter(|i| !graph.is_zero(matrix[*i][row])).collect::<Vec<_>>()
            {
                let by = graph.divide(matrix[i][row], pivot);
                factor.lower[i][row] = Some(by);
            }
            for i in &left {
                factor.take_out(graph, &mut matrix, [row, *i], &left);
            }
            factor.order.push(row);
            factor.pivots.push(pivot);
        }
        Ok(factor)
    }

    /// Eliminates a pivot's row from the row `i`; rows in `left` keep their columns.
    fn take_out(
        &mut self,
        graph: &mut Graph,
        matrix: &mut [Vec<Node>],
        [row, i]: [usize; 2],
        left: &[usize],
    ) {
        if graph.is_zero(matrix[i][row]) {
            return;
        }
        let by = graph.divide(matrix[i][row], matrix[row][row]);
        self.lower[i][row] = Some(by);
        for j in left {
            let taken = graph.multiply(by, matrix[row][*j]);
            matrix[i][*j] = graph.subtract(matrix[i][*j], taken);
        }
    }

    /// Returns x of L D Lᵀ x = `right`.
    pub(super) fn solve(&self, graph: &mut Graph, right: &[Node]) -> Vec<Node> {
        let mut x = right.to_vec();
        for (at, row) in self.order.iter().enumerate() {
            for later in &self.order[at + 1..] {
                x[*later] = without(graph, x[*later], self.lower[*later][*row], x[*row]);
            }
        }
        for (row, pivot) in self.order.iter().zip(&self.pivots) {
            x[*row] = graph.divide(x[*row], *pivot);
        }
        for (at, row) in self.order.iter().enumerate().rev() {
            for later in &self.order[at + 1..] {
                x[*row] = without(graph, x[*row], self.lower[*later][*row], x[*later]);
            }
        }
        x
    }
}

fn without(graph: &mut Graph, x: Node, by: Option<Node>, y: Node) -> Node {
    let Some(by) = by else { return x };
    let taken = graph.multiply(by, y);
    graph.subtract(x, taken)
}

/// Returns the next row: the one with the fewest others, a constant one before a moving one.
fn next(graph: &Graph, matrix: &[Vec<Node>], left: &[usize]) -> Option<usize> {
    left.iter().copied().min_by_key(|row| {
        let others = left.iter().filter(|c| *c != row && !graph.is_zero(matrix[*row][**c])).count();
        let diagonal = graph.operation(matrix[*row][*row]);
        let terms = if let NodeOperation::Sum(_, terms) = diagonal { terms.len() } else { 1 };
        (others, terms, *row)
    })
}
