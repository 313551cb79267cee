//! Functions and their slopes, both of them series.

use super::rules::SeriesRule;
use super::writing::{Writing, slot_of};
use crate::expressions::graph::{BinaryFunction, UnaryFunction};
use crate::expressions::tape::{Instruction, TapeSlot};

impl Writing {
    pub(super) fn unary(&mut self, function: UnaryFunction, x: TapeSlot) -> TapeSlot {
        use UnaryFunction as F;
        let value = Instruction::Unary(function, x);
        if self.is_constant(x) || function == F::Sign {
            return self.push(value, SeriesRule::Constant);
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
            F::Abs | F::Sign => self.push(value, SeriesRule::Magnitude(x)),
            F::Asin | F::Acos => self.arc(function, x),
        }
    }

    /// Writes sine and cosine, each the slope of the other; the cosine's with the opposite sign.
    fn sine_or_cosine(&mut self, function: UnaryFunction, x: TapeSlot) -> TapeSlot {
        let sine = self.driven(UnaryFunction::Sin, x, self.next(1));
        let cosine = self.driven(UnaryFunction::Cos, x, self.next(1));
        self.push(Instruction::Negate(sine), SeriesRule::Negate(sine));
        if function == UnaryFunction::Sin { sine } else { cosine }
    }

    /// Writes tanh with the slope 1 − y², or the logistic function with y − y².
    fn sigmoid(&mut self, function: UnaryFunction, x: TapeSlot) -> TapeSlot {
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

    /// Writes an arc function with the slope ±1/√(1 − x²).
    fn arc(&mut self, function: UnaryFunction, x: TapeSlot) -> TapeSlot {
        let below = self.one_less_square(x);
        let root = self.root(below);
        let sign = self.number(if function == UnaryFunction::Asin { 1.0 } else { -1.0 });
        let slope = self.divide(sign, root);
        self.driven(function, x, slope)
    }

    pub(super) fn binary(
        &mut self,
        function: BinaryFunction,
        x: TapeSlot,
        y: TapeSlot,
    ) -> TapeSlot {
        let value = Instruction::Binary(function, x, y);
        if self.is_constant(x) && self.is_constant(y) {
            return self.push(value, SeriesRule::Constant);
        }
        match function {
            BinaryFunction::Min | BinaryFunction::Max => {
                let first_is_larger = self.subtract(x, y);
                let [above, below] = if function == BinaryFunction::Max { [x, y] } else { [y, x] };
                self.choice([first_is_larger, above, below])
            }
            BinaryFunction::Hypot => {
                let square = self.sum_of_squares(x, y);
                self.push(value, SeriesRule::Root(square))
            }
            BinaryFunction::Atan2 => self.angle(value, x, y),
            BinaryFunction::Power if self.is_constant(y) => {
                self.push(value, SeriesRule::Power(x, y))
            }
            BinaryFunction::Power => {
                let log = self.unary(UnaryFunction::Ln, x);
                let exponent = self.multiply(y, log);
                self.unary(UnaryFunction::Exp, exponent)
            }
        }
    }

    fn sum_of_squares(&mut self, x: TapeSlot, y: TapeSlot) -> TapeSlot {
        let (x, y) = (self.multiply(x, x), self.multiply(y, y));
        self.add(x, y)
    }

    /// Writes atan2(y, x): x/(x² + y²) times the rate of y, less y/(x² + y²) times that of x.
    fn angle(&mut self, value: Instruction, y: TapeSlot, x: TapeSlot) -> TapeSlot {
        let square = self.sum_of_squares(x, y);
        let [by_y, by_x] = [x, y].map(|it| self.divide(it, square));
        // Their own values are zero: each is a part of the angle that begins at zero.
        let zero = self.number(0.0);
        let mut part = |slope, of| {
            if self.is_constant(of) { zero } else { self.integral(slope, of) }
        };
        let [rising, falling] = [part(by_y, y), part(by_x, x)];
        self.push(value, SeriesRule::Subtract(rising, falling))
    }

    fn integral(&mut self, slope: TapeSlot, of: TapeSlot) -> TapeSlot {
        self.push(Instruction::Number(0.0), SeriesRule::Driven { slope, of })
    }

    pub(super) fn choice(&mut self, [condition, x, y]: [TapeSlot; 3]) -> TapeSlot {
        let value = Instruction::Select(condition, x, y);
        // The choice may change even where both are constant: not along a step.
        self.unless_constant(&[x, y], value, SeriesRule::Choice(condition, x, y))
    }
}
