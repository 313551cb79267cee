//! The parameters of the reduced grand, one table.

use crate::describe::Parameter;

/// Parameter values, in the order of `PARAMETERS`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ReducedGrandValues {
    /// R, hammer-head travel over key-front travel.
    pub ratio: f64,
    /// mk, mass of the key at its front (kg).
    pub key_mass: f64,
    /// mh, mass of the hammer at its head (kg).
    pub hammer_mass: f64,
    /// Gravity (m/s²).
    pub g: f64,
    /// Wk, weight of the key at its front without the hammer (N).
    pub key_weight: f64,
    /// ck, viscous damping of the key (N·s/m).
    pub key_damping: f64,
    /// Fc, dry friction of the key (N).
    pub friction: f64,
    /// vc, speed at which the dry friction is at 76 % (m/s).
    pub friction_speed: f64,
    /// ch, viscous damping of the hammer (N·s/m).
    pub hammer_damping: f64,
    /// ybed, key travel at which the key bed begins (m).
    pub bed: f64,
    /// Kb, square-law stiffness of the key bed (N/m²).
    pub bed_stiffness: f64,
    /// ab, loss of the key bed (s/m).
    pub bed_loss: f64,
    /// wf, travel over which bed and rail set in (m).
    pub felt_width: f64,
    /// Kr, square-law stiffness of the rest rail (N/m²).
    pub rail_stiffness: f64,
    /// ar, loss of the rest rail (s/m).
    pub rail_loss: f64,
    /// yb, key travel at which the jack meets the let-off button (m).
    pub button: f64,
    /// zt, head height at which the jack trips (m).
    pub trip_height: f64,
    /// ρ, hammer ratio at the trip over R.
    pub trip_ratio: f64,
    /// ν, friction of the let-off, as a ratio beside Z'.
    pub button_friction: f64,
    /// kj, spring of jack and button at the key front (N/m).
    pub jack_stiffness: f64,
    /// wj, travel over which it sets in (m).
    pub jack_width: f64,
    /// zs, head height at the string (m).
    pub string: f64,
    /// Ks, stiffness of the hammer's felt (N/m^ps).
    pub string_stiffness: f64,
    /// ps, exponent of the hammer's felt.
    pub string_exponent: f64,
    /// μs, loss of the hammer's felt (s/m).
    pub string_loss: f64,
    /// kr, spring of the repetition lever at the head (N/m).
    pub lever_stiffness: f64,
    /// cr, loss of that spring (s/m).
    pub lever_loss: f64,
    /// o_r, height of the lever's end above the hammer on the jack (m).
    pub lever_offset: f64,
    /// yd, key travel at which the lever meets the drop screw (m).
    pub drop: f64,
    /// wd, travel over which the drop screw sets in (m).
    pub drop_width: f64,
    /// zc, head height in check with the key at its bed (m).
    pub check_height: f64,
    /// Rc, travel of a head in check over that of the key.
    pub check_ratio: f64,
    /// yck, key travel from which on the check catches (m).
    pub check_from: f64,
    /// yco, key travel below which it lets go (m).
    pub check_off: f64,
    /// yrs, key travel below which the jack slips back (m).
    pub reset: f64,
    /// k1, spring between the finger's position and the key (N/m).
    pub coupling: f64,
    /// b1, damper beside it (N·s/m).
    pub coupling_damping: f64,
}

/// How many parameters there are.
pub(super) const COUNT: usize = 37;

/// The parameters with unit, range and meaning.
pub(super) const PARAMETERS: [Parameter; COUNT] = [
    Parameter::positive("R", "1", "hammer-head travel over key-front travel"),
    Parameter::positive("mk", "kg", "mass of the key, felt at its front"),
    Parameter::positive("mh", "kg", "mass of the hammer, felt at its head"),
    Parameter::gravity(),
    Parameter::within(
        "Wk",
        "N",
        -100.0,
        100.0,
        "weight of the key at its front, without the hammer; negative with leads",
    ),
    Parameter::not_negative("ck", "N·s/m", "viscous damping of the key"),
    Parameter::not_negative("Fc", "N", "dry friction of the key"),
    Parameter::positive("vc", "m/s", "key speed at which dry friction is at 76 %"),
    Parameter::not_negative("ch", "N·s/m", "viscous damping of the hammer"),
    Parameter::length("ybed", "key travel at which the key bed begins"),
    Parameter::within("Kb", "N/m²", 0.0, 1e12, "stiffness of the key bed, a softened square law"),
    Parameter::not_negative("ab", "s/m", "loss of the key bed"),
    Parameter::positive("wf", "m", "travel over which bed and rest rail set in"),
    Parameter::within("Kr", "N/m²", 0.0, 1e12, "stiffness of the rest rail, a softened square law"),
    Parameter::not_negative("ar", "s/m", "loss of the rest rail"),
    Parameter::length("yb", "key travel at which the jack meets the let-off button"),
    Parameter::length("zt", "head height at which the jack trips; more than R yb"),
    Parameter::within("rho", "1", 0.0, 1.0, "hammer ratio at the trip over R"),
    Parameter::not_negative("nu", "1", "friction of the let-off, a ratio beside the hammer's"),
    Parameter::not_negative("kj", "N/m", "spring of jack and button, at the key front"),
    Parameter::positive("wj", "m", "travel over which that spring sets in"),
    Parameter::length("zs", "head height at the string; more than zt"),
    Parameter::within("Ks", "N/m^ps", 1e-9, 1e15, "stiffness of the hammer's felt"),
    Parameter::within("ps", "1", 1.0, 10.0, "exponent of the hammer's felt"),
    Parameter::not_negative("mus", "s/m", "loss of the hammer's felt"),
    Parameter::positive("kr", "N/m", "spring of the repetition lever, at the head"),
    Parameter::not_negative("cr", "s/m", "loss of that spring"),
    Parameter::length("o_r", "height of the lever above a head that lies on the jack"),
    Parameter::length("yd", "key travel at which the lever meets the drop screw"),
    Parameter::positive("wd", "m", "travel over which the drop screw sets in"),
    Parameter::length("zc", "head height in check with the key at its bed"),
    Parameter::positive("Rc", "1", "travel of a head in check over that of the key"),
    Parameter::length("yck", "key travel from which on the check catches"),
    Parameter::length("yco", "key travel below which the check lets go"),
    Parameter::length("yrs", "key travel below which the jack slips back under the knuckle"),
    Parameter::positive("k1", "N/m", "spring between the finger's position and the key"),
    Parameter::not_negative("b1", "N·s/m", "damper beside it"),
];

impl ReducedGrandValues {
    /// Values in the order of `PARAMETERS`.
    pub(super) const fn from_array(v: &[f64; COUNT]) -> Self {
        Self {
            ratio: v[0],
            key_mass: v[1],
            hammer_mass: v[2],
            g: v[3],
            key_weight: v[4],
            key_damping: v[5],
            friction: v[6],
            friction_speed: v[7],
            hammer_damping: v[8],
            bed: v[9],
            bed_stiffness: v[10],
            bed_loss: v[11],
            felt_width: v[12],
            rail_stiffness: v[13],
            rail_loss: v[14],
            button: v[15],
            trip_height: v[16],
            trip_ratio: v[17],
            button_friction: v[18],
            jack_stiffness: v[19],
            jack_width: v[20],
            string: v[21],
            string_stiffness: v[22],
            string_exponent: v[23],
            string_loss: v[24],
            lever_stiffness: v[25],
            lever_loss: v[26],
            lever_offset: v[27],
            drop: v[28],
            drop_width: v[29],
            check_height: v[30],
            check_ratio: v[31],
            check_from: v[32],
            check_off: v[33],
            reset: v[34],
            coupling: v[35],
            coupling_damping: v[36],
        }
    }
}
