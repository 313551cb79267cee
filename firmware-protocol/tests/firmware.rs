//! The reference firmware against the protocol: on an emulated Cortex-M3, over a real link.
#![cfg(unix)]
#![expect(clippy::expect_used, clippy::panic, reason = "helpers of tests, outside #[test]")]
#![expect(clippy::disallowed_macros, clippy::disallowed_methods, reason = "tests run on the host")]

#[path = "support/firmware.rs"]
mod firmware;
#[expect(dead_code, reason = "other tests use the rest")]
#[path = "support/random.rs"]
mod random;
#[path = "support/tools.rs"]
mod tools;

use std::time::{Duration, Instant};

use firmware::{BOARD, Board, KEYS, SLOW, position, wire};
use firmware_protocol::acyclic::arm::Disarmed;
use firmware_protocol::acyclic::finger::{FORGET, Finger};
use firmware_protocol::acyclic::log::{LogLine, ReadLog};
use firmware_protocol::acyclic::ping::Pong;
use firmware_protocol::acyclic::{Operation, Status, encode_request};
use firmware_protocol::frame::broadcast::Broadcast;
use firmware_protocol::frame::hello::{feature, safe_reason};
use firmware_protocol::frame::key_forces::{ForcePacking, KeySlopes};
use firmware_protocol::frame::key_samples::KeySamples;
use firmware_protocol::frame::multicast_forces::{GROUP, MulticastForces};
use firmware_protocol::key::PerKey;
use firmware_protocol::quantity::{Millinewtons, SlopeCode};
use firmware_protocol::sequence::SequenceNumber;
use firmware_protocol::{MAX_FRAME, Nothing, Record as _, schema};
use random::Random;

/// Rest positions of the key on its felt (um): 10.16 mm without force, 28 um deeper with 2 N.
const BOTTOM: i32 = 10_160;
const PRESSED: i32 = BOTTOM + 28;

#[test]
fn a_board_says_who_it_is_and_answers_a_request_once() {
    let Some(mut board) = Board::start("hello") else { return };
    let hello = board.introduction().hello;
    assert_eq!((hello.schema, hello.first_key, hello.n_keys), (schema::HASH, 11 * BOARD, 11));
    assert_eq!(hello.safe_reason, safe_reason::NEVER_ARMED);
    assert_ne!(hello.features & feature::FINGERS, 0);
    // The same number is the same request, without a new nonce.
    let nonce = |board: &mut Board, id| {
        let (_done, record) = board.ask_with_id(id, Operation::Disarm, &Nothing);
        Disarmed::take(&record).unwrap().nonce
    };
    let first = nonce(&mut board, 200);
    assert_eq!(nonce(&mut board, 200), first);
    assert_ne!(nonce(&mut board, 201), first);
    check_unknown(&mut board);
    let line: LogLine = board.get(Operation::ReadLog, &ReadLog { line: 0 });
    assert!(line.text.starts_with(b"started\0"));
    assert_eq!(board.ask(Operation::ReadLog, &ReadLog { line: 999 }).0, Status::BadValue);
}

#[track_caller]
fn check_unknown(board: &mut Board) {
    let mut bytes = [0; MAX_FRAME];
    let len = encode_request(Board::id(), 77, Operation::Ping, &Nothing, &mut bytes);
    bytes[2] = 99;
    board.send(&bytes[..len]);
    assert_eq!(board.raw_reply(), [0xA0 | BOARD, 77, 99, Status::Unknown as u8]);
}

#[test]
fn forces_need_an_arming_with_the_nonce_that_was_given_last() {
    let Some(mut board) = Board::start_slow("arm") else { return };
    board.stream(4_000);
    assert_eq!(board.arm_with(0, ForcePacking::Force16, 20), Status::WrongState);
    let refused = board.counters().refused;
    let last = board.hold(20, -2_000);
    assert!(20 <= board.counters().refused - refused, "an unarmed board counts forces as refused");
    assert_eq!(position(&last), 0);
    let nonce = board.disarm();
    assert_eq!(board.arm_with(nonce ^ 1, ForcePacking::Force16, 20), Status::WrongNonce);
    assert_eq!(board.arm_with(nonce, ForcePacking::Force16, 4), Status::BadValue);
    assert_eq!(board.arm_with(nonce, ForcePacking::Force16, 100), Status::Done);
    assert_eq!(board.arm_with(nonce, ForcePacking::Force16, 100), Status::WrongState);
    let newer = board.disarm();
    assert_ne!(newer, nonce);
    assert_eq!(board.arm_with(nonce, ForcePacking::Force16, 100), Status::WrongNonce);
    assert_eq!(board.arm_with(newer, ForcePacking::Force16, 100), Status::Done);
    assert_eq!(board.counters().armings, 2);
}

#[test]
fn forces_move_the_key_and_their_silence_lets_it_go_for_good() {
    let Some(mut board) = Board::start_slow("force") else { return };
    board.stream(4_000);
    board.arm(ForcePacking::Force16);
    let pressed = board.hold(100, -2_000);
    assert!((position(&pressed) - PRESSED).abs() < 5, "2 N press the felt: {pressed:?}");
    assert!(!pressed.header.flag);
    check_silence(&mut board, &pressed);
    // Latched: answers have no effect.
    let last = board.hold(50, 2_000);
    assert!(position(&last).abs() < 5 && last.header.flag, "{last:?}");
    let introduction = board.introduction();
    assert_eq!((introduction.safe, introduction.hello.safe_reason), (true, safe_reason::SILENCE));
    assert_eq!(board.counters().trips, 1);
    // Disarming and arming releases it.
    board.skip();
    board.arm(ForcePacking::Force16);
    let up = board.hold(100, 2_000);
    assert!((position(&up) + 33).abs() < 5 && !up.header.flag, "{up:?}");
}

/// Stops answering, and asserts that the force lasts until it expires and ends soon after.
#[track_caller]
fn check_silence(board: &mut Board, answered: &KeySamples) {
    board.answer(answered, -2_000);
    let since = |samples: &KeySamples| {
        u32::from(samples.header.stamp_us.wrapping_sub(answered.header.stamp_us))
    };
    let mut age = 0;
    while age < 60_000 {
        let samples = board.samples();
        age = since(&samples);
        assert!(98_000 <= age || (position(&samples) - PRESSED).abs() < 5, "gone at {age} us");
    }
    // Time on the wire has 16 bits: another 100 ms exceed 65 ms, so count frames.
    let frames = (0..15).map(|_| board.samples()).collect::<Vec<_>>();
    let (still, gone) = (&frames[7], &frames[14]);
    assert!((position(still) - PRESSED).abs() < 5, "gone early: {still:?}");
    assert!(position(gone) < BOTTOM, "still there after 115 ms: {gone:?}");
    assert!(gone.header.flag);
}

#[test]
fn an_emergency_stop_takes_every_force_away() {
    let Some(mut board) = Board::start_slow("stop") else { return };
    board.stream(4_000);
    board.arm(ForcePacking::Force16);
    let pressed = board.hold(100, -2_000);
    assert!((position(&pressed) - PRESSED).abs() < 5);
    board.answer(&pressed, -2_000);
    board.broadcast(Broadcast::EmergencyStop { reason: 1 });
    let last = board.hold(50, -2_000);
    assert!(position(&last).abs() < 5 && last.header.flag, "{last:?}");
    assert_eq!(board.introduction().hello.safe_reason, safe_reason::EMERGENCY_STOP);
    assert_eq!(board.counters().trips, 0);
    assert_eq!(board.ask(Operation::Disarm, &Nothing).0, Status::WrongState);
    assert_eq!(board.introduction().hello.safe_reason, safe_reason::EMERGENCY_STOP);
}

#[test]
fn a_stale_answer_is_counted_and_never_rendered() {
    let Some(mut board) = Board::start_slow("stale") else { return };
    board.stream(4_000);
    board.arm(ForcePacking::Force16);
    let before = board.counters();
    board.skip();
    let mut old = board.samples();
    for _ in 0..50 {
        let new = board.newest_samples();
        board.answer(&new, 0);
        // An old number; a time of another number; an unknown number.
        let mut false_time = new;
        false_time.header.stamp_us = new.header.stamp_us.wrapping_add(1);
        let mut false_number = new;
        false_number.header.sequence = SequenceNumber(new.header.sequence.0.wrapping_add(100));
        for stale in [old, false_time, false_number] {
            board.answer(&stale, -20_000);
        }
        assert_eq!(position(&new), 0);
        old = new;
    }
    let after = board.counters();
    assert_eq!(after.stale - before.stale, 150);
    assert_eq!(after.forces - before.forces, 50);
    assert_eq!(after.trips, 0);
}

#[test]
fn a_spring_between_frames_holds_the_key_in_the_middle() {
    let Some(mut board) = Board::start_slow("spring") else { return };
    board.stream(4_000);
    board.arm(ForcePacking::Force16Slope);
    let mut last = board.samples();
    for _ in 0..200 {
        // Up when it is below 5 mm: 500 N/m and 4 N s/m, so K = −∂F/∂s and B are negative; and
        // down with the 0.3 N of the return spring.
        let force = |(um, speed): (i32, i32)| (um - 5_000) / 2 + speed * 8 / 10 - 300;
        let positions = last.positions.as_slice().iter().map(|counts| counts.get());
        let speeds = last.velocities.as_slice().iter().map(|speed| speed.get().into());
        let forces = positions.zip(speeds).map(force).map(Millinewtons::saturating);
        let slopes = KeySlopes {
            stiffness: SlopeCode::toward_zero(-2_000),
            damping: SlopeCode::toward_zero(-4_000),
        };
        board.answer_with(&last, PerKey::collect(forces), PerKey::collect([slopes; KEYS]));
        last = board.newest_samples();
    }
    assert!((position(&last) - 5_000).abs() < 400, "{last:?}");
    assert_eq!(last.velocities.as_slice()[0].get(), 0);
}

#[test]
fn forces_for_all_boards_need_the_time_of_the_bus() {
    let Some(mut board) = Board::start_slow("all") else { return };
    board.stream(4_000);
    board.arm(ForcePacking::Multicast16);
    let start = Instant::now();
    // A bus clock as slow as its board's, shortly before it wraps.
    let bus_us = || {
        let passed = u32::try_from(start.elapsed().as_micros()).unwrap() / SLOW;
        passed.wrapping_add(u32::MAX - 50_000)
    };
    let before = board.counters();
    send_groups(&mut board, 0, bus_us());
    assert_eq!(board.counters().stale - before.stale, 2, "nobody has said what time it is");
    board.arm(ForcePacking::Multicast16);
    for sequence in 0..80 {
        board.broadcast(Broadcast::BusTime { host_us: bus_us() });
        send_groups(&mut board, sequence, bus_us());
        let _paced = board.newest_samples();
    }
    let last = board.samples();
    // Board 2 has the keys 22 to 32: eight of the first group, three of the second.
    for (slot, counts) in last.positions.as_slice().iter().enumerate() {
        let expected = if slot < 8 { PRESSED } else { -33 };
        assert!((counts.get() - expected).abs() < 5, "slot {slot}: {last:?}");
    }
}

fn send_groups(board: &mut Board, sequence: u8, bus_us: u32) {
    for (group, force) in [(0, -2_000), (1, 2_000)] {
        let [low, high, ..] = bus_us.to_le_bytes();
        let forces = MulticastForces {
            group,
            sequence: SequenceNumber(sequence),
            stamp_us: u16::from_le_bytes([low, high]),
            flag: false,
            forces: [Millinewtons::saturating(force); GROUP],
        };
        board.send(&forces.encode());
    }
}

#[test]
fn noise_is_counted_and_the_next_frame_is_read() {
    let Some(mut board) = Board::start("noise") else { return };
    let mut random = Random::new(5);
    let before = board.counters();
    let mut bytes = [0; MAX_FRAME];
    let len = encode_request(Board::id(), 0, Operation::Light, &Nothing, &mut bytes);
    let good = wire(&bytes[..len]);
    for _ in 0..40 {
        // A flipped bit in a byte that neither is nor becomes zero; then noise, and a zero.
        let mut bad = good.clone();
        bad[1] ^= 2;
        board.send_raw(&bad);
        let noise: Vec<u8> = (0..random.below(90)).map(|_| random.byte() | 1).collect();
        board.send_raw(&noise);
        board.send_raw(&[1, 0]);
        let _in_step: Pong = board.get(Operation::Ping, &Nothing);
    }
    let after = board.counters();
    assert_eq!(after.corrupt - before.corrupt, 80);
    assert_eq!(after.refused, before.refused, "nothing false was taken for a frame");
}

#[test]
fn a_finger_presses_its_key_and_lets_it_go() {
    let Some(mut board) = Board::start_slow("finger") else { return };
    board.stream(4_000);
    let now = board.get::<_, Pong>(Operation::Ping, &Nothing).board_us;
    let (start_us, release_us) = (now.wrapping_add(500_000), now.wrapping_add(900_000));
    let (speed, hold) = (500_000, 15_160);
    let struck =
        Finger { slot: 0, touch: 1, start_us, release_us, speed, hold, from: 0, lift: 50_000 };
    board.get::<_, Nothing>(Operation::Finger, &struck);
    let forgotten = Finger { slot: 1, ..struck };
    board.get::<_, Nothing>(Operation::Finger, &forgotten);
    board.get::<_, Nothing>(Operation::Finger, &Finger { touch: FORGET, ..forgotten });
    assert_eq!(board.ask(Operation::Finger, &Finger { slot: 11, ..struck }).0, Status::BadValue);
    board.skip();
    board.arm(ForcePacking::Force16);
    // 0.5 N up bring the key back.
    let (mut deepest, mut other, mut fastest) = (0, 0, 0);
    let mut last = board.samples();
    let end = Instant::now() + Duration::from_mins(1);
    while Instant::now() < end && (deepest < BOTTOM || 20 <= position(&last)) {
        board.answer(&last, 500);
        last = board.samples();
        deepest = deepest.max(position(&last));
        other = other.max(last.positions.as_slice()[1].get());
        fastest = fastest.max(last.velocities.as_slice()[0].get());
        if last.header.flag {
            // The busy machine made the host silent.
            board.arm(ForcePacking::Force16);
        }
    }
    assert!((BOTTOM + 10..BOTTOM + 500).contains(&deepest), "{deepest} um");
    // In units of 0.2 mm/s: the key is struck at about half a metre per second.
    assert!((1_000..8_000).contains(&fastest), "{fastest}");
    assert!(position(&last) < 20 && other < 20, "{last:?}");
}

#[test]
fn no_more_gestures_are_taken_than_there_is_room_for() {
    let Some(mut board) = Board::start("queue") else { return };
    let now = board.get::<_, Pong>(Operation::Ping, &Nothing).board_us;
    let far = now.wrapping_add(60_000_000);
    let gesture = |i: u32| Finger {
        slot: 0,
        touch: 0,
        start_us: far.wrapping_sub(i * 1_000),
        release_us: far,
        speed: 1,
        hold: 1,
        from: 0,
        lift: 0,
    };
    let taken =
        (0..100).take_while(|i| board.ask(Operation::Finger, &gesture(*i)).0 == Status::Done);
    assert!(24 <= taken.count());
    board.get::<_, Nothing>(Operation::Finger, &Finger { touch: FORGET, ..gesture(0) });
    assert_eq!(board.ask(Operation::Finger, &gesture(0)).0, Status::Done);
}
