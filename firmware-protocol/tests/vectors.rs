//! The golden bytes that firmware in any language must meet; made by another program.

use core::fmt::Debug;

use firmware_protocol::acyclic::*;
use firmware_protocol::can::{self, pieces};
use firmware_protocol::frame::broadcast::{self, Broadcast};
use firmware_protocol::frame::hello::{Hello, Introduction};
use firmware_protocol::frame::key_forces::{ForceLayout, ForcePacking, KeyForces, KeySlopes};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout, SamplePacking};
use firmware_protocol::frame::multicast_forces::MulticastForces;
use firmware_protocol::frame::{FrameKind, Header};
use firmware_protocol::key::{BoardId, PerKey};
use firmware_protocol::quantity::{Counts, Millinewtons, SlopeCode, SpeedCode};
use firmware_protocol::sequence::SequenceNumber;
use firmware_protocol::serial::{self, Deframer};
use firmware_protocol::version::ProtocolVersion;
use firmware_protocol::{MAX_FRAME, Nothing, Record};

use crate::vector::Vector;

#[test]
fn every_vector_reads_as_its_fields_and_its_fields_write_it() {
    for vector in crate::vector::all() {
        match vector.text("kind") {
            "hello" => check_hello(&vector),
            "key_samples" => check_samples(&vector),
            "key_forces" => check_forces(&vector),
            "multicast_forces" => check_multicast(&vector),
            "broadcast" => check_broadcast(&vector),
            "request" => check_request(&vector),
            "reply" => check_reply(&vector),
            kind => panic!("{}: nobody reads {kind}", vector.name),
        }
    }
}

#[test]
fn every_vector_travels_on_the_stream_and_on_both_kinds_of_can() {
    for vector in crate::vector::all() {
        check_wire(&vector);
        check_can(&vector);
        check_pieces(&vector);
    }
}

#[test]
fn the_vectors_are_what_their_program_makes() {
    if !crate::tools::are_there(&["python3"]) {
        return;
    }
    let program = crate::tools::crate_root().join("vectors/make.py");
    crate::tools::run(std::process::Command::new("python3").arg("-B").arg(program).arg("--check"));
}

#[test]
fn there_is_a_vector_of_every_kind_packing_and_operation() {
    let vectors = crate::vector::all();
    let has = |kind: &str, name: &str, number: u8| {
        let of_kind = vectors.iter().filter(|vector| vector.text("kind") == kind);
        let found = of_kind.into_iter().any(|vector| vector.number::<u8>(name) == number);
        assert!(found, "no {kind} with {name} {number}");
    };
    for packing in SamplePacking::ALL {
        has("key_samples", "packing", packing as u8);
    }
    for (kind, name, numbers) in [("key_forces", "packing", 0..=1), ("broadcast", "what", 1..=3)] {
        numbers.for_each(|number| has(kind, name, number));
    }
    for operation in Operation::ALL {
        has("request", "operation", operation as u8);
        has("reply", "operation", operation as u8);
    }
}

fn board(vector: &Vector) -> BoardId {
    BoardId::new(vector.number("board")).expect("a board")
}

fn header(vector: &Vector) -> Header {
    Header {
        board: board(vector),
        sequence: SequenceNumber(vector.number("sequence")),
        stamp_us: vector.number("stamp_us"),
        flag: vector.number::<u8>("flag") == 1,
    }
}

#[track_caller]
fn check_samples(vector: &Vector) {
    let packing = SamplePacking::new(vector.number("packing")).expect("a packing");
    let positions = vector.numbers("positions").into_iter().map(Counts::saturating);
    let velocities = vector.numbers("velocities").into_iter().map(SpeedCode::saturating);
    let (positions, velocities) = (PerKey::collect(positions), PerKey::collect(velocities));
    let samples = KeySamples { header: header(vector), positions, velocities };
    let layout = SampleLayout { packing, n_keys: positions.as_slice().len() };
    let mut bytes = [0xAA; MAX_FRAME];
    let len = samples.encode(packing, &mut bytes);
    check(vector, &bytes[..len], KeySamples::decode(&vector.frame(), layout), Ok(samples));
}

#[track_caller]
fn check_forces(vector: &Vector) {
    let packing = ForcePacking::new(vector.number("packing")).expect("a packing");
    let forces = vector.numbers("forces").into_iter().map(Millinewtons::saturating);
    let stiffness = vector.numbers("stiffness").into_iter().map(SlopeCode::toward_zero);
    let damping = vector.numbers("damping").into_iter().map(SlopeCode::toward_zero);
    let slopes = stiffness.zip(damping).map(|(k, b)| KeySlopes { stiffness: k, damping: b });
    let slopes = PerKey::collect(slopes);
    let forces = KeyForces { header: header(vector), forces: PerKey::collect(forces), slopes };
    let layout = ForceLayout { packing, n_keys: forces.forces.as_slice().len() };
    let mut bytes = [0xAA; MAX_FRAME];
    let len = forces.encode(&mut bytes);
    check(vector, &bytes[..len], KeyForces::decode(&vector.frame(), layout), Ok(forces));
}

#[track_caller]
fn check_multicast(vector: &Vector) {
    let forces: Vec<_> =
        vector.numbers("forces").into_iter().map(Millinewtons::saturating).collect();
    let multicast = MulticastForces {
        group: vector.number("group"),
        sequence: SequenceNumber(vector.number("sequence")),
        stamp_us: vector.number("stamp_us"),
        flag: vector.number::<u8>("flag") == 1,
        forces: forces.try_into().expect("thirty forces"),
    };
    let decoded = MulticastForces::decode(&vector.frame());
    check(vector, &multicast.encode(), decoded, Ok(multicast));
}

#[track_caller]
fn check_broadcast(vector: &Vector) {
    let broadcast = match vector.number("what") {
        1 => Broadcast::EmergencyStop { reason: vector.number("reason") },
        2 => Broadcast::BusTime { host_us: vector.number("host_us") },
        3 => {
            let (major, minor) = (vector.number("major"), vector.number("minor"));
            Broadcast::WhoIsThere { version: ProtocolVersion { major, minor } }
        }
        other => panic!("{}: nobody reads broadcast {other}", vector.name),
    };
    let mut bytes = [0xAA; broadcast::MAX_LEN];
    let len = broadcast.encode(&mut bytes);
    check(vector, &bytes[..len], Broadcast::decode(&vector.frame()), Ok(broadcast));
}

#[track_caller]
fn check_hello(vector: &Vector) {
    let introduction = Introduction::decode(&vector.frame()).expect("a hello");
    check_fields(vector, "flag", &introduction.hello);
    let expected = (board(vector), vector.number::<u8>("flag") == 1);
    let mut bytes = [0xAA; MAX_FRAME];
    let len = introduction.encode(&mut bytes);
    check(vector, &bytes[..len], (introduction.board, introduction.safe), expected);
}

macro_rules! check_operations {
    ($(
        $number:literal $name:ident = $function:ident($request:ty) -> $answer:ty,
        $needed:ident, $meaning:literal;
    )+) => {
        #[track_caller]
        fn check_request(vector: &Vector) {
            match Operation::new(vector.number("operation")).expect("an operation") {
                $(Operation::$name => request_with::<$request>(vector),)+
            }
        }

        #[track_caller]
        fn check_reply(vector: &Vector) {
            if vector.number::<u8>("status") != 0 {
                return reply_with::<Nothing>(vector);
            }
            match Operation::new(vector.number("operation")).expect("an operation") {
                $(Operation::$name => reply_with::<$answer>(vector),)+
            }
        }
    };
}

firmware_protocol::operations!(check_operations);

#[track_caller]
fn request_with<R: Record + Debug>(vector: &Vector) {
    let frame = vector.frame();
    let request = AcyclicRequest::decode(&frame).expect("a request");
    let record = R::take(request.record).expect("its record");
    check_fields(vector, "operation", &record);
    let operation = request.operation.expect("a known operation");
    let got = (request.board, request.id, operation as u8);
    let mut bytes = [0xAA; MAX_FRAME];
    let len = encode_request(request.board, request.id, operation, &record, &mut bytes);
    let expected = (board(vector), vector.number("id"), vector.number("operation"));
    check(vector, &bytes[..len], got, expected);
}

#[track_caller]
fn reply_with<R: Record + Debug>(vector: &Vector) {
    let frame = vector.frame();
    let reply = AcyclicReply::decode(&frame).expect("a reply");
    let record = R::take(reply.record).expect("its record");
    check_fields(vector, "status", &record);
    let outcome = if reply.status == Status::Done { Ok(record) } else { Err(reply.status) };
    let operation = reply.operation.map_or_else(|number| number, |known| known as u8);
    let got = (reply.board, reply.id, operation, reply.status as u8);
    let mut bytes = [0xAA; MAX_FRAME];
    let len = encode_reply(reply.board, reply.id, operation, outcome, &mut bytes);
    let ids = (vector.number("id"), vector.number("operation"), vector.number("status"));
    check(vector, &bytes[..len], got, (board(vector), ids.0, ids.1, ids.2));
}

#[track_caller]
fn check<T: Copy + Debug + PartialEq>(vector: &Vector, bytes: &[u8], got: T, expected: T) {
    assert_eq!(got, expected, "{}", vector.name);
    assert_eq!(bytes, vector.frame(), "{}", vector.name);
}

#[track_caller]
fn check_fields<R: Debug>(vector: &Vector, last: &str, record: &R) {
    let fields = vector.fields_after(last).map(|(name, value)| {
        let bytes = value.split_whitespace().collect::<Vec<_>>().join(", ");
        // Bytes are printed as an array, but one number alone is never an array of one.
        let value = if value.contains(' ') { format!("[{bytes}]") } else { bytes };
        format!("{name}: {value}")
    });
    let fields = fields.collect::<Vec<_>>().join(", ");
    let shown = format!("{record:?}");
    let (_name, shown) = shown.trim_end_matches(" }").split_once(" { ").unwrap_or_default();
    assert_eq!(shown, fields, "{}", vector.name);
}

#[track_caller]
fn check_wire(vector: &Vector) {
    let (frame, golden) = (vector.frame(), vector.bytes("wire").concat());
    let mut wire = [0; serial::MAX_WIRE];
    let len = serial::encode(&frame, &mut wire).expect("a frame that links carry");
    assert_eq!(&wire[..len], golden, "{}", vector.name);
    let mut deframer = Deframer::default();
    let mut last = None;
    for byte in golden {
        last = deframer.push(byte).map(|got| got.map(<[u8]>::to_vec));
    }
    assert_eq!(last, Some(Ok(frame)), "{}", vector.name);
}

#[track_caller]
fn check_can(vector: &Vector) {
    let frame = vector.frame();
    assert_eq!(can::identifier(&frame), Some(vector.number("can_id")), "{}", vector.name);
    assert_eq!(can::padded(frame.len()), vector.number::<usize>("padded"), "{}", vector.name);
    let kind = FrameKind::of(&frame).map(|kind| kind as u8);
    assert_eq!(kind, Some(frame[0] >> 5), "{}", vector.name);
}

#[track_caller]
fn check_pieces(vector: &Vector) {
    let (frame, golden) = (vector.frame(), vector.bytes("pieces"));
    let cut = pieces::cut(&frame, vector.number("roll"));
    let cut: Vec<_> = cut.map(|(piece, len)| piece[..len].to_vec()).collect();
    assert_eq!(cut, golden, "{}", vector.name);
    let mut assembler = pieces::Reassembler::default();
    let mut whole = None;
    for piece in &golden {
        whole = assembler.push(piece).expect("the next piece").map(<[u8]>::to_vec);
    }
    assert_eq!(whole, Some(frame), "{}", vector.name);
}
