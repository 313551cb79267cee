//! A pendulum against a wall at its lowest point: impacts that never accumulate.
//!
//! x'' = −ω0² sin x, v⁺ = −e v⁻ at x = 0. Between impacts x = 2 asin(k sn(ω0 τ, k)) with
//! k = v/(2 ω0), so each swing lasts 2 K(k)/ω0.

use pode::EquationKind;
use pode::{Enclosure, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Model, Nature};
use pode::{Energetic, Reset, Resets};

use super::elliptic::{quarter_period, sn_cn};
use super::{ExpectedEvent, ForceKind, MS, Plan, Reference, Scenario};

/// ω0² (1/s²).
const STIFFNESS: f64 = 9.81;
const RESTITUTION: f64 = 0.9;
/// Initial angle, at rest (rad).
const START: f64 = 1.2;
/// End (s); the tenth impact is at 9.899 s.
const UNTIL: f64 = 10.0;

/// Angle (rad) and its rate (rad/s). The readout is the wall's, per unit of inertia.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Pendulum;

impl Model for Pendulum {
    type Mode = ();
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, (): (), x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], -STIFFNESS * x[0].sin()]
    }

    fn readout(&self, (): (), _x: &[f64; 2], (): &()) -> f64 {
        0.0
    }

    /// Steps are a tenth of a radian of the smallest swing.
    fn nature(&self, (): ()) -> Nature {
        Nature::new(EquationKind::Conservative, STIFFNESS.sqrt())
            .with_longest_step(0.1 / STIFFNESS.sqrt())
    }
}

impl Guarded for Pendulum {
    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        const WALL: [GuardSpec; 1] = [GuardSpec::new(0, "wall")];
        &WALL
    }

    fn guard_bound(&self, (): (), _guard: GuardId, over: &Enclosure<[f64; 2], ()>) -> GuardBound {
        over.entry(0)
    }

    fn guard(&self, (): (), _guard: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(x[0], x[1])
    }
}

impl Resets for Pendulum {
    fn reset(&self, (): (), _guard: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        let impulse = (1.0 + RESTITUTION) * x[1].abs();
        Reset::to((), [0.0, -RESTITUTION * x[1]]).with_impulse(impulse)
    }
}

impl Energetic for Pendulum {
    fn energy(&self, (): (), x: &[f64; 2], (): &()) -> f64 {
        0.5 * x[1] * x[1] + STIFFNESS * (1.0 - x[0].cos())
    }

    fn supplied(&self, (): (), _x: &[f64; 2], (): &()) -> f64 {
        0.0
    }
}

#[derive(Debug)]
pub(super) struct PendulumScenario {
    reference: Reference<Pendulum>,
}

pub(super) fn build() -> PendulumScenario {
    let impacts = impacts();
    let event = |(t, _): &(f64, f64)| ExpectedEvent { t: *t, guard: "wall".to_owned(), to: () };
    let times: Vec<f64> = impacts.iter().map(|(t, _)| *t).collect();
    let samples = Reference::<Pendulum>::samples((10.0 * MS, UNTIL), 5.0 * MS, &times, |t| {
        Some(state(&impacts, t))
    });
    let events = impacts.iter().map(event).collect();
    let reference = Reference { events, is_whole: true, rest: None, names: Vec::new(), samples };
    PendulumScenario { reference }
}

/// Returns the times (s) of the impacts until the end, and the speeds after them (rad/s).
fn impacts() -> Vec<(f64, f64)> {
    let omega = STIFFNESS.sqrt();
    let k = (0.5 * START).sin();
    let first = (quarter_period(k) / omega, RESTITUTION * 2.0 * k * omega);
    let next = |(t, speed): &(f64, f64)| {
        let swing = 2.0 * quarter_period(0.5 * speed / omega) / omega;
        Some((t + swing, RESTITUTION * speed))
    };
    std::iter::successors(Some(first), next).take_while(|(t, _)| *t < UNTIL).collect()
}

/// Returns angle and rate at `t` (s), and the wall's impulses until then.
fn state(impacts: &[(f64, f64)], t: f64) -> ([f64; 2], f64) {
    let omega = STIFFNESS.sqrt();
    let swing = impacts.iter().rfind(|(at, _)| *at <= t);
    let swing = swing.map(|(at, speed)| (0.5 * speed / omega, omega * (t - at)));
    let (k, u) = swing.unwrap_or_else(|| {
        let k = (0.5 * START).sin();
        (k, quarter_period(k) + omega * t)
    });
    let (sn, cn) = sn_cn(u, k);
    let before = impacts.iter().filter(|(at, _)| *at <= t);
    let impulse = before.map(|(_, speed)| speed * (1.0 + RESTITUTION) / RESTITUTION).sum();
    ([2.0 * (k * sn).asin(), 2.0 * k * omega * cn], impulse)
}

impl Scenario for PendulumScenario {
    type Model = Pendulum;

    fn plan(&self) -> Plan {
        let (ticks, offline_tick) = (super::TICKS, 100.0 * MS);
        Plan { until: UNTIL, ticks, offline_tick, felt: ForceKind::Impulse, ..Plan::EXACT }
    }

    fn start(&self) -> (Pendulum, (), [f64; 2]) {
        (Pendulum, (), [START, 0.0])
    }

    fn input(&self, _t: f64) {}

    fn reference(&self) -> &Reference<Pendulum> {
        &self.reference
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn impacts_are_at_the_times_of_40_digit_arithmetic() {
        let impacts = impacts();
        let known = [
            (1, 0.550_770_646_903_126),
            (2, 1.630_077_719_645_963_8),
            (5, 4.783_311_598_904_508),
            (10, 9.898_785_767_259_402),
        ];
        for (n, t) in known {
            assert!((impacts[n - 1].0 - t).abs() < 4e-15, "impact {n}: {:?}", impacts[n - 1]);
        }
        assert_eq!(impacts.len(), 10);
        let speed = impacts[0].1 / RESTITUTION;
        assert!((speed - 3.537_024_294_116_124).abs() < 2e-15, "{speed}");
    }

    #[test]
    fn the_states_move_as_the_equations_say() {
        let impacts = impacts();
        for t in [0.2, 0.9, 1.4, 5.1] {
            // A central difference errs by h²/6 of the third derivative, some 40 rad/s³.
            let h = 1e-5;
            let (before, now, after) =
                (state(&impacts, t - h).0, state(&impacts, t).0, state(&impacts, t + h).0);
            let slope = [0, 1].map(|i| (after[i] - before[i]) / (2.0 * h));
            let right = Pendulum.derivative((), &now, &());
            for i in 0..2 {
                assert!((slope[i] - right[i]).abs() < 1e-8, "{i} at {t}: {slope:?}, {right:?}");
            }
        }
    }
}
