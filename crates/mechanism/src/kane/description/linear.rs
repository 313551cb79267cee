use std::collections::HashMap;

use crate::kane::graph::{Graph, Node, NodeOperation, Place};

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Degree {
    None,
    Linear,
    Other,
}

/// Returns `true` if `node` is linear in the speeds, with coefficients that contain no speeds.
pub(super) fn is_linear_in_speeds(graph: &Graph, node: Node) -> bool {
    let mut degrees: HashMap<Node, Degree> = HashMap::new();
    for reached in graph.reached(&[node]) {
        let of = |it: &Node| degrees.get(it).copied().unwrap_or(Degree::None);
        let degree = match graph.operation(reached) {
            NodeOperation::Symbol(Place::Speed(_)) => Degree::Linear,
            NodeOperation::Number(_) | NodeOperation::Symbol(_) => Degree::None,
            NodeOperation::Sum(_, terms) => largest(terms.iter().map(|(it, _)| of(it))),
            NodeOperation::Product(factors) => {
                product(factors.iter().map(|(it, by)| (of(it), *by)))
            }
            NodeOperation::Unary(_, x) => inside(of(x)),
            NodeOperation::Binary(_, x, y) => inside(of(x).max(of(y))),
            NodeOperation::Select([condition, x, y]) => inside(of(condition)).max(of(x)).max(of(y)),
        };
        degrees.insert(reached, degree);
    }
    degrees.get(&node) != Some(&Degree::Other)
}

fn largest(degrees: impl Iterator<Item = Degree>) -> Degree {
    degrees.max().unwrap_or(Degree::None)
}

fn product(factors: impl Iterator<Item = (Degree, i32)>) -> Degree {
    let mut with_speeds = factors.filter(|(degree, _)| *degree != Degree::None);
    match (with_speeds.next(), with_speeds.next()) {
        (None, _) => Degree::None,
        (Some((Degree::Linear, 1)), None) => Degree::Linear,
        (Some(_), _) => Degree::Other,
    }
}

/// Returns the degree of a function, which is never linear.
fn inside(degree: Degree) -> Degree {
    if degree == Degree::None { degree } else { Degree::Other }
}
