//! The reference firmware in an emulated Cortex-M3, and a host that talks to it.

use std::collections::VecDeque;
use std::io::{ErrorKind, Read as _, Write as _};
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use firmware_protocol::acyclic::arm::{Arm, Disarmed};
use firmware_protocol::acyclic::counters::Counters;
use firmware_protocol::acyclic::stream::Stream;
use firmware_protocol::acyclic::{AcyclicReply, Operation, Status, encode_request};
use firmware_protocol::frame::FrameKind;
use firmware_protocol::frame::broadcast::{self, Broadcast};
use firmware_protocol::frame::hello::Introduction;
use firmware_protocol::frame::key_forces::{ForcePacking, KeyForces, KeySlopes};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout, SamplePacking};
use firmware_protocol::key::{BoardId, PerKey};
use firmware_protocol::quantity::Millinewtons;
use firmware_protocol::serial::{self, Deframer};
use firmware_protocol::version::PROTOCOL_VERSION;
use firmware_protocol::{MAX_FRAME, Nothing, Record};

use super::tools::{STRICT, are_there, crate_root, run, say, scratch};

/// Number of the board: not the first, so that the number must travel.
pub(crate) const BOARD: u8 = 2;
pub(crate) const KEYS: usize = 11;
pub(crate) const PACKING: SamplePacking = SamplePacking::Position24Velocity;
/// Timeout of every wait: the machine may be busy.
const PATIENCE: Duration = Duration::from_secs(10);

const TOOLS: [&str; 3] = ["arm-none-eabi-gcc", "arm-none-eabi-size", "qemu-system-arm"];
const CPU_HZ: u32 = 12_500_000;
/// Factor by which a slow board's clock is slower than the host's.
pub(crate) const SLOW: u32 = 4;

/// Runs the README's build command for board [`BOARD`], with a clock `slow` times too slow.
fn build(slow: u32) -> PathBuf {
    let elf = scratch(&format!("board_{slow}_{}.elf", std::process::id()));
    let folder = crate_root().join("c/firmware");
    let mut gcc = Command::new("arm-none-eabi-gcc");
    gcc.args(["-mcpu=cortex-m3", "-mthumb", "-O2", "-ffreestanding", "-ffunction-sections"]);
    gcc.args(STRICT).args(["-Wdouble-promotion", "-nostartfiles", "-Wl,--gc-sections"]);
    gcc.arg(format!("-DCPU_HZ={}u", slow * CPU_HZ));
    gcc.arg(format!("-DBOARD={BOARD}")).arg("-T").arg(folder.join("link.ld"));
    gcc.args(sources(&folder)).arg(crate_root().join("c/letoff_codec.c"));
    run(gcc.args(["--specs=nano.specs", "--specs=nosys.specs", "-lc", "-lgcc", "-o"]).arg(&elf));
    let size = run(Command::new("arm-none-eabi-size").arg(&elf)).stdout;
    say(&String::from_utf8_lossy(&size));
    elf
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let files = std::fs::read_dir(folder).expect("the firmware");
    let mut files: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    files.retain(|path| path.extension().is_some_and(|end| end == "c"));
    files.sort();
    files
}

pub(crate) struct Board {
    qemu: Child,
    stream: UnixStream,
    deframer: Deframer,
    frames: VecDeque<Vec<u8>>,
    next_id: u8,
}

impl Drop for Board {
    fn drop(&mut self) {
        let _already_gone = self.qemu.kill();
        let _status = self.qemu.wait();
    }
}

impl Board {
    pub(crate) fn start(name: &str) -> Option<Self> {
        static ELF: OnceLock<Option<PathBuf>> = OnceLock::new();
        let elf = ELF.get_or_init(|| are_there(&TOOLS).then(|| build(1))).as_ref()?;
        Some(Self::start_built(name, elf))
    }

    /// Starts a board with a clock [`SLOW`] times too slow: its 100 ms are 400 ms of the host, so
    /// that a busy machine does not look like a silent host.
    pub(crate) fn start_slow(name: &str) -> Option<Self> {
        static ELF: OnceLock<Option<PathBuf>> = OnceLock::new();
        let elf = ELF.get_or_init(|| are_there(&TOOLS).then(|| build(SLOW))).as_ref()?;
        Some(Self::start_built(name, elf))
    }

    fn start_built(name: &str, elf: &Path) -> Self {
        // The path of a socket must be short.
        let socket = std::env::temp_dir().join(format!("fw-{}-{name}", std::process::id()));
        let mut qemu = Command::new("qemu-system-arm");
        qemu.args(["-M", "lm3s6965evb", "-display", "none", "-monitor", "none", "-kernel"]);
        qemu.arg(elf).args(["-serial", "chardev:link", "-chardev"]);
        qemu.arg(format!("socket,id=link,path={},server=on,wait=off", socket.display()));
        let qemu = qemu.stdin(Stdio::null()).stderr(Stdio::null()).spawn().expect("QEMU starts");
        let stream = connect(&socket);
        stream.set_read_timeout(Some(Duration::from_millis(2))).expect("a timeout");
        let _socket_is_open = std::fs::remove_file(&socket);
        let (deframer, frames) = (Deframer::default(), VecDeque::new());
        let mut board = Self { qemu, stream, deframer, frames, next_id: 0 };
        board.introduction();
        board
    }

    pub(crate) fn id() -> BoardId {
        BoardId::new(BOARD).expect("a board")
    }

    pub(crate) fn send_raw(&mut self, bytes: &[u8]) {
        self.stream.write_all(bytes).expect("the board reads");
    }

    pub(crate) fn send(&mut self, frame: &[u8]) {
        self.send_raw(&wire(frame));
    }

    pub(crate) fn broadcast(&mut self, broadcast: Broadcast) {
        let mut bytes = [0; broadcast::MAX_LEN];
        let len = broadcast.encode(&mut bytes);
        self.send(&bytes[..len]);
    }

    /// Reads for at most 2 ms.
    fn poll(&mut self) {
        let mut bytes = [0; 4096];
        let n = match self.stream.read(&mut bytes) {
            Ok(n) => n,
            Err(why) if matches!(why.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => 0,
            Err(why) => panic!("the board is gone: {why}"),
        };
        for byte in &bytes[..n] {
            if let Some(frame) = self.deframer.push(*byte) {
                self.frames.push_back(frame.expect("the board's frames are whole").to_vec());
            }
        }
    }

    /// Waits for a frame of `kind` that `wanted` accepts; drops others of this kind.
    fn next<T>(
        &mut self,
        kind: FrameKind,
        wait: Duration,
        wanted: impl Fn(&[u8]) -> Option<T>,
    ) -> Option<T> {
        let end = Instant::now() + wait;
        loop {
            if let Some(frame) = self.take(kind) {
                match wanted(&frame) {
                    Some(found) => return Some(found),
                    None => continue,
                }
            }
            if end < Instant::now() {
                return None;
            }
            self.poll();
        }
    }

    fn take(&mut self, kind: FrameKind) -> Option<Vec<u8>> {
        let at = self.frames.iter().position(|frame| FrameKind::of(frame) == Some(kind))?;
        self.frames.remove(at)
    }

    pub(crate) fn introduction(&mut self) -> Introduction {
        let end = Instant::now() + PATIENCE;
        while Instant::now() < end {
            self.frames.retain(|frame| FrameKind::of(frame) != Some(FrameKind::Hello));
            self.broadcast(Broadcast::WhoIsThere { version: PROTOCOL_VERSION });
            let hello = |frame: &[u8]| Introduction::decode(frame).ok();
            if let Some(found) = self.next(FrameKind::Hello, Duration::from_millis(200), hello) {
                return found;
            }
        }
        panic!("the board never said hello");
    }

    pub(crate) fn ask_with_id<R: Record>(
        &mut self,
        id: u8,
        operation: Operation,
        record: &R,
    ) -> (Status, Vec<u8>) {
        let mut bytes = [0; MAX_FRAME];
        let len = encode_request(Self::id(), id, operation, record, &mut bytes);
        let end = Instant::now() + PATIENCE;
        while Instant::now() < end {
            self.send(&bytes[..len]);
            let reply = |frame: &[u8]| {
                let reply = AcyclicReply::decode(frame).expect("a reply");
                let ours = reply.id == id && reply.operation == Ok(operation);
                ours.then(|| (reply.status, reply.record.to_vec()))
            };
            if let Some(found) = self.next(FrameKind::Reply, Duration::from_millis(200), reply) {
                return found;
            }
        }
        panic!("{operation:?} was never answered");
    }

    pub(crate) fn ask<R: Record>(&mut self, operation: Operation, record: &R) -> (Status, Vec<u8>) {
        self.next_id = self.next_id.wrapping_add(1);
        self.ask_with_id(self.next_id, operation, record)
    }

    pub(crate) fn raw_reply(&mut self) -> Vec<u8> {
        let any = |frame: &[u8]| Some(frame.to_vec());
        self.next(FrameKind::Reply, PATIENCE, any).expect("a reply")
    }

    pub(crate) fn get<R: Record, A: Record>(&mut self, operation: Operation, record: &R) -> A {
        let (status, record) = self.ask(operation, record);
        assert_eq!(status, Status::Done, "{operation:?}");
        A::take(&record).expect("its record")
    }

    pub(crate) fn counters(&mut self) -> Counters {
        self.get(Operation::Counters, &Nothing)
    }

    pub(crate) fn stream(&mut self, period_us: u16) {
        let stream = Stream { period_us, packing: PACKING as u8, phase_us: 0 };
        self.get::<_, Nothing>(Operation::Stream, &stream);
        self.frames.clear();
    }

    pub(crate) fn disarm(&mut self) -> u32 {
        self.get::<_, Disarmed>(Operation::Disarm, &Nothing).nonce
    }

    pub(crate) fn arm_with(&mut self, nonce: u32, packing: ForcePacking, valid_ms: u8) -> Status {
        let arm = Arm { nonce, packing: packing as u8, valid_ms };
        self.ask(Operation::Arm, &arm).0
    }

    pub(crate) fn arm(&mut self, packing: ForcePacking) {
        let nonce = self.disarm();
        assert_eq!(self.arm_with(nonce, packing, 100), Status::Done);
        // Answers to old samples would be late.
        self.frames.clear();
    }

    pub(crate) fn samples(&mut self) -> KeySamples {
        let layout = SampleLayout { packing: PACKING, n_keys: KEYS };
        let read = |frame: &[u8]| Some(KeySamples::decode(frame, layout).expect("samples"));
        self.next(FrameKind::KeySamples, PATIENCE, read).expect("samples come")
    }

    pub(crate) fn newest_samples(&mut self) -> KeySamples {
        let mut newest = self.samples();
        while self.frames.iter().any(|frame| FrameKind::of(frame) == Some(FrameKind::KeySamples)) {
            newest = self.samples();
        }
        newest
    }

    /// Drops waiting frames, so that the next samples are new.
    pub(crate) fn skip(&mut self) {
        self.poll();
        self.frames.clear();
    }

    pub(crate) fn answer(&mut self, samples: &KeySamples, millinewtons: i32) {
        let forces = PerKey::collect([Millinewtons::saturating(millinewtons); KEYS]);
        self.answer_with(samples, forces, PerKey::default());
    }

    pub(crate) fn answer_with(
        &mut self,
        samples: &KeySamples,
        forces: PerKey<Millinewtons>,
        slopes: PerKey<KeySlopes>,
    ) {
        let mut header = samples.header;
        header.flag = false;
        let mut bytes = [0; MAX_FRAME];
        let len = KeyForces { header, forces, slopes }.encode(&mut bytes);
        self.send(&bytes[..len]);
    }

    pub(crate) fn hold(&mut self, n: usize, millinewtons: i32) -> KeySamples {
        let mut last = self.samples();
        for _ in 0..n {
            self.answer(&last, millinewtons);
            last = self.newest_samples();
        }
        last
    }
}

pub(crate) fn wire(frame: &[u8]) -> Vec<u8> {
    let mut wire = [0; serial::MAX_WIRE];
    let len = serial::encode(frame, &mut wire).expect("a frame that links carry");
    wire[..len].to_vec()
}

pub(crate) fn position(samples: &KeySamples) -> i32 {
    samples.positions.as_slice()[0].get()
}

fn connect(socket: &Path) -> UnixStream {
    let end = Instant::now() + PATIENCE;
    loop {
        match UnixStream::connect(socket) {
            Ok(stream) => return stream,
            Err(why) => assert!(Instant::now() < end, "QEMU opens no socket: {why}"),
        }
        std::thread::sleep(Duration::from_millis(10));
    }
}
