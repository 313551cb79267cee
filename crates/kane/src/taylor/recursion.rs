//! From a tape to the recursion of its coefficients.

use super::rules::Rule;
use crate::graph::{BinaryFunction, UnaryFunction};
use crate::tape::{Argument, Instruction, Slot, Tape};

/// A tape with a rule for each of its values.
///
/// Where a function's slope is not there yet, the tape is made longer: that of tanh is 1 − tanh².
#[derive(Clone, PartialEq, Debug)]
pub struct Recursion {
    /// Values at the start; the outputs are the derivative's entries, and the guards.
    pub tape: Tape,
    /// How each value goes on.
    pub rules: Vec<Rule>,
    /// How many outputs are entries of the derivative; those after them are guards.
    pub entries: usize,
}

impl Recursion {
    /// Returns the recursion of a `tape` whose first `entries` outputs are the derivative.
    pub fn new(tape: &Tape, entries: usize) -> Self {
        let mut writing = Writing::default();
        for instruction in &tape.instructions {
            let slot = writing.instruction(*instruction);
            writing.places.push(slot);
        }
        let outputs: Vec<_> = tape.outputs.iter().map(|it| writing.places[it.index()]).collect();
        let entries = entries.min(outputs.len());
        let tape = Tape { instructions: writing.instructions, outputs };
        Self { tape, rules: writing.rules, entries }
    }

    /// Returns whether the value at `slot` stays as it is.
    pub fn is_constant(&self, slot: Slot) -> bool {
        self.rules[slot.index()] == Rule::Constant
    }

    /// The slots whose coefficients `outputs` depend on, in order.
    pub(super) fn live(&self, outputs: &[Slot]) -> Vec<bool> {
        let mut is_live = vec![false; self.rules.len()];
        let mut waiting = outputs.to_vec();
        while let Some(slot) = waiting.pop() {
            if self.is_constant(slot) || std::mem::replace(&mut is_live[slot.index()], true) {
                continue;
            }
            self.rules[slot.index()].operands(|operand| waiting.push(self.slope_or(slot, operand)));
        }
        is_live
    }

    /// The slots whose coefficient of one order `outputs` of that order depend on: of a slope only
    /// those before it count.
    pub(super) fn last(&self, outputs: &[Slot]) -> Vec<bool> {
        let mut is_live = vec![false; self.rules.len()];
        let mut waiting = outputs.to_vec();
        while let Some(slot) = waiting.pop() {
            if self.is_constant(slot) || std::mem::replace(&mut is_live[slot.index()], true) {
                continue;
            }
            match self.rules[slot.index()] {
                Rule::Driven { of, .. } => waiting.push(of),
                rule => rule.operands(|operand| waiting.push(operand)),
            }
        }
        is_live
    }

    /// The operand itself, or the slot whose row stands for it where it is only a slope.
    fn slope_or(&self, of: Slot, operand: Slot) -> Slot {
        match self.rules[of.index()] {
            Rule::Driven { slope, .. } if slope == operand => self.slope(slope).0,
            _ => operand,
        }
    }

    /// Returns the slots of the derivative's entries, and those of the guards.
    pub fn outputs(&self) -> (&[Slot], &[Slot]) {
        self.tape.outputs.split_at(self.entries)
    }

    /// The row of a slope, and whether it counts with the opposite sign.
    pub(super) fn slope(&self, slope: Slot) -> (Slot, bool) {
        match self.rules[slope.index()] {
            Rule::Negate(positive) => (positive, true),
            _ => (slope, false),
        }
    }
}

/// A recursion that is being written.
#[derive(Default)]
struct Writing {
    instructions: Vec<Instruction>,
    rules: Vec<Rule>,
    /// Where the values of the given tape stand.
    places: Vec<Slot>,
}

impl Writing {
    fn push(&mut self, instruction: Instruction, rule: Rule) -> Slot {
        // What has been written is not written twice.
        let known = self.instructions.iter().zip(&self.rules);
        if let Some(at) = known.into_iter().position(|it| it == (&instruction, &rule)) {
            return slot_of(at);
        }
        self.instructions.push(instruction);
        self.rules.push(rule);
        slot_of(self.rules.len() - 1)
    }

    fn is_constant(&self, slot: Slot) -> bool {
        self.rules[slot.index()] == Rule::Constant
    }

    fn number(&mut self, value: f64) -> Slot {
        self.push(Instruction::Number(value), Rule::Constant)
    }

    /// Writes an instruction of the given tape.
    fn instruction(&mut self, given: Instruction) -> Slot {
        let at = |slot: Slot| self.places[slot.index()];
        match given {
            Instruction::Number(_) => self.push(given, Rule::Constant),
            Instruction::Argument(argument) => self.push(given, of_argument(argument)),
            Instruction::Add(x, y) => self.add(at(x), at(y)),
            Instruction::Subtract(x, y) => self.subtract(at(x), at(y)),
            Instruction::Negate(x) => {
                let x = at(x);
                self.unless_constant(&[x], Instruction::Negate(x), Rule::Negate(x))
            }
            Instruction::Multiply(x, y) => self.multiply(at(x), at(y)),
            Instruction::Divide(x, y) => self.divide(at(x), at(y)),
            Instruction::Unary(function, x) => self.unary(function, at(x)),
            Instruction::Binary(function, x, y) => self.binary(function, at(x), at(y)),
            Instruction::Select(condition, x, y) => self.choice([condition, x, y].map(at)),
        }
    }

    fn unless_constant(&mut self, operands: &[Slot], value: Instruction, rule: Rule) -> Slot {
        let is_constant = operands.iter().all(|slot| self.is_constant(*slot));
        self.push(value, if is_constant { Rule::Constant } else { rule })
    }

    fn add(&mut self, x: Slot, y: Slot) -> Slot {
        self.unless_constant(&[x, y], Instruction::Add(x, y), Rule::Add(x, y))
    }

    fn subtract(&mut self, x: Slot, y: Slot) -> Slot {
        self.unless_constant(&[x, y], Instruction::Subtract(x, y), Rule::Subtract(x, y))
    }

    fn multiply(&mut self, x: Slot, y: Slot) -> Slot {
        let rule = match (self.is_constant(x), self.is_constant(y)) {
            (true, true) => Rule::Constant,
            (true, false) => Rule::Scale(x, y),
            (false, true) => Rule::Scale(y, x),
            (false, false) if x == y => Rule::Square(x),
            (false, false) => Rule::Product(x, y),
        };
        self.push(Instruction::Multiply(x, y), rule)
    }

    fn divide(&mut self, x: Slot, y: Slot) -> Slot {
        let rule = if self.is_constant(y) { Rule::Over(x, y) } else { Rule::Quotient(x, y) };
        self.unless_constant(&[x, y], Instruction::Divide(x, y), rule)
    }

    /// 1 − x².
    fn one_less_square(&mut self, x: Slot) -> Slot {
        let (one, square) = (self.number(1.0), self.multiply(x, x));
        self.subtract(one, square)
    }

    fn root(&mut self, x: Slot) -> Slot {
        let value = Instruction::Unary(UnaryFunction::Sqrt, x);
        self.unless_constant(&[x], value, Rule::Root(x))
    }

    /// The next place but `ahead`, for a slope that is written after what it is the slope of.
    fn next(&self, ahead: usize) -> Slot {
        slot_of(self.rules.len() + ahead)
    }

    /// A function of `x` that changes with `slope` times the rate of x.
    fn driven(&mut self, function: UnaryFunction, x: Slot, slope: Slot) -> Slot {
        self.push(Instruction::Unary(function, x), Rule::Driven { slope, of: x })
    }

    fn unary(&mut self, function: UnaryFunction, x: Slot) -> Slot {
        use UnaryFunction as F;
        let value = Instruction::Unary(function, x);
        if self.is_constant(x) || function == F::Sign {
            return self.push(value, Rule::Constant);
        }
        let known = self.instructions.iter().position(|it| *it == value);
        if let Some(at) = known {
            return slot_of(at);
        }
        match function {
            F::Sin | F::Cos => self.sine_or_cosine(function, x),
            F::Exp => self.driven(F::Exp, x, self.next(0)),
            F::Tanh | F::Logistic => self.sigmoid(function, x),
            F::Softplus => {
                let slope = self.unary(F::Logistic, x);
                self.driven(function, x, slope)
            }
            F::SoftplusArea => {
                let slope = self.unary(F::Softplus, x);
                self.driven(function, x, slope)
            }
            F::SoftplusSquareArea => {
                let softplus = self.unary(F::Softplus, x);
                let slope = self.multiply(softplus, softplus);
                self.driven(function, x, slope)
            }
            F::Ln => {
                let one = self.number(1.0);
                let slope = self.divide(one, x);
                self.driven(function, x, slope)
            }
            F::Sqrt => self.root(x),
            F::Abs | F::Sign => self.push(value, Rule::Magnitude(x)),
            F::Asin | F::Acos => self.arc(function, x),
        }
    }

    /// Both, each the slope of the other; the cosine's with the opposite sign.
    fn sine_or_cosine(&mut self, function: UnaryFunction, x: Slot) -> Slot {
        let sine = self.driven(UnaryFunction::Sin, x, self.next(1));
        let cosine = self.driven(UnaryFunction::Cos, x, self.next(1));
        self.push(Instruction::Negate(sine), Rule::Negate(sine));
        if function == UnaryFunction::Sin { sine } else { cosine }
    }

    /// tanh with the slope 1 − y², or the logistic function with y − y².
    fn sigmoid(&mut self, function: UnaryFunction, x: Slot) -> Slot {
        if function == UnaryFunction::Tanh {
            self.number(1.0);
            let value = self.driven(function, x, self.next(2));
            self.one_less_square(value);
            return value;
        }
        let value = self.driven(function, x, self.next(2));
        let square = self.multiply(value, value);
        self.subtract(value, square);
        value
    }

    /// The slope ±1/√(1 − x²).
    fn arc(&mut self, function: UnaryFunction, x: Slot) -> Slot {
        let below = self.one_less_square(x);
        let root = self.root(below);
        let sign = self.number(if function == UnaryFunction::Asin { 1.0 } else { -1.0 });
        let slope = self.divide(sign, root);
        self.driven(function, x, slope)
    }

    fn binary(&mut self, function: BinaryFunction, x: Slot, y: Slot) -> Slot {
        let value = Instruction::Binary(function, x, y);
        if self.is_constant(x) && self.is_constant(y) {
            return self.push(value, Rule::Constant);
        }
        match function {
            BinaryFunction::Min | BinaryFunction::Max => {
                let first_is_larger = self.subtract(x, y);
                let [above, below] = if function == BinaryFunction::Max { [x, y] } else { [y, x] };
                self.choice([first_is_larger, above, below])
            }
            BinaryFunction::Hypot => {
                let square = self.sum_of_squares(x, y);
                self.push(value, Rule::Root(square))
            }
            BinaryFunction::Atan2 => self.angle(value, x, y),
            BinaryFunction::Power if self.is_constant(y) => self.push(value, Rule::Power(x, y)),
            BinaryFunction::Power => {
                let log = self.unary(UnaryFunction::Ln, x);
                let exponent = self.multiply(y, log);
                self.unary(UnaryFunction::Exp, exponent)
            }
        }
    }

    fn sum_of_squares(&mut self, x: Slot, y: Slot) -> Slot {
        let (x, y) = (self.multiply(x, x), self.multiply(y, y));
        self.add(x, y)
    }

    /// atan2(y, x): x/(x² + y²) times the rate of y, less y/(x² + y²) times that of x.
    fn angle(&mut self, value: Instruction, y: Slot, x: Slot) -> Slot {
        let square = self.sum_of_squares(x, y);
        let [by_y, by_x] = [x, y].map(|it| self.divide(it, square));
        // Their own values are nothing: each is a part of the angle that begins at zero.
        let zero = self.number(0.0);
        let mut part = |slope, of| {
            if self.is_constant(of) { zero } else { self.integral(slope, of) }
        };
        let [rising, falling] = [part(by_y, y), part(by_x, x)];
        self.push(value, Rule::Subtract(rising, falling))
    }

    /// ∫ slope dx from the start on: 0 there.
    fn integral(&mut self, slope: Slot, of: Slot) -> Slot {
        self.push(Instruction::Number(0.0), Rule::Driven { slope, of })
    }

    fn choice(&mut self, [condition, x, y]: [Slot; 3]) -> Slot {
        let value = Instruction::Select(condition, x, y);
        // What is chosen may change even where both are constant: not along a step.
        self.unless_constant(&[x, y], value, Rule::Choice(condition, x, y))
    }
}

const fn of_argument(argument: Argument) -> Rule {
    match argument {
        Argument::State(index) => Rule::State(index),
        Argument::Input(index) => Rule::Input(index),
        Argument::Constant(_) | Argument::Extra(_) => Rule::Constant,
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a tape is shorter than 2³² instructions")]
const fn slot_of(index: usize) -> Slot {
    Slot(index as u32)
}
