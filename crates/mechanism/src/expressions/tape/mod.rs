//! Straight-line program of some expressions.
//!
//! Sums and products of many terms in the graph become operations of two operands, each value
//! computed once. Values and native code are both computed from the tape.

mod analysis;
mod evaluate;
mod factor;
mod forms;
mod lower;
mod order;
mod ready;
mod share;
mod writer;

pub use analysis::{AngleGroup, AngleValues, ArgumentCounts};
pub use evaluate::TapeArguments;
pub use ready::constant_parts;

use crate::expressions::graph::{BinaryFunction, Node, NodeMap, Place, UnaryFunction};

/// Index of a value in a tape: the result of the instruction with that number.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct TapeSlot(pub u32);

impl TapeSlot {
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// Source of a tape's argument.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Argument {
    /// Value that depends on the parameters alone.
    Constant(u16),
    State(u16),
    /// Input (0) or a rate of it (1, 2, 3).
    Input(u8),
    Extra(u16),
}

/// One operation on at most three earlier values.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Instruction {
    Number(f64),
    Argument(Argument),
    Add(TapeSlot, TapeSlot),
    Subtract(TapeSlot, TapeSlot),
    Multiply(TapeSlot, TapeSlot),
    Divide(TapeSlot, TapeSlot),
    Negate(TapeSlot),
    Unary(UnaryFunction, TapeSlot),
    Binary(BinaryFunction, TapeSlot, TapeSlot),
    /// The second where the first is positive, else the third.
    Select(TapeSlot, TapeSlot, TapeSlot),
}

/// Straight-line program: the instruction `i` gives the value of the slot `i`.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Tape {
    pub instructions: Vec<Instruction>,
    pub outputs: Vec<TapeSlot>,
}

/// Arguments for symbols and for ready expressions; the state's layout may lack coordinates.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct ArgumentLayout {
    places: NodeMap<Place, Argument>,
    ready: NodeMap<Node, Argument>,
}

impl ArgumentLayout {
    pub fn place(&mut self, place: Place, argument: Argument) {
        self.places.insert(place, argument);
    }

    pub fn ready(&mut self, node: Node, argument: Argument) {
        self.ready.insert(node, argument);
    }
}
