//! Where the parts are as functions of the key's travel, with their ratios.

use pode::math::tanh;

use super::ReducedGrand;
use super::parameters::ReducedGrandValues;
use equations::Softplus;

/// The hammer's head as the key carries it: z = ζ(y).
#[derive(Clone, Copy, Debug)]
pub(super) struct CarriedHead {
    /// ζ (m).
    pub(super) height: f64,
    pub(super) ratio: f64,
    /// ζ'' (1/m): constant in every mode.
    pub(super) bend: f64,
    /// Force on the key over force on the hammer: ζ' and what friction adds.
    pub(super) transmission: f64,
}

impl CarriedHead {
    /// Without friction and along a straight line.
    const fn straight(height: f64, ratio: f64) -> Self {
        Self { height, ratio, bend: 0.0, transmission: ratio }
    }
}

/// The let-off, from the button to the trip: what follows from the parameters alone.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct LetOff {
    /// zb = R yb, height of the head at the button (m).
    height: f64,
    /// 1/D, D the key's travel from the button to the trip (1/m).
    per_travel: f64,
    /// R D (m).
    rise: f64,
    /// Z'' = −R (1 − ρ)/D (1/m).
    pub(super) bend: f64,
    /// yt = yb + D, where the jack trips (m).
    pub(super) trip: f64,
}

impl LetOff {
    /// D = 2 (zt − zb)/(R (1 + ρ)); where the parameters leave no room it is 1 µm.
    pub(super) fn new(p: &ReducedGrandValues) -> Self {
        const LEAST: f64 = 1e-6;
        let height = p.ratio * p.button;
        let travel = (2.0 * (p.trip_height - height) / (p.ratio * (1.0 + p.trip_ratio))).max(LEAST);
        Self {
            height,
            per_travel: 1.0 / travel,
            rise: p.ratio * travel,
            bend: -p.ratio * (1.0 - p.trip_ratio) / travel,
            trip: p.button + travel,
        }
    }

    /// ξ = (y − yb)/D.
    fn progress(&self, p: &ReducedGrandValues, y: f64) -> f64 {
        (y - p.button) * self.per_travel
    }

    /// Z = zb + R D (ξ − ξ² (1 − ρ)/2) and Z' = R (1 − ξ (1 − ρ)).
    #[inline]
    pub(super) fn head(&self, p: &ReducedGrandValues, y: f64) -> (f64, f64) {
        let xi = self.progress(p, y);
        let bent = xi * (1.0 - p.trip_ratio);
        (self.height + self.rise * xi * (1.0 - 0.5 * bent), p.ratio * (1.0 - bent))
    }
}

/// The end of the repetition lever under the head.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lever {
    /// Zr = o_r + R (y − wd sp(a)), a = (y − yd)/wd (m).
    pub(super) height: f64,
    /// Zr' = R (1 − σ(a)).
    pub(super) ratio: f64,
}

impl ReducedGrand {
    /// ACC: z = R y.
    #[inline]
    pub(super) fn on_jack(&self, y: f64) -> CarriedHead {
        CarriedHead::straight(self.values.ratio * y, self.values.ratio)
    }

    /// LO: z = Z(y), the jack against the button; friction takes most half way.
    #[inline]
    pub(super) fn at_button(&self, y: f64, u: f64) -> CarriedHead {
        let p = &self.values;
        let (height, ratio) = self.let_off.head(p, y);
        let xi = self.let_off.progress(p, y);
        let hump = xi * (1.0 - xi);
        let rubbing = 16.0 * p.button_friction * hump * hump * tanh(u / p.friction_speed);
        CarriedHead { height, ratio, bend: self.let_off.bend, transmission: ratio + rubbing }
    }

    /// CHK: z = Zc(y) = zc + Rc (y − ybed).
    #[inline]
    pub(super) fn in_check(&self, y: f64) -> CarriedHead {
        let p = &self.values;
        CarriedHead::straight(p.check_height + p.check_ratio * (y - p.bed), p.check_ratio)
    }

    /// The repetition lever: it rises with the key until the drop screw holds it.
    #[inline]
    pub(super) fn lever(&self, y: f64) -> Lever {
        let p = &self.values;
        let dropped = Softplus::at((y - p.drop) / p.drop_width);
        Lever {
            height: p.lever_offset + p.ratio * (y - p.drop_width * dropped.value),
            ratio: p.ratio * (1.0 - dropped.slope),
        }
    }
}
