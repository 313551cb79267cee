//! The power series of a formula of t.

use expressions::tape::{Argument, Instruction, Tape, TapeArguments, TapeSlot};
use expressions::taylor::{Recursion, SeriesTapes};
use pode::Motion;

/// Outputs of the tapes before the conditions: the rate of t, and the formula.
const OUTPUTS: usize = 2;

/// A formula's recursion, as two tapes along t' = 1.
#[derive(Debug)]
pub(super) struct FormulaSeries(SeriesTapes);

impl FormulaSeries {
    /// Returns the series of the first output of `tape`, which is a function of its only argument.
    pub(super) fn new(tape: &Tape) -> Option<Self> {
        let along = |instruction: &Instruction| {
            let is_time = matches!(instruction, Instruction::Argument(_));
            if is_time { Instruction::Argument(Argument::State(0)) } else { *instruction }
        };
        let mut instructions: Vec<_> = tape.instructions.iter().map(along).collect();
        let one = TapeSlot(u32::try_from(instructions.len()).ok()?);
        instructions.push(Instruction::Number(1.0));
        let outputs = vec![one, *tape.outputs.first()?];
        Some(Self(Recursion::new(&Tape { instructions, outputs }, 1).tapes()))
    }

    /// Writes the formula at `t` + `span` τ as a power series in τ, as far as `out` goes; returns
    /// `false` if a coefficient is not finite, or the formula may change its form before τ = 1, by a
    /// branch or as a bell that was not seen from afar.
    pub(super) fn write(&self, t: f64, span: f64, out: &mut [Motion]) -> bool {
        let mut coefficients = Coefficients::start(&self.0, t);
        for (k, place) in out.iter_mut().enumerate() {
            if k > 0 {
                coefficients.advance(k, span);
            }
            let position = coefficients.formula();
            if !position.is_finite() {
                return false;
            }
            *place = Motion { position, ..Motion::default() };
        }
        coefficients.margins.iter().all(|margin| *margin >= 0.0)
    }
}

/// Coefficients of one order after another.
struct Coefficients<'tapes> {
    tapes: &'tapes SeriesTapes,
    /// What the tape of the latest order gave.
    values: Vec<f64>,
    /// What the first tape keeps for the others.
    kept: Vec<f64>,
    /// What each condition is at the start, less all that it may change.
    margins: Vec<f64>,
    /// Factors of the sums by lane and order; those of order 0 are in no sum.
    factors: [Vec<Vec<f64>>; 2],
}

impl<'tapes> Coefficients<'tapes> {
    fn start(tapes: &'tapes SeriesTapes, t: f64) -> Self {
        let given = TapeArguments { state: &[t], ..TapeArguments::default() };
        let mut values = tapes.start.evaluate(&given);
        let kept = values.split_off((OUTPUTS + tapes.conditions).min(values.len()));
        let margins = values.iter().skip(OUTPUTS).map(|it| it.abs()).collect();
        let lanes = vec![vec![0.0]; tapes.lanes];
        Self { tapes, values, kept, margins, factors: [lanes.clone(), lanes] }
    }

    /// Goes on to order `k` ≥ 1 of a step of `span` (s).
    fn advance(&mut self, k: usize, span: f64) {
        let [first, second] = &self.factors;
        let lanes = first.iter().zip(second);
        let sums: Vec<f64> = lanes.map(|(a, b)| convolution(a, b, k)).collect();
        let extra = [&[k as f64, 1.0 / k as f64], self.kept.as_slice(), &sums].concat();
        let state = [if k == 1 { span } else { 0.0 }];
        let given = TapeArguments { state: &state, extra: &extra, ..TapeArguments::default() };
        self.values = self.tapes.step.evaluate(&given);
        let conditions = self.values.iter().skip(OUTPUTS);
        self.margins.iter_mut().zip(conditions).for_each(|(margin, moved)| *margin -= moved.abs());
        let made = self.values.iter().skip(OUTPUTS + self.tapes.conditions);
        self.factors.iter_mut().flatten().zip(made).for_each(|(row, value)| row.push(*value));
    }

    fn formula(&self) -> f64 {
        self.values.get(1).copied().unwrap_or(f64::NAN)
    }
}

/// The inner terms of the product's coefficient of order `k`.
fn convolution(first: &[f64], second: &[f64], k: usize) -> f64 {
    (1..k).map(|j| first[j] * second[k - j]).sum()
}

#[cfg(test)]
mod tests {
    use super::super::expression::Expression;
    use super::*;

    #[test]
    fn a_series_is_the_formula_in_its_neighbourhood() {
        for text in ["0.3", "0.1*sin(7*t)", "exp(-((t-0.4)/0.2)^2)", "tanh(t/0.3)*t^2", "sqrt(1+t)"]
        {
            let formula = Expression::read(&format!("s={text}"), "s").expect("a formula");
            let mut terms = [Motion::default(); 24];
            assert!(formula.series(0.3, 0.05, &mut terms), "{text}");
            for tau in [-1.0, 0.3, 1.0] {
                let sum = terms.iter().rev().fold(0.0, |sum, term| term.position + tau * sum);
                let value = formula.at(0.3 + 0.05 * tau).position;
                assert!((sum - value).abs() < 1e-14, "{text} at {tau}: {sum} is not {value}");
            }
        }
        let corner = Expression::read("s=abs(t-0.5)", "s").expect("a formula");
        assert!(corner.series(0.3, 0.05, &mut [Motion::default(); 4]), "0.2 s before it");
        assert!(!corner.series(0.3, 0.25, &mut [Motion::default(); 4]), "in it");
        let bell = Expression::read("s=exp(-((t-1)/0.05)^2)", "s").expect("a formula");
        assert!(!bell.series(0.0, 1.0, &mut [Motion::default(); 24]), "it is not seen from afar");
    }
}
