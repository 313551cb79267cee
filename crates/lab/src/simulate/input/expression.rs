//! An input given as a formula of t, exact with its first three derivatives.

use std::cell::Cell;
use std::fmt;
use std::thread;

use exmex::{Differentiate as _, ExError, ExResult, Express as _, FlatEx};
use pode::Motion;

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
        let derivatives =
            with_derivatives(formula).map_err(|cause| InputMistake::NotDerivable { cause })?;
        let expression = Self { derivatives, last: Cell::new((f64::NAN, Motion::default())) };
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
}

/// `formula` and its first three derivatives with respect to t.
///
/// exmex goes down into an expression by recursion, tens of kilobytes a level, and a
/// derivative is some levels deeper than what it is of: hence a thread with room.
fn with_derivatives(formula: String) -> ExResult<Vec<FlatEx<f64>>> {
    let failed = |why: &dyn fmt::Display| ExError::new(&why.to_string());
    let thread = thread::Builder::new().name("derive".into()).stack_size(STACK);
    let derived = thread.spawn(move || derive(&formula)).map_err(|error| failed(&error))?.join();
    derived.unwrap_or_else(|_panic| Err(failed(&"it gave up on it")))
}

#[expect(clippy::large_stack_frames, reason = "exmex keeps short expressions inline; once")]
fn derive(formula: &str) -> ExResult<Vec<FlatEx<f64>>> {
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
