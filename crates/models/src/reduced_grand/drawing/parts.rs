//! Key, whippen, hammer and finger.

use super::super::ReducedGrand;
use super::places::{
    BORE, CAPSTAN, CAPSTAN_TOP, FRONT, HALF_KEY, HEAD, HEEL, KNUCKLE, KNUCKLE_DROP, Places, at,
};
use crate::draw::{Follow, Material};
use crate::shapes::{Pen, Point, Pose, felt, plate, rim, sum, turned};

/// The finger's place on the key, from its front (m).
const TOUCH: f64 = 0.013;
/// Length of the coupling's spring, which no action has (m).
const COUPLING: f64 = 0.014;
/// The check leans back by so much (rad) (E).
const LEAN: f64 = 0.25;
/// Where the check meets the tail, in the head's axes (m) (E).
const TAIL: Point = [0.009, -0.020];

impl Places {
    /// The stick with its leads, the capstan and the back check.
    pub(super) fn draw_key(&self, pen: &mut Pen<'_>, model: &ReducedGrand) -> u32 {
        let check = self.check(model);
        let body = pen.body("key", Pose::turning([0.0, 0.0], self.key), &[]);
        pen.fill(Material::Wood, &plate([-FRONT, -HALF_KEY, check[0] + 0.012, HALF_KEY]));
        if model.values().key_weight < 0.0 {
            pen.disc(Material::Metal, [-0.62 * FRONT, 0.0], 0.006);
            pen.disc(Material::Metal, [-0.42 * FRONT, 0.0], 0.006);
        }
        pen.disc(Material::Metal, [0.0, 0.0], 0.002);
        let neck = plate([CAPSTAN - 0.0015, HALF_KEY, CAPSTAN + 0.0015, CAPSTAN_TOP - 0.004]);
        pen.fill(Material::Metal, &neck);
        let up = core::f64::consts::FRAC_PI_2;
        let dome = rim::<24>([CAPSTAN, CAPSTAN_TOP - 0.004], 0.004, up);
        pen.fill(Material::Metal, &dome);
        draw_check(pen, check);
        body
    }

    /// Where the check holds the tail, in the key's axes: right in the middle of its range.
    fn check(&self, model: &ReducedGrand) -> Point {
        let y = 0.5 * (model.values().check_off + model.values().bed);
        let tail = self.on_hammer(model.in_check(y).height, self.in_head(TAIL));
        turned(-at(&self.key, y), tail)
    }

    /// The whippen with its heel and the lever's post.
    pub(super) fn draw_whippen(&self, pen: &mut Pen<'_>) -> u32 {
        let pose = Pose::turning(self.whippen_pin, self.whippen);
        let body = pen.body("whippen", pose, &[]);
        let ([jack, _], [heel, _], [post, top]) = (Self::JACK_PIN, Self::HEEL, Self::POST);
        let shape = [
            [0.006, -0.004],
            [0.006, 0.004],
            [post + 0.006, 0.006],
            [post + 0.003, top],
            [post - 0.003, top],
            [post - 0.005, 0.006],
            [jack + 0.007, 0.006],
            [jack + 0.004, 0.004],
            [jack - 0.006, 0.0],
            [jack - 0.005, -0.007],
            [heel - 0.006, -0.007],
            [heel - 0.005, 0.002 - HEEL],
            [heel + 0.005, 0.002 - HEEL],
            [heel + 0.006, -0.006],
        ];
        pen.fill(Material::Wood, &shape);
        pen.fill(Material::Felt, &plate([heel - 0.005, -HEEL, heel + 0.005, 0.002 - HEEL]));
        pen.disc(Material::Metal, [0.0, 0.0], 0.002);
        body
    }

    /// Shank, knuckle and head, whose point stands upright at the string.
    pub(super) fn draw_hammer(&self, pen: &mut Pen<'_>) {
        pen.body("hammer", Pose::turning(self.hammer_pin, self.hammer), &[]);
        let butt = self.knuckle + 0.008;
        pen.fill(
            Material::Wood,
            &[
                [-0.004, -0.004],
                [butt, -0.005],
                [butt + 0.006, -0.003],
                [HEAD, -0.003],
                [HEAD, 0.003],
                [-0.004, 0.004],
            ],
        );
        let up = core::f64::consts::FRAC_PI_2;
        let middle = [self.knuckle, -KNUCKLE_DROP];
        pen.fill(Material::Wood, &plate([middle[0] - 0.001, middle[1], middle[0] + 0.001, -0.005]));
        pen.fill(Material::Felt, &rim::<24>(middle, KNUCKLE, up));
        self.draw_head(pen);
        pen.disc(Material::Metal, [0.0, 0.0], 0.002);
    }

    /// The moulding with its tail, and the felt.
    fn draw_head(&self, pen: &mut Pen<'_>) {
        let moulding = [
            [-0.004, BORE - 0.014],
            [-0.005, -0.010],
            [-0.004, -0.024],
            [-0.001, -0.027],
            [0.006, -0.026],
            TAIL,
            [0.0085, -0.014],
            [0.005, 0.002],
            [0.004, BORE - 0.014],
        ];
        pen.fill(Material::Wood, &moulding.map(|point| self.in_head(point)));
        let top = [0.0, BORE];
        pen.fill(Material::Felt, &felt(0.0105).map(|point| self.in_head(sum(top, point))));
    }

    /// The finger above the key's front, on the spring that couples it.
    pub(super) fn draw_finger(&self, pen: &mut Pen<'_>, key: u32) {
        let touch = [TOUCH - FRONT, HALF_KEY];
        let [x, y] = self.on_key(0.0, touch);
        let pose = Pose::rising(x, Follow::of(y + COUPLING, -1.0, "position"));
        let finger = pen.body("finger", pose, &[]);
        pen.fingertip(0.016);
        pen.coil("k1", (key, touch), (finger, [0.0, 0.0]), &[]);
    }
}

/// A wire with a pad that leans back; `face` is where the tail meets it.
fn draw_check(pen: &mut Pen<'_>, face: Point) {
    let place = |point| sum(face, turned(-LEAN, point));
    let foot = [face[0] + 0.004, HALF_KEY];
    pen.line(Material::Metal, &[foot, place([0.006, -0.008])]);
    pen.fill(Material::Wood, &plate([0.003, -0.014, 0.009, 0.007]).map(place));
    pen.fill(Material::Felt, &plate([0.0, -0.014, 0.003, 0.007]).map(place));
}
