//! The series of the described model B against the one that is compiled as one function, from a
//! graph that was written by hand.

use hand_written::KeyHammerSprings;
use hand_written::key_hammer_springs::Mode;
use models::Described as _;
use pode::Model as _;
use pode::series::Expansion;

use super::{Case, ORDER, model, named};
use crate::evaluation::Numbers;

/// Compares the coefficients of one order.
fn same(expected: &Expansion<[f64; 4]>, found: &Expansion<[f64; 4]>, k: usize) {
    let size = expected.terms[k].iter().fold(1e-14, |most: f64, it| most.max(it.abs()));
    for (a, b) in expected.terms[k].iter().zip(&found.terms[k]) {
        let off = (a - b).abs() / size;
        assert!(off < 1e-12, "order {k}: {off:e}");
    }
    for (a, b) in expected.guards.iter().zip(&found.guards).take(2) {
        let off = (a[k] - b[k]).abs() / (a[0].abs() + a[k].abs() + 1e-3);
        assert!(off < 1e-12, "guards of order {k}: {off:e}");
    }
}

#[test]
fn the_described_model_b_has_the_series_of_the_hand_written_one() {
    let program = named("key-hammer-springs");
    let mut numbers = Numbers::new(3);
    for n in 0..40 {
        // The third preset has a felt, which the hand-written model does not expand.
        let described = model::<4>(&program, n % 2);
        let written = KeyHammerSprings::default().with_values(described.parameters());
        for (index, mode) in [Mode::B1, Mode::B2].into_iter().enumerate() {
            let case = Case::new(described, index, &mut numbers).expect("a series");
            let mut expected = Expansion::of(&case.series.terms[0], ORDER, case.series.scale);
            assert!(written.series(mode, &case.input, &mut expected));
            (0..=ORDER).for_each(|k| same(&expected, &case.series, k));
            assert_eq!(case.series.known_guards, expected.known_guards);
        }
    }
}
