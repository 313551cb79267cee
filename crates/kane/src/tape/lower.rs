//! From the graph to a tape.

use std::collections::HashMap;

use super::{Instruction, Layout, Slot, Tape};
use crate::graph::{Graph, Node, Operation, Place};

impl Tape {
    /// Returns the program of `outputs`.
    ///
    /// # Errors
    /// A symbol that `layout` gives no argument.
    pub fn lower(graph: &Graph, layout: &Layout, outputs: &[Node]) -> Result<Self, Place> {
        let mut lowering = Lowering::default();
        // What is given ready hides what it is made of.
        for node in needed(graph, layout, outputs) {
            let slot = match layout.ready.get(&node) {
                Some(argument) => lowering.push(Instruction::Argument(*argument)),
                None => lowering.node(graph, layout, node)?,
            };
            lowering.slots.insert(node, slot);
        }
        let outputs = outputs.iter().map(|node| lowering.slots[node]).collect();
        Ok(Self { instructions: lowering.instructions, outputs })
    }
}

/// The nodes that are computed or read, operands first.
fn needed(graph: &Graph, layout: &Layout, outputs: &[Node]) -> Vec<Node> {
    let mut wanted: std::collections::BTreeSet<Node> = outputs.iter().copied().collect();
    let mut all = Vec::new();
    while let Some(node) = wanted.pop_last() {
        all.push(node);
        if !layout.ready.contains_key(&node) {
            graph.operation(node).operands(|operand| {
                wanted.insert(operand);
            });
        }
    }
    all.reverse();
    all
}

/// A tape that is being written; equal instructions are written once.
#[derive(Default)]
struct Lowering {
    instructions: Vec<Instruction>,
    known: HashMap<[u64; 4], Slot>,
    slots: HashMap<Node, Slot>,
}

impl Lowering {
    fn push(&mut self, instruction: Instruction) -> Slot {
        let key = key(&instruction);
        if let Some(slot) = self.known.get(&key) {
            return *slot;
        }
        let slot = Slot(u32::try_from(self.instructions.len()).unwrap_or(u32::MAX));
        self.instructions.push(instruction);
        self.known.insert(key, slot);
        slot
    }

    fn node(&mut self, graph: &Graph, layout: &Layout, node: Node) -> Result<Slot, Place> {
        let slot = |it: &Node| self.slots[it];
        Ok(match graph.operation(node) {
            Operation::Number(bits) => self.push(Instruction::Number(f64::from_bits(*bits))),
            Operation::Symbol(place) => {
                let argument = layout.places.get(place).ok_or(*place)?;
                self.push(Instruction::Argument(*argument))
            }
            Operation::Sum(number, terms) => {
                let terms: Vec<_> =
                    terms.iter().map(|(it, by)| (slot(it), f64::from_bits(*by))).collect();
                self.sum(f64::from_bits(*number), &terms)
            }
            Operation::Product(factors) => {
                let factors: Vec<_> = factors.iter().map(|(it, by)| (slot(it), *by)).collect();
                self.product(&factors)
            }
            Operation::Unary(function, x) => {
                let x = slot(x);
                self.push(Instruction::Unary(*function, x))
            }
            Operation::Binary(function, x, y) => {
                let (x, y) = (slot(x), slot(y));
                self.push(Instruction::Binary(*function, x, y))
            }
            Operation::Select([condition, positive, other]) => {
                let [condition, positive, other] = [condition, positive, other].map(slot);
                self.push(Instruction::Select(condition, positive, other))
            }
        })
    }

    /// Terms with the factor −1 are subtracted; the first is a positive one if there is any.
    fn sum(&mut self, number: f64, terms: &[(Slot, f64)]) -> Slot {
        let mut total = (number != 0.0).then(|| self.push(Instruction::Number(number)));
        let (positive, negative): (Vec<_>, Vec<_>) = terms.iter().partition(|(_, by)| *by > 0.0);
        for (slot, factor) in positive {
            let term = self.times(slot, factor);
            total = Some(match total {
                Some(sum) => self.push(Instruction::Add(sum, term)),
                None => term,
            });
        }
        for (slot, factor) in negative {
            let term = self.times(slot, -factor);
            total = Some(match total {
                Some(sum) => self.push(Instruction::Subtract(sum, term)),
                None => self.push(Instruction::Negate(term)),
            });
        }
        total.unwrap_or_else(|| self.push(Instruction::Number(0.0)))
    }

    fn times(&mut self, slot: Slot, factor: f64) -> Slot {
        if factor == 1.0 {
            return slot;
        }
        let factor = self.push(Instruction::Number(factor));
        self.push(Instruction::Multiply(factor, slot))
    }

    /// One division at most: by the product of what has a negative exponent.
    fn product(&mut self, factors: &[(Slot, i32)]) -> Slot {
        let (above, below): (Vec<_>, Vec<_>) = factors.iter().partition(|(_, by)| *by > 0);
        let above = self.powers(&above);
        let below = self.powers(&below);
        match (above, below) {
            (Some(above), None) => above,
            (Some(above), Some(below)) => self.push(Instruction::Divide(above, below)),
            (None, Some(below)) => {
                let one = self.push(Instruction::Number(1.0));
                self.push(Instruction::Divide(one, below))
            }
            (None, None) => self.push(Instruction::Number(1.0)),
        }
    }

    fn powers(&mut self, factors: &[(Slot, i32)]) -> Option<Slot> {
        let mut product = None;
        for (slot, exponent) in factors {
            let power = self.power(*slot, exponent.unsigned_abs());
            product = Some(match product {
                Some(product) => self.push(Instruction::Multiply(product, power)),
                None => power,
            });
        }
        product
    }

    /// By repeated squaring.
    fn power(&mut self, slot: Slot, exponent: u32) -> Slot {
        if exponent <= 1 {
            return slot;
        }
        let half = self.power(slot, exponent / 2);
        let square = self.push(Instruction::Multiply(half, half));
        if exponent % 2 == 0 { square } else { self.push(Instruction::Multiply(square, slot)) }
    }
}

/// What makes two instructions the same.
fn key(instruction: &Instruction) -> [u64; 4] {
    let two = |kind: u64, x: Slot, y: Slot| [kind, u64::from(x.0), u64::from(y.0), 0];
    match *instruction {
        Instruction::Number(value) => [0, value.to_bits(), 0, 0],
        Instruction::Argument(argument) => {
            let (kind, index) = match argument {
                super::Argument::Constant(index) => (0, index),
                super::Argument::State(index) => (1, index),
                super::Argument::Input(index) => (2, u16::from(index)),
                super::Argument::Extra(index) => (3, index),
            };
            [1, kind, u64::from(index), 0]
        }
        Instruction::Add(x, y) => two(2, x.min(y), x.max(y)),
        Instruction::Subtract(x, y) => two(3, x, y),
        Instruction::Multiply(x, y) => two(4, x.min(y), x.max(y)),
        Instruction::Divide(x, y) => two(5, x, y),
        Instruction::Negate(x) => two(6, x, x),
        Instruction::Unary(function, x) => [7, function as u64, u64::from(x.0), 0],
        Instruction::Binary(function, x, y) => {
            [8 + ((function as u64) << 8), u64::from(x.0), u64::from(y.0), 0]
        }
        Instruction::Select(x, y, z) => [9, u64::from(x.0), u64::from(y.0), u64::from(z.0)],
    }
}
