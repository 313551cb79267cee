//! The reduced grand's equations against geometry, virtual work and energy.

use hand_written::ReducedGrand;
use hand_written::reduced_grand::Mode;
use models::Described as _;
use pode::{Energetic as _, GuardId, Guarded as _, Matrix, Model as _, Motion, Resets as _};

use crate::grand::{BUTTON, STRING, TRIP, agree, carried, lever};
use crate::random::Random;
use crate::stroke::{preset, still};

/// A way into the string or the bed (m).
const DEEP: f64 = 1e-3;

/// Somewhere in `mode` as it is played, and an input near.
fn played(model: &ReducedGrand, mode: Mode, random: &mut Random) -> ([f64; 4], Motion) {
    let (low, high) = match mode {
        Mode::Acc | Mode::Fla => (-3e-4, BUTTON),
        Mode::Lo | Mode::Fll => (BUTTON, TRIP),
        Mode::Flt | Mode::Stt | Mode::Stu => (0.007, 0.0105),
        Mode::RepH => (0.0085, 0.0105),
        Mode::RepL => (0.007, 0.0085),
        Mode::Rep0 => (0.003, 0.007),
        Mode::Chk => (0.0078, 0.0105),
    };
    let y = random.between(low, high);
    let z = match mode {
        Mode::Stu | Mode::Stt => STRING + random.between(0.0, DEEP),
        Mode::RepH | Mode::RepL | Mode::Rep0 => {
            lever(model.values(), y) - random.between(0.0, 8e-3)
        }
        Mode::Acc | Mode::Lo | Mode::Chk | Mode::Fla | Mode::Fll | Mode::Flt => {
            5.0 * y + random.between(0.0, 2e-3)
        }
    };
    let [u, w, rate] = [0.6, 4.0, 0.6].map(|size| random.between(-size, size));
    let position = y + random.between(-DEEP, DEEP);
    let [acceleration, jerk] = [30.0, 1e3].map(|size| random.between(-size, size));
    let input = Motion { position, rate, acceleration, jerk };
    (model.constrain(mode, &[y, z, u, w], &input), input)
}

/// 200 places in every mode, with losses and without the friction of the let-off.
fn everywhere(mut check: impl FnMut(&ReducedGrand, Mode, [f64; 4], Motion)) {
    let mut random = Random::new(21);
    for changes in [[].as_slice(), &[("nu", 0.0)], &[("kj", 900.0), ("ch", 0.3)]] {
        let model: ReducedGrand = preset("default", 0, changes);
        for (mode, _) in model.modes() {
            for _ in 0..200 {
                let (x, s) = played(&model, mode, &mut random);
                check(&model, mode, x, s);
            }
        }
    }
}

/// f'(0) by five points, `h` apart.
fn slope(h: f64, f: impl Fn(f64) -> f64) -> f64 {
    (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h)
}

#[test]
fn the_let_off_ends_at_its_height_and_ratio() {
    let model: ReducedGrand = preset("default", 0, &[]);
    let p = model.values();
    let at = |mode, y: f64| model.constrain(mode, &[y, 0.0, 1.0, 0.0], &still(0.0));
    let [_, height, _, ratio] = at(Mode::Lo, TRIP);
    agree("zt", height, p.trip_height, 1e-15);
    agree("ρ R", ratio, p.trip_ratio * p.ratio, 1e-12);
    for (place, mode) in [(at(Mode::Lo, BUTTON), "LO"), (at(Mode::Acc, BUTTON), "ACC")] {
        agree(mode, place[1], p.ratio * BUTTON, 1e-15);
        agree(mode, place[3], p.ratio, 1e-12);
    }
    let guard = model.guard(Mode::Lo, GuardId(3), &[TRIP, 0.0, 0.0, 0.0], &still(0.0));
    assert!(guard.value.abs() < 1e-17, "the trip is at {TRIP}, off by {:e}", guard.value);
}

/// y(t) and ζ(y(t)) are parabolas or their squares: five points 0.1 ms apart are exact but for
/// the rounding of 4e-2 m, 1e-17, over h² = 1e-8 s².
#[test]
fn a_carried_head_does_the_work_that_the_key_puts_in() {
    const H: f64 = 1e-4;
    everywhere(|model, mode, x, s| {
        let p = model.values();
        let [y, _, u, _] = x;
        let Some(height) = carried(p, mode, y) else { return };
        agree("z", x[1], height, 1e-15);
        let dx = model.derivative(mode, &x, &s);
        let place = |t: f64| y + t * (u + 0.5 * t * dx[2]);
        let head = |t: f64| carried(p, mode, place(t)).unwrap_or(0.0);
        let rate = |t: f64| slope(H, |d| head(t + d));
        let acceleration = slope(H, rate);
        agree("z'", dx[1], rate(0.0), 1e-9);
        agree("z''", dx[3], acceleration, 1e-7);
        // On the key alone: what the flying modes give it.
        let alone = p.key_mass * model.derivative(Mode::Flt, &x, &s)[2];
        let ratio = slope(1e-6, |d| carried(p, mode, y + d).unwrap_or(0.0));
        let mut force = p.hammer_mass * (acceleration + p.g) + p.hammer_damping * rate(0.0);
        let mut on_key = force * ratio;
        if mode == Mode::Chk {
            let spring = p.lever_stiffness * (lever(p, y) - height);
            force -= spring;
            on_key = force * ratio + spring * slope(1e-6, |d| lever(p, y + d));
        } else if mode == Mode::Lo {
            let along = (y - BUTTON) / (TRIP - BUTTON);
            let hump = 16.0 * (along * (1.0 - along)).powi(2);
            on_key += p.button_friction * hump * (u / p.friction_speed).tanh() * force;
        }
        agree("key", p.key_mass * dx[2], alone - on_key, 1e-6);
        let mut out = [0.0; 4];
        model.outputs(mode, &x, &s, &mut out);
        if mode != Mode::Chk {
            agree("F_jack", out[1], force, 1e-6);
        }
    });
}

/// Corners are passed in wf/u = 80 µs: five points 0.1 µs apart are off by (1/800)⁴ = 2e-12.
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
        if !matches!(mode, Mode::Acc | Mode::Lo) {
            return;
        }
        let dx = model.derivative(mode, &x, &s);
        let force = |t: f64| {
            let there = core::array::from_fn(|i| x[i] + t * dx[i]);
            let input = Motion {
                position: s.position + t * s.rate,
                rate: s.rate + t * s.acceleration,
                ..s
            };
            model.guard(mode, GuardId(0), &there, &input).value
        };
        let rate = model.guard(mode, GuardId(0), &x, &s).rate;
        // Rounding of the 10 N of its terms over 0.1 µs, 1e-8 N/s, beside 1e3 N/s.
        agree("λ'", rate, slope(1e-7, force), 1e-7);
    });
}

#[test]
fn a_catch_keeps_momentum_and_makes_no_energy() {
    let catches = [(Mode::Fla, 4, Mode::Acc), (Mode::Fll, 4, Mode::Lo), (Mode::RepH, 9, Mode::Chk)];
    let mut random = Random::new(22);
    let model: ReducedGrand = preset("default", 0, &[]);
    let p = model.values();
    for (mode, guard, expected) in catches {
        for _ in 0..100 {
            let (x, s) = played(&model, mode, &mut random);
            // On what it meets, going down.
            let height = carried(p, expected, x[0]).unwrap_or(0.0);
            let before = [x[0], height, x[2], -x[3].abs()];
            let reset = model.reset(mode, GuardId(guard), &before, &s);
            assert_eq!(reset.mode, expected);
            let after = reset.state;
            let ratio = slope(1e-6, |d| carried(p, expected, x[0] + d).unwrap_or(0.0));
            let momentum = |x: &[f64; 4]| p.key_mass * x[2] + p.hammer_mass * ratio * x[3];
            agree("momentum", momentum(&after), momentum(&before), 1e-9);
            agree("w⁺", after[3], ratio * after[2], 1e-9);
            let energy = |mode, x| model.energy(mode, x, &s);
            let made = energy(expected, &after) - energy(mode, &before);
            assert!(made < 1e-15, "{mode:?}: a catch made {made:e} J");
        }
    }
}

#[test]
fn nothing_moves_faster_than_the_nature_of_its_mode() {
    everywhere(|model, mode, x, s| {
        // A jack that is pressed harder rubs more; the key does not turn round there.
        if mode == Mode::Lo && model.guard(mode, GuardId(0), &x, &s).value > 0.5 {
            return;
        }
        // ‖J³²‖^(1/32) is the largest magnitude of an eigenvalue, or little more.
        let mut power = model.jacobian(mode, &x, &s);
        for _ in 0..5 {
            power = Matrix::<[f64; 4]>::product(&power, &power);
        }
        let rate = Matrix::<[f64; 4]>::norm(&power).powf(1.0 / 32.0);
        let stated = model.nature(mode).rate;
        assert!(rate < 2.0 * stated, "{mode:?} at {x:?}: {rate}, stated {stated}");
        assert!(stated * model.longest_step(mode) <= 0.251, "{mode:?}: a step is too long");
    });
}
