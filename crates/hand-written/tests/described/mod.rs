//! The models as their descriptions give them, beside those written by hand.
#![expect(
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test has the heap, and fails aloud"
)]

mod pair;
mod span;

use equations::table::{Functions, ModelTable, ParameterTable};
use hand_written::{
    BouncingBall, CartPendulum, KeyHammerRigid, KeyHammerSprings, ReducedGrand, SpringWall,
};
use models::{Playable, emitted};

use self::pair::{AGREEMENT, DescribedModel, Pair};
use self::span::Span;
use crate::random::Random;

/// Compares a described model with the one by hand: what is said of it, and what it does.
fn check<W: Playable + Default, F: Functions + Copy>(
    table: &'static ModelTable,
    functions: F,
    span: fn(u8) -> Span,
    offset: impl Fn(&[f64]) -> f64,
) {
    let written = W::default();
    says_the_same(&written, table);
    let mut random = Random::new(17);
    for (index, preset) in written.entry().presets.iter().enumerate() {
        for key in [0, 44, 87] {
            let by_hand = |i: usize| (preset.value)(i, key);
            let values: Vec<f64> = (0..table.parameters.len()).map(by_hand).collect();
            let make = |values: &[f64]| {
                DescribedModel::new(table, functions, values).expect("there is room for it")
            };
            let mut found = [0.0; 64];
            make(&values).preset(index, key, &mut found);
            for ((found, value), parameter) in found.iter().zip(&values).zip(table.parameters) {
                let what = format_args!("{} of key {key} in {}", parameter.name, preset.name);
                let apart = (found - value).abs();
                assert!(apart <= AGREEMENT * value.abs(), "{what}: {found} is not {value}");
            }
            let values: Vec<f64> =
                table.parameters.iter().zip(&values).map(|it| lossy(it, key)).collect();
            let label = format!("{} {} {key}", table.name, preset.name);
            let (written, described) = (written.with_values(&values), make(&values));
            let pair = Pair { label, written, described, span, offset: offset(&values) };
            pair.compare_all(&mut random);
        }
    }
}

/// A value with losses unlike those of any preset, for a key in the middle.
fn lossy((parameter, value): (&ParameterTable, &f64), key: u8) -> f64 {
    match (parameter.name, key) {
        ("b1" | "b", 44) => value + 0.3,
        ("c2", 44) => value + 0.2,
        ("inertia", 44) => value + 0.002,
        ("restitution", 44) => 0.6,
        _ => *value,
    }
}

/// Names, units, ranges, modes and where guards lead.
fn says_the_same<W: Playable>(written: &W, table: &'static ModelTable) {
    let entry = written.entry();
    assert_eq!((table.name, table.summary), (entry.name, entry.summary));
    assert_eq!((table.input.name, table.input.unit), (entry.input, entry.input_unit));
    for (ours, theirs) in table.parameters.iter().zip(entry.parameters) {
        assert_eq!((ours.name, ours.range), (theirs.name, theirs.range), "{}", table.name);
        // What grows with a power that is a parameter is told by its size at 1 m.
        if ours.name != "Ks" {
            assert_eq!((ours.unit, ours.doc), (theirs.unit, theirs.doc), "{}", ours.name);
        }
    }
    assert_eq!(table.parameters.len(), entry.parameters.len());
    let presets: Vec<_> = table.presets.iter().map(|it| (it.name, it.doc)).collect();
    assert_eq!(presets, entry.presets.iter().map(|it| (it.name, it.doc)).collect::<Vec<_>>());
    let states: Vec<_> = table.states.iter().map(|it| (it.name, it.unit)).collect();
    let names = entry.states.iter().copied();
    assert_eq!(states, names.zip(entry.state_units.iter().copied()).collect::<Vec<_>>());
    assert_eq!(table.coordinates, entry.coordinates, "{}", table.name);
    for (ours, theirs) in table.modes.iter().zip(entry.modes) {
        assert_eq!(ours.name, theirs.name);
        let (found, name) = (ours.freedom, (table.name, ours.name));
        assert_eq!(found.p, theirs.p, "{name:?}");
        // By hand, as in the paper, what follows from the others is left out where nothing pushes it.
        if !["A2", "B2"].contains(&ours.name) {
            assert_eq!((found.n, found.m), (theirs.n, theirs.m), "{name:?}");
        }
    }
    assert_eq!(table.modes.len(), entry.modes.len());
}

/// Nothing that moves.
const NONE: (f64, f64) = (0.0, 0.0);

#[test]
fn a_described_ball_is_the_one_by_hand() {
    const SPAN: Span = Span::new(
        [(0.0, 1.0), (0.0, 3.0), NONE, NONE],
        [(0.0, 1.0), (0.0, 2.0), (-9.0, 20.0), (0.0, 10.0)],
    );
    let functions = emitted::bouncing_ball::BouncingBallFunctions;
    check::<BouncingBall, _>(&emitted::bouncing_ball::TABLE, functions, |_| SPAN, |_| 0.0);
}

#[test]
fn a_described_cart_is_the_one_by_hand() {
    const SPAN: Span = Span::new(
        [(0.0, 0.1), (0.0, 2.0), (0.0, 1.0), (0.0, 5.0)],
        [(0.0, 0.2), (0.0, 1.0), (0.0, 10.0), (0.0, 10.0)],
    );
    let functions = emitted::cart_pendulum::CartPendulumFunctions;
    check::<CartPendulum, _>(&emitted::cart_pendulum::TABLE, functions, |_| SPAN, |_| 0.0);
}

#[test]
fn a_described_wall_is_the_one_by_hand() {
    const SPAN: Span = Span::new([NONE; 4], [(0.005, 0.01), (0.0, 1.0), (0.0, 10.0), (0.0, 10.0)]);
    let functions = emitted::spring_wall::SpringWallFunctions;
    check::<SpringWall, _>(&emitted::spring_wall::TABLE, functions, |_| SPAN, |_| 0.0);
}

/// By hand the hammer's height is over its pivot: m2 g L4 is between the energies.
fn over_pivot(values: &[f64]) -> f64 {
    values[5] * values[11] * values[3]
}

#[test]
fn a_described_model_b_is_the_one_by_hand() {
    const SPAN: Span = Span::new(
        [(0.1, 0.4), (0.05, 0.3), (0.0, 5.0), (0.0, 3.0)],
        [(0.05, 0.3), (0.0, 2.0), (0.0, 10.0), (0.0, 10.0)],
    );
    let functions = emitted::key_hammer_springs::KeyHammerSpringsFunctions;
    check::<KeyHammerSprings, _>(
        &emitted::key_hammer_springs::TABLE,
        functions,
        |_| SPAN,
        over_pivot,
    );
}

#[test]
fn a_described_model_a_is_the_one_by_hand() {
    const SPAN: Span = Span::new(
        [(0.1, 0.4), (0.0, 5.0), NONE, NONE],
        [(0.02, 0.03), (0.0, 0.5), (-9.0, 30.0), (0.0, 10.0)],
    );
    let functions = emitted::key_hammer_rigid::KeyHammerRigidFunctions;
    check::<KeyHammerRigid, _>(&emitted::key_hammer_rigid::TABLE, functions, |_| SPAN, over_pivot);
}

#[test]
fn a_described_model_c_is_the_one_by_hand() {
    const INPUT: [(f64, f64); 4] = [(0.005, 0.01), (0.0, 0.5), (0.0, 10.0), (0.0, 10.0)];
    const HEAD: [(f64, f64); 3] = [(0.025, 0.03), (0.0, 0.5), (0.0, 4.0)];
    /// Let-off ends at 8.9 mm, behind which its polynomials mean nothing.
    const fn span(mode: u8) -> Span {
        let key = if mode == 1 { (0.0085, 0.0008) } else { (0.005, 0.007) };
        Span::new([key, HEAD[0], HEAD[1], HEAD[2]], INPUT)
    }
    let functions = emitted::reduced_grand::ReducedGrandFunctions;
    check::<ReducedGrand, _>(&emitted::reduced_grand::TABLE, functions, span, |_| 0.0);
}
