//! Path from samples to a model's input: estimate, then continue over the tick.

use haptics::{AnyEstimator, Estimator as _, KeyMotion};
use pode::input::{Cubic, Reconstruction, Reconstructor};
use scheduler::motion::KeySample;
use scheduler::safety::MAX_EXTRAPOLATED;

/// Continuation of the motion over the tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Continuation {
    Estimate,
    Samples(Reconstruction, Reconstructor),
}

/// Path of samples to the input of one voice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputPath {
    estimator: AnyEstimator,
    continuation: Continuation,
    /// Model input per metre.
    scale: f64,
    /// Tick period (s).
    h: f64,
    /// Time from the computation of a force to its effect (s).
    lead: f64,
    last: KeyMotion,
    tick: Option<u64>,
    /// Age of that sample at that tick (ticks).
    since: f64,
}

/// The input over one tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Followed {
    pub signal: Cubic,
    /// Position of the key at the start of the tick (m).
    pub position: f64,
    /// Excess of its newest sample's age over the usual (s).
    pub late: f64,
    /// Displacement of the input back to its position before a long pause with unknown motion.
    pub back: Option<f64>,
}

/// Time difference below which samples are the same (ticks).
const NEWS: f64 = 1e-3;

/// Longest continuation of motion, forward from a sample, or back from an early one (ticks).
const MOST_AHEAD: f64 = 1.0;

/// Ticks of motion that are shown to an estimator that replaces another.
const SHOWN: u32 = 16;

/// Time without a sample after which a key's motion is unknown (s): the length of a stroke.
const FORGOTTEN: f64 = 10e-3;

impl InputPath {
    /// Returns a path with ticks of `h` (s) for a model whose input is `scale` per metre.
    pub fn new(
        estimator: AnyEstimator,
        reconstruction: Option<Reconstruction>,
        scale: f64,
        h: f64,
    ) -> Self {
        let continuation = reconstruction.map_or(Continuation::Estimate, |kind| {
            Continuation::Samples(kind, Reconstructor::new(kind, 0.0, h))
        });
        let last = KeyMotion::at_rest(0.0);
        Self { estimator, continuation, scale, h, lead: 0.0, last, tick: None, since: 0.0 }
    }

    /// Continues estimated motion by `lead` (s), for forces that act that much after the tick.
    #[must_use]
    pub const fn with_lead(self, lead: f64) -> Self {
        Self { lead, ..self }
    }

    /// Continues from the samples of `before`. An estimator with equal settings keeps its state.
    ///
    /// # Real-time
    /// At most 16 updates of an estimator.
    pub fn succeed(&mut self, before: &Self) {
        let Self { last, tick, since, .. } = *before;
        (self.last, self.tick, self.since) = (last, tick, since);
        if is_set_as(self.estimator, before.estimator) {
            self.estimator = before.estimator;
        } else {
            self.show(&last);
        }
        let is_same_scale = self.scale.to_bits() == before.scale.to_bits();
        if let Continuation::Samples(kind, reconstructor) = &mut self.continuation {
            *reconstructor = match before.continuation {
                Continuation::Samples(same, known) if is_same_scale && same == *kind => known,
                Continuation::Samples(..) | Continuation::Estimate => {
                    Reconstructor::new(*kind, last.position * self.scale, self.h)
                }
            };
        }
    }

    /// Shows the estimator a key that has come to `motion`.
    fn show(&mut self, motion: &KeyMotion) {
        let at = |ticks: u32| motion.after(-f64::from(ticks) * self.h).position;
        self.estimator.reset(at(SHOWN));
        for ticks in (0..SHOWN).rev() {
            let position = at(ticks);
            self.estimator.update(position, self.h);
        }
    }

    pub fn newest(&self) -> pode::Motion {
        pode::Motion {
            position: self.last.position * self.scale,
            rate: self.last.velocity * self.scale,
            acceleration: self.last.acceleration * self.scale,
            jerk: 0.0,
        }
    }

    /// Puts the key at rest at `position` (m) from the next tick on; returns the input there.
    pub fn reset(&mut self, position: f64) -> pode::Motion {
        self.estimator.reset(position);
        if let Continuation::Samples(kind, reconstructor) = &mut self.continuation {
            *reconstructor = Reconstructor::new(*kind, position * self.scale, self.h);
        }
        self.last = KeyMotion::at_rest(position);
        self.tick = None;
        pode::Motion { position: position * self.scale, ..pode::Motion::default() }
    }

    /// Advances to `tick`; returns the interval of a new `sample` from the one before (ticks).
    pub fn go_on(&mut self, tick: u64, sample: &KeySample) -> Option<f64> {
        let Some(before) = self.tick.replace(tick) else {
            self.since = sample.taken;
            return Some(1.0);
        };
        let passed = tick.saturating_sub(before) as f64;
        let elapsed = self.since + passed - sample.taken;
        let is_news = NEWS < elapsed;
        self.since = if is_news { sample.taken } else { self.since + passed };
        is_news.then_some(elapsed)
    }

    /// Returns the time from the newest sample to the tick, as far as motion is continued (s).
    const fn ahead(&self) -> f64 {
        self.since.clamp(-MOST_AHEAD, MOST_AHEAD) * self.h
    }

    /// Adds a sample `elapsed` (s) after the last; returns the displacement in a long pause.
    fn learn(
        &mut self,
        &KeySample { position, velocity, .. }: &KeySample,
        elapsed: f64,
    ) -> Option<f64> {
        if FORGOTTEN.max(1.5 * self.h) < elapsed {
            let back = (self.last.position - position) * self.scale;
            self.estimator.reset(position);
            self.last =
                KeyMotion { velocity: velocity.unwrap_or(0.0), ..KeyMotion::at_rest(position) };
            return Some(back);
        }
        self.last = if let Some(velocity) = velocity {
            self.estimator.update_with_speed(position, velocity, elapsed)
        } else {
            self.estimator.update(position, elapsed)
        };
        None
    }

    /// Returns the input over `tick`, at whose start `sample` is the newest.
    pub fn follow(&mut self, tick: u64, sample: &KeySample) -> Followed {
        let elapsed = self.go_on(tick, sample);
        let back = elapsed.and_then(|elapsed| self.learn(sample, elapsed * self.h));
        let (motion, position) = if self.since == 0.0 {
            (self.last, sample.position)
        } else {
            let motion = self.last.after(self.ahead());
            // The limit of the continuation is that of `scheduler::safety`.
            let is_over = MAX_EXTRAPOLATED < sample.age;
            let motion = if is_over { KeyMotion::at_rest(motion.position) } else { motion };
            (motion, motion.position)
        };
        let signal = match &mut self.continuation {
            Continuation::Estimate => {
                let KeyMotion { position, velocity, acceleration } = motion.after(self.lead);
                let scale = self.scale;
                Cubic::ballistic(position * scale, velocity * scale, acceleration * scale, self.h)
            }
            Continuation::Samples(_, reconstructor) => reconstructor.push(position * self.scale),
        };
        Followed { signal, position, late: self.ahead(), back }
    }
}

fn is_set_as(mut one: AnyEstimator, mut other: AnyEstimator) -> bool {
    one.reset(0.0);
    other.reset(0.0);
    one == other
}

#[cfg(test)]
mod tests {
    use haptics::{EstimatorName, EstimatorSettings, Kalman};
    use pode::Signal as _;

    use super::*;

    const H: f64 = 1e-3;

    fn path() -> InputPath {
        let kalman = Kalman::new(H, 1e-6, Kalman::KEY_JERK_DENSITY);
        let mut path = InputPath::new(AnyEstimator::Kalman(kalman), None, 1.0, H);
        path.reset(0.0);
        path
    }

    /// Follows a key at `speed` (m/s) for `ticks`, each sample `late` (ticks).
    fn moved(path: &mut InputPath, speed: f64, ticks: u64, late: f64) {
        for tick in 0..ticks {
            let position = speed * (tick as f64 - late) * H;
            path.follow(tick, &KeySample { taken: late, ..KeySample::fresh(position) });
        }
    }

    #[test]
    fn a_key_goes_on_for_one_tick_without_a_sample_however_late_the_last_was() {
        for late in [-0.4, 0.0, 0.4] {
            let mut path = path();
            moved(&mut path, 0.5, 100, late);
            let position = 0.5 * (99.0 - late) * H;
            let lost = |age: u32| KeySample {
                position,
                age,
                taken: late + f64::from(age),
                velocity: None,
            };
            let first = path.follow(100, &lost(1)).signal.at(0.0);
            assert!((first.rate - 0.5).abs() < 1e-6, "{late}: {first:?}");
            assert!((first.position - position - 0.5 * H).abs() < 0.3 * H, "{late}: {first:?}");
            let second = path.follow(101, &lost(2)).signal.at(0.0);
            assert!(second.rate == 0.0, "{late}: {second:?}");
            assert!((second.position - position - 0.5 * H).abs() < 1e-9, "{late}: {second:?}");
        }
    }

    #[test]
    fn a_key_that_stopped_while_nobody_looked_has_no_speed_afterwards() {
        for ticks in [12, 50, 1000] {
            let mut path = path();
            moved(&mut path, 0.5, 100, 0.0);
            let moved_on = KeySample::fresh(9.9e-3);
            let after = path.follow(99 + ticks, &moved_on).signal.at(0.0);
            assert!(after.rate == 0.0, "{after:?}");
            assert!((after.position - moved_on.position).abs() == 0.0, "{after:?}");
        }
    }

    #[test]
    fn a_sample_that_is_dated_far_in_the_future_is_taken_back_by_a_tick_at_most() {
        let mut path = path();
        moved(&mut path, 0.5, 100, 0.0);
        let position = 0.5 * 100.0 * H;
        let seen = path.follow(100, &KeySample { taken: -20.0, ..KeySample::fresh(position) });
        let back = position - seen.position;
        assert!((0.0..=1.1 * 0.5 * H).contains(&back), "{back} m");
    }

    #[test]
    fn another_estimator_goes_on_with_the_speed_that_was_known() {
        let settings = EstimatorSettings {
            period: H,
            quantum: 1e-6,
            jerk_density: 1e5,
            cutoff: EstimatorSettings::KEY_CUTOFF,
            jerk_limit: EstimatorSettings::KEY_JERK_LIMIT,
        };
        for name in EstimatorName::ALL {
            let mut before = path();
            moved(&mut before, 0.5, 100, 0.0);
            let mut next = InputPath::new(AnyEstimator::new(name, &settings), None, 2.0, H);
            next.succeed(&before);
            let seen = next.follow(100, &KeySample::fresh(0.5 * 100.0 * H)).signal.at(0.0);
            // A low pass of 100 Hz knows a speed to 1 in 20000 after 16 ms.
            assert!((seen.rate - 1.0).abs() < 0.01, "{name:?}: {seen:?}");
            assert!((seen.position - 0.1).abs() < 1e-4, "{name:?}: {seen:?}");
            let mut same = path();
            same.succeed(&before);
            assert_eq!(same, before, "what is set alike goes on to the last bit");
        }
    }

    #[test]
    fn samples_that_come_late_by_turns_show_the_speed_that_they_were_taken_at() {
        let mut path = path();
        for tick in 0..200_u32 {
            let late = [0.0, 0.7, 0.2, 1.4, 0.9][tick as usize % 5];
            let position = 0.5 * (f64::from(tick) - late) * H;
            let sample = KeySample { taken: late, ..KeySample::fresh(position) };
            let seen = path.follow(tick.into(), &sample).signal.at(0.0);
            if 20 < tick {
                assert!((seen.rate - 0.5).abs() < 1e-3, "tick {tick}: {seen:?}");
            }
        }
    }
}
