//! What the bouncing ball looks like: a lever whose far end is the floor.

use pode::math::cbrt;

use super::BouncingBall;
use crate::draw::{Follow, Material, Sketch};
use crate::shapes::{Pen, Pose, plate, rim};

/// Travel of the key's front that there is room for (m).
const TRAVEL: f64 = 0.012;
/// Speed of a key's front in a hard blow (m/s).
const BLOW: f64 = 0.5;
/// Of rubber that just floats (kg/m³).
const DENSITY: f64 = 1000.0;

/// The measures of a drawing (m).
#[derive(Clone, Copy, Debug)]
struct BallDimensions {
    /// Radius of the ball.
    ball: f64,
    /// Pivot to the key's front.
    front: f64,
    /// Pivot to the paddle; negative on the front's side.
    paddle: f64,
    /// Half the thickness of the lever.
    half: f64,
}

impl BouncingBall {
    fn look(&self) -> BallDimensions {
        let ball = cbrt(0.75 * self.mass / (DENSITY * core::f64::consts::PI));
        let length = (10.0 * ball).max(0.25 * self.y0).max(0.2);
        // The lever turns by so little that its end and the paddle stay together.
        let front = (length / (1.0 + self.scale.abs())).max(4.0 * TRAVEL);
        BallDimensions { ball, front, paddle: front * self.scale, half: 0.02 * length }
    }

    /// The highest place that a thrown or dropped ball gets to (m).
    fn highest(&self) -> f64 {
        let speed = BLOW * self.scale;
        let thrown = 0.5 * speed * speed / self.g.max(1.0);
        1.1 * (self.y0.max(thrown) + TRAVEL * self.scale.abs())
    }

    /// The floor at height 0 with the key up.
    pub(super) fn sketch(&self, sketch: &mut dyn Sketch) {
        let look = self.look();
        let BallDimensions { ball, front, paddle, half } = look;
        let wide = 1.6 * ball;
        let down = TRAVEL * (1.0 + self.scale.abs());
        let mut pen = Pen::new(
            sketch,
            [
                (-front).min(paddle - wide) - 2.0 * half,
                -6.5 * half - down,
                (paddle + wide).max(0.0) + 2.0 * half,
                (self.highest() + 2.0 * ball).max(6.0 * half),
            ],
        );
        Self::lever(&mut pen, &look);
        pen.body("paddle", Pose::rising(paddle, Follow::of(0.0, self.scale, "position")), &[]);
        pen.fill(Material::Wood, &plate([-wide, -half, wide, 0.0]));
        pen.body("ball", Pose::rising(paddle, Follow::of(ball, 1.0, "y")), &[]);
        let down = -core::f64::consts::FRAC_PI_2;
        pen.fill(Material::Felt, &rim::<48>([0.0, 0.0], ball, down));
        let finger = Pose::rising(0.8 * half - front, Follow::of(-half, -1.0, "position"));
        pen.body("finger", finger, &[]);
        pen.fingertip(3.0 * half);
    }

    /// The key, which turns about a wedge.
    fn lever(pen: &mut Pen<'_>, look: &BallDimensions) {
        let BallDimensions { front, paddle, half, .. } = *look;
        pen.body("pivot", Pose::default(), &[]);
        let foot = -6.0 * half;
        pen.fill(Material::Ground, &[[0.0, -2.0 * half], [-2.0 * half, foot], [2.0 * half, foot]]);
        let turning = Follow::of(0.0, 1.0 / front, "position");
        pen.body("key", Pose::turning([0.0, -2.0 * half], turning), &[]);
        pen.fill(Material::Wood, &plate([-front, -half, paddle.max(0.0), half]));
        pen.disc(Material::Metal, [0.0, 0.0], 0.5 * half);
    }
}
