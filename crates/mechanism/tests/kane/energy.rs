use crate::kane::builder::MechanismBuilder;
use crate::kane::evaluation::{Derived, Numbers, close};

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
                vec![speed, mode.balance.energy.expect("energy"), mode.readout.expect("readout")];
            nodes.extend(&mode.outputs);
            d.all(&nodes, x, input)
        });
        for (one, other) in one.iter().zip(other) {
            close(*one, other, 1e-10, "projected and stated");
        }
    }
}
