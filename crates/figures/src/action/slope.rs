//! Force against travel at a constant speed, down and back.

use super::{drive::Drive, subject::PianoSubject};

/// Travel between two points of a curve (m), about.
const STEP: f64 = 5e-6;
/// Shortest and longest tick (s).
const TICKS: (f64, f64) = (2e-5, 1e-3);
/// Travel of a pressed key beyond its dip (m).
const BEYOND: f64 = 0.5e-3;

/// Force (N) over travel (m), down positive, with the finger's work.
#[derive(Clone, PartialEq, Debug)]
pub struct ForceCurve {
    /// Speed of the key (m/s).
    pub speed: f64,
    pub down: Vec<(f64, f64)>,
    pub up: Vec<(f64, f64)>,
    /// Greatest rise of the hammer on the way down (m), if the model has it.
    pub highest: Option<f64>,
    /// Work over the whole cycle, and energy that the integration generated (J).
    pub work: f64,
    pub residual: f64,
}

/// The let-off hump of the force.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Hump {
    /// Travel (m).
    pub at: f64,
    /// Force (N).
    pub force: f64,
    /// Height above the greatest force before it, from half travel on (N).
    pub rise: f64,
}

/// Presses `key` to its bed and lets it up at `speed` (m/s); `None` if the model fails.
pub(super) fn measure(subject: &PianoSubject<'_>, key: u8, speed: f64) -> Option<ForceCurve> {
    /// Rest at the end (s), in which the action settles.
    const AFTER: f64 = 0.3;
    let mut driven = subject.open(key);
    let turn = subject.dip(key) + BEYOND;
    let drive = Drive::Slope { speed, turn };
    let h = (STEP / speed).clamp(TICKS.0, TICKS.1);
    let top = turn / speed;
    let (mut down, mut up) = (Vec::new(), Vec::new());
    let mut highest = driven.sample().head;
    let mut t = 0.0;
    while t < 2.0 * top + AFTER {
        if !driven.advance(h, &|theta| drive.at(t + theta * h)) {
            return None;
        }
        t += h;
        let sample = driven.sample();
        if t <= top {
            down.push((sample.travel, sample.force));
            highest = highest.zip(sample.head).map(|(a, b)| a.max(b));
        } else if t <= 2.0 * top {
            up.push((sample.travel, sample.force));
        }
    }
    let audit = driven.audit();
    Some(ForceCurve { speed, down, up, highest, work: audit.supplied, residual: audit.integration })
}

impl ForceCurve {
    /// Returns the mean force (N) between two travels (m) on one way.
    pub fn mean(way: &[(f64, f64)], (from, to): (f64, f64)) -> Option<f64> {
        let within = || way.iter().filter(|(at, _)| (from..=to).contains(at));
        let count = within().count();
        (count > 0).then(|| within().map(|(_, force)| force).sum::<f64>() / count as f64)
    }

    /// Returns the highest force before the bed, if it is a maximum of the curve.
    pub fn hump(&self, dip: f64) -> Option<Hump> {
        let (from, to) = (0.7 * dip, dip - 0.1e-3);
        let within: Vec<_> = self.down.iter().filter(|(at, _)| (from..=to).contains(at)).collect();
        let highest = (0..within.len()).max_by(|a, b| within[*a].1.total_cmp(&within[*b].1))?;
        if highest == 0 || highest + 1 == within.len() {
            return None;
        }
        let (at, force) = *within[highest];
        let before = self.down.iter().filter(|it| (0.5 * dip..at - 0.08 * dip).contains(&it.0));
        let before = before.map(|it| it.1).fold(f64::NEG_INFINITY, f64::max);
        Some(Hump { at, force, rise: force - before })
    }
}
