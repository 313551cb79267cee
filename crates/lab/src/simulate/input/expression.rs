//! An input given as a formula of t, exact with its first three derivatives, and bounded.

use std::cell::Cell;
use std::fmt;
use std::thread;

use exmex::{DiffDataType, Differentiate as _, MakeOperators};
use exmex::{ExError, ExResult, Express as _, FlatEx};
use pode::Motion;

use super::interval::{Interval, IntervalOperators};
use super::spelling::spelt_out;
use super::{InputMistake, NAME, is_finite};

/// Room for exmex's recursion on the longest expression; untouched pages cost nothing.
const STACK: usize = 256 << 20;
/// Longest expression that is derived once more (bytes): a second or two.
const MOST_LENGTH: usize = 12_000;

/// s(t) and its rates.
pub(in super::super) struct Expression {
    /// s and its first three derivatives, each of t alone.
    derivatives: Vec<FlatEx<f64>>,
    /// The same over ranges of t; none where exmex knows a function for numbers only.
    ranges: Vec<FlatEx<Interval, IntervalOperators>>,
    /// The last t and what came out: stages, guards and readouts share their instants.
    last: Cell<(f64, Motion)>,
}

impl Expression {
    /// Reads `text`, which begins with `name` and `=`.
    pub(super) fn read(text: &str, name: &str) -> Result<Self, InputMistake> {
        if name != NAME {
            return Err(InputMistake::Name { name: name.to_owned() });
        }
        let begin = text.find('=').map_or(0, |at| at + 1);
        let formula = spelt_out(&text[begin..]).map_err(|misspelt| {
            let column = text[..begin + misspelt.at].chars().count() + 1;
            InputMistake::Spelling { column, problem: misspelt.problem }
        })?;
        let (derivatives, ranges) =
            with_derivatives(formula).map_err(|cause| InputMistake::NotDerivable { cause })?;
        let last = Cell::new((f64::NAN, Motion::default()));
        let expression = Self { derivatives, ranges, last };
        if is_finite(&expression.at(0.0)) { Ok(expression) } else { Err(InputMistake::NotFinite) }
    }

    /// s and its rates at `t` (s).
    pub(super) fn at(&self, t: f64) -> Motion {
        let (last, motion) = self.last.get();
        if last.to_bits() == t.to_bits() {
            return motion;
        }
        let [position, rate, acceleration, jerk] = [0, 1, 2, 3].map(|order| {
            // One variable is always the right number of them: `derive` saw to it.
            self.derivatives[order].eval(&[t]).unwrap_or(f64::NAN)
        });
        let motion = Motion { position, rate, acceleration, jerk };
        self.last.set((t, motion));
        motion
    }

    /// Largest magnitudes of s and its rates from `from` to `to` (s); `None` where one of them is
    /// not defined or not finite all over that time.
    pub(super) fn bound(&self, from: f64, to: f64) -> Option<Motion> {
        let time = Interval::new(from, to);
        let most = |order: usize| {
            let range = self.ranges.get(order)?.eval(&[time]).ok()?;
            Some(range.magnitude()).filter(|most| most.is_finite())
        };
        Some(Motion { position: most(0)?, rate: most(1)?, acceleration: most(2)?, jerk: most(3)? })
    }
}

/// A formula and its first three derivatives, for numbers and for ranges.
type Derived = (Vec<FlatEx<f64>>, Vec<FlatEx<Interval, IntervalOperators>>);

/// `formula` and its first three derivatives with respect to t.
///
/// exmex goes down into an expression by recursion, tens of kilobytes a level, and a
/// derivative is some levels deeper than what it is of: hence a thread with room.
fn with_derivatives(formula: String) -> ExResult<Derived> {
    let failed = |why: &dyn fmt::Display| ExError::new(&why.to_string());
    let thread = thread::Builder::new().name("derive".into()).stack_size(STACK);
    let derived =
        thread.spawn(move || derive_both(&formula)).map_err(|error| failed(&error))?.join();
    derived.unwrap_or_else(|_panic| Err(failed(&"it gave up on it")))
}

/// Derives for numbers, and then for ranges, without which there are no bounds.
fn derive_both(formula: &str) -> ExResult<Derived> {
    let numbers = derive(formula)?;
    Ok((numbers, derive(formula).unwrap_or_default()))
}

/// Derives a formula three times, for whatever is calculated with.
fn derive<T, O>(formula: &str) -> ExResult<Vec<FlatEx<T, O>>>
where
    T: DiffDataType,
    T::Err: fmt::Debug,
    O: MakeOperators<T>,
{
    // The added term makes each of them a function of t, also where t has dropped out.
    let mut derivatives = vec![FlatEx::parse(&format!("({formula})+0*t"))?];
    for _ in 0..3 {
        let Some(last) = derivatives.last().filter(|last| last.unparse().len() <= MOST_LENGTH)
        else {
            return Err(ExError::new("its derivatives are too long; give a CSV file"));
        };
        derivatives.push(last.clone().partial(0)?);
    }
    Ok(derivatives)
}

impl fmt::Debug for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Expression").field(&self.derivatives[0].unparse()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks s, s', s'', s''' of `text` at `t` against closed forms.
    ///
    /// Error model: a few roundings per operation, at the size of the largest term.
    #[track_caller]
    fn check(text: &str, t: f64, expected: [f64; 4]) {
        let s = Expression::read(text, "s").expect("an expression").at(t);
        let got = [s.position, s.rate, s.acceleration, s.jerk];
        for (order, (got, expected)) in got.into_iter().zip(expected).enumerate() {
            let tolerance = 1e-13 * expected.abs().max(1.0);
            let error = (got - expected).abs();
            assert!(error <= tolerance, "{text}, order {order}: {got} is not {expected}");
        }
    }

    #[test]
    fn polynomials() {
        check("s=0.3", 0.7, [0.3, 0.0, 0.0, 0.0]);
        check("s=-t^2", 0.0, [0.0, 0.0, -2.0, 0.0]);
        check("s=1e-3*t^3 - 2*t", 2.0, [0.008 - 4.0, 0.012 - 2.0, 0.012, 0.006]);
        check("s=(1-t)^3", 2.0, [-1.0, -3.0, -6.0, -6.0]);
        check("s=8/2*t-3-1", 1.0, [0.0, 4.0, 0.0, 0.0]);
    }

    #[test]
    fn waves() {
        let w = std::f64::consts::TAU;
        let (sin, cos) = (w * 0.3).sin_cos();
        let expected = [0.1 * sin, 0.1 * w * cos, -0.1 * w * w * sin, -0.1 * w * w * w * cos];
        check("s=0.1*sin(2*pi*t)", 0.3, expected);
        check("s = 0.1*cos( tau*t - PI/2 )", 0.3, expected);
        let (sin, cos) = 1.4_f64.sin_cos();
        check("s=sin(t)^2", 0.7, [0.5 - 0.5 * cos, sin, 2.0 * cos, -4.0 * sin]);
    }

    #[test]
    fn bells_and_steps() {
        let (a, tc, w, t): (f64, f64, f64, f64) = (0.186, 1.573, 0.059, 1.55);
        let z = (t - tc) / w;
        let bell = a * (-z * z).exp();
        let expected = [
            bell,
            bell * -2.0 * z / w,
            bell * (4.0 * z * z - 2.0) / (w * w),
            bell * (12.0 * z - 8.0 * z * z * z) / (w * w * w),
        ];
        check("s=0.186*exp(-((t-1.573)/0.059)^2)", t, expected);
        let (w, t): (f64, f64) = (0.015, 0.11);
        let h = ((t - 0.1) / w).tanh();
        let d = 1.0 - h * h;
        let expected =
            [0.5 * (1.0 + h), 0.5 * d / w, -h * d / w.powi(2), (2.0 * h * h - d) * d / w.powi(3)];
        check("s=(1+tanh((t-0.1)/0.015))/2", t, expected);
    }

    #[test]
    fn every_derivable_function() {
        let t = 0.4_f64;
        let r = 1.0 + t * t;
        let q = 1.0 - t * t;
        let (sec, tan) = (1.0 / t.cos().powi(2), t.tan());
        check("s=exp(t)", t, [t.exp(); 4]);
        check("s=e^t", t, [t.exp(); 4]);
        for (name, base) in
            [("ln", 1.0_f64.exp()), ("log", 1.0_f64.exp()), ("log2", 2.0), ("log10", 10.0)]
        {
            let k = 1.0 / base.ln();
            let x = 1.0 + t;
            let expected = [k * x.ln(), k / x, -k / x.powi(2), 2.0 * k / x.powi(3)];
            check(&format!("s={name}(1+t)"), t, expected);
        }
        let x = (1.0 + t).sqrt();
        check("s=sqrt(1+t)", t, [x, 0.5 / x, -0.25 / x.powi(3), 0.375 / x.powi(5)]);
        check("s=tan(t)", t, [tan, sec, 2.0 * sec * tan, sec * (4.0 * tan * tan + 2.0 * sec)]);
        let root = q.sqrt();
        let asin = [t.asin(), 1.0 / root, t / root.powi(3), (1.0 + 2.0 * t * t) / root.powi(5)];
        check("s=asin(t)", t, asin);
        check("s=acos(t)", t, [t.acos(), -asin[1], -asin[2], -asin[3]]);
        let atan = [1.0 / r, -2.0 * t / r.powi(2), (6.0 * t * t - 2.0) / r.powi(3)];
        check("s=atan(t)", t, [t.atan(), atan[0], atan[1], atan[2]]);
        check("s=sinh(t)", t, [t.sinh(), t.cosh(), t.sinh(), t.cosh()]);
        check("s=cosh(t)", t, [t.cosh(), t.sinh(), t.cosh(), t.sinh()]);
        let root = r.sqrt();
        let asinh = [1.0 / root, -t / root.powi(3), (2.0 * t * t - 1.0) / root.powi(5)];
        check("s=asinh(t)", t, [t.asinh(), asinh[0], asinh[1], asinh[2]]);
        let u = 2.0 + t;
        let root = (u * u - 1.0).sqrt();
        let acosh = [1.0 / root, -u / root.powi(3), (2.0 * u * u + 1.0) / root.powi(5)];
        check("s=acosh(2+t)", t, [u.acosh(), acosh[0], acosh[1], acosh[2]]);
        let atanh = [1.0 / q, 2.0 * t / q.powi(2), (6.0 * t * t + 2.0) / q.powi(3)];
        check("s=atanh(t)", t, [t.atanh(), atanh[0], atanh[1], atanh[2]]);
    }

    /// Expressions with where they begin (s), and how they move.
    const MOVES: [(&str, f64); 12] = [
        ("0.1*sin(2*pi*3*t)", 0.0),
        ("1.2*exp(-((t-0.35)/0.01)^2)", 0.3),
        ("0.5+0.5*tanh((t-0.1)/0.015)", 0.0),
        ("t^3-2*t^2+t/7", -1.0),
        ("(t-0.4)^4/(1+t^2)", 0.0),
        ("exp(-t)*cos(40*t)", 0.0),
        ("sqrt(1+t)*ln(2+t)", 0.0),
        ("atan(5*t)-asin(t/9)", 0.0),
        ("sinh(t)*cosh(2*t)", -0.4),
        ("(1+t)^1.5", 0.0),
        ("acosh(2+t)+asinh(t)", 0.0),
        ("2^t+log2(1+t)", 0.0),
    ];

    /// Checks the bound of `expression` over 3 ms from `from` (s) against 41 places in it.
    #[track_caller]
    fn check_bound(expression: &Expression, from: f64) {
        let width = 0.003;
        let most = expression.bound(from, from + width).expect("a bound");
        for part in 0..=40 {
            let s = expression.at(from + width * f64::from(part) / 40.0);
            let lower = s.position.abs() <= most.position && s.rate.abs() <= most.rate;
            let higher = s.acceleration.abs() <= most.acceleration && s.jerk.abs() <= most.jerk;
            assert!(lower && higher, "{expression:?} from {from}: {s:?} {most:?}");
        }
    }

    #[test]
    fn bounds_are_never_below_the_rates_themselves() {
        for (text, begin) in MOVES {
            let expression = Expression::read(&format!("s={text}"), "s").expect("an expression");
            for n in 0..50 {
                check_bound(&expression, begin + 0.01 * f64::from(n));
            }
        }
    }

    #[test]
    fn bounds_of_a_short_time_are_close_to_the_rates() {
        for (text, begin) in MOVES {
            let expression = Expression::read(&format!("s={text}"), "s").expect("an expression");
            let at = begin + 0.123;
            let (s, most) = (expression.at(at), expression.bound(at, at + 1e-9).expect("a bound"));
            for (now, most) in [
                (s.position, most.position),
                (s.rate, most.rate),
                (s.acceleration, most.acceleration),
                (s.jerk, most.jerk),
            ] {
                assert!(most <= now.abs() + 1e-4 * (1.0 + now.abs()), "{text}: {now} {most}");
            }
        }
    }

    #[test]
    fn a_time_with_a_pole_has_no_bound() {
        for text in ["1/(t-0.5)", "tan(pi*t)", "sqrt(t-0.5)", "ln(t-0.5)", "tanh(1/(t-0.5))"] {
            // Where it begins it has to be finite; these are, with t² for the shifted t.
            let text = format!("s={}", text.replace("(t-0.5)", "(0.25-t^2)"));
            let expression = Expression::read(&text, "s").expect("an expression");
            assert!(expression.bound(0.49, 0.51).is_none(), "{text}");
            assert!(expression.bound(0.1, 0.101).is_some(), "{text}");
        }
    }

    #[test]
    fn a_long_sum_is_derived_and_a_longer_one_refused() {
        let sum = |n: usize| {
            let terms: Vec<_> = (0..n).map(|i| format!("0.5*tanh((t-0.{i})/0.015)")).collect();
            format!("s={}", terms.join("+"))
        };
        assert!(Expression::read(&sum(40), "s").is_ok());
        let refused = Expression::read(&sum(100), "s").expect_err("too long");
        assert!(refused.to_string().contains("more than 250 operations"), "{refused}");
        let product = format!("s=t{}", "*sin(t)".repeat(60));
        let refused = Expression::read(&product, "s").expect_err("too long");
        assert!(refused.to_string().contains("too long; give a CSV file"), "{refused}");
    }
}
