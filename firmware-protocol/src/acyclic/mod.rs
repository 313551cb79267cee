//! Requests and replies: configuration, calibration, log, arming. One operation per file.
//!
//! ```text
//! request  byte 0 kind 4 | board    byte 1 id    byte 2 operation    byte 3..  its record
//! reply    byte 0 kind 5 | board    byte 1 id    byte 2 operation    byte 3 status    byte 4..
//! ```
//!
//! The host asks again, with the same id, until it is answered: not before 25 ms, since a USB
//! adapter may hold an answer that long. One request is on its way to a board at a time. A
//! board that sees the id of the request that it answered last sends the same answer again and
//! does nothing else, so asking twice does nothing twice.
//!
//! Requests are never on the tick's path, and cost the bus less than a hundredth.

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

use crate::frame::{ALL_BOARDS, DecodeError, FrameKind, check_board, head};
use crate::key::BoardId;
use crate::{MAX_FRAME, Record};

/// Longest time until a board has answered a request (ms).
pub const ANSWER_MS: u32 = 20;

/// Time after which a request is asked again at the earliest (ms).
pub const RETRY_MS: u32 = 25;

/// Bytes before the record of a request.
pub const REQUEST_HEAD: usize = 3;
/// Bytes before the record of a reply.
pub const REPLY_HEAD: usize = 4;

/// What is asked for. New ones may be added in a minor version: boards that do not know one
/// answer [`Status::Unknown`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
#[repr(u8)]
pub enum Operation {
    /// Who are you? Answered with the record of a hello.
    Hello = 1,
    /// Send samples from now on: [`stream`].
    Stream = 2,
    /// Render no force, and say the nonce for arming: [`arm`].
    Disarm = 3,
    /// Render forces from now on: [`arm`].
    Arm = 4,
    /// What time is it? [`ping`].
    Ping = 5,
    /// Read a setting: [`config`].
    ReadConfig = 6,
    /// Write a setting: [`config`].
    WriteConfig = 7,
    /// Read a key's calibration: [`calibration`].
    ReadCalibration = 8,
    /// Write a key's calibration: [`calibration`].
    WriteCalibration = 9,
    /// Read the log: [`log`].
    ReadLog = 10,
    /// Show which board you are: [`light`].
    Light = 11,
    /// What was counted: [`counters`].
    Counters = 12,
    /// Move a simulated finger: [`finger`].
    Finger = 13,
    /// How are you? [`health`].
    BoardHealth = 14,
    /// How is a key? [`health`].
    KeyHealth = 15,
    /// Take a key's motor off or on: [`health`].
    MuteKey = 16,
    /// End the firmware, and start the bootloader: [`bootloader`].
    Bootloader = 17,
}

impl Operation {
    /// All operations, in the order of their numbers.
    pub const ALL: [Self; 17] = [
        Self::Hello,
        Self::Stream,
        Self::Disarm,
        Self::Arm,
        Self::Ping,
        Self::ReadConfig,
        Self::WriteConfig,
        Self::ReadCalibration,
        Self::WriteCalibration,
        Self::ReadLog,
        Self::Light,
        Self::Counters,
        Self::Finger,
        Self::BoardHealth,
        Self::KeyHealth,
        Self::MuteKey,
        Self::Bootloader,
    ];

    /// Returns the operation with this number.
    pub fn new(number: u8) -> Option<Self> {
        Self::ALL.get(usize::from(number).checked_sub(1)?).copied()
    }
}

/// How a request was answered.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum Status {
    Done = 0,
    /// The board does not know the operation.
    Unknown = 1,
    /// A value in it is out of range, or the record is too short.
    BadValue = 2,
    /// Not in the state in which the board is.
    WrongState = 3,
    /// The nonce is not the one that was given out last.
    WrongNonce = 4,
    /// The board cannot do that.
    Impossible = 5,
}

impl Status {
    /// All of them, in the order of their numbers.
    pub const ALL: [Self; 6] = [
        Self::Done,
        Self::Unknown,
        Self::BadValue,
        Self::WrongState,
        Self::WrongNonce,
        Self::Impossible,
    ];

    /// Returns the status with this number; [`Status::Impossible`] for those of newer versions.
    pub fn new(number: u8) -> Self {
        Self::ALL.get(usize::from(number)).copied().unwrap_or(Self::Impossible)
    }
}

/// A request as it came.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct AcyclicRequest<'a> {
    pub board: BoardId,
    /// Its number; the same one is the same request again.
    pub id: u8,
    /// What is asked for; nothing that this version knows if the number is none of its own.
    pub operation: Result<Operation, u8>,
    /// The record, and zeros or newer fields behind it.
    pub record: &'a [u8],
}

impl<'a> AcyclicRequest<'a> {
    /// Reads a frame, padded or not; never panics, whatever the bytes.
    ///
    /// # Errors
    /// Says what in `bytes` is not of this frame.
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

/// Writes a request of `board`; returns its length.
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

/// A reply as it came.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct AcyclicReply<'a> {
    pub board: BoardId,
    pub id: u8,
    /// What had been asked for.
    pub operation: Result<Operation, u8>,
    pub status: Status,
    /// The record, and zeros or newer fields behind it; nothing if it was not done.
    pub record: &'a [u8],
}

impl<'a> AcyclicReply<'a> {
    /// Reads a frame, padded or not; never panics, whatever the bytes.
    ///
    /// # Errors
    /// Says what in `bytes` is not of this frame.
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

/// Writes a reply of `board` to the request `id`; returns its length.
///
/// `operation` is the number that was asked for, known or not.
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
