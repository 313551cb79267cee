//! Ball and cart, derived from their bodies, beside those written by hand.

use hand_written::{BouncingBall, CartPendulum};
use kane::mechanism::Impact;
use models::Described;

use crate::builder::MechanismBuilder;
use crate::evaluation::{Derived, Numbers};
use crate::hand_written::Pair;

fn parameters<M: Described + Default>(values: &[f64]) -> Vec<(&'static str, f64)> {
    M::default().entry().parameters.iter().map(|it| it.name).zip(values.iter().copied()).collect()
}

pub(crate) fn cart() -> MechanismBuilder {
    let values = [1.1, 0.3, 0.25, 0.004, 9.81, 200.0, 1.7, -0.05, 0.06, 0.7, 1.0];
    let mut m = MechanismBuilder::new(&parameters::<CartPendulum>(&values), &["x", "theta"]);
    m.gravity(&["0", "-g"]);
    let cart = m.frame(0, &["x", "0"], "0");
    m.body(cart, "cart_mass", &["0", "0"], "0");
    let bob = m.frame(cart, &["0", "0"], "theta");
    m.body(bob, "bob_mass", &["0", "-length"], "inertia");
    m.force("spring", "s - x", "k*stretch + b*rate", "k*stretch^2/2");
    let left = m.constraint("left", "x - left");
    let right = m.constraint("right", "right - x");
    let modes = [m.mode("free", &[]), m.mode("left", &[left]), m.mode("right", &[right])];
    let restitution = m.e("restitution");
    for (name, value, rate) in [("left", "x - left", "x'"), ("right", "right - x", "-x'")] {
        let separation = m.e(rate);
        let guard = m.guard(modes[0], name, value, modes[0]);
        guard.branches[0].impact =
            Some(Impact { separation, restitution, within: None, settles: None });
    }
    m.guard(modes[1], "off", "reaction_left", modes[0]);
    m.guard(modes[2], "off", "reaction_right", modes[0]);
    m
}

#[test]
fn a_cart_with_a_pendulum_is_the_one_by_hand() {
    let derived = Derived::from(cart());
    let hand = CartPendulum::default().with_values(&derived.values);
    let pair = Pair { hand, derived, more_energy: 0.0 };
    let mut numbers = Numbers::new(7);
    for _ in 0..50 {
        let [_, angle, _, spin] = numbers.list::<4>().map(|it| 3.0 * it);
        let [x, u, ..] = numbers.list::<4>();
        let input = numbers.list::<4>();
        pair.compare(0, &[x, angle, u, spin], input);
        pair.compare_reset(0, 0, &[-0.05, angle, -1.0 - u.abs(), spin], input);
        pair.compare_reset(0, 1, &[0.06, angle, 1.0 + u.abs(), spin], input);
        pair.compare(1, &[-0.05, angle, 0.0, spin], input);
        pair.compare(2, &[0.06, angle, 0.0, spin], input);
        pair.compare_reset(2, 0, &[0.06, angle, 0.0, spin], input);
    }
}

pub(crate) fn ball() -> MechanismBuilder {
    let values = [9.81, 0.8, 0.7, 1.0, 1.0];
    let mut m = MechanismBuilder::new(&parameters::<BouncingBall>(&values), &["y"]);
    m.gravity(&["0", "-g"]);
    let frame = m.frame(0, &["0", "y"], "0");
    m.body(frame, "mass", &["0", "0"], "0");
    let floor = m.constraint("floor", "y - s");
    let modes = [m.mode("flight", &[]), m.mode("rest", &[floor])];
    let (separation, restitution) = (m.e("y' - s'"), m.e("restitution"));
    let guard = m.guard(modes[0], "floor", "y - s", modes[0]);
    guard.branches[0].impact =
        Some(Impact { separation, restitution, within: None, settles: None });
    m.guard(modes[1], "lift", "reaction_floor/mass", modes[0]);
    m
}

#[test]
fn a_bouncing_ball_is_the_one_by_hand() {
    let derived = Derived::from(ball());
    let hand = BouncingBall::default().with_values(&derived.values);
    let pair = Pair { hand, derived, more_energy: 0.0 };
    let mut numbers = Numbers::new(8);
    for _ in 0..50 {
        let [y, v] = numbers.list::<2>();
        let input = numbers.list::<4>();
        pair.compare(0, &[y, v], input);
        pair.compare_reset(0, 0, &[input[0], input[1] - 0.1 - v.abs()], input);
        pair.compare(1, &[input[0], input[1]], input);
    }
}
