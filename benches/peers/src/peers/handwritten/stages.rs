//! One step of the 8(5,3) pair: stages, error, and dense output of order 7.
#![expect(clippy::inline_always, reason = "the sums must be unrolled: measured")]

use super::tableau as t;

/// Derivatives within a step; 12 is at its end, 13 to 15 are for the dense output.
pub(super) type Stages<const N: usize> = [[f64; N]; 16];

/// Fills the stages 1 to 11 and returns the solution of order 8.
#[inline]
pub(super) fn step<const N: usize>(
    f: &impl Fn(f64, &[f64; N]) -> [f64; N],
    time: f64,
    x: &[f64; N],
    h: f64,
    k: &mut Stages<N>,
) -> [f64; N] {
    k[1] = f(time + t::NODES[1] * h, &combine(x, h, k, t::A1));
    k[2] = f(time + t::NODES[2] * h, &combine(x, h, k, t::A2));
    k[3] = f(time + t::NODES[3] * h, &combine(x, h, k, t::A3));
    k[4] = f(time + t::NODES[4] * h, &combine(x, h, k, t::A4));
    k[5] = f(time + t::NODES[5] * h, &combine(x, h, k, t::A5));
    k[6] = f(time + t::NODES[6] * h, &combine(x, h, k, t::A6));
    k[7] = f(time + t::NODES[7] * h, &combine(x, h, k, t::A7));
    k[8] = f(time + t::NODES[8] * h, &combine(x, h, k, t::A8));
    k[9] = f(time + t::NODES[9] * h, &combine(x, h, k, t::A9));
    k[10] = f(time + t::NODES[10] * h, &combine(x, h, k, t::A10));
    k[11] = f(time + t::NODES[11] * h, &combine(x, h, k, t::A11));
    combine(x, h, k, t::B)
}

/// Returns the error over the tolerance, relative and absolute; a step is accepted up to 1.
#[inline]
pub(super) fn error<const N: usize>(
    x: &[f64; N],
    end: &[f64; N],
    h: f64,
    k: &Stages<N>,
    tolerance: f64,
) -> f64 {
    let (fifth, third) = (sum(k, t::E5), sum(k, t::E3));
    let (mut five, mut three) = (0.0, 0.0);
    for i in 0..N {
        let scale = tolerance * (1.0 + x[i].abs().max(end[i].abs()));
        five += (fifth[i] / scale).powi(2);
        three += (third[i] / scale).powi(2);
    }
    let both = five + 0.01 * three;
    if both > 0.0 { h * five / (both * N as f64).sqrt() } else { 0.0 }
}

/// Returns x + h Σ a k.
#[inline(always)]
fn combine<const N: usize, const M: usize>(
    x: &[f64; N],
    h: f64,
    k: &Stages<N>,
    terms: [(usize, f64); M],
) -> [f64; N] {
    let sum = sum(k, terms);
    std::array::from_fn(|i| x[i] + h * sum[i])
}

#[inline(always)]
fn sum<const N: usize, const M: usize>(k: &Stages<N>, terms: [(usize, f64); M]) -> [f64; N] {
    let mut sum = [0.0; N];
    for (stage, a) in terms {
        for i in 0..N {
            sum[i] += a * k[stage][i];
        }
    }
    sum
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Dense<const N: usize> {
    start: [f64; N],
    terms: [[f64; N]; 7],
}

impl<const N: usize> Dense<N> {
    pub(super) fn new(
        f: &impl Fn(f64, &[f64; N]) -> [f64; N],
        time: f64,
        (x, end): (&[f64; N], &[f64; N]),
        h: f64,
        k: &mut Stages<N>,
    ) -> Self {
        k[13] = f(time + t::NODES[13] * h, &combine(x, h, k, t::A13));
        k[14] = f(time + t::NODES[14] * h, &combine(x, h, k, t::A14));
        k[15] = f(time + t::NODES[15] * h, &combine(x, h, k, t::A15));
        let zero = [0.0; N];
        let change: [f64; N] = std::array::from_fn(|i| end[i] - x[i]);
        let terms = [
            change,
            std::array::from_fn(|i| h * k[0][i] - change[i]),
            std::array::from_fn(|i| 2.0 * change[i] - h * (k[12][i] + k[0][i])),
            combine(&zero, h, k, t::D0),
            combine(&zero, h, k, t::D1),
            combine(&zero, h, k, t::D2),
            combine(&zero, h, k, t::D3),
        ];
        Self { start: *x, terms }
    }

    pub(super) fn at(&self, theta: f64) -> [f64; N] {
        let mut x = [0.0; N];
        for (index, term) in self.terms.iter().rev().enumerate() {
            let factor = if index % 2 == 0 { theta } else { 1.0 - theta };
            for i in 0..N {
                x[i] = (x[i] + term[i]) * factor;
            }
        }
        std::array::from_fn(|i| self.start[i] + x[i])
    }
}
