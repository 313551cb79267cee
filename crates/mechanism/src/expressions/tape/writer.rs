use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use super::{Argument, Instruction, TapeSlot};
use crate::expressions::graph::NodeMap;

/// Tape that is being written; equal instructions are written once.
#[derive(Debug, Default)]
pub(super) struct TapeWriter {
    instructions: Vec<Instruction>,
    known: NodeMap<[u64; 4], TapeSlot>,
    /// Time at which each value is ready, roughly in cycles of a present processor.
    ready: Vec<u32>,
}

type Signed = Reverse<(u32, TapeSlot, bool)>;

impl TapeWriter {
    pub(super) fn finish(self) -> Vec<Instruction> {
        self.instructions
    }

    pub(super) fn push(&mut self, instruction: Instruction) -> TapeSlot {
        let key = key(&instruction);
        if let Some(slot) = self.known.get(&key) {
            return *slot;
        }
        let slot = TapeSlot(u32::try_from(self.instructions.len()).unwrap_or(u32::MAX));
        let mut ready = 0;
        instruction.operands(|operand| ready = ready.max(self.ready[operand.index()]));
        self.ready.push(ready + latency(&instruction));
        self.instructions.push(instruction);
        self.known.insert(key, slot);
        slot
    }

    pub(super) fn number(&mut self, value: f64) -> TapeSlot {
        self.push(Instruction::Number(value))
    }

    /// Adds terms with factors of one magnitude first, then multiplies by it once.
    pub(super) fn sum(&mut self, number: f64, terms: &[(TapeSlot, f64)]) -> TapeSlot {
        let mut groups: BTreeMap<u64, Vec<(TapeSlot, bool)>> = BTreeMap::new();
        for (slot, factor) in terms {
            let group = groups.entry(factor.abs().to_bits()).or_default();
            group.push((*slot, *factor < 0.0));
        }
        let mut all = Vec::new();
        for (bits, group) in groups {
            let factor = f64::from_bits(bits);
            if factor.to_bits() == 1.0_f64.to_bits() {
                all.extend(group);
                continue;
            }
            let (sum, is_negative) = self.signed_sum(&group);
            let factor = self.number(factor);
            all.push((self.push(Instruction::Multiply(factor, sum)), is_negative));
        }
        if number != 0.0 || all.is_empty() {
            all.push((self.number(number.abs()), number < 0.0));
        }
        let (sum, is_negative) = self.signed_sum(&all);
        if is_negative { self.push(Instruction::Negate(sum)) } else { sum }
    }

    /// Adds values with signs, the earliest ready first; returns the sum and its sign.
    fn signed_sum(&mut self, all: &[(TapeSlot, bool)]) -> (TapeSlot, bool) {
        let signed = |it: &(TapeSlot, bool)| Reverse((self.ready[it.0.index()], it.0, it.1));
        let mut queue: BinaryHeap<Signed> = all.iter().map(signed).collect();
        loop {
            match (queue.pop(), queue.pop()) {
                (Some(Reverse(x)), Some(Reverse(y))) => {
                    let (slot, is_negative) = self.add((x.1, x.2), (y.1, y.2));
                    queue.push(Reverse((self.ready[slot.index()], slot, is_negative)));
                }
                (Some(Reverse((_, slot, is_negative))), _) => return (slot, is_negative),
                (None, _) => return (self.number(0.0), false),
            }
        }
    }

    fn add(
        &mut self,
        (x, x_negative): (TapeSlot, bool),
        (y, y_negative): (TapeSlot, bool),
    ) -> (TapeSlot, bool) {
        match (x_negative, y_negative) {
            (false, false) => (self.push(Instruction::Add(x, y)), false),
            (true, true) => (self.push(Instruction::Add(x, y)), true),
            (false, true) => (self.push(Instruction::Subtract(x, y)), false),
            (true, false) => (self.push(Instruction::Subtract(y, x)), false),
        }
    }

    /// Multiplies with at most one division: by the product of factors with negative exponents.
    pub(super) fn product(&mut self, factors: &[(TapeSlot, i32)]) -> TapeSlot {
        let (above, below): (Vec<_>, Vec<_>) = factors.iter().partition(|(_, by)| *by > 0);
        let above = self.powers(&above).unwrap_or_else(|| self.number(1.0));
        match self.powers(&below) {
            Some(below) => self.push(Instruction::Divide(above, below)),
            None => above,
        }
    }

    fn powers(&mut self, factors: &[(TapeSlot, i32)]) -> Option<TapeSlot> {
        let mut queue = BinaryHeap::new();
        for (slot, exponent) in factors {
            let power = self.power(*slot, exponent.unsigned_abs());
            queue.push(Reverse((self.ready[power.index()], power)));
        }
        loop {
            let Reverse((_, x)) = queue.pop()?;
            let Some(Reverse((_, y))) = queue.pop() else { return Some(x) };
            let product = self.push(Instruction::Multiply(x, y));
            queue.push(Reverse((self.ready[product.index()], product)));
        }
    }

    fn power(&mut self, slot: TapeSlot, exponent: u32) -> TapeSlot {
        if exponent <= 1 {
            return slot;
        }
        let half = self.power(slot, exponent / 2);
        let square = self.push(Instruction::Multiply(half, half));
        if exponent.is_multiple_of(2) {
            square
        } else {
            self.push(Instruction::Multiply(square, slot))
        }
    }
}

const fn latency(instruction: &Instruction) -> u32 {
    match instruction {
        Instruction::Number(_) | Instruction::Argument(_) => 0,
        Instruction::Negate(_) => 1,
        Instruction::Select(..) => 3,
        Instruction::Add(..) | Instruction::Subtract(..) | Instruction::Multiply(..) => 4,
        Instruction::Divide(..) => 14,
        Instruction::Unary(..) => 30,
        Instruction::Binary(..) => 50,
    }
}

fn key(instruction: &Instruction) -> [u64; 4] {
    let two = |kind: u64, x: TapeSlot, y: TapeSlot| [kind, u64::from(x.0), u64::from(y.0), 0];
    match *instruction {
        Instruction::Number(value) => [0, value.to_bits(), 0, 0],
        Instruction::Argument(argument) => {
            let (kind, index) = match argument {
                Argument::Constant(index) => (0, index),
                Argument::State(index) => (1, index),
                Argument::Input(index) => (2, u16::from(index)),
                Argument::Extra(index) => (3, index),
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
