//! Plausibility of a key's readings: a faulty sensor must not strike a hammer.
//!
//! An implausible reading is discarded like a lost sample. After several of them, all readings of
//! the key are discarded until it has read well for a while; if they continue, the key is muted
//! until its board restarts. A reading that stands still is no fault, since keys rest.
//!
//! | quantity | plausible range | reason |
//! |---|---|---|
//! | position | from half a travel, or 4 mm, above the rest to as much below the bottom | the hardest stroke of the simulated finger presses the felt by 3 mm |
//! | speed | up to 5 m/s | hammers are struck at up to 6.8 m/s, five times as fast as keys (piano-facts) |
//! | speed reported by the board | its sum over 1/20 s is the path, within half a travel or 4 mm | a filter that is late by 1 ms is wrong by less |
//! | fourth difference | as of accelerations of 140 m/s² that change their sign in every sample | a motor of 30 N can hardly do more to a key, and no finger can |
//!
//! Hard strokes exceed the last range for some samples each, so it counts only if exceeded in more
//! than a fifth of the time; they add up to a third of the charge that makes a key doubtful.

use super::key_fault::KeyFault;
use crate::calibration::KeyCalibration;

/// Largest speed of a key (m/s).
pub(super) const FASTEST: f64 = 5.0;

/// Largest acceleration of a key that alternates from sample to sample (m/s²).
const MOST_TO_AND_FRO: f64 = 140.0;

/// Minimum room beyond rest and bottom (m).
const LEAST_ROOM: f64 = 4e-3;

/// Charge of implausible readings that mutes their key (s).
const PATIENCE: f64 = 0.128;

/// Charge from which readings of the key are discarded (s).
const DOUBT: f64 = 0.032;

/// Charging rate of impossible readings, relative to the discharge by good ones.
const IMPOSSIBLE: f64 = 16.0;

/// Charging rate of strange readings, relative to the discharge by good ones.
const STRANGE: f64 = 4.0;

/// Time over which speeds are summed (s).
const SPEED_MEMORY: f64 = 0.05;

/// Difference of summed speeds and path for a key that rests (m).
const SPEED_ROUNDING: f64 = 1e-6;

const PLACES: usize = 5;

/// Plausibility check of one key.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct KeyCheck {
    /// Newest positions (m), the newest last, and their number.
    places: [f64; PLACES],
    n: usize,
    /// Time since the newest position (s).
    since: f64,
    /// Charge of implausible readings (s).
    charge: f64,
    /// Recent sum of the speeds minus the path (m).
    speed_error: f64,
    muted: Option<KeyFault>,
}

impl KeyCheck {
    pub const fn muted(&self) -> Option<KeyFault> {
        self.muted
    }

    /// Forgets the positions, for readings that do not follow the earlier ones.
    pub const fn forget(&mut self) {
        self.n = 0;
    }

    /// Adds the speed (m/s) of the next reading, at `position` (m).
    ///
    /// # Real-time
    /// Five operations.
    pub fn add_speed(&mut self, speed: f64, position: f64, elapsed: Option<f64>) {
        let [.., newest] = self.places;
        self.speed_error = match elapsed.filter(|_| 0 < self.n) {
            Some(elapsed) => {
                let left = (1.0 - elapsed / SPEED_MEMORY).max(0.0);
                left * self.speed_error + speed * elapsed - (position - newest)
            }
            None => 0.0,
        };
    }

    /// Checks a reading at `position` (m), `elapsed` (s) after its predecessor; `true` if usable.
    ///
    /// # Real-time
    /// Some twenty additions; five comparisons for a key that rests.
    pub fn accept(
        &mut self,
        position: f64,
        elapsed: Option<f64>,
        calibration: &KeyCalibration,
    ) -> bool {
        if self.muted.is_some() {
            return false;
        }
        // All checked quantities are unchanged.
        if elapsed.is_some() && self.has_rested_at(position) {
            return true;
        }
        match elapsed {
            Some(elapsed) => self.since += elapsed,
            None => self.forget(),
        }
        let wrong = self.wrong(position, elapsed, calibration);
        let (weight, is_possible) = match wrong {
            None => (-1.0, true),
            Some(KeyFault::Noisy) => (STRANGE, true),
            Some(_impossible) => (IMPOSSIBLE, false),
        };
        // A reading that follows none counts as 1 ms.
        self.charge = (self.charge + weight * elapsed.unwrap_or(1e-3)).max(0.0);
        if PATIENCE <= self.charge {
            self.muted = wrong;
        }
        if matches!(wrong, Some(KeyFault::Beyond | KeyFault::Jumping)) {
            // The remaining row has a hole.
            (self.n, self.speed_error) = (self.n.min(1), 0.0);
        } else {
            self.remember(position);
        }
        is_possible && self.charge < DOUBT
    }

    /// Returns the fault of a reading at `position` (m), if any.
    fn wrong(
        &self,
        position: f64,
        elapsed: Option<f64>,
        calibration: &KeyCalibration,
    ) -> Option<KeyFault> {
        let (quantum, travel) = (calibration.quantum.abs(), calibration.travel());
        let room = (0.5 * travel).max(LEAST_ROOM);
        // A key that was never measured has no travel.
        if 0.0 < travel && !(-room..=travel + room).contains(&position) {
            return Some(KeyFault::Beyond);
        }
        let [older @ .., newest] = self.places;
        if 0 < self.n && FASTEST * self.since + 2.0 * quantum < (position - newest).abs() {
            return Some(KeyFault::Jumping);
        }
        if room < self.speed_error.abs() {
            return Some(KeyFault::FalseSpeed);
        }
        let elapsed = elapsed.filter(|_| PLACES <= self.n + 1)?;
        let [_, a, b, c] = older;
        let fourth = a - 4.0 * b + 6.0 * c - 4.0 * newest + position;
        // Each position is rounded.
        let most = 4.0 * MOST_TO_AND_FRO * elapsed * elapsed + 8.0 * quantum;
        (most < fourth.abs()).then_some(KeyFault::Noisy)
    }

    /// Returns `true` if all stored positions equal `position` (m) and no charge is left.
    fn has_rested_at(&self, position: f64) -> bool {
        let is_here = |place: &f64| place.to_bits() == position.to_bits();
        self.charge <= 0.0
            && self.n == PLACES
            && self.speed_error.abs() < SPEED_ROUNDING
            && self.places.iter().all(is_here)
    }

    fn remember(&mut self, position: f64) {
        self.places.rotate_left(1);
        let [.., newest] = &mut self.places;
        *newest = position;
        self.n = (self.n + 1).min(PLACES);
        self.since = 0.0;
    }
}

#[cfg(test)]
mod tests {
    use crate::links::random::Random;
    use haptics::plant::{Gesture, KeyRig, RigParameters, Touch};

    use super::*;

    const H: f64 = 1e-3;

    fn key() -> KeyCalibration {
        KeyCalibration::nominal(1e-6)
    }

    /// Checks readings (m) every [`H`]; returns which were used, and the check.
    fn read(positions: impl IntoIterator<Item = f64>) -> (Vec<bool>, KeyCheck) {
        let mut check = KeyCheck::default();
        let used = positions.into_iter().enumerate();
        let used = used.map(|(n, it)| check.accept(it, (0 < n).then_some(H), &key()));
        (used.collect(), check)
    }

    fn chance() -> impl Iterator<Item = f64> {
        let mut random = Random(0x9E37_79B9_7F4A_7C15);
        std::iter::repeat_with(move || 2.0 * random.unit() - 1.0)
    }

    #[test]
    fn one_reading_of_30_mm_is_as_if_it_had_been_lost() {
        let (used, check) = read([1e-3, 1e-3, 30e-3, 1e-3, 1.1e-3]);
        assert_eq!(used, [true, true, false, true, true]);
        assert_eq!(check.muted(), None);
    }

    #[test]
    fn a_key_that_stays_at_30_mm_is_muted_within_ten_readings() {
        let (used, check) = read([0.0; 50].into_iter().chain([30e-3; 50]));
        assert!(used[..50].iter().all(|it| *it) && used[50..].iter().all(|it| !it));
        assert_eq!(check.muted(), Some(KeyFault::Beyond));
        let (_, check) = read([0.0; 50].into_iter().chain([30e-3; 10]));
        assert_eq!(check.muted(), Some(KeyFault::Beyond));
    }

    #[test]
    fn a_key_that_jumps_within_its_travel_by_turns_is_muted() {
        let (used, check) = read((0..50).map(|n| if n % 2 == 0 { 0.0 } else { 9e-3 }));
        assert!(used[1..].iter().step_by(2).all(|it| !it), "{used:?}");
        assert_eq!(check.muted(), Some(KeyFault::Jumping));
    }

    #[test]
    fn white_noise_of_a_third_of_a_millimetre_is_muted_and_of_a_fiftieth_not() {
        for (noise, muted) in [(0.3e-3, Some(KeyFault::Noisy)), (0.02e-3, None)] {
            let (used, check) = read(chance().take(500).map(|it| 5e-3 + noise * it));
            assert_eq!(check.muted(), muted, "{noise} m");
            let n_used = used.iter().filter(|it| **it).count();
            let is_right = if muted.is_some() { n_used <= 25 } else { n_used == 500 };
            assert!(is_right, "{n_used} ms of {noise} m");
        }
    }

    #[test]
    fn speeds_that_are_not_those_of_the_key_mute_it() {
        let position = |t: f64| 5e-3 * (1.0 - (6.0 * t).cos());
        let speed = |t: f64| 30e-3 * (6.0 * t).sin();
        for (scale, offset, muted) in [
            (1.0, 0.0, None),
            (1.2, 0.0, None),
            (1.0, 0.5, Some(KeyFault::FalseSpeed)),
            (-8.0, 0.0, Some(KeyFault::FalseSpeed)),
        ] {
            let mut check = KeyCheck::default();
            for n in 0..2_000 {
                let t = f64::from(n) * H;
                let elapsed = (0 < n).then_some(H);
                check.add_speed(scale * speed(t) + offset, position(t), elapsed);
                check.accept(position(t), elapsed, &key());
            }
            assert_eq!(check.muted(), muted, "{scale} {offset}");
        }
        let mut check = KeyCheck::default();
        (0..200).for_each(|_| {
            check.add_speed(0.4, 0.0, Some(H));
            check.accept(0.0, Some(H), &key());
        });
        assert_eq!(check.muted(), Some(KeyFault::FalseSpeed));
    }

    #[test]
    fn a_reading_that_stands_still_or_steps_by_a_coarse_count_is_no_fault() {
        let coarse = KeyCalibration::nominal(50e-6);
        let mut check = KeyCheck::default();
        for n in 0..10_000_u32 {
            let position = if n / 100 % 2 == 0 { 5e-3 } else { 5e-3 + 50e-6 * f64::from(n % 2) };
            assert!(check.accept(position, Some(100e-6), &coarse), "{n}");
        }
    }

    #[test]
    fn a_key_that_nobody_has_measured_may_be_anywhere() {
        let unmeasured = KeyCalibration { bottom: key().rest, ..key() };
        let mut check = KeyCheck::default();
        assert!((0..1000).all(|_| check.accept(3.0, Some(H), &unmeasured)));
    }

    /// The fastest finger, fifteen strokes a second, on a free key or one that is thrown back.
    #[test]
    fn no_stroke_of_a_finger_is_implausible() {
        let strokes = (0..30).map(|n| Gesture {
            start: 0.01 + f64::from(n) / 15.0,
            release: 0.04 + f64::from(n) / 15.0,
            touch: if n % 2 == 0 { Touch::Struck } else { Touch::Pressed },
            speed: 3.0,
            ..Gesture::USUAL
        });
        let strokes: Vec<_> = strokes.collect();
        for (h, stiffness) in [(1e-3, 0.0), (1e-3, 1_500.0), (250e-6, 0.0), (250e-6, 3_000.0)] {
            let mut rig = KeyRig::new(RigParameters::default());
            let (mut check, mut most, mut n) = (KeyCheck::default(), 0.0_f64, 0_u32);
            while f64::from(n) * h < 2.1 {
                let t = f64::from(n) * h;
                let playing = strokes.iter().rfind(|it| it.start < t + h && t < it.end());
                let position = f64::from(rig.counts()) * rig.quantum();
                check.add_speed(rig.velocity(), position, Some(h));
                rig.advance(t, h, (stiffness * position).min(25.0), playing);
                assert!(check.accept(position, Some(h), &key()), "{t} s: {position} m, {check:?}");
                most = most.max(check.charge);
                n += 1;
            }
            assert!(most < 0.5 * DOUBT, "{most} s at {h} s");
        }
    }
}
