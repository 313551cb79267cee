//! A ball dropped from 1 m, v⁺ = −e v⁻: a Zeno sequence in closed form.
//!
//! t1 = √(2/g), t_n = t1 (1 + 2e(1 − eⁿ⁻¹)/(1 − e)), accumulating at t1 (1 + e)/(1 − e).

use instruments::{ModeCode, NamedModes as _, SmallModel};
use pode::Motion;

use super::{BadFile, ExpectedEvent, ForceKind, MS, ModeOf, Plan, Reference, Scenario};

const G: f64 = 9.81;
const HEIGHT: f64 = 1.0;
const MASS: f64 = 1.0;

/// A drop with restitution `e` until `until` (s).
#[derive(Clone, Copy, Debug)]
struct BallDrop {
    e: f64,
    until: f64,
}

#[derive(Debug)]
pub(super) struct BallScenario {
    drop: BallDrop,
    model: SmallModel,
    flight: ModeOf<Self>,
    reference: Reference<SmallModel>,
}

/// Returns ten impacts, on which other codes are measured.
pub(super) fn ten_impacts() -> Result<BallScenario, BadFile> {
    BallDrop { e: 0.8, until: 3.6 }.answered(10, None)
}

/// Returns a ball that rests from 4.06 s on; its first ten impacts and its rest are judged.
pub(super) fn rest_08() -> Result<BallScenario, BadFile> {
    let drop = BallDrop { e: 0.8, until: 5.0 };
    drop.answered(10, Some(drop.rests()))
}

/// Returns a ball that rests from 1.35 s on, with more than six impacts in a tick of 5 ms.
pub(super) fn rest_05() -> Result<BallScenario, BadFile> {
    let drop = BallDrop { e: 0.5, until: 2.0 };
    drop.answered(8, Some(drop.rests()))
}

impl BallDrop {
    /// Returns the time of impact `n`, from 1 (s).
    fn impact(self, n: i32) -> f64 {
        let e = self.e;
        (2.0 * HEIGHT / G).sqrt() * (1.0 + 2.0 * e * (1.0 - e.powi(n - 1)) / (1.0 - e))
    }

    /// Returns the end of all impacts (s).
    fn rests(self) -> f64 {
        (2.0 * HEIGHT / G).sqrt() * (1.0 + self.e) / (1.0 - self.e)
    }

    /// Returns height and speed at `t` (s), and the floor's impulse until then (N·s).
    fn state(self, t: f64) -> ([f64; 2], f64) {
        let n = (1..MOST).take_while(|n| self.impact(*n) <= t).count();
        let n = i32::try_from(n).unwrap_or(MOST);
        let state = if t >= self.rests() {
            [0.0, 0.0]
        } else if n == 0 {
            [HEIGHT - 0.5 * G * t * t, -G * t]
        } else {
            let since = t - self.impact(n);
            let speed = (2.0 * G * HEIGHT).sqrt() * self.e.powi(n);
            [since * (speed - 0.5 * G * since), speed - G * since]
        };
        // The impulse is the momentum that weight does not explain.
        (state, MASS * (state[1] + G * t))
    }

    /// Returns the scenario, judged on its first `judged` impacts and on the time `rests` (s).
    /// Without `rests` no other impacts are allowed.
    #[expect(clippy::large_stack_frames, reason = "once for a scenario")]
    fn answered(self, judged: i32, rests: Option<f64>) -> Result<BallScenario, BadFile> {
        const NAME: &str = "bouncing-ball";
        let missing = |what| BadFile::missing(NAME, what);
        let model = super::small(NAME).ok_or_else(|| missing("the model"))?;
        let model = model.with_values(&[G, self.e, MASS, HEIGHT, 1.0]);
        let mode = |code| model.mode(ModeCode::structural(code));
        let (flight, lies) = mode(0).zip(mode(1)).ok_or_else(|| missing("a mode"))?;
        let event = |t| ExpectedEvent { t, guard: "floor".to_owned(), to: flight };
        let events = (1..=judged).map(|n| event(self.impact(n))).collect();
        let mut times: Vec<f64> = (1..MOST).map(|n| self.impact(n)).collect();
        times.push(self.rests());
        let span = (10.0 * MS, self.until);
        let samples = Reference::<SmallModel>::samples(span, 5.0 * MS, &times, |t| {
            let ([y, v], impulse) = self.state(t);
            Some(([y, v, 0.0, 0.0], impulse))
        });
        let rest = rests.map(|t| (t, lies));
        let names = model.modes().collect();
        let reference = Reference { events, is_whole: rest.is_none(), rest, names, samples };
        Ok(BallScenario { drop: self, model, flight, reference })
    }
}

/// Distinct impacts: e⁹⁹ is 2e-10.
const MOST: i32 = 100;

impl Scenario for BallScenario {
    type Model = SmallModel;

    fn plan(&self) -> Plan {
        let (ticks, offline_tick) = (super::TICKS, 100.0 * MS);
        Plan {
            until: self.drop.until,
            ticks,
            offline_tick,
            felt: ForceKind::Impulse,
            ..Plan::EXACT
        }
    }

    fn start(&self) -> (SmallModel, ModeOf<Self>, [f64; 4]) {
        (self.model.clone(), self.flight, [HEIGHT, 0.0, 0.0, 0.0])
    }

    fn input(&self, _t: f64) -> Motion {
        Motion::default()
    }

    fn reference(&self) -> &Reference<SmallModel> {
        &self.reference
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn impacts_are_at_the_times_of_40_digit_arithmetic() {
        let lively = BallDrop { e: 0.8, until: 5.0 };
        let known = [(1, 0.451_523_640_985_730_9), (2, 1.173_961_466_562_900_4)];
        for (n, t) in known.into_iter().chain([(10, 3.578_892_951_020_438)]) {
            assert!((lively.impact(n) - t).abs() < 1e-15, "impact {n}");
        }
        assert!((lively.rests() - 4.063_712_768_871_578).abs() < 1e-15);
        let dull = BallDrop { e: 0.5, until: 2.0 };
        assert!((dull.rests() - 1.354_570_922_957_192_7).abs() < 1e-15);
    }

    #[test]
    fn a_ball_at_rest_has_passed_on_its_whole_momentum() {
        let (state, impulse) = BallDrop { e: 0.5, until: 2.0 }.state(1.5);
        assert!(state.iter().all(|entry| entry.abs() < 1e-300), "{state:?}");
        assert!((impulse - MASS * G * 1.5).abs() < 1e-15);
    }
}
