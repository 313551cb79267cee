//! Whatever arrives, nothing panics, nothing false is taken for true, and what was sent
//! comes back.
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]
#![expect(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "tests run on the host"
)]

use firmware_protocol::frame::Header;
use firmware_protocol::frame::key_forces::{self, KeyForces};
use firmware_protocol::frame::key_samples::{self, KeySamples};
use firmware_protocol::key::{BoardId, PerKey};
use firmware_protocol::quantity::{Counts, Millinewtons};
use firmware_protocol::sequence::Sequence;
use firmware_protocol::serial::{self, Deframer, MAX_FRAME, MAX_WIRE};
use proptest::collection::vec;
use proptest::prelude::*;

fn any_header() -> impl Strategy<Value = Header> {
    (0..8_u8, any::<u8>(), any::<u16>(), any::<bool>()).prop_map(
        |(board, sequence, stamp_us, fault)| {
            let board = BoardId::new(board).expect("0 ..= 7");
            Header { board, sequence: Sequence(sequence), stamp_us, fault }
        },
    )
}

proptest! {
    #[test]
    fn any_bytes_decode_or_are_refused(bytes in vec(any::<u8>(), 0..80)) {
        // What is accepted means the same when it is sent on.
        if let Ok(samples) = KeySamples::decode(&bytes) {
            let mut again = [0; key_samples::MAX_LEN];
            let n = samples.encode(&mut again);
            prop_assert_eq!(&again[..n], &bytes[..n]);
        }
        if let Ok(forces) = KeyForces::decode(&bytes) {
            let mut again = [0; key_forces::MAX_LEN];
            let n = forces.encode(&mut again);
            prop_assert_eq!(&again[..n], &bytes[..n]);
        }
    }

    #[test]
    fn samples_come_back(header in any_header(), counts in vec(-0x80_0000..=0x7F_FFFF, 1..=11)) {
        let positions = PerKey::collect(counts.into_iter().map(Counts::saturating));
        let samples = KeySamples { header, positions };
        let mut bytes = [0; key_samples::MAX_LEN];
        let n = samples.encode(&mut bytes);
        prop_assert_eq!(KeySamples::decode(&bytes[..n]), Ok(samples));
    }

    #[test]
    fn forces_come_back(header in any_header(), forces in vec(-32_768..=32_767, 1..=11)) {
        let forces = PerKey::collect(forces.into_iter().map(Millinewtons::saturating));
        let forces = KeyForces { header, forces };
        let mut bytes = [0; key_forces::MAX_LEN];
        let n = forces.encode(&mut bytes);
        prop_assert_eq!(KeyForces::decode(&bytes[..n]), Ok(forces));
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
        // The flip may have taken the closing zero, and with it the frame behind.
        let accepted: Vec<_> = frames.into_iter().flatten().collect();
        assert!(accepted.len() <= 1, "bit {bit}: the damaged frame was accepted");
        assert!(accepted.iter().all(|accepted| *accepted == frame), "bit {bit}: a false frame");
        assert_eq!(read(&mut deframer, &good), [Ok(frame.clone())], "bit {bit}: out of step");
    }
}

/// A frame of eleven keys with zeros in it, so that flips meet the stuffing as well.
fn golden() -> Vec<u8> {
    let board = BoardId::new(5).expect("a board");
    let header = Header { board, sequence: Sequence(77), stamp_us: 40_000, fault: false };
    let counts = (0..11).map(|key| Counts::saturating(key * 997));
    let samples = KeySamples { header, positions: PerKey::collect(counts) };
    let mut bytes = [0; key_samples::MAX_LEN];
    let n = samples.encode(&mut bytes);
    bytes[..n].to_vec()
}

fn wire(frame: &[u8]) -> Vec<u8> {
    let mut wire = [0; MAX_WIRE];
    let n = serial::encode(frame, &mut wire).expect("a frame that links carry");
    wire[..n].to_vec()
}

/// Everything that comes out for `bytes`.
fn read(deframer: &mut Deframer, bytes: &[u8]) -> Vec<Result<Vec<u8>, ()>> {
    let mut frames = Vec::new();
    for byte in bytes {
        if let Some(outcome) = deframer.push(*byte) {
            frames.push(outcome.map(<[u8]>::to_vec).map_err(|_why| ()));
        }
    }
    frames
}
