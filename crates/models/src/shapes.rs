//! What drawings are made of: a pen that numbers bodies, and the shapes that they share.

use pode::math::{atan2, hypot, sin_cos, sqrt};

use crate::draw::{Body, Coil, Ends, Follow, Material, Sketch};

/// A point (m).
pub(crate) type Point = [f64; 2];

/// Where a body is: x (m), y (m) and angle (rad).
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Pose {
    pub(crate) x: Follow,
    pub(crate) y: Follow,
    pub(crate) angle: Follow,
}

impl Pose {
    /// Holds still at a point.
    pub(crate) const fn still([x, y]: Point) -> Self {
        Self { x: Follow::fixed(x), y: Follow::fixed(y), angle: Follow::fixed(0.0) }
    }

    /// Turns about a point.
    pub(crate) const fn turning(at: Point, angle: Follow) -> Self {
        Self { angle, ..Self::still(at) }
    }

    /// Goes up and down from a point, by `y`.
    pub(crate) const fn rising(x: f64, y: Follow) -> Self {
        Self { y, ..Self::still([x, 0.0]) }
    }

    /// Goes to and fro from a point, by `x`.
    pub(crate) const fn sliding(x: Follow, y: f64) -> Self {
        Self { x, ..Self::still([0.0, y]) }
    }
}

/// Draws on a sketch and knows the numbers of the bodies.
pub(crate) struct Pen<'a> {
    sketch: &'a mut dyn Sketch,
    bodies: u32,
}

impl<'a> Pen<'a> {
    /// A pen for an empty sketch that shows what is between left, bottom, right, top (m).
    pub(crate) fn new(sketch: &'a mut dyn Sketch, edges: [f64; 4]) -> Self {
        sketch.view(edges);
        Self { sketch, bodies: 0 }
    }

    /// Begins a body that is shown in `modes`, in all if there are none; gives its number.
    pub(crate) fn body(&mut self, name: &'static str, pose: Pose, modes: &[u8]) -> u32 {
        let Pose { x, y, angle } = pose;
        self.sketch.body(Body { name, x, y, angle, modes });
        self.bodies += 1;
        self.bodies - 1
    }

    /// A filled shape of the newest body.
    pub(crate) fn fill(&mut self, material: Material, points: &[Point]) {
        self.sketch.outline(material, points, Ends::Closed);
    }

    /// A line of the newest body.
    pub(crate) fn line(&mut self, material: Material, points: &[Point]) {
        self.sketch.outline(material, points, Ends::Open);
    }

    /// A disc of the newest body.
    pub(crate) fn disc(&mut self, material: Material, centre: Point, radius: f64) {
        self.fill(material, &rim::<24>(centre, radius, 0.0));
    }

    /// A spring between points of two bodies.
    pub(crate) fn coil(
        &mut self,
        name: &'static str,
        from: (u32, Point),
        to: (u32, Point),
        modes: &[u8],
    ) {
        self.sketch.coil(Coil { name, from, to, modes });
    }

    /// A fingertip that comes from above and touches at the origin; `size` is its width (m).
    pub(crate) fn fingertip(&mut self, size: f64) {
        let shape = [
            [-0.25, 0.0],
            [0.25, 0.0],
            [0.45, 0.2],
            [0.5, 0.5],
            [0.35, 1.6],
            [-0.55, 1.6],
            [-0.5, 0.4],
            [-0.42, 0.12],
        ];
        self.fill(Material::Finger, &shape.map(|point| point.map(|it| it * size)));
    }

    /// What does not move under a body: a line with strokes below, from `left` to `right`.
    pub(crate) fn ground(&mut self, [left, right]: [f64; 2], y: f64) {
        const STROKES: u8 = 9;
        let pitch = (right - left) / f64::from(STROKES);
        self.line(Material::Ground, &[[left, y], [right, y]]);
        for stroke in 1..=STROKES {
            let x = left + pitch * f64::from(stroke);
            self.line(Material::Ground, &[[x, y], [x - 0.7 * pitch, y - 0.7 * pitch]]);
        }
    }
}

/// Corners of a rectangle, from left, bottom, right, top (m).
pub(crate) const fn plate([left, bottom, right, top]: [f64; 4]) -> [Point; 4] {
    [[left, bottom], [right, bottom], [right, top], [left, top]]
}

/// Points on a circle, anticlockwise from the direction `first` (rad).
pub(crate) fn rim<const N: usize>([x, y]: Point, radius: f64, first: f64) -> [Point; N] {
    let step = core::f64::consts::TAU / N as f64;
    core::array::from_fn(|i| {
        let (sin, cos) = sin_cos(first + step * i as f64);
        [x + radius * cos, y + radius * sin]
    })
}

/// Felt of a hammer's head, upright, with the point that strikes at the origin; `size` is
/// its half width (m).
pub(crate) fn felt(size: f64) -> [Point; 15] {
    const SIDE: [Point; 3] = [[1.0, -1.4], [0.9, -2.4], [0.5, -3.4]];
    const ROUND: f64 = 0.8;
    core::array::from_fn(|i| {
        let [x, y] = match i {
            0..3 => SIDE[2 - i],
            12.. => [-SIDE[i - 12][0], SIDE[i - 12][1]],
            _ => {
                // Nine points over the crown; the fifth is the top.
                let (sin, cos) = sin_cos(0.33 * (i as f64 - 7.0));
                [-ROUND * sin, ROUND * (cos - 1.0)]
            }
        };
        [x * size, y * size]
    })
}

/// A point turned by `angle` (rad) about the origin.
pub(crate) fn turned(angle: f64, [x, y]: Point) -> Point {
    let (sin, cos) = sin_cos(angle);
    [x * cos - y * sin, x * sin + y * cos]
}

/// a + b.
pub(crate) fn sum(a: Point, b: Point) -> Point {
    [a[0] + b[0], a[1] + b[1]]
}

/// a − b.
pub(crate) fn difference(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

/// The smaller angle (rad) by which `point` is turned to the height `y` (m); as near as it
/// gets if it does not reach it.
pub(crate) fn raised(point: Point, y: f64) -> f64 {
    let reach = hypot(point[0], point[1]);
    let sine = (y / reach).clamp(-1.0, 1.0);
    let ahead = atan2(sine, sqrt(1.0 - sine * sine));
    // A point on the left of its pivot comes up as it turns clockwise.
    if point[0] < 0.0 {
        atan2(point[1], -point[0]) - ahead
    } else {
        ahead - atan2(point[1], point[0])
    }
}

/// What is `first` at one value of `signal` and `last` at another.
pub(crate) fn through(signal: &'static str, first: (f64, f64), last: (f64, f64)) -> Follow {
    let span = last.0 - first.0;
    // Parameters may leave no room between the two: then it is there at the first and still.
    let scale = if span == 0.0 { 0.0 } else { (last.1 - first.1) / span };
    Follow::of(first.1 - scale * first.0, scale, signal)
}
