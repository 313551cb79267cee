//! The drawings as the descriptions give them, beside those by hand: the same bodies, at the same
//! places, all along a stroke.
#![expect(
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a test has the heap, and fails aloud"
)]

mod action;
mod comparison;
mod shapes;

use equations::table::{Functions, ModelTable};
use equations::{EquationModel, ModeNumber};
use models::{
    BouncingBall, CartPendulum, Described as _, KeyHammerRigid, KeyHammerSprings, LoadedFunctions,
    ModelEntry, Playable, ReducedGrand, SpringWall, bouncing_ball, cart_pendulum, key_hammer_rigid,
    key_hammer_springs, reduced_grand, spring_wall,
};

use pode::Motion;

use self::comparison::{AllowedDistance, DrawnPair};
use crate::drawing;
use crate::sketch::play::Moment;
use crate::stroke::{tuned, values};

/// A described model as one of the catalogue.
pub(crate) type DrawnModel = EquationModel<LoadedFunctions, 4, 256>;

/// The model of a table, with the entry of the one by hand but for its outputs.
pub(crate) fn described<W: Playable + Default>(
    table: &'static ModelTable,
    functions: impl Functions + 'static,
) -> DrawnModel {
    let written = W::default().entry();
    let entry = ModelEntry {
        outputs: table.outputs.iter().map(|it| it.name).collect::<Vec<_>>().leak(),
        output_units: table.outputs.iter().map(|it| it.unit).collect::<Vec<_>>().leak(),
        ..*written
    };
    let functions = LoadedFunctions::new(Box::leak(Box::new(functions)), Box::leak(entry.into()));
    let default: Vec<f64> = (0..entry.parameters.len()).map(|i| entry.default_value(i)).collect();
    EquationModel::new(table, functions, &default).expect("there is room for it")
}

macro_rules! described {
    ($($name:ident: $module:ident::$model:ident, $functions:ident;)+) => {$(
        pub(crate) fn $name() -> DrawnModel {
            described::<$model>(&$module::emitted::TABLE, $module::emitted::$functions)
        }
    )+};
}

described! {
    ball: bouncing_ball::BouncingBall, BouncingBallFunctions;
    cart: cart_pendulum::CartPendulum, CartPendulumFunctions;
    wall: spring_wall::SpringWall, SpringWallFunctions;
    model_a: key_hammer_rigid::KeyHammerRigid, KeyHammerRigidFunctions;
    model_b: key_hammer_springs::KeyHammerSprings, KeyHammerSpringsFunctions;
    model_c: reduced_grand::ReducedGrand, ReducedGrandFunctions;
}

/// Compares all presets over a stroke; `apart` has what differs on purpose.
#[track_caller]
fn compare<W: Playable + Default>(described: &DrawnModel, apart: &[AllowedDistance]) {
    for preset in W::default().entry().presets {
        for key in [0, 44, 87] {
            let label = format!("{} {} {key}", W::default().entry().name, preset.name);
            let written = tuned(&W::default(), preset.name, key, &[]);
            let described = tuned(described, preset.name, key, &[]);
            DrawnPair::new(label, written, &described).compare(apart);
        }
    }
}

#[test]
fn the_described_ball_looks_like_the_one_by_hand() {
    compare::<BouncingBall>(&ball(), &[]);
}

#[test]
fn the_described_cart_looks_like_the_one_by_hand() {
    compare::<CartPendulum>(&cart(), &[]);
}

#[test]
fn the_described_wall_looks_like_the_one_by_hand() {
    compare::<SpringWall>(&wall(), &[]);
}

#[test]
fn the_described_model_a_looks_like_the_one_by_hand() {
    compare::<KeyHammerRigid>(&model_a(), &[]);
}

#[test]
fn the_described_model_b_looks_like_the_one_by_hand() {
    // By hand the slider sinks straight down, described square to the key, as the model has it.
    fn aside(moment: &Moment) -> f64 {
        (moment.signal("q4") * moment.signal("theta_k")).abs()
    }
    compare::<KeyHammerSprings>(&model_b(), &[("slider", aside), ("spring k2", aside)]);
}

#[test]
fn the_described_model_c_looks_like_the_one_by_hand() {
    // By hand what turns about a pin that rises follows the chord of its arc, and the lever in the
    // air or under the knuckle is drawn for the middle of the key's way.
    compare::<ReducedGrand>(
        &model_c(),
        &[
            ("jack", |_| 1e-4),
            ("hammer rail", |_| 3e-4),
            ("repetition lever", |_| 3e-3),
            ("spring kr", |_| 3e-3),
        ],
    );
}

/// Does a check with every described model and all its presets, for the lowest and the highest key.
macro_rules! with_all {
    ($check:ident) => {
        for model in [ball, cart, wall, model_a, model_b, model_c] {
            let model = model();
            let ModelEntry { name: known, presets, .. } = model.entry();
            for preset in *presets {
                for key in [0, 87] {
                    let label = format!("described {known} {} key {key}", preset.name);
                    drawing::$check(&label, tuned(&model, preset.name, key, &[]));
                }
            }
        }
    };
}

#[test]
fn a_described_drawing_names_only_what_its_model_has() {
    with_all!(names_are_known);
}

#[test]
fn a_described_drawing_is_finite_whatever_the_values() {
    with_all!(is_finite);
}

/// What a drawing follows is finite too.
#[test]
fn a_described_pose_is_finite_whatever_the_values() {
    for model in [ball, cart, wall, model_a, model_b, model_c] {
        let model = model();
        let entry = model.entry();
        let values = values(&entry.presets[0], entry.parameters.len(), 0);
        for (index, parameter) in entry.parameters.iter().enumerate() {
            for value in [parameter.range.0, 0.0_f64.max(parameter.range.0), parameter.range.1] {
                let mut values = values.clone();
                values[index] = value;
                let label = format!("{}, {} = {value}", entry.name, parameter.name);
                check_poses(&label, &model.with_values(&values));
            }
        }
    }
}

fn check_poses(label: &str, model: &DrawnModel) {
    let names = model.entry().outputs;
    let mut found = vec![0.0; names.len()];
    for mode in (0..).take(model.entry().modes.len()) {
        model.outputs(ModeNumber(mode), &[0.0; 4], &Motion::default(), &mut found);
        let mut poses = names.iter().zip(&found).filter(|it| it.0.contains('.'));
        assert!(poses.all(|it| it.1.is_finite()), "{label}: {found:?}");
    }
}

#[test]
fn each_described_part_is_shown_once_in_every_mode() {
    with_all!(parts_are_single);
}

#[test]
fn everything_described_stays_in_view_along_a_stroke() {
    with_all!(stays_in_view);
}

#[test]
fn a_described_key_s_front_goes_down_by_the_position() {
    with_all!(front_follows);
}

#[test]
fn described_pictures_are_written_to_be_looked_at() {
    with_all!(is_pictured);
}
