use pode::{Guarded as _, Matrix, Model as _, Motion};

use super::{BUTTON, STRING, TRIP, agree, lever};
use crate::kane::evaluation::Numbers;
use crate::kane::runnable::{GRAND, Runnable, guard, mode, modes, value};
use crate::kane::stroke::still;

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

/// Visits 200 states in every mode, with losses and without the friction of the let-off.
#[test]
fn no_step_is_longer_than_the_motion_allows() {
    let mut numbers = Numbers::new(21);
    for changes in [[].as_slice(), &[("nu", 0.0)], &[("kj", 900.0), ("ch", 0.3)]] {
        let model = GRAND.model::<4>("default", 0, changes);
        for (mode, name) in modes(&model).flat_map(|it| std::iter::repeat_n(it, 200)) {
            let (x, s) = played(&model, name, &mut numbers);
            // ‖J³²‖^(1/32) is the largest magnitude of an eigenvalue, or little more.
            let mut power = model.jacobian(mode, &x, &s);
            for _ in 0..5 {
                power = Matrix::<[f64; 4]>::product(&power, &power);
            }
            let rate = Matrix::<[f64; 4]>::norm(&power).powf(1.0 / 32.0);
            let radians = rate * model.longest_step_at(mode, &x, &s);
            assert!(radians < 1.0, "{name} at {x:?}: a step of {radians} rad");
        }
    }
}
