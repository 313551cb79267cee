//! The `playable` presets of models A and B feel like a key, over the whole compass.

use pode::input::{Reconstruction, Reconstructor};
use pode::stepper::Rk4;
use pode::{Advance, Limits, Model as _, Motion, Silent, Simulator};

use crate::kane::evaluation::Numbers;
use crate::kane::runnable::{RIGID, Runnable, SPRINGS, guard, value};
use crate::kane::stroke::{Seen, run, still};

/// Key dip (m) and lever arm of the finger (m): piano-facts.
const DIP: f64 = 0.010_16;
const FRONT: f64 = 0.2595;

fn compass() -> impl Iterator<Item = (u8, Runnable<4>)> {
    (0..88).map(|key| (key, SPRINGS.model("playable", key, &[])))
}

fn hammer<const N: usize>(model: &Runnable<N>, down: f64) -> f64 {
    model.at_rest(&still(down / FRONT)).1[0]
}

/// Returns the distance of the head below the string (m) at that rest.
fn short<const N: usize>(model: &Runnable<N>, down: f64) -> f64 {
    value(model, "L2") * (value(model, "string_angle") - hammer(model, down))
}

#[test]
fn the_key_bottom_leaves_the_hammer_short_of_the_string() {
    for (key, model) in compass() {
        let rigid = RIGID.model::<2>("playable", key, &[]);
        for (name, short) in [("springs", short(&model, DIP)), ("rigid", short(&rigid, DIP))] {
            assert!((2e-3..3e-3).contains(&short), "key {key}, {name}: {:.3} mm", short * 1e3);
        }
    }
}

#[test]
fn the_blow_is_five_dips_and_what_is_left() {
    for (key, model) in compass() {
        let blow = short(&model, 0.0);
        assert!((0.053..0.0545).contains(&blow), "key {key}: {:.2} mm", blow * 1e3);
    }
}

#[test]
fn the_head_travels_five_times_the_key_front() {
    for (key, model) in compass() {
        let head = value(&model, "L2") * (hammer(&model, DIP) - hammer(&model, 0.0));
        let ratio = head / DIP;
        assert!((4.75..5.25).contains(&ratio), "key {key}: {ratio:.3}");
    }
}

#[test]
fn every_key_is_balanced() {
    for (key, model) in compass() {
        for down in [0.0, 0.5 * DIP, DIP] {
            let input = still(down / FRONT);
            let (mode, x) = model.at_rest(&input);
            let force = model.readout(mode, &x, &input) * model.input_per_metre();
            // 39 gf, 0.382 N, with the hammer level; 0.03 N less at its steepest.
            assert!((0.34..0.385).contains(&force), "key {key} at {down}: {force:.4} N");
            let rigid = RIGID.model::<2>("playable", key, &[]);
            let (mode, x) = rigid.at_rest(&input);
            let rigid = rigid.readout(mode, &x, &input) * rigid.input_per_metre();
            // The springs' sag, 0.4 mm at the head, is a hundredth of the blow.
            assert!((force - rigid).abs() < 0.01 * force, "key {key}: {force} N, rigid {rigid} N");
        }
    }
}

fn press(duration: f64, t: f64) -> Motion {
    let z = (t / duration).clamp(0.0, 1.0);
    let bottom = DIP / FRONT;
    let powers = |a: f64, b: f64, c: f64| bottom * (a + z * (b + z * c));
    let r = 1.0 / duration;
    Motion {
        position: powers(10.0, -15.0, 6.0) * z * z * z,
        rate: powers(30.0, -60.0, 30.0) * z * z * r,
        acceleration: powers(60.0, -180.0, 120.0) * z * r * r,
        jerk: if z < 1.0 { powers(60.0, -360.0, 360.0) * r * r * r } else { 0.0 },
    }
}

fn strikes(key: u8, duration: f64) -> Vec<f64> {
    let model = SPRINGS.model::<4>("playable", key, &[]);
    let (audited, _) = run(&model, model.at_rest(&still(0.0)), (1e-3, 1.0), |t| press(duration, t));
    let hit = |event: &Seen<Runnable<4>>| {
        model.sounding(guard(&model, event.before.0, event.name), &event.before.1)
    };
    audited.events.iter().filter_map(hit).collect()
}

#[test]
fn a_slow_press_is_silent_and_faster_ones_are_louder() {
    for key in [0, 39, 87] {
        assert_eq!(strikes(key, 0.5), [0.0_f64; 0], "key {key}: a silent press");
        let speeds = [0.12, 0.06, 0.03].map(|duration| strikes(key, duration)[0]);
        assert!(speeds.is_sorted(), "key {key}: {speeds:?}");
        assert!(speeds[0] > 0.2 && speeds[2] < 7.0, "key {key}: {speeds:?}");
    }
}

#[test]
fn a_press_sounds_once() {
    for key in [0, 39, 87] {
        for duration in [0.12, 0.06, 0.03] {
            let all = strikes(key, duration);
            // Later strikes have at most a fifth of the speed: no second note.
            assert!(all[1..].iter().all(|it| *it < 0.2 * all[0]), "key {key}: {all:?}");
        }
    }
}

#[test]
fn pressing_past_the_bottom_neither_caps_nor_rattles() {
    let model = SPRINGS.model::<4>("playable", 39, &[]);
    // 1.5 mm into the key-bottom felt, where the rigid hammer would be past the string.
    let input = |t: f64| {
        let Motion { position, rate, acceleration, jerk } = press(0.1, t);
        let k = 1.0 + 1.5e-3 / DIP;
        Motion { position: k * position, rate: k * rate, acceleration: k * acceleration, jerk }
    };
    let start = model.at_rest(&still(0.0));
    let (audited, simulator) = run(&model, start, (1e-3, 2.0), input);
    let hits = audited.events.iter().filter(|event| event.name == "string");
    let last = hits.map(|event| event.t).fold(0.0, f64::max);
    assert!(last < 0.4, "still hits the string at {last} s");
    let last = audited.events.last().expect("events").t;
    assert!(last < 1.5, "still leaves the key at {last} s");
    assert!(simulator.state().iter().all(|it| it.abs() < 1.0));
}

#[test]
fn a_hammer_pushed_through_the_string_is_not_put_back() {
    // Model A's contact is rigid: 1.5 mm past the bottom the head is past the string. A key that
    // drops faster than the hammer can fall leaves it there.
    let model = RIGID.model::<2>("playable", 39, &[]);
    let bottom = (DIP + 1.5e-3) / FRONT;
    let input = |t: f64| {
        let t = (t - 0.01).max(0.0);
        Motion {
            position: bottom - 1000.0 * t * t * t,
            rate: -3000.0 * t * t,
            acceleration: -6000.0 * t,
            jerk: -6000.0,
        }
    };
    let start = model.at_rest(&still(bottom));
    assert!(start.1[0] > value(&model, "string_angle"), "the head is past the string");
    let (audited, _) = run(&model, start, (1e-3, 0.03), input);
    assert_eq!(audited.names(), ["release"]);
    assert_eq!(audited.events[0].before.1, audited.events[0].after.1, "a release keeps the state");
}

/// Returns the force at the finger under a sampled input, and that under the exact one (N).
fn deviation(kind: Reconstruction, quantum: f64, noise: f64) -> f64 {
    const H: f64 = 1e-3;
    let model = SPRINGS.model::<4>("playable", 39, &[]);
    let (mode, x) = model.at_rest(&still(0.0));
    let mut exact = Simulator::new(model, Rk4, Limits::default(), mode, x);
    let mut sampled = Simulator::new(model, Rk4, Limits::default(), mode, x);
    let mut samples = Reconstructor::new(kind, 0.0, H);
    let mut numbers = Numbers::new(13);
    let mut worst: f64 = 0.0;
    for tick in 0..1000_u32 {
        let t = f64::from(tick) * H;
        let down = press(0.2, t).position * FRONT + noise * numbers.next();
        let signal = samples.push((down / quantum).round() * quantum / FRONT);
        let rough = sampled.advance(H, &signal, &mut Silent);
        let smooth = exact.advance(H, &|theta: f64| press(0.2, t + theta * H), &mut Silent);
        assert_eq!((rough.advance, smooth.advance), (Advance::Completed, Advance::Completed));
        worst = worst.max((rough.mean_readout - smooth.mean_readout).abs() / FRONT);
    }
    worst
}

#[test]
fn a_quantised_and_noisy_input_moves_the_force_by_a_bounded_amount() {
    // 10 µm of quantum and one of noise: s is off by up to q = 15 µm, the rate of a parabola
    // through it by 4 q / h, and the damper passes that on: b1 4 q / (h r²). The key on its
    // coupling rings on top, at most as high again.
    let (q, h) = (1.5e-5, 1e-3);
    let (k1, b1) = (300.0, 0.12);
    let bound = |rates: f64| 2.0 * (k1 * q + b1 * rates * q / h) / (FRONT * FRONT);
    for (kind, rates) in [
        (Reconstruction::Hold, 0.0),
        (Reconstruction::Linear, 2.0),
        (Reconstruction::Quadratic, 4.0),
        (Reconstruction::LateHermite, 4.0),
    ] {
        let worst = deviation(kind, 1e-5, 1e-5);
        assert!(worst < bound(rates), "{kind:?}: {worst} N, bound {}", bound(rates));
    }
}
