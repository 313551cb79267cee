//! The real CAN driver on the free virtual interface that `LETOFF_CAN` names.
//!
//! Without one the tests are skipped with a note. As root, in a guest or not:
//! `ip link add vcan0 type vcan && ip link set vcan0 up`. Some parts take it down and up again.
#![cfg(target_os = "linux")]

use std::time::{Duration, Instant};
use std::{process::Command, thread};

use boards::links::can::{Can, CanMode};
use boards::links::{BusSide, Health, Link as _, RecvError, SendError, WireState};
use firmware_protocol::{MAX_FRAME, key::BoardId};
use socketcan::{CanErrorFrame, CanFdSocket, Socket as _};

use super::serial_pty::{number, soon, tell};

const MODES: [CanMode; 2] = [CanMode::Fd, CanMode::Classic];

/// One test, since all parts share one interface and leave it as they found it.
#[test]
fn on_a_virtual_interface_the_driver_keeps_its_promises() {
    let Ok(name) = std::env::var("LETOFF_CAN") else {
        return tell("SKIPPED: LETOFF_CAN names no CAN interface: the driver was not tested");
    };
    each_side_hears_what_is_for_it(&name);
    reports_become_health(&name);
    for mode in MODES {
        a_reader_that_stops_reading_loses_whole_frames(&name, mode);
        a_bus_that_is_full_takes_frames_whole_or_not_at_all(&name, mode);
    }
    eight_boards_send_without_a_gap(&name, CanMode::Fd, 1_000);
    // Rates that a real bus of 1 Mbit/s carries.
    eight_boards_send_without_a_gap(&name, CanMode::Classic, 60);
    an_interface_that_goes_down_says_so_and_works_again(&name);
    an_interface_without_fd_says_what_to_do(&name);
}

fn each_side_hears_what_is_for_it(name: &str) {
    for mode in MODES {
        let mut host = open(name, mode, BusSide::Host);
        let mut boards = [3, 4].map(|number| open(name, mode, board(number)));
        // Stop, identify, forces for 3, multicast forces, request for 4.
        for head in [[0x0F, 1], [0x0F, 3], [0x23, 0], [0x42, 0], [0x84, 0]] {
            host.try_send(&[head[0], head[1], 7, 7, 7, 7, 7, 7]).expect("there is room");
        }
        let firsts = |link: &mut Can, n| -> Vec<u8> {
            (0..n).map(|_| soon(|| recv(link).expect("a frame"))[0]).collect()
        };
        assert_eq!(firsts(&mut boards[0], 4), [0x0F, 0x0F, 0x23, 0x42]);
        assert_eq!(firsts(&mut boards[1], 4), [0x0F, 0x0F, 0x42, 0x84]);
        for link in &mut boards {
            link.try_send(&samples(5, 1)).expect("there is room");
            assert_eq!(recv(link), Ok(None), "a board hears itself or another one");
        }
        assert_eq!(firsts(&mut host, 2), [0x65, 0x65]);
        assert_eq!(recv(&mut host), Ok(None), "the host hears itself");
    }
}

fn reports_become_health(name: &str) {
    let mut host = open(name, CanMode::Fd, BusSide::Host);
    let controller = CanFdSocket::open(name).expect("it opens");
    let mut health = |class, data: [u8; 8]| {
        let report = CanErrorFrame::new_error(class, &data).expect("a report");
        let before = host.health().reports;
        controller.write_frame(&report).expect("there is room");
        soon(|| {
            assert_eq!(recv(&mut host), Ok(None), "a report is no frame");
            (before < host.health().reports).then(|| host.health())
        })
    };
    assert_eq!(health(0x040, [0; 8]).state, WireState::Off);
    let passive = health(0x004, [0, 0x10, 0, 0, 0, 0, 0x88, 0]);
    assert_eq!((passive.state, passive.transmit_errors), (WireState::Passive, 136));
    let again = health(0x101, [0; 8]);
    assert_eq!((again.state, again.restarts, again.reports), (WireState::Active, 1, 3));
}

fn a_reader_that_stops_reading_loses_whole_frames(name: &str, mode: CanMode) {
    let (mut host, mut board) = (open(name, mode, BusSide::Host), open(name, mode, board(3)));
    let mut sent = 0;
    while sent < 5_000 && board.try_send(&samples(3, sent)) == Ok(()) {
        sent += 1;
    }
    // A virtual bus has no queue: frames that overflow the reader's socket are lost there.
    let (mut arrived, mut last) = (0_u32, None);
    loop {
        match recv(&mut host) {
            Ok(None) => break,
            Ok(Some(frame)) => {
                let number = number(&frame);
                assert_eq!(frame, samples(3, number));
                assert!(last < Some(number));
                (arrived, last) = (arrived + 1, Some(number));
            }
            Err(error) => assert_eq!(error, RecvError::Corrupt),
        }
    }
    assert!(0 < arrived);
    tell(&format!(
        "MEASURED: {mode:?}: a reader that does not read keeps {arrived} of {sent} frames"
    ));
    board.try_send(&samples(3, sent)).expect("there is room");
    assert_eq!(soon(|| recv(&mut host).ok().flatten()), samples(3, sent));
}

/// Needs a queue: `insmod vcan.ko echo=1`, and `tc`.
fn a_bus_that_is_full_takes_frames_whole_or_not_at_all(name: &str, mode: CanMode) {
    let slow = ["root", "tbf", "rate", "1mbit", "burst", "256", "limit", "2000"];
    if !run("tc", &[&["qdisc", "add", "dev", name][..], &slow].concat()) {
        return tell("SKIPPED: `tc qdisc add` is not possible: a full bus was not tested");
    }
    let (mut host, mut board) = (open(name, mode, BusSide::Host), open(name, mode, board(3)));
    let (mut taken, mut refused) = (Vec::new(), 0);
    for number in 0..300 {
        match board.try_send(&samples(3, number)) {
            Ok(()) => taken.push(number),
            Err(error) => {
                assert_eq!(error, SendError::Full);
                refused += 1;
            }
        }
    }
    for number in &taken {
        let got = soon(|| {
            // Any call to the board sends the rest of its frame.
            assert_eq!(recv(&mut board), Ok(None));
            recv(&mut host).expect("whole frames")
        });
        assert_eq!(got, samples(3, *number));
    }
    assert!(run("tc", &["qdisc", "del", "dev", name, "root"]));
    assert_eq!(board.dropped(), refused);
    let taken = taken.len();
    tell(&match refused {
        0 => {
            "SKIPPED: the interface has no queue (vcan without echo=1): it is never full".to_owned()
        }
        _ => format!("MEASURED: {mode:?}: of 300 frames a full bus took {taken}, all whole"),
    });
}

fn eight_boards_send_without_a_gap(name: &str, mode: CanMode, hertz: u32) {
    const BOARDS: usize = 8;
    let mut host = open(name, mode, BusSide::Host);
    let start = Instant::now();
    let mut next = [0; BOARDS];
    thread::scope(|scope| {
        for number in 0_u8..8 {
            let mut link = open(name, mode, board(number));
            scope.spawn(move || send_for_a_second(&mut link, number, hertz));
        }
        soon(|| {
            while let Some(frame) = recv(&mut host).expect("whole frames") {
                let board = usize::from(frame[0] & 0x0F);
                assert_eq!(frame, samples(frame[0] & 0x0F, next[board]), "a gap");
                next[board] += 1;
            }
            (next == [hertz; BOARDS]).then_some(())
        });
    });
    let rate = f64::from(hertz) / start.elapsed().as_secs_f64();
    tell(&format!("MEASURED: {mode:?}: 8 boards, {rate:.0} frames/s each, none lost"));
    assert_eq!(host.health(), Health::default());
}

/// Does not catch up after a pause: a socket holds only 278 unread frames.
fn send_for_a_second(link: &mut Can, board: u8, hertz: u32) {
    for number in 0..hertz {
        let due = Instant::now() + Duration::from_secs(1) / hertz;
        assert_eq!(link.try_send(&samples(board, number)), Ok(()));
        thread::sleep(due.saturating_duration_since(Instant::now()));
    }
}

fn an_interface_that_goes_down_says_so_and_works_again(name: &str) {
    for mode in MODES {
        let (mut host, mut board) = (open(name, mode, BusSide::Host), open(name, mode, board(3)));
        if !ip(&["link", "set", name, "down"]) {
            return tell("SKIPPED: `ip link set down` is not allowed: it was not tested");
        }
        assert_eq!(board.try_send(&samples(3, 0)), Err(SendError::Down));
        assert_eq!(recv(&mut host), Err(RecvError::Down));
        assert_eq!(recv(&mut host), Ok(None));
        let sentence = Can::open(name, mode, BusSide::Host).expect_err("it is down").to_string();
        let command = format!("bring it up: sudo ip link set {name} up");
        assert!(sentence.contains(&command), "{sentence}");
        assert!(ip(&["link", "set", name, "up"]));
        board.try_send(&samples(3, 1)).expect("it is up");
        assert_eq!(soon(|| recv(&mut host).expect("a frame")), samples(3, 1));
    }
}

fn an_interface_without_fd_says_what_to_do(name: &str) {
    let mut open_already = open(name, CanMode::Fd, board(3));
    let set_mtu = |mtu| {
        ip(&["link", "set", name, "down"])
            && ip(&["link", "set", name, "mtu", mtu])
            && ip(&["link", "set", name, "up"])
    };
    if !set_mtu("16") {
        return tell("SKIPPED: `ip link set mtu` is not allowed: it was not tested");
    }
    let sentence = Can::open(name, CanMode::Fd, BusSide::Host).expect_err("no FD").to_string();
    let command = format!("sudo ip link set {name} down && sudo ip link set {name} mtu 72");
    assert!(sentence.contains(&command), "{sentence}");
    assert_eq!(open_already.try_send(&samples(3, 0)), Err(SendError::Down));
    let (mut host, mut board) =
        (open(name, CanMode::Classic, BusSide::Host), open(name, CanMode::Classic, board(3)));
    board.try_send(&samples(3, 1)).expect("there is room");
    assert_eq!(soon(|| recv(&mut host).expect("a frame")), samples(3, 1));
    assert!(set_mtu("72"));
}

fn open(name: &str, mode: CanMode, side: BusSide) -> Can {
    Can::open(name, mode, side).expect("LETOFF_CAN is a virtual interface that is up")
}

fn board(number: u8) -> BusSide {
    BusSide::Board(BoardId::new(number).expect("a board"))
}

fn samples(board: u8, number: u32) -> Vec<u8> {
    let mut frame = vec![0x60 | board; 48];
    frame[1..5].copy_from_slice(&number.to_le_bytes());
    frame
}

fn recv(link: &mut Can) -> Result<Option<Vec<u8>>, RecvError> {
    let mut buffer = [0; MAX_FRAME];
    Ok(link.try_recv(&mut buffer)?.map(|len| buffer[..len].to_vec()))
}

fn ip(arguments: &[&str]) -> bool {
    run("ip", arguments)
}

fn run(program: &str, arguments: &[&str]) -> bool {
    Command::new(program).args(arguments).status().is_ok_and(|status| status.success())
}
