//! A hammer head that falls on a lossless spring: contacts as short as 0.1 ms.
//!
//! In contact x'' = −ω² x − g: it lasts 2(π − atan(v ω/g))/ω, is deepest in its middle, and the
//! head leaves with its entry speed.

use pode::{
    Enclosure, Energetic, EquationKind, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Model,
    Nature, Reset, Resets,
};

use super::{ExpectedEvent, ForceKind, MS, Plan, Reference, Scenario};

const G: f64 = 9.81;
/// Mass of the head (kg).
const MASS: f64 = 0.01;
/// Speed on touching the spring (m/s).
const SPEED: f64 = 1.0;
/// End (s), about five contacts.
const UNTIL: f64 = 1.0;
/// Upper bound of the bounces until the end.
const MOST_BOUNCES: u32 = 10;
/// Longest step in radians of the contact's oscillation.
const RADIANS: f64 = 0.05;

/// A head that falls on F = −k min(x, 0): height (m) and speed (m/s).
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct FallingHead {
    /// Stiffness (N/m).
    k: f64,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Mode {
    Flight,
    Contact,
}

const TOUCH: [GuardSpec; 1] = [GuardSpec::new(0, "touch").scaled(0.1)];
const CONTACT: [GuardSpec; 2] = [
    // Penetrations are smaller than heights.
    GuardSpec::new(1, "leave").scaled(1e-3),
    GuardSpec::new(2, "deepest").on_crossing(),
];

impl FallingHead {
    /// Returns the contact's frequency (rad/s).
    fn omega(self) -> f64 {
        (self.k / MASS).sqrt()
    }

    /// Returns the duration of a contact (s).
    fn contact(self) -> f64 {
        2.0 * (std::f64::consts::PI - (SPEED * self.omega() / G).atan()) / self.omega()
    }

    /// Returns the time between touches (s).
    fn period(self) -> f64 {
        self.contact() + 2.0 * SPEED / G
    }

    fn events(self) -> Vec<ExpectedEvent<Self>> {
        let bounce = |n: u32| {
            let at = |t: f64, guard: &str, to| ExpectedEvent {
                t: f64::from(n) * self.period() + t,
                guard: guard.to_owned(),
                to,
            };
            [
                at(0.0, "touch", Mode::Contact),
                at(0.5 * self.contact(), "deepest", Mode::Contact),
                at(self.contact(), "leave", Mode::Flight),
            ]
        };
        (0..MOST_BOUNCES).flat_map(bounce).take_while(|event| event.t < UNTIL).collect()
    }

    /// Returns height and speed at `t` (s), and the spring's impulse until then (N·s).
    fn state(self, t: f64) -> ([f64; 2], f64) {
        let since = t % self.period();
        let state = if since < self.contact() {
            let (w, drop) = (self.omega(), G / (self.omega() * self.omega()));
            let (sin, cos) = (w * since).sin_cos();
            [-drop * (1.0 - cos) - SPEED / w * sin, -drop * w * sin - SPEED * cos]
        } else {
            let flown = since - self.contact();
            [flown * (SPEED - 0.5 * G * flown), SPEED - G * flown]
        };
        (state, MASS * (state[1] + SPEED + G * t))
    }
}

impl Model for FallingHead {
    type Mode = Mode;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, mode: Mode, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], self.readout(mode, x, &()) / MASS - G]
    }

    /// Returns the force of the contact (N).
    fn readout(&self, mode: Mode, x: &[f64; 2], (): &()) -> f64 {
        match mode {
            Mode::Flight => 0.0,
            Mode::Contact => -self.k * x[0],
        }
    }

    fn nature(&self, mode: Mode) -> Nature {
        let (rate, longest) = match mode {
            Mode::Flight => (0.0, f64::INFINITY),
            Mode::Contact => (self.omega(), RADIANS / self.omega()),
        };
        Nature::new(EquationKind::Affine, rate).with_longest_step(longest)
    }
}

impl Guarded for FallingHead {
    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        match mode {
            Mode::Flight => &TOUCH,
            Mode::Contact => &CONTACT,
        }
    }

    fn guard_bound(
        &self,
        _mode: Mode,
        guard: GuardId,
        over: &Enclosure<[f64; 2], ()>,
    ) -> GuardBound {
        over.entry(usize::from(guard.0 > 1))
    }

    fn guard(&self, mode: Mode, guard: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        match guard.0 {
            0 => GuardValue::new(x[0], x[1]),
            1 => GuardValue::new(-x[0], -x[1]),
            _ => GuardValue::new(-x[1], -self.derivative(mode, x, &())[1]),
        }
    }
}

impl Resets for FallingHead {
    fn reset(&self, _mode: Mode, guard: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        match guard.0 {
            0 => Reset::to(Mode::Contact, [0.0, x[1]]),
            1 => Reset::to(Mode::Flight, [0.0, x[1]]),
            _ => Reset::to(Mode::Contact, *x),
        }
    }
}

impl Energetic for FallingHead {
    fn energy(&self, mode: Mode, x: &[f64; 2], (): &()) -> f64 {
        let spring = if mode == Mode::Contact { self.k * x[0] * x[0] } else { 0.0 };
        0.5 * (MASS * x[1] * x[1] + spring) + MASS * G * x[0]
    }

    fn supplied(&self, _mode: Mode, _x: &[f64; 2], (): &()) -> f64 {
        0.0
    }
}

#[derive(Debug)]
pub(super) struct HeadScenario {
    head: FallingHead,
    reference: Reference<FallingHead>,
}

/// Builds the scenario with a stiffness of 10 to the `EXPONENT` (N/m).
pub(super) fn build<const EXPONENT: i32>() -> HeadScenario {
    let head = FallingHead { k: 10_f64.powi(EXPONENT) };
    let events = head.events();
    let times: Vec<f64> = events.iter().map(|event| event.t).collect();
    let span = (5.0 * MS, UNTIL);
    let samples = Reference::<FallingHead>::samples(span, MS, &times, |t| Some(head.state(t)));
    let reference = Reference { events, is_whole: true, rest: None, names: Vec::new(), samples };
    HeadScenario { head, reference }
}

impl Scenario for HeadScenario {
    type Model = FallingHead;

    fn plan(&self) -> Plan {
        let (ticks, offline_tick) = (TICKS, 50.0 * MS);
        Plan { until: UNTIL, ticks, offline_tick, felt: ForceKind::Impulse, ..Plan::EXACT }
    }

    fn start(&self) -> (FallingHead, Mode, [f64; 2]) {
        (self.head, Mode::Flight, [0.0, -SPEED])
    }

    fn input(&self, _t: f64) {}

    fn reference(&self) -> &Reference<FallingHead> {
        &self.reference
    }
}

/// Steps down to 5 µs (s), as a contact of 0.1 ms requires.
const TICKS: &[f64] =
    &[5.0 * MS, 2.5 * MS, MS, 0.5 * MS, 0.2 * MS, 0.1 * MS, 0.05 * MS, 0.02 * MS, 0.005 * MS];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contacts_are_those_of_40_digit_arithmetic() {
        const KNOWN: [[f64; 4]; 3] = [
            [1e3, 0.010_130_725_363_703_42, 0.003_261_898_920_601_624, 0.214_004_323_732_714_6],
            [1e5, 0.000_995_420_820_285_805_5, 0.000_317_210_287_639_522_7, 0.204_869_019_189_297],
            [1e7, 9.936_550_265_733_163e-5, 3.163_258_812_331_01e-5, 0.203_972_963_871_668_5],
        ];
        for [k, contact, depth, period] in KNOWN {
            let head = FallingHead { k };
            assert!((head.contact() - contact).abs() < 4e-18 + 4e-16 * contact, "k {k}");
            assert!((head.period() - period).abs() < 1e-16, "k {k}: {}", head.period());
            let ([x, v], _) = head.state(0.5 * head.contact());
            assert!((x + depth).abs() < 1e-17 && v.abs() < 1e-13, "k {k}: {x}, {v}");
        }
    }

    #[test]
    fn a_contact_passes_on_twice_the_momentum_and_its_weight() {
        let head = FallingHead { k: 1e5 };
        let (_, impulse) = head.state(0.01);
        let expected = MASS * (2.0 * SPEED + G * head.contact());
        assert!((impulse - expected).abs() < 1e-16, "{impulse}");
    }
}
