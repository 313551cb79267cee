//! What the catalogue says of a model that was registered.
#![expect(clippy::unwrap_used, reason = "visitors of tests, outside #[test], fail aloud")]

use descriptions::register_model;
use models::catalogue::{self, ModelEntry, Visitor};
use models::draw::{Body, Coil, Ends, Material, Sketch};
use models::registry::{self, Registration};
use models::{ModeCode, Playable};

use crate::ball::{Ball, TABLE};

#[test]
fn an_entry_is_made_of_the_table() {
    let entry = register_model(&TABLE, &Ball, None).unwrap();
    assert_eq!((entry.name, entry.file), ("described-ball", None));
    assert_eq!((entry.input, entry.input_unit), ("floor_height", "m"));
    assert_eq!((entry.states, entry.state_units), (&["y", "v"][..], &["m", "m/s"][..]));
    let titles: Vec<_> = entry.parameters.iter().map(|it| it.title).collect();
    assert_eq!(titles[1..3], ["restitution", "mass of the ball"]);
    // 1 kg less 5 g a key.
    let mass = |key| (entry.presets[0].value)(2, key);
    assert!((mass(0) - 1.0).abs() < 1e-15 && (mass(87) - 0.565).abs() < 1e-15, "{}", mass(87));
    assert!((entry.presets[0].value)(4, 0).is_nan(), "no such parameter");
    let modes: Vec<_> = entry.modes.iter().map(|it| (it.name, it.n, it.m, it.p)).collect();
    assert_eq!(modes, [("flight", 1, 0, 1), ("rest", 1, 1, 0)]);
    let leads = |mode: usize| (entry.modes[mode].guards[0].name, entry.modes[mode].guards[0].to);
    assert_eq!((leads(0), leads(1)), (("floor", &["flight"][..]), ("lift", &["flight"][..])));
}

/// The values of a model as its own parameters are asked for: the weight on the floor (N).
struct Weight(f64);

impl Visitor for Weight {
    type Output = f64;

    fn visit<M: Playable>(self, model: M) -> f64 {
        let model = model.with_values(&[10.0, 0.5, self.0]);
        let mode = model.mode(ModeCode::structural(1)).unwrap();
        assert_eq!(model.mode(ModeCode::structural(2)), None);
        let (_, x) = model.at_rest(&pode::Motion::default());
        model.readout(mode, &x, &pode::Motion::default())
    }
}

#[test]
fn a_newer_version_takes_the_name_and_the_older_one_stays() {
    let versions = [(); 2].map(|()| register_model(&TABLE, &Ball, None).unwrap());
    assert!(!versions[0].is(versions[1]));
    assert!(
        versions.iter().all(|it| catalogue::entries().filter(|is| is.name == it.name).count() == 1)
    );
    let found = catalogue::find("described-ball").unwrap();
    assert!(!found.is(versions[0]), "an older version is not found by its name");
    assert!(catalogue::built_in("described-ball").is_none());
    for (entry, mass) in [(versions[0], 0.3), (versions[1], 0.7)] {
        let weight = catalogue::visit(entry, Weight(mass)).unwrap();
        assert!((weight - 10.0 * mass).abs() < 1e-14, "{weight} N");
    }
    let copy: ModelEntry = *versions[0];
    assert!(catalogue::visit(&copy, Weight(0.3)).is_none(), "a copy is no entry");
}

#[test]
fn what_is_registered_twice_is_there_once() {
    let entry = register_model(&TABLE, &Ball, None).unwrap();
    let functions = models::LoadedFunctions::new(&Ball, entry);
    let again = registry::LoadedModel::new(&TABLE, functions).unwrap();
    let registration: &'static Registration = Box::leak(Box::new(Registration::new(again)));
    registry::register(registration);
    registry::register(registration);
    assert_eq!(catalogue::entries().filter(|it| it.name == entry.name).count(), 1);
}

/// Counts what is drawn, with the modes of each body.
#[derive(Default)]
struct Drawn(Vec<(Vec<u8>, Vec<Option<&'static str>>)>, Vec<(Material, usize)>, usize);

impl Sketch for Drawn {
    fn view(&mut self, _edges: [f64; 4]) {
        self.2 += 1;
    }

    fn body(&mut self, body: Body<'_>) {
        let follows = [body.x, body.y, body.angle].map(|it| it.signal);
        self.0.push((body.modes.to_vec(), follows.to_vec()));
    }

    fn outline(&mut self, material: Material, points: &[[f64; 2]], _ends: Ends) {
        self.1.push((material, points.len()));
    }

    fn coil(&mut self, _coil: Coil<'_>) {}
}

struct Draw;

impl Visitor for Draw {
    type Output = Drawn;

    fn visit<M: Playable>(self, model: M) -> Drawn {
        let mut drawn = Drawn::default();
        model.draw(&mut drawn);
        drawn
    }
}

#[test]
fn a_drawing_follows_the_outputs_and_has_a_body_for_what_some_modes_show() {
    let entry = register_model(&TABLE, &Ball, None).unwrap();
    let drawn = catalogue::visit(entry, Draw).unwrap();
    let follows = vec![Some("ball_x"), Some("ball_y"), Some("ball_angle")];
    assert_eq!(drawn.0, [(vec![], follows.clone()), (vec![1], follows)]);
    assert_eq!(drawn.1, [(Material::Felt, 2), (Material::Metal, 2)]);
    assert_eq!(drawn.2, 1);
}
