//! Detects that a voice is at rest, so that its equations can be skipped.

use pode::State;

/// Time without any motion after which a voice sleeps (s).
const PATIENCE: f64 = 20e-3;

/// Time of little motion after which a voice sleeps (s): twice the period of the slowest key.
const LONG: f64 = 0.5;

/// Little motion of a coordinate (rad or m): 0.1 mm at the end of a hammer of 1 m.
const LITTLE: f64 = 1e-4;

/// Change of force that no finger feels (N).
const UNFELT: f64 = 10e-3;

/// Speed of a coordinate that counts as none (m/s or rad/s): 1 mm takes 2 s. A body that swings at
/// 5 Hz is this fast where its acceleration is [`STILL_ACCELERATION`].
const STILL_SPEED: f64 = 5e-4;

/// Rate of a speed that counts as none (m/s² or rad/s²): 0.1 mN at the finger for a hammer.
const STILL_ACCELERATION: f64 = 2e-2;

/// Detects rest: the key stands still, and the model does not move, or for long not noticeably.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RestDetector<S> {
    /// Tick period (s).
    h: f64,
    position: f64,
    force: f64,
    still: u32,
    calm: u32,
    /// Ticks since the model moved by more than a little.
    little: u32,
    /// State at that time, and the force (N).
    then: (S, f64),
    /// Ticks that count as rest, and as long.
    patience: u32,
    long: u32,
}

impl<S: State> RestDetector<S> {
    /// Starts without any rest, from `state`; ticks take `h` (s).
    pub(crate) fn new(state: S, h: f64) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "2 to 5000")]
        let ticks = |time: f64| (time / h).round().clamp(1.0, 1e6) as u32;
        Self {
            h,
            position: 0.0,
            force: 0.0,
            still: 0,
            calm: 0,
            little: 0,
            then: (state, 0.0),
            patience: ticks(PATIENCE),
            long: ticks(LONG),
        }
    }

    /// Records a tick with the key at a position (m) under a force (N), in which the model, whose
    /// first entries are `coordinates`, went from one state to another.
    pub(crate) fn observe(
        &mut self,
        (position, force): (f64, f64),
        coordinates: usize,
        (before, after): (&S, &S),
    ) {
        let count = |goes_on: bool, ticks: u32| if goes_on { ticks.saturating_add(1) } else { 0 };
        // Bits, not a tolerance: the encoder determines if the key has moved.
        self.still = count(self.position.to_bits() == position.to_bits(), self.still);
        (self.position, self.force) = (position, force);
        self.calm = count(!moves(coordinates, (before, after), self.h), self.calm);
        let is_near =
            is_near(coordinates, (&self.then.0, after)) && (force - self.then.1).abs() <= UNFELT;
        self.little = count(is_near, self.little);
        if !is_near {
            self.then = (*after, force);
        }
    }

    /// Returns the force to hold if the voice sleeps, after `time` at rest, at `position` (m).
    pub(crate) fn force_at(&self, position: f64, time: SleepTime) -> Option<f64> {
        let [patience, long] = [self.patience, self.long].map(|ticks| time.of(ticks));
        let rests = patience <= self.calm || long <= self.little;
        let asleep = patience <= self.still && rests;
        (asleep && self.position.to_bits() == position.to_bits()).then_some(self.force)
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) enum SleepTime {
    #[default]
    Usual,
    /// A quarter of that, while ticks have too little time.
    Short,
}

impl SleepTime {
    const fn of(self, ticks: u32) -> u32 {
        match self {
            Self::Usual => ticks,
            Self::Short => ticks.div_ceil(4),
        }
    }
}

/// Returns `true` if all coordinates are within a little of `then`; NaN is not.
fn is_near<S: State>(coordinates: usize, (then, now): (&S, &S)) -> bool {
    let pairs = then.entries().iter().zip(now.entries()).take(coordinates);
    pairs.fold(true, |is_near, (then, now)| is_near & ((now - then).abs() <= LITTLE))
}

/// Returns `true` if a coordinate or a speed moved from `before` to `after`, `h` (s) later, by
/// rate. A coordinate has no speed at the end of a swing, and no acceleration in its middle.
fn moves<S: State>(coordinates: usize, (before, after): (&S, &S), h: f64) -> bool {
    let pairs = before.entries().iter().zip(after.entries()).enumerate();
    let limit = |index| if index < coordinates { STILL_SPEED } else { STILL_ACCELERATION };
    // NaN counts as motion.
    pairs.map(|(index, (a, b))| (b - a).abs() <= limit(index) * h).any(|is_still| !is_still)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slow_motion_is_no_rest_at_any_rate() {
        for h in [1e-2, 1e-3, 1e-4] {
            let after = |speed: f64, acceleration: f64| {
                moves(1, (&[0.0, speed], &[speed * h, speed + acceleration * h]), h)
            };
            assert!(after(20e-3, 0.0), "20 mm/s in ticks of {h} s");
            assert!(after(1e-3, 0.0), "1 mm/s in ticks of {h} s");
            assert!(after(0.0, 0.05), "0.05 m/s² in ticks of {h} s");
            assert!(!after(1e-4, 0.01), "0.1 mm/s in ticks of {h} s");
            assert!(after(f64::NAN, 0.0));
        }
    }
}
