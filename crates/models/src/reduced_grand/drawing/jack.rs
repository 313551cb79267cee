//! The jack, which goes with the whippen, turns on its button, or is out.

use super::super::{ReducedGrand, ReducedGrandValues};
use super::places::{EDGE, JACK, KNUCKLE, Places, TENDER, TENDER_TOP, at};
use super::{ON_BUTTON, TRIPPED, UNDER};
use crate::draw::{Follow, Material};
use crate::shapes::{Pen, Point, Pose, rim, sum, through};

impl Places {
    pub(super) fn draw_jack(&self, pen: &mut Pen<'_>, model: &ReducedGrand) {
        let p = model.values();
        pen.body("jack", Pose::turning(self.whippen_pin, self.whippen), UNDER);
        outline(pen, Self::JACK_PIN);
        let pin = self.jack_pin(p);
        // The button holds the tender's end while the pin rises.
        let rise = |y: f64| self.on_whippen(y, Self::JACK_PIN)[1];
        let per_travel = if p.bed > p.button {
            (rise(p.bed) - rise(p.button)) / (p.bed - p.button) / TENDER
        } else {
            0.0
        };
        let Follow { offset, scale, .. } = self.whippen;
        let turn = Follow::of(offset - per_travel * p.button, scale + per_travel, "y");
        pen.body("jack", Pose { angle: turn, ..pin }, ON_BUTTON);
        outline(pen, [0.0; 2]);
        // Pushed out by the knuckle beside it, if not by the button.
        let clear = (KNUCKLE + 2.0 * EDGE) / JACK;
        let out = clear.max(per_travel * (p.bed - p.button));
        let turn = Follow::of(offset + out, scale, "y");
        pen.body("jack", Pose { angle: turn, ..pin }, TRIPPED);
        outline(pen, [0.0; 2]);
    }

    /// The jack's pin as a body of its own, from where the jack slips back to the bed: the
    /// chord of a flat arc.
    pub(super) fn jack_pin(&self, p: &ReducedGrandValues) -> Pose {
        let height = |y: f64| (y, self.on_whippen(y, Self::JACK_PIN)[1]);
        let y = through("y", height(p.reset), height(p.bed));
        Pose::rising(self.on_whippen(p.button, Self::JACK_PIN)[0], y)
    }

    /// Where the tender's end meets the button.
    pub(super) fn button(&self, p: &ReducedGrandValues) -> Point {
        self.on_whippen(p.button, sum(Self::JACK_PIN, [-TENDER, TENDER_TOP]))
    }

    /// The whippen's angle where the jack meets the button (rad).
    pub(super) fn slope_at_button(&self, p: &ReducedGrandValues) -> f64 {
        at(&self.whippen, p.button)
    }
}

/// An L on its pin: the arm with its rounded edge under the knuckle, and the tender.
fn outline(pen: &mut Pen<'_>, pin: Point) {
    let top = JACK - EDGE;
    let shape = [
        [0.003, -0.004],
        [EDGE, 0.3 * JACK],
        [EDGE, top],
        [0.87 * EDGE, top + 0.5 * EDGE],
        [0.5 * EDGE, top + 0.87 * EDGE],
        [0.0, JACK],
        [-1.6 * EDGE, JACK - 0.2 * EDGE],
        [-1.6 * EDGE, 0.3 * JACK],
        [-0.005, TENDER_TOP],
        [-TENDER - 0.002, TENDER_TOP],
        [-TENDER - 0.002, 0.002],
        [-0.004, -0.004],
    ];
    pen.fill(Material::Wood, &shape.map(|point| sum(pin, point)));
    pen.fill(Material::Metal, &rim::<12>(pin, 0.0015, 0.0));
}
