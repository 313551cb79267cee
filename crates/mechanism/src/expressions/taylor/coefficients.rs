use super::SeriesTapes;
use crate::expressions::tape::TapeArguments;

/// Coefficients of one order of a series without an input, and the state for the next order.
#[derive(Debug)]
pub struct SeriesCoefficients<'a> {
    tapes: &'a SeriesTapes,
    constants: &'a [f64],
    order: usize,
    /// Coefficients of the outputs, then of the conditions, then those kept as `factors`.
    values: Vec<f64>,
    carried: Vec<f64>,
    /// Factors of the sums by lane and order; those of order 0 are in no sum.
    factors: [Vec<Vec<f64>>; 2],
}

impl<'a> SeriesCoefficients<'a> {
    /// Returns the coefficients of order 0, of a series that starts at `state`.
    pub fn new(tapes: &'a SeriesTapes, constants: &'a [f64], state: &[f64]) -> Self {
        let given = TapeArguments { constants, state, ..TapeArguments::default() };
        let mut values = tapes.start.evaluate(&given);
        let carried = values.split_off(values.len() - tapes.carried);
        let lanes = vec![vec![0.0]; tapes.lanes];
        Self { tapes, constants, order: 0, values, carried, factors: [lanes.clone(), lanes] }
    }

    /// Returns the coefficients of the outputs, then of the conditions.
    pub fn values(&self) -> &[f64] {
        let factors = if self.order == 0 { 0 } else { 2 * self.tapes.lanes };
        &self.values[..self.values.len() - factors]
    }

    pub fn advance(&mut self, state: &[f64]) {
        self.order += 1;
        let k = self.order;
        let [first, second] = &self.factors;
        let product = |(a, b): (&Vec<f64>, &Vec<f64>)| (1..k).map(|j| a[j] * b[k - j]).sum::<f64>();
        let sums: Vec<f64> = first.iter().zip(second).map(product).collect();
        let extra = [&[k as f64, 1.0 / k as f64], self.carried.as_slice(), &sums].concat();
        let constants = self.constants;
        let given = TapeArguments { constants, state, extra: &extra, ..TapeArguments::default() };
        self.values = self.tapes.step.evaluate(&given);
        let made = &self.values[self.values.len() - 2 * self.tapes.lanes..];
        self.factors.iter_mut().flatten().zip(made).for_each(|(row, value)| row.push(*value));
    }
}
