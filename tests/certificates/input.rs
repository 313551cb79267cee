//! Inputs over one tick, arbitrarily fast, with valid bounds or none.

use pode::input::{Cubic, Reconstruction, Reconstructor};
use pode::{Motion, Signal};

use lab::random::SeededRandom;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum InputKind {
    Rest,
    /// a sin(ω t): amplitude and rate (rad/s).
    Sine {
        amplitude: f64,
        rate: f64,
    },
    /// A sine by a closure, without bounds.
    Unbounded {
        amplitude: f64,
        rate: f64,
    },
    /// a exp(−z²), z = (t − centre)/width, repeated with the given period (s).
    Bells {
        amplitude: f64,
        width: f64,
        period: f64,
    },
    /// Random samples, one for each tick, reconstructed.
    Samples {
        amplitude: f64,
        how: Reconstruction,
    },
}

impl InputKind {
    pub(super) fn random(random: &mut SeededRandom, h: f64) -> Self {
        let amplitude = random.spread(0.05, 2.0);
        match random.below(6) {
            0 => Self::Rest,
            1 | 2 => Self::Sine { amplitude, rate: random.spread(0.01, 40.0) / h },
            3 => {
                let width = h * random.spread(0.01, 3.0);
                // Where one bell ends and the next begins both are below 1e-27.
                Self::Bells {
                    amplitude,
                    width,
                    period: 16.0 * width + random.between(0.0, 5.0) * h,
                }
            }
            4 => {
                let how = [
                    Reconstruction::Hold,
                    Reconstruction::Linear,
                    Reconstruction::Quadratic,
                    Reconstruction::LateHermite,
                ];
                Self::Samples { amplitude, how: how[random.below(how.len())] }
            }
            _ => Self::Unbounded { amplitude, rate: random.spread(0.01, 10.0) / h },
        }
    }
}

#[derive(Clone, Debug)]
pub(super) struct Input {
    kind: InputKind,
    random: SeededRandom,
    reconstructor: Reconstructor,
    cubic: Cubic,
}

impl Input {
    pub(super) fn new(kind: InputKind, random: SeededRandom, h: f64) -> Self {
        let how = match kind {
            InputKind::Samples { how, .. } => how,
            InputKind::Rest
            | InputKind::Sine { .. }
            | InputKind::Unbounded { .. }
            | InputKind::Bells { .. } => Reconstruction::Hold,
        };
        let cubic = Cubic::new([0.0; 4], h);
        Self { kind, random, reconstructor: Reconstructor::new(how, 0.0, h), cubic }
    }

    pub(super) fn next(&mut self) {
        if let InputKind::Samples { amplitude, .. } = self.kind {
            self.cubic = self.reconstructor.push(self.random.between(-amplitude, amplitude));
        }
    }

    /// Returns the tick that begins at `start` (s) and lasts `h` (s), from its place `theta` on.
    pub(super) const fn part(&self, start: f64, h: f64, theta: f64) -> InputPart {
        InputPart { kind: self.kind, cubic: self.cubic, start, h, theta }
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) struct InputPart {
    kind: InputKind,
    cubic: Cubic,
    start: f64,
    h: f64,
    theta: f64,
}

impl InputPart {
    fn whole(&self, theta: f64) -> f64 {
        if theta < 1.0 { self.theta + theta * (1.0 - self.theta) } else { 1.0 }
    }
}

impl Signal<Motion> for InputPart {
    fn at(&self, theta: f64) -> Motion {
        let theta = self.whole(theta);
        let t = self.start + theta * self.h;
        match self.kind {
            InputKind::Rest => Motion::default(),
            InputKind::Sine { amplitude, rate } | InputKind::Unbounded { amplitude, rate } => {
                let (sin, cos) = (rate * t).sin_cos();
                Motion {
                    position: amplitude * sin,
                    rate: amplitude * rate * cos,
                    acceleration: -amplitude * rate.powi(2) * sin,
                    jerk: -amplitude * rate.powi(3) * cos,
                }
            }
            InputKind::Bells { amplitude, width, period } => {
                bell(amplitude, width, phase(t, period) / width)
            }
            InputKind::Samples { .. } => self.cubic.at(theta),
        }
    }

    fn bound(&self, from: f64, to: f64) -> Option<Motion> {
        let [from, to] = [from, to].map(|theta| self.whole(theta));
        match self.kind {
            InputKind::Rest => Some(Motion::default()),
            InputKind::Sine { amplitude, rate } => Some(Motion {
                position: amplitude,
                rate: amplitude * rate,
                acceleration: amplitude * rate.powi(2),
                jerk: amplitude * rate.powi(3),
            }),
            InputKind::Unbounded { .. } => None,
            InputKind::Bells { amplitude, width, period } => {
                let [from, to] = [from, to].map(|theta| self.start + theta * self.h);
                Some(bell_bound(amplitude, width, nearest(from, to, period) / width))
            }
            InputKind::Samples { .. } => self.cubic.bound(from, to),
        }
    }
}

fn phase(t: f64, period: f64) -> f64 {
    t - period * (t / period).round()
}

fn nearest(from: f64, to: f64, period: f64) -> f64 {
    let (a, b) = (phase(from, period), phase(to, period));
    let is_over = (to - from) >= 0.5 * period || (a < 0.0 && b > 0.0);
    if is_over { 0.0 } else { a.abs().min(b.abs()) }
}

fn bell(amplitude: f64, width: f64, z: f64) -> Motion {
    let height = amplitude * (-z * z).exp();
    Motion {
        position: height,
        rate: -2.0 * z * height / width,
        acceleration: (4.0 * z * z - 2.0) * height / width.powi(2),
        jerk: (12.0 * z - 8.0 * z.powi(3)) * height / width.powi(3),
    }
}

fn bell_bound(amplitude: f64, width: f64, z: f64) -> Motion {
    // From 2 widths on each falls with the distance.
    let (z, near) = if z > 2.0 { (z, false) } else { (0.0, true) };
    let height = amplitude * (-z * z).exp();
    // At most √(2/e), 2 and 3.9 of them all over.
    let most = |near_most: f64, far: f64| if near { near_most } else { far };
    Motion {
        position: height,
        rate: most(0.858, 2.0 * z) * height / width,
        acceleration: most(2.0, 4.0 * z * z + 2.0) * height / width.powi(2),
        jerk: most(4.0, 12.0 * z + 8.0 * z.powi(3)) * height / width.powi(3),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_never_below_the_input() {
        let mut random = SeededRandom::new(7, 0);
        for n in 0..400_u64 {
            let kind = InputKind::random(&mut random, 1.0);
            let mut input = Input::new(kind, SeededRandom::new(8, n), 1.0);
            input.next();
            let part = input.part(random.between(0.0, 50.0), 1.0, random.between(0.0, 0.9));
            let from = random.between(0.0, 0.9);
            let to = random.between(from, 1.0);
            let Some(most) = part.bound(from, to) else { continue };
            for place in 0..=300 {
                let s = part.at(from + (to - from) * f64::from(place) / 300.0);
                let slack = 1.0 + 1e-9;
                assert!(s.position.abs() <= slack * most.position, "{kind:?}");
                assert!(s.rate.abs() <= slack * most.rate + 1e-25, "{kind:?}");
                assert!(s.acceleration.abs() <= slack * most.acceleration + 1e-25, "{kind:?}");
                assert!(s.jerk.abs() <= slack * most.jerk + 1e-25, "{kind:?}");
            }
        }
    }
}
