//! Reasons why a board is not used, as sentences that name link, board and key.

use std::fmt;

use firmware_protocol::acyclic::{ANSWER_MS, Operation, RETRY_MS, Status};
use firmware_protocol::{frame::hello::safe_reason, version::PROTOCOL_VERSION};
use keyboard::{KeyIndex, KeyRange};

use crate::identity::{ClaimedKeys, Uid};
use crate::{
    calibration::CalibrationFault, clock::MOST_DRIFT, hello_values::ImpossibleValue,
    rt::board_supervisor::SlowSamples, rt::key_fault::KeyFault, untaken::UntakenForces,
};

/// A board's name in sentences.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct BoardName {
    pub line: String,
    pub number: u8,
}

impl fmt::Display for BoardName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "board {} on {}", self.number, self.line)
    }
}

/// Reason why a board or a link is not used.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
#[expect(missing_docs, reason = "the sentences say it")]
pub enum Refusal {
    #[error(
        "nothing on {line} answers as a board does ({heard}); see that the board has power and \
         that this is its port: `letoff devices` lists what there is"
    )]
    Silent { line: String, heard: LineTraffic },
    #[error("{fault}")]
    Link { fault: String },
    #[error(
        "{board} speaks protocol {major}, this host {ours}; update the {older}",
        ours = PROTOCOL_VERSION.major,
        older = if *major < PROTOCOL_VERSION.major { "board's firmware" } else { "host" }
    )]
    Version { board: BoardName, major: u8 },
    #[error(
        "{board} was built with other cyclic layouts (schema {theirs:016x}, this host has \
         {ours:016x}); build its firmware and the host from the same release",
        ours = firmware_protocol::schema::HASH
    )]
    Schema { board: BoardName, theirs: u64 },
    #[error(
        "two boards say that they are {board} ({one} and {other}); give one of them another \
         number"
    )]
    SameNumber { board: BoardName, one: Uid, other: Uid },
    #[error("{one} and {other} are both board {uid}; unplug one of the two cables")]
    SameBoard { one: BoardName, other: BoardName, uid: Uid },
    #[error("{board} says of itself {value}; correct its firmware")]
    Value { board: BoardName, value: ImpossibleValue },
    #[error("{board} says that it carries {keys}; a board carries 1 to 12 keys, all within A0..C8")]
    Keys { board: BoardName, keys: ClaimedKeys },
    #[error(
        "{board} says that it carries {says}, the scene says {}..{}; correct one of the two",
        scene.first(), scene.last()
    )]
    OtherKeys { board: BoardName, says: ClaimedKeys, scene: KeyRange },
    #[error("{one} and {other} both carry {key}; correct the range of one of them")]
    KeyTwice { one: BoardName, other: BoardName, key: KeyIndex },
    #[error("the scene wants {board}, and nobody answers to that number there")]
    Missing { board: BoardName },
    #[error("{board} is another board than before, or has other firmware; start the host again")]
    Exchanged { board: BoardName },
    #[error(
        "{board}: {}; see to its oscillator, and to the constant from which its firmware \
         counts microseconds", clock_words(*ppm)
    )]
    Clock { board: BoardName, ppm: i32 },
    #[error(
        "{board} says that it is armed, and sends no samples; see that its firmware sends them, \
         and that its link carries so many"
    )]
    NoSamples { board: BoardName },
    #[error(
        "{board} says that it is armed, and its samples are none of {n_keys} keys; see that it \
         sends as many as its hello says, packed as it was asked"
    )]
    Unreadable { board: BoardName, n_keys: usize },
    #[error(
        "{board} says that it is armed, and its samples say that it renders no force; see to \
         its firmware"
    )]
    StaysSafe { board: BoardName },
    #[error(
        "{board} answers later than {RETRY_MS} ms after it was asked, so its clock cannot be read; \
         a board answers within {ANSWER_MS} ms: see to its firmware and to what its link carries"
    )]
    LateAnswers { board: BoardName },
    #[error("{board}: {}; see to its firmware and to what its link carries", late_words(*ms))]
    LateSamples { board: BoardName, ms: u16 },
    #[error(
        "{board}: its encoders do not know where {keys} is since it was started; home it as its \
         maker says, then start the host again"
    )]
    NotHomed { board: BoardName, keys: String },
    #[error(
        "{board} confirmed a sample every {:.2} ms and sends one every {:.2} ms: it is not armed, \
         since no model is stable so; ask it for no more than it keeps, or see to its firmware and \
         to what its link carries",
        f64::from(slow.agreed_us) * 1e-3, f64::from(slow.median_us) * 1e-3
    )]
    Slow { board: BoardName, slow: SlowSamples },
    #[error("{board}: {}", burst_words(f64::from(*us)))]
    Bursts { board: BoardName, us: u32 },
    #[error("{board}: {}", restart_words(*times, *reason))]
    Restarting { board: BoardName, times: u8, reason: u8 },
    #[error(
        "{board}: no motor has moved its key as it should, so none of {keys} is played: {}; {}",
        fault.words(), fault.remedy()
    )]
    NotProven { board: BoardName, keys: String, fault: KeyFault },
    #[error("{board} takes no force, so none of {keys} is played{forces}")]
    TakesNoForce { board: BoardName, keys: String, forces: UntakenForces },
    #[error("{board} cannot {what}; {instead}")]
    Unable { board: BoardName, what: &'static str, instead: String },
    #[error(
        "{board} did not answer {asked:?} for {seconds:.1} s; it was there before: see its cable"
    )]
    NoAnswer { board: BoardName, asked: Operation, seconds: f64 },
    #[error(
        "{board} answers, and was not ready within {seconds:.1} s; it was asked for {asked:?} last: \
         see what its link carries, and start the host again while the machine does nothing else"
    )]
    NotReady { board: BoardName, asked: Operation, seconds: f64 },
    #[error(
        "{board} answered {asked:?} with \"{}\"; its log may say why: `letoff devices --boards \
         --link {link} --log`", status_words(*status)
    )]
    Declined { board: BoardName, link: String, asked: Operation, status: Status },
    #[error("{board} renders no force: {}; see to it, then start it anew", reason_words(*reason))]
    Latched { board: BoardName, reason: u8 },
    #[error(
        "{board} has no calibration file {file}; make one: `letoff calibrate --link {link} \
         --board {number}`", number = board.number
    )]
    NotCalibrated { board: BoardName, link: String, file: String },
    #[error("{board}: {why}")]
    Calibration { board: BoardName, why: String },
    #[error("{key} of {board}: {fault}")]
    Key { board: BoardName, key: KeyIndex, fault: CalibrationFault },
}

/// Input of a line on which no board answered.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LineTraffic {
    /// Frames other than hellos.
    pub frames: u64,
    /// Receptions that were no frame.
    pub corrupt: u64,
    pub down: u64,
}

impl fmt::Display for LineTraffic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self { frames: 0, corrupt: 0, down: 0 } => f.write_str("not a byte came"),
            Self { frames: 0, corrupt: 0, .. } => f.write_str("the link is down"),
            Self { frames: 0, corrupt, .. } => {
                write!(f, "{corrupt} pieces came that were no frames")
            }
            Self { frames, .. } => write!(f, "{frames} frames came, none of them a hello"),
        }
    }
}

const fn status_words(status: Status) -> &'static str {
    match status {
        Status::Done => "done",
        Status::Unknown => "unknown operation",
        Status::BadValue => "a value is out of range",
        Status::WrongState => "not in this state",
        Status::WrongNonce => "wrong nonce",
        Status::Impossible => "impossible",
    }
}

/// Returns the fault of a clock with this drift (1e-6), in words.
pub fn clock_words(ppm: i32) -> String {
    let percent = f64::from(ppm.abs()) * 1e-4;
    let how = if ppm < 0 { "slow" } else { "fast" };
    let most = MOST_DRIFT * 1e2;
    format!("its clock runs {percent:.1} % too {how}, and at most {most:.0} % is accepted")
}

/// Returns the fault of samples with this age on arrival (ms), in words.
pub fn late_words(ms: u16) -> String {
    format!("its samples are {ms} ms old when they come, longer than forces are valid")
}

pub const fn reason_words(reason: u8) -> &'static str {
    match reason {
        safe_reason::NONE => "it is armed",
        safe_reason::NEVER_ARMED => "it was never armed",
        safe_reason::SILENCE => "its forces expired",
        safe_reason::DISARMED => "it was disarmed",
        safe_reason::EMERGENCY_STOP => "everything was stopped",
        safe_reason::KEY_FAULT => "a key, motor or sensor failed",
        _ => "for a reason that this version does not know",
    }
}

/// Returns the number of recent restarts and the last reason, in words.
pub fn restart_words(times: u8, reason: u8) -> String {
    let (why, see) = match reason {
        reset_reason::POWER_ON => ("power came back", "see to its supply"),
        reset_reason::BROWN_OUT => ("its supply gave way", "see to its supply"),
        reset_reason::WATCHDOG => ("its watchdog tripped", "see to its firmware"),
        reset_reason::REQUEST => ("it was asked to", "see who asks it"),
        reset_reason::FAULT => ("its program failed", "see to its firmware"),
        _ => ("for a reason of its firmware", "see to its supply and its firmware"),
    };
    let times = if times < 2 { "once".to_owned() } else { format!("{times} times of late") };
    format!("it restarted {times} ({why}, reason {reason}); {see}")
}

/// Returns the fault of samples that arrive in bursts (us), in words.
pub fn burst_words(burst_us: f64) -> String {
    let ms = burst_us * 1e-3;
    format!(
        "its samples come in bursts every {ms:.0} ms: an adapter or a driver holds them back; write \
         1 into the port's latency_timer in /sys/bus/usb-serial/devices, as `letoff devices` shows"
    )
}

/// Words of [`firmware_protocol::frame::hello::Hello::reset_reason`], from minor version 3 on.
mod reset_reason {
    pub(super) const POWER_ON: u8 = 1;
    pub(super) const BROWN_OUT: u8 = 2;
    pub(super) const WATCHDOG: u8 = 3;
    pub(super) const REQUEST: u8 = 4;
    pub(super) const FAULT: u8 = 5;
}

/// All faults at once.
#[derive(Clone, PartialEq, Debug)]
pub struct Refusals(pub Vec<Refusal>);

impl fmt::Display for Refusals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (n, refusal) in self.0.iter().enumerate() {
            let separator = if n == 0 { "" } else { "\nletoff: " };
            write!(f, "{separator}{refusal}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Refusals {}

impl Refusals {
    /// Returns `true` if another try may succeed: power may return, a damaged file stays damaged.
    pub fn may_pass(&self) -> bool {
        !self.0.iter().any(|it| matches!(it, Refusal::Calibration { .. }))
    }

    /// Returns `true` if another try within seconds may succeed.
    pub fn may_pass_soon(&self) -> bool {
        self.0.iter().all(|refusal| match refusal {
            Refusal::Silent { .. }
            | Refusal::Missing { .. }
            | Refusal::Clock { .. }
            | Refusal::NoSamples { .. }
            | Refusal::LateAnswers { .. }
            | Refusal::LateSamples { .. }
            | Refusal::NoAnswer { .. }
            | Refusal::NotReady { .. }
            | Refusal::Slow { .. }
            | Refusal::Bursts { .. } => true,
            Refusal::Link { .. }
            | Refusal::Version { .. }
            | Refusal::Schema { .. }
            | Refusal::SameNumber { .. }
            | Refusal::SameBoard { .. }
            | Refusal::Value { .. }
            | Refusal::Keys { .. }
            | Refusal::OtherKeys { .. }
            | Refusal::KeyTwice { .. }
            | Refusal::Exchanged { .. }
            | Refusal::Unreadable { .. }
            | Refusal::StaysSafe { .. }
            | Refusal::NotHomed { .. }
            | Refusal::Restarting { .. }
            | Refusal::NotProven { .. }
            | Refusal::TakesNoForce { .. }
            | Refusal::Unable { .. }
            | Refusal::Declined { .. }
            | Refusal::Latched { .. }
            | Refusal::NotCalibrated { .. }
            | Refusal::Calibration { .. }
            | Refusal::Key { .. } => false,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_board_that_is_missing_may_come_and_a_damaged_file_stays_so() {
        let board = || BoardName { line: "can0".into(), number: 3 };
        let missing = Refusal::Missing { board: board() };
        assert!(Refusals(vec![missing.clone()]).may_pass());
        let damaged = Refusal::Calibration { board: board(), why: "no checksum".into() };
        assert!(!Refusals(vec![missing, damaged]).may_pass());
    }

    #[test]
    fn what_is_to_be_typed_names_the_link() {
        let board = BoardName { line: "can0".into(), number: 3 };
        let (link, file) = ("can:can0".to_owned(), "f.toml".into());
        let status = Status::WrongState;
        let asked = Operation::Light;
        let declined =
            Refusal::Declined { board: board.clone(), link: link.clone(), asked, status };
        assert!(declined.to_string().contains("devices --boards --link can:can0 --log`"));
        let refusal = Refusal::NotCalibrated { board, link, file };
        assert!(refusal.to_string().contains("calibrate --link can:can0 --board 3`"));
    }
}
