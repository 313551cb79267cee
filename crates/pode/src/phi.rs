//! The φ functions of a matrix, by scaling and squaring.

use crate::math::sqrt;
use crate::state::Matrix as _;
use crate::state::{State, largest};

/// eᴬ and k! φₖ(A) for k = 1, 2, 3. k! φₖ(z) = k ∫₀¹ (1 − s)ᵏ⁻¹ eˢᶻ ds is a mean of the
/// exponential, 1 at z = 0, so that the solution of x' = A x + r0 + r1 t + r2 t² at 1 is x0 + p1 (A
/// x0 + r0) + p2 r1/2 + p3 r2/3.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Phi<S: State> {
    exp: S::Matrix,
    pub(crate) p1: S::Matrix,
    pub(crate) p2: S::Matrix,
    pub(crate) p3: S::Matrix,
}

/// Coefficients of 6 φ3(z), each the one before divided by (j + 3), to z¹⁵: exact for |z| ≤ 1.
const SERIES: [f64; 16] = {
    let (mut series, mut j) = ([1.0; 16], 1);
    while j < 16 {
        series[j] = series[j - 1] / (j + 3) as f64;
        j += 1;
    }
    series
};

impl<S: State> Phi<S> {
    /// Computes the functions of h A/4, h A/2 and h A. h A is halved until its series is short, at
    /// most 64 times, and the functions are doubled as often: at most 10 + 4 · 64 products. The
    /// error is a few ε (1 + |h A|) of the largest entries. If A is not finite, or h A too large
    /// for any right digit, they are not finite.
    pub(crate) fn quarters(a: &S::Matrix, h: f64) -> [Self; 3] {
        let mut powers = [*a; 4];
        for n in 1..4 {
            powers[n] = powers[n - 1].product(a);
        }
        let (halvings, part) = halvings(size::<S>(a), h);
        let mut quarter = Self::series(&powers, part);
        for _ in 2..halvings {
            quarter = quarter.doubled();
        }
        let half = quarter.doubled();
        [quarter, half, half.doubled()]
    }

    /// Sums the functions of `part` · A by Taylor series, from A, A², A³ and A⁴. `[PS73]`
    fn series(powers: &[S::Matrix; 4], part: f64) -> Self {
        let [a, a2, a3, a4] = powers;
        let (part2, part3) = (part * part, part * part * part);
        let mut p3 = S::Matrix::ONE;
        for block in [12, 8, 4, 0] {
            let tail = p3;
            let c = |j: usize| SERIES[block + j] / SERIES[block];
            p3 = S::Matrix::ONE.plus(c(1) * part, a).plus(c(2) * part2, a2).plus(c(3) * part3, a3);
            if block < 12 {
                p3 = p3.plus(c(4) * part2 * part2, &a4.product(&tail));
            }
        }
        // z φₖ₊₁ = φₖ − 1/k!
        let p2 = S::Matrix::ONE.plus(part / 3.0, &a.product(&p3));
        let p1 = S::Matrix::ONE.plus(part / 2.0, &a.product(&p2));
        let exp = S::Matrix::ONE.plus(part, &a.product(&p1));
        Self { exp, p1, p2, p3 }
    }

    /// Computes the functions of 2 A from those of A. `[BSW07]`
    fn doubled(&self) -> Self {
        let Self { exp, p1, p2, p3 } = self;
        let half = |m: &S::Matrix| m.plus(-0.5, m);
        let mean = |m: &S::Matrix| half(&exp.product(m).plus(1.0, m));
        let mean2 = mean(p2);
        Self {
            exp: exp.product(exp),
            p1: mean(p1),
            p2: half(&mean2.plus(1.0, p1)),
            p3: half(&half(&mean(p3).plus(1.5, &p1.plus(1.0, p2)))),
        }
    }
}

/// Returns the number of halvings, at least two, of a matrix of the size `size` (1/s) over `h` (s)
/// after which the series holds, and the rest of `h`.
fn halvings(size: f64, h: f64) -> (u32, f64) {
    const MOST: u32 = 64;
    let (mut halvings, mut part) = (2, 0.25 * h);
    while halvings < MOST && part * size > 1.0 {
        (halvings, part) = (halvings + 1, 0.5 * part);
    }
    (halvings, if part * size <= 1.0 { part } else { f64::NAN })
}

/// Approximates the least row sum of magnitudes in any units of the state's entries: at least the
/// largest eigenvalue of the magnitudes. `[HJ13]` theorem 8.1.26
///
/// Rounding does not depend on the units, but the row sum of a stiff oscillator is as large as its
/// stiffness, and would cause many useless halvings.
fn size<S: State>(a: &S::Matrix) -> f64 {
    const ROUNDS: u32 = 8;
    const LEAST: f64 = 1.0 / 65536.0;
    let column = |index| a.apply(&S::ZERO.with_entry(index, 1.0));
    let magnitudes = S::Matrix::from_columns(|index| mapped(&column(index), |_, it| it.abs()));
    let (mut units, mut least) = (mapped(&S::ZERO, |_, _| 1.0), f64::INFINITY);
    for _ in 0..ROUNDS {
        let ratios = mapped(&magnitudes.apply(&units), |index, sum| sum / units.entries()[index]);
        let most = largest(&ratios);
        least = least.min(most);
        units =
            mapped(&units, |index, unit| unit * sqrt((ratios.entries()[index] / most).max(LEAST)));
    }
    least
}

fn mapped<S: State>(x: &S, f: impl Fn(usize, f64) -> f64) -> S {
    let entries = x.entries().iter().enumerate();
    entries.fold(*x, |mapped, (index, entry)| mapped.with_entry(index, f(index, *entry)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::Matrix;

    type Square = <[f64; 2] as State>::Matrix;

    fn matrix(columns: [[f64; 2]; 2]) -> Square {
        <Square as Matrix<[f64; 2]>>::from_columns(|index| columns[index])
    }

    fn phi(entries: [f64; 4], h: f64) -> [[[f64; 2]; 2]; 3] {
        let [a, b, c, d] = entries;
        let [_, _, whole] = Phi::<[f64; 2]>::quarters(&matrix([[a, c], [b, d]]), h);
        [whole.p1, whole.p2, whole.p3].map(|p| [p.apply(&[1.0, 0.0]), p.apply(&[0.0, 1.0])])
    }

    #[track_caller]
    fn check(what: impl core::fmt::Display, found: [f64; 3], expected: [f64; 3], tolerance: f64) {
        for (k, (found, expected)) in found.into_iter().zip(expected).enumerate() {
            let error = (found - expected).abs();
            assert!(error <= tolerance, "{what}, k = {}: {found} is {error:e} off", k + 1);
        }
    }

    /// Returns k! φₖ(z) by its series where that is short, by eᶻ where nothing cancels.
    fn exact(z: f64) -> [f64; 3] {
        if z.abs() > 2.0 {
            let p1 = z.exp_m1() / z;
            let p2 = 2.0 * (p1 - 1.0) / z;
            return [p1, p2, 3.0 * (p2 - 1.0) / z];
        }
        [1.0, 2.0, 3.0].map(|k| {
            let (mut term, mut sum) = (1.0, 1.0);
            for j in 1..40 {
                term *= z / (f64::from(j) + k);
                sum += term;
            }
            sum
        })
    }

    #[test]
    fn numbers_have_theirs_to_rounding() {
        for n in -500..=500 {
            let z = 0.1 * f64::from(n);
            // In the diagonal, and in the mean and the half difference of a full matrix.
            let found = phi([z, 0.0, 0.0, 0.5 * z], 1.0).map(|[p, _]| p[0]);
            let (expected, half) = (exact(z), exact(0.5 * z));
            let tolerance = 4.0 * f64::EPSILON * (1.0 + z.abs()) * expected[0].max(1.0);
            check(format_args!("{z}"), found, expected, tolerance);
            let full = phi([0.75 * z, 0.25 * z, 0.25 * z, 0.75 * z], 1.0);
            let mean = [0, 1, 2].map(|k| 0.5 * (expected[k] + half[k]));
            check(format_args!("mean of {z}"), full.map(|[p, _]| p[0]), mean, tolerance);
            let rest = [0, 1, 2].map(|k| 0.5 * (expected[k] - half[k]));
            check(format_args!("difference of {z}"), full.map(|[p, _]| p[1]), rest, tolerance);
        }
    }

    #[test]
    fn an_oscillator_has_sines_and_cosines_however_stiff() {
        for w in [1.0, 10.0, 1e3, 1e6] {
            for radians in [0.01_f64, 0.5, 3.0, 10.0, 50.0] {
                let (h, z) = (radians / w, radians);
                // q'' = −w² q under a constant force: q = (1 − cos)/w², q' = sin/w.
                let [p1, ..] = phi([0.0, 1.0, -w * w, 0.0], h);
                let [q, dq] = p1[1].map(|it| it * h);
                let tolerance = 4.0 * f64::EPSILON * (1.0 + z);
                let versine = 2.0 * (0.5 * z).sin().powi(2);
                assert!((q * w * w - versine).abs() <= tolerance, "w {w}, {radians} rad: {q}");
                assert!((dq * w - z.sin()).abs() <= tolerance, "w {w}, {radians} rad: {dq}");
            }
        }
    }

    #[test]
    fn a_free_body_under_jerk_moves_by_powers_of_time() {
        // Nilpotent: q' = v, and v' = 1, t and t² after p1, p2/2 and p3/3.
        let found = phi([0.0, 1.0, 0.0, 0.0], 2.0).map(|[_, p]| p);
        assert_eq!(found, [[1.0, 1.0], [2.0 / 3.0, 1.0], [0.5, 1.0]]);
    }

    #[test]
    fn the_quarter_and_the_half_are_those_of_shorter_steps() {
        let matrix = matrix([[-3.0, 40.0], [-7.0, 1.0]]);
        let [quarter, half, whole] = Phi::<[f64; 2]>::quarters(&matrix, 2.0);
        for (short, h) in [(quarter, 0.5), (half, 1.0), (whole, 2.0)] {
            let [_, _, alone] = Phi::<[f64; 2]>::quarters(&matrix, h);
            for (a, b) in [(short.p1, alone.p1), (short.p2, alone.p2), (short.p3, alone.p3)] {
                assert!((a - b).abs().max() < 1e-13 * b.abs().max(), "{h}");
            }
        }
    }

    #[test]
    fn what_is_not_finite_or_far_too_large_gives_nothing_finite() {
        for entry in [f64::NAN, f64::INFINITY, -1e300, -1e30, -2e19] {
            let [p1, p2, p3] = phi([entry, 0.0, 0.0, entry], 1.0);
            for p in [p1, p2, p3] {
                assert!(!p[0][0].is_finite() && !p[1][1].is_finite(), "{entry}: {p:?}");
            }
        }
    }
}
