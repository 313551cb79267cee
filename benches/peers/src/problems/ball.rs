//! A ball that bounces on a floor: free fall between impacts, times in closed form.

use pode::{EquationKind, Nature};

use crate::problem::Problem;
use crate::reference::{Expected, Reference};

/// State: height y (m) and speed v (m/s).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball {
    /// Gravity (m/s²).
    pub(crate) g: f64,
    pub(crate) e: f64,
    /// Height at the start (m).
    pub(crate) height: f64,
}

impl Problem<2, 1> for Ball {
    type Mode = ();

    fn names((): ()) -> [&'static str; 1] {
        ["floor"]
    }

    fn start(&self) -> ((), [f64; 2]) {
        ((), [self.height, 0.0])
    }

    #[inline]
    fn derivative(&self, (): (), _t: f64, x: &[f64; 2]) -> [f64; 2] {
        [x[1], -self.g]
    }

    #[inline]
    fn guards(&self, (): (), x: &[f64; 2]) -> [f64; 1] {
        [x[0]]
    }

    #[inline]
    fn guard_rates(&self, (): (), x: &[f64; 2]) -> [f64; 1] {
        [x[1]]
    }

    #[inline]
    fn fire(&self, (): (), _guard: usize, x: &[f64; 2]) -> ((), [f64; 2]) {
        ((), [0.0, -self.e * x[1]])
    }

    /// As in diffsol's book.
    fn nudged(&self, x: [f64; 2]) -> [f64; 2] {
        [x[0].max(f64::EPSILON), x[1]]
    }

    fn longest_step(&self) -> f64 {
        f64::INFINITY
    }

    fn nature(&self) -> Nature {
        Nature::new(EquationKind::Affine, 0.0)
    }
}

impl Ball {
    fn impact(&self, n: i32) -> f64 {
        let first = (2.0 * self.height / self.g).sqrt();
        first * (1.0 + 2.0 * self.e * (1.0 - self.e.powi(n - 1)) / (1.0 - self.e))
    }

    /// Returns height and speed at `t` (s) after `n` impacts.
    fn state(&self, t: f64, n: i32) -> [f64; 2] {
        if n == 0 {
            return [self.height - 0.5 * self.g * t * t, -self.g * t];
        }
        let since = t - self.impact(n);
        let speed = (2.0 * self.g * self.height).sqrt() * self.e.powi(n);
        [since * (speed - 0.5 * self.g * since), speed - self.g * since]
    }

    pub(crate) fn reference(&self, t_end: f64) -> Reference {
        let times: Vec<f64> =
            (1..1000).map(|n| self.impact(n)).take_while(|time| *time < t_end).collect();
        let rows = (0..=crate::reference::rows(t_end)).map(|row| {
            let t = crate::reference::row_time(row);
            let n = times.iter().filter(|time| **time <= t).count();
            (t, self.state(t, i32::try_from(n).unwrap_or(i32::MAX)).to_vec())
        });
        let rows = rows.collect();
        let events = times.iter().map(|t| Expected { t: *t, guard: "floor".to_owned() }).collect();
        Reference::new(events, rows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn impacts_are_those_of_40_digit_arithmetic() {
        let ball = Ball { g: 9.81, e: 0.8, height: 1.0 };
        let known = [(1, 0.451_523_640_985_730_9), (2, 1.173_961_466_562_900_4)];
        for (n, t) in known.into_iter().chain([(10, 3.578_892_951_020_438)]) {
            assert!((ball.impact(n) - t).abs() < 1e-15, "impact {n}");
        }
        assert_eq!(ball.reference(3.6).events.len(), 10);
    }
}
