//! What the cart looks like: on a rail between walls, a spring to the hand above one of them.

use super::CartPendulum;
use crate::draw::{Follow, Material, Sketch};
use crate::shapes::{Pen, Pose, plate};

/// Travel of the key's front that there is room for (m).
const TRAVEL: f64 = 0.012;

impl CartPendulum {
    /// Half the width of the cart, from which all that is not given is measured (m).
    const fn unit(&self) -> f64 {
        0.15 * self.length
    }

    /// From the cart's middle to the hand when the spring is slack: beyond the right wall (m).
    fn slack(&self) -> f64 {
        let pushed = TRAVEL * (-self.scale).max(0.0);
        self.right.max(self.left).max(0.0) + 3.5 * self.unit() + pushed
    }

    /// The pivot of the pendulum is the cart's middle.
    pub(super) fn sketch(&self, sketch: &mut dyn Sketch) {
        let (u, swing) = (self.unit(), self.length + 0.6 * self.unit());
        let pulled = TRAVEL * self.scale.abs();
        let left = self.left.min(self.right) - swing.max(2.5 * u);
        let right = (self.right + swing).max(self.slack() + pulled + 2.5 * u);
        let mut pen = Pen::new(sketch, [left, -swing - 0.5 * u, right, 3.0 * u]);
        self.walls(&mut pen);
        let cart = self.cart(&mut pen);
        self.pendulum(&mut pen);
        let hand = Follow::of(self.slack(), self.scale, "position");
        let hand = pen.body("hand", Pose::sliding(hand, 1.2 * u), &[]);
        pen.disc(Material::Finger, [0.0, 0.0], 0.5 * u);
        pen.coil("k", (cart, [u, 1.2 * u]), (hand, [-0.5 * u, 0.0]), &[]);
    }

    /// Where the cart's sides meet them, and the rail that it runs on.
    fn walls(&self, pen: &mut Pen<'_>) {
        let u = self.unit();
        let (left, right) = (self.left - u, self.right + u);
        pen.body("walls", Pose::default(), &[]);
        pen.fill(Material::Ground, &plate([left - 0.5 * u, -0.6 * u, left, 0.7 * u]));
        pen.fill(Material::Ground, &plate([right, -0.6 * u, right + 0.5 * u, 0.7 * u]));
        pen.line(Material::Ground, &[[left, -0.6 * u], [right, -0.6 * u]]);
    }

    fn cart(&self, pen: &mut Pen<'_>) -> u32 {
        let u = self.unit();
        let body = pen.body("cart", Pose::sliding(Follow::of(0.0, 1.0, "x"), 0.0), &[]);
        pen.fill(Material::Wood, &plate([-u, -0.3 * u, u, 0.6 * u]));
        // The post that the spring holds.
        pen.fill(Material::Metal, &plate([0.8 * u, 0.6 * u, u, 1.4 * u]));
        for x in [-0.6 * u, 0.6 * u] {
            pen.disc(Material::Metal, [x, -0.35 * u], 0.25 * u);
        }
        body
    }

    /// Hangs from the cart; counter-clockwise is to the right.
    fn pendulum(&self, pen: &mut Pen<'_>) {
        let (u, l) = (self.unit(), self.length);
        let pose = Pose {
            angle: Follow::of(0.0, 1.0, "theta"),
            ..Pose::sliding(Follow::of(0.0, 1.0, "x"), 0.0)
        };
        pen.body("pendulum", pose, &[]);
        pen.line(Material::Metal, &[[0.0, 0.0], [0.0, -l]]);
        pen.disc(Material::Metal, [0.0, 0.0], 0.12 * u);
        pen.disc(Material::Metal, [0.0, -l], 0.5 * u);
    }
}
