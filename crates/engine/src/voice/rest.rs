//! Whether a voice has come to rest, so that its equations can be skipped.

use pode::State;

/// Time without any movement after which a voice sleeps (s).
const PATIENCE: f64 = 20e-3;

/// How long a model may swing by no more than a little before its voice sleeps (s): twice the period
/// of the slowest key.
const LONG: f64 = 0.5;

/// Motion of a coordinate that is little (rad or m): a tenth of a millimetre at the end of a hammer
/// of a metre.
const LITTLE: f64 = 1e-4;

/// Change of force that no finger feels (N).
const UNFELT: f64 = 10e-3;

/// Speed of a coordinate that counts as none (m/s or rad/s): a millimetre takes two seconds.
///
/// A part that swings at 5 Hz is this fast where its acceleration is [`STILL_ACCELERATION`].
const STILL_SPEED: f64 = 5e-4;

/// Rate of a speed that counts as none (m/s² or rad/s²): of a hammer it means 0.1 mN at the
/// finger, a tenth of what the wire resolves.
const STILL_ACCELERATION: f64 = 2e-2;

/// Watches a key and its model: they rest when the key stands still and the model does not move, or
/// has moved for long by so little that nobody feels it, however it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RestDetector<S> {
    /// Tick (s).
    h: f64,
    position: f64,
    force: f64,
    /// Ticks for which the key has not moved.
    still: u32,
    /// Ticks for which the model has not.
    calm: u32,
    /// Ticks since the model moved by more than a little.
    little: u32,
    /// Where it was then, and the force (N).
    then: (S, f64),
    /// So many ticks are rest, and so many are long.
    patience: u32,
    long: u32,
}

impl<S: State> RestDetector<S> {
    /// Nothing is known to be still of a model in `state`; ticks take `h` (s).
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

    /// Takes note of a tick in which the key was at a position (m) and felt a force (N), and the
    /// model, whose first entries are `coordinates`, went from one state to another.
    pub(crate) fn observe(
        &mut self,
        (position, force): (f64, f64),
        coordinates: usize,
        (before, after): (&S, &S),
    ) {
        let count = |goes_on: bool, ticks: u32| if goes_on { ticks.saturating_add(1) } else { 0 };
        // Bits, not a tolerance: the encoder says whether the key has moved.
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

    /// The force to hold if the voice sleeps and the key is still at `position` (m); it
    /// sleeps after `time` at rest.
    pub(crate) fn force_at(&self, position: f64, time: SleepTime) -> Option<f64> {
        let [patience, long] = [self.patience, self.long].map(|ticks| time.of(ticks));
        let rests = patience <= self.calm || long <= self.little;
        let asleep = patience <= self.still && rests;
        (asleep && self.position.to_bits() == position.to_bits()).then_some(self.force)
    }
}

/// How long a voice is at rest before it sleeps.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) enum SleepTime {
    #[default]
    Usual,
    /// A quarter of that, while there is too much to do.
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

/// Whether no coordinate is farther from `then` than a little; what is no number is.
fn is_near<S: State>(coordinates: usize, (then, now): (&S, &S)) -> bool {
    let pairs = then.entries().iter().zip(now.entries()).take(coordinates);
    pairs.fold(true, |is_near, (then, now)| is_near & ((now - then).abs() <= LITTLE))
}

/// Whether a coordinate or a speed changed from `before` to `after`, `h` (s) later, by what
/// counts as motion.
///
/// Both are asked by their rate: how far something moves in a tick says nothing of how fast it
/// moves. One that is at the end of a swing has no speed, and one in the middle no acceleration.
fn moves<S: State>(coordinates: usize, (before, after): (&S, &S), h: f64) -> bool {
    let pairs = before.entries().iter().zip(after.entries()).enumerate();
    let limit = |index| if index < coordinates { STILL_SPEED } else { STILL_ACCELERATION };
    // What is no number counts as motion.
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
