//! What the drawings of models A and B share: stick, hammer, string and what stands still.
//!
//! Pivots, slider and string stand where the parameters put them. Thicknesses are ours and
//! measured in hundredths of the lever, so that every parameter set looks like an action.

use pode::Motion;
use pode::math::{sin, sqrt};

use super::{Coupled, KeyHammerValues};
use crate::draw::{Follow, Material};
use crate::shapes::{Pen, Point, Pose, felt, plate, rim, sum, turned};

/// Travel of the key's front that there is room for (m).
const TRAVEL: f64 = 0.012;

/// The measures of a drawing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DrawingDimensions<'a> {
    p: &'a KeyHammerValues,
    /// Half the thickness of a key stick (m): 11 mm on a real key.
    pub(crate) unit: f64,
    /// From the key's axis down to the top of its stick (m).
    pub(crate) depth: f64,
    /// θh at rest with the key level (rad).
    rest: f64,
    /// How far below that it may swing (rad).
    swing: f64,
}

impl<'a> DrawingDimensions<'a> {
    /// Returns the dimensions of a mechanism with rigid contacts.
    pub(crate) fn rigid(p: &'a KeyHammerValues) -> Self {
        let unit = 0.08 * p.l1;
        let rest = Coupled::on_key(p, &Motion::default()).angle;
        Self { p, unit, depth: 1.1 * unit, rest, swing: 0.0 }
    }

    /// With springs: the stick is as deep as k2 needs, and the hammer sinks as it lands.
    pub(crate) fn sprung(p: &'a KeyHammerValues) -> Self {
        let rigid = Self::rigid(p);
        let reach = (p.l1 - p.l3).abs().max(rigid.unit);
        let force = p.m2 * p.g * p.l2 / reach;
        let sag = force * (1.0 / p.k2 + p.l1 * p.l1 / p.k1) / reach;
        let fall = (p.string_angle - rigid.rest).max(0.0);
        // A weight that falls on a spring: as deep as it sags at rest, and the fall's share.
        let swing = sag + sqrt(sag * (sag + 2.0 * fall));
        Self { depth: rigid.depth.max(3.0 * force / p.k2), swing: swing.min(1.0), ..rigid }
    }

    /// Radius of the slider, and how far the hammer's underside is from its axis (m).
    const fn radius(&self) -> f64 {
        0.2 * self.unit
    }

    /// From the hammer's axis to the point of its head that strikes (m).
    const fn bore(&self) -> f64 {
        5.0 * self.unit
    }

    /// P2 (m).
    const fn pin(&self) -> Point {
        [self.p.l3, self.p.l4]
    }

    /// Where the head meets the string (m).
    fn strike(&self) -> Point {
        let [x, y] = sum(self.pin(), turned(self.p.string_angle, [self.p.l2, 0.0]));
        [x, y + self.bore()]
    }

    /// Left, bottom, right, top of all that moves (m).
    pub(crate) fn view(&self) -> [f64; 4] {
        let (p, u) = (self.p, self.unit);
        let lowest = p.l4 + p.l2 * sin(self.rest - self.swing) - 2.5 * u;
        let bottom = lowest.min(-self.depth - 3.6 * u).min(-self.depth - 2.0 * u - TRAVEL);
        let right = (p.l3 + p.l2).max(p.l1) + 3.0 * u;
        let top = self.strike()[1].max(p.l4 + 2.0 * u).max(4.0 * u) + u;
        [-p.r.max(u) - 2.0 * u, bottom, right, top]
    }

    /// The key that turns about P1 by `angle`: stick, button over the balance pin, lead.
    pub(crate) fn key(&self, pen: &mut Pen<'_>, angle: Follow) -> u32 {
        let (p, u, top) = (self.p, self.unit, -self.depth);
        let body = pen.body("key", Pose::turning([0.0, 0.0], angle), &[]);
        pen.fill(Material::Wood, &plate([-p.r, top - 1.3 * u, p.l1 + u, top]));
        let button = (0.7 * u).min(0.5 * p.r);
        pen.fill(Material::Wood, &plate([-button, top, button, 0.5 * u]));
        pen.disc(Material::Metal, [0.0, 0.0], 0.18 * u);
        pen.disc(Material::Metal, [p.ck.clamp(-p.r, p.l1), top - 0.65 * u], 0.4 * u);
        body
    }

    /// The slider in the axes of the key; a corner of its rim lies where the hammer rests.
    pub(crate) fn slider(&self, pen: &mut Pen<'_>) {
        let up = core::f64::consts::FRAC_PI_2 + self.rest;
        pen.fill(Material::Metal, &rim::<24>([self.p.l1, 0.0], self.radius(), up));
    }

    /// The screw under the slider.
    pub(crate) fn capstan(&self, pen: &mut Pen<'_>) {
        let (x, half) = (self.p.l1, 0.1 * self.unit);
        pen.fill(Material::Metal, &plate([x - half, -self.depth, x + half, 0.0]));
        self.slider(pen);
    }

    /// The hammer that turns about P2 by θh. Its head stands upright at the string.
    pub(crate) fn hammer(&self, pen: &mut Pen<'_>) -> u32 {
        let (p, u, under) = (self.p, self.unit, self.radius());
        let pose = Pose::turning(self.pin(), Follow::of(0.0, 1.0, "theta_h"));
        let body = pen.body("hammer", pose, &[]);
        let in_head = |point| sum([p.l2, 0.0], turned(-p.string_angle, point));
        let moulding = plate([-0.35 * u, -2.0 * u, 0.35 * u, self.bore() - u]);
        pen.fill(Material::Wood, &plate([-0.3 * u, under, p.l2, under + 0.4 * u]));
        pen.fill(Material::Wood, &moulding.map(in_head));
        let top = [0.0, self.bore()];
        pen.fill(Material::Felt, &felt(u).map(|point| in_head(sum(top, point))));
        pen.disc(Material::Metal, [0.0, 0.0], 0.18 * u);
        pen.disc(Material::Metal, [p.l2, 0.0], 0.15 * u);
        body
    }

    /// A string above the head, from before it to the edge of the view.
    pub(crate) fn string(&self, pen: &mut Pen<'_>) {
        let [x, y] = self.strike();
        let [_, _, right, _] = self.view();
        pen.body("string", Pose::default(), &[]);
        pen.line(Material::String, &[[x - 0.6 * self.p.l2, y], [right, y]]);
    }

    /// The balance rail with its pin, and the rail with the hammer's flange.
    pub(crate) fn rails(&self, pen: &mut Pen<'_>) {
        let (u, [x, y], foot) = (self.unit, self.pin(), -self.depth - 1.3 * self.unit);
        pen.body("balance rail", Pose::default(), &[]);
        let wedge = [[0.0, foot], [-u, foot - 1.3 * u], [u, foot - 1.3 * u]];
        pen.fill(Material::Ground, &wedge);
        pen.ground([-2.0 * u, 2.0 * u], foot - 1.3 * u);
        pen.line(Material::Metal, &[[0.0, foot], [0.0, 0.7 * u]]);
        pen.body("hammer rail", Pose::still([x, y]), &[]);
        pen.fill(Material::Ground, &plate([-1.9 * u, 0.8 * u, -0.2 * u, 1.8 * u]));
        let flange =
            [[-1.2 * u, 0.8 * u], [-0.35 * u, -0.2 * u], [0.1 * u, -0.2 * u], [0.1 * u, 0.8 * u]];
        pen.fill(Material::Wood, &flange);
    }

    /// The finger `height` above the key's axis, at its front.
    pub(crate) fn finger(&self, pen: &mut Pen<'_>, height: f64) {
        let pose = Pose::rising(0.6 * self.unit - self.p.r, Follow::of(height, -1.0, "position"));
        pen.body("finger", pose, &[]);
        pen.fingertip(1.3 * self.unit);
    }
}
