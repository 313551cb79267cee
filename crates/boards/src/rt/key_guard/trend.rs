//! Detects glitches: one reading that leaves a key's trend and returns to it is no motion.
//!
//! A reading that leaves the trend is not used until the next one explains it:
//!
//! | next reading | explanation | consequence |
//! |---|---|---|
//! | is back on the trend | a glitch: a spike on the encoder's lines, a damaged count | it is counted |
//! | continues at the old speed, with an offset | counts were lost, or a coupling slipped | the key is muted |
//! | continues from there | the key was struck or landed | both are used |
//!
//! So a glitch costs no force, and a hard stroke is detected one sample later. Near rest and
//! bottom, which stop a key, a slower reading is used at once.

/// Acceleration that finger and motor hardly exceed (m/s²); beyond it a reading waits for the next.
const MOST_ACCELERATION: f64 = 150.0;

/// Room before rest and bottom in which a key is stopped (m).
const STOP: f64 = 0.4e-3;

/// Minimum path of a slip (m); a shorter one is a stroke.
const LEAST_SLIP: f64 = 0.25e-3;

/// Largest fraction of a slip by which the key has moved meanwhile.
const SLIP_MOTION: f64 = 0.25;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum TrendVerdict {
    Follows,
    /// It leaves the trend, and the next one will explain it.
    Leaves,
    /// It is back, so the one before was a glitch.
    Returns,
    /// It and the one before are beside the trend.
    Slipped,
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct KeyTrend {
    /// Newest reading on the trend (m), speed (m/s), and number of readings.
    position: f64,
    speed: f64,
    n: u8,
    /// A reading (m) that has left the trend, and its delay (s).
    left: Option<(f64, f64)>,
}

impl KeyTrend {
    /// Judges a reading at `position` (m), `elapsed` (s) after the one before if it follows that;
    /// a count is `quantum`, and the key goes down by `travel` (m; 0 if unknown).
    ///
    /// # Real-time
    /// Some ten operations.
    pub(super) fn accept(
        &mut self,
        position: f64,
        elapsed: Option<f64>,
        (quantum, travel): (f64, f64),
    ) -> TrendVerdict {
        let Some(elapsed) = elapsed else {
            *self = Self { position, speed: 0.0, n: 1, left: None };
            return TrendVerdict::Follows;
        };
        let most = |t: f64| MOST_ACCELERATION * t * t + 2.0 * quantum;
        let Some((astray, since)) = self.left.take() else {
            let away = position - (self.position + self.speed * elapsed);
            let most = most(elapsed);
            let is_known = 2 <= self.n;
            // A stop reverses the speed at most.
            let way = 2.0 * self.speed.abs() * elapsed + most;
            let is_stopped = away.abs() <= way && self.is_stopped(away, position, travel);
            if is_known && most < away.abs() && !is_stopped {
                self.left = Some((position, elapsed));
                return TrendVerdict::Leaves;
            }
            self.follow((self.position, position), elapsed);
            return TrendVerdict::Follows;
        };
        let whole = since + elapsed;
        if (position - (self.position + self.speed * whole)).abs() <= most(whole) {
            self.follow((self.position, position), whole);
            return TrendVerdict::Returns;
        }
        let slip = astray - (self.position + self.speed * since);
        let moved = (position - astray) - self.speed * elapsed;
        let is_slip =
            LEAST_SLIP + 2.0 * quantum < slip.abs() && moved.abs() < SLIP_MOTION * slip.abs();
        self.follow((astray, position), elapsed);
        if is_slip { TrendVerdict::Slipped } else { TrendVerdict::Follows }
    }

    /// Returns `true` if rest or bottom explain that the key is `away` (m) from its trend.
    fn is_stopped(&self, away: f64, position: f64, travel: f64) -> bool {
        let is_at_an_end = position < STOP || 0.0 < travel && travel - STOP < position;
        is_at_an_end && away * self.speed < 0.0
    }

    /// Continues from one reading (m) to the next, `elapsed` (s) later.
    fn follow(&mut self, (before, position): (f64, f64), elapsed: f64) {
        self.speed = if 0 < self.n { (position - before) / elapsed } else { 0.0 };
        self.position = position;
        self.n = (self.n + 1).min(2);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const H: f64 = 1e-3;
    const KEY: (f64, f64) = (1e-6, 10.16e-3);

    fn read(millimetres: &[f64]) -> Vec<TrendVerdict> {
        let mut trend = KeyTrend::default();
        let elapsed = std::iter::once(None).chain(std::iter::repeat(Some(H)));
        let readings = millimetres.iter().zip(elapsed);
        readings.map(|(it, elapsed)| trend.accept(it * 1e-3, elapsed, KEY)).collect()
    }

    #[test]
    fn a_spike_is_left_out_at_rest_and_in_motion() {
        use TrendVerdict::{Follows, Leaves, Returns};
        assert_eq!(
            read(&[0.0, 0.0, 0.0, 0.3, 0.0, 0.0]),
            [Follows, Follows, Follows, Leaves, Returns, Follows]
        );
        let moving = [3.0, 3.1, 3.2, 3.6, 3.4, 3.5];
        assert_eq!(read(&moving), [Follows, Follows, Follows, Leaves, Returns, Follows]);
    }

    #[test]
    fn a_spike_near_an_end_is_no_stop() {
        let found = read(&[0.8, 0.75, 0.7, 1.0, 0.6, 0.55]);
        assert_eq!(found[3..5], [TrendVerdict::Leaves, TrendVerdict::Returns], "{found:?}");
    }

    #[test]
    fn counts_that_are_lost_are_a_slip() {
        assert_eq!(
            read(&[2.0, 2.1, 2.2, 3.3, 3.4])[3..],
            [TrendVerdict::Leaves, TrendVerdict::Slipped]
        );
        assert_eq!(
            read(&[0.0, 0.0, 0.0, 1.0, 1.0])[3..],
            [TrendVerdict::Leaves, TrendVerdict::Slipped]
        );
    }

    #[test]
    fn a_hard_stroke_is_used_from_its_second_reading_on() {
        let stroke = [0.0, 0.0, 0.0, 0.3, 0.9, 1.8, 2.7];
        let found = read(&stroke);
        assert_eq!(found[3], TrendVerdict::Leaves);
        assert!(found[4..].iter().all(|it| *it != TrendVerdict::Slipped), "{found:?}");
        assert_eq!(found[4], TrendVerdict::Follows);
    }

    #[test]
    fn a_key_that_lands_is_used_at_once() {
        let landing = [6.0, 7.0, 8.0, 9.0, 10.0, 10.2, 10.2, 10.1];
        assert!(
            read(&landing).iter().all(|it| *it == TrendVerdict::Follows),
            "{:?}",
            read(&landing)
        );
    }
}
