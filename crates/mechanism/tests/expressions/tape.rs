//! Tapes against evaluation by recursion.

use mechanism::expressions::graph::{Graph, Node, Place};
use mechanism::expressions::tape::{
    Argument, ArgumentLayout, Instruction, Tape, TapeArguments, constant_parts,
};
use proptest::prelude::*;

use crate::expressions::common::{SYMBOLS, layout, trees, values};

pub(crate) fn value(tape: &Tape, symbols: &[f64; 6]) -> f64 {
    let [p0, p1, q0, q1, u0, s1] = *symbols;
    let input = [0.0, s1, 0.0, 0.0];
    tape.evaluate(&TapeArguments { constants: &[p0, p1], state: &[q0, q1, u0], input, extra: &[] })
        [0]
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
    let short = TapeArguments { state: &[1.0], ..TapeArguments::default() };
    assert!(tape.evaluate(&short)[0].is_nan());
}

fn costs(tape: &Tape) -> (usize, usize, usize) {
    let count =
        |kind: fn(&Instruction) -> bool| tape.instructions.iter().filter(|it| kind(it)).count();
    (
        count(|it| matches!(it, Instruction::Multiply(..))),
        count(|it| matches!(it, Instruction::Divide(..))),
        count(|it| matches!(it, Instruction::Add(..) | Instruction::Subtract(..))),
    )
}

fn lowered(build: impl Fn(&mut Graph, [Node; 6]) -> Vec<Node>) -> Tape {
    let mut graph = Graph::new();
    let symbols = SYMBOLS.map(|place| graph.symbol(place));
    let outputs = build(&mut graph, symbols);
    Tape::lower(&graph, &layout(), &outputs).unwrap()
}

#[test]
fn common_factors_are_taken_out() {
    // a x + b x + c x y = (a + b + c y) x.
    let tape = lowered(|g, [a, b, c, x, y, _]| {
        let terms = [g.multiply(a, x), g.multiply(b, x), g.product(&[(c, 1), (x, 1), (y, 1)])];
        vec![g.sum(&terms.map(|it| (it, 1.0)))]
    });
    assert_eq!(costs(&tape), (2, 0, 2));
}

#[test]
fn one_division_for_all_by_the_same() {
    let tape = lowered(|g, [a, b, c, x, _, _]| {
        let below = g.add(c, x);
        vec![g.divide(a, below), g.divide(b, below), g.divide(x, below)]
    });
    assert_eq!(costs(&tape), (3, 1, 1));
    let once = lowered(|g, [a, b, ..]| vec![g.divide(a, b)]);
    assert_eq!(costs(&once), (0, 1, 0));
}

#[test]
fn multiples_of_one_sum_are_added_once() {
    let tape = lowered(|g, [a, b, c, ..]| {
        let sum = g.sum(&[(a, 0.5), (b, 4.0), (c, -1.0)]);
        vec![sum, g.scale(sum, 300.0)]
    });
    let (_, _, additions) = costs(&tape);
    assert_eq!(additions, 2);
}

#[test]
fn what_products_share_is_multiplied_once() {
    // a² b² c², a b c x, a b y.
    let tape = lowered(|g, [a, b, c, x, y, _]| {
        vec![
            g.product(&[(a, 2), (b, 2), (c, 2)]),
            g.product(&[(a, 1), (b, 1), (c, 1), (x, 1)]),
            g.product(&[(a, 1), (b, 1), (y, 1)]),
        ]
    });
    assert_eq!(costs(&tape), (5, 0, 0));
}

#[test]
fn long_sums_are_trees() {
    const TERMS: u16 = 32;
    let mut graph = Graph::new();
    let mut layout = ArgumentLayout::default();
    let terms: Vec<(Node, f64)> = (0..TERMS)
        .map(|at| {
            layout.place(Place::Extra(at), Argument::Extra(at));
            (graph.symbol(Place::Extra(at)), 1.0)
        })
        .collect();
    let sum = graph.sum(&terms);
    let tape = Tape::lower(&graph, &layout, &[sum]).unwrap();
    let mut depths = Vec::new();
    for instruction in &tape.instructions {
        let mut depth = 0;
        instruction.operands(|it| depth = depth.max(depths[it.index()]));
        depths.push(depth + u32::from(matches!(instruction, Instruction::Add(..))));
    }
    assert_eq!(depths.last(), Some(&5));
}

#[test]
fn what_is_ready_is_found_within_products_and_sums() {
    let mut graph = Graph::new();
    let [a, b, x, y] = [0, 1, 2, 3].map(|at| graph.symbol(SYMBOLS[at]));
    let product = graph.product(&[(a, 2), (b, 1), (x, 1)]);
    let sum = graph.sum(&[(a, 3.0), (b, 3.0), (y, 1.0)]);
    let root = graph.sqrt(a);
    let outputs = [product, sum, root];
    let parts = constant_parts(&mut graph, &outputs, |it| matches!(it, Place::Parameter(_)));
    assert_eq!(parts.len(), 3, "a² b, 3 a + 3 b, √a");
    let mut layout = layout();
    let values: Vec<f64> = {
        let tape = Tape::lower(&graph, &layout, &parts).unwrap();
        tape.evaluate(&TapeArguments { constants: &[2.0, 5.0], ..TapeArguments::default() })
    };
    for (at, part) in (0..).zip(&parts) {
        layout.ready(*part, Argument::Extra(at));
    }
    let tape = Tape::lower(&graph, &layout, &outputs).unwrap();
    assert_eq!(costs(&tape), (1, 0, 1));
    let got = tape.evaluate(&TapeArguments {
        state: &[7.0, 11.0],
        extra: &values,
        ..TapeArguments::default()
    });
    assert_eq!(got, [140.0, 32.0, 2.0_f64.sqrt()]);
}
