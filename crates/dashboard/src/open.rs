//! Opens a host, a recording, or the demonstration.

use std::{fmt, path::PathBuf, sync::Arc, time::Instant};

use telemetry::Source;
use telemetry::recording::{Playback, PlaybackClock, Recording};
use telemetry::stream::{Client, Dial, Fingerprint};

use crate::source_thread::{Notifier, SourceThread};
use crate::{RepaintWaker, demonstration};

/// Source of a window.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum WindowTarget {
    Host {
        /// Address: `host:port` or `ws://…`.
        address: String,
        token: Option<String>,
        fingerprint: Option<String>,
    },
    /// The host of this machine with this control socket, which reports address and secret.
    Socket(PathBuf),
    Recording {
        file: String,
    },
    Demonstration,
}

impl WindowTarget {
    /// Returns a recording if `text` ends in `.mcap` or is a file, else the host at this address.
    pub fn of(text: &str, token: Option<String>, fingerprint: Option<String>) -> Self {
        let path = std::path::Path::new(text);
        let is_recording = path.extension().is_some_and(|it| it.eq_ignore_ascii_case("mcap"));
        if is_recording || path.is_file() {
            return Self::Recording { file: text.to_owned() };
        }
        Self::Host { address: text.to_owned(), token, fingerprint }
    }
}

/// An error as a sentence: the target that cannot be opened, and the remedy.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Sentence(pub String);

impl fmt::Display for Sentence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Sentence {}

/// Opens `target`; each arrival calls `wake`.
pub fn open(target: &WindowTarget, wake: &RepaintWaker) -> Result<Box<dyn Source>, Sentence> {
    match target {
        WindowTarget::Host { address, token, fingerprint } => {
            let pin = fingerprint.as_deref().map(pin).transpose()?;
            let (address, token) = (address.clone(), token.clone());
            connect(Dial { address, token, pin, socket: None }, wake)
        }
        WindowTarget::Socket(path) => {
            connect(Dial { socket: Some(path.clone()), ..Dial::default() }, wake)
        }
        WindowTarget::Recording { file } => {
            let recording = Recording::open(file).map_err(|error| Sentence(error.to_string()))?;
            Ok(Box::new(Playback::new(recording, clock())))
        }
        WindowTarget::Demonstration => {
            let playback = demonstration(clock()).map_err(|error| Sentence(error.to_string()))?;
            Ok(Box::new(playback))
        }
    }
}

fn connect(dial: Dial, wake: &RepaintWaker) -> Result<Box<dyn Source>, Sentence> {
    let make = |notifier: Notifier| -> Result<Box<dyn Source + Send>, Sentence> {
        let notify = move || {
            let _gone = notifier.notify();
        };
        Ok(Box::new(Client::connect(dial, Some(Box::new(notify)))))
    };
    Ok(Box::new(SourceThread::start(make, Arc::clone(wake))?))
}

fn pin(text: &str) -> Result<Fingerprint, Sentence> {
    text.parse().map_err(|_no_fingerprint| {
        Sentence(format!("{text} is no fingerprint: copy the one that the host printed, AB:CD:…"))
    })
}

fn clock() -> PlaybackClock {
    let began = Instant::now();
    Box::new(move || began.elapsed().as_secs_f64())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_recording_is_told_from_an_address() {
        let recording = |file: &str| WindowTarget::Recording { file: file.into() };
        assert_eq!(WindowTarget::of("takes/one.mcap", None, None), recording("takes/one.mcap"));
        let host = WindowTarget::Host {
            address: "127.0.0.1:8765".into(),
            token: Some("t".into()),
            fingerprint: None,
        };
        assert_eq!(WindowTarget::of("127.0.0.1:8765", Some("t".into()), None), host);
    }

    #[test]
    fn what_cannot_be_opened_is_refused_in_a_sentence() {
        let wake: RepaintWaker = Arc::new(|_| {});
        let file = WindowTarget::of("nothing.mcap", None, None);
        let refused = open(&file, &wake).expect_err("no such file").to_string();
        assert!(refused.contains("nothing.mcap"), "{refused}");
        let host = WindowTarget::of("127.0.0.1:1", None, Some("ABC".into()));
        let refused = open(&host, &wake).expect_err("no fingerprint").to_string();
        assert!(refused.starts_with("ABC is no fingerprint"), "{refused}");
    }

    #[test]
    fn a_host_that_is_not_there_is_tried_again() {
        let wake: RepaintWaker = Arc::new(|_| {});
        // No host listens at a port that was just released.
        let port = std::net::TcpListener::bind("127.0.0.1:0").and_then(|it| it.local_addr());
        let host = WindowTarget::of(&port.expect("a port").to_string(), None, None);
        let source = open(&host, &wake).expect("a source");
        assert!(!matches!(source.standing(), telemetry::ConnectionState::Refused(_)));
    }
}
