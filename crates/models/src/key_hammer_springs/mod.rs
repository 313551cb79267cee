//! The paper's model B: key and hammer, springs in every contact. See README.md.

mod drawing;
mod equations;
mod series;

use pode::{GuardId, Motion, Nature, Part};

use crate::describe::{
    Damper, Described, Parameter, Playable, Preset, SOFTEST_TONE_OF_A_GRAND, Sounding, filled,
    write,
};
use crate::draw::Sketch;
use crate::key_hammer::{KeyHammerValues, PARAMETERS, PRESETS};

/// Key and hammer coupled by springs (B1) or apart (B2).
///
/// State: θh, θk (rad), θh', θk' (rad/s). Input: the manipulandum's angle s (rad).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeyHammerSprings {
    values: KeyHammerValues,
    /// Longest steps in B1 and B2 (s): asked for in every tick, so found once.
    longest_steps: [f64; 2],
    /// What the equations of B1 and B2 are like.
    natures: [Nature; 2],
    /// Hammer and key, which move apart in B2.
    apart: [Part; 2],
    /// 1/JH and 1/JK (1/(kg·m²)): a product takes a third of a division's time.
    per_inertia: [f64; 2],
    /// Angular accelerations by the weight of hammer and key, lying level (rad/s²).
    weights: [f64; 2],
    /// Moments of the weight of hammer and key, lying level (N·m).
    moments: [f64; 2],
    /// What the Taylor series is given: see `equations::series_constants`.
    series: [f64; 10],
}

impl KeyHammerSprings {
    /// Returns the values in the order of the parameters.
    pub const fn values(&self) -> &KeyHammerValues {
        &self.values
    }
}

/// Whether the hammer is on the key.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    /// Hammer on the key, through k2.
    B1,
    /// Hammer in free flight.
    B2,
}

impl Described for KeyHammerSprings {
    const NAME: &'static str = "key-hammer-springs";
    const SUMMARY: &'static str =
        "the paper's model B: key and hammer with springs in the contacts";
    const STATES: &'static [&'static str] = &["theta_h", "theta_k", "theta_h_dot", "theta_k_dot"];
    const STATE_UNITS: &'static [&'static str] = &["rad", "rad", "rad/s", "rad/s"];
    const MODES: &'static [(Mode, &'static str)] = &[(Mode::B1, "B1"), (Mode::B2, "B2")];
    const PARAMETERS: &'static [Parameter] = &PARAMETERS;
    const PRESETS: &'static [Preset] = &PRESETS;
    const OUTPUTS: &'static [&'static str] = &["F_KH", "T_KU", "gap", "q4", "q3"];
    const OUTPUT_UNITS: &'static [&'static str] = &["N", "N·m", "m", "m", "m"];

    fn with_values(values: &[f64]) -> Self {
        let values = KeyHammerValues::from_array(&filled::<_, Self>(values));
        let per_inertia = [1.0 / values.jh, 1.0 / values.jk];
        let moments = [values.m2 * values.l2, values.m1 * values.ck].map(|it| it * values.g);
        let weights = [0, 1].map(|i| moments[i] * per_inertia[i]);
        let longest_steps = equations::longest_steps(&values);
        let natures = equations::natures(&values);
        Self {
            values,
            longest_steps,
            natures,
            apart: equations::apart(&values, natures[1]),
            per_inertia,
            weights,
            moments,
            series: equations::series_constants(&values),
        }
    }

    fn outputs(&self, mode: Mode, x: &[f64; 4], s: &Motion, out: &mut [f64]) {
        let contact = self.contact(x);
        let gap = -contact.q4 * contact.cos_delta;
        // Apart, the spring is slack and the slider is nowhere on the hammer.
        let (force, q4, q3) = match mode {
            Mode::B1 => (contact.force(), contact.q4, contact.q3),
            Mode::B2 => (0.0, 0.0, 0.0),
        };
        write(out, [force, self.coupling(x, s), gap, q4, q3]);
    }

    fn at_rest(&self, input: &Motion) -> (Mode, [f64; 4]) {
        (Mode::B1, self.equilibrium(input.position))
    }
}

impl Playable for KeyHammerSprings {
    const DAMPER: Damper = Damper::GRAND;
    const SOFTEST_TONE: f64 = SOFTEST_TONE_OF_A_GRAND;

    fn input_per_metre(&self) -> f64 {
        1.0 / self.values.r
    }

    fn sounding(&self, guard: GuardId, before: &[f64; 4]) -> Option<Sounding> {
        (guard == equations::STRING).then(|| Sounding { speed: self.values.l2 * before[2].abs() })
    }

    fn draw(&self, sketch: &mut dyn Sketch) {
        self.sketch(sketch);
    }
}
