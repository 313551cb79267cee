//! The golden bytes that firmware in any language must meet; made by another program.
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]

use firmware_protocol::frame::Header;
use firmware_protocol::frame::key_forces::{self, KeyForces};
use firmware_protocol::frame::key_samples::{self, KeySamples};
use firmware_protocol::key::{BoardId, PerKey};
use firmware_protocol::quantity::{Counts, Millinewtons};
use firmware_protocol::sequence::Sequence;
use firmware_protocol::serial::{self, Deframer};

#[test]
fn key_samples() {
    let header = Header { board: board(3), sequence: Sequence(254), stamp_us: 0x1234, fault: true };
    let counts = [0, 1, -1, 2_500, -2_500, 8_388_607, -8_388_608, 256, 65_536, -65_536, 12_345];
    check_samples(include_str!("../vectors/key_samples.hex"), header, &counts);
}

#[test]
fn key_samples_one_key() {
    check_samples(
        include_str!("../vectors/key_samples_one_key.hex"),
        Header { board: board(0), sequence: Sequence(0), stamp_us: 0, fault: false },
        &[-2],
    );
}

#[test]
fn key_forces() {
    let header = Header { board: board(7), sequence: Sequence(42), stamp_us: 65_535, fault: false };
    let forces = [0, 1, -1, 500, -500, 32_767, -32_768, 256, -256, 1_234, -4_321];
    check_forces(include_str!("../vectors/key_forces.hex"), header, &forces);
}

#[test]
fn key_forces_one_key() {
    let vector = include_str!("../vectors/key_forces_one_key.hex");
    check_forces(
        vector,
        Header { board: board(0), sequence: Sequence(1), stamp_us: 1_000, fault: true },
        &[-1],
    );
}

fn board(number: u8) -> BoardId {
    BoardId::new(number).expect("a board of the compass")
}

/// Asserts that these samples are the vector's frame, both ways.
#[track_caller]
fn check_samples(vector: &str, header: Header, counts: &[i32]) {
    let positions = PerKey::collect(counts.iter().copied().map(Counts::saturating));
    let samples = KeySamples { header, positions };
    let golden = line(vector, "frame ");
    let mut bytes = [0; key_samples::MAX_LEN];
    let n = samples.encode(&mut bytes);
    assert_eq!(&bytes[..n], golden);
    assert_eq!(KeySamples::decode(&golden), Ok(samples));
    check_wire(vector);
}

/// Asserts that these forces are the vector's frame, both ways.
#[track_caller]
fn check_forces(vector: &str, header: Header, millinewtons: &[i32]) {
    let forces = PerKey::collect(millinewtons.iter().copied().map(Millinewtons::saturating));
    let forces = KeyForces { header, forces };
    let golden = line(vector, "frame ");
    let mut bytes = [0; key_forces::MAX_LEN];
    let n = forces.encode(&mut bytes);
    assert_eq!(&bytes[..n], golden);
    assert_eq!(KeyForces::decode(&golden), Ok(forces));
    check_wire(vector);
}

/// Asserts that the vector's frame travels as its wire bytes, both ways.
#[track_caller]
fn check_wire(vector: &str) {
    let (frame, golden) = (line(vector, "frame "), line(vector, "wire "));
    let mut wire = [0; serial::MAX_WIRE];
    let n = serial::encode(&frame, &mut wire).expect("a frame that links carry");
    assert_eq!(&wire[..n], golden);
    let mut deframer = Deframer::default();
    let last =
        golden.iter().fold(None, |_, byte| deframer.push(*byte).map(|got| got.map(<[u8]>::to_vec)));
    assert_eq!(last, Some(Ok(frame)));
}

/// The bytes of the vector's line that starts with `name`.
fn line(vector: &str, name: &str) -> Vec<u8> {
    let hex = vector.lines().find_map(|line| line.strip_prefix(name)).expect("the line");
    hex.split(' ').map(|byte| u8::from_str_radix(byte, 16).expect("a hex byte")).collect()
}
