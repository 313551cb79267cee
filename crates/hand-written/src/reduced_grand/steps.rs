//! The longest step that resolves the motion in each mode: an estimate, on the safe side.
//!
//! Masses, springs and dampers of a mode are lumped into one oscillator each, with what is
//! nonlinear taken where a hard blow presses it most; the step is a quarter of a radian of it.
//! Where bed, rail or string are pressed harder than that, they shorten the step further.

use pode::math::{hypot, powf, sqrt};

use super::Mode;
use super::parameters::ReducedGrandValues;

/// A quarter of a radian of the fastest motion: RK4 is off by 1e-5 of a radian there.
const RADIANS: f64 = 0.25;
/// Speed of a hammer in a hard blow (m/s).
const BLOW: f64 = 5.0;
/// Force of a finger in it (N).
const FORCE: f64 = 50.0;
/// Force of a jack that rubs on its button while the key turns round (N): five hammers'
/// weights. A faster key does not turn round there.
const RUBBING: f64 = 0.5;

/// Longest steps (s): asked for in every tick, so found once.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct LongestSteps {
    /// ACC: key and hammer as one.
    on_jack: f64,
    /// LO: as one, with the hammer hardly felt at the trip, and rubbing.
    at_button: f64,
    /// In the air, on the repetition lever and in check.
    apart: f64,
    on_string: f64,
    /// How deep (m) a hard blow goes into the hammer's felt.
    blow: f64,
    /// Coupling, jack and lever at the key (N/m), and what damps it (N·s/m).
    key: (f64, f64),
    /// Mass of the key with the hammer (kg).
    with_hammer: f64,
}

impl LongestSteps {
    pub(super) fn new(p: &ReducedGrandValues) -> Self {
        let with_hammer = p.key_mass + p.ratio * p.ratio * p.hammer_mass;
        let (stiffness, damping) = (key_stiffness(p), key_damping(p));
        let lever = p.ratio * p.ratio * p.lever_stiffness;
        let rubbing = p.button_friction * RUBBING / p.friction_speed;
        let on_jack = rate(stiffness, damping, with_hammer);
        let at_button = rate(stiffness, damping + rubbing, p.key_mass);
        let apart = rate(stiffness + lever, damping, p.key_mass);
        let blow = deepest_blow(p);
        let string = rate(string_stiffness(p, blow), 0.0, p.hammer_mass);
        Self {
            on_jack: RADIANS / on_jack,
            at_button: RADIANS / at_button,
            apart: RADIANS / apart,
            on_string: RADIANS / apart.max(string),
            blow,
            key: (p.coupling + p.jack_stiffness + lever, damping),
            with_hammer,
        }
    }

    /// The longest step in `mode` from `x` on (s).
    #[inline]
    pub(super) fn from(&self, p: &ReducedGrandValues, mode: Mode, x: &[f64; 4]) -> f64 {
        let own = self.of(mode);
        let [y, z, u, w] = *x;
        // As deep as it may be by the end of the step.
        let bed = (y - p.bed + own * u.max(0.0)).max(0.0);
        let rail = (-y - own * u.min(0.0)).max(0.0);
        let [bed, rail] = [p.bed_stiffness * bed * bed, p.rail_stiffness * rail * rail];
        let string = z - p.string + own * w.max(0.0);
        let is_on_string = matches!(mode, Mode::Stu | Mode::Stt);
        let mut step = own;
        if bed.max(rail) > FORCE {
            step = step.min(RADIANS / self.pressed_rate(p, mode, [bed, rail]));
        }
        if is_on_string && string > self.blow {
            step = step.min(RADIANS / struck_rate(p, string));
        }
        step
    }

    /// The key's rate with its bed and its rail under these forces (N) (rad/s).
    #[cold]
    fn pressed_rate(&self, p: &ReducedGrandValues, mode: Mode, [bed, rail]: [f64; 2]) -> f64 {
        let mass = if mode == Mode::Acc { self.with_hammer } else { p.key_mass };
        let slope = 2.0 * (sqrt(p.bed_stiffness * bed) + sqrt(p.rail_stiffness * rail));
        let (stiffness, damping) = self.key;
        rate(stiffness + slope, damping + p.bed_loss * bed + p.rail_loss * rail, mass)
    }

    /// The fastest rate in `mode`, pressed as hard (rad/s).
    pub(super) const fn rate(&self, mode: Mode) -> f64 {
        RADIANS / self.of(mode)
    }

    /// The longest step in `mode` (s).
    pub(super) const fn of(&self, mode: Mode) -> f64 {
        match mode {
            Mode::Acc => self.on_jack,
            Mode::Lo => self.at_button,
            Mode::Fla
            | Mode::Fll
            | Mode::Flt
            | Mode::RepH
            | Mode::RepL
            | Mode::Rep0
            | Mode::Chk => self.apart,
            Mode::Stu | Mode::Stt => self.on_string,
        }
    }
}

/// |λ| of an oscillator, at most: √(k/m + (b/m)²) (rad/s).
fn rate(stiffness: f64, damping: f64, mass: f64) -> f64 {
    hypot(sqrt(stiffness / mass), damping / mass)
}

/// Coupling, jack, and bed or rail under the whole force: a square law's slope is 2 √(K F).
fn key_stiffness(p: &ReducedGrandValues) -> f64 {
    let felt = 2.0 * sqrt(p.bed_stiffness.max(p.rail_stiffness) * FORCE);
    p.coupling + p.jack_stiffness + felt
}

/// Coupling, key, and dry friction as it turns round.
fn key_damping(p: &ReducedGrandValues) -> f64 {
    p.coupling_damping + p.key_damping + p.friction / p.friction_speed
}

/// How deep a blow presses the hammer's felt (m): mh v²/2 = Ks p^(ps+1)/(ps + 1).
fn deepest_blow(p: &ReducedGrandValues) -> f64 {
    let power = p.string_exponent + 1.0;
    let work = power * p.hammer_mass * BLOW * BLOW / (2.0 * p.string_stiffness);
    powf(work, 1.0 / power)
}

/// The slope of that felt, `depth` (m) deep (N/m).
fn string_stiffness(p: &ReducedGrandValues, depth: f64) -> f64 {
    p.string_exponent * p.string_stiffness * powf(depth, p.string_exponent - 1.0)
}

/// The hammer's rate with its felt so deep (m) in the string (rad/s).
#[cold]
fn struck_rate(p: &ReducedGrandValues, depth: f64) -> f64 {
    let stiffness = string_stiffness(p, depth);
    let force = stiffness * depth / p.string_exponent;
    rate(stiffness, p.string_loss * force, p.hammer_mass)
}
