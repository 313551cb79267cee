//! The parameters that models A and B share, one list for both.

use crate::parameter;
use crate::parameters::parameters;

parameters! {
    /// Values of the parameters.
    pub struct KeyHammerValues, pub(crate) COUNT, pub PARAMETERS;

    /// P1 to the slider along K (m).
    l1 = parameter::positive("L1", "m", "key pivot to the slider, along the key");
    /// P2 to the hammer's mass centre (m).
    l2 = parameter::positive("L2", "m", "hammer pivot to the hammer's mass centre");
    /// P2, x (m).
    l3 = parameter::length("L3", "hammer pivot, to the right of the key pivot");
    /// P2, y (m).
    l4 = parameter::length("L4", "hammer pivot, above the key pivot");
    /// Mass of the key (kg).
    m1 = parameter::not_negative("M1", "kg", "mass of the key");
    /// Mass of the hammer (kg).
    m2 = parameter::positive("M2", "kg", "mass of the hammer");
    /// Torsion spring between manipulandum and key, model B (N·m/rad).
    k1 = parameter::positive(
        "k1",
        "N·m/rad",
        "torsion spring between manipulandum and key (model B; A is rigid)",
    );
    /// Spring between key and slider, model B (N/m).
    k2 = parameter::positive("k2", "N/m", "spring between key and slider (model B; A is rigid)");
    /// P1 to the key's mass centre (m).
    ck = parameter::length(
        "cK",
        "key pivot to the key's mass centre; negative on the player's side",
    );
    /// Inertia of the key about P1 (kg·m²).
    jk = parameter::positive("JK", "kg·m²", "inertia of the key about its pivot");
    /// Inertia of the hammer about P2 (kg·m²).
    jh = parameter::positive("JH", "kg·m²", "inertia of the hammer about its pivot");
    /// Gravity (m/s²).
    g = parameter::gravity();
    /// Hammer angle at the string (rad).
    string_angle = parameter::within(
        "string_angle",
        "rad",
        -1.5,
        1.5,
        "angle of the hammer at the string",
    );
    /// Restitution of the string.
    restitution = parameter::restitution(
        "speed after the string over speed before; the paper has 1",
    );
    /// Damper beside k1, model B (N·m·s/rad).
    b1 = parameter::not_negative(
        "b1",
        "N·m·s/rad",
        "damper beside k1 (model B; the paper has none)",
    );
    /// Loss of the felt in k2, model B (s/m).
    c2 = parameter::not_negative(
        "c2",
        "s/m",
        "loss of the felt in k2, F = k2 q4 (1 + c2 q4') (model B; the paper has none)",
    );
    /// Lever arm of the finger (m).
    r = parameter::positive("r", "m", "lever arm of the finger: finger force = torque / r");
}
