//! One stroke: the hammer on the string, the key on its bed, and the time after.

use super::drive::{Drive, StrokeTouch};
use super::key::{ActionSample, StringContact};
use super::{grands::StrokeTime, subject::PianoSubject};

/// Tick while the hammer is on its way (s).
const FINE: f64 = 5e-5;
/// Tick while the key is held (s).
const COARSE: f64 = 5e-4;
/// Hold after a stroke (s), in which the hammer comes to rest.
const HOLD: f64 = 0.2;
/// Time of fine ticks after the expected contact with the string (s).
const FINELY_AFTER: f64 = 0.03;

/// A stroke that reached the string.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stroke {
    pub touch: StrokeTouch,
    /// Requested duration of most of the key's way (s).
    pub duration: f64,
    /// Speed of the hammer at the string (m/s).
    pub speed: f64,
    /// Time from the key's start to the string (s).
    pub travel: f64,
    /// Time from the string to the key's bottom (s), if the key reached it.
    pub key_bottom: Option<f64>,
    /// Time from the hammer's release to the string (s), if the model has the action's force.
    pub free_flight: Option<f64>,
    /// Height of the hammer below the string with the key held (m), if the model has it.
    pub checked: Option<f64>,
    pub strikes: usize,
    /// Greatest speed of the hammer on its way (m/s), if the model has its height.
    pub thrown: Option<f64>,
}

impl Stroke {
    /// Returns a time (s), if it was measured.
    pub fn timed(&self, what: StrokeTime) -> Option<f64> {
        match what {
            StrokeTime::Travel => Some(self.travel),
            StrokeTime::KeyBottom => self.key_bottom,
            StrokeTime::FreeFlight => self.free_flight,
        }
    }

    /// Returns free flight times speed (m): the distance at which the hammer leaves the action.
    pub fn gap(&self) -> Option<f64> {
        self.free_flight.map(|time| time * self.speed)
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Miss {
    Silent,
    Failed,
}

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

struct Seen {
    last: ActionSample,
    dip: f64,
    /// Time at which the key met its bed (s).
    bottom: Option<f64>,
    /// Last end of the action's force on the hammer before the string (s).
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
            // Pushed at the last sample before the string.
            self.released = Some(strike.t.min(now.t));
        }
    }
}

/// Returns `count` durations from slow to fast, between two (s).
pub fn durations((slow, fast): (f64, f64), count: u32) -> impl Iterator<Item = f64> {
    let last = f64::from(count.max(2) - 1);
    (0..count).map(move |i| slow * (fast / slow).powf(f64::from(i) / last))
}

/// Finds by bisection the slowest pressed stroke that reaches the string, if any does.
pub(super) fn softest(subject: &PianoSubject<'_>, key: u8) -> Option<Stroke> {
    /// Durations (s): a key that takes 0.1 s sounds, one that takes 3 s does not.
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
