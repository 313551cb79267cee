//! The status of a host: `letoff status`, and the metrics of its stream.

use serde::{Deserialize, Serialize};

use crate::{Board, Status, status};

/// What a host does.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum HostState {
    /// It looks for its keys.
    #[default]
    Preparing,
    /// Its pianist rehearses; no board is armed.
    Rehearsing,
    /// Boards are armed, and threads start.
    Starting,
    Playing,
    /// It should play, and its ticks do not go on.
    Stalled,
    /// Forces fade, and notes end.
    Ending,
    /// Its piece is over, and it ends.
    Over,
    /// A stop removed all forces, and it ends.
    Stopped,
}

impl HostState {
    pub const fn words(self) -> &'static str {
        match self {
            Self::Preparing => "is being prepared",
            Self::Rehearsing => "rehearses",
            Self::Starting => "arms its boards",
            Self::Playing => "plays",
            Self::Stalled => "hangs",
            Self::Ending => "ends",
            Self::Over => "has played its piece",
            Self::Stopped => "was stopped",
        }
    }

    const fn message(self) -> status::State {
        match self {
            Self::Preparing => status::State::Preparing,
            Self::Rehearsing => status::State::Rehearsing,
            Self::Starting => status::State::Arming,
            Self::Playing => status::State::Playing,
            Self::Stalled => status::State::Stalled,
            Self::Ending => status::State::Stopping,
            Self::Over => status::State::Over,
            Self::Stopped => status::State::Stopped,
        }
    }
}

/// Status of a host, as `letoff status --json` prints it.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct HostStatus {
    pub process: u32,
    pub scene: String,
    pub state: HostState,
    /// When this state began (s since 1970).
    pub since: u64,
    /// Strokes that are rehearsed, and how many there are.
    pub rehearsed: [u64; 2],
    #[serde(flatten)]
    pub run: RunProgress,
    pub boards: Vec<BoardState>,
    pub clients: u32,
    pub recording: Option<String>,
    /// Begin of the recording (s since 1970).
    #[serde(default)]
    pub recording_since: u64,
    /// Sentence about the run, once it is over.
    #[serde(default)]
    pub report: String,
    /// Boards that received a stop, and boards that were armed, once it was stopped.
    #[serde(default)]
    pub stopped: [u32; 2],
    /// Keys of the scene that no board carries, by number.
    #[serde(default)]
    pub absent: Vec<u32>,
    /// The MIDI output in words, or why there is none.
    pub midi: String,
    /// Last faults of voices and changes of boards, the newest last.
    pub last_faults: Vec<String>,
}

/// Progress of the ticks and of their voices, once a run is prepared.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct RunProgress {
    pub tick_hz: u32,
    /// How often the play list has begun, if it begins again and again.
    pub pass: Option<u64>,
    pub voices: u32,
    /// Voices whose equations were not computed in the last tick.
    pub asleep: u32,
    pub deadlines: DeadlineStatus,
    pub strikes: u64,
    pub faults: u64,
    /// Key events for which a ring had no room.
    pub dropped: u64,
    pub muted: Vec<String>,
    #[serde(default)]
    pub muted_keys: Vec<u32>,
    /// Work that is left out now, since ticks have more work than time.
    pub left_out: Vec<String>,
    /// Turns of voices that had to wait, since their lanes had no time left.
    pub waited: u64,
    /// Ticks in which voices waited although there was time: an error of the host.
    #[serde(default)]
    pub starved: u64,
}

/// Ticks, and how late they were.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct DeadlineStatus {
    /// Ticks so far, run or not.
    pub ticks: u64,
    pub skipped: u64,
    /// Ticks that were run and missed their deadline since their voices took too long.
    pub own_work: u64,
    /// Ticks that missed it since the system woke the tick too late.
    pub woken_late: u64,
    /// Ticks that missed it since the system took the processor away.
    pub preempted: u64,
    /// Woken after the tick was due (us): quantiles 0.5, 0.99, 0.999 and the largest; none before
    /// the first second is over.
    pub lateness_us: Option<[f64; 4]>,
}

/// A board, simulated or not.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct BoardState {
    pub link: String,
    pub number: u32,
    /// Its first key, 0 (A0) to 87 (C8), and how many.
    pub first_key: u32,
    pub keys: u32,
    /// Whether it renders forces, or why not, in words.
    pub state: String,
    /// Times that the numbers of its samples jumped.
    pub gaps: u64,
    /// Median of the latest round trips (us), if there were any.
    pub round_trip_us: Option<f64>,
}

impl BoardState {
    pub fn is_armed(&self) -> bool {
        self.state == "armed"
    }
}

/// Severity of a state of a board or key.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Severity {
    Well,
    /// Some keys have no force, or the board was lost meanwhile.
    Degraded,
    /// No key of the board has a force.
    Lost,
}

impl Board {
    pub fn severity(&self) -> Severity {
        if self.state == "armed" && self.muted.is_empty() {
            Severity::Well
        } else if self.state.starts_with("armed") {
            Severity::Degraded
        } else {
            Severity::Lost
        }
    }
}

impl HostStatus {
    /// Returns the message of the topic `/status`, with `boards` on `lines`.
    pub fn message(&self, boards: Vec<Board>, lines: Vec<String>) -> Status {
        let [rehearsed, strokes] = self.rehearsed;
        let [stopped, armed] = self.stopped;
        Status {
            state: self.state.message().into(),
            scene: self.scene.clone(),
            since: self.since,
            rehearsed,
            strokes,
            report: self.report.clone(),
            stopped,
            armed,
            recording: self.recording.clone().unwrap_or_default(),
            recording_since: self.recording_since,
            midi: self.midi.clone(),
            boards,
            lines,
            muted: self.run.muted_keys.clone(),
            absent: self.absent.clone(),
        }
    }

    /// Returns what it does and how its boards are, in a line.
    pub fn line(&self) -> String {
        let Self { scene, state, rehearsed: [done, total], .. } = self;
        if *state == HostState::Rehearsing {
            return format!("{scene}: rehearsed {done} of {total} strokes");
        }
        let line = format!("{scene}: {}", state.words());
        if *state != HostState::Playing || self.boards.is_empty() {
            return line;
        }
        let lost: Vec<_> = self.boards.iter().filter(|it| !it.is_armed()).collect();
        let (all, armed) = (self.boards.len(), self.boards.len() - lost.len());
        let lost = lost.iter().map(|BoardState { number, link, state, .. }| {
            format!("; board {number} on {link}: {state}")
        });
        let lost: String = lost.collect();
        format!("{line}, {armed} of {all} boards armed{lost}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_names_the_boards_that_render_no_force() {
        let board = |number, state: &str| BoardState {
            number,
            link: "can0".to_owned(),
            state: state.to_owned(),
            ..BoardState::default()
        };
        let boards = vec![board(1, "armed"), board(2, "silent"), board(3, "armed; C4 is muted")];
        let scene = "default".to_owned();
        let status =
            HostStatus { scene, boards, state: HostState::Playing, ..HostStatus::default() };
        assert_eq!(
            status.line(),
            "default: plays, 1 of 3 boards armed; board 2 on can0: silent; \
             board 3 on can0: armed; C4 is muted"
        );
        let rehearsing = HostStatus { state: HostState::Rehearsing, rehearsed: [3, 57], ..status };
        assert_eq!(rehearsing.line(), "default: rehearsed 3 of 57 strokes");
    }
}
