//! The last stage of Dop853 is evaluated at the step's start.

use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, Vector1};

use super::Probe;

struct Cubic;

impl ode_solvers::System<f64, Vector1<f64>> for Cubic {
    fn system(&self, t: f64, _: &Vector1<f64>, dx: &mut Vector1<f64>) {
        dx[0] = 3.0 * t * t;
    }
}

/// Integrates x' = 3 t² in one step from 0 to 1, exact for any method of order 3.
fn one_step() -> f64 {
    let loose = 1e9;
    let mut stepper = Dop853::from_param(
        Cubic,
        0.0,
        1.0,
        0.0,
        Vector1::new(0.0),
        loose,
        loose,
        0.9,
        0.0,
        0.333,
        6.0,
        1.0,
        1.0,
        10,
        1000,
        OutputType::Sparse,
    );
    let _ = stepper.integrate();
    stepper.y_out().last().map_or(f64::NAN, |x| x[0])
}

pub(super) fn probes() -> Vec<Probe> {
    let end = one_step();
    let seen = format!(
        "Dop853 on x' = 3t², one step from 0 to 1: 1 is right, {end:.4} is what it says \
         (`butcher_tableau.rs` has 0 for the node c12, which is 1): systems that depend on time \
         come out wrong, and at small tolerances it reports stiffness. Here a second sweep \
         carries the time as a state; Dopri5 is not concerned."
    );
    vec![Probe::new("ode_solvers", seen)]
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_node_is_wrong() {
        let missing = 3.0 * 0.044_710_615_727_772_59;
        assert!((super::one_step() - (1.0 - missing)).abs() < 1e-6, "{}", super::one_step());
    }
}
