//! Requests and replies: configuration, calibration, log, arming. One operation per file.
//!
//! ```text
//! request  byte 0 kind 4 | board    byte 1 id    byte 2 operation    byte 3..  its record
//! reply    byte 0 kind 5 | board    byte 1 id    byte 2 operation    byte 3 status    byte 4..
//! ```
//!
//! The host repeats a request, with the same id, until it is answered: not before 25 ms, since a
//! USB adapter may hold an answer that long. Each board has one open request at a time. A board
//! that receives the id of its last answered request again repeats the answer and does nothing
//! else, so a repeated request acts once.
//!
//! Requests are never on the tick's path, and use less than a hundredth of the bus. No decoder
//! panics.

#[macro_use]
mod operation;

pub mod arm;
pub mod bootloader;
pub mod calibration;
pub mod config;
pub mod counters;
pub mod finger;
pub mod health;
pub mod light;
pub mod log;
pub mod ping;
pub mod stream;

use crate::frame::hello::Hello;
use crate::frame::{ALL_BOARDS, DecodeError, FrameKind, check_board, head};
use crate::key::BoardId;
use crate::{MAX_FRAME, Nothing, Record, RecordLayout};

/// Passes the table of operations to the macro `with`: number, name, function with the records of
/// request and answer, obligation (`shall`, `should` or `may`), and meaning.
///
/// [`Operation`], the functions of a board in Rust and in C, and the tables of PROTOCOL.md derive
/// from it. A minor version may add operations.
#[macro_export]
macro_rules! operations {
    ($with:ident) => {
        $with! {
            1 Hello = hello(Nothing) -> Hello, shall, "who are you?";
            2 Stream = stream(stream::Stream) -> Nothing, shall, "send samples from now on";
            3 Disarm = disarm(Nothing) -> arm::Disarmed,
                shall, "render no force, and make a new nonce";
            4 Arm = arm(arm::Arm) -> Nothing, shall, "render forces from now on";
            5 Ping = ping(Nothing) -> ping::Pong, shall, "what time is it?";
            6 ReadConfig = read_config(config::ReadConfig) -> config::Config,
                should, "read a setting";
            7 WriteConfig = write_config(config::WriteConfig) -> config::Config,
                should, "write a setting";
            8 ReadCalibration = read_calibration(calibration::ReadCalibration) -> calibration::KeyCalibration,
                may, "read what the board keeps of a key";
            9 WriteCalibration = write_calibration(calibration::KeyCalibration) -> Nothing,
                may, "write it";
            10 ReadLog = read_log(log::ReadLog) -> log::LogLine, may, "read a line of the log";
            11 Light = light(light::Light) -> Nothing, should, "show which board you are";
            12 Counters = counters(Nothing) -> counters::Counters,
                should, "what was counted since the start?";
            13 Finger = finger(finger::Finger) -> Nothing, may, "move a simulated finger";
            14 BoardHealth = board_health(Nothing) -> health::BoardHealth, may, "how are you?";
            15 KeyHealth = key_health(health::ReadKeyHealth) -> health::KeyHealth,
                may, "how is a key?";
            16 MuteKey = mute_key(health::MuteKey) -> Nothing,
                may, "take the motor of a key off or on";
            17 Bootloader = bootloader(bootloader::Bootloader) -> Nothing,
                may, "end the firmware, and start the bootloader";
        }
    };
}

operations!(define_operations);

/// An operation for generated code and documents.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct OperationEntry {
    /// Name of its function in [`BoardOperations`], and in C after `answer_`.
    pub function: &'static str,
    /// Obligation of boards: `shall`, `should` or `may`.
    pub needed: &'static str,
    pub request: RecordLayout,
    pub answer: RecordLayout,
    pub meaning: &'static str,
}

/// Maximum time from a request to its answer (ms).
pub const ANSWER_MS: u32 = 20;

/// Minimum time before a request is repeated (ms).
pub const RETRY_MS: u32 = 25;

/// Number of bytes before the record of a request.
pub const REQUEST_HEAD: usize = 3;
/// Number of bytes before the record of a reply.
pub const REPLY_HEAD: usize = 4;

/// Result of a request.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum Status {
    Done = 0,
    /// The board does not know the operation.
    Unknown = 1,
    /// A value of the request is out of range, or the record is too short.
    BadValue = 2,
    /// The state of the board does not allow the operation.
    WrongState = 3,
    /// The nonce is not the newest one.
    WrongNonce = 4,
    Impossible = 5,
}

impl Status {
    pub const ALL: [Self; 6] = [
        Self::Done,
        Self::Unknown,
        Self::BadValue,
        Self::WrongState,
        Self::WrongNonce,
        Self::Impossible,
    ];

    /// Returns the status with this number; [`Status::Impossible`] for one of a newer version.
    pub fn new(number: u8) -> Self {
        Self::ALL.get(usize::from(number)).copied().unwrap_or(Self::Impossible)
    }
}

/// A received request.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct AcyclicRequest<'a> {
    pub board: BoardId,
    /// Number of the request; a repeated request has the same one.
    pub id: u8,
    /// Operation, or its number if this version does not know it.
    pub operation: Result<Operation, u8>,
    /// The record, followed by zeros or newer fields.
    pub record: &'a [u8],
}

impl<'a> AcyclicRequest<'a> {
    pub fn decode(bytes: &'a [u8]) -> Result<Self, DecodeError> {
        let length = DecodeError::Length { got: bytes.len() };
        let [first, id, operation, record @ ..] = bytes else { return Err(length) };
        if MAX_FRAME < bytes.len() {
            return Err(length);
        }
        let board = check_board(*first, FrameKind::Request)?;
        let operation = Operation::new(*operation).ok_or(*operation);
        Ok(Self { board, id: *id, operation, record })
    }
}

/// Encodes a request of `board`; returns its length.
pub fn encode_request<R: Record>(
    board: BoardId,
    id: u8,
    operation: Operation,
    record: &R,
    bytes: &mut [u8; MAX_FRAME],
) -> usize {
    bytes.fill(0);
    let start = [head(FrameKind::Request, board.number()), id, operation as u8];
    bytes[..REQUEST_HEAD].copy_from_slice(&start);
    REQUEST_HEAD + record.put(&mut bytes[REQUEST_HEAD..]).unwrap_or_default()
}

/// A received reply.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct AcyclicReply<'a> {
    pub board: BoardId,
    pub id: u8,
    pub operation: Result<Operation, u8>,
    pub status: Status,
    /// The record, followed by zeros or newer fields; empty if the operation was not done.
    pub record: &'a [u8],
}

impl<'a> AcyclicReply<'a> {
    pub fn decode(bytes: &'a [u8]) -> Result<Self, DecodeError> {
        let length = DecodeError::Length { got: bytes.len() };
        let [first, id, operation, status, record @ ..] = bytes else { return Err(length) };
        if MAX_FRAME < bytes.len() {
            return Err(length);
        }
        let board = check_board(*first, FrameKind::Reply)?;
        let operation = Operation::new(*operation).ok_or(*operation);
        Ok(Self { board, id: *id, operation, status: Status::new(*status), record })
    }
}

/// Encodes a reply to the request `id` with its `operation`, known or not; returns the length.
pub fn encode_reply<R: Record>(
    board: BoardId,
    id: u8,
    operation: u8,
    outcome: Result<R, Status>,
    bytes: &mut [u8; MAX_FRAME],
) -> usize {
    bytes.fill(0);
    let status = outcome.as_ref().map_or_else(|status| *status as u8, |_done| Status::Done as u8);
    let start = [head(FrameKind::Reply, board.number()), id, operation, status];
    bytes[..REPLY_HEAD].copy_from_slice(&start);
    let record = outcome.map_or(0, |record| record.put(&mut bytes[REPLY_HEAD..]).unwrap_or(0));
    REPLY_HEAD + record
}

const _: () = assert!(ALL_BOARDS == 15, "requests are for one board, never for all");
