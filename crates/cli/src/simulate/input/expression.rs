//! An input as a formula of t, exact with its first three derivatives, and bounded.

use std::cell::Cell;
use std::f64::consts::{E, PI, TAU};

use documents::quoted;
use mechanism::expressions::graph::{Graph, Place};
use mechanism::expressions::tape::{Argument, ArgumentLayout, Tape, TapeArguments};
use mechanism::formulas::{Dependence, Dimension, Form, Measured, NameError, NameScope, TextError};
use pode::Motion;

use super::interval::{Interval, enclose};
use super::{InputMistake, NAME, is_finite};

/// Symbol and argument of t.
const TIME: (Place, Argument) = (Place::Extra(0), Argument::Extra(0));

/// Maximum work before the next derivative: a derivative of n factors has n products of them.
const MAX_WORK: u64 = 30_000;

/// s(t) and its rates.
#[derive(Debug)]
pub(in super::super) struct Expression {
    tape: Tape,
    /// Last t with its motion: stages, guards and readouts share their instants.
    last: Cell<(f64, Motion)>,
}

impl Expression {
    /// Parses `text`, which begins with `name` and `=`.
    pub(super) fn read(text: &str, name: &str) -> Result<Self, Vec<InputMistake>> {
        if name != NAME {
            return Err(vec![InputMistake::Name { name: name.to_owned() }]);
        }
        let begin = text.find('=').map_or(0, |at| at + 1);
        let tape = derived(&text[begin..]).map_err(|errors| {
            let column = |error: &TextError| {
                text.get(..begin + error.span.start).map_or(1, |before| before.chars().count() + 1)
            };
            let mistake = |error: TextError| InputMistake::Spelling {
                column: column(&error),
                problem: format!("{}; {}", error.message, error.help),
            };
            errors.into_iter().map(mistake).collect::<Vec<_>>()
        })?;
        let tape = tape.ok_or_else(|| vec![InputMistake::TooLong])?;
        let expression = Self { tape, last: Cell::new((f64::NAN, Motion::default())) };
        let is_driven = is_finite(&expression.at(0.0));
        if is_driven { Ok(expression) } else { Err(vec![InputMistake::NotFinite]) }
    }

    /// Returns s and its rates at `t` (s).
    pub(super) fn at(&self, t: f64) -> Motion {
        let (last, motion) = self.last.get();
        if last.to_bits() == t.to_bits() {
            return motion;
        }
        let values = self.tape.evaluate(&TapeArguments { extra: &[t], ..TapeArguments::default() });
        let [position, rate, acceleration, jerk] =
            [0, 1, 2, 3].map(|order| values.get(order).copied().unwrap_or(f64::NAN));
        let motion = Motion { position, rate, acceleration, jerk };
        self.last.set((t, motion));
        motion
    }

    /// Returns the largest magnitudes of s and its rates from `from` to `to` (s); `None` if one of
    /// them jumps, is undefined or is not finite there.
    pub(super) fn bound(&self, from: f64, to: f64) -> Option<Motion> {
        let ranges = enclose(&self.tape, Interval::new(from, to));
        let most = |order: usize| {
            let range = ranges.get(order)?;
            Some(range.magnitude()).filter(|most| most.is_finite())
        };
        Some(Motion { position: most(0)?, rate: most(1)?, acceleration: most(2)?, jerk: most(3)? })
    }
}

/// Compiles `formula` and its first three derivatives; `None` if that is too much work.
fn derived(formula: &str) -> Result<Option<Tape>, Vec<TextError>> {
    let parsed = mechanism::formulas::parse(formula, Form::Value).map_err(|error| vec![error])?;
    let mut graph = Graph::new();
    graph.limit_work();
    let value = mechanism::formulas::build(&parsed, &mut graph, &mut InputNames)?;
    if !value.dimension.is_none() {
        let message = format!("the input is in {}", value.dimension);
        let help = "write numbers without units, in SI";
        return Err(vec![TextError::new(0..formula.len(), message, help)]);
    }
    let mut outputs = vec![value.node];
    for order in 0..3 {
        if graph.work() > MAX_WORK {
            return Ok(None);
        }
        outputs.push(graph.partial(outputs[order], TIME.0));
    }
    let mut layout = ArgumentLayout::default();
    layout.place(TIME.0, TIME.1);
    let tape = Tape::lower(&graph, &layout, &outputs).ok();
    Ok(tape.filter(|_tape| graph.given_up().is_none()))
}

/// Names in a formula: t and some constants.
struct InputNames;

impl NameScope for InputNames {
    fn value(
        &mut self,
        graph: &mut Graph,
        name: &str,
        primes: u8,
    ) -> Result<Measured, Option<NameError>> {
        let node = match (name, primes) {
            ("t", 0) => graph.symbol(TIME.0),
            ("pi" | "PI" | "π", 0) => graph.constant(PI),
            ("tau" | "TAU" | "τ", 0) => graph.constant(TAU),
            ("e" | "E", 0) => graph.constant(E),
            _ => {
                let message = format!("there is no {}", quoted(name));
                let help = "the variable is t, and there are pi, e, tau and functions as sin(t)";
                return Err(Some(NameError { message, help: help.to_owned() }));
            }
        };
        Ok(Measured { node, dimension: Dimension::NONE, reach: Dependence::NOTHING })
    }

    fn named(
        &mut self,
        _graph: &mut Graph,
        _function: &str,
        _names: &[&str],
    ) -> Result<Measured, (usize, Option<NameError>)> {
        let message = "an input has no points and no forces".to_owned();
        Err((0, Some(NameError { message, help: "write a function of t".to_owned() })))
    }

    fn rate(&mut self, graph: &mut Graph, value: Measured) -> Result<Measured, NameError> {
        Ok(Measured { node: graph.partial(value.node, TIME.0), ..value })
    }

    fn allowed(&self) -> Dependence {
        Dependence::NOTHING
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks s, s', s'', s''' of `text` at `t` against closed forms; allows a few roundings per
    /// operation, at the size of the largest term.
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
        check("s=2^3^2*t+1/2*3*-t", 2.0, [1021.0, 510.5, 0.0, 0.0]);
        check("s=2^-t^2", 0.0, [1.0, 0.0, -2.0 * std::f64::consts::LN_2, 0.0]);
        check("s=+.5 + 1.5E+2 - ( t )", 0.25, [150.25, -1.0, 0.0, 0.0]);
    }

    #[test]
    fn waves() {
        let w = TAU;
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

    /// Expressions with their starts (s).
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

    /// Checks the bound of `expression` over 3 ms from `from` (s) at 41 points.
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
            // It has to be finite at its start; these are, with t² for the shifted t.
            let text = format!("s={}", text.replace("(t-0.5)", "(0.25-t^2)"));
            let expression = Expression::read(&text, "s").expect("an expression");
            assert!(expression.bound(0.49, 0.51).is_none(), "{text}");
            assert!(expression.bound(0.1, 0.101).is_some(), "{text}");
        }
    }

    #[test]
    fn corners_are_derived_on_both_sides_and_have_no_bound() {
        check("s=abs(t-0.5)", 0.2, [0.3, -1.0, 0.0, 0.0]);
        check("s=if(t > 0.5, t^2, 3*t)", 0.6, [0.36, 1.2, 2.0, 0.0]);
        for text in ["s=abs(t-0.5)", "s=max(t, 1-t)", "s=if(t > 0.5, 1, 2)", "s=sign(t-0.5)"] {
            let expression = Expression::read(text, "s").expect("an expression");
            assert!(expression.bound(0.49, 0.51).is_none(), "{text}");
            assert!(expression.bound(0.1, 0.11).is_some(), "{text}");
            assert!(expression.bound(0.6, 0.61).is_some(), "{text}");
        }
    }

    #[test]
    fn functions_are_those_of_their_names_far_away_too() {
        type Named = (&'static str, fn(f64) -> f64);
        const NAMED: [Named; 15] = [
            ("exp", f64::exp),
            ("ln", f64::ln),
            ("log", f64::ln),
            ("log2", f64::log2),
            ("log10", f64::log10),
            ("sqrt", f64::sqrt),
            ("tan", f64::tan),
            ("asin", f64::asin),
            ("acos", f64::acos),
            ("atan", f64::atan),
            ("sinh", f64::sinh),
            ("cosh", f64::cosh),
            ("asinh", f64::asinh),
            ("acosh", f64::acosh),
            ("atanh", f64::atanh),
        ];
        for x in [-1e3_f64, -20.0, -0.7, -1e-3, 1e-9, 0.3, 4.0, 500.0] {
            let values = NAMED.map(|(name, function)| (name, function(x)));
            for (name, expected) in values.into_iter().filter(|(_, value)| value.is_finite()) {
                let text = format!("s={name}({x})+0*t");
                let found = Expression::read(&text, "s").expect("an expression").at(0.0).position;
                let error = (found - expected).abs();
                assert!(error <= 1e-15 + 4e-15 * expected.abs(), "{name}({x}) is not {found}");
            }
        }
        check("s=e^t", 0.4, [0.4_f64.exp(); 4]);
        check("s=cbrt(0.027)*signum(-2)*t+floor(0.5)+fract(1.25)", 2.0, [-0.35, -0.3, 0.0, 0.0]);
    }

    #[test]
    fn what_is_too_long_is_refused() {
        let refused = |formula: &str| {
            let mistakes = Expression::read(&format!("s={formula}"), "s").expect_err("too long");
            mistakes.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
        };
        let sum = |n: usize| {
            let terms: Vec<_> = (0..n).map(|i| format!("0.5*tanh((t-0.{i})/0.015)")).collect();
            terms.join("+")
        };
        assert!(Expression::read(&format!("s={}", sum(100)), "s").is_ok());
        assert!(refused(&sum(300)).contains("the expression is too long"));
        let deep = format!("{}t{}", "(".repeat(300), ")".repeat(300));
        assert!(refused(&deep).contains("nests more than 200 deep"));
        let factors: Vec<_> = (1..300).map(|i| format!("sin({i}*t)")).collect();
        assert!(refused(&factors.join("*")).contains("too long; give a CSV file"));
        assert!(refused(&factors[..60].join("*")).contains("too long; give a CSV file"));
        assert!(Expression::read(&format!("s={}", factors[..20].join("*")), "s").is_ok());
    }
}
