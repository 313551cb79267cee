//! Response of a key at rest, as a table: finger speed to hammer speed and delay.

use haptics::plant::{Gesture, Touch};

use super::Rehearsal;
use super::hand::{DEEPEST, LONGEST_RISE, LOOK, QUICK_LIFT};
use crate::stroke::Technique;

/// Slowest finger that presses (m/s).
const SLOWEST_PRESS: f64 = 0.02;

/// Slowest finger that strikes (m/s): in a slower stroke the swing after its impact decides.
const SLOWEST_STRIKE: f64 = 0.1;

/// Fastest finger (m/s) for which gestures are meant.
pub(super) const FASTEST: f64 = 8.0;

/// Fastest finger that plays with ease (m/s).
const FASTEST_WITH_EASE: f64 = 3.0;

/// Speeds tried up to [`FASTEST_WITH_EASE`], in a geometric progression that continues beyond.
const N_SPEEDS: u32 = 24;

/// Path of a finger until its strike is certain (m), for the length of a trial.
const WAY: f64 = 0.02;

/// Additional time of a trial (s): finger and key must gather speed.
const PATIENCE: f64 = 0.2;

/// Longest wait for the damper after a release (s).
const LONGEST_FALL: f64 = 0.5;

/// An easy stroke (m/s), and a hold until all is still (s).
const EASY: (f64, f64) = (0.2, 0.5);

/// Guess for an empty table: hammer speed over finger speed.
const USUAL_RATIO: f64 = 5.0;

/// Guess for an empty table: path of a finger until the strike (m).
const USUAL_WAY: f64 = 0.01;

#[derive(Clone, Copy, PartialEq, Debug)]
struct TablePoint {
    /// Speed that the finger commands (m/s).
    command: f64,
    /// Hammer speed at the string (m/s).
    hammer: f64,
    /// Time from the start of the gesture to the strike (s).
    delay: f64,
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
    /// Time from the release of a held key to the fall of its damper (s), if seen.
    pub fall: Option<f64>,
    /// Time from the quick release of a held key until it can be struck again (s), if it rises.
    pub rise: Option<f64>,
}

impl StrokeTables {
    /// Tries both touches on `instrument`, which is at rest at time 0.
    pub fn measure<R: Rehearsal>(instrument: &R, technique: &Technique) -> Self {
        Self {
            pressed: tabulate(instrument, Touch::Pressed, technique),
            struck: tabulate(instrument, Touch::Struck, technique),
            fall: fall(instrument, technique),
            rise: rise(instrument, technique),
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
}

/// Tries `touch` on `instrument`, at rest at time 0, at 24 speeds of easy play and some beyond.
pub fn tabulate<R: Rehearsal>(instrument: &R, touch: Touch, technique: &Technique) -> StrokeTable {
    let slowest = slowest(touch);
    let ratio = (FASTEST_WITH_EASE / slowest).powf(1.0 / f64::from(N_SPEEDS - 1));
    let commands = (0..2 * N_SPEEDS).map(|index| slowest * ratio.powf(f64::from(index)));
    let commands = commands.take_while(|command| *command <= FASTEST);
    let trials = commands.filter_map(|command| measure(instrument, touch, command, technique));
    StrokeTable { points: rising(&trials.collect::<Vec<_>>()) }
}

/// Returns the slowest useful finger of `touch` (m/s).
pub(super) fn slowest(touch: Touch) -> f64 {
    match touch {
        Touch::Pressed => SLOWEST_PRESS,
        Touch::Struck => SLOWEST_STRIKE,
    }
}

/// Returns the time from the release of a held key to the fall of its damper (s).
fn fall<R: Rehearsal>(instrument: &R, technique: &Technique) -> Option<f64> {
    let gesture = technique.gesture(Touch::Pressed, EASY.0, 0.0, EASY.1);
    let outcome = instrument.clone().play(&[gesture], EASY.1 + LONGEST_FALL);
    outcome.damper_fall.map(|at| at - EASY.1).filter(|fall| *fall > 0.0)
}

/// Returns the time from the quick release of a held key until it can be struck (s).
fn rise<R: Rehearsal>(instrument: &R, technique: &Technique) -> Option<f64> {
    let (speed, release) = EASY;
    let press = technique.gesture(Touch::Pressed, speed, 0.0, release);
    let gesture = Gesture { lift: QUICK_LIFT, ..press };
    let mut instrument = instrument.clone();
    let mut looks = (0..LONGEST_RISE).map(|look| f64::from(look) * LOOK);
    looks.find(|after| {
        instrument.play(&[gesture], release + after);
        instrument.depth() <= DEEPEST
    })
}

fn measure<R: Rehearsal>(
    instrument: &R,
    touch: Touch,
    command: f64,
    technique: &Technique,
) -> Option<TablePoint> {
    let until = WAY / command + PATIENCE;
    let gesture = technique.gesture(touch, command, 0.0, f64::INFINITY);
    let outcome = instrument.clone().play(&[gesture], until);
    let &[strike] = outcome.strikes.as_slice() else { return None };
    let sound = strike.speed > 0.0 && strike.at > 0.0 && strike.speed.is_finite();
    sound.then_some(TablePoint { command, hammer: strike.speed, delay: strike.at })
}

/// Returns the longest subsequence of `points` with strictly rising hammer speed.
fn rising(points: &[TablePoint]) -> Vec<TablePoint> {
    let mut best: Vec<Vec<TablePoint>> = Vec::with_capacity(points.len());
    for point in points {
        let below = best.iter().filter(|run| run.last().is_some_and(|l| l.hammer < point.hammer));
        let mut run = longest(below).cloned().unwrap_or_default();
        run.push(*point);
        best.push(run);
    }
    longest(best.iter()).cloned().unwrap_or_default()
}

/// Returns the first of the longest runs.
fn longest<'a>(runs: impl Iterator<Item = &'a Vec<TablePoint>>) -> Option<&'a Vec<TablePoint>> {
    runs.reduce(|best, run| if run.len() > best.len() { run } else { best })
}

/// Returns `to` at `from` = `x`: straight between points on logarithmic scales.
fn interpolate(
    points: &[TablePoint],
    x: f64,
    from: fn(&TablePoint) -> f64,
    to: fn(&TablePoint) -> f64,
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
        let hammers: Vec<f64> = rising(&points).iter().map(|point| point.hammer).collect();
        assert_eq!(hammers, [1.0, 1.5, 2.0]);
    }
}
