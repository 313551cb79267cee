//! Whatever arrives, nothing panics, nothing false is taken for true, and what was sent comes back.

use firmware_protocol::MAX_FRAME;
use firmware_protocol::acyclic::finger::Finger;
use firmware_protocol::acyclic::{
    AcyclicReply, AcyclicRequest, Operation, Status, encode_reply, encode_request,
};
use firmware_protocol::can::{self, pieces};
use firmware_protocol::frame::broadcast::{self, Broadcast};
use firmware_protocol::frame::hello::{self, Introduction};
use firmware_protocol::frame::key_forces::{ForceLayout, ForcePacking, KeyForces, KeySlopes};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout, SamplePacking};
use firmware_protocol::frame::multicast_forces::MulticastForces;
use firmware_protocol::frame::{FrameKind, Header, board_of};
use firmware_protocol::key::{BoardId, MOST_KEYS, PerKey};
use firmware_protocol::quantity::{Counts, Millinewtons, SlopeCode, SpeedCode};
use firmware_protocol::sequence::SequenceNumber;
use firmware_protocol::serial::{self, Deframer, MAX_WIRE};
use firmware_protocol::{Nothing, Record as _};
use proptest::array::uniform4;
use proptest::collection::vec;
use proptest::prelude::*;

/// Bit of the first byte that only some kinds have; a newer minor version may set it elsewhere.
const FLAG: u8 = 0b0001_0000;

fn any_board() -> impl Strategy<Value = BoardId> {
    (0..=BoardId::MAX.number()).prop_map(|board| BoardId::new(board).expect("0 ..= 14"))
}

fn any_header() -> impl Strategy<Value = Header> {
    (any_board(), any::<u8>(), any::<u16>(), any::<bool>()).prop_map(
        |(board, sequence, stamp_us, flag)| Header {
            board,
            sequence: SequenceNumber(sequence),
            stamp_us,
            flag,
        },
    )
}

fn near_frames() -> impl Strategy<Value = Vec<u8>> {
    let anything = vec(any::<u8>(), 0..80);
    let sparse = vec(prop_oneof![4 => Just(0), 1 => any::<u8>()], 0..80);
    let stops = vec(prop_oneof![Just(0x0F), Just(1), Just(0xDE), Just(0xAD), Just(0)], 0..9);
    prop_oneof![anything, sparse, stops]
}

proptest! {
    #[test]
    fn any_bytes_are_cyclic_frames_or_refused(bytes in near_frames(), n_keys in 1..=MOST_KEYS) {
        let mut again = [0xAA; MAX_FRAME];
        for packing in SamplePacking::ALL {
            if let Ok(samples) = KeySamples::decode(&bytes, SampleLayout { packing, n_keys }) {
                let n = samples.encode(packing, &mut again);
                prop_assert_eq!(&again[..bytes.len().max(n)], &bytes);
            }
        }
        for packing in ForcePacking::ALL {
            if let Ok(forces) = KeyForces::decode(&bytes, ForceLayout { packing, n_keys }) {
                let n = forces.encode(&mut again);
                prop_assert_eq!(&again[..bytes.len().max(n)], &bytes);
            }
        }
        if let Ok(multicast) = MulticastForces::decode(&bytes) {
            prop_assert_eq!(&multicast.encode()[..], &bytes);
        }
    }

    #[test]
    fn any_bytes_are_said_to_all_or_refused(bytes in near_frames()) {
        let mut again = [0xAA; broadcast::MAX_LEN];
        if let Ok(broadcast) = Broadcast::decode(&bytes) {
            let n = broadcast.encode(&mut again);
            prop_assert_eq!(&again[1..bytes.len().max(n)], &bytes[1..]);
            prop_assert_eq!(again[0], bytes[0] & !FLAG);
        }
    }

    #[test]
    fn any_bytes_behind_a_magic_are_a_hello_or_refused(
        first in any::<u8>(),
        major in 1..4_u8,
        rest in vec(any::<u8>(), 0..80),
    ) {
        let bytes = [&[first], &hello::MAGIC[..], &[major], &rest].concat();
        let mut again = [0xAA; MAX_FRAME];
        if let Ok(introduction) = Introduction::decode(&bytes) {
            let n = introduction.encode(&mut again);
            prop_assert_eq!(&again[..n], &bytes[..n]);
        }
    }

    #[test]
    fn any_bytes_are_a_request_a_reply_or_refused(bytes in near_frames()) {
        let mut again = [0xAA; MAX_FRAME];
        if let Ok(request) = AcyclicRequest::decode(&bytes) {
            prop_assert_eq!(request.record, &bytes[3..]);
            if let (Ok(operation), Some(finger)) = (request.operation, Finger::take(request.record)) {
                let n = encode_request(request.board, request.id, operation, &finger, &mut again);
                prop_assert_eq!(&again[1..n], &bytes[1..n]);
                prop_assert_eq!(again[0], bytes[0] & !FLAG);
            }
        }
        if let Ok(reply) = AcyclicReply::decode(&bytes) {
            prop_assert_eq!(reply.record, &bytes[4..]);
            let outcome = if bytes[3] == 0 { Ok(Nothing) } else { Err(reply.status) };
            let n = encode_reply(reply.board, reply.id, bytes[2], outcome, &mut again);
            prop_assert_eq!(&again[1..n - 1], &bytes[1..n - 1]);
            prop_assert_eq!(again[n - 1], Status::new(bytes[3]) as u8);
        }
    }

    #[test]
    fn any_bytes_have_an_identifier_if_they_have_a_kind(bytes in near_frames()) {
        prop_assert_eq!(can::identifier(&bytes).is_some(), FrameKind::of(&bytes).is_some());
        prop_assert!(can::identifier(&bytes).is_none_or(|id| id < 1 << 11));
        prop_assert!(board_of(&bytes).is_none_or(|board| board <= BoardId::MAX));
    }

    #[test]
    fn samples_come_back(
        header in any_header(),
        packing in prop::sample::select(&SamplePacking::ALL[..]),
        keys in vec((-0x80_0000..=0x7F_FFFF, any::<i16>()), 1..=12),
    ) {
        let short = matches!(packing, SamplePacking::Position16 | SamplePacking::Position16Velocity);
        let edge = if short { 0x7FFF } else { 0x7F_FFFF };
        let counts = keys.iter().map(|(counts, _)| Counts::saturating(i32::clamp(*counts, -edge, edge)));
        let speeds = keys.iter().map(|(_, speed)| SpeedCode::saturating((*speed).into()));
        let speeds = speeds.take(if packing.has_velocity() { MOST_KEYS } else { 0 });
        let (positions, velocities) = (PerKey::collect(counts), PerKey::collect(speeds));
        let samples = KeySamples { header, positions, velocities };
        let mut bytes = [0xAA; MAX_FRAME];
        let n = samples.encode(packing, &mut bytes);
        let layout = SampleLayout { packing, n_keys: keys.len() };
        prop_assert_eq!(KeySamples::decode(&bytes[..n], layout), Ok(samples));
        prop_assert_eq!(KeySamples::decode(&bytes[..can::padded(n)], layout), Ok(samples));
    }

    #[test]
    fn forces_come_back(
        header in any_header(),
        keys in vec((any::<i16>(), any::<u8>(), any::<u8>()), 1..=12),
        with_slopes in any::<bool>(),
    ) {
        let forces = keys.iter().map(|(force, _, _)| Millinewtons::saturating((*force).into()));
        let slopes = keys.iter().map(|(_, k, b)| KeySlopes {
            stiffness: SlopeCode::from_code(*k),
            damping: SlopeCode::from_code(*b),
        });
        let slopes = slopes.take(if with_slopes { MOST_KEYS } else { 0 });
        let (forces, slopes) = (PerKey::collect(forces), PerKey::collect(slopes));
        let forces = KeyForces { header, forces, slopes };
        let mut bytes = [0xAA; MAX_FRAME];
        let n = forces.encode(&mut bytes);
        let layout = ForceLayout { packing: forces.packing(), n_keys: keys.len() };
        prop_assert_eq!(KeyForces::decode(&bytes[..n], layout), Ok(forces));
    }

    #[test]
    fn a_request_comes_back(
        board in any_board(),
        id in any::<u8>(),
        slot in any::<u8>(),
        times in uniform4(any::<u32>()),
        depth_and_lift in any::<(u32, u32)>(),
    ) {
        let [start_us, release_us, speed, hold] = times;
        let (from, lift) = depth_and_lift;
        let finger = Finger { slot, touch: 1, start_us, release_us, speed, hold, from, lift };
        let mut bytes = [0xAA; MAX_FRAME];
        let n = encode_request(board, id, Operation::Finger, &finger, &mut bytes);
        let request = AcyclicRequest::decode(&bytes[..can::padded(n)]).expect("a request");
        prop_assert_eq!((request.board, request.id), (board, id));
        prop_assert_eq!(Finger::take(request.record), Some(finger));
    }

    #[test]
    fn after_any_noise_and_one_zero_the_next_frame_is_read(
        noise in vec(any::<u8>(), 0..300),
        frame in vec(any::<u8>(), 0..=MAX_FRAME),
    ) {
        let mut deframer = Deframer::default();
        for byte in noise.into_iter().chain([0]) {
            let _refused_or_not = deframer.push(byte);
        }
        prop_assert_eq!(read(&mut deframer, &wire(&frame)), vec![Ok(frame)]);
    }

    #[test]
    fn after_any_pieces_a_whole_frame_is_read(
        noise in vec(vec(any::<u8>(), 0..=8), 0..40),
        frame in vec(any::<u8>(), 8..=MAX_FRAME),
        roll in 0..8_u8,
    ) {
        let mut assembler = pieces::Reassembler::default();
        for piece in noise {
            let _lost_or_not = assembler.push(&piece);
        }
        let mut whole = Vec::new();
        for (piece, len) in pieces::cut(&frame, roll) {
            // The first piece may report that it interrupts the frame that the noise began.
            whole.extend(assembler.push(&piece[..len]).unwrap_or_default().map(<[u8]>::to_vec));
        }
        prop_assert_eq!(whole, vec![frame]);
    }
}

#[test]
fn each_flipped_bit_costs_at_most_its_frame_and_the_next() {
    let frame = golden();
    let good = wire(&frame);
    for bit in 0..good.len() * 8 {
        let mut bad = good.clone();
        bad[bit / 8] ^= 1 << (bit % 8);
        let mut deframer = Deframer::default();
        let mut frames = read(&mut deframer, &bad);
        frames.extend(read(&mut deframer, &good));
        assert!(frames.contains(&Err(())), "bit {bit} went unnoticed");
        // The flip may have hit the closing zero, and with it the next frame.
        let accepted: Vec<_> = frames.into_iter().flatten().collect();
        assert!(accepted.len() <= 1, "bit {bit}: the damaged frame was accepted");
        assert!(accepted.iter().all(|accepted| *accepted == frame), "bit {bit}: a false frame");
        assert_eq!(read(&mut deframer, &good), [Ok(frame.clone())], "bit {bit}: out of step");
    }
}

/// Returns a frame of eleven keys with zeros in it, so that flips hit the stuffing as well.
fn golden() -> Vec<u8> {
    let board = BoardId::new(5).expect("a board");
    let header = Header { board, sequence: SequenceNumber(77), stamp_us: 40_000, flag: false };
    let positions = PerKey::collect((0..11).map(|key| Counts::saturating(key * 997)));
    let samples = KeySamples { header, positions, velocities: PerKey::default() };
    let mut bytes = [0; MAX_FRAME];
    let n = samples.encode(SamplePacking::Position24, &mut bytes);
    bytes[..n].to_vec()
}

fn wire(frame: &[u8]) -> Vec<u8> {
    let mut wire = [0; MAX_WIRE];
    let n = serial::encode(frame, &mut wire).expect("a frame that links carry");
    wire[..n].to_vec()
}

fn read(deframer: &mut Deframer, bytes: &[u8]) -> Vec<Result<Vec<u8>, ()>> {
    let mut frames = Vec::new();
    for byte in bytes {
        if let Some(outcome) = deframer.push(*byte) {
            frames.push(outcome.map(<[u8]>::to_vec).map_err(|_why| ()));
        }
    }
    frames
}
