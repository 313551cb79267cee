//! Recordings: what a host told, in files that public viewers read.
//!
//! A recording is [MCAP](https://mcap.dev): the same topics and messages as on the stream, with
//! their schemas, in compressed chunks.
//! [`Recorder`] writes one and goes on in another file when one is full, [`Recording`] reads what
//! is there of one, [`Playback`] lets a window see it as if it were live, [`BlackBox`] keeps the
//! last seconds to be written when something fails, [`recover`] makes a complete file of one that
//! breaks off, and [`export_csv`] makes tables of it.
//!
//! Nothing here reads a clock: time comes with the messages, or from the caller.
//!
//! A file holds, in this order:
//!
//! | what | why |
//! |---|---|
//! | header, profile `letoff` | says who wrote it |
//! | metadata `letoff` | format version, run, and which file of the recording it is |
//! | chunks | messages with their schemas; none is open for longer than a second |
//! | metadata, catalogue and voices, said again | after the first chunk, every half minute and at the end: a damaged piece takes none of them away |
//! | metadata `letoff.missing`, in a recovered file | what is not there in its place, and why; at the end, that the old file broke off |
//! | summary | where the chunks are; missing if the host died, and then found again by reading |
//!
//! A file that is not a recording's first begins with the last catalogue and the last voice of
//! every key, so that it can be understood alone. Whatever is said again stands under the time at
//! which that is done, with the time at which it was made as MCAP's publish time; who reads a
//! recording gets it only where what was said before is not there or cannot be read.

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
