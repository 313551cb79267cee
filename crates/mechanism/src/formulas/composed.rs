use std::f64::consts::{LOG2_E, LOG10_E};

use crate::expressions::graph::{BinaryFunction, Graph, Node, UnaryFunction};

pub(super) fn tan(graph: &mut Graph, x: Node) -> Node {
    let [sine, cosine] = [UnaryFunction::Sin, UnaryFunction::Cos].map(|it| graph.unary(it, x));
    graph.divide(sine, cosine)
}

pub(super) fn atan(graph: &mut Graph, x: Node) -> Node {
    let one = graph.constant(1.0);
    graph.binary(BinaryFunction::Atan2, x, one)
}

/// Builds cosh x · tanh x, which has no cancellation.
pub(super) fn sinh(graph: &mut Graph, x: Node) -> Node {
    let (cosh, tanh) = (cosh(graph, x), graph.unary(UnaryFunction::Tanh, x));
    graph.multiply(cosh, tanh)
}

pub(super) fn cosh(graph: &mut Graph, x: Node) -> Node {
    let opposite = graph.negate(x);
    let [grows, falls] = [x, opposite].map(|it| graph.unary(UnaryFunction::Exp, it));
    graph.sum(&[(grows, 0.5), (falls, 0.5)])
}

/// Builds 4 artanh(x/(q + √2q)) with q = 1 + √(1 + x²): a quarter of the angle.
///
/// ln(x + √(1 + x²)) cancels for negative x, and an artanh of half the angle for large x.
pub(super) fn asinh(graph: &mut Graph, x: Node) -> Node {
    let (one, square) = (graph.constant(1.0), graph.power(x, 2));
    let square = graph.add(one, square);
    let root = graph.sqrt(square);
    let q = graph.add(one, root);
    let double = graph.scale(q, 2.0);
    let root = graph.sqrt(double);
    let below = graph.add(q, root);
    let quarter = graph.divide(x, below);
    let quarter = atanh(graph, quarter);
    graph.scale(quarter, 4.0)
}

/// Builds ln(x + √((x − 1)(x + 1))).
pub(super) fn acosh(graph: &mut Graph, x: Node) -> Node {
    let one = graph.constant(1.0);
    let (less, more) = (graph.subtract(x, one), graph.add(x, one));
    let square = graph.multiply(less, more);
    let root = graph.sqrt(square);
    let sum = graph.add(x, root);
    graph.unary(UnaryFunction::Ln, sum)
}

/// Builds ln((1 + x)/(1 − x))/2.
pub(super) fn atanh(graph: &mut Graph, x: Node) -> Node {
    let one = graph.constant(1.0);
    let (more, less) = (graph.add(one, x), graph.subtract(one, x));
    let ratio = graph.divide(more, less);
    let log = graph.unary(UnaryFunction::Ln, ratio);
    graph.scale(log, 0.5)
}

pub(super) fn log2(graph: &mut Graph, x: Node) -> Node {
    let log = graph.unary(UnaryFunction::Ln, x);
    graph.scale(log, LOG2_E)
}

pub(super) fn log10(graph: &mut Graph, x: Node) -> Node {
    let log = graph.unary(UnaryFunction::Ln, x);
    graph.scale(log, LOG10_E)
}
