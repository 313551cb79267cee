use super::{Conserved, conserved};
use crate::kane::evaluation::Derived;

/// Free body of three different moments, on rotations about z, x and z: it tumbles.
const TUMBLING: &str = r#"
name = "tumbling"
[coordinates]
psi = { unit = "rad", range = [-99, 99], speed_range = [-99, 99] }
theta = { unit = "rad", range = [0.1, 3], speed_range = [-99, 99] }
phi = { unit = "rad", range = [-99, 99], speed_range = [-99, 99] }
[frames]
A = { in = "ground", turn = "psi" }
B = { in = "A", turn = "theta", axis = "x" }
C = { in = "B", turn = "phi", axis = "z" }
[bodies]
C = { frame = "C", mass = "1 kg", inertia = ["1e-3 kg*m^2", "2e-3 kg*m^2", "2.7e-3 kg*m^2", "0 kg*m^2", "0 kg*m^2", "0 kg*m^2"] }
[rest]
mode = "motion"
start = true
theta = "1 rad"
"#;

#[test]
fn a_tumbling_body_keeps_its_angular_momentum_in_space_and_its_energy() {
    let derived = Derived::described(TUMBLING, 0);
    let moments = [1e-3, 2e-3, 2.7e-3];
    // On the body's axes: ω = ψ' (sin θ sin φ, sin θ cos φ, cos θ) + θ' (cos φ, −sin φ, 0) + φ' z.
    let turn = |[_, theta, phi, a, b, c]: &[f64; 6]| {
        let ((sin, cos), (s, c_phi)) = (theta.sin_cos(), phi.sin_cos());
        [a * sin * s + b * c_phi, a * sin * c_phi - b * s, a * cos + c]
    };
    let energy = |x: &[f64; 6]| -> f64 {
        turn(x).iter().zip(moments).map(|(w, moment)| 0.5 * moment * w * w).sum()
    };
    // On the ground's axes: about z by φ, about x by θ, about z by ψ.
    let in_space = |x: &[f64; 6]| {
        let w = turn(x);
        let [a, b, c] = [moments[0] * w[0], moments[1] * w[1], moments[2] * w[2]];
        let (s, cos) = x[2].sin_cos();
        let [a, b] = [a * cos - b * s, a * s + b * cos];
        let (s, cos) = x[1].sin_cos();
        let [b, c] = [b * cos - c * s, b * s + c * cos];
        let (s, cos) = x[0].sin_cos();
        [a * cos - b * s, a * s + b * cos, c]
    };
    let along = |axis: usize| move |x: &[f64; 6]| in_space(x)[axis];
    let [x, y, z] = [along(0), along(1), along(2)];
    let quantities: &[(&str, Conserved<'_, 6>)] =
        &[("energy", &energy), ("L along x", &x), ("L along y", &y), ("L along z", &z)];
    let start = [0.2, 1.3, 0.4, 1.0, 0.5, 4.0];
    conserved(&derived, (0, start), (0.0, 1.0), quantities);
}

/// Returns the rates of the disk about its own axes across, along and up its lean: ω1 = θ',
/// ω2 = ψ' + φ' sin θ along its axle, ω3 = φ' cos θ.
fn disk_turns([_, _, _, lean, _, _, _, yaw_rate, lean_rate, roll_rate]: &[f64; 10]) -> [f64; 3] {
    let (sin, cos) = lean.sin_cos();
    [*lean_rate, roll_rate + yaw_rate * sin, yaw_rate * cos]
}

const DISK: [f64; 10] = [0.0, 0.0, 0.1, 0.3, 0.0, 0.0, 0.0, 4.0, -0.5, 12.0];

#[test]
fn a_rolling_disk_keeps_its_energy() {
    let derived = Derived::shipped("rolling-disk");
    let [m, r, g] = ["m", "R", "g"].map(|name| derived.value_of(name));
    let energy = |x: &[f64; 10]| {
        let [a, b, c] = disk_turns(x);
        let moving = m * r * r * (a * a + b * b);
        let turning = m * r * r / 4.0 * (a * a + 2.0 * b * b + c * c);
        0.5 * (moving + turning) + m * g * r * x[3].cos()
    };
    let start = derived.consistent(0, &DISK, [0.0; 4]).try_into().expect("ten entries");
    conserved(&derived, (0, start), (0.0, 1.0), &[("energy", &energy)]);
}
