use crate::kane::builder::MechanismBuilder;
use crate::kane::evaluation::{Derived, Numbers, close};

const STILL: [f64; 4] = [0.0; 4];

fn double_pendulum() -> MechanismBuilder {
    let mut m = MechanismBuilder::new(
        &[("m1", 1.3), ("m2", 0.7), ("l1", 0.9), ("l2", 0.6), ("g", 9.81)],
        &["a", "b"],
    );
    m.gravity(&["0", "-g"]);
    let first = m.frame(0, &["0", "0"], "a");
    m.body(first, "m1", &["l1"], "0");
    let second = m.frame(0, &["l1*cos(a)", "l1*sin(a)"], "b");
    m.body(second, "m2", &["l2"], "0");
    m.mode("free", &[]);
    m
}

/// (m1 + m2) l1² a'' + m2 l1 l2 (cos(a − b) b'' + sin(a − b) b'²) + (m1 + m2) g l1 cos a = 0,
/// m2 l2² b'' + m2 l1 l2 (cos(a − b) a'' − sin(a − b) a'²) + m2 g l2 cos b = 0.
#[test]
fn a_double_pendulum() {
    let d = Derived::from(double_pendulum());
    let mut numbers = Numbers::new(1);
    for _ in 0..20 {
        let x: [f64; 4] = numbers.list::<4>().map(|it| 3.0 * it);
        let f = d.derivative(0, &x, STILL);
        let [m1, m2, l1, l2, g] = d.values[..] else { unreachable!() };
        let [a, b, u, v] = x;
        let first = (m1 + m2) * l1 * l1 * f[2]
            + m2 * l1 * l2 * ((a - b).cos() * f[3] + (a - b).sin() * v * v)
            + (m1 + m2) * g * l1 * a.cos();
        let second = m2 * l2 * l2 * f[3]
            + m2 * l1 * l2 * ((a - b).cos() * f[2] - (a - b).sin() * u * u)
            + m2 * g * l2 * b.cos();
        close(first, 0.0, 1e-11, "first");
        close(second, 0.0, 1e-11, "second");
        close(f[0], u, 0.0, "a'");
    }
}

/// r'' = r φ'² + g cos φ − k (r − l)/m, φ'' = −(2 r' φ' + g sin φ)/r.
#[test]
fn a_spring_pendulum() {
    let mut m =
        MechanismBuilder::new(&[("m", 0.4), ("l", 0.5), ("k", 30.0), ("g", 9.81)], &["r", "phi"]);
    m.gravity(&["0", "-g"]);
    let frame = m.frame(0, &["0", "0"], "phi");
    m.body(frame, "m", &["0", "-r"], "0");
    m.force("spring", "r - l", "k*stretch", "k*stretch^2/2");
    m.mode("free", &[]);
    m.rest(0, "l");
    let d = Derived::from(m);
    let mut numbers = Numbers::new(3);
    for _ in 0..20 {
        let [r, phi, u, w] = numbers.list::<4>();
        let r = 1.0 + 0.5 * r;
        let f = d.derivative(0, &[r, phi, u, w], STILL);
        let [m, l, k, g] = d.values[..] else { unreachable!() };
        close(f[2], r * w * w + g * phi.cos() - k * (r - l) / m, 1e-12, "r''");
        close(f[3], -(2.0 * u * w + g * phi.sin()) / r, 1e-12, "phi''");
    }
}

/// A thin disc that rolls without slipping: yaw φ, lean θ, spin ψ; ω1 = θ', ω2 = ψ' + φ' sin θ and
/// ω3 = φ' cos θ along the leaning axes:
/// ω1' = (4 g sin θ + 6 r ω2 ω3 − r ω3² tan θ)/(5 r), ω2' = −2 ω1 ω3/3,
/// ω3' = ω1 (ω3 tan θ − 2 ω2).
#[test]
fn a_rolling_disc() {
    let parameters = [("m", 0.8), ("r", 0.3), ("g", 9.81)];
    let mut m = MechanismBuilder::new(&parameters, &["x", "y", "phi", "theta", "psi"]);
    m.gravity(&["0", "0", "-g"]);
    // The disc is in the plane of x and z of its leaning frame, its axis is y.
    let yaw = m.frame_about(0, &["x", "y", "0"], Some((2, "phi")));
    let lean = m.frame_about(yaw, &["0", "0", "0"], Some((0, "theta")));
    let spin = m.frame_about(lean, &["0", "0", "r"], Some((1, "psi")));
    let across = m.e("m*r^2/4");
    let along = m.e("m*r^2/2");
    m.body_with(
        spin,
        "m",
        &["0", "0", "0"],
        [Some(across), Some(along), Some(across), None, None, None],
    );
    // The point of contact (x, y) moves on the floor as the rim unrolls.
    m.nonholonomic("roll_x", "x' - r*psi'*cos(phi)");
    m.nonholonomic("roll_y", "y' - r*psi'*sin(phi)");
    m.mode("rolls", &[0, 1]);
    let mut d = Derived::from(m);
    let mut numbers = Numbers::new(4);
    for _ in 0..20 {
        let [x, y, phi, theta, psi] = numbers.list::<5>();
        let [yaw, lean, spin] = numbers.list::<3>().map(|it| 3.0 * it);
        let state = [x, y, phi, theta, psi, 0.0, 0.0, yaw, lean, spin];
        let state = d.consistent(0, &state, STILL);
        let f = d.derivative(0, &state, STILL);
        let [_, r, g] = d.values[..] else { unreachable!() };
        let (sin, cos) = theta.sin_cos();
        let tan = sin / cos;
        let (w1, w2, w3) = (lean, spin + yaw * sin, yaw * cos);
        let d1 = (4.0 * g * sin + 6.0 * r * w2 * w3 - r * w3 * w3 * tan) / (5.0 * r);
        close(f[8], d1, 1e-11, "lean");
        let spinning = f[9] + f[7] * sin + yaw * lean * cos;
        close(spinning, -2.0 * w1 * w3 / 3.0, 1e-11, "spin");
        let yawing = f[7] * cos - yaw * lean * sin;
        close(yawing, w1 * (w3 * tan - 2.0 * w2), 1e-11, "yaw");
        let lost = crate::kane::evaluation::imbalance(&mut d, 0, &state, STILL);
        close(lost, 0.0, 1e-11, "energy");
    }
}
