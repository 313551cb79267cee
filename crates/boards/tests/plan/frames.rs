//! Lengths of CAN frames: the table, exact vectors, and any payload between minimum and maximum.

use boards::plan::can::{FdBits, Id, Stuffing, classic_bits};
use firmware_protocol::can::padded;
use proptest::prelude::*;

use super::encoder;
use Id::{Extended, Standard};
use Stuffing::{Fewest, Most};

fn fd_bits(id: Id, bytes: usize, stuffing: Stuffing) -> (usize, usize) {
    let bits = FdBits::of(id, bytes, stuffing);
    (bits.nominal, bits.data)
}

/// Returns the time at 1 Mbit/s and this data rate (us).
fn fd_time(bytes: usize, stuffing: Stuffing, data: u32) -> f64 {
    FdBits::of(Standard, bytes, stuffing).time(1_000_000, data)
}

#[test]
fn classic_frames_have_the_lengths_of_the_table() {
    let table = [
        (0, 47, 55),
        (1, 55, 65),
        (2, 63, 75),
        (3, 71, 85),
        (4, 79, 95),
        (6, 95, 115),
        (8, 111, 135),
    ];
    for (bytes, fewest, most) in table {
        let got = (classic_bits(Standard, bytes, Fewest), classic_bits(Standard, bytes, Most));
        assert_eq!(got, (fewest, most), "{bytes} bytes");
    }
    assert_eq!((classic_bits(Extended, 8, Fewest), classic_bits(Extended, 8, Most)), (131, 160));
}

/// Payload (bytes), data bits and time at 1/5 Mbit/s, each minimum and maximum, time at 1/8 (us).
type FdRow = (usize, usize, usize, f64, f64, f64);

const FD: [FdRow; 8] = [
    (8, 97, 114, 48.4, 55.8, 47.2),
    (12, 129, 154, 54.8, 63.8, 52.2),
    (16, 161, 194, 61.2, 71.8, 57.2),
    (20, 198, 239, 68.6, 80.8, 62.9),
    (24, 230, 279, 75.0, 88.8, 67.9),
    (32, 294, 359, 87.8, 104.8, 77.9),
    (48, 422, 519, 113.4, 136.8, 97.9),
    (64, 550, 679, 139.0, 168.8, 117.9),
];

#[test]
fn fd_frames_have_the_lengths_and_times_of_the_table() {
    for (bytes, fewest, most, least, longest, faster) in FD {
        assert_eq!(fd_bits(Standard, bytes, Fewest), (29, fewest), "{bytes} bytes");
        assert_eq!(fd_bits(Standard, bytes, Most), (33, most), "{bytes} bytes");
        let times = [
            (fd_time(bytes, Fewest, 5_000_000), least),
            (fd_time(bytes, Most, 5_000_000), longest),
            (fd_time(bytes, Most, 8_000_000), faster),
        ];
        for (got, printed) in times {
            assert!((got - printed).abs() < 0.051, "{bytes} bytes: {got} us, not {printed}");
        }
    }
    assert_eq!(fd_bits(Extended, 64, Fewest), (48, 550));
    assert_eq!(fd_bits(Extended, 64, Most), (56, 680));
}

#[test]
fn classic_vectors_of_can_utils_have_their_exact_length() {
    let cases: [(usize, &[u8], usize); 7] = [
        (0x123, &[0xDE, 0xAD, 0xBE, 0xEF], 81),
        (0x000, &[0x00; 8], 127),
        (0x7FF, &[0xFF; 8], 126),
        (0x555, &[0x55; 8], 112),
        (0x201, &[], 50),
        (0x078, &[0x3C; 8], 131),
        (0x100, &[1, 2, 3, 4, 5, 6, 7, 8], 122),
    ];
    for (id, payload, bits) in cases {
        assert_eq!(encoder::classic(Standard, id, payload), bits, "{id:03X}#{payload:02X?}");
    }
}

#[test]
fn fd_vectors_have_their_exact_length() {
    let counting: Vec<u8> = (0..64).collect();
    let cases: [(usize, &[u8], (usize, usize)); 6] = [
        (0x123, &[0x00; 64], (29, 652)),
        (0x123, &[0xFF; 64], (29, 653)),
        (0x123, &[0x55; 64], (29, 550)),
        (0x101, &counting, (30, 575)),
        (0x101, &counting[..48], (30, 443)),
        (0x101, &counting[..32], (30, 312)),
    ];
    for (id, payload, (nominal, data)) in cases {
        let bits = encoder::fd(Standard, id, payload);
        assert_eq!(bits, FdBits { nominal, data }, "{id:03X}##1 {} bytes", payload.len());
    }
}

/// Payloads by their runs of equal bits: runs of about four cost most.
fn by_runs() -> impl Strategy<Value = Vec<u8>> {
    (prop::collection::vec(1_usize..7, 64 * 8), any::<bool>()).prop_map(|(runs, first)| {
        let bits = runs.iter().scan(first, |bit, run| {
            *bit = !*bit;
            Some(std::iter::repeat_n(*bit, *run))
        });
        pack(bits.flatten())
    })
}

/// Runs of four behind a first of five: the maximum of stuff bits.
fn worst() -> impl Strategy<Value = Vec<u8>> {
    (0_usize..8, any::<bool>())
        .prop_map(|(phase, first)| pack((0..64 * 8).map(|at| ((at + phase) / 4 % 2 == 0) != first)))
}

fn pack(bits: impl Iterator<Item = bool>) -> Vec<u8> {
    let bits: Vec<_> = bits.take(64 * 8).collect();
    let byte = |eight: &[bool]| eight.iter().fold(0, |byte, bit| (byte << 1) | u8::from(*bit));
    bits.chunks_exact(8).map(byte).collect()
}

fn payload() -> impl Strategy<Value = Vec<u8>> {
    prop_oneof![
        prop::collection::vec(any::<u8>(), 64),
        prop::collection::vec(prop::sample::select(vec![0x00, 0xFF, 0x0F, 0xF0, 0x3C, 0xC3]), 64),
        any::<u8>().prop_map(|byte| vec![byte; 64]),
        by_runs(),
        worst(),
    ]
}

fn address() -> impl Strategy<Value = (Id, usize)> {
    let standard = prop_oneof![0..0x800_usize, prop::sample::select(vec![0x078, 0x787, 0, 0x7FF])];
    let extended = prop_oneof![0..0x2000_0000_usize, Just(0x0787_8787), Just(0x1878_7878)];
    prop_oneof![standard.prop_map(|it| (Standard, it)), extended.prop_map(|it| (Extended, it))]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4_000))]

    #[test]
    fn every_classic_frame_lies_between_fewest_and_most(
        (id, number) in address(), payload in payload(), n in 0_usize..=8,
    ) {
        let bits = encoder::classic(id, number, &payload[..n]);
        prop_assert!(classic_bits(id, n, Fewest) <= bits && bits <= classic_bits(id, n, Most));
    }

    #[test]
    fn every_fd_frame_lies_between_fewest_and_most(
        (id, number) in address(), payload in payload(), n in 0_usize..=64,
    ) {
        let n = padded(n);
        let bits = encoder::fd(id, number, &payload[..n]);
        let (fewest, most) = (FdBits::of(id, n, Fewest), FdBits::of(id, n, Most));
        prop_assert!(fewest.nominal <= bits.nominal && bits.nominal <= most.nominal);
        prop_assert!(fewest.data <= bits.data);
        // Stuff bits that the head does not use, the rest may need.
        prop_assert!(bits.nominal + bits.data <= most.nominal + most.data);
        let exact = bits.time(1_000_000, 5_000_000);
        prop_assert!(exact <= most.time(1_000_000, 5_000_000) + 1e-9);
    }
}
