//! Interval arithmetic: the range of a tape's values over a range of arguments. `[MKC09]`
//!
//! A result contains the results of `f64` and of exact arithmetic for any numbers of the operands:
//! each bound is moved outwards by the possible rounding. A result that is undefined for, or jumps
//! at, some number of an operand is undefined.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::{Add, Div, Mul, Neg, Sub};

use mechanism::expressions::graph::{BinaryFunction, UnaryFunction};
use mechanism::expressions::tape::{Instruction, Tape, TapeSlot};

/// Largest angle with known turning points of a wave (rad).
const MAX_ANGLE: f64 = 1e12;

/// All numbers from `lo` to `hi`; undefined if these are NaN.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(super) struct Interval {
    lo: f64,
    hi: f64,
}

/// Returns the ranges of the outputs of `tape` with each argument in `argument`.
pub(super) fn enclose(tape: &Tape, argument: Interval) -> Vec<Interval> {
    let mut values: Vec<Interval> = Vec::with_capacity(tape.instructions.len());
    for instruction in &tape.instructions {
        let of = |slot: TapeSlot| values[slot.index()];
        let value = match *instruction {
            Instruction::Number(number) => Interval::new(number, number),
            Instruction::Argument(_) => argument,
            Instruction::Add(x, y) => of(x) + of(y),
            Instruction::Subtract(x, y) => of(x) - of(y),
            Instruction::Multiply(x, y) if x == y => of(x).whole_power(2.0),
            Instruction::Multiply(x, y) => of(x) * of(y),
            Instruction::Divide(x, y) => of(x) / of(y),
            Instruction::Negate(x) => -of(x),
            Instruction::Unary(function, x) => of(x).unary(function),
            Instruction::Binary(function, x, y) => of(x).binary(function, of(y)),
            Instruction::Select(condition, positive, other) => match of(condition) {
                Interval { lo, .. } if lo > 0.0 => of(positive),
                Interval { hi, .. } if hi <= 0.0 => of(other),
                Interval { .. } => Interval::UNDEFINED,
            },
        };
        values.push(value);
    }
    tape.outputs.iter().map(|slot| values[slot.index()]).collect()
}

fn outwards(lo: f64, hi: f64, units: usize) -> Interval {
    let lo = (0..units).fold(lo, |lo, _unit| lo.next_down());
    let hi = (0..units).fold(hi, |hi, _unit| hi.next_up());
    Interval::new(lo, hi)
}

/// Returns a function's range of results: a library errs by one or two units, this allows four.
fn around(values: [f64; 4]) -> Interval {
    spread(values, 4)
}

fn spread(values: [f64; 4], units: usize) -> Interval {
    if values.iter().any(|it| it.is_nan()) {
        return Interval::UNDEFINED;
    }
    let lo = values.into_iter().fold(f64::INFINITY, f64::min);
    outwards(lo, values.into_iter().fold(f64::NEG_INFINITY, f64::max), units)
}

impl Interval {
    const UNDEFINED: Self = Self { lo: f64::NAN, hi: f64::NAN };

    pub(super) fn new(lo: f64, hi: f64) -> Self {
        if lo <= hi { Self { lo, hi } } else { Self::UNDEFINED }
    }

    const fn is_undefined(self) -> bool {
        self.lo.is_nan() || self.hi.is_nan()
    }

    const fn contains(self, value: f64) -> bool {
        self.lo <= value && value <= self.hi
    }

    /// Returns the largest magnitude; infinite or NaN if there is none.
    pub(super) fn magnitude(self) -> f64 {
        if self.is_undefined() { f64::NAN } else { self.lo.abs().max(self.hi.abs()) }
    }

    fn magnitudes(self) -> Self {
        let least = if self.contains(0.0) { 0.0 } else { self.lo.abs().min(self.hi.abs()) };
        Self::new(least, self.magnitude())
    }

    /// Clips to the values that a function can have.
    fn within(self, least: f64, most: f64) -> Self {
        if self.is_undefined() { self } else { Self::new(self.lo.max(least), self.hi.min(most)) }
    }

    /// Returns the results at all pairs of ends: `[MKC09]` eq. 2.23 and 2.24.
    fn corners(self, other: Self, of: impl Fn(f64, f64) -> f64) -> [f64; 4] {
        let (a, b) = (self, other);
        [of(a.lo, b.lo), of(a.lo, b.hi), of(a.hi, b.lo), of(a.hi, b.hi)]
    }

    /// Returns the range of a monotonic function with values from `least` to `most`.
    fn monotonic(self, function: UnaryFunction, [least, most]: [f64; 2]) -> Self {
        if self.lo >= least && self.hi <= most {
            let (a, b) = (function.of(self.lo), function.of(self.hi));
            around([a, a, b, b])
        } else {
            Self::UNDEFINED
        }
    }

    fn unary(self, function: UnaryFunction) -> Self {
        const ALL: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
        let over = |domain| self.monotonic(function, domain);
        match function {
            UnaryFunction::Sin => self.wave(function, FRAC_PI_2),
            UnaryFunction::Cos => self.wave(function, 0.0),
            UnaryFunction::Tanh => over(ALL).within(-1.0, 1.0),
            UnaryFunction::Logistic => over(ALL).within(0.0, 1.0),
            UnaryFunction::Exp
            | UnaryFunction::Softplus
            | UnaryFunction::SoftplusArea
            | UnaryFunction::SoftplusSquareArea => over(ALL).within(0.0, f64::INFINITY),
            UnaryFunction::Ln => over([f64::MIN_POSITIVE, f64::INFINITY]),
            UnaryFunction::Sqrt => over([0.0, f64::INFINITY]).within(0.0, f64::INFINITY),
            UnaryFunction::Asin | UnaryFunction::Acos => over([-1.0, 1.0]),
            UnaryFunction::Abs => self.magnitudes(),
            UnaryFunction::Sign => match self {
                Self { lo, .. } if lo > 0.0 => Self::new(1.0, 1.0),
                Self { hi, .. } if hi < 0.0 => Self::new(-1.0, -1.0),
                Self { .. } => Self::UNDEFINED,
            },
        }
    }

    /// Returns the range of a wave of size 1 with a maximum at `top` (rad).
    fn wave(self, function: UnaryFunction, top: f64) -> Self {
        let (a, b) = (function.of(self.lo), function.of(self.hi));
        let least = if self.may_contain(top + PI, TAU) { -1.0 } else { a };
        let most = if self.may_contain(top, TAU) { 1.0 } else { b };
        around([a, b, least, most]).within(-1.0, 1.0)
    }

    /// Returns `true` if `at` plus a multiple of `period` may lie in it.
    fn may_contain(self, at: f64, period: f64) -> bool {
        /// Rounding of the multiple, at the largest accepted angle.
        const SLACK: f64 = 1e-3;
        if self.is_undefined() || self.magnitude() > MAX_ANGLE {
            return true;
        }
        let slack = SLACK * self.magnitude() / MAX_ANGLE + 1e-14;
        let next = at + period * ((self.lo - slack - at) / period).ceil();
        // The quotient may have been rounded up past the multiple.
        next <= self.hi + slack || next - period >= self.lo - slack
    }

    fn binary(self, function: BinaryFunction, other: Self) -> Self {
        let at_corners = |a: Self, b: Self| around(a.corners(b, |a, b| function.of(a, b)));
        match function {
            // Written atan2(y, x): the angle has a cut where y is 0 and x is negative.
            BinaryFunction::Atan2 if other.lo > 0.0 || !self.contains(0.0) => {
                at_corners(self, other)
            }
            BinaryFunction::Atan2 => Self::UNDEFINED,
            BinaryFunction::Hypot => at_corners(self.magnitudes(), other.magnitudes()),
            BinaryFunction::Power => self.power(other),
            BinaryFunction::Min | BinaryFunction::Max => {
                if self.is_undefined() || other.is_undefined() {
                    return Self::UNDEFINED;
                }
                Self::new(function.of(self.lo, other.lo), function.of(self.hi, other.hi))
            }
        }
    }

    /// Returns powers: integer ones of any base, others of a base that is not negative.
    fn power(self, exponent: Self) -> Self {
        let Self { lo: n, hi } = exponent;
        if n >= hi && n.fract() == 0.0 {
            return self.whole_power(n);
        }
        if self.lo > 0.0 || (self.lo == 0.0 && n > 0.0) {
            around(self.corners(exponent, f64::powf)).within(0.0, f64::INFINITY)
        } else {
            Self::UNDEFINED
        }
    }

    fn whole_power(self, n: f64) -> Self {
        if n < 0.0 && self.contains(0.0) {
            return Self::UNDEFINED;
        }
        let is_even = n.rem_euclid(2.0) == 0.0;
        let Self { lo, hi } = if is_even { self.magnitudes() } else { self };
        let range = around([lo.powf(n), hi.powf(n), lo.powf(n), hi.powf(n)]);
        if is_even { range.within(0.0, f64::INFINITY) } else { range }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        outwards(self.lo + other.lo, self.hi + other.hi, 1)
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        spread(self.corners(other, |a, b| a * b), 1)
    }
}

impl Div for Interval {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if other.contains(0.0) {
            return Self::UNDEFINED;
        }
        spread(self.corners(other, |a, b| a / b), 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks that a function's range over `lo` to `hi` contains its values, and not much more.
    #[track_caller]
    fn check(found: Interval, value: impl Fn(f64) -> f64, lo: f64, hi: f64) {
        let places = (0..=1000).map(|n| (lo + (hi - lo) * f64::from(n) / 1000.0).min(hi));
        let (least, most) = places.map(value).fold((f64::INFINITY, f64::NEG_INFINITY), |it, y| {
            assert!(found.contains(y), "{y} is not in {found:?}");
            (it.0.min(y), it.1.max(y))
        });
        // Between 1,001 points a smooth function turns by a millionth of its range.
        let slack = 1e-5 * (most - least) + 1e-14 * (1.0 + most.abs());
        assert!(found.lo >= least - slack && found.hi <= most + slack, "{found:?} {least} {most}");
    }

    #[test]
    fn functions_contain_their_values_and_little_more() {
        use UnaryFunction::{Abs, Acos, Asin, Cos, Exp, Ln, Logistic, Sin, Softplus, Sqrt, Tanh};
        for (lo, hi) in [(-1.0, 1.0), (0.3, 0.9), (-4.0, -3.0), (2.0, 9.0), (1e3, 1e3 + 1.0)] {
            let x = Interval::new(lo, hi);
            for function in [Sin, Cos, Tanh, Abs, Softplus, Logistic] {
                check(x.unary(function), |x| function.of(x), lo, hi);
            }
            check(x.whole_power(2.0), |x| x * x, lo, hi);
            check(x.whole_power(3.0), |x| x * x * x, lo, hi);
            let two = Interval::new(2.0, 2.0);
            for function in [BinaryFunction::Atan2, BinaryFunction::Hypot, BinaryFunction::Min] {
                check(x.binary(function, two), |x| function.of(x, 2.0), lo, hi);
            }
        }
        for (function, lo, hi) in [
            (Exp, -4.0, -3.0),
            (Exp, -1.0, 1.0),
            (Ln, 0.5, 2.0),
            (Sqrt, 0.0, 4.0),
            (Asin, -1.0, 0.5),
            (Acos, -1.0, 0.5),
        ] {
            check(Interval::new(lo, hi).unary(function), |x| function.of(x), lo, hi);
        }
        let power = |lo, hi, n| Interval::new(lo, hi).power(Interval::new(n, n));
        check(power(-4.0, -3.0, -2.0), |x| x.powi(-2), -4.0, -3.0);
        check(power(0.0, 4.0, 1.5), |x| x.powf(1.5), 0.0, 4.0);
    }

    #[test]
    fn poles_edges_and_jumps_are_undefined() {
        let over = Interval::new;
        let one = over(1.0, 1.0);
        let undefined = [
            one / over(-1.0, 1.0),
            over(-0.1, 4.0).unary(UnaryFunction::Sqrt),
            over(0.0, 1.0).unary(UnaryFunction::Ln),
            over(0.5, 1.1).unary(UnaryFunction::Asin),
            over(-1.0, 1.0).unary(UnaryFunction::Sign),
            over(-1.0, 1.0).power(over(-1.0, -1.0)),
            over(-1.0, 1.0).power(over(0.5, 0.5)),
            over(-1.0, 1.0).binary(BinaryFunction::Atan2, over(-2.0, -1.0)),
            over(1.0, 0.0),
        ];
        for it in undefined {
            for it in [it, it * over(0.0, 0.0), it + one, -it, it.unary(UnaryFunction::Abs)] {
                assert!(it.is_undefined() && it.magnitude().is_nan(), "{undefined:?}");
            }
        }
    }

    #[test]
    fn a_third_lies_between_two_neighbours() {
        let [one, three, tenth] = [1.0, 3.0, 0.1].map(|it| Interval::new(it, it));
        let third = one / three;
        assert!(third.lo < third.hi && third.contains(1.0 / 3.0));
        assert!((third * three).contains(1.0));
        let sum = tenth + Interval::new(0.2, 0.2);
        assert!(sum.contains(0.3) && sum.contains(0.1 + 0.2), "{sum:?}");
    }

    #[test]
    fn a_wave_far_away_is_anything_it_can_be() {
        let far = Interval::new(1e15, 1e15 + 1.0);
        assert_eq!(far.unary(UnaryFunction::Sin), Interval::new(-1.0, 1.0));
    }
}
