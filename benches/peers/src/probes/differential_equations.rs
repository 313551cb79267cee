//! Its root finder loses the bracket; a crossing at a step's end is missed; the dense output of
//! DOP853 is of low order.

use differential_equations::ode::OrdinaryNumericalMethod;
use differential_equations::prelude::{
    CrossingDirection, Event, EventConfig, ExplicitRungeKutta, IVP, Interpolation, ODE,
};

use super::Probe;

const CODE: &str = "differential-equations";

/// x' = 1: x is the time.
struct Clock;

impl ODE<f64, f64> for Clock {
    fn diff(&self, _t: f64, _x: &f64, dx: &mut f64) {
        *dx = 1.0;
    }
}

struct Sixth;

impl ODE<f64, f64> for Sixth {
    fn diff(&self, t: f64, _x: &f64, dx: &mut f64) {
        *dx = 6.0 * t.powi(5);
    }
}

/// A guard of the time, with the direction of its crossing.
struct Guard(fn(f64) -> f64, CrossingDirection);

impl Event<f64, f64> for Guard {
    fn config(&self) -> EventConfig {
        EventConfig::new(self.1, Some(1))
    }

    fn event(&self, t: f64, _x: &f64) -> f64 {
        (self.0)(t)
    }
}

/// Returns the time of the reported event, with steps of `h` from 0 to 1.
fn event(guard: &Guard, h: f64) -> Option<f64> {
    let method = ExplicitRungeKutta::rk4(h);
    let solution = IVP::ode(&Clock, 0.0, 1.0, 0.0).method(method).event(guard).solve().ok()?;
    let is_event = matches!(solution.status, differential_equations::status::Status::Interrupted);
    solution.t.last().copied().filter(|_| is_event)
}

/// Integrates x' = 6 t⁵ in one step from 0 to 1; returns the dense output at 1/4, where x is 4⁻⁶.
fn quarter() -> f64 {
    let mut method = ExplicitRungeKutta::dop853().rtol(1e9).atol(1e9).h0(1.0);
    if method.init(&Sixth, 0.0, 1.0, &0.0).is_err() || method.step(&Sixth).is_err() {
        return f64::NAN;
    }
    method.interpolate(0.25).unwrap_or(f64::NAN)
}

fn cubic() -> Guard {
    Guard(|t| t * t * t - 0.2, CrossingDirection::Both)
}

fn half() -> Guard {
    Guard(|t| 0.5 - t, CrossingDirection::Negative)
}

pub(super) fn probes() -> Vec<Probe> {
    let said = |t: Option<f64>| t.map_or_else(|| "none".to_owned(), |t| format!("{t:.4}"));
    let lost = said(event(&cubic(), 1.0));
    let exact = said(event(&half(), 0.25));
    let quarter = quarter();
    vec![
        Probe::new(
            CODE,
            format!(
                "event g(t) = t³ − 0.2 in one step from 0 to 1: 0.5848 is right, {lost} is reported \
             (its Brent–Dekker loses the bracket)."
            ),
        ),
        Probe::new(
            CODE,
            format!(
                "falling event g(t) = 0.5 − t with steps of 0.25, so that a step ends on the zero: \
             0.5000 is right, {exact} is reported."
            ),
        ),
        Probe::new(
            CODE,
            format!(
                "dense output of DOP853 on x' = 6t⁵, one step from 0 to 1, at 1/4: {:.6} is right, \
             {quarter:.6} is what it says (θ and 1 − θ change places in the terms of high order): \
             with a root search of our own its event times are a thousand times worse than those \
             of the same method elsewhere.",
                0.25_f64.powi(6)
            ),
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn its_faults_are_still_there() {
        let root = event(&cubic(), 1.0).unwrap_or(f64::NAN);
        assert!((root - 0.2_f64.cbrt()).abs() > 0.1, "the root is found: {root}");
        assert_eq!(event(&half(), 0.25), None, "the exact zero is found");
        let right = 0.25_f64.powi(6);
        assert!((quarter() - right).abs() > 1e-4, "the dense output is right: {}", quarter());
    }
}
