//! The straight-line program of some expressions.
//!
//! What stands in the graph as sums and products of many terms becomes operations of two
//! operands, each value computed once. All ways out go over it: values, emitted Rust, native code.

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
pub(crate) use writer::TapeWriter;

use crate::expressions::graph::{BinaryFunction, Place, UnaryFunction};

/// The place of a value in a tape: the result of the instruction with that number.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct TapeSlot(pub u32);

impl TapeSlot {
    /// Returns the slot as an index into the tape's instructions.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// Where an argument of a tape comes from.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Argument {
    /// A value that depends on the parameters alone, by its number.
    Constant(u16),
    /// An entry of the state.
    State(u16),
    /// The input (0) or a rate of it (1, 2, 3).
    Input(u8),
    /// Any other argument, by its number.
    Extra(u16),
}

/// One operation of at most three operands, all of them before it.
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

/// A straight-line program: the instruction `i` gives the value of the slot `i`.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Tape {
    pub instructions: Vec<Instruction>,
    /// The slots of what it computes, in order.
    pub outputs: Vec<TapeSlot>,
}

/// Where a tape finds the values of symbols, and which expressions it is given ready.
///
/// The state's layout is a model's own: some coordinates are no entry of it.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct ArgumentLayout {
    places: std::collections::HashMap<Place, Argument>,
    ready: std::collections::HashMap<crate::expressions::graph::Node, Argument>,
}

impl ArgumentLayout {
    /// Says that the symbol at `place` is the argument `argument`.
    pub fn place(&mut self, place: Place, argument: Argument) {
        self.places.insert(place, argument);
    }

    /// Says that the value of `node` is given as `argument`.
    pub fn ready(&mut self, node: crate::expressions::graph::Node, argument: Argument) {
        self.ready.insert(node, argument);
    }
}
