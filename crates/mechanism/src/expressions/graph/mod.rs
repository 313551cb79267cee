//! Expressions, each held once.
//!
//! A [`Graph`] is a list of operations; a [`Node`] is a place in it. An expression that is built
//! twice is the same node (hash-consing), so that common subexpressions need no search. Operands
//! always stand before what is made of them: every pass is one loop over the list, whatever the
//! depth of an expression.
//!
//! Sums and products are kept in one order, with equal terms collected, so that `a − a` is 0 and
//! `x / x` is 1; nothing is multiplied out.

mod build;
mod derivative;
mod functions;
mod operation;
mod order;
mod substitute;
mod trigonometry;
mod work;

pub use derivative::Tangent;
pub use functions::{BinaryFunction, UnaryFunction};
pub use operation::{NodeOperation, NodeTerms, Place};
pub use substitute::Substitution;
pub use work::{MAX_WORK, WorkEnd};

use std::collections::HashMap;

/// A place in a [`Graph`]: one expression.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Node(u32);

impl Node {
    /// Returns the place as an index into lists with one entry per node.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// Expressions that share their parts.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    operations: Vec<NodeOperation>,
    known: HashMap<NodeOperation, Node>,
    work: work::WorkMeter,
}

impl Graph {
    /// Returns an empty graph.
    pub fn new() -> Self {
        Self::default()
    }

    /// Returns what `node` is made of.
    pub fn operation(&self, node: Node) -> &NodeOperation {
        &self.operations[node.index()]
    }

    /// Returns how many expressions there are.
    pub const fn len(&self) -> usize {
        self.operations.len()
    }

    /// Whether there is no expression yet.
    pub const fn is_empty(&self) -> bool {
        self.operations.is_empty()
    }

    /// Returns every expression from the number `first` on, operands first.
    pub fn nodes_from(&self, first: usize) -> impl Iterator<Item = Node> + use<> {
        let end = u32::try_from(self.operations.len()).unwrap_or(u32::MAX);
        let first = u32::try_from(first).unwrap_or(u32::MAX);
        (first..end).map(Node)
    }

    /// Returns the node of `operation`, which is entered if it is new.
    fn intern(&mut self, operation: NodeOperation) -> Node {
        if let Some(node) = self.known.get(&operation) {
            return *node;
        }
        self.spend(1);
        if self.given_up().is_some() && !self.is_empty() {
            return Node(0);
        }
        let place = u32::try_from(self.operations.len()).unwrap_or(u32::MAX);
        let node = Node(place);
        self.operations.push(operation.clone());
        self.known.insert(operation, node);
        node
    }

    /// Returns the number that `node` is, if it is one.
    pub fn number(&self, node: Node) -> Option<f64> {
        let NodeOperation::Number(bits) = self.operation(node) else { return None };
        Some(f64::from_bits(*bits))
    }

    /// Whether `node` is the number 0.
    pub fn is_zero(&self, node: Node) -> bool {
        self.number(node) == Some(0.0)
    }

    /// Whether any of `places` appears in `node`.
    pub fn depends(&self, node: Node, on: impl Fn(Place) -> bool) -> bool {
        self.reached(&[node])
            .into_iter()
            .any(|it| matches!(self.operation(it), NodeOperation::Symbol(place) if on(*place)))
    }

    /// Returns every node that `outputs` are made of, themselves included, operands first; none
    /// if work on the graph was given up.
    pub fn reached(&self, outputs: &[Node]) -> Vec<Node> {
        let Some(last) = outputs.iter().max() else { return Vec::new() };
        // A node that is passed over is much less than an operand.
        self.spend(1 + last.index() / 32);
        if self.given_up().is_some() {
            return Vec::new();
        }
        let mut is_reached = vec![false; last.index() + 1];
        for output in outputs {
            is_reached[output.index()] = true;
        }
        for index in (0..is_reached.len()).rev() {
            if is_reached[index] {
                self.operations[index].operands(|operand| is_reached[operand.index()] = true);
            }
        }
        let count = u32::try_from(is_reached.len()).unwrap_or(u32::MAX);
        (0..count).map(Node).filter(|node| is_reached[node.index()]).collect()
    }
}
