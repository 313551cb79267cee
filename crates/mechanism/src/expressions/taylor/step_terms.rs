//! Coefficients of one order, from those of lower orders, as instructions.

use super::carried::{CarriedValue, extra};
use super::lanes::{LaneFactor, SeriesLane};
use super::recursion::Recursion;
use super::rules::SeriesRule;
use crate::expressions::tape::{Argument, Instruction, Tape, TapeSlot, TapeWriter};

/// Index in `extra` of the first carried value, after k and 1/k.
const CARRIED: usize = 2;

/// Coefficient; `None` where it is zero.
type Term = Option<TapeSlot>;

pub(super) struct StepTerms<'a> {
    recursion: &'a Recursion,
    lanes: &'a [SeriesLane],
    /// Number of carried values; the lanes' sums follow them.
    count: usize,
    writer: TapeWriter,
    terms: Vec<Term>,
    carried: Vec<CarriedValue>,
}

impl<'a> StepTerms<'a> {
    pub(super) fn new(recursion: &'a Recursion, lanes: &'a [SeriesLane], count: usize) -> Self {
        let terms = vec![None; recursion.rules.len()];
        let writer = TapeWriter::default();
        Self { recursion, lanes, count, writer, terms, carried: Vec::new() }
    }

    /// Returns the tape of `outputs` and lanes by the live coefficients, and the values it needs.
    pub(super) fn finish(
        mut self,
        is_live: &[bool],
        outputs: &[TapeSlot],
    ) -> (Tape, Vec<CarriedValue>) {
        // Operands precede their operation.
        for at in (0..is_live.len()).filter(|at| is_live[*at]) {
            self.terms[at] = self.term(at);
        }
        let mut all: Vec<Term> = outputs.iter().map(|it| self.now(*it)).collect();
        for lane in self.lanes {
            all.push(self.factor(lane.first));
        }
        for lane in self.lanes {
            all.push(self.factor(lane.second));
        }
        let all = all.into_iter().map(|it| it.unwrap_or_else(|| self.writer.number(0.0)));
        let outputs = all.collect();
        (Tape { instructions: self.writer.finish(), outputs }, self.carried)
    }

    fn now(&self, slot: TapeSlot) -> Term {
        self.terms[slot.index()]
    }

    fn factor(&mut self, factor: LaneFactor) -> Term {
        match factor {
            LaneFactor::Value(slot) => self.now(slot),
            LaneFactor::Rate(slot) => {
                let order = self.writer.push(extra(0));
                self.times(Some(order), self.now(slot))
            }
        }
    }

    fn sum(&mut self, a: LaneFactor, b: LaneFactor) -> Term {
        let lane = self.lanes.iter().position(|it| it.is_sum_of(a, b))?;
        Some(self.writer.push(extra(CARRIED + self.count + lane)))
    }

    fn carried(&mut self, value: CarriedValue) -> TapeSlot {
        let known = self.carried.iter().position(|it| *it == value);
        let at = known.unwrap_or(self.carried.len());
        if known.is_none() {
            self.carried.push(value);
        }
        self.writer.push(extra(CARRIED + at))
    }

    fn value(&mut self, slot: TapeSlot) -> TapeSlot {
        let instruction = self.recursion.tape.instructions[slot.index()];
        let is_at_hand = matches!(
            instruction,
            Instruction::Number(_) | Instruction::Argument(Argument::Constant(_))
        );
        if is_at_hand {
            self.writer.push(instruction)
        } else {
            self.carried(CarriedValue::Value(slot))
        }
    }

    fn plus(&mut self, a: Term, b: Term) -> Term {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.writer.push(Instruction::Add(a, b))),
            (a, b) => a.or(b),
        }
    }

    fn minus(&mut self, a: Term, b: Term) -> Term {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.writer.push(Instruction::Subtract(a, b))),
            (None, Some(b)) => Some(self.writer.push(Instruction::Negate(b))),
            (a, None) => a,
        }
    }

    fn times(&mut self, a: Term, b: Term) -> Term {
        Some(self.writer.push(Instruction::Multiply(a?, b?)))
    }

    /// Returns the sum, plus each factor's start times the other's coefficient.
    fn product(&mut self, x: TapeSlot, y: TapeSlot) -> Term {
        let sum = self.sum(LaneFactor::Value(x), LaneFactor::Value(y));
        let (first, second) = (self.value(x), self.value(y));
        let left = self.times(Some(first), self.now(y));
        let right = self.times(self.now(x), Some(second));
        let sum = self.plus(sum, left);
        self.plus(sum, right)
    }

    fn driven(&mut self, slope: TapeSlot, of: TapeSlot) -> Term {
        let (slope, is_negative) = self.recursion.slope(slope);
        let per_order = self.writer.push(extra(1));
        let sum = self.sum(LaneFactor::Rate(of), LaneFactor::Value(slope));
        let before = self.times(sum, Some(per_order));
        let slope = self.value(slope);
        let now = self.times(self.now(of), Some(slope));
        let term = self.plus(before, now);
        if is_negative { self.minus(None, term) } else { term }
    }

    /// Returns x to a constant power a, by x y' = a y x'. `[JZ05]` proposition 2.1.
    fn power(&mut self, at: TapeSlot, x: TapeSlot, by: TapeSlot) -> Term {
        let (exponent, one) = (Some(self.value(by)), self.writer.number(1.0));
        let more = self.plus(exponent, Some(one));
        let per_order = self.writer.push(extra(1));
        let of = LaneFactor::Value(at);
        let by_rate = self.sum(LaneFactor::Rate(x), of);
        let by_rate = self.times(by_rate, Some(per_order));
        let by_rate = self.times(more, by_rate);
        let by_value = self.sum(LaneFactor::Value(x), of);
        let before = self.minus(by_rate, by_value);
        let value = self.value(at);
        let slope = self.times(exponent, Some(value));
        let now = self.times(slope, self.now(x));
        let all = self.plus(before, now);
        let inverse = self.carried(CarriedValue::Over(1.0, x));
        let term = self.times(all, Some(inverse));
        self.unless_zero(x, x, term)
    }

    /// Returns a coefficient singular at a zero of `of`: none if it stays zero, NaN if it leaves.
    fn unless_zero(&mut self, start: TapeSlot, of: TapeSlot, term: Term) -> Term {
        let [start, now] = [Some(self.carried(CarriedValue::Value(start))), self.now(of)];
        let [start, now] = [start, now].map(|it| self.times(it, it));
        let is_any = self.plus(start, now)?;
        let zero = self.writer.number(0.0);
        Some(self.writer.push(Instruction::Select(is_any, term?, zero)))
    }

    fn term(&mut self, at: usize) -> Term {
        let own = super::writing::slot_of(at);
        match self.recursion.rules[at] {
            SeriesRule::Constant => None,
            SeriesRule::State(index) => Some(self.argument(Argument::State(index))),
            SeriesRule::Input(rate) => Some(self.argument(Argument::Input(rate))),
            SeriesRule::Add(x, y) => self.plus(self.now(x), self.now(y)),
            SeriesRule::Subtract(x, y) => self.minus(self.now(x), self.now(y)),
            SeriesRule::Negate(x) => self.minus(None, self.now(x)),
            SeriesRule::Scale(by, x) => {
                let by = self.value(by);
                self.times(Some(by), self.now(x))
            }
            SeriesRule::Product(x, y) => self.product(x, y),
            SeriesRule::Square(x) => {
                let sum = self.sum(LaneFactor::Value(x), LaneFactor::Value(x));
                let twice = self.carried(CarriedValue::Twice(x));
                let now = self.times(Some(twice), self.now(x));
                self.plus(sum, now)
            }
            SeriesRule::Quotient(x, y) => {
                let sum = self.sum(LaneFactor::Value(y), LaneFactor::Value(own));
                let value = self.value(own);
                let now = self.times(Some(value), self.now(y));
                let before = self.minus(self.now(x), sum);
                let all = self.minus(before, now);
                let inverse = self.carried(CarriedValue::Over(1.0, y));
                self.times(all, Some(inverse))
            }
            SeriesRule::Over(x, by) => {
                let inverse = self.carried(CarriedValue::Over(1.0, by));
                self.times(self.now(x), Some(inverse))
            }
            SeriesRule::Driven { slope, of } => self.driven(slope, of),
            SeriesRule::Root(x) => {
                let sum = self.sum(LaneFactor::Value(own), LaneFactor::Value(own));
                let before = self.minus(self.now(x), sum);
                let inverse = self.carried(CarriedValue::Over(0.5, own));
                let term = self.times(before, Some(inverse));
                self.unless_zero(own, x, term)
            }
            SeriesRule::Power(x, by) => self.power(own, x, by),
            SeriesRule::Magnitude(x) => {
                let sign = self.carried(CarriedValue::Sign(x));
                self.times(Some(sign), self.now(x))
            }
            SeriesRule::Choice(condition, x, y) => Some(self.choice(condition, x, y)),
        }
    }

    fn choice(&mut self, condition: TapeSlot, x: TapeSlot, y: TapeSlot) -> TapeSlot {
        let condition = self.value(condition);
        let [x, y] = [x, y].map(|it| self.now(it).unwrap_or_else(|| self.writer.number(0.0)));
        self.writer.push(Instruction::Select(condition, x, y))
    }

    fn argument(&mut self, argument: Argument) -> TapeSlot {
        self.writer.push(Instruction::Argument(argument))
    }
}
