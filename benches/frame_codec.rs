//! Cost of the wire format for a full keyboard in one tick. The host decodes eight boards' samples
//! from their byte streams and encodes eight frames of forces; the boards do the opposite. Eleven
//! keys a board.
#![expect(clippy::expect_used, reason = "a bench may stop here")]

#[path = "setting/mod.rs"]
mod setting;

use std::hint::black_box;

use firmware_protocol::frame::DecodeError;
use firmware_protocol::frame::Header;
use firmware_protocol::frame::key_forces::{self, ForceLayout, ForcePacking, KeyForces};
use firmware_protocol::frame::key_samples::{self, KeySamples, SampleLayout, SamplePacking};
use firmware_protocol::key::{BOARDS, BoardId, PerKey};
use firmware_protocol::quantity::{Counts, Millinewtons};
use firmware_protocol::sequence::SequenceNumber;
use firmware_protocol::serial::{self, Deframer, MAX_WIRE};

const PACKING: SamplePacking = SamplePacking::Position24;

type Wire = ([u8; MAX_WIRE], usize);

fn main() {
    let mut criterion = setting::criterion();
    let (samples, forces) = (all(samples), all(forces));
    let sent_samples = samples.each_ref().map(encoded_samples);
    let sent_forces = forces.each_ref().map(encoded_forces);
    let mut deframer = Deframer::default();
    assert_eq!(decoded(&mut deframer, &sent_samples[3], read_samples), samples[3]);
    assert_eq!(decoded(&mut deframer, &sent_forces[3], read_forces), forces[3]);

    criterion.bench_function("frame_codec/host", |bencher| {
        bencher.iter(|| {
            for wire in black_box(&sent_samples) {
                black_box(decoded(&mut deframer, wire, read_samples));
            }
            black_box(black_box(&forces).each_ref().map(encoded_forces))
        });
    });
    criterion.bench_function("frame_codec/boards", |bencher| {
        bencher.iter(|| {
            for wire in black_box(&sent_forces) {
                black_box(decoded(&mut deframer, wire, read_forces));
            }
            black_box(black_box(&samples).each_ref().map(encoded_samples))
        });
    });
    criterion.final_summary();
}

fn all<T>(frame: impl Fn(BoardId) -> T) -> [T; BOARDS] {
    let boards: Vec<_> = BoardId::all().collect();
    std::array::from_fn(|index| frame(boards[index]))
}

fn header(board: BoardId) -> Header {
    Header { board, sequence: SequenceNumber(9), stamp_us: 12_345, flag: false }
}

fn samples(board: BoardId) -> KeySamples {
    let counts = (0..11).map(|slot| Counts::saturating(900 * slot));
    let positions = PerKey::collect(counts);
    KeySamples { header: header(board), positions, velocities: PerKey::default() }
}

fn forces(board: BoardId) -> KeyForces {
    let forces = (0..11).map(|slot| Millinewtons::saturating(300 * slot));
    let forces = PerKey::collect(forces);
    KeyForces { header: header(board), forces, slopes: PerKey::default() }
}

fn read_samples(bytes: &[u8]) -> Result<KeySamples, DecodeError> {
    const LAYOUT: SampleLayout = SampleLayout { packing: PACKING, n_keys: 11 };
    KeySamples::decode(bytes, LAYOUT)
}

fn read_forces(bytes: &[u8]) -> Result<KeyForces, DecodeError> {
    const LAYOUT: ForceLayout = ForceLayout { packing: ForcePacking::Force16, n_keys: 11 };
    KeyForces::decode(bytes, LAYOUT)
}

fn encoded_samples(frame: &KeySamples) -> Wire {
    let mut bytes = [0; key_samples::MAX_LEN];
    let len = frame.encode(PACKING, &mut bytes);
    framed(&bytes[..len])
}

fn encoded_forces(frame: &KeyForces) -> Wire {
    let mut bytes = [0; key_forces::MAX_LEN];
    let len = frame.encode(&mut bytes);
    framed(&bytes[..len])
}

fn framed(frame: &[u8]) -> Wire {
    let mut wire = [0; MAX_WIRE];
    let len = serial::encode(frame, &mut wire).expect("a frame of ours is short");
    (wire, len)
}

fn decoded<T, E: std::fmt::Debug>(
    deframer: &mut Deframer,
    (wire, len): &Wire,
    decode: fn(&[u8]) -> Result<T, E>,
) -> T {
    let mut frames = wire[..*len].iter().filter_map(|byte| {
        deframer.push(*byte).map(|frame| decode(frame.expect("it was not damaged")))
    });
    frames.next().expect("the wire ends with a frame").expect("a frame of ours")
}
