//! What the paper's models A and B share: geometry, parameters, presets.
//!
//! Planar, x to the right, y up, angles counter-clockwise, radians. The key K pivots at
//! P1 = (0, 0), the hammer H at P2 = (L3, L4). The slider pivots on K at the distance L1
//! from P1 and slides along H. `s` is the key's angle; a pressed key has a larger one.

mod bounds;
mod parameters;
mod presets;

pub(crate) use bounds::{ReachBounds, gap_bound};
pub(crate) use parameters::COUNT;
pub use parameters::{KeyHammerValues, PARAMETERS};
pub use presets::PRESETS;
pub(crate) use presets::{BALANCE, hammer_mass};

use pode::math::{atan2, hypot, sin_cos, sin_cos_of_two};
use pode::{GuardValue, Motion};

/// Gap between slider and hammer and its rate; positive apart.
///
/// gap = L4 cos θh − L3 sin θh − L1 sin δ, δ = θk − θh.
#[expect(clippy::inline_always, reason = "a call takes the state through memory")]
#[inline(always)]
pub(crate) fn gap(p: &KeyHammerValues, hammer: (f64, f64), key: (f64, f64)) -> GuardValue {
    let ([sin_h, sin_d], [cos_h, cos_d]) = sin_cos_of_two([hammer.0, key.0 - hammer.0]);
    let value = p.l4 * cos_h - p.l3 * sin_h - p.l1 * sin_d;
    let rate = -(p.l4 * sin_h + p.l3 * cos_h) * hammer.1 - p.l1 * cos_d * (key.1 - hammer.1);
    GuardValue::new(value, rate)
}

/// Distance below the string angle and its rate; positive below.
#[inline]
pub(crate) fn below_string(p: &KeyHammerValues, hammer: (f64, f64)) -> GuardValue {
    GuardValue::new(p.string_angle - hammer.0, -hammer.1)
}

/// The hammer on a rigid key: all that follows from s, s', s''.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coupled {
    /// θh (rad).
    pub(crate) angle: f64,
    /// θh' (rad/s).
    pub(crate) rate: f64,
    /// θh'' (rad/s²).
    pub(crate) acceleration: f64,
    /// θh''' (rad/s³).
    pub(crate) jerk: f64,
    /// σ, the slider's distance from P2 (m).
    pub(crate) reach: f64,
    /// σ' (m/s).
    pub(crate) reach_rate: f64,
    pub(crate) cos_delta: f64,
}

impl Coupled {
    /// X = L1 cos s − L3, Y = L1 sin s − L4; θh = atan2(Y, X), σ = hypot(X, Y), δ = s − θh.
    pub(crate) fn on_key(p: &KeyHammerValues, s: &Motion) -> Self {
        let (sin_s, cos_s) = sin_cos(s.position);
        let (x, y) = (p.l1 * cos_s - p.l3, p.l1 * sin_s - p.l4);
        let (angle, reach) = (atan2(y, x), hypot(x, y));
        let (sin_d, cos_d) = sin_cos(s.position - angle);
        let rate = p.l1 * cos_d * s.rate / reach;
        let reach_rate = -p.l1 * sin_d * s.rate;
        let delta_rate = s.rate - rate;
        // θh'' = n / σ, and its derivative.
        let n = p.l1 * (cos_d * s.acceleration - sin_d * s.rate * s.rate) - 2.0 * reach_rate * rate;
        let acceleration = n / reach;
        let reach_acceleration = -p.l1 * (cos_d * delta_rate * s.rate + sin_d * s.acceleration);
        let n_rate = p.l1
            * (cos_d * (s.jerk - delta_rate * s.rate * s.rate)
                - sin_d * (delta_rate + 2.0 * s.rate) * s.acceleration)
            - 2.0 * (reach_acceleration * rate + reach_rate * acceleration);
        let jerk = (n_rate - reach_rate * acceleration) / reach;
        Self { angle, rate, acceleration, jerk, reach, reach_rate, cos_delta: cos_d }
    }
}
