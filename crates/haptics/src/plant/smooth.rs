//! Smooth steps from 0 to 1 for gestures, constant outside `0 ..= 1`.

/// Cubic step with zero slope at both ends.
pub(super) fn cubic(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// Integral of [`cubic`] from 0 to `x` within `0 ..= 1`; one half at the end.
pub(super) fn cubic_integral(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * x * (1.0 - 0.5 * x)
}

/// Quintic step with zero slope and curvature at both ends.
pub fn quintic(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * x * (10.0 + x * (6.0 * x - 15.0))
}

pub(super) fn quintic_slope(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    let hump = x * (1.0 - x);
    30.0 * hump * hump
}
