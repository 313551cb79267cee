//! The codes, one module each, with their `entries`.

mod differential_equations;
mod diffsol;
mod handwritten;
mod ode_solvers;
mod ours;

pub(crate) use diffsol::entries as diffsol;
pub(crate) use ours::{Ours, Written, entries as ours, shipped};

use crate::entry::Entry;
use crate::problem::Problem;

pub(crate) fn entries<const N: usize, const G: usize, const M: usize, P: Problem<N, G>>(
    problem: P,
    t_end: f64,
) -> Vec<Entry> {
    let mut all = Vec::new();
    all.extend(handwritten::entries(problem, t_end));
    all.extend(ode_solvers::entries::<N, G, M, P>(problem, t_end));
    all.extend(diffsol::entries(problem, t_end));
    all.extend(differential_equations::entries(problem, t_end));
    all
}
