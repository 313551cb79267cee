//! Equations of described models against geometry and energy alone.
//!
//! Bodies are placed by vectors, energies computed from their positions, and Lagrange's equations
//! formed by finite differences; no formula of the models is used.
//! A five-point difference at 1e-3 of functions of scale 1 is off by 1e-13 (truncation h⁴/30) plus
//! 1e-13 (rounding ε/h), times at most the spread of the energies by mass matrices, 1e3 here.

use pode::{Energetic as _, Guarded as _, Model as _, Motion, Resets as _};

use crate::kane::evaluation::Numbers;
use crate::kane::runnable::{BALL, CART, RIGID, Runnable, SPRINGS, guard, mode, output, value};
use crate::kane::stroke::still;

/// Relative error allowed for the differences.
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

/// Returns f'(0) by five points.
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

/// Parameters of models A and B that place bodies and springs.
struct Parameters {
    l1: f64,
    l2: f64,
    l3: f64,
    l4: f64,
    m1: f64,
    m2: f64,
    k1: f64,
    k2: f64,
    ck: f64,
    jk: f64,
    jh: f64,
    g: f64,
}

impl Parameters {
    fn of<const N: usize>(model: &Runnable<N>) -> Self {
        let of = |name| value(model, name);
        let [l1, l2, l3, l4] = ["L1", "L2", "L3", "L4"].map(of);
        let [m1, m2, k1, k2] = ["M1", "M2", "k1", "k2"].map(of);
        let [ck, jk, jh, g] = ["cK", "JK", "JH", "g"].map(of);
        Self { l1, l2, l3, l4, m1, m2, k1, k2, ck, jk, jh, g }
    }

    /// Returns the slider's nominal point on a key at the angle `key`, from the hammer's pivot.
    fn slider(&self, key: f64) -> Vector {
        combined(combined([0.0; 2], self.l1, direction(key)), -1.0, [self.l3, self.l4])
    }

    /// Returns the compression of k2: from the slider's nominal point on K, along K's normal, to H.
    fn compression(&self, hammer: f64, key: f64) -> f64 {
        dot(self.slider(key), normal(hammer)) / dot(normal(key), normal(hammer))
    }

    /// Returns L of model B with the hammer's mass anywhere on a body of inertia JH.
    fn springs_lagrangian(&self, mode: &str, s: f64, q: Vector, v: Vector) -> f64 {
        let [hammer, key] = q;
        let kinetic = 0.5 * (self.jh * v[0] * v[0] + self.jk * v[1] * v[1]);
        let centre_h = combined([self.l3, self.l4], self.l2, direction(hammer));
        let centre_k = combined([0.0; 2], self.ck, direction(key));
        let squeeze = if mode == "B1" { self.compression(hammer, key) } else { 0.0 };
        let springs = 0.5 * (self.k1 * (s - key).powi(2) + self.k2 * squeeze * squeeze);
        kinetic - springs - self.g * (self.m2 * centre_h[1] + self.m1 * centre_k[1])
    }
}

fn between(numbers: &mut Numbers, low: f64, high: f64) -> f64 {
    low + (high - low) * 0.5 * (1.0 + numbers.next())
}

/// Random configurations of model B: both presets of moderate size, springs, coordinates.
fn springs_cases(mut check: impl FnMut(&Runnable<4>, &Parameters, [f64; 4], Motion)) {
    let mut numbers = Numbers::new(7);
    for name in ["paper", "playable"] {
        for key in [0, 44, 87] {
            let model = SPRINGS.model::<4>(name, key, &[("c2", 0.2), ("b1", 0.3)]);
            for _ in 0..50 {
                let x = [0.4, 0.4, 5.0, 5.0].map(|size| size * numbers.next());
                let [position, rate] = [0.2, 1.0].map(|size| size * numbers.next());
                let s = Motion { position, rate, ..Motion::default() };
                check(&model, &Parameters::of(&model), x, s);
            }
        }
    }
}

#[test]
fn model_b_is_lagranges_equations_of_its_energy() {
    springs_cases(|model, p, x, s| {
        for name in ["B1", "B2"] {
            let mode = mode(model, name);
            let l = |q, v| p.springs_lagrangian(name, s.position, q, v);
            let (q, v) = ([x[0], x[1]], [x[2], x[3]]);
            let squeeze = |h: f64, k: f64| p.compression(q[0] + h, q[1] + k);
            let [per_hammer, per_key] = [slope(|d| squeeze(d, 0.0)), slope(|d| squeeze(0.0, d))];
            // The felt stiffens with its rate, and never pulls.
            let rate = per_hammer * v[0] + per_key * v[1];
            let lossy = (1.0 + value(model, "c2") * rate).max(0.0) - 1.0;
            let felt = if name == "B1" { p.k2 * squeeze(0.0, 0.0) * lossy } else { 0.0 };
            let damper = value(model, "b1") * (s.rate - v[1]);
            let applied = [-felt * per_hammer, damper - felt * per_key];
            let expected = lagrange(l, q, v, applied);
            let dx = model.derivative(mode, &x, &s);
            assert_eq!([dx[0], dx[1]], v);
            // Largest acceleration by the springs in a case.
            let scale = p.k1 / p.jk + p.k2 * (p.l1 * p.l1 / p.jk + 0.1 / p.jh);
            agree("θh''", dx[2], expected[0], scale);
            agree("θk''", dx[3], expected[1], scale);
            let energy = l(q, v) - 2.0 * l(q, [0.0; 2]);
            let got = model.energy(mode, &x, &s);
            assert!((got - energy).abs() < 1e-13 * (1.0 + energy.abs()), "{got} is not {energy}");
        }
    });
}

#[test]
fn the_slider_moves_as_the_identities_say() {
    springs_cases(|model, p, x, s| {
        let of = |name| output(model, mode(model, "B1"), (&x, &s), name);
        let [gap, q4, q3] = ["gap", "q4", "q3"].map(of);
        let delta = x[1] - x[0];
        agree("q4", q4, p.compression(x[0], x[1]), 1e-3);
        agree("gap", gap, -q4 * delta.cos(), 1e-3);
        let per_hammer = slope(|d| p.compression(x[0] + d, x[1]));
        let per_key = slope(|d| p.compression(x[0], x[1] + d));
        agree("∂q4/∂θh", -q3 / delta.cos(), per_hammer, 1.0);
        agree("∂q4/∂θk", p.l1 + q4 * delta.tan(), per_key, 1.0);
        // The slider is on H at q3: nominal point − q4 normal = P2 + q3 direction.
        let along = dot(combined(p.slider(x[1]), -q4, normal(x[1])), direction(x[0]));
        agree("q3", q3, along, 1.0);
    });
}

/// Checks the effect of the string on a hammer in `mode`.
#[track_caller]
fn check_string<const N: usize>(model: &Runnable<N>, name: &str, x: [f64; N], speed: usize) {
    let mode = mode(model, name);
    let id = guard(model, mode, "string");
    let reset = model.reset(mode, id, &x, &still(0.02));
    let mut after = x;
    after[0] = value(model, "string_angle");
    after[speed] = -0.6 * x[speed];
    assert_eq!((reset.mode, reset.state, reset.impulse), (mode, after, 0.0), "{name}");
    assert_eq!(model.sounding(id, &x), Some(value(model, "L2") * x[speed]), "{name}");
}

#[test]
fn the_string_throws_the_hammer_back_by_its_restitution() {
    let losses = [("restitution", 0.6)];
    check_string(&RIGID.model::<2>("paper", 44, &losses), "A2", [0.4, 3.0], 1);
    for name in ["B1", "B2"] {
        check_string(&SPRINGS.model::<4>("paper", 44, &losses), name, [0.4, 0.1, 3.0, 0.5], 2);
    }
}

fn moved(s: &Motion, t: f64) -> f64 {
    s.position + t * (s.rate + 0.5 * t * s.acceleration)
}

#[test]
fn model_a_is_virtual_work() {
    let mut numbers = Numbers::new(9);
    for name in ["paper", "playable"] {
        let model = RIGID.model::<2>(name, 44, &[]);
        let p = Parameters::of(&model);
        for _ in 0..200 {
            let s = Motion {
                position: between(&mut numbers, 0.0, 0.04),
                // The differences are over 1 ms, in which the hammer must not go far.
                rate: between(&mut numbers, 0.02, 0.2),
                acceleration: 2.0 * numbers.next(),
                jerk: 0.0,
            };
            let (on_key, x) = model.at_rest(&s);
            assert_eq!(on_key, mode(&model, "A1"));
            let x = model.constrain(on_key, &x, &s);
            // θh of a rigid contact: H points from P2 to the slider on K.
            let angle = |t: f64| {
                let [along, up] = p.slider(moved(&s, t));
                up.atan2(along)
            };
            let rate = |t: f64| slope(|d| angle(t + d));
            agree("θh", x[0], angle(0.0), 1.0);
            agree("θh'", x[1], rate(0.0), 1.0);
            // Power of T_KU = rate of all energy; of F_KH = rate of the hammer's.
            let hammer_energy =
                |t: f64| 0.5 * p.jh * rate(t).powi(2) + p.m2 * p.g * p.l2 * angle(t).sin();
            let key_energy = |t: f64| {
                let v = s.rate + t * s.acceleration;
                0.5 * p.jk * v * v + p.m1 * p.g * p.ck * moved(&s, t).sin()
            };
            let [contact, torque] =
                ["F_KH", "T_KU"].map(|name| output(&model, on_key, (&x, &s), name));
            let reach = dot(p.slider(s.position), direction(x[0]));
            // A difference of differences: its step costs three digits more.
            let check = |what, got: f64, expected: f64| {
                let error = (got - expected).abs();
                assert!(error < 1e-6 * (0.1 + expected.abs()), "{what}: {got} is not {expected}");
            };
            check("F_KH", contact * reach * x[1], slope(hammer_energy));
            check("T_KU", torque * s.rate, slope(|t| hammer_energy(t) + key_energy(t)));
        }
    }
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
            let [inertia, b] = [1e-3, 2.0].map(|most| between(&mut numbers, 0.0, most));
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
        let e = between(&mut numbers, 0.0, 1.0);
        let ball = BALL.model::<2>("default", 0, &[("restitution", e), ("mass", 0.3)]);
        let [position, rate, acceleration] = [1.0, 1.0, 20.0].map(|size| size * numbers.next());
        let s = Motion { position, rate, acceleration, jerk: 0.0 };
        let speed = between(&mut numbers, 0.01, 3.0);
        let flight = mode(&ball, "flight");
        let floor = guard(&ball, flight, "floor");
        let reset = ball.reset(flight, floor, &[s.position, s.rate - speed], &s);
        assert_eq!(reset.rests, Some((mode(&ball, "rest"), [s.position, s.rate])));
        agree("v⁺ − s'", reset.state[1] - s.rate, e * speed, 1e-3);
        agree("impulse", reset.impulse, 0.3 * (1.0 + e) * speed, 1e-3);
    }
}
