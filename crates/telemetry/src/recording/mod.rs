//! Recordings of host telemetry, readable by public viewers.
//!
//! A recording is [MCAP](https://mcap.dev): the topics and messages of the stream with their
//! schemas, in compressed chunks. [`Recorder`] writes one, file after file, and [`Recording`] reads
//! it. [`Playback`] shows it to a window as if live, and [`BlackBox`] keeps the last seconds to be
//! written when something fails. [`recover`] completes a file that breaks off, and [`export_csv`]
//! writes tables. Nothing here reads a clock: time comes with the messages, or from the caller.
//!
//! A file contains, in this order:
//!
//! | part | purpose |
//! |---|---|
//! | header, profile `letoff` | names the program that wrote it |
//! | metadata `letoff` | format version, run, and number of the file in the recording |
//! | chunks | messages with their schemas; none is open for longer than a second |
//! | metadata, catalogue and voices, repeated | after the first chunk, every half minute and at the end: a damaged piece destroys none of them |
//! | metadata `letoff.missing`, in a recovered file | the data missing in its place, and why; at the end, that the old file broke off |
//! | summary | positions of the chunks; missing if the host died, and then found by reading |
//!
//! A file other than the first begins with the last catalogue and the last voice of every key, so
//! that it can be understood alone. Repeated messages have the time of the repetition, and as
//! MCAP's publish time the time at which they were made. A reader gets them only if the earlier
//! ones are missing or unreadable.

mod blackbox;
mod chunk;
mod csv;
mod declared;
mod error;
mod file_bytes;
mod format;
mod index;
mod latest;
mod marks;
mod missing;
mod part;
mod part_file;
mod playback;
mod raw_message;
mod reader;
mod recover;
mod rows;
mod settings;
mod walk;
mod writer;
mod zstd;

pub use blackbox::BlackBox;
pub use csv::{Exported, Selection, export_csv};
pub use error::{ExportError, OpenError, ReadError, RecordError};
pub use format::FORMAT;
pub use marks::{Marks, marks};
pub use missing::MissingPiece;
pub use playback::{Playback, PlaybackClock};
pub use reader::{Messages, Recording, Tear};
pub use recover::{RecoverError, Recovered, recover};
pub use rows::{Row, rows};
pub use settings::{RecordingLimits, RecordingSettings};
pub use writer::{Recorder, RecordingStatus};
