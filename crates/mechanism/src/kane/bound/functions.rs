use super::interval::{Range, around, room};
use super::{above_zero, larger, least, magnitude, most};
use crate::kane::graph::{BinaryFunction, Graph, Node, NodeOperation, UnaryFunction};

pub(super) fn power(graph: &mut Graph, x: Range, exponent: i32) -> Range {
    if exponent == 1 {
        return x;
    }
    let n = exponent.unsigned_abs();
    let n = i32::try_from(n).unwrap_or(i32::MAX);
    let whole = if exponent < 0 { inverse(graph, x) } else { x };
    if n == 1 {
        return whole;
    }
    // |xⁿ − cⁿ| ≤ |x − c| Σ |x|ᵏ |c|ⁿ⁻¹⁻ᵏ, all but one of them with the size in place of |c|.
    let (own, rest) = (magnitude(graph, whole.centre), graph.power(whole.size, n - 2));
    let last = graph.multiply(own, rest);
    let all = graph.power(whole.size, n - 1);
    let slope = graph.sum(&[(all, f64::from(n - 1)), (last, 1.0)]);
    Range {
        centre: graph.power(x.centre, exponent),
        spread: graph.multiply(slope, whole.spread),
        size: graph.power(whole.size, n),
    }
}

/// Returns the range of 1/x: |1/x − 1/c| = |x − c|/(|x| |c|).
fn inverse(graph: &mut Graph, x: Range) -> Range {
    if graph.is_zero(x.spread) {
        let centre = graph.power(x.centre, -1);
        return around(graph, centre, None);
    }
    let low = lowest(graph, x);
    let own = magnitude(graph, x.centre);
    Range {
        centre: graph.power(x.centre, -1),
        spread: graph.product(&[(x.spread, 1), (low, -1), (own, -1)]),
        size: graph.power(low, -1),
    }
}

fn lowest(graph: &mut Graph, x: Range) -> Node {
    let (zero, room) = (graph.constant(0.0), room(graph, x));
    most(graph, room, zero)
}

fn ends(graph: &mut Graph, x: Range) -> [Node; 2] {
    [graph.subtract(x.centre, x.spread), graph.add(x.centre, x.spread)]
}

/// Returns the range of a function of x: |f − f(c)| ≤ the largest slope times |x − c|.
pub(super) fn unary(graph: &mut Graph, function: UnaryFunction, x: Range, centre: Node) -> Range {
    if graph.is_zero(x.spread) {
        return around(graph, centre, None);
    }
    let slope = largest_slope(graph, function, x);
    let spread = if function == UnaryFunction::Sign {
        let (room, zero, two) = (room(graph, x), graph.constant(0.0), graph.constant(2.0));
        graph.select(room, zero, two)
    } else if function == UnaryFunction::Sqrt {
        // |√x − √c| ≤ √|x − c| too.
        let (spread, root) = (graph.multiply(slope, x.spread), graph.sqrt(x.spread));
        least(graph, spread, root)
    } else {
        graph.multiply(slope, x.spread)
    };
    let range = around(graph, centre, Some(spread));
    let size = size(graph, function, x, range.size);
    Range { size, ..range }
}

/// Returns a bound of |f| over the range, at most `far`.
fn size(graph: &mut Graph, function: UnaryFunction, x: Range, far: Node) -> Node {
    let [_, high] = ends(graph, x);
    match function {
        UnaryFunction::Sin | UnaryFunction::Cos | UnaryFunction::Tanh | UnaryFunction::Sign => {
            let one = graph.constant(1.0);
            least(graph, far, one)
        }
        UnaryFunction::Abs => x.size,
        UnaryFunction::Exp
        | UnaryFunction::Softplus
        | UnaryFunction::Logistic
        | UnaryFunction::SoftplusArea
        | UnaryFunction::SoftplusSquareArea => graph.unary(function, high),
        UnaryFunction::Ln | UnaryFunction::Sqrt | UnaryFunction::Asin | UnaryFunction::Acos => far,
    }
}

/// Returns a bound of |f(x) − f(c)|/|x − c| over the range.
fn largest_slope(graph: &mut Graph, function: UnaryFunction, x: Range) -> Node {
    let one = graph.constant(1.0);
    let [low, high] = ends(graph, x);
    match function {
        UnaryFunction::Sin => turning(graph, UnaryFunction::Cos, x),
        UnaryFunction::Cos => turning(graph, UnaryFunction::Sin, x),
        // The slopes decrease on both sides of 0.
        UnaryFunction::Tanh | UnaryFunction::Logistic => {
            let nearest = lowest(graph, x);
            let value = graph.unary(function, nearest);
            let square = graph.power(value, 2);
            let top = if function == UnaryFunction::Tanh { one } else { value };
            graph.subtract(top, square)
        }
        UnaryFunction::Exp => graph.unary(UnaryFunction::Exp, high),
        UnaryFunction::Ln => {
            let low = positive(graph, low);
            graph.power(low, -1)
        }
        UnaryFunction::Sqrt => {
            let low = positive(graph, low);
            let roots = [low, x.centre].map(|it| graph.sqrt(it));
            let sum = graph.add(roots[0], roots[1]);
            graph.power(sum, -1)
        }
        UnaryFunction::Abs | UnaryFunction::Sign => one,
        UnaryFunction::Softplus => graph.unary(UnaryFunction::Logistic, high),
        UnaryFunction::SoftplusArea => graph.unary(UnaryFunction::Softplus, high),
        UnaryFunction::SoftplusSquareArea => {
            let softplus = graph.unary(UnaryFunction::Softplus, high);
            graph.power(softplus, 2)
        }
        UnaryFunction::Asin | UnaryFunction::Acos => {
            let square = graph.power(x.size, 2);
            let left = graph.subtract(one, square);
            let left = positive(graph, left);
            let root = graph.sqrt(left);
            graph.power(root, -1)
        }
    }
}

/// Returns a bound of the mean slope between the centre and any place, for a slope `function`:
/// |cos x − cos c| ≤ |sin c| |x − c| + |x − c|²/2.
fn turning(graph: &mut Graph, function: UnaryFunction, x: Range) -> Node {
    let value = graph.unary(function, x.centre);
    let (size, one) = (magnitude(graph, value), graph.constant(1.0));
    let far = graph.sum(&[(size, 1.0), (x.spread, 0.5)]);
    least(graph, far, one)
}

fn positive(graph: &mut Graph, x: Node) -> Node {
    let zero = graph.constant(0.0);
    most(graph, x, zero)
}

/// Returns the range of a function of two arguments, in written order.
pub(super) fn binary(
    graph: &mut Graph,
    function: BinaryFunction,
    [x, y]: [Range; 2],
    centre: Node,
) -> Range {
    if graph.is_zero(x.spread) && graph.is_zero(y.spread) {
        return around(graph, centre, None);
    }
    match function {
        BinaryFunction::Min | BinaryFunction::Max => Range {
            centre,
            spread: larger(graph, x.spread, y.spread),
            size: larger(graph, x.size, y.size),
        },
        BinaryFunction::Hypot => {
            let spread = graph.binary(BinaryFunction::Hypot, x.spread, y.spread);
            around(graph, centre, Some(spread))
        }
        BinaryFunction::Atan2 => angle(graph, [x, y], centre),
        BinaryFunction::Power => general_power(graph, [x, y], centre),
    }
}

/// Returns the angle of a point that is far from the origin and the cut.
fn angle(graph: &mut Graph, [x, y]: [Range; 2], centre: Node) -> Range {
    let unknown = graph.constant(f64::INFINITY);
    let zero = graph.constant(0.0);
    let distance = graph.binary(BinaryFunction::Hypot, x.centre, y.centre);
    let moves = graph.binary(BinaryFunction::Hypot, x.spread, y.spread);
    let nearest = graph.subtract(distance, moves);
    let nearest = most(graph, nearest, zero);
    let turns = graph.divide(moves, nearest);
    let room = cut_room(graph, [x, y]);
    let spread = graph.select(room, turns, unknown);
    let half = graph.constant(std::f64::consts::PI);
    Range { centre, spread, size: half }
}

/// Returns a positive value where atan2(x, y) cannot reach its cut, y < 0 and x = 0.
pub(super) fn cut_room(graph: &mut Graph, [x, y]: [Range; 2]) -> Node {
    let ahead = graph.subtract(y.centre, y.spread);
    let aside = room(graph, x);
    most(graph, ahead, aside)
}

/// Returns the range of xʸ for positive x and constant y: it and its slope are largest at an end.
fn general_power(graph: &mut Graph, [x, y]: [Range; 2], centre: Node) -> Range {
    let unknown = graph.constant(f64::INFINITY);
    if !graph.is_zero(y.spread) {
        return Range { centre, spread: unknown, size: unknown };
    }
    let [low, high] = ends(graph, x).map(|end| above_zero(graph, end));
    let largest = |graph: &mut Graph, exponent: Node| {
        let at = |graph: &mut Graph, end| graph.binary(BinaryFunction::Power, end, exponent);
        match graph.number(exponent) {
            Some(exponent) if exponent >= 0.0 => at(graph, high),
            Some(_) => at(graph, low),
            None => {
                let (low, high) = (at(graph, low), at(graph, high));
                larger(graph, low, high)
            }
        }
    };
    let minus_one = graph.constant(-1.0);
    let less = graph.add(y.centre, minus_one);
    let (slope, size) = (largest(graph, less), largest(graph, y.centre));
    let steep = magnitude(graph, y.centre);
    let spread = graph.product(&[(steep, 1), (slope, 1), (x.spread, 1)]);
    Range { centre, spread, size }
}

/// Returns `true` if a node is never negative, as far as its own operation shows.
pub(super) fn is_never_negative(graph: &Graph, node: Node) -> bool {
    let is_number = |node: &Node| graph.number(*node).is_some_and(|number| number >= 0.0);
    match graph.operation(node) {
        NodeOperation::Number(bits) => f64::from_bits(*bits) >= 0.0,
        NodeOperation::Sum(number, terms) => {
            let is_term = |(node, by): &(Node, u64)| {
                let is_sum = matches!(graph.operation(*node), NodeOperation::Sum(..));
                f64::from_bits(*by) >= 0.0 && !is_sum && is_never_negative(graph, *node)
            };
            f64::from_bits(*number) >= 0.0 && terms.iter().all(is_term)
        }
        NodeOperation::Product(factors) => factors
            .iter()
            .all(|(node, exponent)| exponent % 2 == 0 || is_positive_function(graph, *node)),
        NodeOperation::Binary(BinaryFunction::Max, x, y) => is_number(x) || is_number(y),
        NodeOperation::Symbol(_)
        | NodeOperation::Unary(..)
        | NodeOperation::Binary(..)
        | NodeOperation::Select(_) => is_positive_function(graph, node),
    }
}

fn is_positive_function(graph: &Graph, node: Node) -> bool {
    let NodeOperation::Unary(function, _) = graph.operation(node) else {
        return matches!(graph.operation(node), NodeOperation::Binary(BinaryFunction::Hypot, ..));
    };
    matches!(
        function,
        UnaryFunction::Exp
            | UnaryFunction::Sqrt
            | UnaryFunction::Abs
            | UnaryFunction::Softplus
            | UnaryFunction::Logistic
            | UnaryFunction::SoftplusArea
            | UnaryFunction::SoftplusSquareArea
    )
}
