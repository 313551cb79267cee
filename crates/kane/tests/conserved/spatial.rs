//! Bodies in space: one that tumbles, and one that rolls.

use super::{Conserved, conserved, free};
use crate::evaluation::Derived;

/// A free body of three unlike moments, on turns about z, x and z: it tumbles.
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

/// Rates of turn of the disk about its own axes across, along and up its lean: ω1 = θ',
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

/// As functions of the lean θ alone, dω2/dθ = −2 ω3/3 and dω3/dθ = ω3 tan θ − 2 ω2: whatever the
/// lean does, ω2 and ω3 come back with it. (Appell and Korteweg solved these in series.)
#[test]
fn the_turns_of_a_rolling_disk_are_functions_of_its_lean() {
    let derived = Derived::shipped("rolling-disk");
    let start = derived.consistent(0, &DISK, [0.0; 4]).try_into().expect("ten entries");
    let tolerance = 1e-11;
    let run = free(&derived, (0, start), (0.0, 1.0), tolerance);
    let [_, b, c] = disk_turns(&start);
    let mut far = 0.0_f64;
    for state in &run.states {
        let [_, along, up] = disk_turns(state);
        let [expected_along, expected_up] = turns_at(start[3], [b, c], state[3]);
        far = far.max((state[3] - start[3]).abs());
        // The turns are of 10 rad/s, and change by as much per radian of the lean.
        let bound = 100.0 * tolerance * f64::from(run.steps);
        assert!((along - expected_along).abs() < bound, "{along} is not {expected_along}");
        assert!((up - expected_up).abs() < bound, "{up} is not {expected_up}");
    }
    assert!(far > 0.1, "it leans by {far} only");
}

/// ω2 and ω3 at another lean: RK4 in 2000 steps.
fn turns_at(from: f64, mut turns: [f64; 2], to: f64) -> [f64; 2] {
    let rates = |lean: f64, [b, c]: [f64; 2]| [-2.0 * c / 3.0, c * lean.tan() - 2.0 * b];
    let h = (to - from) / 2000.0;
    let ahead = |[b, c]: [f64; 2], [db, dc]: [f64; 2], h: f64| [b + h * db, c + h * dc];
    for step in 0..2000 {
        let lean = from + h * f64::from(step);
        let k1 = rates(lean, turns);
        let k2 = rates(lean + 0.5 * h, ahead(turns, k1, 0.5 * h));
        let k3 = rates(lean + 0.5 * h, ahead(turns, k2, 0.5 * h));
        let k4 = rates(lean + h, ahead(turns, k3, h));
        for i in 0..2 {
            turns[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
    }
    turns
}
