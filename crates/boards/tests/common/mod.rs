//! Simulated boards in real time, on sockets of this process.
#![allow(clippy::unnecessary_wraps, reason = "what the keybed calls")]

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use std::{os::unix::net::UnixDatagram, sync::Arc, thread::JoinHandle};

use boards::calibration::KeyCalibration;
use boards::keybed::{Armed, FoundBoard, Keybed, NamedLink, Offline, Terms, WantedBoards};
use boards::links::{HostClock, Link, RecvError, SendError};
use boards::refusal::{BoardName, Refusal};
use boards::sim::board::{BoardMake, SimulatedBoard};
use firmware_protocol::frame::{key_forces::ForcePacking, key_samples::SamplePacking};
use firmware_protocol::key::{BoardId, PerKey};
use haptics::plant::RigParameters;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus as _;

pub fn now_us() -> u64 {
    static BEGAN: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    let passed = BEGAN.get_or_init(Instant::now).elapsed();
    1_000_000 + u64::try_from(passed.as_micros()).expect("a short test")
}

pub fn clock() -> HostClock {
    HostClock::Monotonic(now_us)
}

/// Frames over a pair of datagram sockets.
#[derive(Debug)]
pub struct Socket(UnixDatagram);

pub fn pair() -> (Socket, Socket) {
    let (one, other) = UnixDatagram::pair().expect("sockets");
    for end in [&one, &other] {
        end.set_nonblocking(true).expect("a socket that does not wait");
    }
    (Socket(one), Socket(other))
}

impl Link for Socket {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        match self.0.send(frame) {
            Ok(_) => Ok(()),
            Err(error) if error.kind() == std::io::ErrorKind::WouldBlock => Err(SendError::Full),
            Err(_) => Err(SendError::Down),
        }
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        match self.0.recv(buffer) {
            Ok(len) => Ok(Some(len)),
            Err(error) if error.kind() == std::io::ErrorKind::WouldBlock => Ok(None),
            Err(_) => Err(RecvError::Down),
        }
    }
}

/// A simulated board that runs on a thread until it is dropped.
pub struct Living {
    stop: Arc<AtomicBool>,
    thread: Option<JoinHandle<SimulatedBoard>>,
}

impl Living {
    pub fn start(mut board: SimulatedBoard, mut link: impl Link + Send + 'static) -> Self {
        let stop = Arc::new(AtomicBool::new(false));
        let its_stop = Arc::clone(&stop);
        let thread = std::thread::spawn(move || {
            let began = Instant::now();
            let period = board.make().period;
            while !its_stop.load(Ordering::Acquire) {
                let tick = (began.elapsed().as_secs_f64() / period) as u64;
                board.advance(tick, &mut link);
                std::thread::sleep(Duration::from_micros(300));
            }
            board
        });
        Self { stop, thread: Some(thread) }
    }

    pub fn stop(mut self) -> SimulatedBoard {
        self.stop.store(true, Ordering::Release);
        self.thread.take().expect("it lives").join().expect("it lives well")
    }
}

impl Drop for Living {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Release);
        if let Some(thread) = self.thread.take() {
            let _stopped = thread.join();
        }
    }
}

pub fn board(number: u8) -> SimulatedBoard {
    let id = BoardId::new(number).expect("a board");
    let make = BoardMake::standard(id, 100e-6, RigParameters::default());
    SimulatedBoard::new(make).expect("a possible board")
}

pub fn keybed(numbers: &[u8]) -> (Keybed<Offline>, Vec<Living>) {
    let (mut lines, mut boards) = (Vec::new(), Vec::new());
    for number in numbers {
        let (host, away) = pair();
        lines.push(NamedLink::new(format!("socket {number}"), Box::new(host)));
        boards.push(Living::start(board(*number), away));
    }
    (Keybed::new(lines, clock()), boards)
}

pub fn nominal(found: &FoundBoard, _name: &BoardName) -> Result<PerKey<KeyCalibration>, Refusal> {
    let n = usize::from(found.hello.n_keys);
    Ok(PerKey::collect(std::iter::repeat_n(found.nominal(), n)))
}

pub const PATIENCE: u64 = 5_000_000;

pub fn wanted() -> WantedBoards {
    WantedBoards { hz: 1_000, ..WantedBoards::default() }
}

pub fn terms() -> Terms {
    let (samples, forces) = (SamplePacking::default(), ForcePacking::default());
    Terms { period_us: 1_000, samples, forces, valid_ms: 100 }
}

pub fn armed(keybed: Keybed<Offline>) -> Keybed<Armed> {
    let identified = keybed.identify(PATIENCE).expect("boards");
    let calibrated = identified.calibrate(&wanted(), nominal).expect("good boards");
    calibrated.arm(terms(), PATIENCE).expect("boards that can be armed")
}

pub fn exchange(
    keybed: &mut Keybed<Armed>,
    from: u64,
    ticks: u64,
    force: f64,
) -> [KeySample; KEYS] {
    let mut samples = [KeySample::default(); KEYS];
    for tick in from..from + ticks {
        keybed.receive(tick, &mut samples);
        keybed.send(tick, &[force; KEYS], &[KeySlope::HELD; KEYS]);
        std::thread::sleep(Duration::from_millis(1));
    }
    samples
}
