//! Named parameter sets of models A and B: the paper's, and one of a real key's size.

use models::Preset;
use pode::math::atan2;

/// The sets; the first is the default.
pub const PRESETS: [Preset; 3] = [
    Preset {
        name: "paper",
        doc: "Table 2 of the paper, lengths read as decimetres",
        value: &paper,
    },
    Preset { name: "literal", doc: "Table 2 of the paper as printed, in SI", value: &literal },
    Preset {
        name: "playable",
        doc: "a real key's size, graded over the compass; the key bottom leaves the hammer 2–3 mm short",
        value: &playable,
    },
];

/// 3 inches of travel for 45°: the paper's manipulandum (m).
const PAPER_LEVER: f64 = 0.0762 / core::f64::consts::FRAC_PI_4;

fn paper(parameter: usize, _key: u8) -> f64 {
    [
        0.4,
        1.0,
        0.1,
        0.05,
        6.5,
        0.01,
        6.2,
        15.0,
        0.002,
        0.01625,
        0.01,
        9.81,
        0.398,
        1.0,
        0.0,
        0.0,
        PAPER_LEVER,
    ][parameter]
}

fn literal(parameter: usize, _key: u8) -> f64 {
    [
        4.0,
        10.0,
        1.0,
        0.5,
        6.5,
        0.01,
        620.0,
        15.0,
        0.02,
        1.625,
        1.0,
        9.81,
        0.398,
        1.0,
        0.0,
        0.0,
        PAPER_LEVER,
    ][parameter]
}

/// A key of a grand's size. Figures: `piano-facts` in REFERENCES.md; E marks estimates.
///
/// The whippen's leverage is folded into the slider: balance rail to capstan 138.5 mm,
/// slider 13.7 mm from the hammer pin, so that the head travels 5 times the key front.
/// Without let-off it does so to the key bottom: the blow is 54 mm, a grand's 47–48.
fn playable(parameter: usize, key: u8) -> f64 {
    let head = hammer_mass(key);
    [
        CAPSTAN,
        HEAD_RADIUS,
        CAPSTAN - KNUCKLE,
        HALF_RISE,
        KEY_MASS,
        head,
        300.0,                                  // coupling: 4.5 kN/m at the front (E)
        24e3,                                   // knuckle, whippen and shank in series (E)
        balance(head),                          // leads, graded as a technician does
        2.0e-3,                                 // stick less the manipulandum's own inertia (E)
        1.1 * head * HEAD_RADIUS * HEAD_RADIUS, // head and shank
        9.81,
        string_angle(),
        0.1,  // no back check in A and B: it must take its place (E)
        0.12, // keeps the coupling from ringing (E)
        6.0,  // felt: loses what a check would catch (E)
        FRONT,
    ][parameter]
}

/// Balance rail to capstan (m) (S).
const CAPSTAN: f64 = 0.1385;
/// Balance rail to key front (m) (S).
const FRONT: f64 = 0.2595;
/// Key dip at the front (m) (S).
const DIP: f64 = 0.010_16;
/// Hammer pin to head (m) (S).
const HEAD_RADIUS: f64 = 0.13;
/// Slider to hammer pin; gives the ratio 5 of head to key front (m) (C).
const KNUCKLE: f64 = 0.0137;
/// Half of the capstan's rise, so that the hammer is level at half stroke (m) (C).
const HALF_RISE: f64 = 0.0027;
/// How far the key bottom leaves the head short of the string (m): let-off, 1–3 mm (S).
/// Model B's springs sag by another 0.7–0.9 mm.
const SHORT: f64 = 0.002_05;

/// Key stick and leads, 0.10–0.16 (kg) (E).
const KEY_MASS: f64 = 0.13;
/// Balance weight: 39 gf at the front (N) (P: 38–40 gf).
pub(crate) const BALANCE: f64 = 0.382;

/// Mass centre of the key, whippen included, that balances a hammer of `head` (kg) (m).
fn balance(head: f64) -> f64 {
    let hammer = head * HEAD_RADIUS * CAPSTAN / KNUCKLE;
    (BALANCE * FRONT / 9.81 - hammer) / KEY_MASS
}

/// Hammer mass over the compass (kg): Chabassier & Duruflé, Steinway D (S).
pub(crate) fn hammer_mass(key: u8) -> f64 {
    0.0112 - 6.2348e-5 * f64::from(key + 1)
}

/// Head angle at the key bottom, plus what is left to fly.
fn string_angle() -> f64 {
    let s = DIP / FRONT;
    let (sin_s, cos_s) = pode::math::sin_cos(s);
    let bottom = atan2(CAPSTAN * sin_s - HALF_RISE, CAPSTAN * (cos_s - 1.0) + KNUCKLE);
    bottom + SHORT / HEAD_RADIUS
}
