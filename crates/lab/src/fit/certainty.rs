use nalgebra_of_lm::{DMatrix, DVector};

/// Share of a direction's largest parameter from which a parameter belongs to it.
const SHARE: f64 = 0.3;

/// Uncertainty of values, from a Jacobian and the remaining differences.
pub(super) struct FitCertainty {
    /// Half of each 95 % interval (the parameter's unit).
    pub(super) halves: Vec<f64>,
    pub(super) correlations: DMatrix<f64>,
    /// Singular values of the scaled parameters, least first, with their directions.
    directions: Vec<(f64, DVector<f64>)>,
}

/// Size of the remaining differences.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct RemainingSpread {
    /// Standard deviation over the stated or estimated noise.
    pub(super) deviation: f64,
    pub(super) rows: f64,
}

impl RemainingSpread {
    /// Measures the differences of each stroke, less the degrees of freedom of `fitted` parameters.
    /// Neighbours with the correlation r count as (1 - r)/(1 + r) of independent rows.
    pub(super) fn new(strokes: &[&[f64]], fitted: usize) -> Self {
        let products = |lag: usize| {
            let all = strokes.iter().flat_map(|it| it.iter().zip(it.iter().skip(lag)));
            all.map(|(a, b)| a * b).sum::<f64>()
        };
        let count = strokes.iter().map(|it| it.len()).sum::<usize>() as f64;
        let squares = products(0);
        let alike = if squares > 0.0 { (products(1) / squares).clamp(0.0, 0.99) } else { 0.0 };
        let rows = count * (1.0 - alike) / (1.0 + alike);
        let free = (count - fitted as f64).max(1.0);
        Self { deviation: (squares / free).sqrt(), rows: rows.max(fitted as f64 + 1.0) }
    }
}

impl FitCertainty {
    /// Computes the covariance s²(JᵀJ)⁻¹ from the singular values of the Jacobian with its columns
    /// scaled by `sizes`, and adds the effect of the changes `shaken` of the differences.
    pub(super) fn new(
        jacobian: &DMatrix<f64>,
        sizes: &[f64],
        (spread, shaken): (RemainingSpread, &[DVector<f64>]),
    ) -> Self {
        let (rows, n) = jacobian.shape();
        let scaled = jacobian * DMatrix::from_diagonal(&DVector::from_column_slice(sizes));
        let decomposed = scaled.clone().svd(false, true);
        let least = f64::MIN_POSITIVE.sqrt();
        let mut directions: Vec<_> = decomposed.v_t.map_or_else(Vec::new, |v_t| {
            let singular = decomposed.singular_values.iter();
            singular.zip(v_t.row_iter()).map(|(s, row)| (s.max(least), row.transpose())).collect()
        });
        directions.sort_by(|a, b| a.0.total_cmp(&b.0));
        let inverse = directions.iter().fold(DMatrix::zeros(n, n), |sum, (singular, v)| {
            sum + v * v.transpose() / (singular * singular)
        });
        let alike = (rows as f64 / spread.rows).max(1.0);
        let mut covariance = &inverse * (spread.deviation * spread.deviation * alike);
        for change in shaken {
            let moved = &inverse * (scaled.transpose() * change);
            covariance += &moved * moved.transpose() / shaken.len() as f64;
        }
        let t = student(spread.rows - n as f64);
        let of = |i: usize| covariance[(i, i)].max(0.0).sqrt();
        Self {
            halves: (0..n).map(|i| t * of(i) * sizes[i]).collect(),
            correlations: DMatrix::from_fn(n, n, |i, j| covariance[(i, j)] / (of(i) * of(j))),
            directions,
        }
    }

    /// Returns the worst parameter with an interval wider than its size, and possible substitutes.
    pub(super) fn undetermined(&self, sizes: &[f64]) -> Option<(usize, Vec<usize>)> {
        let width = |at: &usize| self.halves[*at] / sizes[*at];
        let worst = (0..sizes.len()).max_by(|a, b| width(a).total_cmp(&width(b)))?;
        // A width that is NaN cannot be trusted.
        if width(&worst) <= 1.0 {
            return None;
        }
        let (_, direction) = self.directions.iter().max_by(|a, b| {
            let share = |it: &(f64, DVector<f64>)| (it.1[worst] / it.0).abs();
            share(a).total_cmp(&share(b))
        })?;
        let largest = direction.amax();
        let with = (0..sizes.len()).filter(|at| *at != worst);
        Some((worst, with.filter(|at| direction[*at].abs() > SHARE * largest).collect()))
    }
}

/// Returns Student's t, with 95 % between -t and t, for these degrees of freedom. Abramowitz &
/// Stegun 26.7.5, correct to 1 % from 3 degrees on; fewer count as 3.
fn student(freedom: f64) -> f64 {
    const Z: f64 = 1.959_964;
    let v = freedom.max(3.0);
    let (z3, z5, z7) = (Z.powi(3), Z.powi(5), Z.powi(7));
    Z + (z3 + Z) / (4.0 * v)
        + (5.0 * z5 + 16.0 * z3 + 3.0 * Z) / (96.0 * v * v)
        + (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * Z) / (384.0 * v.powi(3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn student_s_t_is_that_of_the_tables() {
        for (freedom, t) in [(3.0, 3.182), (5.0, 2.571), (10.0, 2.228), (1e6, 1.960)] {
            assert!((student(freedom) / t - 1.0).abs() < 0.01, "{}", student(freedom));
        }
    }

    #[test]
    fn a_line_s_interval_is_the_textbook_s_and_a_sum_is_not_told_apart() {
        let x: Vec<_> = (0..101).map(|it| f64::from(it) / 50.0 - 1.0).collect();
        let line = DMatrix::from_fn(101, 2, |row, column| if column == 0 { 1.0 } else { x[row] });
        let spread = RemainingSpread { deviation: 0.1, rows: 101.0 };
        let found = FitCertainty::new(&line, &[1.0, 1.0], (spread, &[]));
        let sum = x.iter().map(|it| it * it).sum::<f64>();
        let expected = [0.1 / 101.0_f64.sqrt(), 0.1 / sum.sqrt()].map(|it| 1.984 * it);
        for (half, expected) in found.halves.iter().zip(expected) {
            assert!((half / expected - 1.0).abs() < 1e-3, "{half} {expected}");
        }
        assert_eq!(found.undetermined(&[1.0, 1.0]), None);
        let twice = DMatrix::from_fn(101, 3, |row, column| [1.0, x[row], 1.0][column]);
        let found = FitCertainty::new(&twice, &[1.0; 3], (spread, &[]));
        let (worst, with) = found.undetermined(&[1.0; 3]).expect("a sum");
        assert_eq!(worst + with[0], 2, "{worst} {with:?}");
    }

    #[test]
    fn rows_that_follow_each_other_count_as_fewer() {
        let alternating: Vec<_> = (0..100).map(|it| [1.0, -1.0][it % 2]).collect();
        assert_eq!(RemainingSpread::new(&[&alternating], 1).rows.to_bits(), 100.0_f64.to_bits());
        let slow: Vec<_> = (0..100).map(|it| (f64::from(it) / 10.0).sin()).collect();
        assert!(RemainingSpread::new(&[&slow], 1).rows < 10.0);
    }
}
