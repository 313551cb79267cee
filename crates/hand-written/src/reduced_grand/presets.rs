//! Named parameter sets of the reduced grand.

use super::parameters::COUNT;
use crate::key_hammer::{BALANCE, hammer_mass};
use models::Preset;

/// The sets; the first is the default.
pub(super) const PRESETS: [Preset; 2] = [
    Preset {
        name: "default",
        doc: "one key of a grand, plausible and not measured",
        value: &|parameter, _key| DEFAULT[parameter],
    },
    Preset {
        name: "playable",
        doc: "hammers graded over the compass, and a key that comes up by itself from everywhere",
        value: &playable,
    },
];

/// All estimates (E): they give the feel that README.md lists.
const DEFAULT: [f64; COUNT] = [
    5.0,    // R
    0.15,   // mk
    0.0112, // mh
    9.81,   // g
    -0.18,  // Wk
    0.4,    // ck
    0.12,   // Fc
    0.004,  // vc
    0.002,  // ch
    0.010,  // ybed
    2e7,    // Kb
    1.0,    // ab
    5e-5,   // wf
    2e7,    // Kr
    1.0,    // ar
    0.0082, // yb
    0.0435, // zt
    0.1,    // rho
    5.0,    // nu
    250.0,  // kj
    5e-5,   // wj
    0.045,  // zs
    1e9,    // Ks
    2.5,    // ps
    0.1,    // mus
    45.0,   // kr
    4.0,    // cr
    0.0030, // o_r
    0.0080, // yd
    2e-4,   // wd
    0.032,  // zc
    1.5,    // Rc
    0.0085, // yck
    0.0078, // yco
    0.0070, // yrs
    8000.0, // k1
    20.0,   // b1
];

/// For a keyboard whose finger pushes and never pulls: with the jack out, nothing but the key
/// and what the lever passes on lifts the key, against the manipulandum's own friction too.
fn playable(parameter: usize, key: u8) -> f64 {
    let head = hammer_mass(key);
    match parameter {
        HAMMER_MASS => head,
        // Leads as a technician puts them (P), but for the bass, where it would not come up.
        KEY_WEIGHT => (BALANCE - DEFAULT[0] * head * 9.81).max(LEAST_WEIGHT),
        FRICTION => 0.0,    // the manipulandum has its own 0.10 N (E)
        DROP_WIDTH => 5e-4, // the lever lets go of the key later (E)
        CHECK_RATIO => 0.2, // a check that does not pull the key down (E)
        _ => DEFAULT[parameter],
    }
}

/// Places in [`super::parameters::PARAMETERS`].
const HAMMER_MASS: usize = 2;
const KEY_WEIGHT: usize = 4;
const FRICTION: usize = 6;
const DROP_WIDTH: usize = 29;
const CHECK_RATIO: usize = 31;

/// Weight of a key without a hammer that still comes up (N) (E).
const LEAST_WEIGHT: f64 = -0.04;
