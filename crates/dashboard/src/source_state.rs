//! State of the source and of the host behind it, in words.

use telemetry::{ConnectionState, Severity, Status, status};

/// State of a window's source, and of the host behind a connection.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum SourceState {
    Connecting,
    NoHost(String),
    Refused(String),
    Preparing,
    Rehearsing {
        done: u64,
        total: u64,
    },
    Arming,
    Playing,
    /// The host should play and its ticks do not continue.
    Stalled,
    Ending,
    Over(String),
    /// A stop removed all forces: boards that received it, of all.
    Stopped {
        told: u32,
        boards: u32,
    },
    Recording,
    Demonstration,
}

impl SourceState {
    /// Combines the `connection` with the last `status` of the host. A host that ended after its
    /// piece or a stop is not lost.
    pub(crate) fn new(connection: ConnectionState, status: Option<&Status>) -> Self {
        let of_host = status.map(Self::of_host);
        match connection {
            ConnectionState::Connecting => Self::Connecting,
            ConnectionState::Live => of_host.unwrap_or(Self::Playing),
            ConnectionState::Lost(why) => match of_host {
                Some(ended @ (Self::Over(_) | Self::Stopped { .. })) => ended,
                Some(_) | None => Self::NoHost(why),
            },
            ConnectionState::Refused(why) => Self::Refused(why),
            ConnectionState::Recording => Self::Recording,
            ConnectionState::Demonstration => Self::Demonstration,
        }
    }

    fn of_host(status: &Status) -> Self {
        match status.state() {
            status::State::Preparing => Self::Preparing,
            status::State::Rehearsing => {
                Self::Rehearsing { done: status.rehearsed, total: status.strokes }
            }
            status::State::Arming => Self::Arming,
            status::State::Playing => Self::Playing,
            status::State::Stalled => Self::Stalled,
            status::State::Stopping => Self::Ending,
            status::State::Over => Self::Over(status.report.clone()),
            status::State::Stopped => Self::Stopped { told: status.stopped, boards: status.armed },
        }
    }

    pub(crate) fn label(&self) -> String {
        match self {
            Self::Connecting => "Connecting".to_owned(),
            Self::NoHost(_) => "No host".to_owned(),
            Self::Refused(_) => "Refused".to_owned(),
            Self::Preparing => "Preparing".to_owned(),
            Self::Rehearsing { done, total } => format!("Rehearsing {done} of {total}"),
            Self::Arming => "Arming boards".to_owned(),
            Self::Playing => "Playing".to_owned(),
            Self::Stalled => "Stalled".to_owned(),
            Self::Ending => "Ending".to_owned(),
            Self::Over(_) => "Piece over".to_owned(),
            Self::Stopped { boards: 0, .. } => "Stopped".to_owned(),
            Self::Stopped { told, boards } => format!("Stopped {told} of {boards}"),
            Self::Recording => "Recording file".to_owned(),
            Self::Demonstration => "Demonstration".to_owned(),
        }
    }

    /// Returns the reason why a panel has nothing to show, unless the host plays.
    pub(crate) fn why_empty(&self) -> Option<String> {
        let text = match self {
            Self::Playing => return None,
            Self::Connecting => "Connecting to the host.",
            Self::NoHost(_) => "No host is connected: start one with `letoff run`.",
            Self::Refused(why) => return Some(format!("The host rejects this window: {why}.")),
            Self::Preparing => "The host is looking for its keys.",
            Self::Rehearsing { done, total } => {
                let text = format!("The host rehearses its piece: {done} of {total} strokes.");
                return Some(text + " It plays after that.");
            }
            Self::Arming => "The host is arming its boards.",
            Self::Stalled => "The host does not continue its ticks.",
            Self::Ending => "The host is ending.",
            Self::Over(report) => return Some(format!("The piece is over. {report}")),
            Self::Stopped { .. } => "The host was stopped: start it again with `letoff run`.",
            Self::Recording => "The recording contains nothing of this so far.",
            Self::Demonstration => "The demonstration contains nothing of this so far.",
        };
        Some(text.to_owned())
    }

    /// Returns the severity; `None` for a state that is neither good nor bad.
    pub(crate) const fn severity(&self) -> Option<Severity> {
        match self {
            Self::Playing => Some(Severity::Well),
            Self::NoHost(_) | Self::Stopped { .. } => Some(Severity::Degraded),
            Self::Refused(_) | Self::Stalled => Some(Severity::Lost),
            Self::Connecting
            | Self::Preparing
            | Self::Rehearsing { .. }
            | Self::Arming
            | Self::Ending
            | Self::Over(_)
            | Self::Recording
            | Self::Demonstration => None,
        }
    }

    pub(crate) fn why_apart(&self) -> Option<&str> {
        if let Self::NoHost(why) | Self::Refused(why) = self { Some(why) } else { None }
    }
}
