//! The described grand's repetition lever, where the one by hand is drawn for a middle place.

use models::reduced_grand::Mode;

use super::model_c;
use crate::sketch::play::{Moment, film};
use crate::sketch::{Drawing, Point};
use crate::stroke::tuned;

/// From the lever's pin to where the knuckle lies, and to where the drop screw presses (m).
const SEAT: Point = [-0.032, 0.003];
const SCREW: Point = [-0.045, 0.003];

fn height(modes: &[Mode], moment: &Moment, of: f64) -> Option<f64> {
    modes.iter().any(|it| *it as usize == moment.mode).then_some(of)
}

#[test]
fn the_lever_is_on_its_post_and_under_the_knuckle_or_the_screw() {
    for (preset, key) in [("default", 0), ("playable", 0), ("playable", 87)] {
        let model = tuned(&model_c(), preset, key, &[]);
        let drawing = Drawing::of(&model);
        let mut loaded = 0;
        for (_, moment) in film(model) {
            let part = |name: &str| drawing.part(name, &moment);
            let lever = part("repetition lever");
            // The post's top is the fourth and fifth corner of the whippen.
            let post = part("whippen").placed(&moment, 0);
            let pin = lever.place(&moment, [0.0, 0.0]);
            let off = [0, 1].map(|i| pin[i] - 0.5 * (post[3][i] + post[4][i]));
            assert!(off[0].hypot(off[1]) < 1e-9, "{off:?} m off its post at {moment:?}");
            let seat = lever.place(&moment, SEAT)[1];
            let knuckle = part("hammer").placed(&moment, 2);
            let lowest = knuckle.iter().map(|it| it[1]).fold(f64::INFINITY, f64::min);
            let bearing = [Mode::RepH, Mode::RepL, Mode::Rep0, Mode::Chk];
            if let Some(lowest) = height(&bearing, &moment, lowest) {
                loaded += 1;
                // A rim of 24 corners turns with the shank: its lowest is within 0.9 % of 4.5 mm.
                assert!((seat - lowest).abs() < 5e-5, "seat {seat}, knuckle {lowest}");
            }
        }
        assert!(loaded > 10, "{loaded} moments on the lever");
        let down = model_c_at_drop(preset, key);
        let moment = Moment::posed(&model, Mode::Flt as usize, 0.0, &[("y", down)]);
        let screw = drawing.part("hammer rail", &moment).placed(&moment, 2)[1];
        let end = drawing.part("repetition lever", &moment).place(&moment, SCREW);
        let apart = (screw[0] - end[0]).hypot(screw[1] - end[1]);
        assert!(apart < 1e-9, "{apart} m between lever and drop screw");
    }
}

/// The key's travel at which the lever meets the drop screw (m).
fn model_c_at_drop(preset: &str, key: u8) -> f64 {
    crate::stroke::parameter(&model_c(), (preset, key), "yd")
}
