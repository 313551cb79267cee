//! The reduced grand under a finger: weights, let-off, blows and repetitions.

use pode::stepper::Rk4;
use pode::{Advance, Guarded as _, Limits, Model as _, Motion, Simulator};

use super::lever;
use crate::kane::runnable::{GRAND, Runnable, guard, mode, mode_name, value};
use crate::kane::stroke::{AuditedRun, Seen, presses, run, still};

const GRAM: f64 = 9.806_65e-3;
const H: f64 = 1e-3;

#[derive(Clone, Copy, Debug)]
struct Felt {
    y: f64,
    /// Force of the finger, as a weight (gf).
    weight: f64,
    mode: &'static str,
}

fn play(gestures: &[[f64; 3]], until: f64) -> (AuditedRun<Runnable<4>>, Vec<Felt>) {
    let model = GRAND.model::<4>("default", 0, &[]);
    let (mode, x) = model.at_rest(&still(0.0));
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, x);
    let mut audited = AuditedRun::new(H);
    let ticks = (0_u32..).map(f64::from).take_while(|tick| tick * H < until);
    let felt = ticks.map(|tick| {
        let signal = |theta: f64| presses(gestures, (tick + theta) * H);
        let done = simulator.advance(H, &signal, &mut audited);
        assert_eq!(done.advance, Advance::Completed);
        Felt {
            y: simulator.state()[0],
            weight: done.end_readout / GRAM,
            mode: mode_name(&model, simulator.mode()),
        }
    });
    let felt = felt.collect();
    (audited, felt)
}

fn strikes(audited: &AuditedRun<Runnable<4>>) -> Vec<f64> {
    let model = GRAND.model::<4>("default", 0, &[]);
    let hits = audited.events.iter().filter(|event| event.name == "string-on");
    let sounds = |event: &Seen<Runnable<4>>| {
        let speed = model.sounding(guard(&model, event.before.0, event.name), &event.before.1);
        assert_eq!(speed, Some(event.before.1[3]), "it sounds with the speed of its head");
        speed
    };
    hits.filter_map(sounds).collect()
}

/// Returns a press to the bottom that takes some 4 `w` (s), with its middle at 6 `w`.
fn press(w: f64) -> [f64; 3] {
    [0.0107, 6.0 * w, w]
}

/// Returns the slow press of a technician, 18 mm/s at most, and its release.
fn weighed() -> (AuditedRun<Runnable<4>>, Vec<Felt>) {
    play(&[press(0.3), [-0.0107, 4.2, 0.3]], 6.5)
}

fn at(felt: &[Felt], y: f64) -> Vec<f64> {
    let passes = felt.windows(2).filter(|pair| (pair[0].y < y) != (pair[1].y < y));
    passes.map(|pair| pair[1].weight).collect()
}

#[test]
fn down_weight_and_up_weight_are_those_of_a_grand() {
    // 50.9 and 25.7 gf by the independent program, which states no speeds: viscous damping adds
    // 0.046 gf for each mm/s, hence 0.8 gf at the 18 mm/s of this press.
    let (_, felt) = weighed();
    let weights = at(&felt, 0.005);
    let [down, up] = weights[..] else { panic!("passes 5 mm {} times", weights.len()) };
    assert!((down - 50.9).abs() < 0.8, "down weight {down:.2} gf");
    let up_earlier = at(&felt, 0.004)[1];
    assert!((up_earlier - 25.7).abs() < 0.8, "up weight {up_earlier:.2} gf, at 5 mm {up:.2} gf");
}

#[test]
fn the_let_off_is_felt_and_then_the_key_is_light() {
    let (audited, felt) = weighed();
    assert_eq!(audited.names()[..3], ["button", "trip", "rep-on"]);
    let in_let_off = felt.iter().filter(|it| it.mode == "LO");
    let peak = in_let_off.max_by(|a, b| a.weight.total_cmp(&b.weight)).expect("a let-off");
    // Only S + t r at rest, with t = Z' + ν half way: 2.77 + 5 times the 0.11 N of the hammer,
    // 0.11 N of the jack's spring and −0.06 N of key and friction are 92 gf; the key, held up and
    // released within 30 ms, adds some per cent.
    assert!((peak.y - 8.65e-3).abs() < 5e-5, "let-off at {:.3} mm", peak.y * 1e3);
    assert!((92.0..110.0).contains(&peak.weight), "let-off of {:.1} gf", peak.weight);
    // After the trip the hammer is off the finger, and only the jack's spring remains.
    let [after, _] = at(&felt, 9.5e-3)[..] else { panic!("passes 9.5 mm once each way") };
    assert!((20.0..30.0).contains(&after), "aftertouch of {after:.1} gf");
    let [bottom, _] = at(&felt, 10.0e-3)[..] else { panic!("passes 10 mm once each way") };
    assert!((35.0..46.0).contains(&bottom), "aftertouch of {bottom:.1} gf at the bed");
}

#[test]
fn a_slow_press_is_silent_and_faster_ones_are_louder() {
    for w in [0.07, 0.1, 0.3] {
        let (audited, felt) = play(&[press(w)], 12.0 * w + 0.5);
        assert_eq!(strikes(&audited), [0.0_f64; 0], "a press of {w} s");
        let last = felt.last().expect("ticks");
        assert_eq!(last.mode, "REPH", "the hammer lies on the lever");
    }
    let speeds: Vec<_> = [0.06, 0.04, 0.02, 0.015, 0.01, 0.0075]
        .iter()
        .map(|w| {
            let all = strikes(&play(&[press(*w)], 12.0 * w + 0.5).0);
            assert_eq!(all.len(), 1, "a press of {w} s sounds once: {all:?}");
            all[0]
        })
        .collect();
    assert!(speeds.is_sorted(), "{speeds:?}");
    assert!(speeds[0] < 0.2 && speeds[5] > 4.0, "from 0.13 to 4.0 m/s and more: {speeds:?}");
}

/// Plays a forte, up to where the key is `low` (m), and another 0.12 s later.
fn repeated(low: f64) -> AuditedRun<Runnable<4>> {
    let back = 0.0107 - low;
    play(&[[0.0107, 0.1, 0.015], [-back, 0.3, 0.015], [back, 0.42, 0.015]], 0.8).0
}

#[test]
fn a_caught_hammer_strikes_again_from_below_7_mm_and_not_from_above() {
    let whole = repeated(0.0);
    assert!(whole.names().contains(&"check"), "{:?}", whole.names());
    for low in [0.0, 0.003, 0.005, 0.006] {
        let audited = repeated(low);
        let speeds = strikes(&audited);
        assert_eq!(speeds.len(), 2, "from {low} m: {:?}", audited.names());
        assert!(audited.names().contains(&"jack-in"), "from {low} m: {:?}", audited.names());
        assert!(speeds[1] > 0.3 * speeds[0], "from {low} m: {speeds:?}");
    }
    // At 7.5 mm the jack has not slipped back, so nothing can throw the hammer.
    let audited = repeated(0.0075);
    assert_eq!(strikes(&audited).len(), 1, "{:?}", audited.names());
    assert!(!audited.names().contains(&"reset"), "{:?}", audited.names());
}

#[test]
fn a_press_while_the_head_is_below_the_check_does_not_catch_it() {
    // On the lever with the head low, the key comes down through the start of the check.
    let model = GRAND.model::<4>("default", 0, &[]);
    let s = Motion { position: 8.6e-3, rate: 0.05, ..Motion::default() };
    let x = [8.49e-3, 0.028, 0.05, -0.1];
    let (near, far) = (mode(&model, "REPH"), mode(&model, "REPL"));
    let check = model.guard(near, guard(&model, near, "check"), &x, &s).value;
    assert!(check < 0.0, "the head is {check} m over the check");
    let input = |t: f64| Motion { position: s.position + t * s.rate, ..s };
    let (audited, _) = run(&model, (far, x), (H, 0.004), input);
    assert_eq!(audited.names()[0], "check-near");
    assert_eq!(audited.events[0].after.0, near);
    assert!(
        !audited.names()[..2.min(audited.names().len())].contains(&"check"),
        "{:?}",
        audited.names()
    );
}

#[test]
fn held_down_it_rests_where_a_slow_press_would_leave_it() {
    let model = GRAND.model::<4>("default", 0, &[]);
    for (s, expected) in [(0.004, "ACC"), (0.0085, "LO"), (0.0102, "REPH")] {
        let input = still(s);
        let (mode, x) = model.at_rest(&input);
        assert_eq!(mode_name(&model, mode), expected, "at {s} m");
        let dx = model.derivative(mode, &x, &input);
        // 1e-18 m of the key on 8 kN/m, and of the head on 45 N/m over 11 g.
        assert!(dx.iter().all(|it| it.abs() < 1e-11), "at {s} m: {dx:?}");
        let (audited, end) = run(&model, (mode, x), (H, 0.5), |_| input);
        assert!(audited.events.is_empty(), "at {s} m: {:?}", audited.names());
        let moved = x.iter().zip(end.state()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(moved < 1e-10, "at {s} m it moved by {moved:e}");
    }
}

#[test]
fn a_playable_key_is_balanced_and_comes_up_from_everywhere() {
    /// Stiction of a simulated key, which a released key must overcome (N).
    const STICTION: f64 = 0.12;
    for key in 0..88 {
        let model = GRAND.model::<4>("playable", key, &[]);
        let input = still(0.004);
        let (rest, x) = model.at_rest(&input);
        let weight = model.readout(rest, &x, &input);
        // 39 gf, and more in the bass, where leads would keep the key down.
        assert!((0.38..0.51).contains(&weight), "key {key}: {weight:.3} N");
        let [mk, mh, g, kr] = ["mk", "mh", "g", "kr"].map(|name| value(&model, name));
        let sag = mh * g / kr;
        for y in (0..=20).map(|i| 0.0082 + 1e-4 * f64::from(i)) {
            // Slowly upwards, without a finger: s moves with the key.
            let u = -0.02;
            let s = Motion { position: y, rate: u, ..Motion::default() };
            for (name, z) in [("REPH", lever(&model, y) - sag), ("CHK", 0.0)] {
                let mode = mode(&model, name);
                let ratio = (lever(&model, y + 1e-7) - lever(&model, y - 1e-7)) / 2e-7;
                let x = model.constrain(mode, &[y, z, u, ratio * u], &s);
                let rises = -mk * model.derivative(mode, &x, &s)[2];
                assert!(rises > STICTION, "key {key}, {name} at {y}: {rises:.3} N");
            }
        }
    }
}
