//! Removes noise from travel: local cubics, as wide as the noise requires.

use nalgebra_of_lm::{Matrix4, Vector4};

use super::data::median;

/// Half widths of the windows that are tried (rows).
const WINDOWS: [usize; 8] = [3, 5, 8, 12, 18, 27, 40, 60];
/// Noise below which travel is not smoothed (m).
pub(super) const EXACT: f64 = 1e-8;
/// Allowed ratio of the removed part to the noise.
const EXCESS: f64 = 1.05;

/// Estimates the standard deviation of the noise in evenly sampled `values` from the median of
/// their third differences, so that corners do not count. For independent noise these have 20
/// times its variance, for a smooth motion almost none.
pub(super) fn noise(values: &[f64]) -> f64 {
    const MEDIAN: f64 = 0.674_5;
    let third = values.windows(4).map(|it| (it[3] - 3.0 * it[2] + 3.0 * it[1] - it[0]).abs());
    median(third.collect()) / MEDIAN / 20.0_f64.sqrt()
}

/// Removes the noise from `samples` (s, m): each lies on the weighted least-squares cubic through
/// its neighbours (Cleveland 1979), of the widest window that leaves no more than the noise.
pub(super) fn smoothed(samples: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let values: Vec<_> = samples.iter().map(|it| it.1).collect();
    let noise = noise(&values);
    let mut kept = samples.to_vec();
    if noise < EXACT {
        return kept;
    }
    let mut most = EXCESS * noise;
    for half in WINDOWS.into_iter().filter(|half| 2 * half < samples.len()) {
        let smooth: Vec<_> = (0..samples.len()).map(|at| local(samples, at, half)).collect();
        let squares = smooth.iter().zip(&values).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        // A cubic follows its middle row by about three rows' share of the window.
        let left = values.len() as f64 * (1.0 - 3.0 / (2.0 * half as f64 + 1.0));
        let deviation = (squares / left).sqrt();
        if half == WINDOWS[0] {
            // Of two estimates of the noise the larger counts.
            most = most.max(EXCESS * deviation);
        } else if deviation > most {
            break;
        }
        kept = samples.iter().zip(smooth).map(|((t, _), value)| (*t, value)).collect();
    }
    kept
}

/// Returns the value at the row `at` of the cubic through the rows at most `half` away.
fn local(samples: &[(f64, f64)], at: usize, half: usize) -> f64 {
    let rows = at.saturating_sub(half)..(at + half + 1).min(samples.len());
    let (middle, window) = (samples[at].0, &samples[rows]);
    let farthest = window.iter().map(|it| (it.0 - middle).abs()).fold(f64::MIN_POSITIVE, f64::max);
    let reach = 1.05 * farthest;
    let (mut normal, mut right) = (Matrix4::zeros(), Vector4::zeros());
    for (t, value) in window {
        let x = (t - middle) / reach;
        let weight = (1.0 - x.abs().powi(3)).powi(3);
        let powers = Vector4::new(1.0, x, x * x, x * x * x);
        normal += weight * powers * powers.transpose();
        right += weight * powers * *value;
    }
    normal.cholesky().map_or(samples[at].1, |it| it.solve(&right)[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stroke(noise: f64) -> Vec<(f64, f64)> {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 40) as f64 / (1_u64 << 24) as f64 - 0.5
        };
        let travel = |t: f64| 5e-3 * (1.0 - (std::f64::consts::PI * t / 0.1).cos());
        let times = (0..=200).map(|it| f64::from(it) * 1e-3);
        times.map(|t| (t, travel(t) + noise * 12.0_f64.sqrt() * random())).collect()
    }

    #[test]
    fn the_noise_of_a_stroke_is_known_from_the_stroke() {
        let values: Vec<_> = stroke(1e-5).iter().map(|it| it.1).collect();
        assert!((noise(&values) / 1e-5 - 1.0).abs() < 0.2, "{}", noise(&values));
    }

    #[test]
    fn what_is_smoothed_has_the_accelerations_of_the_motion() {
        let (clean, noisy) = (stroke(0.0), stroke(1e-5));
        let bends = |it: &[(f64, f64)]| -> Vec<f64> {
            it.windows(3).map(|it| (it[0].1 - 2.0 * it[1].1 + it[2].1) / 1e-6).collect()
        };
        let error = |it: &[(f64, f64)]| {
            let squares = bends(it).iter().zip(bends(&clean)).map(|(a, b)| (a - b).powi(2)).sum();
            f64::sqrt(squares) / 199.0_f64.sqrt()
        };
        // Of at most 4.9 m/s².
        assert!(error(&noisy) > 20.0, "{}", error(&noisy));
        assert!(error(&smoothed(&noisy)) < 0.3, "{}", error(&smoothed(&noisy)));
        assert!(error(&smoothed(&clean)) < 0.05, "{}", error(&smoothed(&clean)));
    }
}
