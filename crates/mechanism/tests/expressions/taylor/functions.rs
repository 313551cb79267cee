//! Series of every function along x = t, against the function and the graph's exact derivatives.

use mechanism::expressions::graph::{
    BinaryFunction as Two, Graph, Node, Place, Tangent, UnaryFunction as One,
};
use mechanism::expressions::tape::{Argument, ArgumentLayout, Tape, TapeArguments};

use super::straight::followed;
use crate::expressions::common::UNARY;

/// Start of the series, and the parameter.
const X: f64 = 0.37;
const P: f64 = 0.8;

struct Along {
    graph: Graph,
    layout: ArgumentLayout,
    x: Node,
    p: Node,
}

impl Along {
    fn new() -> Self {
        let (mut graph, mut layout) = (Graph::new(), ArgumentLayout::default());
        layout.place(Place::Coordinate(0), Argument::State(0));
        layout.place(Place::Parameter(0), Argument::Constant(0));
        for rate in 0..3 {
            layout.place(Place::Input(rate), Argument::Input(rate));
        }
        let (x, p) = (graph.symbol(Place::Coordinate(0)), graph.symbol(Place::Parameter(0)));
        Self { graph, layout, x, p }
    }

    fn one(&mut self, function: One, x: Node) -> Node {
        self.graph.unary(function, x)
    }

    fn two(&mut self, function: Two, x: Node, y: Node) -> Node {
        self.graph.binary(function, x, y)
    }

    fn functions(&mut self) -> Vec<Node> {
        let (x, p) = (self.x, self.p);
        let (half, square) = (self.graph.scale(x, 0.5), self.graph.power(x, 2));
        let wave = self.one(One::Sin, x);
        let above = {
            let three = self.graph.constant(3.0);
            self.graph.sum(&[(square, 1.0), (wave, 0.3), (three, 0.4)])
        };
        let (of_any, of_angles) = UNARY.split_at(12);
        let mut all: Vec<_> = of_any.iter().map(|it| self.one(*it, above)).collect();
        all.extend(of_angles.iter().map(|it| self.one(*it, half)));
        let inverse = self.graph.divide(p, above);
        let ratio = self.graph.divide(wave, above);
        let product = self.graph.product(&[(wave, 2), (above, 3), (x, 1)]);
        all.extend([inverse, ratio, product]);
        let exponent = self.graph.constant(2.5);
        all.push(self.two(Two::Power, above, exponent));
        all.push(self.two(Two::Power, above, p));
        all.push(self.two(Two::Power, above, wave));
        for function in [Two::Atan2, Two::Hypot, Two::Min, Two::Max] {
            all.push(self.two(function, wave, above));
        }
        all.push(self.two(Two::Atan2, p, above));
        all.push(self.graph.select(wave, above, x));
        all.push(self.graph.select(x, p, x));
        all
    }

    fn tape(&self, guards: &[Node]) -> Tape {
        let mut graph = self.graph.clone();
        let mut outputs = vec![graph.constant(1.0)];
        outputs.extend(guards);
        Tape::lower(&graph, &self.layout, &outputs).unwrap_or_default()
    }

    fn values(&self, nodes: &[Node], x: f64) -> Vec<f64> {
        let tape = Tape::lower(&self.graph, &self.layout, nodes).unwrap_or_default();
        tape.evaluate(&TapeArguments { constants: &[P], state: &[x], ..TapeArguments::default() })
    }

    fn series(&self, nodes: &[Node], order: usize) -> Vec<Vec<f64>> {
        let one = |node: &Node| followed(&self.tape(&[*node]), (P, X), order).swap_remove(1);
        nodes.iter().map(one).collect()
    }
}

#[test]
fn a_series_gives_the_function_in_its_neighbourhood() {
    let mut along = Along::new();
    let nodes = along.functions();
    let series = along.series(&nodes, 24);
    for step in [-0.05, 0.02, 0.08] {
        let values = along.values(&nodes, X + step);
        for (terms, (node, value)) in series.iter().zip(nodes.iter().zip(values)) {
            let sum = terms.iter().rev().fold(0.0, |sum, term| term + step * sum);
            let error = (sum - value).abs() / value.abs().max(1.0);
            assert!(error < 2e-15, "{:?}: {error:e}", along.graph.operation(*node));
        }
    }
}

#[test]
fn coefficients_are_exact_derivatives_over_factorials() {
    let mut along = Along::new();
    let nodes = along.functions();
    let series = along.series(&nodes, 5);
    let one = along.graph.constant(1.0);
    let mut derivatives = nodes.clone();
    let mut factorial = 1.0;
    for k in 1..=5_u8 {
        factorial *= f64::from(k);
        let mut tangent = Tangent::new([(Place::Coordinate(0), one)]);
        for it in &mut derivatives {
            *it = tangent.of(&mut along.graph, *it);
        }
        let values = along.values(&derivatives, X);
        for (index, value) in values.into_iter().enumerate() {
            let (found, expected) = (series[index][usize::from(k)], value / factorial);
            let error = (found - expected).abs() / expected.abs().max(1.0);
            assert!(error < 1e-12, "order {k} of function {index}: {found} is not {expected}");
        }
    }
}

#[test]
fn a_series_says_where_it_ends() {
    let mut along = Along::new();
    let (x, p) = (along.x, along.p);
    let conditions = |along: &Along, node: Node, x: f64| -> Vec<Vec<f64>> {
        followed(&along.tape(&[node]), (P, x), 2).split_off(2)
    };
    // A choice by x − p: the compared value is zero where they are equal.
    let larger = along.two(Two::Max, x, p);
    assert_eq!(conditions(&along, larger, 2.0), [[2.0 - P, 1.0, 0.0]]);
    let size = along.one(One::Abs, x);
    assert_eq!(conditions(&along, size, -3.0), [[-3.0, 1.0, 0.0]]);
    // A softplus: from −100 to −40, from −35 to −20, from 15 to 10 if it turns round; near zero
    // its own coefficients show the corner.
    let soft = along.one(One::Softplus, x);
    for (x, above, slope) in [(-100.0, 60.0, -1.0), (-35.0, 15.0, -1.0), (15.0, 5.0, 1.0)] {
        assert_eq!(conditions(&along, soft, x), [[above, slope, 0.0]]);
    }
    assert_eq!(conditions(&along, soft, -5.0), [[0.0, 0.0, 0.0]]);
    let tanh = along.one(One::Tanh, x);
    assert_eq!(conditions(&along, tanh, -12.0), [[4.0, -2.0, 0.0]]);
    let fixed = along.graph.select(p, x, p);
    assert!(conditions(&along, fixed, 2.0).is_empty());
}
