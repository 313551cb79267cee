//! Faults of peers, measured again in each run: an exact question with a known answer, and the
//! code's answer.

mod differential_equations;
mod diffsol;
mod ode_solvers;

use serde::Serialize;

#[derive(Clone, PartialEq, Debug, Serialize)]
pub(crate) struct Probe {
    pub(crate) code: String,
    pub(crate) seen: String,
}

impl Probe {
    fn new(code: &str, seen: String) -> Self {
        Self { code: format!("{code} {}", crate::versions::version(code)), seen }
    }
}

pub(crate) fn all() -> Vec<Probe> {
    let mut all = ode_solvers::probes();
    all.extend(differential_equations::probes());
    all.extend(diffsol::probes());
    all
}
