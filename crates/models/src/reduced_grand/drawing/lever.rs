//! The repetition lever, its spring, and what it rests on.

use super::super::{ReducedGrand, ReducedGrandValues};
use super::places::{HEAD, JACK, Places};
use super::{LEVER_DROPPED, LEVER_FREE, LEVER_LOADED, LEVER_PRESSED};
use crate::draw::{Follow, Material};
use crate::shapes::{Pen, Point, Pose, difference, raised, sum, through, turned};

/// From where the knuckle lies to the lever's pin on its post (m) (E).
const ARM: f64 = 0.032;
/// The pin below the lever's upper side (m).
const BELOW: f64 = 0.003;
/// From where the knuckle lies to where the drop screw presses (m) (E).
const TO_SCREW: f64 = 0.013;
/// Where the spring presses the lever, from the knuckle (m).
const SPRING: Point = [0.016, -0.006];

impl Places {
    /// Where the knuckle lies on the pressed lever, in the whippen's axes.
    const SEAT: Point = [Self::JACK_PIN[0], JACK];
    /// The lever's pin in the whippen's axes.
    pub(super) const POST: Point = [Self::SEAT[0] + ARM, Self::SEAT[1] - BELOW];

    pub(super) fn draw_lever(&self, pen: &mut Pen<'_>, model: &ReducedGrand, whippen: u32) {
        let p = model.values();
        let with_whippen = Pose::turning(self.whippen_pin, self.whippen);
        // The lever's free end is o_r higher, measured at the head.
        let raise = -p.lever_offset * self.knuckle / HEAD / ARM;
        Self::one(pen, with_whippen, (Self::SEAT, 0.0), whippen, LEVER_PRESSED);
        Self::one(pen, with_whippen, (Self::SEAT, raise), whippen, LEVER_FREE);
        let dropped = self.dropped(model);
        Self::one(pen, dropped, ([0.0; 2], 0.0), whippen, LEVER_DROPPED);
        let loaded = self.loaded(model);
        Self::one(pen, loaded, ([0.0; 2], 0.0), whippen, LEVER_LOADED);
    }

    /// Where the knuckle lies on a lever that the drop screw holds.
    fn highest_seat(&self, model: &ReducedGrand) -> Point {
        self.under_knuckle(model.lever(model.values().bed).height)
    }

    /// Turned so that a lever whose seat is at this height lies on its post (rad).
    fn slope(&self, y: f64, seat: f64) -> f64 {
        raised([ARM, -BELOW], self.on_whippen(y, Self::POST)[1] - seat)
    }

    /// Held by the drop screw: the key lifts its post.
    fn dropped(&self, model: &ReducedGrand) -> Pose {
        let p = model.values();
        let seat = self.highest_seat(model);
        let slope = |y: f64| (y, self.slope(y, seat[1]));
        let angle = through("y", slope(p.reset), slope(p.bed));
        Pose::turning([self.seat_x(p), seat[1]], angle)
    }

    /// Under the knuckle: it goes with the head, and its post is where it is on the average.
    fn loaded(&self, model: &ReducedGrand) -> Pose {
        let p = model.values();
        let key = 0.5 * (p.reset + p.bed);
        let (low, high) = (p.check_height, model.lever(p.bed).height);
        let seat = |z: f64| (z, self.under_knuckle(z)[1]);
        let slope = |z: f64| (z, self.slope(key, seat(z).1));
        Pose {
            x: Follow::fixed(self.seat_x(p)),
            y: through("z", seat(low), seat(high)),
            angle: through("z", slope(low), slope(high)),
        }
    }

    /// Where the seat is on the way between the jack's reset and the bed (m).
    fn seat_x(&self, p: &ReducedGrandValues) -> f64 {
        self.on_whippen(0.5 * (p.reset + p.bed), Self::SEAT)[0]
    }

    /// The lever with its seat at a place of the body, turned about its pin by `raise`.
    fn one(pen: &mut Pen<'_>, pose: Pose, (seat, raise): (Point, f64), whippen: u32, modes: &[u8]) {
        let post = [ARM, -BELOW];
        let place = |point| {
            let about = turned(raise, difference(point, post));
            sum(sum(seat, post), about)
        };
        let body = pen.body("repetition lever", pose, modes);
        let front = -TO_SCREW - 0.006;
        let shape = [
            [front, 0.0],
            [front, -0.004],
            [0.006, -0.0055],
            [ARM, -0.0075],
            [ARM + 0.018, -0.005],
            [ARM + 0.018, -0.001],
            [ARM - 0.006, 0.0],
        ];
        pen.fill(Material::Wood, &shape.map(place));
        pen.disc(Material::Metal, place(post), 0.0015);
        let from = [Self::POST[0] - 0.013, 0.006];
        pen.coil("kr", (whippen, from), (body, place(SPRING)), modes);
    }

    /// Where the drop screw ends.
    pub(super) fn drop_screw(&self, model: &ReducedGrand) -> Point {
        let p = model.values();
        let seat = self.highest_seat(model);
        let slope = self.slope(p.drop, seat[1]);
        sum([self.seat_x(p), seat[1]], turned(slope, [-TO_SCREW, 0.0]))
    }
}
