//! The real serial driver on pseudo-terminals: rates, order, and ends that leave or stop reading.
//!
//! Counts are asserted; times depend on the machine and are only printed.
#![cfg(unix)]

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use std::{io::Write as _, path::Path, thread};

use boards::links::serial::{Pty, Serial};
use boards::links::wire::{Wire, WirePlan};
use boards::links::{Link, RecvError, SendError};
use firmware_protocol::MAX_FRAME;

const BAUD: u32 = 1_000_000;
/// Length of most frames: samples of eleven keys with 24 bits each.
const LEN: usize = 37;
const PATIENCE: Duration = Duration::from_secs(20);
const TRIES: u32 = 200_000;

#[test]
fn eight_boards_at_1_khz_answer_every_frame_in_order() {
    const BOARDS: usize = 8;
    const FRAMES: u32 = 2_000;
    let (mut boards, mut hosts) = (Vec::new(), Vec::new());
    for _ in 0..BOARDS {
        let Pty { board, path } = Pty::open().unwrap();
        hosts.push(Answered::new(open(&path)));
        boards.push(board);
    }
    let over = AtomicBool::new(false);
    let (seconds, heard) = thread::scope(|scope| {
        let end = End(&over);
        let echo = |board| {
            let over = &over;
            scope.spawn(move || echo(board, over))
        };
        let boards: Vec<_> = boards.into_iter().map(echo).collect();
        let start = Instant::now();
        for number in 0..FRAMES {
            for host in &mut hosts {
                host.ask(number);
            }
            let due = start + Duration::from_millis(1) * (number + 1);
            while Instant::now() < due {
                hosts.iter_mut().for_each(Answered::listen);
                thread::sleep(Duration::from_micros(50));
            }
        }
        let seconds = start.elapsed().as_secs_f64();
        listen_for(&mut hosts, FRAMES);
        drop(end);
        (seconds, boards.into_iter().map(|board| board.join().unwrap()).collect::<Vec<_>>())
    });
    let (mut trips, mut answers, mut waits) = (Vec::new(), 0, 0);
    for host in hosts {
        assert_eq!(host.next, FRAMES);
        answers += host.next;
        waits += host.link.dropped();
        trips.extend(host.trips);
    }
    assert_eq!(heard, [FRAMES; BOARDS]);
    tell(&format!(
        "MEASURED: 8 boards on pseudo-terminals: {:.0} frames/s each way and board, {waits} times full, {}",
        f64::from(answers) / BOARDS as f64 / seconds,
        quantiles(trips)
    ));
}

#[test]
fn a_port_whose_other_end_is_gone_is_down_and_opens_again() {
    let pty = Pty::open().unwrap();
    let mut host = open(&pty.path);
    drop(pty);
    assert_eq!(soon(|| host.try_recv(&mut [0; MAX_FRAME]).err()), RecvError::Down);
    assert_eq!(host.try_send(&[1]), Err(SendError::Down));
    // The next board may have the same path.
    drop(host);
    let Pty { mut board, path } = Pty::open().unwrap();
    let mut host = open(&path);
    check_passes(&mut board, &mut host);
    let wire = Wire::open(WirePlan::default()).unwrap();
    let mut host = open(wire.host());
    drop(wire);
    assert_eq!(soon(|| host.try_recv(&mut [0; MAX_FRAME]).err()), RecvError::Down);
}

#[test]
fn a_board_outlives_its_clients() {
    let Pty { mut board, path } = Pty::open().unwrap();
    for _ in 0..3 {
        assert_eq!(board.try_recv(&mut [0; MAX_FRAME]), Ok(None));
        let mut host = open(&path);
        check_passes(&mut board, &mut host);
        check_passes(&mut host, &mut board);
        // The frame below reaches no host and is discarded when the next one opens the port.
        drop(host);
        board.try_send(&numbered(99)).unwrap();
    }
}

#[test]
fn a_reader_that_stops_reading_fills_the_port_and_costs_whole_frames_only() {
    let Pty { mut board, path } = Pty::open().unwrap();
    let mut host = open(&path);
    for round in 0..3 {
        let mut sent = 0;
        while host.try_send(&numbered(sent)) == Ok(()) {
            sent += 1;
            assert!(sent < 1_000_000, "the port has no end");
        }
        assert_eq!(host.try_send(&numbered(sent)), Err(SendError::Full));
        assert_eq!(host.dropped(), 2 * (round + 1));
        for number in 0..sent {
            let got = soon(|| {
                // Any call to the host sends the rest of its frame.
                let _nothing = host.try_recv(&mut [0; MAX_FRAME]);
                recv(&mut board)
            });
            assert_eq!(got, numbered(number));
        }
        check_passes(&mut host, &mut board);
    }
}

#[test]
fn on_a_wire_that_loses_bytes_every_frame_that_arrives_was_sent_and_the_next_is_whole() {
    const FRAMES: u32 = 5_000;
    let plan = WirePlan { seed: 1, loss: 0.001, ..WirePlan::default() };
    let wire = Wire::open(plan).unwrap();
    let (mut host, mut board) = (open(wire.host()), open(wire.board()));
    let (mut next, mut arrived, mut corrupt) = (0, 0_u64, 0_u64);
    let mut listen = || {
        let mut buffer = [0; MAX_FRAME];
        match board.try_recv(&mut buffer) {
            Ok(None) => return false,
            Ok(Some(len)) => {
                let number = number(&buffer[..len]);
                assert_eq!(buffer[..len], numbered(number));
                assert!(next <= number && number < FRAMES, "{number} after {next}");
                next = number + 1;
                arrived += 1;
            }
            Err(error) => {
                assert_eq!(error, RecvError::Corrupt);
                corrupt += 1;
            }
        }
        true
    };
    for number in 0..FRAMES {
        soon(|| host.try_send(&numbered(number)).ok());
        while listen() {}
    }
    let sent = u64::from(FRAMES) * (LEN as u64 + 4);
    soon(|| {
        let _nothing = host.try_recv(&mut [0; MAX_FRAME]);
        let counts = wire.counts();
        (!listen() && counts.passed + counts.lost == sent).then_some(())
    });
    while listen() {}
    let (lost_bytes, lost_frames) = (wire.counts().lost, u64::from(FRAMES) - arrived);
    tell(&format!(
        "MEASURED: 0.1 % of bytes lost: {lost_bytes} of {sent} bytes, {lost_frames} of {FRAMES} frames"
    ));
    // Five standard deviations of a binomial with n p q = 205.
    assert!(lost_bytes.abs_diff(sent / 1_000) < 72, "{lost_bytes}");
    // A lost byte spoils its frame; a lost zero also spoils the next one, never more.
    assert!(corrupt <= lost_bytes && lost_frames <= 2 * lost_bytes);
    assert!(lost_bytes / 2 < lost_frames, "{lost_frames}");
}

#[test]
fn a_wire_that_is_cut_is_silent_and_carries_again_when_it_is_mended() {
    let wire = Wire::open(WirePlan::default()).unwrap();
    let (mut host, mut board) = (open(wire.host()), open(wire.board()));
    wire.cut();
    host.try_send(&numbered(7)).unwrap();
    let sent = LEN as u64 + 4;
    soon(|| (wire.counts().lost == sent).then_some(()));
    assert_eq!(board.try_recv(&mut [0; MAX_FRAME]), Ok(None));
    wire.mend();
    check_passes(&mut host, &mut board);
}

fn open(path: &Path) -> Serial {
    Serial::open(path, BAUD).expect("the port opens")
}

fn numbered(number: u32) -> [u8; LEN] {
    let mut frame = [0; LEN];
    frame[0] = 0x63;
    for (place, byte) in frame[1..].iter_mut().zip(number.to_le_bytes().into_iter().cycle()) {
        *place = byte;
    }
    frame
}

pub(super) fn number(frame: &[u8]) -> u32 {
    let bytes = frame.get(1..).and_then(<[u8]>::first_chunk).expect("a frame with a number");
    u32::from_le_bytes(*bytes)
}

#[track_caller]
pub(super) fn soon<T>(mut ask: impl FnMut() -> Option<T>) -> T {
    let (start, mut tries) = (Instant::now(), 0);
    while start.elapsed() < PATIENCE || tries < TRIES {
        if let Some(answer) = ask() {
            return answer;
        }
        tries += 1;
        thread::yield_now();
    }
    ask().expect("it comes in time")
}

#[track_caller]
fn recv(link: &mut impl Link) -> Option<Vec<u8>> {
    let mut buffer = [0; MAX_FRAME];
    let len = link.try_recv(&mut buffer).expect("a whole frame or none")?;
    Some(buffer[..len].to_vec())
}

#[track_caller]
fn check_passes(from: &mut impl Link, to: &mut impl Link) {
    assert_eq!(from.try_send(&numbered(0x1234_5678)), Ok(()));
    assert_eq!(soon(|| recv(to)), numbered(0x1234_5678));
}

fn echo(mut board: impl Link, over: &AtomicBool) -> u32 {
    let mut next = 0;
    while !over.load(Ordering::Relaxed) {
        while let Some(frame) = recv(&mut board) {
            assert_eq!(number(&frame), next);
            next += 1;
            // A machine that stands still for a third of a second fills a pseudo-terminal.
            soon(|| board.try_send(&frame).ok());
        }
        thread::sleep(Duration::from_micros(50));
    }
    next
}

struct End<'a>(&'a AtomicBool);

impl Drop for End<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

struct Answered {
    link: Serial,
    asked: Vec<Instant>,
    next: u32,
    trips: Vec<Duration>,
}

impl Answered {
    fn new(link: Serial) -> Self {
        Self { link, asked: Vec::new(), next: 0, trips: Vec::new() }
    }

    fn ask(&mut self, number: u32) {
        self.asked.push(Instant::now());
        soon(|| {
            self.listen();
            self.link.try_send(&numbered(number)).ok()
        });
    }

    fn listen(&mut self) {
        while let Some(frame) = recv(&mut self.link) {
            assert_eq!(frame, numbered(self.next));
            self.trips.push(self.asked[self.next as usize].elapsed());
            self.next += 1;
        }
    }
}

fn listen_for(hosts: &mut [Answered], n: u32) {
    soon(|| {
        hosts.iter_mut().for_each(Answered::listen);
        hosts.iter().all(|host| host.next == n).then_some(())
    });
}

fn quantiles(mut trips: Vec<Duration>) -> String {
    trips.sort_unstable();
    let [half, most] = [trips.len() / 2, trips.len() * 99 / 100].map(|i| trips[i].as_micros());
    format!("round trip p50 {half} us, p99 {most} us")
}

pub(super) fn tell(what: &str) {
    let _unheard = writeln!(std::io::stderr(), "{what}");
}
