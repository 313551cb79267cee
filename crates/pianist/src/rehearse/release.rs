//! Choice of the release of a key.

use haptics::plant::Gesture;
use midi::velocity::{release_level, release_speed};

use super::search::Try;
use super::take::Take;
use super::{DamperFall, Practice, QUICK_LIFT, Rehearsal, SETTLED, price};
use crate::stroke::PlannedStroke;

/// Shortest time from a strike to the release of its key (s).
const SHORTEST_HOLD: f64 = 0.01;

/// Time before the first guess that is kept open for an earlier release (s).
const LEEWAY: f64 = 0.1;

/// Longest wait for the damper after a lift (s).
const PATIENCE: f64 = 0.25;

/// Largest accepted distance from the wanted end (s).
const TOLERANCE: f64 = 3e-3;

/// Largest accepted distance from the wanted release velocity.
const UNITS: f64 = 3.0;

const MAX_TRIES: u32 = 7;

/// Range of the lifts that are searched (s).
const LIFTS: (f64, f64) = (10e-3, 1.0);

/// A stroke before its release was chosen, with snapshots of its hold.
#[derive(Clone, Debug)]
pub(super) struct HeldStroke<R> {
    take: Take<R>,
    gesture: Gesture,
    /// Earliest release (s): after the strike.
    pub(super) earliest: f64,
}

/// A take with a release.
#[derive(Clone, Debug)]
pub(super) struct Released<R> {
    pub(super) take: Take<R>,
    pub(super) gesture: Gesture,
    pub(super) n_tries: u32,
}

impl<R: Rehearsal> HeldStroke<R> {
    pub(super) fn new(found: Try<R>, wanted: &PlannedStroke) -> Self {
        let struck = found.strike.map_or(wanted.onset, |strike| strike.at);
        Self { take: found.take, gesture: found.gesture, earliest: struck + SHORTEST_HOLD }
    }

    /// Returns the key with a quick release at `release` (s).
    pub(super) fn released(&mut self, release: f64, lift: f64) -> Released<R> {
        let release = release.max(self.earliest).max(self.take.earliest());
        self.take.record(release, |_| false);
        let gesture = Gesture { release, lift, ..self.gesture };
        Released { take: self.take.branch(release, gesture), gesture, n_tries: 0 }
    }

    /// Releases the key so that the damper falls when it should, and as fast. The key is kept as it
    /// was for an earlier release, should a stroke at `next` (s) need one.
    pub(super) fn release(
        &mut self,
        practice: &Practice<'_>,
        wanted: &PlannedStroke,
        next: f64,
    ) -> Released<R> {
        let lifts = &practice.tables.lifts;
        let mut lift = wanted.release.map_or(Gesture::LIFT, |it| lifts.lift(release_speed(it)));
        // A slow lift must fit into the note.
        while QUICK_LIFT < lift && wanted.end - lifts.fall(lift) < self.earliest {
            lift *= 0.8;
        }
        let mut release = wanted.end - lifts.fall(lift);
        self.take.skip((release - LEEWAY).min(next - SETTLED));
        let mut best: Option<(f64, Released<R>)> = None;
        for n_tries in 1..=MAX_TRIES {
            let mut tried = Released { n_tries, ..self.released(release, lift) };
            (release, lift) = (tried.gesture.release, tried.gesture.lift);
            let is_down = |take: &Take<R>| take.fall(release, f64::INFINITY);
            tried.take.record(release + lift + PATIENCE, |it| is_down(it).is_some());
            let Some(fall) = is_down(&tried.take) else { return tried };
            let (off, units) = (fall.at - wanted.end, off_by(wanted, fall));
            let price = price::end(off, units);
            if best.as_ref().is_none_or(|best| price < best.0) {
                best = Some((price, tried));
            }
            if off.abs() <= TOLERANCE && units.abs() <= UNITS {
                break;
            }
            let before = (release.max(self.earliest), lift);
            if UNITS < units.abs() {
                let speed = wanted.release.map_or(fall.speed, release_speed);
                // Smaller corrections find what lies between two folds.
                let share = 1.0 / f64::from(n_tries);
                let other = lift * (fall.speed / speed).powf(share);
                let other = other.clamp(LIFTS.0, LIFTS.1);
                let later = lifts.fall(other) - lifts.fall(lift);
                // The end of a note counts more than its release velocity.
                let fits = self.earliest <= release - off - later;
                lift = Some(other).filter(|_| fits).unwrap_or(lift);
            }
            release -= off + lifts.fall(lift) - lifts.fall(before.1);
            if (release.max(self.earliest), lift) == before {
                break;
            }
        }
        let Some((_, best)) = best else { unreachable!("there is a first try") };
        best
    }
}

/// Returns the error of a release velocity, if one is wanted.
fn off_by(wanted: &PlannedStroke, fall: DamperFall) -> f64 {
    wanted.release.map_or(0.0, |it| release_level(fall.speed) - f64::from(it.get()))
}
