use mechanism::expressions::graph::{Graph, Node, Place, Substitution, UnaryFunction};
use mechanism::expressions::tape::Tape;
use proptest::prelude::*;

use crate::expressions::common::{SYMBOLS, layout, trees, values};
use crate::expressions::tape::value;

fn symbols<const N: usize>(graph: &mut Graph) -> [Node; N] {
    core::array::from_fn(|at| graph.symbol(SYMBOLS[at]))
}

fn evaluate(graph: &Graph, node: Node, at: &[f64; 6]) -> f64 {
    value(&Tape::lower(graph, &layout(), &[node]).unwrap(), at)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn what_is_built_twice_is_one_node(tree in trees(), other in trees()) {
        let mut graph = Graph::new();
        let first = tree.build(&mut graph);
        other.build(&mut graph);
        let size = graph.len();
        prop_assert_eq!(tree.build(&mut graph), first);
        prop_assert_eq!(graph.len(), size, "the second time made nodes");
    }

    #[test]
    fn the_order_of_terms_and_factors_does_not_matter(all in prop::collection::vec(trees(), 2..5)) {
        let mut graph = Graph::new();
        // Rounding depends on the order of numbers, so only other nodes are compared.
        let mut nodes: Vec<Node> = all.iter().map(|it| it.build(&mut graph)).collect();
        nodes.retain(|it| graph.number(*it).is_none());
        let nodes: Vec<Node> =
            nodes.into_iter().map(|it| graph.unary(UnaryFunction::Exp, it)).collect();
        let terms: Vec<_> = nodes.iter().map(|it| (*it, 2.0)).collect();
        let factors: Vec<_> = nodes.iter().map(|it| (*it, 2)).collect();
        let reversed: Vec<_> = terms.iter().rev().copied().collect();
        let back: Vec<_> = factors.iter().rev().copied().collect();
        prop_assert_eq!(graph.sum(&terms), graph.sum(&reversed));
        prop_assert_eq!(graph.product(&factors), graph.product(&back));
    }

    /// Central differences of smooth expressions: truncation is below h² times the third
    /// derivative, which is estimated by the formula at 2h, and rounding below ε |f| / h.
    #[test]
    fn derivatives_are_slopes(tree in trees(), at in values(), by in 0..6_usize) {
        const H: f64 = 1e-4;
        let near = |step: f64| {
            let mut near = at;
            near[by] += step;
            tree.evaluate(&near)
        };
        let samples = [-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0].map(|n| near(n * H));
        let Some(samples) = samples.into_iter().collect::<Option<Vec<_>>>() else { return Ok(()) };
        let slope = |low: usize, high: usize, step: f64| {
            (samples[high].value - samples[low].value) / (2.0 * step * H)
        };
        let [wide, middle, narrow] = [slope(0, 6, 2.0), slope(1, 5, 1.0), slope(2, 4, 0.5)];
        // At a corner the slopes of the two sides differ.
        let bend = |low: usize, high: usize| {
            samples[high].value - 2.0 * samples[3].value + samples[low].value
        };
        let rounding = 16.0 * samples[3].error;
        if bend(2, 4).abs() > 0.4 * bend(1, 5).abs() + rounding {
            return Ok(());
        }
        let spread = (wide - middle).abs().max((middle - narrow).abs());
        if spread.is_nan() || spread >= 1e-3 * (1.0 + middle.abs()) {
            return Ok(());
        }
        let error = samples.iter().map(|it| it.error).fold(0.0, f64::max);
        let mut graph = Graph::new();
        let node = tree.build(&mut graph);
        let derivative = graph.partial(node, SYMBOLS[by]);
        let got = evaluate(&graph, derivative, &at);
        let bound = 10.0 * spread + 8.0 * error / H + 1e-7 * (1.0 + middle.abs());
        prop_assume!(got.is_finite());
        prop_assert!((got - middle).abs() <= bound, "{got:e} is not {middle:e} within {bound:e}");
    }

    #[test]
    fn substitution_is_composition(tree in trees(), inner in trees(), at in values()) {
        let Some(value_of_inner) = inner.evaluate(&at) else { return Ok(()) };
        let mut moved = at;
        moved[2] = value_of_inner.value;
        // Errors of inner values are not bounded here: only exact ones are used.
        let Some(expected) = tree.evaluate(&moved) else { return Ok(()) };
        prop_assume!(value_of_inner.error == 0.0);
        let mut graph = Graph::new();
        let (node, by) = (tree.build(&mut graph), inner.build(&mut graph));
        let whole = Substitution::new([(SYMBOLS[2], by)]).of(&mut graph, node);
        let got = evaluate(&graph, whole, &at);
        prop_assert!((got - expected.value).abs() <= 16.0 * expected.error, "{got}");
    }
}

#[test]
fn squares_of_sine_and_cosine_become_one() {
    let mut graph = Graph::new();
    let [x, y] = symbols(&mut graph);
    let sum = graph.add(x, y);
    let (sine, cosine) =
        (graph.unary(UnaryFunction::Sin, sum), graph.unary(UnaryFunction::Cos, sum));
    let (ss, cc) = (graph.power(sine, 2), graph.power(cosine, 2));
    let one = graph.add(ss, cc);
    assert_eq!(graph.number(one), Some(1.0));
    let terms = [(graph.multiply(ss, y), 3.0), (graph.multiply(cc, y), 3.0), (x, 1.0)];
    let sum = graph.sum(&terms);
    let expected = graph.sum(&[(y, 3.0), (x, 1.0)]);
    assert_eq!(sum, expected);
    let uneven = graph.sum(&[(ss, 1.0), (cc, 2.0)]);
    assert_ne!(graph.number(uneven), Some(1.0));
}

#[test]
fn many_pairs_of_squares_become_their_number() {
    const PAIRS: u16 = 5000;
    let mut graph = Graph::new();
    let mut terms = Vec::new();
    for number in 0..PAIRS {
        let x = graph.symbol(Place::Coordinate(number));
        for function in [UnaryFunction::Sin, UnaryFunction::Cos] {
            let value = graph.unary(function, x);
            terms.push((graph.power(value, 2), 1.0));
        }
    }
    let sum = graph.sum(&terms);
    assert_eq!(graph.number(sum), Some(f64::from(PAIRS)));
}

#[test]
fn odd_and_even_functions_of_a_long_sum_have_one_sign() {
    let mut graph = Graph::new();
    let terms = (0..60).map(|at| graph.symbol(Place::Parameter(at))).collect::<Vec<_>>();
    let [minus, plus] = [-1.0, 1.0]
        .map(|factor| graph.sum(&terms.iter().map(|it| (*it, factor)).collect::<Vec<_>>()));
    let [sine, other] = [minus, plus].map(|it| graph.unary(UnaryFunction::Sin, it));
    assert_eq!(sine, graph.negate(other));
    let [cosine, other] = [minus, plus].map(|it| graph.unary(UnaryFunction::Cos, it));
    assert_eq!(cosine, other);
}

/// Iterates x ↦ √(x² + c): after n times √(x² + n c), with the slope x/√(x² + n c).
/// Building, derivative, substitution and evaluation must not recurse.
#[test]
fn deep_chains_do_not_overflow_the_stack() {
    const DEPTH: u32 = 100_000;
    const C: f64 = 1e-5;
    let mut graph = Graph::new();
    let [x] = symbols(&mut graph);
    let c = graph.constant(C);
    let mut chain = x;
    for _ in 0..DEPTH {
        let square = graph.power(chain, 2);
        let sum = graph.add(square, c);
        chain = graph.sqrt(sum);
    }
    let at = [0.3, 0.0, 0.0, 0.0, 0.0, 0.0];
    let expected = (0.09 + C * f64::from(DEPTH)).sqrt();
    assert!((evaluate(&graph, chain, &at) - expected).abs() < 1e-10);
    let derivative = graph.partial(chain, SYMBOLS[0]);
    assert!((evaluate(&graph, derivative, &at) - 0.3 / expected).abs() <= 1e-9);
    let two = graph.constant(2.0);
    let moved = Substitution::new([(SYMBOLS[0], two)]).of(&mut graph, chain);
    assert!(graph.number(moved).is_some());
    assert!(graph.depends(chain, |place| place == SYMBOLS[0]));
}

/// Each x is the sum of all earlier sines: what flattens to long sums still ends soon.
#[test]
fn chains_that_flatten_are_lowered_in_bounded_time() {
    const DEPTH: u32 = 3000;
    let mut graph = Graph::new();
    let [x] = symbols(&mut graph);
    let (mut chain, mut expected, mut slope) = (x, 0.3_f64, 1.0);
    for _ in 0..DEPTH {
        let sine = graph.unary(UnaryFunction::Sin, chain);
        chain = graph.sum(&[(sine, 1e-3), (chain, 1.0)]);
        slope *= 1.0 + 1e-3 * expected.cos();
        expected += 1e-3 * expected.sin();
    }
    let at = [0.3, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert!((evaluate(&graph, chain, &at) - expected).abs() < 1e-9);
    let derivative = graph.partial(chain, SYMBOLS[0]);
    assert!((evaluate(&graph, derivative, &at) - slope).abs() <= 1e-9 * slope.abs());
}

#[test]
fn long_sums_and_products_written_term_by_term_stay_small() {
    const TERMS: u16 = 60_000;
    let mut graph = Graph::new();
    let (mut sum, mut product) = (graph.constant(0.0), graph.constant(1.0));
    for number in 0..TERMS {
        let x = graph.symbol(Place::Coordinate(number));
        sum = graph.add(sum, x);
        product = graph.multiply(product, x);
    }
    let partial = graph.partial(sum, Place::Coordinate(17));
    assert_eq!(graph.number(partial), Some(1.0));
    let same = graph.subtract(sum, sum);
    assert!(graph.is_zero(same));
    let one = graph.divide(product, product);
    assert_eq!(graph.number(one), Some(1.0));
}
