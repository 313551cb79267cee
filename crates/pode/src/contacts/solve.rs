//! The forces that hold several contacts at once: a small symmetric system.

use crate::contacts::MAX_FRICTIONS;

/// Change of the slip accelerations per unit of each force: row by slip, column by force. Symmetric
/// and without negative eigenvalues where slips and forces match, as in mechanics.
pub(super) type Mobility = [[f64; MAX_FRICTIONS]; MAX_FRICTIONS];

pub(super) type PerFriction = [f64; MAX_FRICTIONS];

/// Relative size below which a pivot is rounding: other contacts can hold this one.
const DEPENDENT: f64 = 1e-11;

/// The factor B of W = B Bᵀ, of the rank of W; rows in the order of the contacts.
struct Factor {
    b: Mobility,
    order: [usize; MAX_FRICTIONS],
    rank: usize,
}

/// Solves W λ = b for the first `n` entries with the least norm; ignores what no λ can reach.
pub(super) fn least_norm(w: &Mobility, b: &PerFriction, n: usize) -> PerFriction {
    let factor = factor(w, n);
    if factor.rank == n {
        return solve_regular(&factor, b, n);
    }
    // W⁺ = B (BᵀB)⁻² Bᵀ, and BᵀB is regular.
    let gram = gram(&factor, n);
    let mut y = transposed(&factor, b, n);
    for _ in 0..2 {
        y = solve_regular(&gram, &y, factor.rank);
    }
    applied(&factor, &y, n)
}

/// Cholesky with diagonal pivots, until the rest is rounding.
fn factor(w: &Mobility, n: usize) -> Factor {
    let mut it = Factor { b: [[0.0; MAX_FRICTIONS]; MAX_FRICTIONS], order: [0; _], rank: 0 };
    let mut rest: PerFriction = core::array::from_fn(|i| w[i][i]);
    let mut is_free = [true; MAX_FRICTIONS];
    for k in 0..n {
        // The pivot with the largest fraction of its own entry left, in any units.
        // A force that pushes away from zero cannot hold.
        let part = |i: usize| if w[i][i] > 0.0 { rest[i] / w[i][i] } else { 0.0 };
        let best = (0..n).filter(|i| is_free[*i] && part(*i) > DEPENDENT);
        let Some(pivot) = best.max_by(|i, j| part(*i).total_cmp(&part(*j))) else { break };
        is_free[pivot] = false;
        it.order[k] = pivot;
        it.rank = k + 1;
        let diagonal = crate::math::sqrt(rest[pivot]);
        it.b[pivot][k] = diagonal;
        for i in (0..n).filter(|i| is_free[*i]) {
            let known: f64 = (0..k).map(|j| it.b[i][j] * it.b[pivot][j]).sum();
            let entry = (w[i][pivot] - known) / diagonal;
            it.b[i][k] = entry;
            rest[i] -= entry * entry;
        }
    }
    it
}

fn solve_regular(it: &Factor, b: &PerFriction, n: usize) -> PerFriction {
    let mut y = [0.0; MAX_FRICTIONS];
    for k in 0..n {
        let row = it.order[k];
        let known: f64 = (0..k).map(|j| it.b[row][j] * y[j]).sum();
        y[k] = (b[row] - known) / it.b[row][k];
    }
    let mut x = [0.0; MAX_FRICTIONS];
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| it.b[it.order[j]][k] * x[it.order[j]]).sum();
        x[it.order[k]] = (y[k] - known) / it.b[it.order[k]][k];
    }
    x
}

fn gram(it: &Factor, n: usize) -> Factor {
    let mut gram = [[0.0; MAX_FRICTIONS]; MAX_FRICTIONS];
    for (i, row) in gram.iter_mut().enumerate().take(it.rank) {
        for (j, entry) in row.iter_mut().enumerate().take(it.rank) {
            *entry = (0..n).map(|k| it.b[k][i] * it.b[k][j]).sum();
        }
    }
    factor(&gram, it.rank)
}

fn transposed(it: &Factor, x: &PerFriction, n: usize) -> PerFriction {
    core::array::from_fn(|j| (0..n).map(|i| it.b[i][j] * x[i]).sum())
}

fn applied(it: &Factor, y: &PerFriction, n: usize) -> PerFriction {
    core::array::from_fn(
        |i| if i < n { (0..it.rank).map(|j| it.b[i][j] * y[j]).sum() } else { 0.0 },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// J Jᵀ for the rows `jacobian`.
    fn mobility<const N: usize>(jacobian: &[[f64; N]]) -> Mobility {
        let mut w = [[0.0; MAX_FRICTIONS]; MAX_FRICTIONS];
        for (i, a) in jacobian.iter().enumerate() {
            for (j, b) in jacobian.iter().enumerate() {
                w[i][j] = a.iter().zip(b).map(|(a, b)| a * b).sum();
            }
        }
        w
    }

    fn column(entries: &[f64]) -> PerFriction {
        core::array::from_fn(|i| entries.get(i).copied().unwrap_or(0.0))
    }

    #[track_caller]
    fn check<const N: usize>(jacobian: &[[f64; N]], b: &[f64], expected: &[f64]) {
        let found = least_norm(&mobility(jacobian), &column(b), b.len());
        for (found, expected) in found.iter().zip(column(expected)) {
            assert!(
                (found - expected).abs() < 1e-12 * (1.0 + expected.abs()),
                "{found} {expected}"
            );
        }
    }

    #[test]
    fn independent_contacts_have_the_one_solution() {
        // W = [[1, 1], [1, 2]]; then with rows of very different units.
        check(&[[1.0, 0.0], [1.0, 1.0]], &[1.0, 3.0], &[-1.0, 2.0]);
        check(&[[1e-6, 0.0], [1e6, 1e6]], &[1e-6, 3e6], &[-1e6, 2e-6]);
    }

    #[test]
    fn contacts_that_hold_the_same_motion_share_it_evenly() {
        check(&[[1.0], [1.0]], &[4.0, 4.0], &[2.0, 2.0]);
        // Least norm: in proportion to each row.
        check(&[[1.0], [3.0]], &[10.0, 30.0], &[1.0, 3.0]);
        check(&[[1.0, 0.0], [0.0, 2.0], [1.0, 0.0]], &[4.0, 8.0, 4.0], &[2.0, 2.0, 2.0]);
    }

    #[test]
    fn what_cannot_be_held_gets_no_force() {
        check(&[[0.0], [1.0]], &[5.0, 2.0], &[0.0, 2.0]);
        check::<1>(&[], &[], &[]);
    }
}
