//! The power series of a formula of t.

use mechanism::expressions::tape::{Argument, Instruction, Tape, TapeSlot};
use mechanism::expressions::taylor::{Recursion, SeriesCoefficients, SeriesTapes};
use pode::Motion;

/// Outputs of the tapes before the conditions: the rate of t, and the formula.
const OUTPUTS: usize = 2;

#[derive(Debug)]
pub(super) struct FormulaSeries(SeriesTapes);

impl FormulaSeries {
    /// Returns the series of the first output of `tape`, a function of its only argument.
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

    /// Writes the formula at `t` + `span` τ as a power series in τ into `out`; returns `false` if a
    /// coefficient is not finite, or the formula may change its form before τ = 1, by a branch or
    /// as an unseen bell.
    pub(super) fn write(&self, t: f64, span: f64, out: &mut [Motion]) -> bool {
        let mut series = SeriesCoefficients::new(&self.0, &[], &[t]);
        // Value of each condition at the start, less its largest change.
        let conditions = series.values().iter().skip(OUTPUTS);
        let mut margins: Vec<f64> = conditions.map(|it| it.abs()).collect();
        let time = |k: usize| if k == 1 { span } else { 0.0 };
        for (k, place) in out.iter_mut().enumerate() {
            if k > 0 {
                series.advance(&[time(k)]);
                let conditions = series.values().iter().skip(OUTPUTS);
                margins.iter_mut().zip(conditions).for_each(|(margin, it)| *margin -= it.abs());
            }
            let position = series.values().get(1).copied().unwrap_or(f64::NAN);
            if !position.is_finite() {
                return false;
            }
            *place = Motion { position, ..Motion::default() };
        }
        margins.iter().all(|margin| *margin >= 0.0)
    }
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
