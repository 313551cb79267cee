//! Expressions, each stored once.
//!
//! A [`Graph`] is a list of operations; a [`Node`] is an index into it. An expression that is built
//! twice is the same node (hash-consing), so that common subexpressions need no search. Operands
//! precede their operation: every pass is one loop over the list.
//!
//! Sums and products are kept in one order, with equal terms collected, so that `a − a` is 0 and
//! `x / x` is 1; nothing is multiplied out.

mod build;
mod derivative;
mod functions;
mod hash;
mod operation;
mod order;
mod substitute;
mod trigonometry;
mod work;

pub use derivative::Tangent;
pub use functions::{BinaryFunction, UnaryFunction};
pub use hash::NodeMap;
pub use operation::{NodeOperation, NodeTerms, Place};
pub use substitute::Substitution;
pub use work::{MAX_WORK, WorkEnd};

/// Index of an expression in a [`Graph`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Node(u32);

impl Node {
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// Set of expressions that share subexpressions.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    operations: Vec<NodeOperation>,
    known: NodeMap<NodeOperation, Node>,
    work: work::WorkMeter,
}

impl Graph {
    pub fn new() -> Self {
        Self::default()
    }

    pub fn operation(&self, node: Node) -> &NodeOperation {
        &self.operations[node.index()]
    }

    pub const fn len(&self) -> usize {
        self.operations.len()
    }

    pub const fn is_empty(&self) -> bool {
        self.operations.is_empty()
    }

    /// Returns every expression from the number `first` on, operands first.
    pub fn nodes_from(&self, first: usize) -> impl Iterator<Item = Node> + use<> {
        let end = u32::try_from(self.operations.len()).unwrap_or(u32::MAX);
        let first = u32::try_from(first).unwrap_or(u32::MAX);
        (first..end).map(Node)
    }

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

    pub fn number(&self, node: Node) -> Option<f64> {
        let NodeOperation::Number(bits) = self.operation(node) else { return None };
        Some(f64::from_bits(*bits))
    }

    pub fn is_zero(&self, node: Node) -> bool {
        self.number(node) == Some(0.0)
    }

    /// Returns `true` if any of `on` appears in `node`.
    pub fn depends(&self, node: Node, on: impl Fn(Place) -> bool) -> bool {
        self.reached(&[node])
            .into_iter()
            .any(|it| matches!(self.operation(it), NodeOperation::Symbol(place) if on(*place)))
    }

    /// Returns `outputs` and what they depend on, operands first; empty if work was given up.
    pub fn reached(&self, outputs: &[Node]) -> Vec<Node> {
        let Some(last) = outputs.iter().max() else { return Vec::new() };
        // Passing over a node costs much less than an operand.
        self.spend(1 + last.index() / 32);
        if self.given_up().is_some() {
            return Vec::new();
        }
        // A bit per node: operands precede their operation, so the highest bit is next.
        let mut waiting = vec![0_u64; last.index() / 64 + 1];
        for output in outputs {
            waiting[output.index() / 64] |= 1 << (output.0 % 64);
        }
        let mut reached = Vec::new();
        for word in (0..=last.0 / 64).rev() {
            while let Some(bit) = waiting[word as usize].checked_ilog2() {
                waiting[word as usize] ^= 1 << bit;
                let node = Node(64 * word + bit);
                self.operation(node).operands(|it| waiting[it.index() / 64] |= 1 << (it.0 % 64));
                reached.push(node);
            }
        }
        reached.reverse();
        reached
    }
}
