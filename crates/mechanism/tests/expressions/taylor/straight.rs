use mechanism::expressions::tape::Tape;
use mechanism::expressions::taylor::{Recursion, SeriesCoefficients};

pub(crate) fn followed(tape: &Tape, (p, x): (f64, f64), order: usize) -> Vec<Vec<f64>> {
    let tapes = Recursion::new(tape, 1).tapes();
    let known = tape.outputs.len() + tapes.conditions;
    assert_eq!(tapes.start.outputs.len() - known, tapes.carried);
    let constants = [p];
    let mut series = SeriesCoefficients::new(&tapes, &constants, &[x]);
    let mut all: Vec<Vec<f64>> = series.values().iter().map(|value| vec![*value]).collect();
    assert_eq!(all.len(), known);
    for k in 1..=order {
        series.advance(&[if k == 1 { 1.0 } else { 0.0 }]);
        all.iter_mut().zip(series.values()).for_each(|(row, value)| row.push(*value));
    }
    all
}
