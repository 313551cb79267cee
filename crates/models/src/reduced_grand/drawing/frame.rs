//! What stands still: rails, screws, felts and the string.

use super::super::{ReducedGrand, ReducedGrandValues};
use super::places::{FRONT, HALF_KEY, Places};
use crate::draw::Material;
use crate::shapes::{Pen, Point, Pose, plate, sum, turned};

/// Half the thickness of the felts under the key (m).
const FELT: f64 = 0.005;

impl Places {
    pub(super) fn draw_frame(&self, pen: &mut Pen<'_>, model: &ReducedGrand) {
        let p = model.values();
        pen.body("string", Pose::default(), &[]);
        let [x, y] = self.string;
        pen.line(Material::String, &[[x - 0.20, y], [0.275, y]]);
        self.key_frame(pen, p);
        self.hammer_rail(pen, model);
        self.let_off_rail(pen, p);
        pen.body("whippen rail", Pose::still(self.whippen_pin), &[]);
        pen.fill(
            Material::Wood,
            &[[-0.002, -0.003], [0.006, -0.003], [0.012, 0.012], [0.004, 0.012]],
        );
        pen.fill(Material::Ground, &plate([0.001, 0.012, 0.016, 0.022]));
    }

    /// The balance rail with its pin, the bed's felt under the front, the rest's at the back.
    fn key_frame(&self, pen: &mut Pen<'_>, p: &ReducedGrandValues) {
        pen.body("key frame", Pose::default(), &[]);
        let low = -HALF_KEY - 0.016;
        let wedge = [
            [0.0, -HALF_KEY],
            [-0.012, low + 0.006],
            [-0.012, low],
            [0.012, low],
            [0.012, low + 0.006],
        ];
        pen.fill(Material::Ground, &wedge);
        pen.line(Material::Metal, &[[0.0, -HALF_KEY], [0.0, HALF_KEY + 0.004]]);
        let front = self.on_key(p.bed, [0.02 - FRONT, -HALF_KEY]);
        let back = self.on_key(0.0, [0.215, -HALF_KEY]);
        for [x, y] in [front, back] {
            pen.fill(Material::Felt, &plate([x - 2.0 * FELT, y - FELT, x + 2.0 * FELT, y]));
        }
    }

    /// The flange at the hammer's pin, with the drop screw.
    fn hammer_rail(&self, pen: &mut Pen<'_>, model: &ReducedGrand) {
        let [x, y] = self.hammer_pin;
        pen.body("hammer rail", Pose::default(), &[]);
        pen.fill(Material::Ground, &plate([x - 0.045, y - 0.006, x - 0.018, y + 0.010]));
        let flange = [[-0.018, -0.005], [0.003, -0.003], [0.003, 0.003], [-0.018, 0.006]];
        pen.fill(Material::Wood, &flange.map(|point| sum([x, y], point)));
        let [screw, end] = self.drop_screw(model);
        pen.line(Material::Metal, &[[screw, y], [screw, end]]);
        pen.fill(Material::Metal, &plate([screw - 0.002, end, screw + 0.002, end + 0.002]));
    }

    /// The rail with the let-off button over the tender.
    fn let_off_rail(&self, pen: &mut Pen<'_>, p: &ReducedGrandValues) {
        let button = self.button(p);
        let slope = self.slope_at_button(p);
        let place = |point: Point| sum(button, turned(slope, point));
        pen.body("let-off button", Pose::default(), &[]);
        pen.fill(Material::Ground, &plate([-0.034, 0.006, -0.008, 0.022]).map(place));
        pen.line(Material::Metal, &[[-0.008, 0.010], [0.0, 0.010], [0.0, 0.003]].map(place));
        pen.fill(Material::Felt, &plate([-0.003, 0.0, 0.003, 0.004]).map(place));
    }
}
