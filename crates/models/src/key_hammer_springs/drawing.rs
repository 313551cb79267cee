//! What model B looks like: the finger holds a manipulandum, springs do the rest.

use super::KeyHammerSprings;
use crate::draw::{Follow, Material, Sketch};
use crate::key_hammer::drawing::DrawingDimensions;
use crate::shapes::{Pen, Pose, plate};

impl KeyHammerSprings {
    /// The torsion spring k1 is drawn at the key's front, k2 under the slider.
    pub(super) fn sketch(&self, sketch: &mut dyn Sketch) {
        let (p, look) = (&self.values, DrawingDimensions::sprung(&self.values));
        let u = look.unit;
        let mut pen = Pen::new(sketch, look.view());
        look.rails(&mut pen);
        let key = look.key(&mut pen, Follow::of(0.0, 1.0, "theta_k"));
        let slider = Self::slider(&mut pen, &look);
        let manipulandum = self.manipulandum(&mut pen, u);
        look.hammer(&mut pen);
        look.string(&mut pen);
        look.finger(&mut pen, u);
        let (arm, below) = (0.7 * p.r, -look.depth);
        pen.coil("k1", (key, [-arm, below]), (manipulandum, [-arm, 0.6 * u]), &[]);
        pen.coil("k2", (key, [p.l1, below]), (slider, [p.l1, -0.2 * u]), &[]);
    }

    /// Turns with the key and sinks by q4: straight down, which is square to the key while its
    /// angle is small.
    fn slider(pen: &mut Pen<'_>, look: &DrawingDimensions<'_>) -> u32 {
        let turning = Pose::turning([0.0, 0.0], Follow::of(0.0, 1.0, "theta_k"));
        let body = pen.body("slider", Pose { y: Follow::of(0.0, -1.0, "q4"), ..turning }, &[]);
        look.slider(pen);
        body
    }

    /// The lever M that the finger moves, s = position / r.
    fn manipulandum(&self, pen: &mut Pen<'_>, u: f64) -> u32 {
        let r = self.values.r;
        let pose = Pose::turning([0.0, 0.0], Follow::of(0.0, 1.0 / r, "position"));
        let body = pen.body("manipulandum", pose, &[]);
        pen.fill(Material::Metal, &plate([-r, 0.6 * u, 0.25 * u, u]));
        pen.fill(Material::Metal, &plate([-0.25 * u, 0.0, 0.25 * u, 0.6 * u]));
        body
    }
}
