//! Choice of the release of a key.

use haptics::plant::Gesture;

use super::hand::{PlannedKey, QUICK_LIFT};
use super::search::Try;
use super::{PlayOutcome, Practice, Rehearsal, RehearsedStroke};
use crate::stroke::PlannedStroke;

/// Shortest time from a strike to the release of its key (s).
const SHORTEST_HOLD: f64 = 0.01;

/// Guess for a key that was not seen to fall: time from a release to the fall of the damper (s).
const USUAL_FALL: f64 = 0.03;

/// Time before the first guess that is kept open for an earlier release (s).
const LEEWAY: f64 = 0.1;

/// Longest wait for the damper after a release (s).
const PATIENCE: f64 = 0.25;

/// Largest accepted distance from the wanted end (s).
const TOLERANCE: f64 = 3e-3;

const MAX_TRIES: u32 = 7;

/// Delay of a damper's fall per second of a longer lift: the lift passes the key's bottom after a
/// third of its time, and the damper's height half-way.
const FALL_PER_LIFT: f64 = 0.4;

/// Chooses the release of the gesture in `found`, and gives the gesture to the key. The damper
/// falls as near to the wanted end as a release by `latest` (s) allows, when the next stroke needs
/// the key.
pub(super) fn choose<R: Rehearsal>(
    practice: &Practice<'_>,
    hand: &mut PlannedKey<R>,
    wanted: &PlannedStroke,
    found: &Try,
    latest: Option<f64>,
) -> RehearsedStroke {
    let limits = ReleaseWindow::new(hand, wanted, found, latest);
    let (guess, lift) = limits.first_guess(wanted, practice.tables.fall.unwrap_or(USUAL_FALL));
    hand.keep(found.gesture);
    let held = hand.advance(guess - LEEWAY);
    let limits = ReleaseWindow { earliest: limits.earliest.max(hand.now()), ..limits };
    let Released { release, outcome, n_tries } = refine(hand, wanted.end, (guess, lift), limits);
    hand.let_go(release, lift);

    let strikes = held.strikes.iter().chain(&outcome.strikes);
    let gesture = Gesture { release, lift, ..found.gesture };
    RehearsedStroke {
        wanted: *wanted,
        gesture: Some(gesture),
        shortfall: None,
        strike: found.strike,
        n_strikes: strikes.filter(|strike| strike.at >= gesture.start).count(),
        damper_fall: outcome.damper_fall.filter(|fall| *fall > release),
        n_tries: found.n_tries + n_tries,
    }
}

/// Returns the earliest release of the key (s): after its strike.
pub(super) fn earliest(wanted: &PlannedStroke, found: &Try) -> f64 {
    found.strike.map_or(wanted.onset, |strike| strike.at) + SHORTEST_HOLD
}

/// Times at which a key may be released (s).
#[derive(Clone, Copy, PartialEq, Debug)]
struct ReleaseWindow {
    earliest: f64,
    latest: f64,
}

impl ReleaseWindow {
    fn new<R: Rehearsal>(
        hand: &PlannedKey<R>,
        wanted: &PlannedStroke,
        found: &Try,
        latest: Option<f64>,
    ) -> Self {
        let earliest = earliest(wanted, found).max(hand.now());
        Self { earliest, latest: latest.unwrap_or(f64::INFINITY) }
    }

    /// Returns release and lift (s) for a stroke whose damper falls `fall` (s) after a usual
    /// release. The lift is as slow as wanted if the note is long enough and the key is not needed.
    fn first_guess(self, wanted: &PlannedStroke, fall: f64) -> (f64, f64) {
        let later = |lift: f64| FALL_PER_LIFT * (lift - Gesture::LIFT);
        let longest = Gesture::LIFT + (wanted.end - self.earliest - fall) / FALL_PER_LIFT;
        let lift = wanted.lift.min(longest).max(QUICK_LIFT);
        let release = wanted.end - fall - later(lift);
        if release <= self.latest {
            (self.apply(release), lift)
        } else {
            (self.apply(release), QUICK_LIFT)
        }
    }

    /// Returns the allowed time nearest to `release` (s); the strike comes before the next stroke.
    fn apply(self, release: f64) -> f64 {
        release.min(self.latest).max(self.earliest)
    }
}

struct Released {
    release: f64,
    outcome: PlayOutcome,
    n_tries: u32,
}

/// Moves the release from `guess` until the damper falls at `end`, within `limits` (all in s).
fn refine<R: Rehearsal>(
    hand: &mut PlannedKey<R>,
    end: f64,
    (guess, lift): (f64, f64),
    limits: ReleaseWindow,
) -> Released {
    let mut release = guess;
    let mut n_tries = 0;
    let mut best: Option<(f64, Released)> = None;
    loop {
        n_tries += 1;
        hand.let_go(release, lift);
        let outcome = hand.look_ahead(release + lift + PATIENCE);
        let fall = outcome.damper_fall.filter(|fall| *fall > release);
        let late = fall.map_or(0.0, |fall| fall - end);
        let better = limits.apply(release - late);
        let stays = (better - release).abs() < f64::EPSILON * release;
        if best.as_ref().is_none_or(|best| late.abs() < best.0) {
            best = Some((late.abs(), Released { release, outcome, n_tries }));
        }
        if n_tries >= MAX_TRIES || late.abs() <= TOLERANCE || stays {
            let Some((_, best)) = best else { continue };
            return Released { n_tries, ..best };
        }
        release = better;
    }
}
