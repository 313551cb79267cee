//! Functions of a range.
//!
//! A library's function errs by an unit or two in the last place; [`outwards`] allows for four.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::Interval;

/// Beyond this the place of a turn of a wave is not known (rad).
const MOST_ANGLE: f64 = 1e12;

/// The range between two values of a function that is calculated with rounding.
fn outwards(lo: f64, hi: f64) -> Interval {
    const UNITS: usize = 4;
    let lo = (0..UNITS).fold(lo, |lo, _unit| lo.next_down());
    let hi = (0..UNITS).fold(hi, |hi, _unit| hi.next_up());
    Interval::new(lo, hi)
}

impl Interval {
    /// A function that rises all over it.
    pub(super) fn rising(self, function: fn(f64) -> f64) -> Self {
        outwards(function(self.lo), function(self.hi))
    }

    /// A function that rises where it is defined: from `least` to `most`.
    fn rising_in(self, (least, most): (f64, f64), function: fn(f64) -> f64) -> Self {
        let is_inside = self.lo >= least && self.hi <= most;
        if is_inside { self.rising(function) } else { Self::UNDEFINED }
    }

    /// A function that only numbers have here, and no ranges.
    pub(super) fn at_point(self, function: fn(f64) -> f64) -> Self {
        self.as_point().map_or(Self::UNDEFINED, |value| outwards(function(value), function(value)))
    }

    /// The same kept to what the function can give.
    fn within(self, least: f64, most: f64) -> Self {
        if self.is_undefined() { self } else { Self::new(self.lo.max(least), self.hi.min(most)) }
    }

    pub(super) fn sqrt(self) -> Self {
        self.rising_in((0.0, f64::INFINITY), f64::sqrt).within(0.0, f64::INFINITY)
    }

    pub(super) fn exp(self) -> Self {
        self.rising(f64::exp).within(0.0, f64::INFINITY)
    }

    /// A logarithm to whatever base.
    pub(super) fn log(self, function: fn(f64) -> f64) -> Self {
        self.rising_in((f64::MIN_POSITIVE, f64::INFINITY), function)
    }

    pub(super) fn asin(self) -> Self {
        self.rising_in((-1.0, 1.0), f64::asin)
    }

    /// Falls where the arc of the sine rises.
    pub(super) fn acos(self) -> Self {
        let is_inside = self.lo >= -1.0 && self.hi <= 1.0;
        if is_inside { outwards(self.hi.acos(), self.lo.acos()) } else { Self::UNDEFINED }
    }

    pub(super) fn tanh(self) -> Self {
        self.rising(f64::tanh).within(-1.0, 1.0)
    }

    pub(super) fn acosh(self) -> Self {
        self.rising_in((1.0, f64::INFINITY), f64::acosh)
    }

    pub(super) fn atanh(self) -> Self {
        self.rising_in((-1.0, 1.0), f64::atanh)
    }

    pub(super) fn cosh(self) -> Self {
        let (a, b) = (self.lo.cosh(), self.hi.cosh());
        if self.is_undefined() {
            return self;
        }
        let lo = if self.contains(0.0) { 1.0 } else { a.min(b) };
        outwards(lo, a.max(b))
    }

    pub(super) fn sin(self) -> Self {
        self.wave(f64::sin, FRAC_PI_2)
    }

    pub(super) fn cos(self) -> Self {
        self.wave(f64::cos, 0.0)
    }

    /// Undefined over a pole.
    pub(super) fn tan(self) -> Self {
        if self.may_contain(FRAC_PI_2, PI) { Self::UNDEFINED } else { self.rising(f64::tan) }
    }

    /// A wave of size 1 with a maximum at `top` (rad).
    fn wave(self, function: fn(f64) -> f64, top: f64) -> Self {
        let (a, b) = (function(self.lo), function(self.hi));
        if self.is_undefined() || a.is_nan() || b.is_nan() {
            return Self::UNDEFINED;
        }
        let lo = if self.may_contain(top + PI, TAU) { -1.0 } else { a.min(b) };
        let hi = if self.may_contain(top, TAU) { 1.0 } else { a.max(b) };
        outwards(lo, hi).within(-1.0, 1.0)
    }

    /// Whether a place `at` plus a multiple of `period` may lie in it.
    fn may_contain(self, at: f64, period: f64) -> bool {
        /// Rounding of the multiple, at the largest angle that is taken.
        const SLACK: f64 = 1e-3;
        if self.is_undefined() || self.magnitude() > MOST_ANGLE {
            return true;
        }
        let slack = SLACK * self.magnitude() / MOST_ANGLE + 1e-14;
        let next = at + period * ((self.lo - slack - at) / period).ceil();
        // The quotient may have been rounded up past the place.
        next <= self.hi + slack || next - period >= self.lo - slack
    }

    /// Powers: whole ones of any base, others of a base that is not negative.
    pub(super) fn power(self, exponent: Self) -> Self {
        if self.is_undefined() || exponent.is_undefined() {
            return Self::UNDEFINED;
        }
        match exponent.as_point() {
            Some(0.0) => Self::from(1),
            Some(1.0) => self,
            Some(n) if n.fract() == 0.0 => self.whole_power(n),
            _ if self.lo > 0.0 || (self.lo == 0.0 && exponent.lo > 0.0) => {
                let values = [
                    self.lo.powf(exponent.lo),
                    self.lo.powf(exponent.hi),
                    self.hi.powf(exponent.lo),
                    self.hi.powf(exponent.hi),
                ];
                let lo = values.into_iter().fold(f64::INFINITY, f64::min);
                let hi = values.into_iter().fold(0.0, f64::max);
                outwards(lo, hi).within(0.0, f64::INFINITY)
            }
            _ => Self::UNDEFINED,
        }
    }

    /// A power by a whole number but 0 and 1.
    fn whole_power(self, n: f64) -> Self {
        let (a, b) = (self.lo.powf(n), self.hi.powf(n));
        if n < 0.0 && self.contains(0.0) {
            return Self::UNDEFINED;
        }
        let is_even = n.rem_euclid(2.0) == 0.0;
        if !is_even {
            return outwards(a.min(b), a.max(b));
        }
        let lo = if self.contains(0.0) { 0.0 } else { a.min(b) };
        outwards(lo, a.max(b)).within(0.0, f64::INFINITY)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks that `function` of a range contains its values, and not much more.
    #[track_caller]
    fn check(function: fn(Interval) -> Interval, value: fn(f64) -> f64, lo: f64, hi: f64) {
        let found = function(Interval::new(lo, hi));
        let places = (0..=1000).map(|n| lo + (hi - lo) * f64::from(n) / 1000.0);
        let (least, most) = places.map(value).fold((f64::INFINITY, f64::NEG_INFINITY), |it, y| {
            assert!(found.contains(y), "{y} is not in {found:?}");
            (it.0.min(y), it.1.max(y))
        });
        // Between 1,001 places a smooth function turns by a millionth of its range.
        let slack = 1e-5 * (most - least) + 1e-14;
        assert!(found.lo >= least - slack && found.hi <= most + slack, "{found:?} {least} {most}");
    }

    #[test]
    fn functions_contain_their_values_and_little_more() {
        for (lo, hi) in [(-1.0, 1.0), (0.3, 0.9), (-4.0, -3.0), (2.0, 9.0), (1e3, 1e3 + 1.0)] {
            check(Interval::sin, f64::sin, lo, hi);
            check(Interval::cos, f64::cos, lo, hi);
            check(Interval::tanh, f64::tanh, lo, hi);
        }
        for (lo, hi) in [(-1.0, 1.0), (0.3, 0.9), (-4.0, -3.0)] {
            check(Interval::cosh, f64::cosh, lo, hi);
            check(Interval::exp, f64::exp, lo, hi);
            check(|x| x.power(Interval::from(2)), |x| x * x, lo, hi);
            check(|x| x.power(Interval::from(3)), |x| x * x * x, lo, hi);
        }
        check(|x| x.power(-Interval::from(2)), |x| x.powi(-2), -4.0, -3.0);
        check(|x| x.power(Interval::point(1.5)), |x| x.powf(1.5), 0.0, 4.0);
        check(Interval::tan, f64::tan, -1.5, 1.5);
        check(Interval::acos, f64::acos, -1.0, 0.5);
        check(Interval::sqrt, f64::sqrt, 0.0, 4.0);
    }

    #[test]
    fn poles_and_edges_are_undefined() {
        let over = |lo, hi| Interval::new(lo, hi);
        let undefined = [
            over(1.5, 1.6).tan(),
            over(-0.1, 4.0).sqrt(),
            over(0.0, 1.0).log(f64::ln),
            over(0.5, 1.1).asin(),
            over(-1.0, 1.0).power(-Interval::from(1)),
            over(-1.0, 1.0).power(Interval::point(0.5)),
            over(0.0, 1.0).at_point(f64::abs),
            over(1.0, 0.0).cosh(),
        ];
        assert!(undefined.iter().all(|it| it.is_undefined()), "{undefined:?}");
    }

    #[test]
    fn a_wave_far_away_is_anything_it_can_be() {
        assert_eq!(Interval::new(1e15, 1e15 + 1.0).sin(), Interval::new(-1.0, 1.0));
    }
}
