//! Search for finger speed and start of one stroke, by trials.

use haptics::plant::{Gesture, Touch};

use super::hand::{KeyRise, PlannedKey};
use super::{PlayOutcome, Practice, Rehearsal, SETTLED, Strike, table};
use crate::stroke::PlannedStroke;

/// Most simulations for one stroke and touch.
const MAX_TRIES: u32 = 12;

/// Accepted error of the velocity (MIDI units).
const LEVEL_TOLERANCE: f64 = 0.3;

/// Accepted error of the onset (s).
const ONSET_TOLERANCE: f64 = 1e-4;

/// Cost above which the other touch is tried too: see [`Try::cost`].
const ACCEPTABLE_COST: f64 = 1.0;

const EXTRA_COST: f64 = 100.0;

const MISS_COST: f64 = 1e6;

/// Cost of a stroke that misses if a tick is lost on the way.
const FRAGILE_COST: f64 = 1e3;

/// Shifts of the start that a stroke must bear (s): a tick that the machine loses.
const LOST_TICKS: [f64; 2] = [-1e-3, 1e-3];

/// Time after the onset in which a second strike is searched (s).
const WATCH: f64 = 0.08;

/// Largest change of the finger speed between tries, as a natural logarithm.
const MAX_STRIDE: f64 = 0.7;

/// Assumed error of a gesture without a strike: this much too slow, as a natural logarithm.
const MISS_STRIDE: f64 = 0.4;

/// Depth at which an action lets off (m), for a first guess.
const LET_OFF: f64 = 9e-3;

/// Time from the deepest start to the strike, as a fraction of that from rest: see
/// [`Gesture::passes`].
pub(super) const SHORTEST_WAY: f64 = 0.25;

/// Halvings of the time within which a stroke starts: to below 1 us of 0.5 s.
const HALVINGS: u32 = 20;

/// Spare time before the earliest considered start (s).
const MARGIN: f64 = 0.03;

/// Returns the lead (s) of a stroke with `delay` (s): the search may halve its speed.
pub(super) fn reach(delay: f64) -> f64 {
    2.0 * delay + MARGIN
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Try {
    pub(super) gesture: Gesture,
    pub(super) strike: Option<Strike>,
    /// Velocity error (MIDI units) + onset error (ms) + cost of missing or extra strikes.
    pub(super) cost: f64,
    pub(super) n_extra: usize,
    /// `true` if exactly one strike meets both tolerances.
    pub(super) is_good: bool,
    pub(super) n_tries: u32,
}

impl Try {
    /// Returns `true` if the other touch need not be tried.
    pub(super) fn is_acceptable(&self) -> bool {
        self.cost <= ACCEPTABLE_COST
    }
}

pub(super) fn find<R: Rehearsal>(
    practice: &Practice<'_>,
    hand: &PlannedKey<R>,
    wanted: &PlannedStroke,
    touch: Touch,
    rise: &KeyRise,
) -> Try {
    let mut search = StrokeSearch::new(practice, (hand.free_from(), rise), wanted, touch);
    let mut last = search.attempt(hand);
    let mut best = last;
    let mut n_tries = 1;
    while !last.is_good && n_tries < MAX_TRIES && search.correct(&last) {
        last = search.attempt(hand);
        n_tries += 1;
        if last.cost < best.cost {
            best = last;
        }
    }
    if best.strike.is_some() && !search.is_sure(hand, best.gesture) {
        best.cost += FRAGILE_COST;
    }
    Try { n_tries, ..best }
}

struct StrokeSearch<'a> {
    practice: &'a Practice<'a>,
    wanted: &'a PlannedStroke,
    touch: Touch,
    /// Time from which the finger is free (s).
    earliest: f64,
    rise: &'a KeyRise,
    /// Start of the gesture (s).
    start: f64,
    bracket: SpeedBracket,
}

impl<'a> StrokeSearch<'a> {
    fn new(
        practice: &'a Practice<'a>,
        (earliest, rise): (f64, &'a KeyRise),
        wanted: &'a PlannedStroke,
        touch: Touch,
    ) -> Self {
        let (command, delay) = practice.guess(touch, wanted.speed);
        let start = (wanted.onset - delay).max(earliest);
        let bracket = SpeedBracket::new(touch, command);
        let mut search = Self { practice, wanted, touch, earliest, rise, start, bracket };
        search.aim(wanted.onset);
        search
    }

    /// Sets the start so that the strike is expected at `at` (s), or as early as possible. A later
    /// start finds the key higher and has a longer path, so it is between the earliest and that
    /// from rest.
    fn aim(&mut self, at: f64) {
        let from_rest = at - self.delay_from(f64::INFINITY);
        if self.rise.depth(from_rest) == 0.0 && self.earliest <= from_rest {
            self.start = from_rest;
            return;
        }
        let (mut early, mut late) = (self.earliest, at);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (early + late);
            let is_late = at < middle + self.delay_from(middle);
            (early, late) = if is_late { (early, middle) } else { (middle, late) };
        }
        self.start = early;
    }

    /// Returns the gesture of the present speed that starts at `start` (s).
    fn gesture_from(&self, start: f64) -> Gesture {
        let Self { practice, touch, .. } = *self;
        let speed = self.bracket.guess.exp();
        let usual = practice.technique.gesture(touch, speed, start, f64::INFINITY);
        match touch {
            Touch::Pressed => Gesture { from: self.rise.depth(start), ..usual },
            Touch::Struck => usual,
        }
    }

    fn attempt<R: Rehearsal>(&self, hand: &PlannedKey<R>) -> Try {
        let until = self.wanted.onset.max(self.start + self.delay_from(self.start)) + WATCH;
        let gesture = self.gesture_from(self.start);
        judge(self.practice, self.wanted, gesture, &hand.try_out(gesture, until))
    }

    /// Returns `true` if `gesture` strikes even if a tick is lost: a key that is struck again
    /// before it rests may only just catch its hammer.
    fn is_sure<R: Rehearsal>(&self, hand: &PlannedKey<R>, gesture: Gesture) -> bool {
        if self.earliest + SETTLED < gesture.start {
            return true;
        }
        LOST_TICKS.iter().all(|late| {
            let start = (gesture.start + late).max(self.earliest);
            let moved = Gesture { start, ..gesture };
            let outcome = hand.try_out(moved, self.wanted.onset + WATCH);
            judge(self.practice, self.wanted, moved, &outcome).strike.is_some()
        })
    }

    /// Corrects speed and start after `tried`; returns `false` if neither can change.
    fn correct(&mut self, tried: &Try) -> bool {
        let (guess, start) = (self.bracket.guess, self.start);
        let expected = start + self.delay_from(start);
        if !is_level(self.practice, self.wanted, tried.strike) {
            self.bracket.learn(too_fast_by(self.wanted, tried.strike));
        }
        let lag = tried.strike.map_or(0.0, |strike| strike.at - expected);
        self.aim(self.wanted.onset - lag);
        let is_elsewhere = (self.start - start).abs() > 0.1 * ONSET_TOLERANCE;
        is_elsewhere || guess.to_bits() != self.bracket.guess.to_bits()
    }

    /// Returns the time from `start` to the strike (s) if the key were at rest, less the path that
    /// the finger then has behind it.
    fn delay_from(&self, start: f64) -> f64 {
        let gesture = self.gesture_from(start);
        let whole = Gesture { from: 0.0, ..gesture }.passes(LET_OFF);
        let way = gesture.passes(LET_OFF) / whole;
        way * self.practice.tables.of(self.touch).delay(gesture.speed)
    }
}

fn judge(
    practice: &Practice<'_>,
    wanted: &PlannedStroke,
    gesture: Gesture,
    outcome: &PlayOutcome,
) -> Try {
    let mut own = outcome.strikes.iter().filter(|strike| strike.at >= gesture.start);
    let strike = own.next().copied();
    let n_extra = own.count();
    let onset_error = strike.map_or(0.0, |strike| (strike.at - wanted.onset).abs());
    let wrong = if strike.is_some() { EXTRA_COST * n_extra as f64 } else { MISS_COST };
    let level_error = level_error(practice, wanted, strike);
    Try {
        gesture,
        strike,
        n_extra,
        cost: level_error + 1e3 * onset_error + wrong,
        is_good: wrong == 0.0 && level_error <= LEVEL_TOLERANCE && onset_error <= ONSET_TOLERANCE,
        n_tries: 1,
    }
}

fn is_level(practice: &Practice<'_>, wanted: &PlannedStroke, strike: Option<Strike>) -> bool {
    strike.is_some() && level_error(practice, wanted, strike) <= LEVEL_TOLERANCE
}

/// Returns the velocity error (MIDI units); zero without a strike, which has its own cost.
pub(super) fn level_error(
    practice: &Practice<'_>,
    wanted: &PlannedStroke,
    strike: Option<Strike>,
) -> f64 {
    let level = |speed| practice.curve.level(speed).clamp(0.0, 128.0);
    strike.map_or(0.0, |strike| (level(strike.speed) - level(wanted.speed)).abs())
}

/// Returns the natural logarithm of hammer speed over wanted hammer speed.
fn too_fast_by(wanted: &PlannedStroke, strike: Option<Strike>) -> f64 {
    match strike {
        Some(strike) if strike.speed > 0.0 => (strike.speed / wanted.speed).ln(),
        _ => -MISS_STRIDE,
    }
}

/// End of a bracket: finger speed and excess of the hammer speed, as logarithms.
#[derive(Clone, Copy, PartialEq, Debug)]
struct BracketEnd {
    command: f64,
    excess: f64,
}

/// Illinois' method on logarithms: regula falsi that halves an end which stays.
///
/// Until there are two ends, hammer speed is assumed proportional to finger speed.
#[derive(Clone, Copy, PartialEq, Debug)]
struct SpeedBracket {
    /// Slowest and fastest finger of the touch, as natural logarithms.
    limits: (f64, f64),
    /// Next finger speed, as a natural logarithm.
    guess: f64,
    slow: Option<BracketEnd>,
    fast: Option<BracketEnd>,
}

impl SpeedBracket {
    /// Starts at finger speed `command` (m/s).
    fn new(touch: Touch, command: f64) -> Self {
        let limits = (table::slowest(touch).ln(), table::FASTEST.ln());
        let guess = command.ln().clamp(limits.0, limits.1);
        Self { limits, guess, slow: None, fast: None }
    }

    /// Adds the excess of the hammer speed at the present guess, and guesses again.
    fn learn(&mut self, excess: f64) {
        let end = Some(BracketEnd { command: self.guess, excess });
        let (replaced, opposite) = if excess < 0.0 {
            (&mut self.slow, &mut self.fast)
        } else {
            (&mut self.fast, &mut self.slow)
        };
        let stays = replaced.is_some();
        *replaced = end;
        if let Some(opposite) = opposite.as_mut().filter(|_| stays) {
            opposite.excess *= 0.5;
        }
        let guess = match (self.slow, self.fast) {
            (Some(slow), Some(fast)) => between(slow, fast),
            _ => self.guess - excess.clamp(-MAX_STRIDE, MAX_STRIDE),
        };
        self.guess = guess.clamp(self.limits.0, self.limits.1);
    }
}

/// Returns the zero of the straight line through both ends.
fn between(slow: BracketEnd, fast: BracketEnd) -> f64 {
    let share = -slow.excess / (fast.excess - slow.excess);
    slow.command + share * (fast.command - slow.command)
}
