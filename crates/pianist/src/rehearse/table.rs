//! Response of a key at rest, as a table: finger speed to hammer speed and delay.

use haptics::plant::{Gesture, Touch};

use super::take::Take;
use super::{Rehearsal, Strike};
use crate::stroke::Technique;

/// Slowest finger that presses (m/s).
const SLOWEST_PRESS: f64 = 0.02;

/// Slowest finger that strikes (m/s): in a slower stroke the swing after its impact decides.
const SLOWEST_STRIKE: f64 = 0.1;

/// Fastest finger (m/s) for which gestures are meant.
pub(super) const FASTEST: f64 = 8.0;

/// Factor from one tried speed to the next. Above [`FINE`] the response of many actions folds.
const COARSE_STEP: f64 = 1.6;
const FINE_STEP: f64 = 1.25;

/// Finger speed (m/s) above which trials are dense, and short.
const FINE: f64 = 1.5;

/// Halvings of the gap below the softest stroke: to a twentieth of a speed.
const HALVINGS: u32 = 4;

/// Most points of a table that learns.
const MAX_POINTS: usize = 64;

/// Path of a finger until its strike is certain (m), for the length of a trial.
const WAY: f64 = 0.02;

/// Additional time of a trial (s): finger and key must gather speed.
const PATIENCE: f64 = 0.2;

/// Time after a strike in which a second one spoils a trial (s).
const WATCH: f64 = 0.06;

/// Time between two looks for a strike (s).
const LOOK: f64 = 4e-3;

/// Longest wait for the damper after a lift (s).
const LONGEST_FALL: f64 = 0.25;

/// An easy stroke (m/s), and a hold until all is still (s).
const EASY: (f64, f64) = (0.2, 0.5);

/// Time of the quickest lift of a finger (s) (estimate).
pub(crate) const QUICK_LIFT: f64 = 20e-3;

/// Lifts that are tried for notes with a release velocity (s).
pub(crate) const LIFTS: [f64; 8] = [10e-3, QUICK_LIFT, 35e-3, 60e-3, 0.11, 0.22, 0.45, 1.0];

/// Guess for a key that was not seen to fall: time from a release to the fall of the damper (s).
const USUAL_FALL: f64 = 0.03;

/// Guess for an empty table: hammer speed over finger speed.
const USUAL_RATIO: f64 = 5.0;

/// Guess for an empty table: path of a finger until the strike (m).
const USUAL_WAY: f64 = 0.01;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct TablePoint {
    /// Speed that the finger commands (m/s).
    pub(super) command: f64,
    /// Hammer speed at the string (m/s).
    pub(super) hammer: f64,
    /// Time from the start of the gesture to the strike (s).
    pub(super) delay: f64,
}

/// Responses of a key at rest to gestures of one touch. Hammer speed rises strictly with finger
/// speed; other trials, and those without exactly one strike, are left out.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct StrokeTable {
    points: Vec<TablePoint>,
}

impl StrokeTable {
    /// Returns the finger speed (m/s) for hammer speed `hammer` (m/s), within the table.
    pub fn command(&self, hammer: f64) -> f64 {
        let found = interpolate(&self.points, hammer, |point| point.hammer, |point| point.command);
        found.unwrap_or(hammer / USUAL_RATIO)
    }

    /// Returns the time from a gesture's start at finger speed `command` (m/s) to its strike (s).
    pub fn delay(&self, command: f64) -> f64 {
        let found = interpolate(&self.points, command, |point| point.command, |point| point.delay);
        found.unwrap_or(USUAL_WAY / command.max(SLOWEST_PRESS))
    }

    /// Adds a stroke from rest, so that a table serves equal strokes better than its first trials.
    pub(super) fn learn(&mut self, point: TablePoint) {
        let after = self.points.partition_point(|it| it.command < point.command);
        let (low, high) = self.points.split_at(after);
        let is_above = |it: &TablePoint| it.command < point.command && it.hammer < point.hammer;
        let is_below = |it: &TablePoint| point.command < it.command && point.hammer < it.hammer;
        let fits = low.last().is_some_and(is_above) && high.first().is_some_and(is_below);
        if fits && self.points.len() < MAX_POINTS {
            self.points.insert(after, point);
        }
    }

    /// Returns the softest and loudest hammer speed of this touch (m/s), if it strikes.
    pub fn range(&self) -> Option<(f64, f64)> {
        Some((self.points.first()?.hammer, self.points.last()?.hammer))
    }
}

/// Tables of a key, one for each touch.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct StrokeTables {
    /// Finger resting on the key.
    pub pressed: StrokeTable,
    /// Finger coming from above.
    pub struck: StrokeTable,
    pub lifts: LiftTable,
}

impl StrokeTables {
    /// Tries both touches on `instrument`, which is at rest at time 0, and `lifts` (s).
    pub fn measure<R: Rehearsal>(instrument: &R, technique: &Technique, lifts: &[f64]) -> Self {
        Self {
            pressed: tabulate(instrument, Touch::Pressed, technique),
            struck: tabulate(instrument, Touch::Struck, technique),
            lifts: LiftTable::measure(instrument, technique, lifts),
        }
    }

    /// Returns the softest and loudest hammer speed of any touch from rest (m/s), if any.
    pub fn range(&self) -> Option<(f64, f64)> {
        let ranges = [&self.pressed, &self.struck].into_iter().filter_map(StrokeTable::range);
        ranges.reduce(|one, other| (one.0.min(other.0), one.1.max(other.1)))
    }

    pub fn of(&self, touch: Touch) -> &StrokeTable {
        match touch {
            Touch::Pressed => &self.pressed,
            Touch::Struck => &self.struck,
        }
    }

    pub(super) const fn of_mut(&mut self, touch: Touch) -> &mut StrokeTable {
        match touch {
            Touch::Pressed => &mut self.pressed,
            Touch::Struck => &mut self.struck,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
struct LiftPoint {
    /// Duration of the finger's lift (s).
    lift: f64,
    /// Time from the release to the fall of the damper (s).
    fall: f64,
    /// Speed of the key at that fall (m/s).
    speed: f64,
}

/// Responses of a held key to the lifts of its finger, slow to fast. The speed of the key rises
/// strictly with that of the lift; other trials, and those without a fall, are left out.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct LiftTable {
    points: Vec<LiftPoint>,
}

impl LiftTable {
    fn measure<R: Rehearsal>(instrument: &R, technique: &Technique, lifts: &[f64]) -> Self {
        let press = technique.gesture(Touch::Pressed, EASY.0, 0.0, f64::INFINITY);
        let mut held = Take::new(instrument.clone()).branch(0.0, press);
        held.skip(EASY.1);
        let release = held.earliest();
        let trials = lifts.iter().rev().filter_map(|&lift| {
            let mut take = held.branch(release, Gesture { release, lift, ..press });
            let fall = |take: &Take<R>| take.fall(release, f64::INFINITY);
            take.record(release + lift + LONGEST_FALL, |it| fall(it).is_some());
            let fall = fall(&take)?;
            Some(LiftPoint { lift, fall: fall.at - release, speed: fall.speed })
        });
        Self { points: rising(&trials.collect::<Vec<_>>(), |point| point.speed) }
    }

    /// Returns the lift (s) with which the damper falls at `speed` (m/s), within the table.
    pub fn lift(&self, speed: f64) -> f64 {
        let found = interpolate(&self.points, speed, |point| point.speed, |point| point.lift);
        found.unwrap_or(Gesture::LIFT)
    }

    /// Returns the time from the release to the fall of the damper (s) for a `lift` (s).
    pub fn fall(&self, lift: f64) -> f64 {
        let rate = |point: &LiftPoint| 1.0 / point.lift;
        interpolate(&self.points, 1.0 / lift, rate, |point| point.fall).unwrap_or(USUAL_FALL)
    }
}

/// Tries `touch` on `instrument`, at rest at time 0, at some twenty speeds.
pub fn tabulate<R: Rehearsal>(instrument: &R, touch: Touch, technique: &Technique) -> StrokeTable {
    let slowest = slowest(touch);
    let next = |speed: &f64| Some(speed * if *speed < FINE { COARSE_STEP } else { FINE_STEP });
    let commands = std::iter::successors(Some(slowest), next).take_while(|it| *it < FASTEST);
    let commands = commands.chain([FASTEST]);
    let trial = |command| measure(instrument, touch, command, technique);
    let trials: Vec<_> = commands.filter_map(trial).collect();
    let mut points = with_loudest(rising(&trials, |point| point.hammer), &trials);
    if let Some(softest) = points.first().copied() {
        points.splice(..0, softer(softest, slowest, trial));
    }
    StrokeTable { points }
}

/// Returns `points` up to the loudest of all `trials`: beyond a fold, faster fingers are no louder.
/// An outlier that spoils most of the table is none.
fn with_loudest(points: Vec<TablePoint>, trials: &[TablePoint]) -> Vec<TablePoint> {
    let loudest = trials.iter().max_by(|a, b| a.hammer.total_cmp(&b.hammer));
    let Some(loudest) = loudest else { return points };
    let is_below = |it: &&TablePoint| it.command < loudest.command && it.hammer < loudest.hammer;
    let below: Vec<_> = points.iter().filter(is_below).chain([loudest]).copied().collect();
    if points.len() < 2 * below.len() { below } else { points }
}

/// Searches the softest stroke between a finger speed that strikes and the slowest one (m/s);
/// returns the strokes on the way, soft to loud.
fn softer(
    mut softest: TablePoint,
    mut silent: f64,
    trial: impl Fn(f64) -> Option<TablePoint>,
) -> Vec<TablePoint> {
    let mut found = Vec::new();
    for _ in 0..HALVINGS {
        let tried = trial((silent * softest.command).sqrt());
        match tried.filter(|point| point.hammer < softest.hammer) {
            Some(point) => {
                softest = point;
                found.insert(0, point);
            }
            None => silent = (silent * softest.command).sqrt(),
        }
    }
    found
}

/// Returns the slowest useful finger of `touch` (m/s).
pub(super) fn slowest(touch: Touch) -> f64 {
    match touch {
        Touch::Pressed => SLOWEST_PRESS,
        Touch::Struck => SLOWEST_STRIKE,
    }
}

fn measure<R: Rehearsal>(
    instrument: &R,
    touch: Touch,
    command: f64,
    technique: &Technique,
) -> Option<TablePoint> {
    let gesture = technique.gesture(touch, command, 0.0, f64::INFINITY);
    let mut instrument = instrument.clone();
    let (mut until, mut now) = (WAY / command + PATIENCE, 0.0);
    let mut strikes = Vec::new();
    while now < until {
        now += LOOK;
        strikes.extend(instrument.play(&[gesture], now).strikes);
        until = strikes.first().map_or(until, |first: &Strike| until.min(first.at + WATCH));
    }
    let &[strike] = strikes.as_slice() else { return None };
    let sound = strike.speed > 0.0 && strike.at > 0.0 && strike.speed.is_finite();
    sound.then_some(TablePoint { command, hammer: strike.speed, delay: strike.at })
}

/// Returns the longest subsequence of `points` in which `value` rises strictly.
fn rising<P: Copy>(points: &[P], value: fn(&P) -> f64) -> Vec<P> {
    let mut best: Vec<Vec<P>> = Vec::with_capacity(points.len());
    for point in points {
        let below = best.iter().filter(|run| run.last().is_some_and(|l| value(l) < value(point)));
        let mut run = longest(below).cloned().unwrap_or_default();
        run.push(*point);
        best.push(run);
    }
    longest(best.iter()).cloned().unwrap_or_default()
}

/// Returns the first of the longest runs.
fn longest<'a, P>(runs: impl Iterator<Item = &'a Vec<P>>) -> Option<&'a Vec<P>> {
    runs.reduce(|best, run| if run.len() > best.len() { run } else { best })
}

/// Returns `to` at `from` = `x`: straight between points on logarithmic scales.
fn interpolate<P>(
    points: &[P],
    x: f64,
    from: impl Fn(&P) -> f64,
    to: impl Fn(&P) -> f64,
) -> Option<f64> {
    let after = points.partition_point(|point| from(point) < x);
    let low = points.get(after.saturating_sub(1))?;
    let Some(high) = points.get(after) else { return Some(to(low)) };
    if from(high) <= from(low) {
        return Some(to(low));
    }
    let share = (x / from(low)).ln() / (from(high) / from(low)).ln();
    Some(to(low) * (to(high) / to(low)).powf(share))
}

impl Technique {
    /// Returns a gesture of this technique; times in s, `speed` of the finger in m/s.
    pub(super) fn gesture(&self, touch: Touch, speed: f64, start: f64, release: f64) -> Gesture {
        Gesture { start, release, touch, speed, hold: self.hold, ..Gesture::USUAL }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(command: f64, hammer: f64) -> TablePoint {
        TablePoint { command, hammer, delay: 0.01 / command }
    }

    #[test]
    fn a_power_law_is_met_between_the_points_too() {
        let points = [0.1, 0.2, 0.4].map(|command: f64| point(command, 4.0 * command.powf(1.2)));
        let table = StrokeTable { points: points.to_vec() };
        assert!((table.command(4.0 * 0.3_f64.powf(1.2)) - 0.3).abs() < 1e-12);
        assert!((table.delay(0.3) - 0.01 / 0.3).abs() < 1e-12);
    }

    #[test]
    fn beyond_its_ends_a_table_says_its_ends() {
        let table = StrokeTable { points: vec![point(0.1, 0.5), point(0.4, 2.0)] };
        assert_eq!((table.command(0.01), table.command(9.0)), (0.1, 0.4));
        assert!((table.delay(4.0) - 0.01 / 0.4).abs() < 1e-12);
        assert_eq!(table.range(), Some((0.5, 2.0)));
    }

    #[test]
    fn an_outlier_is_left_out() {
        let points =
            [point(0.1, 9.0), point(0.2, 1.0), point(0.3, 1.5), point(0.4, 1.4), point(0.5, 2.0)];
        let hammers: Vec<f64> =
            rising(&points, |point| point.hammer).iter().map(|point| point.hammer).collect();
        assert_eq!(hammers, [1.0, 1.5, 2.0]);
    }
}
