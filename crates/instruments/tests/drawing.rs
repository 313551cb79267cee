//! Drawings of the models: complete, named, and always in view.

use instruments::{Described as _, ModelEntry, Playable, SmallModel};

use crate::every_model::small;
use crate::sketch::play::{Moment, film};
use crate::sketch::{Drawing, Part, Point};
use crate::stroke::{tuned, values};

fn presets() -> impl Iterator<Item = (String, SmallModel)> {
    let of = |model: SmallModel| {
        let ModelEntry { name: known, presets, .. } = model.entry();
        let keys = presets.iter().flat_map(|it| [0, 87].map(|key| (it.name, key)));
        let tuned = keys.map(|(name, key)| {
            (format!("{known} {name} key {key}"), tuned(&model, name, key, &[]))
        });
        tuned.collect::<Vec<_>>()
    };
    small().flat_map(of)
}

#[test]
fn every_signal_has_a_unit() {
    for entry in crate::every_model::all() {
        assert_eq!(entry.states.len(), entry.state_units.len(), "{}: states", entry.name);
        assert_eq!(entry.outputs.len(), entry.output_units.len(), "{}: outputs", entry.name);
        let mut guards = entry.modes.iter().flat_map(|mode| &mode.guards).map(|it| it.unit);
        // A computed angle is a ratio, as all its units are.
        assert!(guards.all(|it| ["m", "1", "N", "m/s²"].contains(&it)), "{}", entry.name);
        let units = ["m", "m/s", "rad", "rad/s", "N", "N·m"];
        let all = entry.state_units.iter().chain(&entry.output_units);
        assert!(all.into_iter().all(|unit| units.contains(unit)), "{}: a new unit", entry.name);
        let forces = entry.outputs.iter().zip(&entry.output_units);
        for (name, unit) in forces {
            let first = name.chars().next().expect("a name");
            let by_name = if first == 'T' { "N·m" } else { "N" };
            assert!(!first.is_uppercase() || *unit == by_name, "{}: {name}", entry.name);
        }
    }
}

#[test]
fn a_drawing_names_only_what_its_model_has() {
    for (label, model) in presets() {
        let drawing = Drawing::of(&model);
        assert_eq!(drawing.views.len(), 1, "{label}: views");
        assert!(drawing.parts.len() > 2, "{label}: parts");
        let ModelEntry { states, outputs, modes: listed, .. } = model.entry();
        let known =
            |name: &str| name == "position" || states.contains(&name) || outputs.contains(&name);
        for part in &drawing.parts {
            assert!(!part.outlines.is_empty(), "{label}: {} has no shape", part.name);
            assert!(part.outlines.iter().all(|it| it.points.len() > 1), "{label}: {}", part.name);
            let mut signals = part.pose.iter().filter_map(|it| it.signal);
            assert!(signals.all(known), "{label}: {} follows what is not", part.name);
        }
        for spring in &drawing.springs {
            assert!(spring.ends.iter().all(|end| end.0 < drawing.parts.len()), "{label}: ends");
            let [from, to] = spring.ends.map(|end| &drawing.parts[end.0]);
            let is_shown = |modes: &[u8]| {
                modes.is_empty() || spring.modes.iter().all(|mode| modes.contains(mode))
            };
            assert!(is_shown(&from.modes) && is_shown(&to.modes), "{label}: {} hangs", spring.name);
        }
        let modes = drawing.parts.iter().map(|it| &it.modes);
        let mut modes = modes.chain(drawing.springs.iter().map(|it| &it.modes)).flatten();
        assert!(modes.all(|mode| usize::from(*mode) < listed.len()), "{label}: modes");
        let [up, down] = [0.0, 0.005].map(|down| pressed(&model, down));
        let mut parts = drawing.parts.iter().filter(|it| it.is_shown(&up));
        assert!(parts.any(|it| it.points(&up) != it.points(&down)), "{label}: no finger");
    }
}

#[test]
fn a_drawing_is_finite_whatever_the_values() {
    for (label, model) in presets() {
        let ModelEntry { parameters, presets, .. } = model.entry();
        let values = values(&presets[0], parameters.len(), 0);
        for (index, parameter) in parameters.iter().enumerate() {
            for value in [parameter.range.0, 0.0_f64.max(parameter.range.0), parameter.range.1] {
                let mut values = values.clone();
                values[index] = value;
                let drawing = Drawing::of(&model.with_values(&values));
                let what = format!("{label}, {} = {value}", parameter.name);
                let [left, bottom, right, top] = drawing.views[0];
                assert!(left < right && bottom < top, "{what}: {:?}", drawing.views[0]);
                assert!((right - left + top - bottom).is_finite(), "{what}: the view");
                let follows = drawing.parts.iter().flat_map(|it| it.pose);
                let numbers = follows.flat_map(|it| [it.offset, it.scale]);
                let lines = drawing.parts.iter().flat_map(|it| &it.outlines);
                let points = lines.flat_map(|it| it.points.iter().flatten().copied());
                assert!(numbers.chain(points).all(f64::is_finite), "{what}: a number");
            }
        }
    }
}

#[test]
fn each_part_is_shown_once_in_every_mode() {
    for (label, model) in presets() {
        let drawing = Drawing::of(&model);
        let mut moment = Moment::at_rest(&model, 0.0);
        for mode in 0..model.entry().modes.len() {
            moment.mode = mode;
            for part in &drawing.parts {
                let twins = drawing.parts.iter().filter(|it| it.name == part.name);
                let shown = twins.filter(|it| it.is_shown(&moment)).count();
                assert_eq!(shown, 1, "{label}: {} in mode {mode}", part.name);
            }
        }
    }
}

#[test]
fn everything_stays_in_view_along_a_stroke() {
    for (label, model) in presets() {
        let drawing = Drawing::of(&model);
        let [left, bottom, right, top] = drawing.views[0];
        assert!(left < right && bottom < top, "{label}: {:?}", drawing.views[0]);
        let still = (0_u8..=10).map(|down| Moment::at_rest(&model, 1e-3 * f64::from(down)));
        let moments = still.chain(film(&model).into_iter().map(|it| it.1));
        for moment in moments {
            for part in drawing.parts.iter().filter(|it| it.is_shown(&moment)) {
                for [x, y] in part.points(&moment) {
                    let is_in = (left..=right).contains(&x) && (bottom..=top).contains(&y);
                    assert!(
                        is_in,
                        "{label}: {} at {x}, {y}, {:?}, {moment:?}",
                        part.name, drawing.views
                    );
                }
            }
        }
    }
}

#[test]
fn a_key_s_front_goes_down_by_the_position() {
    for (label, model) in presets() {
        let drawing = Drawing::of(&model);
        let Some(key) = drawing.parts.iter().find(|it| it.name == "key") else { return };
        // Its front is 97 mm from a pivot in a stick of 4 m, which is thicker than 97 mm.
        if label.contains("literal") {
            continue;
        }
        // The paper's lever of 97 mm turns by 3° at 5 mm.
        let farthest = if label.contains("paper") { 0.005 } else { 0.01 };
        let up = pressed(&model, 0.0);
        for down in [0.002, 0.005, farthest] {
            let moment = pressed(&model, down);
            let sunk = front(key, &up) - front(key, &moment);
            assert!((sunk / down - 1.0).abs() < 0.02, "{label}: {sunk} m for {down} m");
            let finger = |moment| drawing.part("finger", moment).points(moment)[0][1];
            let sunk = finger(&up) - finger(&moment);
            assert!((sunk - down).abs() < 1e-12, "{label}: the finger sinks {sunk} m");
        }
    }
}

/// Returns the moment with the key at `down` (m) and all else at rest, so that no spring counts.
fn pressed<M: Playable>(model: &M, down: f64) -> Moment {
    let keys = [("y", down), ("theta_k", down * model.input_per_metre())];
    let is_one = |it: &(&str, f64)| model.entry().states.contains(&it.0);
    let keys: Vec<_> = keys.into_iter().filter(is_one).collect();
    Moment::posed(model, 0, down, &keys)
}

fn front(key: &Part, moment: &Moment) -> f64 {
    let own = key.outlines.iter().flat_map(|it| &it.points).copied();
    let before = |a: Point, b: Point| if (b[0], -b[1]) < (a[0], -a[1]) { b } else { a };
    key.place(moment, own.reduce(before).expect("points"))[1]
}
