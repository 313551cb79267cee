//! Between samples: hold, causal extrapolation, or a cubic one tick late.
//!
//! | reconstruction | order in the input | latency | at the start of a tick |
//! |---|---|---|---|
//! | `Hold` | 1 | 0 | jumps |
//! | `Linear` | 2 | 0 | jumps by the second difference |
//! | `Quadratic` | 3 | 0 | jumps by the third difference |
//! | `LateHermite` | 4 | one tick | continuous |
//!
//! A jump across a guard is an event at the tick's start.

use crate::input::{Motion, Signal};

/// Reconstruction of a sampled input over a tick.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Reconstruction {
    /// The newest sample, at rest.
    Hold,
    /// The line through the two newest samples, continued.
    Linear,
    /// The parabola through the three newest samples, continued.
    #[default]
    Quadratic,
    /// The cubic through the four newest samples, over the previous tick.
    LateHermite,
}

/// A cubic motion over one tick of `h` (s): s(θ) = c0 + θ (c1 + θ (c2 + θ c3)).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Cubic {
    c: [f64; 4],
    /// Ticks per second (1/s).
    per_second: f64,
}

impl Cubic {
    /// Builds the cubic with coefficients `c` by power of θ, over `h` (s).
    pub fn new(c: [f64; 4], h: f64) -> Self {
        Self { c, per_second: 1.0 / h }
    }

    /// Builds the motion with constant `acceleration` from the given start over `h` (s).
    pub fn ballistic(position: f64, rate: f64, acceleration: f64, h: f64) -> Self {
        Self::new([position, rate * h, 0.5 * acceleration * h * h, 0.0], h)
    }

    /// Builds the cubic from (`s0`, `v0`) to (`s1`, `v1`) over `h` (s).
    pub fn hermite(s0: f64, v0: f64, s1: f64, v1: f64, h: f64) -> Self {
        let rise = s1 - s0;
        let (d0, d1) = (v0 * h, v1 * h);
        Self::new([s0, d0, 3.0 * rise - 2.0 * d0 - d1, d0 + d1 - 2.0 * rise], h)
    }
}

impl Signal<Motion> for Cubic {
    #[inline]
    fn at(&self, theta: f64) -> Motion {
        let [c0, c1, c2, c3] = self.c;
        let r = self.per_second;
        Motion {
            position: c0 + theta * (c1 + theta * (c2 + theta * c3)),
            rate: (c1 + theta * (2.0 * c2 + theta * 3.0 * c3)) * r,
            acceleration: (2.0 * c2 + theta * 6.0 * c3) * r * r,
            jerk: 6.0 * c3 * r * r * r,
        }
    }

    #[inline]
    fn bound(&self, from: f64, to: f64) -> Option<Motion> {
        Some(self.at(from).bound_over((to - from) / self.per_second))
    }
}

/// Turns one sample per tick into a motion over each tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Reconstructor {
    kind: Reconstruction,
    samples: [f64; 4],
    h: f64,
}

impl Reconstructor {
    /// Starts at rest at `sample`, with ticks of `h` (s).
    pub const fn new(kind: Reconstruction, sample: f64, h: f64) -> Self {
        Self { kind, samples: [sample; 4], h }
    }

    /// Adds the sample at the start of a tick and returns the motion over that tick.
    #[inline]
    pub fn push(&mut self, sample: f64) -> Cubic {
        let [s1, s2, s3, _] = self.samples;
        self.samples = [sample, s1, s2, s3];
        let s0 = sample;
        let h = self.h;
        let c = match self.kind {
            Reconstruction::Hold => [s0, 0.0, 0.0, 0.0],
            Reconstruction::Linear => [s0, s0 - s1, 0.0, 0.0],
            Reconstruction::Quadratic => {
                [s0, 0.5 * (3.0 * s0 - 4.0 * s1 + s2), 0.5 * (s0 - 2.0 * s1 + s2), 0.0]
            }
            Reconstruction::LateHermite => {
                // Slopes per tick at both ends of the last tick, of third order.
                let d1 = (11.0 * s0 - 18.0 * s1 + 9.0 * s2 - 2.0 * s3) / 6.0;
                let d0 = (2.0 * s0 + 3.0 * s1 - 6.0 * s2 + s3) / 6.0;
                return Cubic::hermite(s1, d0 / h, s0, d1 / h, h);
            }
        };
        Cubic::new(c, h)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [(Reconstruction, i32, f64); 4] = [
        (Reconstruction::Hold, 1, 0.0),
        (Reconstruction::Linear, 2, 0.0),
        (Reconstruction::Quadratic, 3, 0.0),
        (Reconstruction::LateHermite, 4, 1.0),
    ];

    /// Returns the largest error (m) over 0.64 s in ticks of `h` (s), after four samples.
    fn error(kind: Reconstruction, latency: f64, h: f64, motion: impl Fn(f64) -> f64) -> f64 {
        let mut reconstructor = Reconstructor::new(kind, motion(-4.0 * h), h);
        let mut most: f64 = 0.0;
        let mut n = -3.0;
        while n * h < 0.64 {
            let cubic = reconstructor.push(motion(n * h));
            for part in (0..=8_u8).filter(|_| n >= 0.0) {
                let theta = f64::from(part) / 8.0;
                let t = (n + theta - latency) * h;
                most = most.max((cubic.at(theta).position - motion(t)).abs());
            }
            n += 1.0;
        }
        most
    }

    #[test]
    fn every_reconstruction_has_its_order_on_a_sine() {
        for (kind, order, latency) in ALL {
            let coarse = error(kind, latency, 0.02, |t| (t + 0.4).sin());
            let fine = error(kind, latency, 0.01, |t| (t + 0.4).sin());
            let observed = (coarse / fine).log2();
            // The next term of the error is about 0.02 of the first.
            let off = (observed - f64::from(order)).abs();
            assert!(off < 0.1, "{kind:?}: observed order {observed:.3}, not {order}");
        }
    }

    #[test]
    fn every_reconstruction_is_exact_below_its_order() {
        for (kind, order, latency) in ALL {
            for power in 0..order {
                // Values up to 1 and combinations of up to 18 of them round by 1e-14.
                let error = error(kind, latency, 0.02, |t| (1.3 * t).powi(power));
                assert!(error < 1e-14, "{kind:?} on t^{power}: {error:e}");
            }
        }
    }

    #[test]
    fn the_late_cubic_does_not_jump_between_ticks() {
        let mut reconstructor = Reconstructor::new(Reconstruction::LateHermite, 0.0, 0.02);
        let mut end = 0.0;
        for n in 1..50 {
            let cubic = reconstructor.push((0.1 * f64::from(n)).sin());
            let start = cubic.at(0.0).position;
            assert!((start - end).abs() < 1e-15, "tick {n}: from {end} to {start}");
            end = cubic.at(1.0).position;
        }
    }

    #[test]
    fn a_cubic_has_its_stated_rates() {
        let cubic = Cubic::hermite(1.0, 2.0, 3.0, 4.0, 0.5);
        let (start, end) = (cubic.at(0.0), cubic.at(1.0));
        let found = [start.position, start.rate, end.position, end.rate];
        let wrong = found.iter().zip([1.0, 2.0, 3.0, 4.0]).find(|(a, b)| (*a - b).abs() > 1e-14);
        assert_eq!(wrong, None);
        let fallen = Cubic::ballistic(1.0, 0.0, -9.81, 0.5).at(1.0);
        assert!((fallen.position - (1.0 - 0.125 * 9.81)).abs() < 1e-15);
        assert!(
            (fallen.rate + 0.5 * 9.81).abs() < 1e-14 && (fallen.acceleration + 9.81).abs() < 1e-14
        );
    }
}
