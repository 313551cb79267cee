//! RK4 with fixed steps; at an event Newton shortens the step until it ends there, which keeps
//! the order without a dense output.

use super::root::falling;
use crate::log::Log;
use crate::problem::{Problem, armed};

pub(super) fn run<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: &P,
    t_end: f64,
    h: f64,
    log: &mut Log,
) -> Result<(), String> {
    let (mut mode, mut x) = problem.start();
    let (mut since, mut steps, mut evaluations) = (0.0, 0_u32, 0);
    let (mut guards, mut watched) = (problem.guards(mode, &x), armed(problem, mode, &x));
    loop {
        // A sum of steps would add its rounding to the error.
        let time = since + f64::from(steps) * h;
        let length = h.min(t_end - time);
        if length <= 1e-15 * t_end {
            log.count(evaluations);
            return Ok(());
        }
        let end = step(problem, mode, (time, length), &x);
        let next = problem.guards(mode, &end);
        evaluations += 4;
        if (0..G).any(|i| watched[i] && next[i] <= 0.0) {
            let (part, guard) =
                earliest(problem, mode, (time, length), &x, (&guards, &next), &watched);
            evaluations += 4 * u64::from(part.1);
            log.sample(time + part.0, |t| step(problem, mode, (time, t - time), &x));
            x = step(problem, mode, (time, part.0), &x);
            (since, steps) = (time + part.0, 0);
            log.event(since, P::names(mode)[guard])?;
            (mode, x) = problem.fire(mode, guard, &x);
            (guards, watched) = (problem.guards(mode, &x), armed(problem, mode, &x));
        } else {
            log.sample(time + length, |t| step(problem, mode, (time, t - time), &x));
            (x, guards) = (end, next);
            steps += 1;
            for (watched, guard) in watched.iter_mut().zip(guards) {
                *watched |= guard > 0.0;
            }
        }
    }
}

#[inline]
fn step<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: &P,
    mode: P::Mode,
    (time, h): (f64, f64),
    x: &[f64; N],
) -> [f64; N] {
    let f = |t: f64, x: [f64; N]| problem.derivative(mode, t, &x);
    let go = |h: f64, k: &[f64; N]| -> [f64; N] { std::array::from_fn(|i| x[i] + h * k[i]) };
    let k1 = f(time, *x);
    let k2 = f(time + 0.5 * h, go(0.5 * h, &k1));
    let k3 = f(time + 0.5 * h, go(0.5 * h, &k2));
    let k4 = f(time + h, go(h, &k3));
    std::array::from_fn(|i| x[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]))
}

/// Returns the length of the step up to the first event (s), the steps tried, and the guard.
fn earliest<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: &P,
    mode: P::Mode,
    (time, h): (f64, f64),
    x: &[f64; N],
    (start, end): (&[f64; G], &[f64; G]),
    watched: &[bool; G],
) -> ((f64, u32), usize) {
    let (mut first, mut tried) = ((h, 0), 1);
    for i in (0..G).filter(|i| watched[*i] && end[*i] <= 0.0) {
        let theta = falling((start[i], end[i]), |theta| {
            tried += 1;
            let x = step(problem, mode, (time, theta * h), x);
            (problem.guards(mode, &x)[i], h * problem.guard_rates(mode, &x)[i])
        });
        if theta * h <= first.0 {
            first = (theta * h, i);
        }
    }
    ((first.0, tried), first.1)
}
