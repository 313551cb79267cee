//! Boards with faulty clocks, sensors or firmware, on the host's own path to them, in virtual time.

use std::cell::Cell;

use boards::keybed::{Armed, Keybed, NamedLink, Offline, Terms, WantedBoards};
use boards::links::loopback::Loopback;
use boards::links::{HostClock, Link, RecvError, SendError};
use boards::refusal::Refusals;
use boards::rt::board_supervisor::{ArmLockout, ArmState as BoardStage};
use boards::rt::key_fault::KeyFault;
use boards::sim::board::{BoardMake, SimulatedBoard};
use firmware_protocol::acyclic::Operation;
use firmware_protocol::frame::FrameKind;
use firmware_protocol::frame::hello::safe_reason;
use firmware_protocol::frame::key_forces::{ForceLayout, ForcePacking, KeyForces};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout, SamplePacking};
use firmware_protocol::key::{BoardId, KEYS_PER_BOARD, MOST_KEYS, PerKey};
use firmware_protocol::quantity::Counts;
use haptics::{RigParameters, Touch};
use scheduler::port::{FinishedTick, TickObserver};

use crate::stage::{Stage, scene, stroke};

const TICK_US: u64 = 1_000;
/// Interval at which a board polls its link (us), as in `letoff board`.
const LOOK_US: u64 = 500;
/// Advance of the clock at each query while boards are brought up (us).
const ASKED_US: u64 = 250;
const TICKS: u64 = 3_000;
/// Largest force on an untouched key (N).
const NONE: f64 = 0.5;
/// The played key of board 3: C4, and its slot.
const PLAYED: (usize, usize) = (39, 6);

thread_local! {
    /// Time on this thread (us), advanced at each query.
    static NOW: Cell<u64> = const { Cell::new(1_000_000) };
    static LATER: Cell<u64> = const { Cell::new(ASKED_US) };
    /// Relative excess rate of this thread's board clocks.
    static DRIFT: Cell<f64> = const { Cell::new(0.0) };
    static WRONG: Cell<Wrong> = const { Cell::new(Wrong::Nothing) };
    /// Largest force of each key in the last frame (mN), and number of armings.
    static SENT: Cell<[u16; KEYS_PER_BOARD]> = const { Cell::new([0; KEYS_PER_BOARD]) };
    static ARMINGS: Cell<u32> = const { Cell::new(0) };
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Wrong {
    Nothing,
    Flag,
    KeyLess,
    KeyFault,
    /// Offset of the played key's reading (um).
    Elsewhere(i32),
    /// Random error of the played key's reading, up to this (um).
    Noise(i32),
}

fn now_us() -> u64 {
    NOW.set(NOW.get() + LATER.get());
    NOW.get()
}

struct Wire {
    board: SimulatedBoard,
    loopback: Loopback,
    /// Host time of the board's last step, and the board's own (us).
    looked: u64,
    lived: f64,
    chance: u64,
}

impl Wire {
    /// Board 3, on which [`PLAYED`] is struck `n_strokes` times from its second second on.
    fn new(n_strokes: u32) -> Self {
        let id = BoardId::new(3).expect("a board");
        let make = BoardMake::standard(id, 100e-6, RigParameters::default());
        let mut board = SimulatedBoard::new(make).expect("a possible board");
        let strokes = (0..n_strokes).map(|n| {
            let start = 2.0 + 0.4 * f64::from(n);
            let touch = if n % 2 == 0 { Touch::Struck } else { Touch::Pressed };
            stroke(start, start + 0.2, touch, 0.3 + 0.1 * f64::from(n))
        });
        board.play(PLAYED.1, strokes.collect());
        Self { board, loopback: Loopback::new(256), looked: NOW.get(), lived: 0.0, chance: 1 }
    }

    fn live(&mut self) {
        let now = NOW.get() / LOOK_US * LOOK_US;
        self.lived += now.saturating_sub(self.looked) as f64 * (1.0 + DRIFT.get());
        self.looked = now.max(self.looked);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "short")]
        let tick = (self.lived / 100.0) as u64;
        if WRONG.get() == Wrong::KeyFault {
            self.board.fail(safe_reason::KEY_FAULT);
        }
        self.board.advance(tick, &mut self.loopback.board_end());
    }

    fn distorted(&mut self, samples: KeySamples) -> KeySamples {
        let mut distorted = samples;
        let noise = |most: i32, chance: u64| {
            let span = u64::try_from(2 * most + 1).expect("positive");
            i32::try_from((chance >> 33) % span).expect("small") - most
        };
        let beside = match WRONG.get() {
            Wrong::Flag => {
                distorted.header.flag = true;
                0
            }
            Wrong::KeyLess => {
                let fewer = samples.positions.as_slice().iter().skip(1).copied();
                distorted.positions = PerKey::collect(fewer);
                0
            }
            Wrong::Elsewhere(it) => it,
            Wrong::Noise(most) => {
                self.chance = self.chance.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                noise(most, self.chance)
            }
            Wrong::Nothing | Wrong::KeyFault => 0,
        };
        if let Some(played) = distorted.positions.as_mut_slice().get_mut(PLAYED.1) {
            *played = Counts::saturating(played.get() + beside);
        }
        distorted
    }
}

impl Link for Wire {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        let layout = ForceLayout { packing: ForcePacking::Force16, n_keys: KEYS_PER_BOARD };
        match FrameKind::of(frame) {
            Some(FrameKind::KeyForces) => {
                let sent = KeyForces::decode(frame, layout).expect("forces");
                let forces: Vec<_> =
                    sent.forces.as_slice().iter().map(|it| it.get().unsigned_abs()).collect();
                SENT.set(forces.try_into().expect("all keys"));
            }
            Some(FrameKind::Request) if frame.get(2) == Some(&(Operation::Arm as u8)) => {
                ARMINGS.set(ARMINGS.get() + 1);
            }
            _ => {}
        }
        self.loopback.host_end().try_send(frame)
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        self.live();
        let len = self.loopback.host_end().try_recv(buffer)?;
        let Some(len) =
            len.filter(|len| FrameKind::of(&buffer[..*len]) == Some(FrameKind::KeySamples))
        else {
            return Ok(len);
        };
        let packing = SamplePacking::default();
        let layout = SampleLayout { packing, n_keys: KEYS_PER_BOARD };
        let samples = KeySamples::decode(&buffer[..len], layout).expect("samples");
        let mut bytes = [0; firmware_protocol::frame::key_samples::MAX_LEN];
        let len = self.distorted(samples).encode(packing, &mut bytes);
        buffer[..len].copy_from_slice(&bytes[..len]);
        Ok(Some(len))
    }
}

const PATIENCE: u64 = 4_000_000;

fn armed(drift: f64, n_strokes: u32) -> Result<Keybed<Armed>, Refusals> {
    armed_within(PATIENCE, drift, n_strokes)
}

/// Like [`armed`], but waits for at most `patience` (us) until it renders forces.
fn armed_within(patience: u64, drift: f64, n_strokes: u32) -> Result<Keybed<Armed>, Refusals> {
    DRIFT.set(drift);
    LATER.set(ASKED_US);
    let line = NamedLink::new("wire", Box::new(Wire::new(n_strokes)));
    let keybed =
        Keybed::<Offline>::new(vec![line], HostClock::Monotonic(now_us)).identify(PATIENCE)?;
    let wanted = WantedBoards { hz: 1_000, ..WantedBoards::default() };
    let keybed = keybed.calibrate(&wanted, |found, _name| {
        Ok(PerKey::collect(std::iter::repeat_n(found.nominal(), found.hello.n_keys.into())))
    })?;
    let terms = Terms {
        period_us: 1_000,
        samples: SamplePacking::default(),
        forces: ForcePacking::default(),
        valid_ms: 20,
    };
    keybed.arm(terms, patience)
}

#[derive(Default)]
struct Heard {
    strikes: u32,
    faults: u32,
    force: f64,
}

impl TickObserver for Heard {
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        for turn in seen.turns {
            self.faults += u32::from(turn.fault.is_some());
            self.strikes += u32::try_from(turn.events.strikes()).expect("few");
        }
        self.force = seen.forces.iter().fold(self.force, |most, it| it.abs().max(most));
    }
}

fn staged(keybed: Keybed<Armed>) -> Stage<Keybed<Armed>, Heard> {
    LATER.set(0);
    NOW.set(NOW.get() + 137);
    Stage::new(&scene("springs", &[]), keybed).watched_by(Heard::default())
}

fn run(stage: &mut Stage<Keybed<Armed>, Heard>, ticks: u64) {
    for _ in 0..ticks {
        NOW.set(NOW.get() + TICK_US);
        stage.tick();
    }
}

fn at_every_drift(check: impl Fn(f64) + Sync) {
    let drifts = [-5.0, -3.3, -3.0, -2.0, -1.0, -0.02, 0.0, 0.02, 1.0, 1.5, 2.0, 3.0, 3.3, 5.0];
    std::thread::scope(|scope| {
        for drift in drifts {
            let check = &check;
            scope.spawn(move || check(drift * 1e-2));
        }
    });
}

fn is_tolerable(drift: f64) -> bool {
    drift.abs() <= 0.03
}

#[test]
fn keys_that_nobody_touches_are_quiet_at_every_drift_or_their_board_is_refused_by_name() {
    at_every_drift(|drift| match armed(drift, 0) {
        Ok(keybed) => {
            assert!(is_tolerable(drift), "{drift} was accepted");
            let mut stage = staged(keybed);
            run(&mut stage, TICKS);
            let Heard { strikes, faults, force } = stage.observer;
            assert_eq!((strikes, faults), (0, 0), "drift {drift}");
            assert!(force < NONE, "drift {drift}: {force} N");
            let report = stage.bus.board_reports().remove(0);
            let known = report.condition.drift_ppm * 1e-6;
            assert!((known - drift).abs() < 1e-3, "{known} for {drift}");
            assert_eq!((report.condition.armings, report.statistics.implausible), (1, 0));
        }
        Err(refusals) => {
            assert!(!is_tolerable(drift), "drift {drift}: {refusals}");
            let how = if drift < 0.0 { "slow" } else { "fast" };
            let clock = format!("its clock runs {:.1} % too {how}", drift.abs() * 1e2);
            let sentence = refusals.to_string();
            for words in ["board 3 on wire", &clock, "at most 3 % is accepted"] {
                assert!(sentence.contains(words), "no `{words}` in: {sentence}");
            }
        }
    });
}

#[test]
fn a_key_that_is_played_strikes_as_often_at_every_drift() {
    at_every_drift(|drift| {
        let Ok(keybed) = armed(drift, 6) else { return };
        let mut stage = staged(keybed);
        run(&mut stage, 5_000);
        let Heard { strikes, faults, .. } = stage.observer;
        assert_eq!((strikes, faults), (6, 0), "drift {drift}");
        assert_eq!(stage.bus.board_reports()[0].statistics.implausible, 0, "drift {drift}");
    });
}

#[test]
fn a_board_whose_clock_leaves_the_tolerance_in_a_run_is_disarmed_and_renders_nothing() {
    let mut stage = staged(armed(0.0, 6).expect("a good clock"));
    run(&mut stage, TICKS / 2);
    DRIFT.set(0.045);
    run(&mut stage, 2 * TICKS);
    let report = stage.bus.board_reports().remove(0);
    let BoardStage::Barred(ArmLockout::Clock(ppm)) = report.condition.state else {
        panic!("it is used as if nothing was: {report:?}");
    };
    // As soon as it is certain, and before it is known exactly.
    assert!((30_000..46_000).contains(&ppm), "{ppm}");
    assert_eq!(SENT.get(), [0; KEYS_PER_BOARD]);
}

fn refused(wrong: Wrong) -> (String, f64) {
    WRONG.set(wrong);
    let start = NOW.get();
    let sentence = armed(0.0, 0).expect_err("it is refused").to_string();
    (sentence, (NOW.get() - start) as f64 * 1e-6)
}

#[test]
fn a_board_that_cannot_be_armed_is_refused_after_few_attempts_with_what_is_wrong() {
    for (wrong, words) in [
        (Wrong::Flag, "its samples say that it renders no force"),
        (Wrong::KeyLess, "its samples are none of 11 keys"),
        (Wrong::KeyFault, "a key, motor or sensor failed"),
    ] {
        ARMINGS.set(0);
        let (sentence, seconds) = refused(wrong);
        assert!(sentence.contains("board 3 on wire") && sentence.contains(words), "{sentence}");
        assert!(ARMINGS.get() <= 5 && seconds < 4.0, "{} in {seconds} s", ARMINGS.get());
    }
}

#[test]
fn a_board_that_answers_is_not_called_gone_when_time_is_up() {
    // Its clock is known after eight round trips, which are 10 ms apart.
    let sentence = armed_within(60_000, 0.0, 0).expect_err("no time").to_string();
    let words =
        "board 3 on wire answers, and was not ready within 0.1 s; it was asked for Ping last";
    assert!(sentence.starts_with(words), "{sentence}");
}

fn gone_wrong(wrong: Wrong) -> Stage<Keybed<Armed>, Heard> {
    let mut stage = staged(armed(0.0, 20).expect("a good board"));
    run(&mut stage, TICKS / 2);
    ARMINGS.set(0);
    WRONG.set(wrong);
    run(&mut stage, TICKS / 2);
    stage
}

#[test]
fn a_board_that_renders_no_force_in_a_run_is_sent_none_and_armed_a_few_times_only() {
    for (wrong, bar) in [
        (Wrong::Flag, ArmLockout::StaysSafe),
        (Wrong::KeyLess, ArmLockout::Unreadable),
        (Wrong::KeyFault, ArmLockout::Latched(safe_reason::KEY_FAULT)),
    ] {
        WRONG.set(Wrong::Nothing);
        let mut stage = gone_wrong(wrong);
        for _ in 0..TICKS {
            run(&mut stage, 1);
            assert_eq!(SENT.get(), [0; KEYS_PER_BOARD], "{wrong:?}");
        }
        let report = stage.bus.board_reports().remove(0);
        assert_eq!(report.condition.state, BoardStage::Barred(bar), "{wrong:?}");
        assert!(ARMINGS.get() <= 5, "{wrong:?}: {} times", ARMINGS.get());
    }
}

#[test]
fn a_board_that_is_well_again_is_armed_after_a_while() {
    let mut stage = gone_wrong(Wrong::KeyLess);
    WRONG.set(Wrong::Nothing);
    run(&mut stage, 10_500);
    let report = stage.bus.board_reports().remove(0);
    assert_eq!((report.condition.state, report.condition.armings), (BoardStage::Armed, 2));
}

/// Asserts that a key with invalid readings is sent nothing after some `ticks`, and never more than
/// `most` (N); and that its neighbours continue.
#[track_caller]
fn check_muted(wrong: Wrong, reason: KeyFault, ticks: u64, most: f64) {
    WRONG.set(Wrong::Nothing);
    let mut stage = staged(armed(0.0, 0).expect("a good board"));
    run(&mut stage, 500);
    WRONG.set(wrong);
    run(&mut stage, ticks);
    for _ in 0..1_000 {
        run(&mut stage, 1);
        let sent = SENT.get();
        assert!(sent[PLAYED.1] == 0 && 0 < sent[PLAYED.1 + 1], "{wrong:?}: {sent:?}");
    }
    let report = stage.bus.board_reports().remove(0);
    let mut muted = [None; MOST_KEYS];
    muted[PLAYED.1] = Some(reason);
    assert_eq!(report.statistics.keys.muted, muted, "{wrong:?}");
    assert_eq!(report.condition.state, BoardStage::Armed, "{wrong:?}");
    assert_eq!((stage.observer.strikes, stage.observer.faults), (0, 0), "{wrong:?}");
    assert!(stage.observer.force < most, "{wrong:?}: {} N", stage.observer.force);
}

#[test]
fn a_key_that_reads_what_no_key_can_is_muted_and_strikes_nothing() {
    // 30 mm of 10.16, and a third of a millimetre to and fro: a dozen of the latter are used.
    check_muted(Wrong::Elsewhere(30_000), KeyFault::Beyond, 40, NONE);
    check_muted(Wrong::Noise(300), KeyFault::Noisy, 120, 15.0);
}

#[test]
fn one_sample_that_cannot_be_is_as_if_it_had_been_lost() {
    let mut stage = staged(armed(0.0, 0).expect("a good board"));
    run(&mut stage, 500);
    for _ in 0..20 {
        WRONG.set(Wrong::Elsewhere(30_000));
        run(&mut stage, 1);
        WRONG.set(Wrong::Nothing);
        run(&mut stage, 99);
    }
    let report = stage.bus.board_reports().remove(0);
    assert_eq!((stage.observer.strikes, stage.observer.faults), (0, 0));
    assert!(stage.observer.force < NONE, "{} N", stage.observer.force);
    assert_eq!(report.statistics.keys.muted, [None; MOST_KEYS]);
    assert!((15..=40).contains(&report.statistics.implausible), "{report:?}");
}
