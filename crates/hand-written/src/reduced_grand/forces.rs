//! The forces on key and hammer, and the rates that guards need.

use core::f64::consts::LN_2;

use pode::Motion;
use pode::math::{powf, tanh};

use super::ReducedGrand;
use super::geometry::Lever;
use equations::Softplus;

/// A felt that sets in softly: k w² sp(x/w)² (1 + a x'), x how far one is in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct SoftFelt {
    /// k (N/m²).
    pub(super) stiffness: f64,
    /// w (m).
    pub(super) width: f64,
    /// a (s/m).
    pub(super) loss: f64,
}

/// A felt's force and what its slopes and energies are made of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pressed {
    /// k w² sp(x/w)²: the part that stores (N).
    pub(super) spring: f64,
    /// 1 + a x', never below zero: felt does not pull.
    pub(super) factor: f64,
    /// ∂(spring)/∂x (N/m).
    slope: f64,
}

impl SoftFelt {
    /// `depth` (m) deep, going on at `rate` (m/s).
    #[inline]
    pub(super) fn pressed(&self, depth: f64, rate: f64) -> Pressed {
        let soft = Softplus::at(depth / self.width);
        let force = self.stiffness * self.width * soft.value;
        Pressed {
            spring: force * self.width * soft.value,
            factor: (1.0 + self.loss * rate).max(0.0),
            slope: 2.0 * force * soft.slope,
        }
    }

    /// What it stores (J).
    pub(super) fn energy(&self, depth: f64) -> f64 {
        let soft = Softplus::at(depth / self.width);
        self.stiffness * self.width * self.width * self.width * soft.area_of_square()
    }
}

impl Pressed {
    #[inline]
    fn force(&self) -> f64 {
        self.spring * self.factor
    }

    /// ∂/∂x and ∂/∂x' of the force (N/m, N·s/m).
    fn slopes(&self, loss: f64) -> (f64, f64) {
        let per_rate = if self.factor > 0.0 { self.spring * loss } else { 0.0 };
        (self.slope * self.factor, per_rate)
    }
}

impl ReducedGrand {
    /// F_KU = k1 (s − y) + b1 (s' − u) (N).
    #[inline]
    pub(super) fn finger(&self, y: f64, u: f64, s: &Motion) -> f64 {
        let p = &self.values;
        p.coupling * (s.position - y) + p.coupling_damping * (s.rate - u)
    }

    /// Its rate while the key accelerates at `acceleration` (N/s).
    pub(super) fn finger_rate(&self, u: f64, acceleration: f64, s: &Motion) -> f64 {
        let p = &self.values;
        p.coupling * (s.rate - u) + p.coupling_damping * (s.acceleration - acceleration)
    }

    /// The key bed; the key is y − ybed deep in it.
    pub(super) const fn bed(&self) -> SoftFelt {
        let p = &self.values;
        SoftFelt { stiffness: p.bed_stiffness, width: p.felt_width, loss: p.bed_loss }
    }

    /// The rest rail; the key is −y deep in it.
    pub(super) const fn rail(&self) -> SoftFelt {
        let p = &self.values;
        SoftFelt { stiffness: p.rail_stiffness, width: p.felt_width, loss: p.rail_loss }
    }

    /// How the spring of jack and button sets in.
    #[inline]
    pub(super) fn button_spring(&self, y: f64) -> Softplus {
        Softplus::at((y - self.values.button) / self.values.jack_width)
    }

    /// S: what the key's own parts put against its going down (N).
    #[inline]
    pub(super) fn key_load(&self, y: f64, u: f64) -> f64 {
        let p = &self.values;
        p.key_weight
            + p.friction * tanh(u / p.friction_speed)
            + p.key_damping * u
            + p.jack_stiffness * p.jack_width * self.button_spring(y).value
            + self.bed().pressed(y - p.bed, u).force()
            - self.rail().pressed(-y, -u).force()
    }

    /// Rate of S while the key accelerates at `acceleration` (N/s).
    pub(super) fn key_load_rate(&self, y: f64, u: f64, acceleration: f64) -> f64 {
        let p = &self.values;
        let rubbing = tanh(u / p.friction_speed);
        let (bed, bed_damping) = self.bed().pressed(y - p.bed, u).slopes(p.bed_loss);
        let (rail, rail_damping) = self.rail().pressed(-y, -u).slopes(p.rail_loss);
        let stiffness = p.jack_stiffness * self.button_spring(y).slope + bed + rail;
        let damping = p.friction / p.friction_speed * (1.0 - rubbing * rubbing)
            + p.key_damping
            + bed_damping
            + rail_damping;
        stiffness * u + damping * acceleration
    }

    /// F = kr d sp(cr d')/ln 2, d = Zr − z: the repetition spring on the head (N).
    #[inline]
    pub(super) fn lever_force(&self, lever: &Lever, x: &[f64; 4]) -> f64 {
        let p = &self.values;
        let squeeze = lever.height - x[1];
        let rate = lever.ratio * x[2] - x[3];
        p.lever_stiffness * squeeze * Softplus::at(p.lever_loss * rate).value / LN_2
    }

    /// kr (Zr − Zc): the same spring on a head in check (N).
    #[inline]
    pub(super) fn lever_under_check(&self, y: f64) -> f64 {
        self.values.lever_stiffness * (self.lever(y).height - self.in_check(y).height)
    }

    /// Ks (z − zs)^ps: the part of the string's force that stores; none before the string (N).
    #[inline]
    pub(super) fn string_spring(&self, z: f64) -> f64 {
        let p = &self.values;
        p.string_stiffness * powf((z - p.string).max(0.0), p.string_exponent)
    }

    /// Ks (z − zs)^ps (1 + μs w): the string on the head (N).
    #[inline]
    pub(super) fn string_force(&self, z: f64, w: f64) -> f64 {
        self.string_spring(z) * (1.0 + self.values.string_loss * w).max(0.0)
    }
}
