//! What a version may add without harm, and what it may not change.

use firmware_protocol::acyclic::ping::Pong;
use firmware_protocol::acyclic::stream::Stream;
use firmware_protocol::acyclic::{
    AcyclicReply, AcyclicRequest, Operation, Status, encode_reply, encode_request,
};
use firmware_protocol::frame::broadcast::Broadcast;
use firmware_protocol::frame::hello::{self, Hello, Introduction, MAGIC};
use firmware_protocol::frame::{DecodeError, FrameKind};
use firmware_protocol::key::BoardId;
use firmware_protocol::version::{PROTOCOL_VERSION, ProtocolVersion};
use firmware_protocol::{MAX_FRAME, Nothing, Record as _, can, schema};

fn board() -> BoardId {
    BoardId::new(4).expect("a board")
}

fn introduction() -> Introduction {
    let text = [0; Hello::LEN];
    let hello = Hello::take(&text).expect("all fields");
    let ProtocolVersion { major, minor } = PROTOCOL_VERSION;
    let hello = Hello { magic: MAGIC, major, minor, schema: schema::HASH, n_keys: 11, ..hello };
    Introduction { board: board(), safe: false, hello }
}

fn encoded(introduction: Introduction) -> [u8; MAX_FRAME] {
    let mut bytes = [0; MAX_FRAME];
    introduction.encode(&mut bytes);
    bytes
}

#[test]
fn a_hello_of_a_newer_minor_version_may_have_more_fields() {
    let mut newer = introduction();
    newer.hello.minor = PROTOCOL_VERSION.minor + 3;
    let mut bytes = encoded(newer);
    bytes[hello::LEN..].fill(0xA5);
    for len in hello::LEN..=MAX_FRAME {
        assert_eq!(Introduction::decode(&bytes[..len]), Ok(newer));
    }
}

#[test]
fn a_board_of_another_generation_is_refused_by_its_number_however_short_its_hello() {
    let mut foreign = introduction();
    foreign.hello.major = PROTOCOL_VERSION.major + 1;
    let bytes = encoded(foreign);
    let refused = Err(DecodeError::Version(foreign.hello.major));
    for len in 1 + MAGIC.len() + 1..=MAX_FRAME {
        assert_eq!(Introduction::decode(&bytes[..len]), refused);
    }
}

#[test]
fn another_schema_is_seen_though_the_version_is_the_same() {
    let mut other = introduction();
    other.hello.schema = !schema::HASH;
    let read = Introduction::decode(&encoded(other)).expect("the version is the same");
    assert_ne!(read.hello.schema, schema::HASH);
}

#[test]
fn an_operation_of_a_newer_version_is_answered_as_unknown() {
    let mut bytes = [0; MAX_FRAME];
    let len = encode_request(board(), 7, Operation::Ping, &Nothing, &mut bytes);
    bytes[2] = 200;
    let request = AcyclicRequest::decode(&bytes[..len]).expect("a request");
    let number = request.operation.expect_err("a newer one");
    let unknown = Err::<Nothing, _>(Status::Unknown);
    let len = encode_reply(request.board, request.id, number, unknown, &mut bytes);
    let reply = AcyclicReply::decode(&bytes[..len]).expect("a reply");
    assert_eq!((reply.id, reply.operation, reply.status), (7, Err(200), Status::Unknown));
}

#[test]
fn a_record_may_have_grown_but_not_shrunk() {
    let mut bytes = [0; MAX_FRAME];
    let stream = Stream { period_us: 2_000, packing: 1, phase_us: 0 };
    let len = encode_request(board(), 7, Operation::Stream, &stream, &mut bytes);
    bytes[len] = 99;
    let grown = AcyclicRequest::decode(&bytes[..=len]).expect("a request");
    assert_eq!(Stream::take(grown.record), Some(stream));
    let cut = AcyclicRequest::decode(&bytes[..len - 1]).expect("a request still");
    assert_eq!(Stream::take(cut.record), None);
}

#[test]
fn a_status_of_a_newer_version_is_a_refusal() {
    let mut bytes = [0; MAX_FRAME];
    let pong = Pong { board_us: 1 };
    let len = encode_reply(board(), 7, Operation::Ping as u8, Ok(pong), &mut bytes);
    bytes[3] = 77;
    assert_eq!(AcyclicReply::decode(&bytes[..len]).expect("a reply").status, Status::Impossible);
}

#[test]
fn a_kind_of_a_newer_version_is_ignored() {
    let mut bytes = encoded(introduction());
    bytes[0] |= 0xE0;
    assert_eq!(FrameKind::of(&bytes), None);
    assert_eq!(can::identifier(&bytes), None);
    assert_eq!(Introduction::decode(&bytes), Err(DecodeError::Kind(7)));
    assert_eq!(AcyclicRequest::decode(&bytes), Err(DecodeError::Kind(7)));
    assert_eq!(Broadcast::decode(&bytes[..8]), Err(DecodeError::Kind(7)));
}
