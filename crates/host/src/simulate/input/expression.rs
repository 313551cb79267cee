//! An input given as a formula of t, exact with its first three derivatives.

use std::cell::Cell;
use std::fmt;

use exmex::prelude::*;
use pode::Motion;

use super::spelling::spelt_out;
use super::{InputMistake, NAME, is_finite};

/// s(t), s'(t), s''(t), s'''(t).
pub(in super::super) struct Expression {
    /// s and its derivatives, each of t alone.
    derivatives: [FlatEx<f64>; 4],
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
            with_derivatives(&formula).map_err(|cause| InputMistake::NotDerivable { cause })?;
        let expression = Self { derivatives, last: Cell::new((f64::NAN, Motion::default())) };
        if is_finite(&expression.at(0.0)) { Ok(expression) } else { Err(InputMistake::NotFinite) }
    }

    /// s and its rates at `t` [s].
    pub(super) fn at(&self, t: f64) -> Motion {
        let (last, motion) = self.last.get();
        if last.to_bits() == t.to_bits() {
            return motion;
        }
        // One variable is always the right number of them: `read` saw to it.
        let [position, rate, acceleration, jerk] =
            self.derivatives.each_ref().map(|each| each.eval(&[t]).unwrap_or(f64::NAN));
        let motion = Motion { position, rate, acceleration, jerk };
        self.last.set((t, motion));
        motion
    }
}

/// `formula` and its first three derivatives with respect to t.
fn with_derivatives(formula: &str) -> exmex::ExResult<[FlatEx<f64>; 4]> {
    // The added term makes each of them a function of t, also where t has dropped out.
    let s = FlatEx::<f64>::parse(&format!("({formula})+0*t"))?;
    let rate = s.clone().partial(0)?;
    let acceleration = rate.clone().partial(0)?;
    let jerk = acceleration.clone().partial(0)?;
    Ok([s, rate, acceleration, jerk])
}

impl fmt::Debug for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Expression").field(&self.derivatives[0].unparse()).finish()
    }
}
