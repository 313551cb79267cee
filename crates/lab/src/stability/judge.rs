//! Judges whether a knocked loop comes to rest.
//!
//! Four windows of equal length follow the knock. In each, the mean square of the key's velocity
//! measures the dissipation of its damper, and the range of the force the activity of the loop.
//! Without a source of energy both must fall from window to window: falling means rest, growing
//! means generated energy, constant means ringing. The first window, with the knock, is ignored.

use serde::Serialize;

/// Mean square of a velocity that counts as zero: a micrometre in a second (m²/s²).
const STILL: f64 = 1e-12;

/// Square of a force range below perception: a hundredth of a newton (N²).
const STEADY: f64 = 1e-4;

/// Share by which a value must fall from window to window; less counts as constant.
const SHARE: f64 = 0.02;

/// Behaviour of a loop after a knock.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum LoopVerdict {
    Rests,
    /// Moves for ever without growing.
    Rings,
    /// Its motion grows, or its voice was muted because it generated energy.
    MakesEnergy,
    Fails,
}

impl LoopVerdict {
    /// All verdicts, the best first.
    pub const ALL: [Self; 4] = [Self::Rests, Self::Rings, Self::MakesEnergy, Self::Fails];

    pub const fn title(self) -> &'static str {
        match self {
            Self::Rests => "comes to rest",
            Self::Rings => "rings for ever",
            Self::MakesEnergy => "makes energy",
            Self::Fails => "the model fails",
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) struct WindowSums {
    /// Sum of squares of velocity (m²/s²), and their number.
    squares: f64,
    count: f64,
    /// Smallest and largest force (N).
    force: (f64, f64),
}

impl Default for WindowSums {
    fn default() -> Self {
        Self { squares: 0.0, count: 0.0, force: (f64::INFINITY, f64::NEG_INFINITY) }
    }
}

impl WindowSums {
    /// Adds a velocity (m/s) and the force (N) on the key.
    pub(super) fn enter(&mut self, velocity: f64, force: f64) {
        self.squares += velocity * velocity;
        self.count += 1.0;
        self.force = (self.force.0.min(force), self.force.1.max(force));
    }

    fn mean_square(&self) -> f64 {
        self.squares / self.count.max(1.0)
    }

    fn force_square(&self) -> f64 {
        let range = (self.force.1 - self.force.0).max(0.0);
        range * range
    }
}

pub(super) fn judge(windows: &[WindowSums; 4]) -> LoopVerdict {
    let motion = windows.map(|it| it.mean_square());
    let force = windows.map(|it| it.force_square());
    match (trend(motion, STILL), trend(force, STEADY)) {
        (Trend::Falls, Trend::Falls) => LoopVerdict::Rests,
        (Trend::Grows, _) => LoopVerdict::MakesEnergy,
        _ => LoopVerdict::Rings,
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Trend {
    Falls,
    Stays,
    Grows,
}

fn trend([_, second, third, fourth]: [f64; 4], floor: f64) -> Trend {
    let falls = |from: f64, to: f64| to < (1.0 - SHARE) * from;
    if fourth <= floor || falls(second, third) && falls(third, fourth) {
        Trend::Falls
    } else if falls(third, second) && falls(fourth, third) {
        Trend::Grows
    } else {
        Trend::Stays
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn windows(factor: f64, force: f64) -> [WindowSums; 4] {
        let mut windows = [WindowSums::default(); 4];
        let mut velocity = 0.1_f64;
        for window in &mut windows {
            for _sample in 0..100 {
                velocity *= -factor;
                window.enter(velocity, force * velocity);
            }
        }
        windows
    }

    #[test]
    fn what_falls_comes_to_rest_what_grows_makes_energy_and_what_stays_rings() {
        for (factor, verdict) in [
            (0.9, LoopVerdict::Rests),
            // 2 % of the square in 100 samples are 1e-4 of the velocity in one.
            (0.9998, LoopVerdict::Rests),
            (0.999_95, LoopVerdict::Rings),
            (1.0, LoopVerdict::Rings),
            (1.000_05, LoopVerdict::Rings),
            (1.0002, LoopVerdict::MakesEnergy),
            (1.1, LoopVerdict::MakesEnergy),
        ] {
            assert_eq!(judge(&windows(factor, 10.0)), verdict, "{factor}");
        }
    }

    #[test]
    fn a_still_key_under_a_force_that_chatters_is_not_at_rest() {
        let mut windows = [WindowSums::default(); 4];
        for window in &mut windows {
            window.enter(0.0, 0.5);
            window.enter(0.0, -0.5);
        }
        assert_eq!(judge(&windows), LoopVerdict::Rings);
    }

    #[test]
    fn a_key_that_never_moves_is_at_rest() {
        let mut windows = [WindowSums::default(); 4];
        for window in &mut windows {
            window.enter(0.0, 0.3);
        }
        assert_eq!(judge(&windows), LoopVerdict::Rests);
    }
}
