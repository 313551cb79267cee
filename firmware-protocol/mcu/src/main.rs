//! The protocol crate on a Cortex-M3: reads, writes and reports every golden vector.
//!
//! ```text
//! cargo run --release        in this folder, with qemu-system-arm
//! ```
#![no_std]
#![no_main]

mod semihosting;
mod vector;

use firmware_protocol::MAX_FRAME;
use firmware_protocol::acyclic::{AcyclicReply, AcyclicRequest};
use firmware_protocol::can;
use firmware_protocol::can::pieces::{self, Reassembler};
use firmware_protocol::frame::FrameKind;
use firmware_protocol::frame::broadcast::{self, Broadcast};
use firmware_protocol::frame::hello::Introduction;
use firmware_protocol::frame::key_forces::{ForceLayout, ForcePacking, KeyForces};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout, SamplePacking};
use firmware_protocol::frame::multicast_forces::MulticastForces;
use firmware_protocol::serial::{self, Deframer};
use vector::Vector;

static VECTORS: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/vectors.rs"));

/// The vector table after the initial stack pointer: the start, and 14 faults.
#[unsafe(link_section = ".vectors")]
#[used]
static EXCEPTIONS: [extern "C" fn() -> !; 15] = [
    reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
    fault, fault,
];

extern "C" fn fault() -> ! {
    semihosting::write("FAULT\n");
    semihosting::exit(false)
}

#[unsafe(no_mangle)]
extern "C" fn reset() -> ! {
    let mut good = 0;
    for (name, text) in VECTORS {
        if Vector::read(text).is_some_and(|vector| holds(&vector)) {
            good += 1;
        } else {
            semihosting::write("FAILED: ");
            semihosting::write(name);
            semihosting::write("\n");
        }
    }
    semihosting::write_number(good);
    semihosting::write(" of ");
    semihosting::write_number(VECTORS.len());
    semihosting::write(" vectors hold on this machine\n");
    semihosting::exit(good == VECTORS.len())
}

#[panic_handler]
fn panic(_why: &core::panic::PanicInfo<'_>) -> ! {
    semihosting::write("PANIC\n");
    semihosting::exit(false)
}

fn holds(vector: &Vector<'_>) -> bool {
    frame_holds(vector) == Some(true)
        && stream_holds(vector) == Some(true)
        && can_holds(vector) == Some(true)
}

/// Returns `true` if the frame decodes, and encodes to its own bytes.
fn frame_holds(vector: &Vector<'_>) -> Option<bool> {
    let frame = vector.frame();
    let mut again = [0xAA; MAX_FRAME];
    let len = match FrameKind::of(frame)? {
        FrameKind::KeySamples => {
            let packing = SamplePacking::new(vector.number("packing")?)?;
            let n_keys = vector.count("positions")?;
            KeySamples::decode(frame, SampleLayout { packing, n_keys })
                .ok()?
                .encode(packing, &mut again)
        }
        FrameKind::KeyForces => {
            let packing = ForcePacking::new(vector.number("packing")?)?;
            let n_keys = vector.count("forces")?;
            KeyForces::decode(frame, ForceLayout { packing, n_keys }).ok()?.encode(&mut again)
        }
        FrameKind::MulticastForces => {
            again = MulticastForces::decode(frame).ok()?.encode();
            again.len()
        }
        FrameKind::Broadcast => {
            let mut short = [0; broadcast::MAX_LEN];
            let len = Broadcast::decode(frame).ok()?.encode(&mut short);
            again[..short.len()].copy_from_slice(&short);
            len
        }
        FrameKind::Hello => Introduction::decode(frame).ok()?.encode(&mut again),
        FrameKind::Request => {
            return Some(request_holds(vector, AcyclicRequest::decode(frame).ok()?));
        }
        FrameKind::Reply => return Some(reply_holds(vector, AcyclicReply::decode(frame).ok()?)),
    };
    Some(&again[..len] == frame)
}

fn request_holds(vector: &Vector<'_>, request: AcyclicRequest<'_>) -> bool {
    let operation = request.operation.map_or_else(|number| number, |known| known as u8);
    vector.number("board") == Some(request.board.number())
        && vector.number("id") == Some(request.id)
        && vector.number("operation") == Some(operation)
}

fn reply_holds(vector: &Vector<'_>, reply: AcyclicReply<'_>) -> bool {
    let operation = reply.operation.map_or_else(|number| number, |known| known as u8);
    vector.number("board") == Some(reply.board.number())
        && vector.number("id") == Some(reply.id)
        && vector.number("operation") == Some(operation)
        && vector.number("status") == Some(reply.status as u8)
}

/// Returns `true` if the frame has the vector's bytes on a byte stream, and arrives.
fn stream_holds(vector: &Vector<'_>) -> Option<bool> {
    let mut wire = [0; serial::MAX_WIRE];
    let len = serial::encode(vector.frame(), &mut wire).ok()?;
    let golden = vector.line("wire")?;
    let mut deframer = Deframer::default();
    let mut arrived = false;
    for (byte, digits) in wire[..len].iter().zip(golden.as_bytes().chunks(2)) {
        if vector::byte(digits)? != *byte {
            return Some(false);
        }
        arrived = deframer.push(*byte).is_some_and(|frame| frame == Ok(vector.frame()));
    }
    Some(arrived && golden.len() == 2 * len)
}

/// Returns `true` if the frame has the vector's pieces on CAN, and arrives.
fn can_holds(vector: &Vector<'_>) -> Option<bool> {
    let mut reassembler = Reassembler::default();
    let mut golden = vector.line("pieces")?.split(' ');
    let mut arrived = false;
    for (piece, len) in pieces::cut(vector.frame(), vector.number("roll")?) {
        let word = golden.next()?.as_bytes();
        let same = word.chunks(2).map(vector::byte).eq(piece[..len].iter().copied().map(Some));
        let whole = reassembler.push(&piece[..len]).ok()?;
        arrived = same && whole.is_some_and(|frame| frame == vector.frame());
        if !same {
            return Some(false);
        }
    }
    let id = can::identifier(vector.frame())? == vector.number("can_id")?;
    Some(arrived && golden.next().is_none() && id)
}
