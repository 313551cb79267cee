//! What the spring wall looks like: the key's front over a pad on a spring and a damper.

use super::{Mode, SpringWall};
use crate::draw::{Follow, Material, Sketch};
use crate::shapes::{Pen, Pose, plate};

/// Travel of the key's front that there is room for (m).
const TRAVEL: f64 = 0.012;
/// Modes before the wall and in it.
const FREE: &[u8] = &[Mode::Free as u8];
const CONTACT: &[u8] = &[Mode::Contact as u8];
/// Half the width of the key (m): a real one's, 23 mm in all.
const HALF: f64 = 0.0115;
/// Length of the spring with the pad up (m).
const SPRING: f64 = 0.030;

impl SpringWall {
    /// The underside of the key is at 0 with the key up.
    pub(super) fn sketch(&self, sketch: &mut dyn Sketch) {
        let room = TRAVEL.max(self.wall + TRAVEL);
        let floor = -self.wall.max(0.0) - SPRING - 0.003;
        let edges = [-2.0 * HALF, floor.min(-room) - 0.006, 2.0 * HALF, 0.045];
        let mut pen = Pen::new(sketch, edges);
        pen.body("key", Pose::rising(0.0, Follow::of(0.0, -1.0, "position")), &[]);
        pen.fill(Material::Wood, &plate([-HALF, 0.0, HALF, 0.012]));
        pen.body("finger", Pose::rising(0.0, Follow::of(0.012, -1.0, "position")), &[]);
        pen.fingertip(0.015);
        let ground = Self::base(&mut pen, floor);
        Self::pad(&mut pen, (ground, floor), Follow::fixed(-self.wall), FREE);
        Self::pad(&mut pen, (ground, floor), Follow::of(0.0, -1.0, "position"), CONTACT);
    }

    /// The ground and the damper's cylinder.
    fn base(pen: &mut Pen<'_>, floor: f64) -> u32 {
        let body = pen.body("ground", Pose::default(), &[]);
        pen.ground([-1.6 * HALF, 1.6 * HALF], floor);
        let (x, half, top) = (0.5 * HALF, 0.25 * HALF, floor + 0.55 * SPRING);
        let cylinder = [[x - half, top], [x - half, floor], [x + half, floor], [x + half, top]];
        pen.line(Material::Metal, &cylinder);
        body
    }

    /// What the key meets, with the damper's piston and the spring under it.
    fn pad(pen: &mut Pen<'_>, (ground, floor): (u32, f64), y: Follow, modes: &[u8]) {
        let pad = pen.body("wall", Pose::rising(0.0, y), modes);
        pen.fill(Material::Felt, &plate([-HALF, -0.003, HALF, 0.0]));
        let (x, half, low) = (0.5 * HALF, 0.22 * HALF, -0.003 - 0.5 * SPRING);
        pen.line(Material::Metal, &[[x, -0.003], [x, low]]);
        pen.fill(Material::Metal, &plate([x - half, low - 0.001, x + half, low]));
        pen.coil("K", (ground, [-x, floor]), (pad, [-x, -0.003]), modes);
    }
}
