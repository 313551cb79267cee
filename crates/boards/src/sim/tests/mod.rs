//! One simulated board on a wire in memory.

use crate::links::{Link as _, loopback::Loopback};
use firmware_protocol::acyclic::arm::{Arm, Disarmed};
use firmware_protocol::acyclic::{AcyclicReply, Operation, Status, encode_request};
use firmware_protocol::frame::broadcast::{self, Broadcast};
use firmware_protocol::frame::hello::{Hello, safe_reason};
use firmware_protocol::frame::key_forces::{self, ForcePacking, KeyForces};
use firmware_protocol::frame::multicast_forces::{GROUP, MulticastForces};
use firmware_protocol::frame::{FrameKind, key_samples::KeySamples};
use firmware_protocol::key::{BoardId, PerKey};
use firmware_protocol::quantity::Millinewtons;
use firmware_protocol::sequence::SequenceNumber;
use firmware_protocol::{MAX_FRAME, Nothing, Record};
use haptics::plant::RigParameters;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus as _;

use super::board::{BoardMake, SimulatedBoard};
use super::keybed::SimulatedKeybed;

const TICK_US: u64 = 1_000;
/// Force that holds keys on their felts (mN).
const DOWN: i32 = -2_000;

struct Bench {
    board: SimulatedBoard,
    wire: Loopback,
    tick: u64,
    next_id: u8,
    replies: Vec<Vec<u8>>,
    newest: Option<KeySamples>,
    sequences: [SequenceNumber; 3],
}

impl Bench {
    fn new(number: u8) -> Self {
        let id = BoardId::new(number).unwrap();
        let make = BoardMake::standard(id, TICK_US as f64 * 1e-6, RigParameters::default());
        let board = SimulatedBoard::new(make).unwrap().armed();
        let (wire, replies) = (Loopback::new(512), Vec::new());
        let (newest, sequences) = (None, [SequenceNumber::default(); 3]);
        let mut bench = Self { board, wire, tick: 0, next_id: 0, replies, newest, sequences };
        bench.live(1);
        bench
    }

    fn tell(&mut self, frame: &[u8]) {
        self.wire.host_end().try_send(frame).unwrap();
    }

    fn live(&mut self, ticks: u64) {
        self.tick += ticks;
        self.board.advance(self.tick, &mut self.wire.board_end());
        let mut bytes = [0; MAX_FRAME];
        while let Ok(Some(len)) = self.wire.host_end().try_recv(&mut bytes) {
            match FrameKind::of(&bytes[..len]) {
                Some(FrameKind::KeySamples) => {
                    self.newest = KeySamples::decode(&bytes[..len], self.board.samples).ok();
                }
                _ => self.replies.push(bytes[..len].to_vec()),
            }
        }
    }

    fn broadcast(&mut self, said: Broadcast) {
        let mut bytes = [0; broadcast::MAX_LEN];
        let len = said.encode(&mut bytes);
        self.tell(&bytes[..len]);
    }

    fn stop(&mut self) {
        self.broadcast(Broadcast::EmergencyStop { reason: 1 });
    }

    fn request<R: Record>(&mut self, operation: Operation, record: &R) {
        self.next_id += 1;
        let mut bytes = [0; MAX_FRAME];
        let board = self.board.make().id;
        let len = encode_request(board, self.next_id, operation, record, &mut bytes);
        self.tell(&bytes[..len]);
    }

    fn ask<R: Record, A: Record>(&mut self, operation: Operation, record: &R) -> Result<A, Status> {
        self.request(operation, record);
        self.live(1);
        let frame = self.replies.pop().unwrap();
        let reply = AcyclicReply::decode(&frame).unwrap();
        if reply.status == Status::Done {
            Ok(A::take(reply.record).unwrap())
        } else {
            Err(reply.status)
        }
    }

    fn arm(&mut self, packing: ForcePacking) -> Result<Nothing, Status> {
        let Disarmed { nonce } = self.ask(Operation::Disarm, &Nothing)?;
        self.ask(Operation::Arm, &Arm { nonce, packing: packing as u8, valid_ms: 20 })
    }

    fn reason(&mut self) -> u8 {
        self.ask::<_, Hello>(Operation::Hello, &Nothing).unwrap().safe_reason
    }

    fn answer(&mut self) {
        let header = self.newest.unwrap().header;
        let forces = PerKey::collect([Millinewtons::saturating(DOWN); 11]);
        let mut bytes = [0; key_forces::MAX_LEN];
        let frame = KeyForces { header, forces, slopes: PerKey::default() };
        let len = frame.encode(&mut bytes);
        self.tell(&bytes[..len]);
    }

    fn hold(&mut self) {
        for _ in 0..100 {
            self.answer();
            self.live(1);
        }
        assert!(1.9 < self.force(0), "{} N", self.force(0));
    }

    /// Time on the host's clock, which started long before (us).
    fn host_us(&self) -> u32 {
        u32::try_from(self.tick * TICK_US + 7_000_123).unwrap()
    }

    fn multicast(&mut self, group: u8) {
        let [low, high, ..] = self.host_us().to_le_bytes();
        let sequence = &mut self.sequences[usize::from(group)];
        *sequence = sequence.next();
        let frame = MulticastForces {
            group,
            sequence: *sequence,
            stamp_us: u16::from_le_bytes([low, high]),
            flag: false,
            forces: [Millinewtons::saturating(DOWN); GROUP],
        };
        self.tell(&frame.encode());
    }

    fn live_with(&mut self, ticks: u64, groups: &[u8]) {
        for _ in 0..ticks {
            let host_us = self.host_us();
            self.broadcast(Broadcast::BusTime { host_us });
            for group in groups {
                self.multicast(*group);
            }
            self.live(1);
        }
    }

    fn force(&self, slot: usize) -> f64 {
        self.board.rig(slot).unwrap().motor_force().abs()
    }
}

#[test]
fn no_request_arms_a_board_that_was_stopped() {
    let mut bench = Bench::new(0);
    bench.hold();
    bench.live(60);
    assert_eq!(bench.reason(), safe_reason::SILENCE);
    bench.stop();
    bench.live(1);
    assert_eq!(bench.arm(ForcePacking::Force16), Err(Status::WrongState));
    assert_eq!(bench.reason(), safe_reason::EMERGENCY_STOP);
    bench.board.fail(safe_reason::KEY_FAULT);
    assert_eq!(bench.reason(), safe_reason::EMERGENCY_STOP);
    assert!(bench.newest.unwrap().header.flag && bench.board.introduction().safe);
}

#[test]
fn what_is_heard_after_a_freeze_holds_from_its_beginning() {
    let takes_away: [fn(&mut Bench); 2] =
        [Bench::stop, |bench| bench.request(Operation::Disarm, &Nothing)];
    for take_away in takes_away {
        let mut bench = Bench::new(0);
        bench.hold();
        take_away(&mut bench);
        // Fading and the motor's lag end before the forces would have expired.
        bench.live(18);
        assert!(bench.force(0) < 1e-6, "{} N", bench.force(0));
    }
}

#[test]
fn forces_for_all_boards_are_no_younger_for_a_freeze() {
    let mut bench = Bench::new(0);
    bench.arm(ForcePacking::Multicast16).unwrap();
    bench.live_with(100, &[0]);
    assert!(1.9 < bench.force(0));
    // Forces that arrive at the end of a freeze last 20 ms, as if they came at its beginning.
    bench.tick += 59;
    bench.live_with(1, &[0]);
    assert!(bench.board.is_safe() && bench.force(0) < 1e-6, "{} N", bench.force(0));
}

#[test]
fn a_group_that_is_lost_is_not_kept_alive_by_another() {
    let mut bench = Bench::new(2);
    bench.arm(ForcePacking::Multicast16).unwrap();
    // Keys 22 to 29 are in the first group, 30 to 32 in the second.
    bench.live_with(50, &[1]);
    assert!(!bench.board.is_safe() && bench.force(10) <= 0.0, "half a board renders nothing");
    bench.live_with(100, &[0, 1]);
    assert!(1.9 < bench.force(0) && 1.9 < bench.force(10));
    bench.live_with(19, &[1]);
    assert!(!bench.board.is_safe() && 1.9 < bench.force(0));
    bench.live_with(40, &[1]);
    assert_eq!(bench.board.safe_reason(), safe_reason::SILENCE);
    assert!(bench.force(0) < 1e-6 && bench.force(10) < 1e-6, "{} N", bench.force(0));
    bench.arm(ForcePacking::Multicast16).unwrap();
    bench.live_with(50, &[0]);
    assert!(!bench.board.is_safe() && bench.force(0) < 1e-6);
}

#[test]
fn the_flag_says_that_no_forces_are_rendered_for_whatever_reason() {
    let mut bench = Bench::new(0);
    let mut flag = |said: fn(&mut Bench)| {
        said(&mut bench);
        bench.live(2);
        bench.newest.unwrap().header.flag
    };
    assert!(!flag(|_| ()), "armed");
    assert!(flag(|bench| bench.request(Operation::Disarm, &Nothing)), "disarmed");
    assert!(!flag(|bench| _ = bench.arm(ForcePacking::Force16).unwrap()), "armed again");
    assert!(flag(Bench::stop), "stopped");
}

#[test]
fn boards_that_a_stall_of_the_host_made_safe_are_armed_again() {
    let mut keybed = SimulatedKeybed::new(1e-3, RigParameters::default()).expect("a keybed");
    keybed.keep_armed();
    let mut samples = [KeySample::default(); KEYS];
    for tick in (0..10).chain(100..110) {
        keybed.receive(tick, &mut samples);
        keybed.send(tick, &[0.5; KEYS], &[KeySlope::HELD; KEYS]);
    }
    assert_eq!(keybed.rearmed(), 1, "90 ms of silence trip every watchdog once");
    assert!(BoardId::all().all(|board| !keybed.is_safe(board)));
}
