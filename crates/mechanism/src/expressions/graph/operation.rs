//! What a node is made of.

use super::{BinaryFunction, Node, UnaryFunction};

/// Where a symbol's value comes from.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Place {
    /// A parameter, by its number in the description.
    Parameter(u16),
    /// A coordinate (`theta`), by its number.
    Coordinate(u16),
    /// A generalised speed (`theta'`, unless it is defined otherwise), by its number.
    Speed(u16),
    /// The rate of a generalised speed; known once a mode's equations are solved.
    Acceleration(u16),
    /// The input (0) and its rates (1, 2, 3).
    Input(u8),
    /// The force of a constraint, by its number; known once a mode's equations are solved.
    Reaction(u16),
    /// The force of a contact or friction, by its number, as the mode has it.
    Contact(u16),
    /// An argument beyond state and input, by its number: what a function says that it is.
    Extra(u16),
    /// Number of the key, 0 (A0) to 87 (C8), in gradings.
    Key,
}

/// Terms with a number each: in a sum its factor, in a product its exponent.
pub type NodeTerms = Box<[(Node, u64)]>;

/// One operation; its operands stand before it. Numbers are held by their bits.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum NodeOperation {
    Number(u64),
    Symbol(Place),
    /// A number, and nodes times a number each: in the order of the nodes, none twice.
    Sum(u64, NodeTerms),
    /// Nodes to a whole power each: in the order of the nodes, none twice.
    Product(Box<[(Node, i32)]>),
    Unary(UnaryFunction, Node),
    Binary(BinaryFunction, Node, Node),
    /// The second where the first is positive, else the third.
    Select([Node; 3]),
}

impl NodeOperation {
    /// Shows each operand to `see`.
    pub fn operands(&self, mut see: impl FnMut(Node)) {
        match self {
            Self::Number(_) | Self::Symbol(_) => {}
            Self::Sum(_, terms) => terms.iter().for_each(|(node, _)| see(*node)),
            Self::Product(factors) => factors.iter().for_each(|(node, _)| see(*node)),
            Self::Unary(_, x) => see(*x),
            Self::Binary(_, x, y) => [x, y].into_iter().for_each(|node| see(*node)),
            Self::Select(all) => all.iter().for_each(|node| see(*node)),
        }
    }
}
