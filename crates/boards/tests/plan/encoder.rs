//! CAN frames bit by bit, as a controller sends them: the slow, plain method to their length.

use boards::plan::can::{FdBits, Id};

/// After the CRC of a classic frame: delimiter, ACK, delimiter, end, pause.
const CLASSIC_TAIL: usize = 1 + 1 + 1 + 7 + 3;
/// After the CRC's delimiter of a CAN FD frame.
const FD_TAIL: usize = 1 + 1 + 7 + 3;

pub(crate) fn classic(id: Id, number: usize, payload: &[u8]) -> usize {
    let mut bits = address(id, number);
    bits.push(false); // RTR
    // r1 and r0; with a short identifier, IDE and r0.
    bits.extend([false, false]);
    push(&mut bits, payload.len(), 4);
    push_all(&mut bits, payload);
    let crc = remainder(&bits, 15, 0x4599, 0);
    push(&mut bits, crc, 15);
    let wire = stuffed(&bits);
    let last = usize::from(ends_equal(&wire));
    wire.len() + last + CLASSIC_TAIL
}

pub(crate) fn fd(id: Id, number: usize, payload: &[u8]) -> FdBits {
    let mut bits = address(id, number);
    bits.push(false); // RRS
    if id == Id::Standard {
        bits.push(false); // IDE
    }
    bits.extend([true, false, true]); // FDF, res, BRS
    let nominal = stuffed(&bits).len();
    bits.push(false); // ESI
    push(&mut bits, length_code(payload.len()), 4);
    push_all(&mut bits, payload);
    // Behind the last bit, the first fixed stuff bit takes the place of a dynamic one.
    let mut wire = stuffed(&bits);
    let count = wire.len() - bits.len();
    wire.extend(fixed_stuffed(&wire, &check_field(&wire, count, payload.len())));
    let delimiter = 1;
    FdBits { nominal: nominal + FD_TAIL, data: wire.len() - nominal + delimiter }
}

fn address(id: Id, number: usize) -> Vec<bool> {
    let mut bits = vec![false];
    match id {
        Id::Standard => push(&mut bits, number, 11),
        Id::Extended => {
            push(&mut bits, number >> 18, 11);
            bits.extend([true, true]); // SRR, IDE
            push(&mut bits, number, 18);
        }
    }
    bits
}

/// Returns the stuff bits' count, Gray-coded with parity, and the CRC of all before.
fn check_field(wire: &[bool], count: usize, payload: usize) -> Vec<bool> {
    let (width, poly) = if payload <= 16 { (17, 0x1_685B) } else { (21, 0x10_2899) };
    let count = count % 8;
    let gray = count ^ (count >> 1);
    let mut field = Vec::new();
    push(&mut field, (gray << 1) | usize::from(gray.count_ones() % 2 == 1), 4);
    let covered: Vec<_> = wire.iter().chain(&field).copied().collect();
    push(&mut field, remainder(&covered, width, poly, 1 << (width - 1)), width);
    field
}

fn length_code(payload: usize) -> usize {
    let above_8 = [12, 16, 20, 24, 32, 48, 64];
    above_8.iter().position(|it| *it == payload).map_or(payload, |code| 9 + code)
}

fn push(bits: &mut Vec<bool>, value: usize, n: usize) {
    bits.extend((0..n).rev().map(|at| (value >> at) & 1 == 1));
}

fn push_all(bits: &mut Vec<bool>, payload: &[u8]) {
    for byte in payload {
        push(bits, usize::from(*byte), 8);
    }
}

/// Inserts the inverse after five equal bits, which counts for the next five; not behind the last.
fn stuffed(bits: &[bool]) -> Vec<bool> {
    let mut wire = Vec::new();
    for bit in bits {
        if ends_equal(&wire) {
            wire.extend(wire.last().map(|last| !last));
        }
        wire.push(*bit);
    }
    wire
}

fn ends_equal(wire: &[bool]) -> bool {
    wire.last_chunk::<5>().is_some_and(|five| five.iter().all(|bit| *bit == five[0]))
}

/// Inserts the inverse of the bit before in front of and after every fourth bit of `field`.
fn fixed_stuffed(wire: &[bool], field: &[bool]) -> Vec<bool> {
    let mut last = wire.last().is_some_and(|bit| *bit);
    let mut out = Vec::new();
    for (at, bit) in field.iter().enumerate() {
        if at % 4 == 0 {
            out.push(!last);
        }
        out.push(*bit);
        last = *bit;
    }
    out
}

fn remainder(bits: &[bool], width: usize, poly: usize, start: usize) -> usize {
    bits.iter().fold(start, |crc, bit| {
        let out = ((crc >> (width - 1)) & 1 == 1) != *bit;
        ((crc << 1) ^ if out { poly } else { 0 }) & ((1 << width) - 1)
    })
}

#[test]
fn the_encoder_s_checksums_are_those_of_the_catalogue() {
    let mut bits = Vec::new();
    push_all(&mut bits, b"123456789");
    assert_eq!(remainder(&bits, 15, 0x4599, 0), 0x059E);
    assert_eq!(remainder(&bits, 17, 0x1_685B, 0), 0x0_4F03);
    assert_eq!(remainder(&bits, 21, 0x10_2899, 0), 0x0E_D841);
}
