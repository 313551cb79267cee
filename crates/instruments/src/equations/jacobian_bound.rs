//! The fastest rate of a mode: a bound of the magnitude of its Jacobian's eigenvalues.

use pode::State;

/// A step of the fastest motion (rad).
pub(crate) const RADIANS: f64 = 0.75;

/// Rounds of the power iteration; a few oscillators need about six.
const ROUNDS: usize = 12;

/// Returns an upper bound of the eigenvalues' magnitudes for the rows and columns of `entries`: of
/// the Perron root of their magnitudes, which for one oscillator is its rate.
///
/// For any positive v the root is at most the largest of (A v)_i/v_i (Collatz and Wielandt). Each
/// round uses the geometric mean of v and A v, which converges to the eigenvector even where A v
/// alone would oscillate, as between coordinates and speeds.
pub(crate) fn fastest<const N: usize>(rows: &[[f64; N]; N], entries: u64, rounds: usize) -> f64 {
    /// Largest decrease of an entry in one round.
    const FLOOR: f64 = 1e-6;
    let has = |index: usize| entries >> (index & 63) & 1 == 1;
    let count = (u64::BITS - entries.leading_zeros()) as usize;
    let mut v = [1.0; N];
    let mut least = f64::INFINITY;
    for _ in 0..rounds {
        let mut ratio = [0.0; N];
        for (i, (ratio, row)) in ratio.iter_mut().zip(rows).enumerate().take(count) {
            let row = row.iter().zip(&v).enumerate().take(count).filter(|(j, _)| has(*j));
            let sum: f64 = row.map(|(_, (a, v))| a.abs() * v).sum();
            *ratio = if has(i) { sum / v[i] } else { 0.0 };
        }
        let most = ratio.iter().fold(0.0, |most: f64, it| if *it > most { *it } else { most });
        least = least.min(most);
        if most <= 0.0 {
            break;
        }
        for (v, ratio) in v.iter_mut().zip(&ratio).take(count) {
            *v *= pode::math::sqrt((ratio / most).max(FLOOR));
        }
    }
    if least.is_finite() { least } else { 0.0 }
}

pub(crate) fn fastest_once<const N: usize>(rows: &[[f64; N]; N], entries: u64) -> f64 {
    fastest(rows, entries, ROUNDS)
}

pub(crate) fn matrix<const N: usize>(rows: &[[f64; N]; N]) -> <[f64; N] as State>::Matrix {
    pode::Matrix::from_columns(|column: usize| rows.map(|row| row[column]))
}

#[cfg(test)]
mod tests {
    use super::fastest_once;

    #[test]
    fn one_oscillator_has_its_own_rate() {
        let rows = [[0.0, 1.0], [-1e4, 0.0]];
        assert!((fastest_once(&rows, 3) - 100.0).abs() < 1e-9);
        assert!(fastest_once(&[[0.0, 1.0], [0.0, 0.0]], 3) < 1e-3, "a free mass has none");
    }

    #[test]
    fn no_eigenvalue_is_larger_and_the_bound_is_close() {
        // Masses of 1 and 0.25 kg: k = 100 N/m to the ground, 400 N/m between them.
        let rows = [
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
            [-500.0, 400.0, 0.0, 0.0],
            [1600.0, -1600.0, 0.0, 0.0],
        ];
        // ω⁴ − 2100 ω² + 160000 = 0; with magnitudes the root is the same: the graph is a tree.
        let rate = (1050.0 + (1050.0_f64.powi(2) - 160_000.0).sqrt()).sqrt();
        let found = fastest_once(&rows, 15);
        assert!(found >= rate * (1.0 - 1e-12) && found < 1.02 * rate, "{found} for {rate}");
    }
}
