//! Dormand–Prince 8(5,3) with a root search on its dense output, restarted at each event.
//!
//! Pair, error estimate and step control are those of Hairer's DOP853 (`[HNW93]` II.5, II.6).
//! The three extra evaluations of the dense output are spent only if a guard changes its sign.

use super::root::falling;
use super::stages::{Dense, Stages, error, step};
use crate::log::Log;
use crate::problem::{Problem, armed};

/// First step (s): the motion starts from rest, and the step can grow sixfold at once.
const FIRST: f64 = 1e-3;

const MOST_STEPS: u32 = 1_000_000;

struct Integrator<'a, P: Problem<N, G>, const N: usize, const G: usize> {
    problem: &'a P,
    mode: P::Mode,
    time: f64,
    x: [f64; N],
    h: f64,
    /// `true` if the last attempt was rejected: the step must not grow at once.
    was_rejected: bool,
    k: Stages<N>,
    guards: [f64; G],
    watched: [bool; G],
    evaluations: u64,
}

pub(super) fn run<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: &P,
    t_end: f64,
    tolerance: f64,
    log: &mut Log,
) -> Result<(), String> {
    let longest = problem.longest_step().min(t_end);
    let mut integrator = Integrator::new(problem);
    for _ in 0..MOST_STEPS {
        integrator.h = integrator.h.min(longest).min(t_end - integrator.time);
        integrator.attempt(tolerance, log)?;
        if integrator.time >= t_end * (1.0 - 1e-15) {
            log.count(integrator.evaluations);
            return Ok(());
        }
    }
    Err("too many steps".to_owned())
}

impl<'a, P: Problem<N, G>, const N: usize, const G: usize> Integrator<'a, P, N, G> {
    fn new(problem: &'a P) -> Self {
        let (mode, x) = problem.start();
        let mut new = Self {
            problem,
            mode,
            time: 0.0,
            x,
            h: FIRST,
            was_rejected: false,
            k: [[0.0; N]; 16],
            guards: [0.0; G],
            watched: [false; G],
            evaluations: 0,
        };
        new.restart();
        new
    }

    fn restart(&mut self) {
        self.k[0] = self.problem.derivative(self.mode, self.time, &self.x);
        self.evaluations += 1;
        self.guards = self.problem.guards(self.mode, &self.x);
        self.watched = armed(self.problem, self.mode, &self.x);
    }

    #[inline]
    fn attempt(&mut self, tolerance: f64, log: &mut Log) -> Result<(), String> {
        let (problem, mode) = (self.problem, self.mode);
        let f = |t: f64, x: &[f64; N]| problem.derivative(mode, t, x);
        let end = step(&f, self.time, &self.x, self.h, &mut self.k);
        let error = error(&self.x, &end, self.h, &self.k, tolerance);
        self.evaluations += 11;
        let growth = if self.was_rejected { 1.0 } else { 6.0 };
        let factor = (0.9 * error.powf(-0.125)).clamp(0.333, growth);
        self.was_rejected = error > 1.0 || error.is_nan();
        if self.was_rejected {
            self.h *= factor.min(0.9);
            return Ok(());
        }
        self.k[12] = f(self.time + self.h, &end);
        self.evaluations += 1;
        let guards = problem.guards(mode, &end);
        if (0..G).any(|i| self.watched[i] && guards[i] <= 0.0) {
            return self.leave(&end, &guards, log);
        }
        self.sample(&end, log);
        self.accept(end, guards);
        self.h *= factor;
        Ok(())
    }

    #[inline]
    fn accept(&mut self, end: [f64; N], guards: [f64; G]) {
        self.time += self.h;
        (self.x, self.k[0], self.guards) = (end, self.k[12], guards);
        for (watched, guard) in self.watched.iter_mut().zip(guards) {
            *watched |= guard > 0.0;
        }
    }

    fn leave(&mut self, end: &[f64; N], guards: &[f64; G], log: &mut Log) -> Result<(), String> {
        let dense = self.dense(end);
        let (theta, guard) = self.earliest(&dense, guards);
        log.sample(self.time + theta * self.h, |t| dense.at((t - self.time) / self.h));
        self.time += theta * self.h;
        log.event(self.time, P::names(self.mode)[guard])?;
        (self.mode, self.x) = self.problem.fire(self.mode, guard, &dense.at(theta));
        self.restart();
        Ok(())
    }

    fn dense(&mut self, end: &[f64; N]) -> Dense<N> {
        let (problem, mode) = (self.problem, self.mode);
        let f = |t: f64, x: &[f64; N]| problem.derivative(mode, t, x);
        self.evaluations += 3;
        Dense::new(&f, self.time, (&self.x, end), self.h, &mut self.k)
    }

    fn earliest(&self, dense: &Dense<N>, end: &[f64; G]) -> (f64, usize) {
        let mut first = (1.0, 0);
        for i in (0..G).filter(|i| self.watched[*i] && end[*i] <= 0.0) {
            let theta = falling((self.guards[i], end[i]), |theta| {
                let x = dense.at(theta);
                let rate = self.problem.guard_rates(self.mode, &x)[i];
                (self.problem.guards(self.mode, &x)[i], self.h * rate)
            });
            if theta <= first.0 {
                first = (theta, i);
            }
        }
        first
    }

    fn sample(&mut self, end: &[f64; N], log: &mut Log) {
        let (time, h) = (self.time, self.h);
        let mut dense = None;
        log.sample(time + h, |t| dense.get_or_insert_with(|| self.dense(end)).at((t - time) / h));
    }
}
