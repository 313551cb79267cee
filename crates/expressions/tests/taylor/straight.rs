//! A recursion as two straight lines gives the coefficients of the recursion.

use expressions::tape::{Tape, TapeArguments};
use expressions::taylor::{Recursion, SeriesTapes};

/// Outputs and conditions of x' = 1 from `x` on, order by order, as anybody would follow the two
/// tapes.
pub(crate) fn followed(tape: &Tape, (p, x): (f64, f64), order: usize) -> Vec<Vec<f64>> {
    let SeriesTapes { start, step, carried, lanes, conditions } = Recursion::new(tape, 1).tapes();
    let constants = [p];
    let given = TapeArguments { constants: &constants, state: &[x], ..TapeArguments::default() };
    let mut values = start.evaluate(&given);
    let kept = values.split_off(tape.outputs.len() + conditions);
    assert_eq!(kept.len(), carried);
    let mut all: Vec<Vec<f64>> = values.into_iter().map(|it| vec![it]).collect();
    // Factors by lane and order; those of order 0 are in no sum.
    let mut factors = [vec![vec![0.0]; lanes], vec![vec![0.0]; lanes]];
    for k in 1..=order {
        let [first, second] = &factors;
        let sum = |lane: usize| (1..k).map(|j| first[lane][j] * second[lane][k - j]).sum::<f64>();
        let sums: Vec<f64> = (0..lanes).map(sum).collect();
        let extra = [&[k as f64, 1.0 / k as f64], kept.as_slice(), &sums].concat();
        let state = [if k == 1 { 1.0 } else { 0.0 }];
        let given = TapeArguments { state: &state, extra: &extra, ..given };
        let values = step.evaluate(&given);
        let (outputs, made) = values.split_at(all.len());
        all.iter_mut().zip(outputs).for_each(|(row, value)| row.push(*value));
        for (rows, made) in factors.iter_mut().zip(made.chunks(lanes.max(1))) {
            rows.iter_mut().zip(made).for_each(|(row, value)| row.push(*value));
        }
    }
    all
}
