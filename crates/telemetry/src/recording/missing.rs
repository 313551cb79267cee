//! Unreadable pieces of a recording, and their notes in a recovered file.

use std::fmt;
use std::path::{Path, PathBuf};

use documents::shown;
use mcap::records::Metadata;

use super::format;
use crate::Topic;

pub(super) const NAME: &str = "letoff.missing";

/// Damage of a file at a missing piece.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Defect {
    /// Description with the file as its subject.
    pub(super) wrong: String,
    /// `true` if it is of the file from which this one was recovered.
    pub(super) is_left_out: bool,
}

impl Defect {
    pub(super) const fn here(wrong: String) -> Self {
        Self { wrong, is_left_out: false }
    }

    pub(super) const fn left_out(wrong: String) -> Self {
        Self { wrong, is_left_out: true }
    }

    pub(super) fn damage(at: u64, cause: &str) -> Self {
        Self::here(format!("is damaged at byte {at} ({cause})"))
    }

    /// Returns the description for a file that is recovered from `old`, which has this defect.
    pub(super) fn recovered_from(&self, old: &Path) -> String {
        if self.is_left_out {
            return self.wrong.clone();
        }
        let name = shown(Path::new(old.file_name().unwrap_or_default()));
        format!("was recovered from {name}, which {}", self.wrong)
    }
}

/// An unreadable piece of a recording.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MissingPiece {
    pub path: PathBuf,
    pub(super) defect: Defect,
    /// Times of its first and last message (ns since 1970), as far as known.
    pub span: (u64, u64),
    /// Time of the recording's beginning (ns since 1970).
    pub began: u64,
    /// Topics of its messages, if known.
    pub topics: Option<Vec<Topic>>,
}

impl MissingPiece {
    /// Returns `true` if it held only the catalogue and voices, which are repeated elsewhere.
    pub fn is_said_again(&self) -> bool {
        self.topics.as_ref().is_some_and(|topics| {
            topics.iter().all(|it| matches!(it, Topic::Catalogue | Topic::Voices))
        })
    }

    /// Describes the damage and the missing data, without advice.
    pub fn what(&self) -> String {
        format!(
            "{} {}: what it had {} is left out",
            shown(&self.path),
            self.defect.wrong,
            self.when()
        )
    }

    fn when(&self) -> String {
        let seconds = |at: u64| at.saturating_sub(self.began) as f64 * 1e-9;
        match self.span {
            (_, last) if last <= self.began => "at its beginning".to_owned(),
            (first, last) if first == last => format!("at {:.3} s", seconds(first)),
            (first, last) => format!("from {:.3} s to {:.3} s", seconds(first), seconds(last)),
        }
    }
}

impl std::error::Error for MissingPiece {}

impl fmt::Display for MissingPiece {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.what())?;
        if self.defect.is_left_out {
            return Ok(());
        }
        write!(f, ", and `letoff recover {}` makes a complete file of the rest", shown(&self.path))
    }
}

/// Note about a missing piece, which a recovered file contains in its place.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct MissingNote {
    pub(super) wrong: String,
    /// Times of the first and last message (ns since 1970); `None` if the file breaks off.
    pub(super) span: Option<(u64, u64)>,
    pub(super) topics: Option<Vec<Topic>>,
}

impl MissingNote {
    pub(super) fn new(piece: &MissingPiece) -> Self {
        let wrong = piece.defect.recovered_from(&piece.path);
        Self { wrong, span: Some(piece.span), topics: piece.topics.clone() }
    }

    pub(super) fn metadata(&self) -> Metadata {
        let mut entries = vec![("wrong", self.wrong.clone())];
        if let Some((first, last)) = self.span {
            entries.extend([("first", first.to_string()), ("last", last.to_string())]);
        }
        if let Some(topics) = &self.topics {
            let channels = topics.iter().map(|topic| format::channel(*topic).to_string());
            entries.push(("channels", channels.collect::<Vec<_>>().join(" ")));
        }
        let entries = entries.into_iter().map(|(name, value)| (name.to_owned(), value));
        Metadata { name: NAME.to_owned(), metadata: entries.collect() }
    }

    pub(super) fn of(metadata: &Metadata) -> Option<Self> {
        if metadata.name != NAME {
            return None;
        }
        let entry = |name: &str| metadata.metadata.get(name);
        let time = |name: &str| entry(name).and_then(|time| time.parse().ok());
        let names = format::topics();
        let topics = entry("channels").map(|channels| {
            let channels = channels.split(' ').filter_map(|channel| channel.parse().ok());
            channels.filter_map(|channel: u16| names.get(&channel).copied()).collect()
        });
        let span = time("first").zip(time("last"));
        // The file may be foreign: it must not control the terminal.
        let wrong = entry("wrong")?.replace(char::is_control, "\u{FFFD}");
        Some(Self { wrong, span, topics })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn piece() -> MissingPiece {
        MissingPiece {
            path: "takes/one.mcap".into(),
            defect: Defect::damage(4711, "no chunk"),
            span: (3_500_000_000, 4_250_000_000),
            began: 1_000_000_000,
            topics: Some(vec![Topic::Ticks, Topic::Block(87)]),
        }
    }

    #[test]
    fn a_note_comes_back_from_its_metadata_and_commands_no_terminal() {
        let note = MissingNote::new(&piece());
        assert_eq!(MissingNote::of(&note.metadata()), Some(note.clone()));
        assert!(note.wrong.starts_with("was recovered from one.mcap, which is damaged at byte"));
        let end = MissingNote { wrong: "broke off".into(), span: None, topics: None };
        assert_eq!(MissingNote::of(&end.metadata()), Some(end.clone()));
        let hostile = MissingNote { wrong: "\u{1b}[2Jgone\n".into(), ..end };
        let read = MissingNote::of(&hostile.metadata()).map(|it| it.wrong);
        assert_eq!(read.as_deref(), Some("\u{FFFD}[2Jgone\u{FFFD}"));
    }
}
