//! The equations against what follows from geometry and energy alone.
//!
//! Bodies are placed by vectors, energies taken from where they are, and Lagrange's
//! equations formed by finite differences; no formula of the models is used.
//! A five-point difference at 1e-3 of functions of scale 1 is off by 1e-13 (truncation
//! h⁴/30) plus 1e-13 (rounding ε/h); mass matrices multiply that by at most the spread
//! of the energies, 1e3 here.

#![expect(clippy::float_cmp, reason = "what is copied or declared zero is so to the bit")]

use hand_written::bouncing_ball::Mode as Ball;
use hand_written::cart_pendulum::Mode as Cart;
use hand_written::key_hammer::KeyHammerValues;
use hand_written::key_hammer_rigid::Mode as Rigid;
use hand_written::key_hammer_springs::Mode as Springs;
use hand_written::{BouncingBall, CartPendulum, KeyHammerRigid, KeyHammerSprings};
use models::Described as _;
use pode::{Energetic as _, GuardId, Guarded as _, Model as _, Motion, Resets as _};

use crate::random::Random;
use crate::stroke::{preset, still};

/// Relative error that the differences are allowed.
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

/// f'(0) by five points.
fn slope(f: impl Fn(f64) -> f64) -> f64 {
    const H: f64 = 1e-3;
    (8.0 * (f(H) - f(-H)) - (f(2.0 * H) - f(-2.0 * H))) / (12.0 * H)
}

/// q'' of a system of two coordinates with Lagrangian L(q, q') under the forces `applied`.
///
/// L is quadratic in q': its second differences over unit steps are exact.
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
    // Eliminate the first coordinate.
    let share = mass(0, 1) / mass(0, 0);
    let second = (f[1] - share * f[0]) / (mass(1, 1) - share * mass(0, 1));
    [f[0] / mass(0, 0) - share * second, second]
}

#[track_caller]
fn agree(what: &str, got: f64, expected: f64, scale: f64) {
    let error = (got - expected).abs();
    assert!(error <= TOLERANCE * (scale + expected.abs()), "{what}: {got} is not {expected}");
}

/// Compression of k2: from the slider's nominal point on K, along K's normal, to H.
fn compression(p: &KeyHammerValues, hammer: f64, key: f64) -> f64 {
    let from_hammer_pivot = combined(combined([0.0; 2], p.l1, direction(key)), -1.0, [p.l3, p.l4]);
    dot(from_hammer_pivot, normal(hammer)) / dot(normal(key), normal(hammer))
}

/// L of model B with the hammer's mass anywhere on a body of inertia JH.
fn springs_lagrangian(p: &KeyHammerValues, mode: Springs, s: f64, q: Vector, v: Vector) -> f64 {
    let [hammer, key] = q;
    let kinetic = 0.5 * (p.jh * v[0] * v[0] + p.jk * v[1] * v[1]);
    let centre_h = combined([p.l3, p.l4], p.l2, direction(hammer));
    let centre_k = combined([0.0; 2], p.ck, direction(key));
    let squeeze = match mode {
        Springs::B1 => compression(p, hammer, key),
        Springs::B2 => 0.0,
    };
    let springs = 0.5 * (p.k1 * (s - key).powi(2) + p.k2 * squeeze * squeeze);
    kinetic - springs - p.g * (p.m2 * centre_h[1] + p.m1 * centre_k[1])
}

/// Random configurations of model B: both presets of moderate size, springs, coordinates.
fn springs_cases(mut check: impl FnMut(&KeyHammerSprings, [f64; 4], Motion)) {
    let mut random = Random::new(7);
    for name in ["paper", "playable"] {
        for key in [0, 44, 87] {
            for _ in 0..50 {
                let lossless = [("c2", 0.0), ("b1", 0.0)];
                let model: KeyHammerSprings = preset(name, key, &lossless);
                let x = [0.4, 0.4, 5.0, 5.0].map(|size| random.between(-size, size));
                let s = Motion {
                    position: random.between(-0.2, 0.2),
                    rate: random.between(-1.0, 1.0),
                    ..Motion::default()
                };
                check(&model, x, s);
            }
        }
    }
}

#[test]
fn model_b_is_lagranges_equations_of_its_energy() {
    springs_cases(|model, x, s| {
        for mode in [Springs::B1, Springs::B2] {
            let l = |q, v| springs_lagrangian(model.values(), mode, s.position, q, v);
            let expected = lagrange(l, [x[0], x[1]], [x[2], x[3]], [0.0; 2]);
            let dx = model.derivative(mode, &x, &s);
            assert_eq!([dx[0], dx[1]], [x[2], x[3]]);
            let p = model.values();
            // The largest acceleration that the springs give in a case.
            let scale = p.k1 / p.jk + p.k2 * (p.l1 * p.l1 / p.jk + 0.1 / p.jh);
            agree("θh''", dx[2], expected[0], scale);
            agree("θk''", dx[3], expected[1], scale);
        }
    });
}

#[test]
fn the_energies_of_model_b_are_those_of_the_vectors() {
    springs_cases(|model, x, s| {
        for mode in [Springs::B1, Springs::B2] {
            let (q, v) = ([x[0], x[1]], [x[2], x[3]]);
            let l = |v| springs_lagrangian(model.values(), mode, s.position, q, v);
            let energy = l(v) - 2.0 * l([0.0; 2]);
            // The vectors measure heights from P1, the model's energy the hammer's from P2.
            let p = model.values();
            let offset = p.g * p.m2 * p.l4;
            let got = model.energy(mode, &x, &s) + offset;
            assert!((got - energy).abs() < 1e-13 * (1.0 + energy.abs()), "{got} is not {energy}");
        }
    });
}

#[test]
fn the_slider_moves_as_the_identities_say() {
    springs_cases(|model, x, s| {
        let p = model.values();
        let mut out = [0.0; 5];
        model.outputs(Springs::B1, &x, &s, &mut out);
        let [_, _, gap, q4, q3] = out;
        let delta = x[1] - x[0];
        agree("q4", q4, compression(p, x[0], x[1]), 1e-3);
        agree("gap", gap, -q4 * delta.cos(), 1e-3);
        let per_hammer = slope(|d| compression(p, x[0] + d, x[1]));
        let per_key = slope(|d| compression(p, x[0], x[1] + d));
        agree("∂q4/∂θh", -q3 / delta.cos(), per_hammer, 1.0);
        agree("∂q4/∂θk", p.l1 + q4 * delta.tan(), per_key, 1.0);
        // The slider is on H at q3: nominal point − q4 normal = P2 + q3 direction.
        let slider = combined(combined([0.0; 2], p.l1, direction(x[1])), -q4, normal(x[1]));
        let along = dot(combined(slider, -1.0, [p.l3, p.l4]), direction(x[0]));
        agree("q3", q3, along, 1.0);
    });
}

#[test]
fn the_loss_of_the_felt_and_the_damper_do_the_work_they_report() {
    let mut random = Random::new(8);
    for _ in 0..200 {
        let model: KeyHammerSprings = preset("paper", 0, &[("c2", 0.3), ("b1", 0.2)]);
        let x = [0.1, 0.1, 2.0, 2.0].map(|size| random.between(-size, size));
        let s = Motion { position: 0.1, rate: random.between(-1.0, 1.0), ..Motion::default() };
        if model.guard(Springs::B1, GuardId(0), &x, &s).value < 0.0 {
            continue;
        }
        // dE/dt along the flow, by the chain rule on the energy alone.
        let dx = model.derivative(Springs::B1, &x, &s);
        let energy = |t: f64| {
            let y = core::array::from_fn(|i| x[i] + t * dx[i]);
            model.energy(Springs::B1, &y, &Motion { position: s.position + t * s.rate, ..s })
        };
        let balance = model.supplied(Springs::B1, &x, &s) - model.dissipated(Springs::B1, &x, &s);
        agree("dE/dt", slope(energy), balance, 1.0);
    }
}

/// θh of a rigid contact: H points from P2 to the slider on K.
fn hammer_on(p: &KeyHammerValues, s: f64) -> f64 {
    let slider = combined([0.0; 2], p.l1, direction(s));
    let along = combined(slider, -1.0, [p.l3, p.l4]);
    along[1].atan2(along[0])
}

/// s(t) with constant s''.
fn moved(s: &Motion, t: f64) -> f64 {
    s.position + t * (s.rate + 0.5 * t * s.acceleration)
}

#[test]
fn model_a_is_virtual_work() {
    let mut random = Random::new(9);
    for name in ["paper", "playable"] {
        let model: KeyHammerRigid = preset(name, 44, &[]);
        let p = &model.values;
        for _ in 0..200 {
            let s = Motion {
                position: random.between(0.0, 0.04),
                // The differences are over 1 ms: the hammer must not go far in it.
                rate: random.between(0.02, 0.2),
                acceleration: random.between(-2.0, 2.0),
                jerk: 0.0,
            };
            let (mode, x) = model.at_rest(&s);
            assert_eq!(mode, Rigid::A1);
            let angle = |t: f64| hammer_on(p, moved(&s, t));
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
            let mut out = [0.0; 3];
            model.outputs(mode, &x, &s, &mut out);
            let [contact, torque, _] = out;
            let slider = combined([0.0; 2], p.l1, direction(s.position));
            let reach = dot(combined(slider, -1.0, [p.l3, p.l4]), direction(x[0]));
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

#[test]
fn a_stiff_model_b_stands_like_model_a() {
    let mut random = Random::new(10);
    for name in ["paper", "playable"] {
        let rigid: KeyHammerRigid = preset(name, 44, &[]);
        let soft: KeyHammerSprings = preset(name, 44, &[]);
        // The sag is force over stiffness; ten times the stiffness, a tenth of it.
        let sag = |times: f64, s: &Motion| {
            let stiff = [("k1", soft.values().k1 * times), ("k2", soft.values().k2 * times)];
            let springs: KeyHammerSprings = preset(name, 44, &stiff);
            let (mode, x) = springs.at_rest(s);
            let torque = springs.readout(mode, &x, s);
            let (mode, y) = rigid.at_rest(s);
            [x[0] - y[0], torque - rigid.readout(mode, &y, s)]
        };
        for _ in 0..20 {
            let s = still(random.between(0.0, 0.04));
            let (once, tenth) = (sag(1e3, &s), sag(1e4, &s));
            for (a, b) in once.iter().zip(tenth) {
                assert!((a / b - 10.0).abs() < 0.05, "{name}: {a:e}, then {b:e}");
            }
        }
    }
}

fn cart_lagrangian(p: &CartPendulum, s: f64, q: Vector, v: Vector) -> f64 {
    let [x, angle] = q;
    // The bob hangs by `length` from the cart: its velocity from the rod's direction.
    let bob = combined([x, 0.0], -p.length, normal(angle));
    let velocity = combined([v[0], 0.0], p.length * v[1], direction(angle));
    let kinetic = 0.5
        * (p.cart_mass * v[0] * v[0]
            + p.bob_mass * dot(velocity, velocity)
            + p.inertia * v[1] * v[1]);
    kinetic - p.bob_mass * p.g * bob[1] - 0.5 * p.k * (s - x).powi(2)
}

/// Random carts, states and inputs.
fn cart_cases(mut check: impl FnMut(&CartPendulum, [f64; 4], Motion)) {
    let mut random = Random::new(11);
    for name in ["default", "key"] {
        for _ in 0..100 {
            let inertia = [("inertia", random.between(0.0, 1e-3)), ("b", random.between(0.0, 2.0))];
            let model: CartPendulum = preset(name, 0, &inertia);
            let x = [0.05, 3.0, 1.0, 5.0].map(|size| random.between(-size, size));
            let [position, rate] = [0.05, 1.0].map(|size| random.between(-size, size));
            check(&model, x, Motion { position, rate, ..Motion::default() });
        }
    }
}

#[test]
fn the_cart_is_lagranges_equations_of_its_energy() {
    cart_cases(|model, x, s| {
        let l = |q, v| cart_lagrangian(model, s.position, q, v);
        let damper = model.b * (s.rate - x[2]);
        let expected = lagrange(l, [x[0], x[1]], [x[2], x[3]], [damper, 0.0]);
        let dx = model.derivative(Cart::Free, &x, &s);
        assert_eq!([dx[0], dx[1]], [x[2], x[3]]);
        agree("x''", dx[2], expected[0], 1e3);
        agree("θ''", dx[3], expected[1], 1e4);
        let energy = l([x[0], x[1]], [x[2], x[3]]) - 2.0 * l([x[0], x[1]], [0.0; 2]);
        let got = model.energy(Cart::Free, &x, &s);
        assert!((got - energy).abs() < 1e-13 * (1.0 + energy.abs()), "{got} is not {energy}");
    });
}

#[test]
fn a_wall_gives_what_holds_the_cart() {
    cart_cases(|model, x, s| {
        for (mode, sign) in [(Cart::Left, -1.0), (Cart::Right, 1.0)] {
            let x = model.constrain(mode, &x, &s);
            let mut out = [0.0; 2];
            model.outputs(mode, &x, &s, &mut out);
            // With the wall's force applied, the cart's own equations keep it still.
            let l = |q, v| cart_lagrangian(model, s.position, q, v);
            let applied = [model.b * s.rate - sign * out[1], 0.0];
            let [cart, bob] = lagrange(l, [x[0], x[1]], [0.0, x[3]], applied);
            agree("x''", cart, 0.0, 1e3);
            agree("θ''", model.derivative(mode, &x, &s)[3], bob, 1e4);
        }
    });
}

#[test]
fn impacts_obey_their_law_and_momentum() {
    cart_cases(|model, x, s| {
        for (guard, sign) in [(GuardId(0), -1.0), (GuardId(1), 1.0)] {
            let mut before = x;
            before[2] = sign * x[2].abs();
            let reset = model.reset(Cart::Free, guard, &before, &s);
            let after = reset.state;
            assert_eq!(reset.impulse, 0.0, "the spring passes no impulse on");
            agree("x'⁺", after[2], -model.restitution * before[2], 1e-3);
            let l = |v| cart_lagrangian(model, s.position, [x[0], x[1]], v);
            let momentum = |x: &[f64; 4]| 0.5 * (l([x[2], x[3] + 1.0]) - l([x[2], x[3] - 1.0]));
            agree("∂L/∂θ'", momentum(&after), momentum(&before), 1e-3);
        }
    });
}

#[test]
fn the_ball_gives_the_floor_its_momentum() {
    let mut random = Random::new(12);
    for _ in 0..100 {
        let e = random.between(0.0, 1.0);
        let ball: BouncingBall = preset("default", 0, &[("restitution", e), ("mass", 0.3)]);
        let s = Motion {
            position: random.between(-1.0, 1.0),
            rate: random.between(-1.0, 1.0),
            acceleration: random.between(-20.0, 20.0),
            jerk: 0.0,
        };
        let speed = random.between(0.01, 3.0);
        let reset = ball.reset(Ball::Flight, GuardId(0), &[s.position, s.rate - speed], &s);
        agree("v⁺ − s'", reset.state[1] - s.rate, e * speed, 1e-3);
        agree("impulse", reset.impulse, 0.3 * (1.0 + e) * speed, 1e-3);
        assert_eq!(reset.settles.is_some(), ball.g + s.acceleration > 0.0);
        let Some(settling) = reset.settles else { continue };
        // The geometric series, term by term.
        let (mut time, mut impulse, mut v) = (0.0, 0.0, e * speed);
        for _ in 0..20_000 {
            time += 2.0 * v / (ball.g + s.acceleration);
            impulse += 0.3 * (1.0 + e) * v;
            v *= e;
        }
        if e < 0.99 {
            agree("T_Z", settling.after, time, 1e-3);
            agree("what follows", settling.impulse, impulse, 1e-3);
        }
    }
}
