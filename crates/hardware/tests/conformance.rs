//! What every link must do, asked of each of them. A new link adds one `#[test]`.
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]

use hardware::link::faulty::{FaultPlan, Faults};
use hardware::link::loopback::Loopback;
use hardware::link::{Link, MAX_LEN, RecvError, SendError};

#[test]
fn loopback() {
    let mut wire = Loopback::new(4);
    check(&mut |side, turn| match side {
        Side::Host => turn(&mut wire.host_end()),
        Side::Board => turn(&mut wire.board_end()),
    });
}

#[test]
fn faulty_without_faults() {
    let mut wire = Loopback::new(4);
    let mut faults = Faults::new(FaultPlan::default());
    check(&mut |side, turn| match side {
        Side::Host => turn(&mut faults.around(wire.host_end())),
        Side::Board => turn(&mut wire.board_end()),
    });
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Side {
    Host,
    Board,
}

/// Lends one end of a link that carries at least four frames each way.
type Lend<'a> = &'a mut dyn FnMut(Side, &mut dyn FnMut(&mut dyn Link));

#[track_caller]
fn check(lend: Lend<'_>) {
    for (from, to) in [(Side::Host, Side::Board), (Side::Board, Side::Host)] {
        silence_is_nothing(lend, to);
        frames_arrive_whole_and_in_order(lend, from, to);
        the_longest_frame_passes_and_a_longer_one_is_refused(lend, from, to);
        a_short_buffer_loses_that_frame_only(lend, from, to);
    }
}

#[track_caller]
fn silence_is_nothing(lend: Lend<'_>, to: Side) {
    assert_eq!(recv(lend, to, MAX_LEN), Ok(None), "{to:?}");
}

#[track_caller]
fn frames_arrive_whole_and_in_order(lend: Lend<'_>, from: Side, to: Side) {
    let frames = [vec![1], vec![2; 39], vec![0; 3], Vec::new()];
    for frame in &frames {
        assert_eq!(send(lend, from, frame), Ok(()));
    }
    assert_eq!(recv(lend, from, MAX_LEN), Ok(None), "{from:?} hears itself");
    for frame in frames {
        assert_eq!(recv(lend, to, MAX_LEN), Ok(Some(frame)));
    }
    silence_is_nothing(lend, to);
}

#[track_caller]
fn the_longest_frame_passes_and_a_longer_one_is_refused(lend: Lend<'_>, from: Side, to: Side) {
    let longest = vec![7; MAX_LEN];
    assert_eq!(send(lend, from, &longest), Ok(()));
    assert_eq!(recv(lend, to, MAX_LEN), Ok(Some(longest)));
    let len = MAX_LEN + 1;
    assert_eq!(send(lend, from, &vec![7; len]), Err(SendError::TooLong { len }));
    silence_is_nothing(lend, to);
}

#[track_caller]
fn a_short_buffer_loses_that_frame_only(lend: Lend<'_>, from: Side, to: Side) {
    assert_eq!(send(lend, from, &[1; 9]), Ok(()));
    assert_eq!(send(lend, from, &[2; 3]), Ok(()));
    assert_eq!(recv(lend, to, 8), Err(RecvError::BufferTooShort { len: 9 }));
    assert_eq!(recv(lend, to, 8), Ok(Some(vec![2; 3])));
    silence_is_nothing(lend, to);
}

fn send(lend: Lend<'_>, side: Side, frame: &[u8]) -> Result<(), SendError> {
    let mut outcome = None;
    lend(side, &mut |link| outcome = Some(link.try_send(frame)));
    outcome.expect("the end was lent")
}

fn recv(lend: Lend<'_>, side: Side, room: usize) -> Result<Option<Vec<u8>>, RecvError> {
    let mut buffer = vec![0; room];
    let mut outcome = None;
    lend(side, &mut |link| outcome = Some(link.try_recv(&mut buffer)));
    let len = outcome.expect("the end was lent")?;
    Ok(len.map(|len| buffer[..len].to_vec()))
}
