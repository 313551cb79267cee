//! Tapes against evaluation by recursion.

use kane::graph::{Graph, Place};
use kane::tape::{Arguments, Tape};
use proptest::prelude::*;

use crate::common::{layout, trees, values};

/// A tape's first output at values of the symbols.
pub(crate) fn value(tape: &Tape, symbols: &[f64; 6]) -> f64 {
    let [p0, p1, q0, q1, u0, s1] = *symbols;
    let input = [0.0, s1, 0.0, 0.0];
    tape.evaluate(&Arguments { constants: &[p0, p1], state: &[q0, q1, u0], input, extra: &[] })[0]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn a_tape_computes_what_the_expression_says(tree in trees(), symbols in values()) {
        let Some(expected) = tree.evaluate(&symbols) else { return Ok(()) };
        let mut graph = Graph::new();
        let node = tree.build(&mut graph);
        let tape = Tape::lower(&graph, &layout(), &[node]).unwrap();
        prop_assert!(tape.is_ordered());
        let got = value(&tape, &symbols);
        prop_assert!(
            (got - expected.value).abs() <= 16.0 * expected.error,
            "{got:e} is not {:e} within {:e}", expected.value, expected.error
        );
    }
}

#[test]
fn a_symbol_without_a_place_is_named() {
    let mut graph = Graph::new();
    let x = graph.symbol(Place::Acceleration(3));
    let twice = graph.scale(x, 2.0);
    assert_eq!(Tape::lower(&graph, &layout(), &[twice]), Err(Place::Acceleration(3)));
}

#[test]
fn missing_arguments_are_not_numbers() {
    let mut graph = Graph::new();
    let x = graph.symbol(Place::Coordinate(1));
    let tape = Tape::lower(&graph, &layout(), &[x]).unwrap();
    let short = Arguments { state: &[1.0], ..Arguments::default() };
    assert!(tape.evaluate(&short)[0].is_nan());
}
