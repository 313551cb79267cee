//! What the tests of the reduced grand share: its geometry, as the source writes it.
#![allow(dead_code, unreachable_pub, reason = "each test file uses its own part")]

use hand_written::reduced_grand::{Mode, ReducedGrandValues};

/// The let-off button (m).
pub const BUTTON: f64 = 0.0082;
/// Where the jack trips (m).
pub const TRIP: f64 = 0.009_109_090_909_090_909;
/// The string (m).
pub const STRING: f64 = 0.045;

/// ln(1 + eˣ), as the source writes it.
fn softplus(x: f64) -> f64 {
    if x > 30.0 { x } else { x.exp().ln_1p() }
}

/// The end of the repetition lever (m).
pub fn lever(p: &ReducedGrandValues, y: f64) -> f64 {
    p.lever_offset + p.ratio * (y - p.drop_width * softplus((y - p.drop) / p.drop_width))
}

/// The head that the key carries (m): on the jack along a line, through the let-off along the
/// parabola that leaves the button in the line's direction and ends flat by `rho` at `zt`.
pub fn carried(p: &ReducedGrandValues, mode: Mode, y: f64) -> Option<f64> {
    match mode {
        Mode::Acc => Some(p.ratio * y),
        Mode::Chk => Some(p.check_height + p.check_ratio * (y - p.bed)),
        Mode::Lo => {
            let (from, slopes) = (p.ratio * BUTTON, [p.ratio, p.ratio * p.trip_ratio]);
            let along = (y - BUTTON) / (TRIP - BUTTON);
            let mean = slopes[0] + 0.5 * along * (slopes[1] - slopes[0]);
            Some(from + mean * (y - BUTTON))
        }
        Mode::Fla
        | Mode::Fll
        | Mode::Flt
        | Mode::Stu
        | Mode::Stt
        | Mode::RepH
        | Mode::RepL
        | Mode::Rep0 => None,
    }
}

/// Compares, absolutely below 1 and relatively above.
#[track_caller]
pub fn agree(what: &str, got: f64, expected: f64, tolerance: f64) {
    let error = (got - expected).abs();
    assert!(error <= tolerance * (1.0 + expected.abs()), "{what}: {got} is not {expected}");
}
