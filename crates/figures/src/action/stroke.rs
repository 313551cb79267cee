//! One stroke: when the hammer meets the string, when the key its bed, and what happens then.

use super::drive::{Drive, StrokeTouch};
use super::grands::StrokeTime;
use super::key::{ActionSample, StringContact};
use super::subject::PianoSubject;

/// Length of a tick while the hammer is on its way (s).
const FINE: f64 = 5e-5;
/// Length of a tick while the key is held (s).
const COARSE: f64 = 5e-4;
/// How long a key is held after its stroke (s): the hammer has come to rest then.
const HOLD: f64 = 0.2;
/// How long a stroke is followed finely after its hammer should have met the string (s).
const FINELY_AFTER: f64 = 0.03;

/// A stroke that reached the string.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stroke {
    pub touch: StrokeTouch,
    /// Time that the key took for most of its way (s), which was asked for.
    pub duration: f64,
    /// Speed of the hammer at the string (m/s).
    pub speed: f64,
    /// From the key's start to the string (s).
    pub travel: f64,
    /// From the string to the key's bottom (s), where the key got there.
    pub key_bottom: Option<f64>,
    /// From the hammer's release to the string (s), where the model tells the action's force.
    pub free_flight: Option<f64>,
    /// Height of the hammer below the string with the key held (m), where the model tells.
    pub checked: Option<f64>,
    /// Strikes, the first one included.
    pub strikes: usize,
    /// Greatest speed of the hammer on its way (m/s), where the model tells its height.
    pub thrown: Option<f64>,
}

impl Stroke {
    /// What was timed, if it was.
    pub fn timed(&self, what: StrokeTime) -> Option<f64> {
        match what {
            StrokeTime::Travel => Some(self.travel),
            StrokeTime::KeyBottom => self.key_bottom,
            StrokeTime::FreeFlight => self.free_flight,
        }
    }

    /// Free flight times speed (m): where the hammer leaves the action.
    pub fn gap(&self) -> Option<f64> {
        self.free_flight.map(|time| time * self.speed)
    }
}

/// Why a stroke gave nothing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Miss {
    /// The hammer did not reach the string.
    Silent,
    /// The model could not be advanced.
    Failed,
}

/// Plays one stroke on `key`, and holds it.
pub(super) fn play(
    subject: &PianoSubject<'_>,
    key: u8,
    (touch, duration): (StrokeTouch, f64),
) -> Result<Stroke, Miss> {
    let mut driven = subject.open(key);
    let dip = subject.dip(key);
    let drive = Drive::stroke(touch, duration, dip);
    let fine_until = 1.3 * duration + FINELY_AFTER;
    let until = fine_until + HOLD;
    let mut seen = Seen::new(driven.sample(), dip);
    let mut t = 0.0;
    // A fine tick each 50 µs of the stroke, then 400 coarse ones.
    while t < until {
        let h = if t < fine_until { FINE } else { COARSE };
        if !driven.advance(h, &|theta| drive.at(t + theta * h)) {
            return Err(Miss::Failed);
        }
        t += h;
        let first = driven.strikes().first().copied();
        seen.add(driven.sample(), first);
    }
    let StringContact { t: met, speed, .. } = *driven.strikes().first().ok_or(Miss::Silent)?;
    let string = subject.parameter("string_height", key);
    Ok(Stroke {
        touch,
        duration,
        speed,
        travel: met,
        key_bottom: seen.bottom.map(|bottom| bottom - met),
        free_flight: seen.released.map(|released| (met - released).max(0.0)),
        checked: string.and_then(|string| Some(string - seen.last.head?)),
        strikes: driven.strikes().len(),
        thrown: seen.thrown,
    })
}

/// What has been seen of a stroke.
struct Seen {
    last: ActionSample,
    dip: f64,
    /// When the key met its bed (s).
    bottom: Option<f64>,
    /// When the action's force on the hammer ended the last time before the string (s).
    released: Option<f64>,
    /// Greatest speed of the hammer before the string (m/s).
    thrown: Option<f64>,
}

impl Seen {
    fn new(sample: ActionSample, dip: f64) -> Self {
        let released = sample.push.map(|_push| sample.t);
        Self { last: sample, dip, bottom: None, released, thrown: None }
    }

    fn add(&mut self, now: ActionSample, strike: Option<StringContact>) {
        let before = self.last;
        self.last = now;
        if self.bottom.is_none() && now.travel >= self.dip {
            let (left, way) = (self.dip - before.travel, now.travel - before.travel);
            let part = (left / way).clamp(0.0, 1.0);
            self.bottom = Some(before.t + part * (now.t - before.t));
        }
        let is_before = strike.is_none_or(|strike| strike.t >= now.t);
        if let (Some(from), Some(to), true) = (before.head, now.head, is_before) {
            let (rise, time) = (to - from, now.t - before.t);
            let speed = rise / time;
            self.thrown = Some(self.thrown.map_or(speed, |thrown| thrown.max(speed)));
        }
        if let (Some(push), true) = (now.push, is_before)
            && push > 0.0
        {
            self.released = Some(now.t);
        } else if let (Some(pushed), Some(strike)) = (before.push, strike)
            && pushed > 0.0
            && before.t < strike.t
        {
            // Pushed at the last look before the string.
            self.released = Some(strike.t.min(now.t));
        }
    }
}

/// Plays strokes from slow to fast, `count` of them between two durations (s).
pub fn durations((slow, fast): (f64, f64), count: u32) -> impl Iterator<Item = f64> {
    let last = f64::from(count.max(2) - 1);
    (0..count).map(move |i| slow * (fast / slow).powf(f64::from(i) / last))
}

/// The slowest pressed stroke that reaches the string, by halving; none if none does.
pub(super) fn softest(subject: &PianoSubject<'_>, key: u8) -> Option<Stroke> {
    /// A key that takes 0.1 s sounds, one that takes 3 s does not.
    const BRACKET: (f64, f64) = (0.1, 3.0);
    const HALVINGS: u32 = 12;
    let (mut sounds, mut silent) = BRACKET;
    let mut softest = play(subject, key, (StrokeTouch::Pressed, sounds)).ok()?;
    for _ in 0..HALVINGS {
        let middle = (sounds * silent).sqrt();
        match play(subject, key, (StrokeTouch::Pressed, middle)) {
            Ok(stroke) => (sounds, softest) = (middle, stroke),
            Err(_) => silent = middle,
        }
    }
    Some(softest)
}
