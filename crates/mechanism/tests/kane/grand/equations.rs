use instruments::equations::ModeNumber;
use pode::{Energetic as _, Guarded as _, Matrix, Model as _, Motion, Resets as _};

use super::{BUTTON, STRING, TRIP, agree, carried, lever};
use crate::kane::evaluation::Numbers;
use crate::kane::runnable::{GRAND, Runnable, guard, mode, mode_name, modes, output, value};
use crate::kane::stroke::still;

/// Displacement into the string or the bed (m).
const DEEP: f64 = 1e-3;

/// Returns a state of the mode called `name` as it is played, and an input near.
fn played(model: &Runnable<4>, name: &str, numbers: &mut Numbers) -> ([f64; 4], Motion) {
    let (low, high) = match name {
        "ACC" | "FLA" => (-3e-4, BUTTON),
        "LO" | "FLL" => (BUTTON, TRIP),
        "FLT" | "STT" | "STU" => (0.007, 0.0105),
        "REPH" => (0.0085, 0.0105),
        "REPL" => (0.007, 0.0085),
        "REP0" => (0.003, 0.007),
        _ => (0.0078, 0.0105),
    };
    let mut part = || 0.5 * (1.0 + numbers.next());
    let y = low + (high - low) * part();
    let z = match name {
        "STU" | "STT" => STRING + DEEP * part(),
        "REPH" | "REPL" | "REP0" => lever(model, y) - 8e-3 * part(),
        _ => 5.0 * y + 2e-3 * part(),
    };
    let [u, w, rate] = [0.6, 4.0, 0.6].map(|size| size * numbers.next());
    let position = y + DEEP * numbers.next();
    let [acceleration, jerk] = [30.0, 1e3].map(|size| size * numbers.next());
    let input = Motion { position, rate, acceleration, jerk };
    (model.constrain(mode(model, name), &[y, z, u, w], &input), input)
}

/// Visits 200 states in every mode, with losses and without the friction of the let-off.
fn everywhere(mut check: impl FnMut(&Runnable<4>, ModeNumber, [f64; 4], Motion)) {
    let mut numbers = Numbers::new(21);
    for changes in [[].as_slice(), &[("nu", 0.0)], &[("kj", 900.0), ("ch", 0.3)]] {
        let model = GRAND.model::<4>("default", 0, changes);
        for (mode, name) in modes(&model) {
            for _ in 0..200 {
                let (x, s) = played(&model, name, &mut numbers);
                check(&model, mode, x, s);
            }
        }
    }
}

/// Returns f'(0) by five points, `h` apart.
fn slope(h: f64, f: impl Fn(f64) -> f64) -> f64 {
    (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h)
}

#[test]
fn the_let_off_ends_at_its_height_and_ratio() {
    let model = GRAND.model::<4>("default", 0, &[]);
    let of = |name| value(&model, name);
    let at = |name, y| model.constrain(mode(&model, name), &[y, 0.0, 1.0, 0.0], &still(0.0));
    let [_, height, _, ratio] = at("LO", TRIP);
    agree("zt", height, of("zt"), 1e-15);
    agree("ρ R", ratio, of("rho") * of("R"), 1e-12);
    for mode in ["LO", "ACC"] {
        let [_, height, _, ratio] = at(mode, BUTTON);
        agree(mode, height, of("R") * BUTTON, 1e-15);
        agree(mode, ratio, of("R"), 1e-12);
    }
    let lo = mode(&model, "LO");
    let trip = model.guard(lo, guard(&model, lo, "trip"), &[TRIP, 0.0, 0.0, 0.0], &still(0.0));
    assert!(trip.value.abs() < 1e-17, "the trip is at {TRIP}, off by {:e}", trip.value);
}

/// y(t) and ζ(y(t)) are parabolas or their squares: five points 0.1 ms apart are exact except for
/// the rounding of 4e-2 m, 1e-17, over h² = 1e-8 s².
#[test]
fn a_carried_head_does_the_work_that_the_key_puts_in() {
    const H: f64 = 1e-4;
    everywhere(|model, mode, x, s| {
        let of = |name| value(model, name);
        let name = mode_name(model, mode);
        let [y, _, u, _] = x;
        let Some(height) = carried(model, name, y) else { return };
        agree("z", x[1], height, 1e-15);
        let dx = model.derivative(mode, &x, &s);
        let place = |t: f64| y + t * (u + 0.5 * t * dx[2]);
        let head = |t: f64| carried(model, name, place(t)).unwrap_or(0.0);
        let rate = |t: f64| slope(H, |d| head(t + d));
        let acceleration = slope(H, rate);
        agree("z'", dx[1], rate(0.0), 1e-9);
        agree("z''", dx[3], acceleration, 1e-7);
        // On the key alone: the contribution of the flying modes.
        let alone = of("mk") * model.derivative(self::mode(model, "FLT"), &x, &s)[2];
        let ratio = slope(1e-6, |d| carried(model, name, y + d).unwrap_or(0.0));
        let mut force = of("mh") * (acceleration + of("g")) + of("ch") * rate(0.0);
        let mut on_key = force * ratio;
        if name == "CHK" {
            let spring = of("kr") * (lever(model, y) - height);
            force -= spring;
            on_key = force * ratio + spring * slope(1e-6, |d| lever(model, y + d));
        } else if name == "LO" {
            let along = (y - BUTTON) / (TRIP - BUTTON);
            let hump = 16.0 * (along * (1.0 - along)).powi(2);
            on_key += of("nu") * hump * (u / of("vc")).tanh() * force;
        }
        agree("key", of("mk") * dx[2], alone - on_key, 1e-6);
        if name != "CHK" {
            agree("F_jack", output(model, mode, (&x, &s), "F_jack"), force, 1e-6);
        }
    });
}

/// Corners take wf/u = 80 µs: five points 0.1 µs apart are off by (1/800)⁴ = 2e-12.
#[test]
fn the_energy_is_what_is_put_in_less_what_is_lost() {
    everywhere(|model, mode, x, s| {
        let dx = model.derivative(mode, &x, &s);
        let energy = |t: f64| {
            let there = core::array::from_fn(|i| x[i] + t * dx[i]);
            let input = Motion { position: s.position + t * s.rate, ..s };
            model.energy(mode, &there, &input)
        };
        let lost = model.dissipated(mode, &x, &s);
        let balance = model.supplied(mode, &x, &s) - lost;
        agree("dE/dt", slope(1e-7, energy), balance, 1e-7);
        let is_valid =
            model.guards(mode).iter().all(|guard| model.guard(mode, guard.id, &x, &s).value > 0.0);
        assert!(lost >= 0.0 || !is_valid, "{mode:?} loses {lost} W");
    });
}

#[test]
fn the_jacks_force_changes_at_its_rate() {
    everywhere(|model, mode, x, s| {
        if !["ACC", "LO"].contains(&mode_name(model, mode)) {
            return;
        }
        let id = guard(model, mode, "lift-off");
        let dx = model.derivative(mode, &x, &s);
        let force = |t: f64| {
            let there = core::array::from_fn(|i| x[i] + t * dx[i]);
            let input = Motion {
                position: s.position + t * s.rate,
                rate: s.rate + t * s.acceleration,
                ..s
            };
            model.guard(mode, id, &there, &input).value
        };
        let rate = model.guard(mode, id, &x, &s).rate;
        // Rounding of the 10 N of its terms over 0.1 µs, 1e-8 N/s, beside 1e3 N/s.
        agree("λ'", rate, slope(1e-7, force), 1e-7);
    });
}

#[test]
fn a_catch_keeps_momentum_and_makes_no_energy() {
    let catches = [("FLA", "land", "ACC"), ("FLL", "land", "LO"), ("REPH", "check", "CHK")];
    let mut numbers = Numbers::new(22);
    let model = GRAND.model::<4>("default", 0, &[]);
    let [mk, mh] = ["mk", "mh"].map(|name| value(&model, name));
    for (name, by, expected) in catches {
        let (from, to) = (mode(&model, name), mode(&model, expected));
        for _ in 0..100 {
            let (x, s) = played(&model, name, &mut numbers);
            let head = |y: f64| carried(&model, expected, y).unwrap_or(0.0);
            let before = [x[0], head(x[0]), x[2], -x[3].abs()];
            let reset = model.reset(from, guard(&model, from, by), &before, &s);
            assert_eq!(reset.mode, to);
            let after = reset.state;
            let ratio = slope(1e-6, |d| head(x[0] + d));
            let momentum = |x: &[f64; 4]| mk * x[2] + mh * ratio * x[3];
            agree("momentum", momentum(&after), momentum(&before), 1e-9);
            agree("w⁺", after[3], ratio * after[2], 1e-9);
            let made = model.energy(to, &after, &s) - model.energy(from, &before, &s);
            assert!(made < 1e-15, "{name}: a catch made {made:e} J");
        }
    }
}

#[test]
fn no_step_is_longer_than_the_motion_allows() {
    everywhere(|model, mode, x, s| {
        let name = mode_name(model, mode);
        // ‖J³²‖^(1/32) is the largest magnitude of an eigenvalue, or little more.
        let mut power = model.jacobian(mode, &x, &s);
        for _ in 0..5 {
            power = Matrix::<[f64; 4]>::product(&power, &power);
        }
        let rate = Matrix::<[f64; 4]>::norm(&power).powf(1.0 / 32.0);
        let radians = rate * model.longest_step_at(mode, &x, &s);
        assert!(radians < 1.0, "{name} at {x:?}: a step of {radians} rad");
    });
}
