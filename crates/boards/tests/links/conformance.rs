//! The checklist for every link. A new link adds one `#[test]`.
#![cfg(unix)]
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]

use std::io::Write as _;

use boards::links::can::{Can, CanMode};
use boards::links::faulty::{FaultPlan, Faults};
use boards::links::serial::{Pty, Serial};
use boards::links::wire::{Wire, WirePlan};
use boards::links::{BusSide, Health, Link, RecvError, SendError};
use boards::{links::framed::Framing, links::loopback::Loopback};
use firmware_protocol::{MAX_FRAME, key::BoardId};

const BAUD: u32 = 1_000_000;
/// Polls for a frame that a driver delivers late: seconds, not hours.
const PATIENCE: usize = 3_000_000;
/// Bytes that are no frame: stuffing that points behind its end.
const SPOILT: [u8; 3] = [9, 1, 0];

#[test]
fn faulty_without_faults_with_framing() {
    let mut wire = Loopback::new(16);
    let mut faults = Faults::new(FaultPlan::default());
    let (mut host, mut board) = (Framing::default(), Framing::default());
    check(&mut |side, turn| match side {
        Side::Host => turn(&mut host.around(faults.around(wire.host_end()))),
        Side::Board => turn(&mut board.around(wire.board_end())),
    });
}

#[test]
fn serial_on_a_pseudo_terminal() {
    let Pty { mut board, path } = Pty::open().unwrap();
    let mut host = Serial::open(&path, BAUD).unwrap();
    check(&mut |side, turn| match side {
        Side::Host => turn(&mut host),
        Side::Board => turn(&mut board),
    });
}

#[test]
fn serial_on_a_wire_without_faults() {
    for baud in [None, Some(BAUD)] {
        let wire = Wire::open(WirePlan { baud, ..WirePlan::default() }).unwrap();
        let mut host = Serial::open(wire.host(), BAUD).unwrap();
        let mut board = Serial::open(wire.board(), BAUD).unwrap();
        check(&mut |side, turn| match side {
            Side::Host => turn(&mut host),
            Side::Board => turn(&mut board),
        });
        let counts = wire.counts();
        assert_eq!([counts.lost, counts.flipped, counts.stalls], [0; 3]);
    }
}

/// One test for both modes, since they share an interface and would receive each other.
#[test]
fn can_where_there_is_an_interface() {
    let Ok(name) = std::env::var("LETOFF_CAN") else {
        return skip("LETOFF_CAN names no CAN interface: CAN was not tested");
    };
    for mode in [CanMode::Fd, CanMode::Classic] {
        let open = |side| Can::open(&name, mode, side);
        let mut host = match open(BusSide::Host) {
            Ok(host) => host,
            Err(error) => {
                skip(&format!("{mode:?} was not tested: {error}"));
                continue;
            }
        };
        let mut board = open(BusSide::Board(BoardId::new(3).unwrap())).unwrap();
        check(&mut |side, turn| match side {
            Side::Host => turn(&mut host),
            Side::Board => turn(&mut board),
        });
        assert_eq!((host.dropped(), host.health()), (0, Health::default()));
    }
}

#[test]
fn on_a_stream_a_corrupted_frame_is_told_and_the_next_is_read() {
    let mut wire = Loopback::new(16);
    let mut framing = Framing::default();
    let whole = encoded(&frame(Side::Board, 3, 48));
    for bytes in [&SPOILT[..], &whole[..9], &whole[10..], &whole] {
        wire.board_end().try_send(bytes).unwrap();
    }
    check_corrupt(2, Side::Board, &mut framing.around(wire.host_end()));
    let Pty { mut board, path } = Pty::open().unwrap();
    let mut client = std::fs::File::options().write(true).open(path).unwrap();
    let whole = encoded(&frame(Side::Host, 3, 48));
    let spoilt = [&SPOILT[..], &whole[..9], &whole[10..], &whole].concat();
    client.write_all(&spoilt).unwrap();
    check_corrupt(2, Side::Host, &mut board);
}

#[track_caller]
fn check_corrupt(n: usize, from: Side, link: &mut dyn Link) {
    // `recv` polls both sides; with one link for both it would lose the frames of the other.
    let mut silence = Loopback::new(1);
    let lend: Lend<'_> = &mut |side, turn| {
        if side == from.other() { turn(link) } else { turn(&mut silence.host_end()) }
    };
    for _ in 0..n {
        assert_eq!(recv(lend, from.other(), MAX_FRAME), Err(RecvError::Corrupt));
    }
    assert_eq!(recv(lend, from.other(), MAX_FRAME), Ok(Some(frame(from, 3, 48))));
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Side {
    Host,
    Board,
}

impl Side {
    const fn other(self) -> Self {
        match self {
            Self::Host => Self::Board,
            Self::Board => Self::Host,
        }
    }
}

/// Lends one end of a link that carries at least four frames each way, for board 3.
type Lend<'a> = &'a mut dyn FnMut(Side, &mut dyn FnMut(&mut dyn Link));

#[track_caller]
fn check(lend: Lend<'_>) {
    for from in [Side::Host, Side::Board] {
        let to = from.other();
        silence_is_nothing(lend, to);
        frames_arrive_whole_and_in_order(lend, from, to);
        the_longest_frame_passes_and_a_longer_one_is_refused(lend, from, to);
        a_short_buffer_loses_that_frame_only(lend, from, to);
    }
}

fn frame(from: Side, fill: u8, len: usize) -> Vec<u8> {
    let mut frame = vec![fill; len];
    // Kinds 1 (forces) and 3 (samples), board 3.
    frame[0] = match from {
        Side::Host => 0x23,
        Side::Board => 0x63,
    };
    frame
}

#[track_caller]
fn silence_is_nothing(lend: Lend<'_>, to: Side) {
    for _ in 0..100 {
        assert_eq!(recv_now(lend, to, MAX_FRAME), Ok(None), "{to:?}");
    }
}

#[track_caller]
fn frames_arrive_whole_and_in_order(lend: Lend<'_>, from: Side, to: Side) {
    let frames = [(1, 8), (2, 48), (0, 3), (255, 1)].map(|(fill, len)| frame(from, fill, len));
    for frame in &frames {
        assert_eq!(send(lend, from, frame), Ok(()));
    }
    for frame in frames {
        assert_eq!(recv(lend, to, MAX_FRAME), Ok(Some(frame)));
    }
    assert_eq!(recv_now(lend, from, MAX_FRAME), Ok(None), "{from:?} hears itself");
    silence_is_nothing(lend, to);
}

#[track_caller]
fn the_longest_frame_passes_and_a_longer_one_is_refused(lend: Lend<'_>, from: Side, to: Side) {
    for fill in [0, 7] {
        let longest = frame(from, fill, MAX_FRAME);
        assert_eq!(send(lend, from, &longest), Ok(()));
        assert_eq!(recv(lend, to, MAX_FRAME), Ok(Some(longest)));
    }
    for len in [MAX_FRAME + 1, 1_000] {
        let refused = Err(SendError::TooLong { len });
        assert_eq!(send(lend, from, &frame(from, 7, len)), refused);
    }
    silence_is_nothing(lend, to);
}

#[track_caller]
fn a_short_buffer_loses_that_frame_only(lend: Lend<'_>, from: Side, to: Side) {
    assert_eq!(send(lend, from, &frame(from, 1, 12)), Ok(()));
    assert_eq!(send(lend, from, &frame(from, 2, 3)), Ok(()));
    assert_eq!(recv(lend, to, 8), Err(RecvError::BufferTooShort { len: 12 }));
    assert_eq!(recv(lend, to, 8), Ok(Some(frame(from, 2, 3))));
    silence_is_nothing(lend, to);
}

fn send(lend: Lend<'_>, side: Side, frame: &[u8]) -> Result<(), SendError> {
    let mut outcome = None;
    lend(side, &mut |link| outcome = Some(link.try_send(frame)));
    outcome.expect("the end was lent")
}

fn recv(lend: Lend<'_>, side: Side, room: usize) -> Result<Option<Vec<u8>>, RecvError> {
    for _ in 0..PATIENCE {
        let outcome = recv_now(lend, side, room);
        if outcome != Ok(None) {
            return outcome;
        }
        // Any call at the other end sends the rest of a partly sent frame.
        let _nothing = recv_now(lend, side.other(), room);
        std::thread::yield_now();
    }
    Ok(None)
}

fn recv_now(lend: Lend<'_>, side: Side, room: usize) -> Result<Option<Vec<u8>>, RecvError> {
    let mut buffer = vec![0; room];
    let mut outcome = None;
    lend(side, &mut |link| outcome = Some(link.try_recv(&mut buffer)));
    let len = outcome.expect("the end was lent")?;
    Ok(len.map(|len| buffer[..len].to_vec()))
}

fn encoded(frame: &[u8]) -> Vec<u8> {
    let mut wire = [0; firmware_protocol::serial::MAX_WIRE];
    let len = firmware_protocol::serial::encode(frame, &mut wire).expect("a frame");
    wire[..len].to_vec()
}

fn skip(what: &str) {
    let _unheard = writeln!(std::io::stderr(), "SKIPPED: {what}");
}
