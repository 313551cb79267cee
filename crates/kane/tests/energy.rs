//! What the input supplies is stored or dissipated, and closed chains stay closed.

use crate::builder::MechanismBuilder;
use crate::evaluation::{Derived, Numbers, close, imbalance};

/// Crank of 0.1 m, coupler of 0.3 m, rocker of 0.25 m between pivots 0.3 m apart; the crank is
/// driven by a spring.
pub(crate) fn four_bar() -> MechanismBuilder {
    let parameters = [("l1", 0.1), ("l2", 0.3), ("l3", 0.25), ("d", 0.3), ("g", 9.81), ("k", 20.0)];
    let mut m = MechanismBuilder::new(&parameters, &["a", "b", "c"]);
    m.gravity(&["0", "-g"]);
    let crank = m.frame(0, &["0", "0"], "a");
    m.body(crank, "0.3", &["l1/2"], "0.001");
    let coupler = m.frame(crank, &["l1", "0"], "b - a");
    m.body(coupler, "0.5", &["l2/2", "0.02"], "0.004");
    let rocker = m.frame(0, &["d", "0"], "c");
    m.body(rocker, "0.4", &["l3/2"], "0.003");
    m.force("drive", "s - a", "k*stretch + 0.3*rate", "k*stretch^2/2");
    let x = m.constraint("loop_x", "l1*cos(a) + l2*cos(b) - d - l3*cos(c)");
    let y = m.constraint("loop_y", "l1*sin(a) + l2*sin(b) - l3*sin(c)");
    m.mode("closed", &[x, y]);
    m.output("pull", "reaction_loop_x");
    m.rest(0, "0.5");
    m.rest(1, "0.6");
    m.rest(2, "1.5");
    m
}

/// A chain of one degree of freedom moves as its energy says.
#[test]
fn a_four_bar_linkage_stays_closed() {
    let mut d = Derived::from(four_bar());
    assert_eq!(d.system.modes[0].is_free, [true, true, true, true, false, false]);
    let mut numbers = Numbers::new(10);
    for _ in 0..20 {
        let [a, b, c, u] = numbers.list::<4>();
        let state = [0.5 + 0.3 * a, 0.6 + 0.1 * b, 1.5 + 0.1 * c, 3.0 * u, 0.0, 0.0];
        let input = numbers.list::<4>();
        let x = d.consistent(0, &state, input);
        close(imbalance(&mut d, 0, &x, input), 0.0, 1e-11, "energy");
        let f = d.derivative(0, &x, input);
        let [l1, l2, l3, ..] = d.values[..] else { unreachable!() };
        let arms = [l1, l2, -l3];
        let rate =
            |by: fn(f64) -> f64| -> f64 { (0..3).map(|i| arms[i] * by(x[i]) * x[3 + i]).sum() };
        close(rate(f64::sin), 0.0, 1e-12, "speed along x");
        close(rate(f64::cos), 0.0, 1e-12, "speed along y");
        let bend = |first: fn(f64) -> f64, second: fn(f64) -> f64| -> f64 {
            (0..3)
                .map(|i| arms[i] * (first(x[i]) * f[3 + i] + second(x[i]) * x[3 + i].powi(2)))
                .sum()
        };
        close(bend(f64::sin, f64::cos), 0.0, 1e-10, "acceleration along x");
        close(bend(f64::cos, |angle| -angle.sin()), 0.0, 1e-10, "acceleration along y");
    }
}

/// A crank and a slider, with the rod's angle as it is asked for.
fn slider_crank(solve: impl FnOnce(&mut MechanismBuilder)) -> Derived {
    let mut m = MechanismBuilder::new(&[("r", 0.1), ("l", 0.3), ("k", 50.0)], &["a", "b", "x"]);
    m.gravity(&["0", "-9.81"]);
    let crank = m.frame(0, &["0", "0"], "a");
    m.body(crank, "0.4", &["0.03"], "0.002");
    let rod = m.frame(crank, &["r", "0"], "b - a");
    m.body(rod, "0.2", &["l/2"], "0.0015");
    let slider = m.frame(0, &["x", "0"], "0");
    m.body(slider, "0.6", &["0", "0"], "0");
    m.force("spring", "x - s", "k*stretch", "k*stretch^2/2");
    let along = m.constraint("along", "r*cos(a) + l*cos(b) - x");
    let across = m.constraint("across", "r*sin(a) + l*sin(b)");
    m.mode("turns", &[along, across]);
    m.rest(0, "0.4");
    m.rest(1, "0 - 0.1");
    m.rest(2, "0.38");
    m.output("side", "reaction_across");
    m.output("push", "reaction_along");
    solve(&mut m);
    Derived::from(m)
}

#[test]
fn a_stated_solution_and_a_projected_one_agree() {
    let projected = slider_crank(|_| ());
    let stated = slider_crank(|m| m.solved(0, 1, "atan2(0 - r*sin(a), sqrt(l^2 - (r*sin(a))^2))"));
    assert_eq!(projected.system.state.len(), 4, "x is solved from the loop");
    assert_eq!(stated.system.state.len(), 2);
    let mut numbers = Numbers::new(11);
    for _ in 0..20 {
        let [a, u] = numbers.list::<2>().map(|it| 3.0 * it);
        let input = numbers.list::<4>();
        let x = projected.consistent(0, &[a, 0.0, u, 0.0], input);
        let [one, other] = [(&projected, &x[..]), (&stated, &[a, u][..])].map(|(d, x)| {
            let mode = &d.system.modes[0];
            let speed = *mode.derivative.get(d.system.coordinates).expect("a''");
            let mut nodes =
                vec![speed, mode.energy.expect("energy"), mode.readout.expect("readout")];
            nodes.extend(&mode.outputs);
            d.all(&nodes, x, input)
        });
        for (one, other) in one.iter().zip(other) {
            close(*one, other, 1e-10, "projected and stated");
        }
    }
}
