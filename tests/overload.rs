//! What is left out while a tick has more work than time: what it saves, what it costs, and that
//! no key feels another one's work.

use std::ops::Range;

use scene::Scene;
use scheduler::motion::{KEYS, KeyEvent, KeySample, KeySlope};
use scheduler::overload::{Simplification, Simplifications};
use scheduler::port::{FinishedTick, KeyBus, TickObserver};
use scheduler::voice::VoiceWork;

use crate::stage::{Stage, keybed, play_all, scene, voices};

/// Length of a run (s), and its ticks of a millisecond.
const END: f64 = 1.2;
const TICKS: u64 = 1200;

/// What all keys did in a run.
#[derive(Default)]
struct Played {
    /// Strikes: the key, and when (s).
    strikes: Vec<(usize, f64)>,
    work: VoiceWork,
    /// What was sent to each key in each tick (N).
    forces: Vec<[f64; KEYS]>,
    /// Where each key was in each tick.
    samples: Vec<[KeySample; KEYS]>,
    /// Turns of voices that had to wait.
    waited: u64,
}

impl TickObserver for &mut Played {
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        for (key, turn) in seen.turns.iter().enumerate() {
            let strikes = turn.events.as_slice().iter().filter_map(|(at, event)| {
                let is_strike = matches!(event, KeyEvent::Strike { .. });
                is_strike.then(|| (key, at.seconds(1e-3)))
            });
            // At the end of the run one more or less may be in time.
            self.strikes.extend(strikes.filter(|(_, at)| *at < END - 0.05));
            self.work = self.work.plus(turn.work);
            self.waited += u64::from(turn.waited);
        }
        self.forces.push(*seen.forces);
        self.samples.push(*seen.samples);
    }
}

/// Keys that move as they did in another run, whatever they feel.
struct SameMotion<'a>(&'a [[KeySample; KEYS]]);

impl KeyBus for SameMotion<'_> {
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        *samples = self.0[usize::try_from(tick).expect("few ticks")];
    }

    fn send(&mut self, _tick: u64, _forces: &[f64; KEYS], _slopes: &[KeySlope; KEYS]) {}
}

/// Runs `stage`, while `simplified` says what is left out in each tick.
fn run<B: KeyBus>(
    stage: Stage<B, crate::stage::Nobody>,
    simplified: impl Fn(u64) -> Simplifications,
) -> Played {
    let mut played = Played::default();
    let mut stage = stage.watched_by(&mut played);
    for tick in 0..TICKS {
        stage.scheduler.simplify(simplified(tick));
        stage.tick();
    }
    drop(stage);
    played.strikes.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    played
}

/// Plays every key of `scene`.
fn played(scene: &Scene, simplified: impl Fn(u64) -> Simplifications) -> Played {
    let mut keybed = keybed(scene);
    play_all(&mut keybed, END);
    run(Stage::new(scene, keybed), simplified)
}

/// The root of the mean square of the difference of forces (N).
fn difference(one: &Played, other: &Played) -> f64 {
    let pairs = one.forces.iter().flatten().zip(other.forces.iter().flatten());
    let (sum, n) = pairs.fold((0.0, 0.0), |(sum, n), (a, b)| (sum + (a - b) * (a - b), n + 1.0));
    f64::sqrt(sum / n)
}

/// The largest difference of the times at which the same strikes come (s).
fn shift(one: &Played, other: &Played) -> f64 {
    let keys = |it: &Played| it.strikes.iter().map(|(key, _)| *key).collect::<Vec<_>>();
    assert_eq!(keys(one), keys(other), "the same keys sound equally often");
    let pairs = one.strikes.iter().zip(&other.strikes);
    pairs.map(|((_, a), (_, b))| (a - b).abs()).fold(0.0, f64::max)
}

fn all(simplified: &[Simplification]) -> Simplifications {
    simplified.iter().fold(Simplifications::NONE, |all, one| all.with(*one))
}

/// The default instrument on all keys, each played about twice a second: what is left out saves
/// evaluations, and moves strikes by less than a millisecond.
#[test]
fn what_is_left_out_saves_work_and_every_note_sounds_in_time() {
    let scene = scene("default", &[]);
    let whole = played(&scene, |_| Simplifications::NONE);
    let usual = f64::from(whole.work.derivatives);
    for (simplified, saved, off) in [
        (
            &[Simplification::Telemetry, Simplification::Slopes, Simplification::Fidelity][..],
            0.0,
            0.0,
        ),
        (&[Simplification::Rest], 0.005, 0.02),
        (&[Simplification::Steps], 0.3, 0.15),
    ] {
        let simplified = all(simplified);
        let less = played(&scene, |_| simplified);
        let same = run(Stage::new(&scene, SameMotion(&whole.samples)), |_| simplified);
        let part = 1.0 - f64::from(less.work.derivatives) / usual;
        let (off_by, shift) = (difference(&whole, &same), shift(&whole, &less));
        assert!(saved <= part && part < saved + 0.1, "{simplified:?} saves {part}");
        assert!(off_by <= off, "{simplified:?}: the same motion feels other by {off_by} N");
        assert!(shift < 1e-3, "{simplified:?}: strikes come {shift} s off");
    }
}

/// A force may change by more in one tick than it did with everything, since contacts come some
/// microseconds earlier or later; not by more where something is left out or taken back.
#[test]
fn no_force_steps_where_something_is_left_out_or_taken_back() {
    const SPAN: u64 = 50;
    let everything = all(&Simplification::ALL);
    for name in ["default", "springs"] {
        let scene = scene(name, &[]);
        let whole = played(&scene, |_| Simplifications::NONE);
        let is_whole = |tick: u64| (tick / SPAN).is_multiple_of(2);
        let simplified = |tick| if is_whole(tick) { Simplifications::NONE } else { everything };
        let changing = run(Stage::new(&scene, SameMotion(&whole.samples)), simplified);
        assert_eq!(changing.strikes.len(), whole.strikes.len());
        let (mut at_changes, mut elsewhere) = (0.0_f64, 0.0_f64);
        let pairs = whole.forces.windows(2).zip(changing.forces.windows(2));
        for (tick, (usual, changed)) in (1..).zip(pairs) {
            let worst =
                if is_whole(tick - 1) == is_whole(tick) { &mut elsewhere } else { &mut at_changes };
            for key in 0..KEYS {
                let step = |pair: &[[f64; KEYS]]| (pair[1][key] - pair[0][key]).abs();
                *worst = worst.max(step(changed) - step(usual));
            }
        }
        assert!(at_changes <= elsewhere, "{name}: {at_changes} N, elsewhere {elsewhere} N");
    }
}

/// A key whose voice takes 4000 evaluations in each tick, beside others on one lane.
#[test]
fn a_voice_with_too_much_work_waits_and_its_neighbours_feel_the_same_to_the_last_bit() {
    const HOG: usize = 40;
    let scene = scene("springs", &[]);
    let greedy = crate::stage::scene("springs", &[("render.longest_step", "1.1 us")]);
    let stage = |scene: &Scene, hog: Range<usize>| {
        let mut keybed = keybed(scene);
        play_all(&mut keybed, END);
        let mut playing = voices(scene);
        for key in hog {
            playing[key] = voices(&greedy).swap_remove(key);
        }
        Stage::playing(scene, playing, keybed, 1)
    };
    let whole = run(stage(&scene, 0..0), |_| Simplifications::NONE);
    let beside = run(stage(&scene, HOG..HOG + 1), |_| Simplifications::NONE);
    assert_eq!(whole.waited, 0);
    for (tick, (expected, found)) in whole.forces.iter().zip(&beside.forces).enumerate() {
        for key in (0..KEYS).filter(|key| *key != HOG) {
            assert_eq!(expected[key].to_bits(), found[key].to_bits(), "key {key} in tick {tick}");
        }
    }
    let of_hog = beside.work.evaluations() - whole.work.evaluations();
    assert!(f64::from(of_hog) <= 1100.0 * TICKS as f64, "it took {of_hog} evaluations");
    assert!(0 < beside.waited);
}
