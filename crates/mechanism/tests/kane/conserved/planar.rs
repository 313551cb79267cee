use super::{Conserved, conserved, free};
use crate::kane::evaluation::Derived;
use crate::kane::work::pendulum;

/// Mass (kg), inertia (kg m²), position and velocity of a mass centre, and angular velocity.
struct Moving {
    mass: f64,
    inertia: f64,
    place: [f64; 2],
    velocity: [f64; 2],
    turn: f64,
}

impl Moving {
    fn energy(&self, gravity: f64) -> f64 {
        let [_, y] = self.place;
        let [u, v] = self.velocity;
        0.5 * self.mass * (u * u + v * v)
            + 0.5 * self.inertia * self.turn * self.turn
            + self.mass * gravity * y
    }

    fn angular_momentum(&self) -> f64 {
        let ([x, y], [u, v]) = (self.place, self.velocity);
        self.mass * (x * v - y * u) + self.inertia * self.turn
    }
}

/// Returns the rods of the double pendulum: angles are to the vertical and to the upper rod.
fn rods(derived: &Derived, [a, b, u, w]: &[f64; 4]) -> [Moving; 2] {
    let [l1, l2, m1, m2] = ["l1", "l2", "m1", "m2"].map(|name| derived.value_of(name));
    let (sin, cos) = a.sin_cos();
    let (low, high) = (a + b).sin_cos();
    let turn = u + w;
    let half = |sin: f64, cos: f64, length: f64| [0.5 * length * sin, -0.5 * length * cos];
    let along = |sin: f64, cos: f64, length: f64, rate: f64| {
        [0.5 * length * cos * rate, 0.5 * length * sin * rate]
    };
    let upper = Moving {
        mass: m1,
        inertia: m1 * l1 * l1 / 12.0,
        place: half(sin, cos, l1),
        velocity: along(sin, cos, l1, *u),
        turn: *u,
    };
    let (knee, knee_rate) = (half(sin, cos, 2.0 * l1), along(sin, cos, 2.0 * l1, *u));
    let (own, own_rate) = (half(low, high, l2), along(low, high, l2, turn));
    let lower = Moving {
        mass: m2,
        inertia: m2 * l2 * l2 / 12.0,
        place: [knee[0] + own[0], knee[1] + own[1]],
        velocity: [knee_rate[0] + own_rate[0], knee_rate[1] + own_rate[1]],
        turn,
    };
    [upper, lower]
}

#[test]
fn a_double_pendulum_keeps_its_energy_also_at_an_elastic_wall() {
    let mut derived = Derived::shipped("double-pendulum");
    derived.set("restitution", 1.0);
    let k = derived.value_of("k");
    let energy = |x: &[f64; 4]| {
        let rods: f64 = rods(&derived, x).iter().map(|it| it.energy(9.81)).sum();
        rods + 0.5 * k * (0.2 - x[0]).powi(2)
    };
    let start = (0, [0.2, -0.4, 4.0, -9.0]);
    let run = free(&derived, start, (0.2, 1.0), 1e-8);
    let turns = run.states.windows(2).filter(|it| (it[1][3] - it[0][3]).abs() > 5.0).count();
    assert!(turns > 0, "the wall is met");
    conserved(&derived, start, (0.2, 1.0), &[("energy", &energy)]);
}

#[test]
fn a_double_pendulum_without_gravity_and_spring_keeps_its_angular_momentum() {
    let mut derived = Derived::shipped("double-pendulum");
    for (name, value) in [("g", 0.0), ("k", 0.0), ("wall", 1.0)] {
        derived.set(name, value);
    }
    let energy = |x: &[f64; 4]| rods(&derived, x).iter().map(|it| it.energy(0.0)).sum();
    let about_pivot = |x: &[f64; 4]| rods(&derived, x).iter().map(Moving::angular_momentum).sum();
    let quantities: &[(&str, Conserved<'_, 4>)] =
        &[("energy", &energy), ("angular momentum", &about_pivot)];
    conserved(&derived, (0, [0.2, -0.4, 2.0, -3.0]), (0.0, 1.0), quantities);
}

#[test]
fn twelve_hanging_rods_keep_their_energy() {
    let derived = Derived::described(&pendulum(12), 0);
    let energy = |x: &[f64; 24]| {
        let (mut angle, mut turn, mut knee, mut speed) = (0.0, 0.0, [0.0; 2], [0.0; 2]);
        let mut sum = 0.5 * 0.6 * x[0] * x[0];
        for (q, u) in x[..12].iter().zip(&x[12..]) {
            (angle, turn) = (angle + q, turn + u);
            let (sin, cos) = f64::sin_cos(angle);
            let (half, rate) = ([0.05 * sin, -0.05 * cos], [0.05 * cos * turn, 0.05 * sin * turn]);
            let place = [knee[0] + half[0], knee[1] + half[1]];
            let velocity = [speed[0] + rate[0], speed[1] + rate[1]];
            let rod = Moving { mass: 0.05, inertia: 0.05 * 0.01 / 12.0, place, velocity, turn };
            sum += rod.energy(9.81);
            knee = [place[0] + half[0], place[1] + half[1]];
            speed = [velocity[0] + rate[0], velocity[1] + rate[1]];
        }
        sum
    };
    let mut start = [0.1; 24];
    start[0] = 1.0;
    conserved(&derived, (0, start), (0.0, 0.2), &[("energy", &energy)]);
}

/// Two bodies in the plane, each with its position and angle, on a spring between their edges.
const PAIR: &str = r#"
name = "pair"
[coordinates]
x1 = { unit = "m", range = [-9, 9], speed_range = [-9, 9] }
y1 = { unit = "m", range = [-9, 9], speed_range = [-9, 9] }
a1 = { unit = "rad", range = [-99, 99], speed_range = [-99, 99] }
x2 = { unit = "m", range = [-9, 9], speed_range = [-9, 9] }
y2 = { unit = "m", range = [-9, 9], speed_range = [-9, 9] }
a2 = { unit = "rad", range = [-99, 99], speed_range = [-99, 99] }
[frames]
A = { in = "ground", origin = ["x1", "y1"], turn = "a1" }
B = { in = "ground", origin = ["x2", "y2"], turn = "a2" }
[points]
P = { in = "A", at = ["0.1 m", "0.05 m"] }
Q = { in = "B", at = ["-0.2 m", "0.02 m"] }
[bodies]
A = { frame = "A", mass = "0.3 kg", inertia = "2e-3 kg*m^2" }
B = { frame = "B", mass = "0.7 kg", inertia = "9e-3 kg*m^2" }
[springs]
k = { between = ["P", "Q"], length = "0.2 m", stiffness = "40 N/m" }
[rest]
mode = "motion"
start = true
x2 = "0.7 m"
"#;

#[test]
fn two_bodies_on_a_spring_keep_momentum_angular_momentum_and_energy() {
    let derived = Derived::described(PAIR, 0);
    let both = |x: &[f64; 12]| {
        [(0, 0.3, 2e-3), (3, 0.7, 9e-3)].map(|(i, mass, inertia)| Moving {
            mass,
            inertia,
            place: [x[i], x[i + 1]],
            velocity: [x[6 + i], x[7 + i]],
            turn: x[8 + i],
        })
    };
    let momentum = |axis: usize| {
        move |x: &[f64; 12]| both(x).iter().map(|it| it.mass * it.velocity[axis]).sum::<f64>()
    };
    let (along_x, along_y) = (momentum(0), momentum(1));
    let turning = |x: &[f64; 12]| both(x).iter().map(Moving::angular_momentum).sum::<f64>();
    let energy = |x: &[f64; 12]| {
        let end = |i: usize, [a, b]: [f64; 2]| {
            let (sin, cos) = x[i + 2].sin_cos();
            [x[i] + a * cos - b * sin, x[i + 1] + a * sin + b * cos]
        };
        let (p, q) = (end(0, [0.1, 0.05]), end(3, [-0.2, 0.02]));
        let stretch = (q[0] - p[0]).hypot(q[1] - p[1]) - 0.2;
        both(x).iter().map(|it| it.energy(0.0)).sum::<f64>() + 20.0 * stretch * stretch
    };
    let start = [0.0, 0.0, 0.3, 0.7, 0.1, -0.5, 0.4, -0.2, 3.0, 0.1, 0.6, -2.0];
    let quantities: &[(&str, Conserved<'_, 12>)] = &[
        ("momentum along x", &along_x),
        ("momentum along y", &along_y),
        ("angular momentum", &turning),
        ("energy", &energy),
    ];
    conserved(&derived, (0, start), (0.0, 2.0), quantities);
}

/// Returns the rods of the linkage; the coupler's angle is that to the ground.
fn linkage_rods(derived: &Derived, x: &[f64; 6]) -> [Moving; 3] {
    let [crank, base] = ["crank", "base"].map(|name| derived.value_of(name));
    let rod = |i: usize, mass: &str, length: &str, pivot: [f64; 2], pivot_rate: [f64; 2]| {
        let (mass, length) = (derived.value_of(mass), derived.value_of(length));
        let ((sin, cos), turn) = (x[i].sin_cos(), x[3 + i]);
        let half = 0.5 * length;
        Moving {
            mass,
            inertia: mass * length * length / 12.0,
            place: [pivot[0] + half * cos, pivot[1] + half * sin],
            velocity: [pivot_rate[0] - half * sin * turn, pivot_rate[1] + half * cos * turn],
            turn,
        }
    };
    let (sin, cos) = x[0].sin_cos();
    let knee = [crank * cos, crank * sin];
    let knee_rate = [-crank * sin * x[3], crank * cos * x[3]];
    [
        rod(0, "m1", "crank", [0.0; 2], [0.0; 2]),
        rod(1, "m2", "coupler", knee, knee_rate),
        rod(2, "m3", "rocker", [base, 0.0], [0.0; 2]),
    ]
}

/// Two constraints are projected in each step: the loop stays closed, and no energy is lost.
#[test]
fn a_closed_linkage_keeps_its_energy_and_stays_closed() {
    let mut derived = Derived::shipped("linkage");
    derived.set("k", 0.01);
    let input = 0.3;
    let energy = |x: &[f64; 6]| {
        let rods: f64 = linkage_rods(&derived, x).iter().map(|it| it.energy(9.81)).sum();
        rods + 0.005 * (input - x[0]).powi(2)
    };
    let open = |axis: usize| {
        let [_, coupler, rocker] = ["crank", "coupler", "rocker"].map(|it| derived.value_of(it));
        let rods = &derived;
        move |x: &[f64; 6]| {
            let end = linkage_rods(rods, x);
            let along = |i: usize| [x[i].cos(), x[i].sin()][axis];
            end[1].place[axis] + 0.5 * coupler * along(1)
                - end[2].place[axis]
                - 0.5 * rocker * along(2)
        }
    };
    let start = derived.consistent(0, &[0.2, 0.6, 1.3, 8.0, 0.0, 0.0], [input, 0.0, 0.0, 0.0]);
    let start = start.try_into().expect("six entries");
    let (x, y) = (open(0), open(1));
    let quantities: &[(&str, Conserved<'_, 6>)] =
        &[("energy", &energy), ("opening along x", &x), ("opening along y", &y)];
    conserved(&derived, (0, start), (input, 1.0), quantities);
}
