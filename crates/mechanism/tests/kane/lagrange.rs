//! Equations of the cart and the ball against geometry and energy alone.
//!
//! Bodies are placed by vectors, energies computed from their positions, and Lagrange's equations
//! formed by finite differences; no formula of the models is used.
//! A five-point difference at 1e-3 of functions of scale 1 is off by 1e-13 (truncation h⁴/30) plus
//! 1e-13 (rounding ε/h), times at most the spread of the energies by mass matrices, 1e3 here.

use pode::{Energetic as _, Guarded as _, Model as _, Motion, Resets as _};

use crate::kane::evaluation::Numbers;
use crate::kane::runnable::{BALL, CART, Runnable, guard, mode, output, value};

const TOLERANCE: f64 = 1e-9;

type Vector = [f64; 2];

fn direction(angle: f64) -> Vector {
    [angle.cos(), angle.sin()]
}

fn normal(angle: f64) -> Vector {
    [-angle.sin(), angle.cos()]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn combined(a: Vector, scale: f64, b: Vector) -> Vector {
    [a[0] + scale * b[0], a[1] + scale * b[1]]
}

fn slope(f: impl Fn(f64) -> f64) -> f64 {
    const H: f64 = 1e-3;
    (8.0 * (f(H) - f(-H)) - (f(2.0 * H) - f(-2.0 * H))) / (12.0 * H)
}

/// Returns q'' of two coordinates with Lagrangian L(q, q') under the forces `applied`. L is
/// quadratic in q': its second differences over unit steps are exact.
fn lagrange(
    lagrangian: impl Fn(Vector, Vector) -> f64,
    q: Vector,
    v: Vector,
    applied: Vector,
) -> Vector {
    let unit = [[1.0, 0.0], [0.0, 1.0]];
    let momentum = |q: Vector, i: usize| {
        let l = |sign| lagrangian(q, combined(v, sign, unit[i]));
        0.5 * (l(1.0) - l(-1.0))
    };
    let mass = |i: usize, j: usize| {
        let l = |a, b| lagrangian(q, combined(combined([0.0; 2], a, unit[i]), b, unit[j]));
        l(1.0, 1.0) - l(1.0, 0.0) - l(0.0, 1.0) + l(0.0, 0.0)
    };
    let f = [0, 1].map(|i| {
        let force = slope(|d| lagrangian(combined(q, d, unit[i]), v));
        // d/dt ∂L/∂q'_i = Σ ∂²L/∂q'_i∂q_j q'_j + Σ M_ij q''_j.
        let carried = slope(|d| momentum(combined(q, d, v), i));
        force - carried + applied[i]
    });
    let share = mass(0, 1) / mass(0, 0);
    let second = (f[1] - share * f[0]) / (mass(1, 1) - share * mass(0, 1));
    [f[0] / mass(0, 0) - share * second, second]
}

#[track_caller]
fn agree(what: &str, got: f64, expected: f64, scale: f64) {
    let error = (got - expected).abs();
    assert!(error <= TOLERANCE * (scale + expected.abs()), "{what}: {got} is not {expected}");
}

fn cart_lagrangian(model: &Runnable<4>, s: f64, q: Vector, v: Vector) -> f64 {
    let [x, angle] = q;
    let [length, cart_mass, bob_mass] =
        ["length", "cart_mass", "bob_mass"].map(|name| value(model, name));
    let [inertia, g, k] = ["inertia", "g", "k"].map(|name| value(model, name));
    // The bob hangs by `length` from the cart: its velocity from the rod's direction.
    let bob = combined([x, 0.0], -length, normal(angle));
    let velocity = combined([v[0], 0.0], length * v[1], direction(angle));
    let kinetic = 0.5
        * (cart_mass * v[0] * v[0] + bob_mass * dot(velocity, velocity) + inertia * v[1] * v[1]);
    kinetic - bob_mass * g * bob[1] - 0.5 * k * (s - x).powi(2)
}

fn cart_cases(mut check: impl FnMut(&Runnable<4>, [f64; 4], Motion)) {
    let mut numbers = Numbers::new(11);
    for name in ["default", "key"] {
        for _ in 0..100 {
            let [inertia, b] = [1e-3, 2.0].map(|most| numbers.between(0.0, most));
            let model = CART.model::<4>(name, 0, &[("inertia", inertia), ("b", b)]);
            let x = [0.05, 3.0, 1.0, 5.0].map(|size| size * numbers.next());
            let [position, rate] = [0.05, 1.0].map(|size| size * numbers.next());
            check(&model, x, Motion { position, rate, ..Motion::default() });
        }
    }
}

#[test]
fn the_cart_is_lagranges_equations_of_its_energy() {
    cart_cases(|model, x, s| {
        let free = mode(model, "free");
        let l = |q, v| cart_lagrangian(model, s.position, q, v);
        let damper = value(model, "b") * (s.rate - x[2]);
        let expected = lagrange(l, [x[0], x[1]], [x[2], x[3]], [damper, 0.0]);
        let dx = model.derivative(free, &x, &s);
        assert_eq!([dx[0], dx[1]], [x[2], x[3]]);
        agree("x''", dx[2], expected[0], 1e3);
        agree("θ''", dx[3], expected[1], 1e4);
        let energy = l([x[0], x[1]], [x[2], x[3]]) - 2.0 * l([x[0], x[1]], [0.0; 2]);
        let got = model.energy(free, &x, &s);
        assert!((got - energy).abs() < 1e-13 * (1.0 + energy.abs()), "{got} is not {energy}");
    });
}

#[test]
fn a_wall_gives_what_holds_the_cart() {
    cart_cases(|model, x, s| {
        for (name, sign) in [("left", -1.0), ("right", 1.0)] {
            let mode = mode(model, name);
            let x = model.constrain(mode, &x, &s);
            assert_eq!([x[0], x[2]], [value(model, name), 0.0], "the cart is at the wall");
            let held = output(model, mode, (&x, &s), "N");
            // With the wall's force applied, the cart's own equations keep it still.
            let l = |q, v| cart_lagrangian(model, s.position, q, v);
            let applied = [value(model, "b") * s.rate - sign * held, 0.0];
            let [cart, bob] = lagrange(l, [x[0], x[1]], [0.0, x[3]], applied);
            agree("x''", cart, 0.0, 1e3);
            agree("θ''", model.derivative(mode, &x, &s)[3], bob, 1e4);
            let off = model.guard(mode, guard(model, mode, "off"), &x, &s);
            agree("off", off.value, held, 1.0);
        }
    });
}

#[test]
fn impacts_obey_their_law_and_momentum() {
    cart_cases(|model, x, s| {
        let free = mode(model, "free");
        for (name, sign) in [("left", -1.0), ("right", 1.0)] {
            let before = [value(model, name), x[1], sign * x[2].abs(), x[3]];
            let reset = model.reset(free, guard(model, free, name), &before, &s);
            let after = reset.state;
            assert_eq!(reset.impulse, 0.0, "the spring passes no impulse on");
            agree("x'⁺", after[2], -value(model, "restitution") * before[2], 1e-3);
            let l = |v| cart_lagrangian(model, s.position, [before[0], x[1]], v);
            let momentum = |x: &[f64; 4]| 0.5 * (l([x[2], x[3] + 1.0]) - l([x[2], x[3] - 1.0]));
            agree("∂L/∂θ'", momentum(&after), momentum(&before), 1e-3);
        }
    });
}

#[test]
fn the_ball_gives_the_floor_its_momentum() {
    let mut numbers = Numbers::new(12);
    for _ in 0..100 {
        let e = numbers.between(0.0, 1.0);
        let ball = BALL.model::<2>("default", 0, &[("restitution", e), ("mass", 0.3)]);
        let [position, rate, acceleration] = [1.0, 1.0, 20.0].map(|size| size * numbers.next());
        let s = Motion { position, rate, acceleration, jerk: 0.0 };
        let speed = numbers.between(0.01, 3.0);
        let flight = mode(&ball, "flight");
        let floor = guard(&ball, flight, "floor");
        let reset = ball.reset(flight, floor, &[s.position, s.rate - speed], &s);
        assert_eq!(reset.rests, Some((mode(&ball, "rest"), [s.position, s.rate])));
        agree("v⁺ − s'", reset.state[1] - s.rate, e * speed, 1e-3);
        agree("impulse", reset.impulse, 0.3 * (1.0 + e) * speed, 1e-3);
    }
}
