//! A drawing by hand and one described, at the same moments.

use std::collections::BTreeMap;

use models::draw::Material;
use models::{Described as _, ModeCode, Playable};
use pode::{Model as _, Motion};

use super::DrawnModel;
use super::shapes::PlacedShapes;
use crate::sketch::Drawing;
use crate::sketch::play::{Moment, film};

/// How closely points agree (m).
const AGREEMENT: f64 = 1e-6;

const MATERIALS: [Material; 6] = [
    Material::Wood,
    Material::Felt,
    Material::Metal,
    Material::String,
    Material::Ground,
    Material::Finger,
];

/// A body or spring that is drawn elsewhere on purpose, and by how much at most at a moment (m).
pub(super) type AllowedDistance = (&'static str, fn(&Moment) -> f64);

/// Both drawings of one model with the same values.
pub(super) struct DrawnPair<W> {
    label: String,
    written: W,
    described: DrawnModel,
    drawings: [Drawing; 2],
}

impl<W: Playable> DrawnPair<W> {
    pub(super) fn new(label: String, written: W, described: &DrawnModel) -> Self {
        let drawings = [Drawing::of(&written), Drawing::of(described)];
        Self { label, written, described: *described, drawings }
    }

    /// The described model in the mode and at the place of the one by hand.
    fn there(&self, moment: &Moment) -> Moment {
        let entry = self.described.entry();
        let mut state = [0.0; 4];
        for (slot, name) in state.iter_mut().zip(entry.states) {
            *slot = moment.signal(name);
        }
        let position = moment.signal("position") * self.described.input_per_metre();
        let input = Motion { position, ..Motion::default() };
        let number = u8::try_from(moment.mode).expect("few modes");
        let mode = self.described.mode(ModeCode::structural(number)).expect("the same modes");
        let state = self.described.constrain(mode, &state, &input);
        Moment::of(&self.described, (mode, state), &input)
    }

    /// Compares views, names and places, at rest and over a stroke.
    #[track_caller]
    pub(super) fn compare(&self, apart: &[AllowedDistance]) {
        let [by_hand, described] = &self.drawings;
        let (ours, theirs) = (described.views[0], by_hand.views[0]);
        for (ours, theirs) in ours.iter().zip(theirs) {
            assert!((ours - theirs).abs() < AGREEMENT, "{}: view {ours} {theirs}", self.label);
        }
        let rest = (0_u8..=10).map(|it| Moment::at_rest(&self.written, 1e-3 * f64::from(it)));
        let film = film(self.written).into_iter().map(|it| it.1);
        let mut worst = BTreeMap::<(String, usize), f64>::new();
        for moment in rest.chain(film) {
            for (name, distance) in self.distances(&moment) {
                let allowed = apart.iter().find(|it| it.0 == name).map_or(0.0, |it| it.1(&moment));
                let known = worst.entry((name, moment.mode)).or_default();
                *known = known.max(distance - allowed);
            }
        }
        let far: Vec<_> = worst.iter().filter(|it| *it.1 >= AGREEMENT).collect();
        assert!(far.is_empty(), "{}: apart by mode (m): {far:#?}", self.label);
    }

    /// How far apart each body and spring is that is shown, by its name (m).
    fn distances(&self, moment: &Moment) -> Vec<(String, f64)> {
        let moments = [moment.clone(), self.there(moment)];
        let shown = [0, 1].map(|i| {
            let parts = self.drawings[i].parts.iter();
            parts.filter(|it| it.is_shown(&moments[i])).collect::<Vec<_>>()
        });
        let names = shown.each_ref().map(|all| all.iter().map(|it| it.name).collect::<Vec<_>>());
        assert_eq!(names[0], names[1], "{}: bodies, from the back", self.label);
        let mut all = Vec::new();
        for (by_hand, described) in shown[0].iter().zip(&shown[1]) {
            for material in MATERIALS {
                let ours = PlacedShapes::of(described, material, &moments[1]);
                let theirs = PlacedShapes::of(by_hand, material, &moments[0]);
                all.push((by_hand.name.to_owned(), ours.distance(&theirs)));
            }
        }
        let [by_hand, described] = [0, 1].map(|i| self.drawings[i].coils(&moments[i]));
        assert_eq!(by_hand.len(), described.len(), "{}: springs", self.label);
        for (spring, ends) in by_hand {
            let name = spring.name;
            let other = described.iter().find(|it| it.0.name == name).expect("the same springs");
            for (a, b) in ends.iter().zip(other.1) {
                all.push((format!("spring {name}"), (a[0] - b[0]).hypot(a[1] - b[1])));
            }
        }
        all
    }
}
