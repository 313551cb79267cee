//! From links to an armed keybed, and what is refused on the way.
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]
#![expect(clippy::disallowed_methods, reason = "boards live in real time")]

use std::time::Duration;

use firmware_protocol::frame::key_forces::ForcePacking;
use firmware_protocol::frame::key_samples::SamplePacking;
use firmware_protocol::key::KeyIndex;
use haptics::plant::{Gesture, Touch};
use hardware::keybed::{Armed, Keybed, NamedLink, Offline, Terms, WantedBoards};
use hardware::refusal::Refusal;
use hardware::rt::board_supervisor::{ArmLockout, ArmState};
use hardware::rt::link_snapshot::LinkSnapshot;
use keyboard::KeyRange;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus as _;

use crate::common::{Living, board, clock, keybed, nominal, now_us, pair};

const PATIENCE: u64 = 5_000_000;

fn wanted() -> WantedBoards {
    WantedBoards { hz: 1_000, ..WantedBoards::default() }
}

fn terms() -> Terms {
    Terms {
        period_us: 1_000,
        samples: SamplePacking::default(),
        forces: ForcePacking::default(),
        valid_ms: 100,
    }
}

fn armed(keybed: Keybed<Offline>) -> Keybed<Armed> {
    let identified = keybed.identify(PATIENCE).expect("boards");
    let calibrated = identified.calibrate(&wanted(), nominal).expect("good boards");
    calibrated.arm(terms(), PATIENCE).expect("boards that can be armed")
}

/// Exchanges `ticks` times, a millisecond apart, with the same force on all keys.
fn exchange(keybed: &mut Keybed<Armed>, from: u64, ticks: u64, force: f64) -> [KeySample; KEYS] {
    let mut samples = [KeySample::default(); KEYS];
    for tick in from..from + ticks {
        keybed.receive(tick, &mut samples);
        keybed.send(tick, &[force; KEYS], &[KeySlope::HELD; KEYS]);
        std::thread::sleep(Duration::from_millis(1));
    }
    samples
}

#[test]
fn two_boards_are_found_armed_and_take_forces() {
    let (offline, boards) = keybed(&[2, 5]);
    let mut keybed = armed(offline);
    // Down: 1 N is more than the 0.12 N of stiction.
    let samples = exchange(&mut keybed, 0, 300, -1.0);
    for (key, sample) in samples.iter().enumerate() {
        let is_there = (22..33).contains(&key) || (55..66).contains(&key);
        assert_eq!(9e-3 < sample.position, is_there, "key {key}: {sample:?}");
    }
    let reports = keybed.board_reports();
    drop(keybed);
    for (report, living) in reports.iter().zip(boards) {
        let counts = living.stop().counts();
        assert!(200 < counts.forces && counts.corrupt == 0 && counts.refused == 0, "{counts:?}");
        assert!(counts.oldest_us <= 100_000, "{counts:?}");
        assert_eq!(report.condition.armings, 1, "{report:?}");
    }
}

#[test]
fn one_board_shows_its_light_while_all_render_and_each_is_seen() {
    let (offline, mut boards) = keybed(&[2, 5]);
    let mut keybed = armed(offline);
    let (mut lights, mut samples) = (keybed.identify_requests(), keybed.monitor(1_000));
    exchange(&mut keybed, 0, 50, 0.0);
    lights.push(1).expect("room");
    exchange(&mut keybed, 50, 100, 0.0);
    let mut seen = std::iter::from_fn(|| samples.pop().ok());
    for line in [0, 1] {
        let (tick, snapshot) = seen.next().expect("a line");
        assert!(matches!(snapshot, LinkSnapshot::Line(it, _) if it == line), "{tick}");
    }
    for board in [0, 1] {
        let Some((_, LinkSnapshot::Board(index, it))) = seen.next() else { panic!("no board") };
        let status = it.status.expect("it is supervised");
        assert_eq!((index, status.state, status.armings), (board, ArmState::Armed, 1));
        assert!(status.round_trip_us.is_some_and(|it| 0 < it), "{status:?}");
    }
    assert_eq!(seen.next(), None, "they are shown once a second");
    let lit: Vec<_> = boards.drain(..).map(|board| board.stop().is_lit()).collect();
    assert_eq!(lit, [false, true]);
}

#[test]
fn a_board_that_was_stopped_shows_its_light_all_the_same() {
    let (offline, mut boards) = keybed(&[0]);
    let mut keybed = armed(offline);
    exchange(&mut keybed, 0, 50, 0.0);
    keybed.stop(1);
    exchange(&mut keybed, 50, 200, 0.0);
    keybed.request_light(0);
    exchange(&mut keybed, 250, 100, 0.0);
    let report = keybed.board_reports().remove(0);
    assert!(
        matches!(report.condition.state, ArmState::Barred(ArmLockout::Latched(_))),
        "{report:?}"
    );
    assert!(boards.remove(0).stop().is_lit());
}

#[test]
fn a_host_that_falls_silent_leaves_a_board_safe_and_one_that_comes_back_arms_it_again() {
    let (offline, mut boards) = keybed(&[0]);
    let mut keybed = armed(offline);
    exchange(&mut keybed, 0, 100, -1.0);
    std::thread::sleep(Duration::from_millis(300));
    exchange(&mut keybed, 400, 300, 0.0);
    let report = keybed.board_reports().remove(0);
    assert_eq!(report.condition.armings, 2, "{report:?}");
    let counts = boards.remove(0).stop().counts();
    assert_eq!((counts.trips, counts.armings), (1, 2), "{counts:?}");
}

#[test]
fn a_simulated_finger_plays_over_the_link() {
    let (offline, _boards) = keybed(&[3]);
    let mut keybed = armed(offline);
    let key = KeyIndex::new(39).expect("C4");
    let gesture =
        Gesture { start: 0.1, release: 0.4, touch: Touch::Pressed, speed: 0.3, ..Gesture::USUAL };
    keybed.play(key, &[gesture]);
    keybed.begin_at(now_us());
    let mut deepest = 0.0_f64;
    let mut samples = [KeySample::default(); KEYS];
    for tick in 0..700 {
        keybed.receive(tick, &mut samples);
        keybed.send(tick, &[0.2; KEYS], &[KeySlope::HELD; KEYS]);
        deepest = deepest.max(samples[39].position);
        std::thread::sleep(Duration::from_millis(1));
    }
    assert!(9e-3 < deepest, "{deepest}");
    assert!(samples[39].position < 1e-3, "{:?}", samples[39]);
}

#[test]
fn a_line_without_a_board_is_refused_by_its_name() {
    let (host, _nobody) = pair();
    let line = NamedLink::new("/dev/printer", Box::new(host));
    let refusals = Keybed::new(vec![line], clock()).identify(300_000).expect_err("nobody");
    let sentence = refusals.to_string();
    assert!(
        sentence.contains("/dev/printer") && sentence.contains("not a byte came"),
        "{sentence}"
    );
}

#[test]
fn one_board_on_two_lines_is_refused() {
    let (offline, _boards) = keybed(&[1, 1]);
    let refusals = offline.identify(PATIENCE).expect_err("twins");
    assert!(matches!(refusals.0[..], [Refusal::SameBoard { .. }]), "{refusals}");
}

#[test]
fn a_board_that_carries_other_keys_than_the_scene_says_is_refused() {
    let (offline, _boards) = keybed(&[1]);
    let identified = offline.identify(PATIENCE).expect("a board");
    let scene = KeyRange::parse("A0..G1").expect("keys");
    let boards = vec![(0, 1, scene), (0, 7, scene)];
    let refusals = identified.calibrate(&WantedBoards { boards, ..wanted() }, nominal);
    let sentence = refusals.expect_err("other keys").to_string();
    assert!(
        sentence.contains("says that it carries G#1..F#2, the scene says A0..G1"),
        "{sentence}"
    );
    assert!(sentence.contains("the scene wants board 7 on socket 1"), "{sentence}");
}

#[test]
fn a_board_that_dies_is_brought_up_again_and_the_other_never_notices() {
    let (host, away) = pair();
    let (other_host, other_away) = pair();
    let lines =
        vec![NamedLink::new("dies", Box::new(host)), NamedLink::new("lives", Box::new(other_host))];
    let first = Living::start(board(0), away);
    let other = Living::start(board(1), other_away);
    let mut keybed = armed(Keybed::new(lines, clock()));
    exchange(&mut keybed, 0, 100, -1.0);
    drop(first);
    let samples = exchange(&mut keybed, 100, 200, -1.0);
    assert!(100 < samples[0].age && samples[11].age < 100, "{:?} {:?}", samples[0], samples[11]);
    assert!(9e-3 < samples[11].position);
    let statistics = keybed.board_reports()[1].statistics;
    assert!(200 < statistics.samples.frames, "{statistics:?}");
    let counts = other.stop().counts();
    assert_eq!(counts.trips, 0, "{counts:?}");
}

#[test]
fn forces_for_all_boards_move_the_keys_of_each() {
    let (offline, boards) = keybed(&[2, 5]);
    let identified = offline.identify(PATIENCE).expect("boards");
    let forces = ForcePacking::Multicast16;
    let calibrated = identified.calibrate(&WantedBoards { forces, ..wanted() }, nominal);
    let calibrated = calibrated.expect("boards that take multicast");
    let mut keybed = calibrated.arm(Terms { forces, ..terms() }, PATIENCE).expect("armed");
    let samples = exchange(&mut keybed, 0, 300, -1.0);
    for key in (22..33).chain(55..66) {
        assert!(9e-3 < samples[key].position, "key {key}: {:?}", samples[key]);
    }
    for living in boards {
        let counts = living.stop().counts();
        assert!(200 < counts.forces && counts.oldest_us <= 32_000, "{counts:?}");
    }
}
