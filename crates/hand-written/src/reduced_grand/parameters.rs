//! The parameters of the reduced grand, one list.

use crate::parameter;
use crate::parameters::parameters;

parameters! {
    /// Values of the parameters.
    pub struct ReducedGrandValues, pub(super) COUNT, pub(super) PARAMETERS;

    /// R, hammer-head travel over key-front travel.
    ratio = parameter::positive("R", "1", "hammer-head travel over key-front travel");
    /// mk, mass of the key at its front (kg).
    key_mass = parameter::positive("mk", "kg", "mass of the key, felt at its front");
    /// mh, mass of the hammer at its head (kg).
    hammer_mass = parameter::positive("mh", "kg", "mass of the hammer, felt at its head");
    /// Gravity (m/s²).
    g = parameter::gravity();
    /// Wk, weight of the key at its front without the hammer (N).
    key_weight = parameter::within(
        "Wk",
        "N",
        -100.0,
        100.0,
        "weight of the key at its front, without the hammer; negative with leads",
    );
    /// ck, viscous damping of the key (N·s/m).
    key_damping = parameter::not_negative("ck", "N·s/m", "viscous damping of the key");
    /// Fc, dry friction of the key (N).
    friction = parameter::not_negative("Fc", "N", "dry friction of the key");
    /// vc, speed at which the dry friction is at 76 % (m/s).
    friction_speed = parameter::positive("vc", "m/s", "key speed at which dry friction is at 76 %");
    /// ch, viscous damping of the hammer (N·s/m).
    hammer_damping = parameter::not_negative("ch", "N·s/m", "viscous damping of the hammer");
    /// ybed, key travel at which the key bed begins (m).
    bed = parameter::length("ybed", "key travel at which the key bed begins");
    /// Kb, square-law stiffness of the key bed (N/m²).
    bed_stiffness = parameter::within(
        "Kb",
        "N/m²",
        0.0,
        1e12,
        "stiffness of the key bed, a softened square law",
    );
    /// ab, loss of the key bed (s/m).
    bed_loss = parameter::not_negative("ab", "s/m", "loss of the key bed");
    /// wf, travel over which bed and rail set in (m).
    felt_width = parameter::positive("wf", "m", "travel over which bed and rest rail set in");
    /// Kr, square-law stiffness of the rest rail (N/m²).
    rail_stiffness = parameter::within(
        "Kr",
        "N/m²",
        0.0,
        1e12,
        "stiffness of the rest rail, a softened square law",
    );
    /// ar, loss of the rest rail (s/m).
    rail_loss = parameter::not_negative("ar", "s/m", "loss of the rest rail");
    /// yb, key travel at which the jack meets the let-off button (m).
    button = parameter::length("yb", "key travel at which the jack meets the let-off button");
    /// zt, head height at which the jack trips (m).
    trip_height = parameter::length("zt", "head height at which the jack trips; more than R yb");
    /// ρ, hammer ratio at the trip over R.
    trip_ratio = parameter::within("rho", "1", 0.0, 1.0, "hammer ratio at the trip over R");
    /// ν, friction of the let-off, as a ratio beside Z'.
    button_friction = parameter::not_negative(
        "nu",
        "1",
        "friction of the let-off, a ratio beside the hammer's",
    );
    /// kj, spring of jack and button at the key front (N/m).
    jack_stiffness = parameter::not_negative(
        "kj",
        "N/m",
        "spring of jack and button, at the key front",
    );
    /// wj, travel over which it sets in (m).
    jack_width = parameter::positive("wj", "m", "travel over which that spring sets in");
    /// zs, head height at the string (m).
    string = parameter::length("zs", "head height at the string; more than zt");
    /// Ks, stiffness of the hammer's felt (N/m^ps).
    string_stiffness = parameter::within(
        "Ks",
        "N/m^ps",
        1e-9,
        1e15,
        "stiffness of the hammer's felt",
    );
    /// ps, exponent of the hammer's felt.
    string_exponent = parameter::within("ps", "1", 1.0, 10.0, "exponent of the hammer's felt");
    /// μs, loss of the hammer's felt (s/m).
    string_loss = parameter::not_negative("mus", "s/m", "loss of the hammer's felt");
    /// kr, spring of the repetition lever at the head (N/m).
    lever_stiffness = parameter::positive(
        "kr",
        "N/m",
        "spring of the repetition lever, at the head",
    );
    /// cr, loss of that spring (s/m).
    lever_loss = parameter::not_negative("cr", "s/m", "loss of that spring");
    /// o_r, height of the lever's end above the hammer on the jack (m).
    lever_offset = parameter::length(
        "o_r",
        "height of the lever above a head that lies on the jack",
    );
    /// yd, key travel at which the lever meets the drop screw (m).
    drop = parameter::length("yd", "key travel at which the lever meets the drop screw");
    /// wd, travel over which the drop screw sets in (m).
    drop_width = parameter::positive("wd", "m", "travel over which the drop screw sets in");
    /// zc, head height in check with the key at its bed (m).
    check_height = parameter::length("zc", "head height in check with the key at its bed");
    /// Rc, travel of a head in check over that of the key.
    check_ratio = parameter::positive("Rc", "1", "travel of a head in check over that of the key");
    /// yck, key travel from which on the check catches (m).
    check_from = parameter::length("yck", "key travel from which on the check catches");
    /// yco, key travel below which it lets go (m).
    check_off = parameter::length("yco", "key travel below which the check lets go");
    /// yrs, key travel below which the jack slips back (m).
    reset = parameter::length(
        "yrs",
        "key travel below which the jack slips back under the knuckle",
    );
    /// k1, spring between the finger's position and the key (N/m).
    coupling = parameter::positive("k1", "N/m", "spring between the finger's position and the key");
    /// b1, damper beside it (N·s/m).
    coupling_damping = parameter::not_negative("b1", "N·s/m", "damper beside it");
}
