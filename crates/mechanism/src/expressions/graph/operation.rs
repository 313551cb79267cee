use super::{BinaryFunction, Node, UnaryFunction};

/// Origin of a symbol's value; the numbers are those of the description.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Place {
    Parameter(u16),
    /// Coordinate (`theta`).
    Coordinate(u16),
    /// Generalised speed (`theta'`, unless it is defined otherwise).
    Speed(u16),
    /// Rate of a generalised speed; known once a mode's equations are solved.
    Acceleration(u16),
    /// Input (0) and its rates (1, 2, 3).
    Input(u8),
    /// Force of a constraint; known once a mode's equations are solved.
    Reaction(u16),
    /// Normal force of a contact.
    Contact(u16),
    /// Friction of a contact or bearing, along positive slip; known once it sticks or slides.
    Friction(u16),
    /// Argument beyond state and input, defined by each function.
    Extra(u16),
    /// Number of the key, 0 (A0) to 87 (C8), in gradings.
    Key,
}

/// Terms with a number each: in a sum its factor, in a product its exponent.
pub type NodeTerms = Box<[(Node, u64)]>;

/// One operation; its operands precede it. Numbers are stored as their bits.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum NodeOperation {
    Number(u64),
    Symbol(Place),
    /// Number, and nodes times a number each: sorted by node, without repetition.
    Sum(u64, NodeTerms),
    /// Nodes to a whole power each: sorted by node, without repetition.
    Product(Box<[(Node, i32)]>),
    Unary(UnaryFunction, Node),
    Binary(BinaryFunction, Node, Node),
    /// The second where the first is positive, else the third.
    Select([Node; 3]),
}

impl NodeOperation {
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
