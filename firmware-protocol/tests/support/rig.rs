//! The fault rig in virtual time, and a host that answers its samples.

use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use firmware_protocol::acyclic::arm::{Arm, Disarmed};
use firmware_protocol::acyclic::stream::Stream;
use firmware_protocol::acyclic::{AcyclicReply, Operation, Status, encode_request};
use firmware_protocol::frame::FrameKind;
use firmware_protocol::frame::hello::{Hello, Introduction};
use firmware_protocol::frame::key_forces::{ForcePacking, KeyForces};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout, SamplePacking};
use firmware_protocol::key::{BoardId, PerKey};
use firmware_protocol::quantity::Millinewtons;
use firmware_protocol::serial::{self, Deframer, FramingError};
use firmware_protocol::{MAX_FRAME, Nothing, Record};

use crate::tools::{STRICT, are_there, crate_root, run, scratch};

pub(crate) const KEYS: usize = 4;
pub(crate) const TICK_US: u64 = 1_000;
/// The host's time when the board is switched on (us).
pub(crate) const START_US: u64 = 7_000_000;
/// Ticks until a request is repeated, and until it counts as unanswered.
const RETRY_TICKS: u32 = 60;
const PATIENCE_TICKS: u32 = 600;

pub(crate) type Law = fn(&KeySamples) -> [i32; KEYS];

pub(crate) fn readme() -> String {
    std::fs::read_to_string(crate_root().join("c/rig/README.md")).expect("the rig's README")
}

/// Builds the rig with the command of its README and extra `flags`; `None` without a compiler.
pub(crate) fn build(name: &str, flags: &str) -> Option<PathBuf> {
    if !are_there(&["gcc"]) {
        return None;
    }
    let program = scratch(&format!("rig_{name}_{}", std::process::id()));
    let readme = readme();
    let (_, command) = readme.split_once("```sh\n").expect("the command");
    let (command, _) = command.split_once("```").expect("its end");
    let gcc = format!("gcc {} {flags}", STRICT.join(" "));
    let command = command.replacen("cc -std=c99", &gcc, 1);
    let command = command.replace("-o rig\n", "-o \"$PROGRAM\"\n");
    let mut shell = Command::new("sh");
    shell.args(["-e", "-c", &command]).env("PROGRAM", &program);
    run(shell.current_dir(crate_root().join("c/rig")));
    Some(program)
}

pub(crate) fn program() -> Option<&'static Path> {
    static PROGRAM: OnceLock<Option<PathBuf>> = OnceLock::new();
    PROGRAM.get_or_init(|| build("plain", "")).as_deref()
}

pub(crate) fn new_report() -> PathBuf {
    static REPORTS: AtomicUsize = AtomicUsize::new(0);
    let number = REPORTS.fetch_add(1, Ordering::Relaxed);
    scratch(&format!("rig_report_{}_{number}.json", std::process::id()))
}

pub(crate) struct Arrival {
    pub(crate) at_us: u64,
    pub(crate) frame: Vec<u8>,
}

pub(crate) struct Rig {
    child: Child,
    report: PathBuf,
    pub(crate) now_us: u64,
    outgoing: Vec<u8>,
    deframer: Deframer,
    next_id: u8,
    law: Option<Law>,
    pub(crate) bytes: Vec<u8>,
    pub(crate) arrivals: Vec<Arrival>,
    /// Number of segments of the stream that were no frames.
    pub(crate) corrupt: usize,
    pub(crate) sent: usize,
}

impl Drop for Rig {
    fn drop(&mut self) {
        let _already_ended = self.child.kill();
        let _status = self.child.wait();
    }
}

impl Rig {
    pub(crate) fn start(arguments: &[&str]) -> Option<Self> {
        Some(Self::start_program(program()?, arguments))
    }

    pub(crate) fn start_program(program: &Path, arguments: &[&str]) -> Self {
        let report = new_report();
        let mut command = Command::new(program);
        command.arg("--lockstep").arg("--report").arg(&report).args(arguments);
        let child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
        let mut rig = Self {
            child: child.expect("the rig starts"),
            report,
            now_us: START_US,
            outgoing: Vec::new(),
            deframer: Deframer::default(),
            next_id: 0,
            law: None,
            bytes: Vec::new(),
            arrivals: Vec::new(),
            corrupt: 0,
            sent: 0,
        };
        rig.exchange(0);
        rig
    }

    fn exchange(&mut self, us: u64) {
        self.now_us += us;
        let len = u16::try_from(self.outgoing.len()).expect("few bytes in an exchange");
        let head = [&self.now_us.to_le_bytes()[..], &len.to_le_bytes()].concat();
        let stdin = self.child.stdin.as_mut().expect("piped");
        stdin.write_all(&[head, std::mem::take(&mut self.outgoing)].concat()).expect("it reads");
        let stdout = self.child.stdout.as_mut().expect("piped");
        let mut len = [0; 2];
        stdout.read_exact(&mut len).expect("an answer");
        let mut bytes = vec![0; usize::from(u16::from_le_bytes(len))];
        stdout.read_exact(&mut bytes).expect("all of the answer");
        for found in bytes.iter().filter_map(|byte| self.deframer.push(*byte).map(owned)) {
            self.corrupt += usize::from(found.is_none());
            self.arrivals.extend(found.map(|frame| Arrival { at_us: self.now_us, frame }));
        }
        self.bytes.extend(bytes);
    }

    /// Runs one period: answers its samples if there is a law.
    fn tick(&mut self) {
        let known = self.arrivals.len();
        self.exchange(TICK_US);
        let Some(law) = self.law else { return };
        let new: Vec<_> = self.arrivals[known..].iter().filter_map(samples).collect();
        for samples in new {
            let forces = law(&samples).map(Millinewtons::saturating);
            let mut header = samples.header;
            header.flag = false;
            let (forces, slopes) = (PerKey::collect(forces), PerKey::default());
            let mut frame = [0; MAX_FRAME];
            let len = KeyForces { header, forces, slopes }.encode(&mut frame);
            self.send(&frame[..len]);
            self.sent += 1;
        }
    }

    fn send(&mut self, frame: &[u8]) {
        let mut wire = [0; serial::MAX_WIRE];
        let len = serial::encode(frame, &mut wire).expect("a frame that links carry");
        self.outgoing.extend(&wire[..len]);
    }

    pub(crate) fn run(&mut self, ms: u32) {
        for _ in 0..ms {
            self.tick();
        }
    }

    pub(crate) fn try_ask<R: Record>(
        &mut self,
        operation: Operation,
        record: &R,
    ) -> Option<(Status, Vec<u8>)> {
        self.next_id = self.next_id.wrapping_add(1);
        let mut request = [0; MAX_FRAME];
        let board = BoardId::new(0).expect("a board");
        let len = encode_request(board, self.next_id, operation, record, &mut request);
        for tick in 0..PATIENCE_TICKS {
            if tick % RETRY_TICKS == 0 {
                self.send(&request[..len]);
            }
            let known = self.arrivals.len();
            self.tick();
            let replies = self.arrivals[known..].iter();
            let mut replies = replies.filter_map(|it| AcyclicReply::decode(&it.frame).ok());
            let id = self.next_id;
            if let Some(reply) = replies.find(|it| it.id == id && it.operation == Ok(operation)) {
                return Some((reply.status, reply.record.to_vec()));
            }
        }
        None
    }

    pub(crate) fn ask<R: Record>(&mut self, operation: Operation, record: &R) -> (Status, Vec<u8>) {
        self.try_ask(operation, record).expect("an answer")
    }

    pub(crate) fn get<R: Record, A: Record>(&mut self, operation: Operation, record: &R) -> A {
        let (status, record) = self.ask(operation, record);
        assert_eq!(status, Status::Done, "{operation:?}");
        A::take(&record).expect("its record")
    }

    pub(crate) fn arm(&mut self, law: Law) -> Status {
        let period_us = u16::try_from(TICK_US).expect("a period");
        let packing = SamplePacking::Position24Velocity as u8;
        let _done: Nothing =
            self.get(Operation::Stream, &Stream { period_us, packing, phase_us: 0 });
        let (status, record) = self.ask(Operation::Disarm, &Nothing);
        if status != Status::Done {
            return status;
        }
        let nonce = Disarmed::take(&record).expect("a nonce").nonce;
        let arm = Arm { nonce, packing: ForcePacking::Force16 as u8, valid_ms: 20 };
        self.law = Some(law);
        self.ask(Operation::Arm, &arm).0
    }

    pub(crate) fn play(&mut self, law: Law, ms: u32) {
        assert_eq!(self.arm(law), Status::Done);
        self.run(ms);
    }

    pub(crate) fn samples(&self) -> Vec<(u64, KeySamples)> {
        let read = |it: &Arrival| samples(it).map(|samples| (it.at_us, samples));
        self.arrivals.iter().filter_map(read).collect()
    }

    pub(crate) fn hellos(&self) -> Vec<Hello> {
        let read = |it: &Arrival| Introduction::decode(&it.frame).ok();
        self.arrivals.iter().filter_map(read).map(|who| who.hello).collect()
    }

    pub(crate) fn kill(mut self) -> Report {
        self.child.kill().expect("it runs");
        Report::read(&self.report)
    }

    pub(crate) fn end(mut self) -> Report {
        drop(self.child.stdin.take());
        let status = self.child.wait().expect("it ends");
        assert!(status.success(), "{status}");
        Report::read(&self.report)
    }
}

fn owned(found: Result<&[u8], FramingError>) -> Option<Vec<u8>> {
    found.ok().map(<[u8]>::to_vec)
}

fn samples(arrival: &Arrival) -> Option<KeySamples> {
    let layout = SampleLayout { packing: SamplePacking::Position24Velocity, n_keys: KEYS };
    let is_samples = FrameKind::of(&arrival.frame) == Some(FrameKind::KeySamples);
    is_samples.then(|| KeySamples::decode(&arrival.frame, layout).expect("samples"))
}

/// Returns position (um) and velocity (0.2 mm/s) of the key in slot 0.
pub(crate) fn first_key(samples: &KeySamples) -> (i32, i32) {
    (samples.positions.as_slice()[0].get(), samples.velocities.as_slice()[0].get().into())
}

pub(crate) struct Report(String);

impl Report {
    pub(crate) fn read(path: &Path) -> Self {
        let text = std::fs::read_to_string(path).expect("a report");
        assert!(text.starts_with("{\n") && text.ends_with("}\n"), "{text}");
        Self(text)
    }

    /// Returns the value of a field; for a field of keys, that of slot 0.
    pub(crate) fn text(&self, field: &str) -> &str {
        let (_, rest) = self.0.split_once(&format!("\"{field}\": ")).expect("the field");
        rest.split([',', '}', '\n']).next().expect("its value")
    }

    pub(crate) fn number(&self, field: &str) -> f64 {
        self.text(field).parse().expect("a number")
    }
}
