//! The parameters that models A and B share, one table for both.

use crate::describe::Parameter;

/// Parameter values, in the order of [`PARAMETERS`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeyHammerValues {
    /// P1 to the slider along K (m).
    pub l1: f64,
    /// P2 to the hammer's mass centre (m).
    pub l2: f64,
    /// P2, x (m).
    pub l3: f64,
    /// P2, y (m).
    pub l4: f64,
    /// Mass of the key (kg).
    pub m1: f64,
    /// Mass of the hammer (kg).
    pub m2: f64,
    /// Torsion spring between manipulandum and key, model B (N·m/rad).
    pub k1: f64,
    /// Spring between key and slider, model B (N/m).
    pub k2: f64,
    /// P1 to the key's mass centre (m).
    pub ck: f64,
    /// Inertia of the key about P1 (kg·m²).
    pub jk: f64,
    /// Inertia of the hammer about P2 (kg·m²).
    pub jh: f64,
    /// Gravity (m/s²).
    pub g: f64,
    /// Hammer angle at the string (rad).
    pub string_angle: f64,
    /// Restitution of the string.
    pub restitution: f64,
    /// Damper beside k1, model B (N·m·s/rad).
    pub b1: f64,
    /// Loss of the felt in k2, model B (s/m).
    pub c2: f64,
    /// Lever arm of the finger (m).
    pub r: f64,
}

/// How many parameters there are.
pub(crate) const N: usize = 17;

/// The parameters with unit, range and meaning.
pub const PARAMETERS: [Parameter; N] = [
    Parameter::positive("L1", "m", "key pivot to the slider, along the key"),
    Parameter::positive("L2", "m", "hammer pivot to the hammer's mass centre"),
    Parameter::length("L3", "hammer pivot, to the right of the key pivot"),
    Parameter::length("L4", "hammer pivot, above the key pivot"),
    Parameter::not_negative("M1", "kg", "mass of the key"),
    Parameter::positive("M2", "kg", "mass of the hammer"),
    Parameter::positive(
        "k1",
        "N·m/rad",
        "torsion spring between manipulandum and key (model B; A is rigid)",
    ),
    Parameter::positive("k2", "N/m", "spring between key and slider (model B; A is rigid)"),
    Parameter::length("cK", "key pivot to the key's mass centre; negative on the player's side"),
    Parameter::positive("JK", "kg·m²", "inertia of the key about its pivot"),
    Parameter::positive("JH", "kg·m²", "inertia of the hammer about its pivot"),
    Parameter::gravity(),
    Parameter::within("string_angle", "rad", -1.5, 1.5, "angle of the hammer at the string"),
    Parameter::restitution("speed after the string over speed before; the paper has 1"),
    Parameter::not_negative("b1", "N·m·s/rad", "damper beside k1 (model B; the paper has none)"),
    Parameter::not_negative(
        "c2",
        "s/m",
        "loss of the felt in k2, F = k2 q4 (1 + c2 q4') (model B; the paper has none)",
    ),
    Parameter::positive("r", "m", "lever arm of the finger: finger force = torque / r"),
];

impl KeyHammerValues {
    /// Values in the order of [`PARAMETERS`].
    pub(crate) const fn from_array(v: &[f64; N]) -> Self {
        Self {
            l1: v[0],
            l2: v[1],
            l3: v[2],
            l4: v[3],
            m1: v[4],
            m2: v[5],
            k1: v[6],
            k2: v[7],
            ck: v[8],
            jk: v[9],
            jh: v[10],
            g: v[11],
            string_angle: v[12],
            restitution: v[13],
            b1: v[14],
            c2: v[15],
            r: v[16],
        }
    }
}
