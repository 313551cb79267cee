//! A key's sensor or wire fails: its neighbours are unaffected, and it fades and returns.

use std::ops::Range;

use boards::links::faulty::{Chance, Direction, FaultPlan, LinkFault, Scripted};
use boards::sim::keybed::SimulatedKeybed;
use firmware_protocol::key::BoardId;
use haptics::Touch;
use scene::Scene;
use scheduler::motion::{KEYS, KeyEvent};
use scheduler::port::{FinishedTick, KeyBus, TickObserver};

use crate::stage::broken_sensor::BrokenSensor;
use crate::stage::{Nobody, Stage, key, keybed, play_all, scene, stroke};

/// The key with the failing sensor: held down, so that it should always feel a force.
const FAILING: usize = 40;
const TICKS: u64 = 5500;
/// Ticks of the fault; by then the hammer of the held key has come to rest.
const WRONG: Range<u64> = 4000..4060;
/// Ticks from the first held one to the first without force: 20 ms.
const FADE: u64 = 20;

fn hands(scene: &Scene) -> SimulatedKeybed {
    let mut keybed = keybed(scene);
    play_all(&mut keybed, 5.5);
    keybed.play(key(FAILING), vec![stroke(0.1, f64::INFINITY, Touch::Pressed, 0.3)]);
    keybed
}

/// Forces on every key in every tick (N), and the number of faulted voices in it.
struct Felt {
    forces: Vec<[f64; KEYS]>,
    faults: Vec<u32>,
}

fn felt<B: KeyBus>(stage: &mut Stage<B, Nobody>) -> Felt {
    let (mut forces, mut faults) = (Vec::new(), Vec::new());
    for _ in 0..TICKS {
        faults.push(stage.tick().voices.faults);
        forces.push(*stage.forces());
    }
    Felt { forces, faults }
}

fn healthy() -> Felt {
    let scene = scene("springs", &[]);
    let bus = hands(&scene);
    let felt = felt(&mut Stage::new(&scene, bus));
    assert_eq!(felt.faults.iter().sum::<u32>(), 0);
    felt
}

fn index(tick: u64) -> usize {
    usize::try_from(tick).unwrap_or(usize::MAX)
}

#[track_caller]
fn check_neighbours(healthy: &Felt, felt: &Felt, disturbed: &Range<usize>) {
    let mut differed = false;
    for (tick, (expected, forces)) in healthy.forces.iter().zip(&felt.forces).enumerate() {
        for (key, (expected, force)) in expected.iter().zip(forces).enumerate() {
            let same = expected.to_bits() == force.to_bits();
            assert!(same || disturbed.contains(&key), "tick {tick}: key {key} noticed");
            differed |= !same;
        }
    }
    assert!(differed, "nothing was disturbed");
}

/// Asserts that the failing key is held at `last_good`, fades in 20 ms, and returns after tick
/// `back`, without a step on the way.
#[track_caller]
fn check_fade(felt: &Felt, last_good: u64, back: u64) {
    let at = |tick: u64| felt.forces[index(tick)][FAILING];
    let held = at(last_good);
    assert!(0.1 < held, "the key felt {held} N");
    assert!(at(last_good + 1).to_bits() == held.to_bits(), "the first faulty tick holds");
    for tick in last_good + 1 + FADE..back {
        assert!(at(tick) == 0.0, "{} N at tick {tick}", at(tick));
    }
    let after = at(TICKS - 1);
    assert!((after - held).abs() < 0.05 * held, "{held} N before, {after} N after");
    // A step would be the whole force in one tick. Key and hammer move: twice as much.
    let step = 3.0 * held / FADE as f64;
    for tick in last_good..TICKS - 1 {
        let change = (at(tick + 1) - at(tick)).abs();
        assert!(change <= step, "{change} N after tick {tick}, allowed {step} N");
    }
}

#[test]
fn nan_from_a_sensor_stays_with_its_key_on_any_number_of_lanes() {
    let healthy = healthy();
    for n_lanes in 1..=2 {
        let scene = scene("springs", &[]);
        let bus = BrokenSensor { keybed: hands(&scene), key: FAILING, ticks: WRONG };
        let felt = felt(&mut Stage::on_lanes(&scene, bus, n_lanes));
        check_neighbours(&healthy, &felt, &(FAILING..FAILING + 1));
        check_fade(&felt, WRONG.start - 1, WRONG.end);
        for (tick, faults) in (0..).zip(&felt.faults) {
            assert_eq!(*faults, u32::from(WRONG.contains(&tick)), "tick {tick}");
        }
    }
}

#[test]
fn one_nan_is_a_fault_that_fades_whole() {
    let scene = scene("springs", &[]);
    let bus = BrokenSensor { keybed: hands(&scene), key: FAILING, ticks: 4000..4001 };
    let felt = felt(&mut Stage::new(&scene, bus));
    assert_eq!(felt.faults.iter().sum::<u32>(), 1);
    check_fade(&felt, 3999, 3999 + FADE + 1);
    check_neighbours(&healthy(), &felt, &(FAILING..FAILING + 1));
}

fn disturbed(plan: FaultPlan) -> (Felt, Stage<SimulatedKeybed, Nobody>) {
    let scene = scene("springs", &[]);
    let mut bus = hands(&scene);
    bus.disturb(board(), plan);
    let mut stage = Stage::new(&scene, bus);
    (felt(&mut stage), stage)
}

fn board() -> BoardId {
    BoardId::of(key(FAILING))
}

fn scripted(exchanges: Range<u64>, fault: LinkFault) -> FaultPlan {
    let script = vec![Scripted { exchanges, direction: Direction::Receive, fault }];
    FaultPlan { script, ..FaultPlan::default() }
}

#[test]
fn one_lost_sample_is_bridged() {
    let healthy = healthy();
    let (felt, stage) = disturbed(scripted(4000..4001, LinkFault::Drop));
    check_neighbours(&healthy, &felt, &board().keys());
    assert_eq!(stage.bus.statistics(board()).samples.gaps, 1);
    let (expected, force) = (healthy.forces[4000][FAILING], felt.forces[4000][FAILING]);
    assert!((expected - force).abs() < 1e-2 * expected, "{expected} N, {force} N");
}

#[test]
fn lost_samples_are_bridged_held_and_faded_and_the_board_alone_notices() {
    // Shorter than the board's own patience, 20 ms, after which it would have to be armed.
    let lost = 4000..4018;
    let (felt, stage) = disturbed(scripted(lost.clone(), LinkFault::Drop));
    check_neighbours(&healthy(), &felt, &board().keys());
    let statistics = stage.bus.statistics(board());
    assert_eq!((statistics.samples.gaps, statistics.samples.missing), (1, 18));
    assert!(!stage.bus.is_safe(board()));
    let at = |tick: usize| felt.forces[tick][FAILING];
    assert!(at(4001).to_bits() == at(4000).to_bits(), "after one tick it holds");
    assert!(at(4017) < 0.3 * at(4000), "and fades: {} N of {} N are left", at(4017), at(4000));
    let step = 3.0 * at(4000) / FADE as f64;
    for tick in 3999..index(TICKS) - 1 {
        let change = (at(tick + 1) - at(tick)).abs();
        assert!(change <= step, "{change} N after tick {tick}, allowed {step} N");
    }
}

#[test]
fn a_board_that_was_silent_fades_and_comes_back_when_it_is_armed() {
    let scene = scene("springs", &[]);
    let mut bus = hands(&scene);
    bus.disturb(board(), scripted(WRONG, LinkFault::Down));
    let mut stage = Stage::new(&scene, bus);
    let mut felt = Felt { forces: Vec::new(), faults: Vec::new() };
    for tick in 0..TICKS {
        if tick == WRONG.end {
            assert!(stage.bus.is_safe(board()), "its own watchdog tripped");
            stage.bus.rearm();
        }
        felt.faults.push(stage.tick().voices.faults);
        felt.forces.push(*stage.forces());
    }
    check_neighbours(&healthy(), &felt, &board().keys());
    // The first lost sample is bridged, so the second tick holds.
    check_fade(&felt, WRONG.start, WRONG.end);
    assert_eq!(stage.bus.wire(board()).down, WRONG.end - WRONG.start);
    assert_eq!(stage.bus.board_counts(board()).trips, 1);
}

#[derive(Default)]
struct Ends(Vec<u64>);

impl TickObserver for Ends {
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        let events = seen.turns[FAILING].events.as_slice();
        let falls = events.iter().filter(|(_at, it)| matches!(it, KeyEvent::DamperFall { .. }));
        self.0.extend(falls.map(|_fall| seen.tick));
    }
}

fn ends<B: KeyBus>(bus: B) -> Vec<u64> {
    let mut stage = Stage::new(&scene("springs", &[]), bus).watched_by(Ends::default());
    for _ in 0..TICKS {
        stage.tick();
    }
    stage.observer.0
}

#[test]
fn the_note_of_a_key_ends_when_its_voice_fails_or_its_board_is_silent_for_long() {
    let scene = scene("springs", &[]);
    assert!(ends(hands(&scene)).is_empty(), "it is held");
    assert_eq!(ends(BrokenSensor { keybed: hands(&scene), key: FAILING, ticks: WRONG }), [4000]);
    let silent_in = |ticks| {
        let mut bus = hands(&scene);
        bus.disturb(board(), scripted(ticks, LinkFault::Drop));
        ends(bus)
    };
    // The first sample that does not come is a tick old.
    assert_eq!([silent_in(4000..4500), silent_in(4000..4600)], [vec![], vec![4500]]);
}

#[test]
fn corrupt_frames_are_counted_and_never_acted_on() {
    let healthy = healthy();
    let chances = vec![Chance { probability: 0.05, fault: LinkFault::FlipBit }];
    let (felt, stage) = disturbed(FaultPlan { seed: 7, chances, script: Vec::new() });
    check_neighbours(&healthy, &felt, &board().keys());
    let flipped = stage.bus.fault_counts(board()).flipped;
    let statistics = stage.bus.statistics(board());
    let at_board = stage.bus.board_counts(board());
    let wire = stage.bus.wire(board());
    let refused = wire.corrupt + statistics.refused + at_board.corrupt + at_board.refused;
    assert!(100 < flipped, "{flipped} bits were flipped");
    // A flipped bit may make a zero, which cuts a frame in two, or unmake the closing one.
    assert!(refused.abs_diff(flipped) <= flipped / 10, "{refused} of {flipped}");
    assert_eq!(felt.faults.iter().sum::<u32>(), 0);
    // The key is held: it never feels a step, in spite of all losses.
    for (tick, pair) in felt.forces.windows(2).enumerate().skip(4000) {
        let change = (pair[1][FAILING] - pair[0][FAILING]).abs();
        assert!(change < 0.1, "{change} N after tick {tick}");
    }
}
