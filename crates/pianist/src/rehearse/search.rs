//! Search for finger speed and start of one stroke, by trials.

use haptics::plant::{Gesture, Touch};

use super::price::{ACCEPTABLE, FAIR, FRAGILE, SECOND_STRIKE};
use super::take::Take;
use super::{Practice, Rehearsal, Strike, table};
use crate::stroke::PlannedStroke;

/// Most simulations for one stroke and touch.
const MAX_TRIES: u32 = 12;

/// Price per try up to which a stroke is taken as it is.
const PATIENCE: f64 = 0.15;

/// Most simulations on a key that still moves.
const TRIES_IN_MOTION: u32 = 8;

/// Price after some tries above which a moving key needs more time.
const HOPELESS: f64 = 15.0;
const TRIES_FOR_HOPE: u32 = 4;

/// Accepted error of the velocity (MIDI units).
const LEVEL_TOLERANCE: f64 = 0.3;

/// Accepted error of the onset (s).
const ONSET_TOLERANCE: f64 = 1e-4;

/// Shifts of the start that a stroke must bear (s): a tick that the machine loses.
const LOST_TICKS: [f64; 2] = [-1e-3, 1e-3];

/// Time after a strike in which a second one is searched, and after its due time the first (s).
const WATCH: f64 = 0.08;

/// Largest change of the finger speed between tries, as a natural logarithm.
const MAX_STRIDE: f64 = 0.7;

/// Assumed error of a gesture without a strike: this much too slow, as a natural logarithm.
const MISS_STRIDE: f64 = 0.4;

/// Depth at which an action lets off (m), for a first guess.
const LET_OFF: f64 = 9e-3;

/// Time from the deepest start to the strike over that from rest, see [`Gesture::passes`].
const SHORTEST_WAY: f64 = 0.25;

/// Halvings of the time within which a stroke starts: to below 1 us of 0.5 s.
const HALVINGS: u32 = 20;

/// Spare time before the earliest considered start (s).
const MARGIN: f64 = 0.03;

/// Starts that are tried on a moving key, and halvings between two of them.
const N_STARTS: u32 = 11;
const HALVINGS_OF_START: u32 = 4;

/// Shortest and longest time from these starts to the strike (s).
const SHORTEST_STROKE: f64 = 12e-3;
const LONGEST_STROKE: f64 = 0.15;

/// Tries for the speed from one start.
const TRIES_PER_START: u32 = 4;

/// Error of the onset that ends them (s), and that of strikes whose loudness is compared (s).
const IN_TIME: f64 = 0.5e-3;
const NEARLY: f64 = 6e-3;

/// Fingers that are tried from each start, if all are.
const N_FINGERS: u32 = 12;

/// Fingers that are tried in time, as logarithms of their speed over that from rest.
const SPEEDS_IN_TIME: std::ops::Range<f64> = -0.7..3.0;

/// Time after the onset when a strike no longer counts (s).
const OVERDUE: f64 = 0.03;

#[derive(Clone, Debug)]
pub(super) struct Try<R> {
    /// The key with the gesture, up to some time after the strike.
    pub(super) take: Take<R>,
    pub(super) gesture: Gesture,
    pub(super) strike: Option<Strike>,
    pub(super) price: f64,
    pub(super) n_extra: usize,
    pub(super) n_tries: u32,
}

impl<R> Try<R> {
    /// Returns `true` if neither the other touch nor an earlier release need be tried.
    pub(super) fn is_acceptable(&self) -> bool {
        self.price <= ACCEPTABLE
    }

    /// Returns the cheaper one, with the tries of both.
    pub(super) fn or(self, other: Self) -> Self {
        let n_tries = self.n_tries + other.n_tries;
        let best = if other.price < self.price { other } else { self };
        Self { n_tries, ..best }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum SearchEffort {
    /// Corrections of a guess: enough for a key that is nearly at rest.
    Usual,
    /// Starts while the key rises, each with the finger that strikes in time.
    Scan,
    /// All starts with all fingers.
    Everything,
}

/// Finds speed and start on `take` with `effort`; `None` if there is no time for a stroke.
pub(super) fn find<R: Rehearsal>(
    practice: &mut Practice<'_>,
    take: &mut Take<R>,
    wanted: &PlannedStroke,
    effort: SearchEffort,
) -> Option<Try<R>> {
    if effort == SearchEffort::Usual {
        return Some(find_usual(practice, take, wanted));
    }
    let search = StrokeSearch::new(practice, take, wanted, Touch::Pressed);
    if effort == SearchEffort::Scan { search.scan(take) } else { search.everything(take) }
}

/// Finds speed and start by the wanted touch or else by the other; learns from strokes at rest.
pub(super) fn find_usual<R: Rehearsal>(
    practice: &mut Practice<'_>,
    take: &mut Take<R>,
    wanted: &PlannedStroke,
) -> Try<R> {
    let longest = [Touch::Pressed, Touch::Struck].map(|touch| practice.guess(touch, wanted).1);
    // The search may halve the speed.
    take.skip(wanted.onset - 2.0 * longest[0].max(longest[1]) - MARGIN);
    let first = StrokeSearch::new(practice, take, wanted, wanted.touch).find(take);
    practice.learn(take, &first);
    let is_still = take.is_still(first.gesture.start);
    let is_enough = first.is_acceptable() && practice.is_within_reach(wanted);
    if is_enough || !is_still && wanted.touch == Touch::Pressed {
        return first;
    }
    let second = StrokeSearch::new(practice, take, wanted, other(wanted.touch)).find(take);
    practice.learn(take, &second);
    first.or(second)
}

struct StrokeSearch<'a> {
    practice: &'a Practice<'a>,
    wanted: &'a PlannedStroke,
    touch: Touch,
    /// Time from which the finger is free (s).
    earliest: f64,
    /// Start of the gesture (s).
    start: f64,
    bracket: SpeedBracket,
}

impl<'a> StrokeSearch<'a> {
    fn new<R: Rehearsal>(
        practice: &'a Practice<'a>,
        take: &mut Take<R>,
        wanted: &'a PlannedStroke,
        touch: Touch,
    ) -> Self {
        let (command, delay) = practice.guess(touch, wanted);
        let earliest = take.free_from();
        let start = (wanted.onset - delay).max(earliest);
        let bracket = SpeedBracket::new(touch, command);
        let mut search = Self { practice, wanted, touch, earliest, start, bracket };
        search.aim(take, wanted.onset);
        search
    }

    fn find<R: Rehearsal>(mut self, take: &mut Take<R>) -> Try<R> {
        let mut last = self.attempt(take);
        let mut n_tries = 1;
        let most = if take.is_still(last.gesture.start) { MAX_TRIES } else { TRIES_IN_MOTION };
        let mut best: Option<Try<R>> = None;
        loop {
            let is_done = self.is_good(&last) || most <= n_tries;
            let strike = last.strike;
            if best.as_ref().is_none_or(|best| last.price < best.price) {
                best = Some(last);
            }
            let enough = (PATIENCE * f64::from(n_tries)).min(ACCEPTABLE);
            let is_cheap = best.as_ref().is_some_and(|best| best.price <= enough);
            let is_enough = is_cheap && self.practice.is_within_reach(self.wanted);
            let is_hopeless = most < MAX_TRIES
                && TRIES_FOR_HOPE <= n_tries
                && best.as_ref().is_some_and(|best| HOPELESS < best.price);
            if is_done || is_enough || is_hopeless || !self.correct(take, strike) {
                break;
            }
            last = self.attempt(take);
            n_tries += 1;
        }
        let Some(mut best) = best else { unreachable!("there is a first try") };
        self.watch(take, &mut best);
        Try { n_tries, ..best }
    }

    /// Searches on a key that still moves, where the hammer's answer has folds and gaps. From each of
    /// some starts the finger is as fast as it must be to strike in time: the later the start, the
    /// louder. Bisects between two starts if one is too loud and the other too soft.
    fn scan<R: Rehearsal>(mut self, take: &mut Take<R>) -> Option<Try<R>> {
        let mut scan = StartScan::new(self.earliest, self.wanted.onset)?;
        let command = self.bracket.guess;
        let mut best: Option<Try<R>> = None;
        let mut n_tries = 0;
        // Time of a finger's way to let-off over that to the strike, as it was last.
        let mut share = self.way(0.0) / self.practice.tables.of(self.touch).delay(command.exp());
        while let Some(start) = scan.next() {
            take.record(start, |_| false);
            let depth = take.depth(start);
            self.bracket.guess = command;
            let faster = (self.way(depth) / (share * (self.wanted.onset - start))).ln();
            if !SPEEDS_IN_TIME.contains(&faster) {
                continue;
            }
            self.bracket.guess += faster;
            let (tried, n) = self.in_time(take, (start, depth));
            n_tries += n;
            let strike = tried.strike.filter(|it| (it.at - self.wanted.onset).abs() < NEARLY);
            if let Some(strike) = strike {
                scan.louder(self.too_fast_by(Some(strike)));
                self.bracket.guess = tried.gesture.speed.ln();
                share = self.way(depth) / (strike.at - start);
            }
            if best.as_ref().is_none_or(|best| tried.price < best.price) {
                best = Some(tried);
            }
            if best.as_ref().is_some_and(Try::is_acceptable) {
                break;
            }
        }
        let mut best = best?;
        self.watch(take, &mut best);
        Some(Try { n_tries, ..best })
    }

    /// Searches among all starts and fingers, where a soft note on a moving key may be an accident.
    fn everything<R: Rehearsal>(mut self, take: &mut Take<R>) -> Option<Try<R>> {
        let mut scan = StartScan::new(self.earliest, self.wanted.onset)?;
        let command = self.bracket.guess;
        let mut best: Option<Try<R>> = None;
        let mut n_tries = 0;
        while let Some(start) = scan.next() {
            take.record(start, |_| false);
            let depth = take.depth(start);
            for index in 0..N_FINGERS {
                let range = SPEEDS_IN_TIME.end - SPEEDS_IN_TIME.start;
                let faster = range * f64::from(index) / f64::from(N_FINGERS - 1);
                let limits = self.bracket.limits;
                let guess = command + SPEEDS_IN_TIME.start + faster;
                self.bracket.guess = guess.clamp(limits.0, limits.1);
                let gesture = self.gesture_from(start, depth);
                let tried = self.play(take, gesture, self.wanted.onset + OVERDUE);
                n_tries += 1;
                best = best.filter(|best| best.price <= tried.price).or(Some(tried));
            }
            if best.as_ref().is_some_and(|best| best.price <= FAIR) {
                break;
            }
        }
        let Gesture { start, from, speed, .. } = best.as_ref()?.gesture;
        self.bracket.guess = speed.ln();
        let (better, n) = self.in_time(take, (start, from));
        let mut best = best?.or(better);
        self.watch(take, &mut best);
        Some(Try { n_tries: n_tries + n, ..best })
    }

    /// Returns the best stroke from a start (s) and depth (m) that strikes in time, and the tries.
    fn in_time<R: Rehearsal>(
        &mut self,
        take: &Take<R>,
        (start, depth): (f64, f64),
    ) -> (Try<R>, u32) {
        let onset = self.wanted.onset;
        let mut n_tries = 1;
        let mut best = self.play(take, self.gesture_from(start, depth), onset + OVERDUE);
        let mut strike = best.strike;
        while n_tries < TRIES_PER_START {
            let faster = match strike {
                Some(it) if (it.at - onset).abs() < IN_TIME => break,
                Some(it) => ((it.at - start) / (onset - start)).ln(),
                None if 1 < n_tries => break,
                None => MISS_STRIDE,
            };
            let limits = self.bracket.limits;
            self.bracket.guess = (self.bracket.guess + faster).clamp(limits.0, limits.1);
            let tried = self.play(take, self.gesture_from(start, depth), onset + OVERDUE);
            strike = tried.strike;
            n_tries += 1;
            if tried.price < best.price {
                best = tried;
            }
        }
        (best, n_tries)
    }

    /// Returns the time of the present finger from `depth` (m) to let-off (s).
    fn way(&self, depth: f64) -> f64 {
        self.gesture_from(0.0, depth).passes(LET_OFF)
    }

    /// Plays the best try on, for what its hammer does after the strike.
    fn watch<R: Rehearsal>(&self, take: &Take<R>, best: &mut Try<R>) {
        let Some(strike) = best.strike else { return };
        best.take.record(strike.at + WATCH, |_| false);
        best.n_extra = best.take.strikes(best.gesture.start, f64::INFINITY).count() - 1;
        best.price += SECOND_STRIKE * best.n_extra as f64;
        if !self.is_sure(take, best.gesture) {
            best.price += FRAGILE;
        }
    }

    /// Sets the start so that the strike is expected at `at` (s), or as early as possible: between
    /// the earliest start and that from rest, since a later one finds the key higher.
    fn aim<R: Rehearsal>(&mut self, take: &mut Take<R>, at: f64) {
        let from_rest = at - self.delay_from(0.0);
        take.record(from_rest, |_| false);
        if take.depth(from_rest) == 0.0 && self.earliest <= from_rest {
            self.start = from_rest;
            return;
        }
        take.record(at - SHORTEST_WAY * (at - from_rest), |_| false);
        let (mut early, mut late) = (self.earliest, at);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (early + late);
            let is_late = at < middle + self.delay_from(take.depth(middle));
            (early, late) = if is_late { (early, middle) } else { (middle, late) };
        }
        self.start = early;
    }

    /// Returns the gesture of the present speed that starts at `start` (s) from `depth` (m).
    fn gesture_from(&self, start: f64, depth: f64) -> Gesture {
        let Self { practice, touch, .. } = *self;
        let speed = self.bracket.guess.exp();
        let usual = practice.technique.gesture(touch, speed, start, f64::INFINITY);
        match touch {
            Touch::Pressed => Gesture { from: depth, ..usual },
            Touch::Struck => usual,
        }
    }

    fn attempt<R: Rehearsal>(&self, take: &mut Take<R>) -> Try<R> {
        take.record(self.start, |_| false);
        let depth = take.depth(self.start);
        let due = self.wanted.onset.max(self.start + self.delay_from(depth));
        let gesture = self.gesture_from(self.start, depth);
        self.play(take, gesture, due + WATCH)
    }

    /// Plays `gesture` up to its strike, or until `until` (s).
    fn play<R: Rehearsal>(&self, take: &Take<R>, gesture: Gesture, until: f64) -> Try<R> {
        let first = |it: &Take<R>| it.strikes(gesture.start, f64::INFINITY).next().copied();
        let mut take = take.branch(gesture.start, gesture);
        take.record(until, |it| first(it).is_some());
        let strike = first(&take);
        let price = self.practice.price(self.wanted, strike);
        Try { take, gesture, strike, price, n_extra: 0, n_tries: 1 }
    }

    /// Returns `true` if `gesture` strikes even if a tick is lost: a key that is struck again
    /// before it rests may only just catch its hammer.
    fn is_sure<R: Rehearsal>(&self, take: &Take<R>, gesture: Gesture) -> bool {
        if take.depth(gesture.start) == 0.0 {
            return true;
        }
        LOST_TICKS.iter().all(|late| {
            let start = (gesture.start + late).max(self.earliest);
            let moved = Gesture { start, ..gesture };
            self.play(take, moved, self.wanted.onset + WATCH).strike.is_some()
        })
    }

    fn is_good<R>(&self, tried: &Try<R>) -> bool {
        let is_in_time = |it: &Strike| (it.at - self.wanted.onset).abs() <= ONSET_TOLERANCE;
        self.is_level(tried.strike) && tried.strike.as_ref().is_some_and(is_in_time)
    }

    fn is_level(&self, strike: Option<Strike>) -> bool {
        let level = |it: Strike| self.practice.curve.level(it.speed).clamp(0.0, 128.0);
        let wanted = self.practice.curve.level(self.wanted.speed).clamp(0.0, 128.0);
        strike.is_some_and(|it| (level(it) - wanted).abs() <= LEVEL_TOLERANCE)
    }

    /// Corrects speed and start after a `strike`; returns `false` if neither can change.
    fn correct<R: Rehearsal>(&mut self, take: &mut Take<R>, strike: Option<Strike>) -> bool {
        let (guess, start) = (self.bracket.guess, self.start);
        let expected = start + self.delay_from(take.depth(start));
        if !self.is_level(strike) {
            self.bracket.learn(self.too_fast_by(strike));
        }
        let lag = strike.map_or(0.0, |strike| strike.at - expected);
        self.aim(take, self.wanted.onset - lag);
        let is_elsewhere = (self.start - start).abs() > 0.1 * ONSET_TOLERANCE;
        is_elsewhere || guess.to_bits() != self.bracket.guess.to_bits()
    }

    /// Returns the natural logarithm of hammer speed over wanted hammer speed.
    fn too_fast_by(&self, strike: Option<Strike>) -> f64 {
        match strike {
            Some(strike) if strike.speed > 0.0 => (strike.speed / self.wanted.speed).ln(),
            _ => -MISS_STRIDE,
        }
    }

    /// Returns the time (s) from a start at `depth` (m) to the strike, less than that from rest.
    fn delay_from(&self, depth: f64) -> f64 {
        let way = self.way(depth) / self.way(0.0);
        way * self.practice.tables.of(self.touch).delay(self.bracket.guess.exp())
    }
}

/// Starts of a stroke, from late to early, with halvings where it gets too soft.
struct StartScan {
    /// Latest start (s), and the distance to the next one.
    latest: f64,
    step: f64,
    index: u32,
    /// Last start, and the last one that was too loud, if it is its neighbour.
    start: f64,
    loud: Option<f64>,
    /// A start that is too loud, one that is too soft, and halvings left.
    between: Option<(f64, f64, u32)>,
}

impl StartScan {
    /// Returns the starts from `earliest` (s) for a strike at `onset` (s), if there is time.
    fn new(earliest: f64, onset: f64) -> Option<Self> {
        let latest = onset - SHORTEST_STROKE;
        let span = (latest - earliest).min(LONGEST_STROKE);
        let step = span / f64::from(N_STARTS - 1);
        (0.0 < span).then_some(Self {
            latest,
            step,
            index: 0,
            start: latest,
            loud: None,
            between: None,
        })
    }

    fn next(&mut self) -> Option<f64> {
        if let Some((loud, soft, left)) = self.between {
            self.between = (1 < left).then_some((loud, soft, left - 1));
            self.start = 0.5 * (loud + soft);
            return Some(self.start);
        }
        self.start = self.latest - f64::from(self.index) * self.step;
        self.index += 1;
        (self.index <= N_STARTS).then_some(self.start)
    }

    /// Learns that a strike in time from the last start is too fast by a logarithm.
    fn louder(&mut self, louder: f64) {
        let is_loud = 0.0 < louder;
        self.between = match self.between {
            Some((_, soft, left)) if is_loud => Some((self.start, soft, left)),
            Some((loud, _, left)) => Some((loud, self.start, left)),
            None if is_loud => None,
            None => self.loud.map(|loud| (loud, self.start, HALVINGS_OF_START)),
        };
        self.loud = is_loud.then_some(self.start);
    }
}

fn other(touch: Touch) -> Touch {
    match touch {
        Touch::Pressed => Touch::Struck,
        Touch::Struck => Touch::Pressed,
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
