//! The folder of a supervised host: its scene and piece, and where its MIDI goes.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io;
use std::os::unix::fs::OpenOptionsExt as _;
use std::path::{Path, PathBuf};

use midi::{Message, MidiSendError, Output as _, Smf};
use rustix::fs::{CWD, FileType, Mode, OFlags, mknodat};

/// A chord that is held until the end of the piece, and a note that is repeated above it.
const CHORD: [u8; 3] = [60, 64, 67];
const REPEATED: u8 = 72;
/// Length of the piece (ms): more than a host plays before it is killed.
const LENGTH: u32 = 60_000;

/// The program that supervises a host, which a trial starts and whose host it kills.
#[derive(Clone, Debug)]
pub struct SupervisedProgram {
    pub program: PathBuf,
    /// What is typed behind it, so that it uses the files of [`HostFiles`].
    pub arguments: Vec<OsString>,
    /// Variables of its environment that are set.
    pub environment: Vec<(OsString, OsString)>,
}

/// The files of a supervised host.
#[derive(Clone, Debug)]
pub struct HostFiles {
    pub(crate) folder: PathBuf,
    /// The scene that it plays.
    pub scene: PathBuf,
    /// The device that it sends MIDI to.
    pub midi: PathBuf,
    /// The socket at which `letoff stop` reaches it.
    pub socket: PathBuf,
    /// The folder where it keeps the minutes before a crash.
    pub last_minutes: PathBuf,
}

impl HostFiles {
    /// The scene: an octave, so that the piece beside it is rehearsed at once.
    pub const SCENE: &str = r#"
tick_hz = 1000
[[keys]]
range = "C4..C5"
instrument = "grand-springs"
[links]
kind = "simulated"
[pianist]
performance = "piece.mid"
"#;

    /// Returns where they are in the folder of a trial.
    pub fn in_folder(folder: &Path) -> Self {
        let folder = folder.join("killed");
        Self {
            scene: folder.join("scene.toml"),
            midi: folder.join("midi"),
            socket: folder.join("socket"),
            last_minutes: folder.join("last-minutes"),
            folder,
        }
    }

    /// Makes them anew, and returns the other end of its MIDI, which no reading waits for.
    pub(crate) fn make(&self) -> io::Result<File> {
        match fs::remove_dir_all(&self.folder) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            Ok(()) | Err(_) => {}
        }
        fs::create_dir_all(&self.folder)?;
        fs::write(&self.scene, Self::SCENE)?;
        piece(&self.folder.join("piece.mid"))
            .and_then(|mut it| it.finish())
            .map_err(io::Error::other)?;
        mknodat(CWD, &self.midi, FileType::Fifo, Mode::RUSR | Mode::WUSR, 0)?;
        // Open for writing, too: a host that dies is no end.
        let mut options = OpenOptions::new();
        let flags = i32::try_from(OFlags::NONBLOCK.bits()).unwrap_or_default();
        options.read(true).write(true).custom_flags(flags).open(&self.midi)
    }
}

/// Returns the piece, which is to be written to `path`.
fn piece(path: &Path) -> Result<Smf, MidiSendError> {
    let mut piece = Smf::new(path);
    let mut send = |ms: u32, is_on: bool, note: u8| {
        let bytes = if is_on { [0x90, note, 70] } else { [0x80, note, 64] };
        // All of them are messages.
        let message = Message::decode(&bytes);
        message.map_or(Ok(()), |message| piece.send(f64::from(ms) * 1e-3, message))
    };
    CHORD.iter().try_for_each(|note| send(500, true, *note))?;
    for at in (1000..LENGTH).step_by(500) {
        send(at, true, REPEATED)?;
        send(at + 250, false, REPEATED)?;
    }
    CHORD.iter().try_for_each(|note| send(LENGTH, false, *note))?;
    Ok(piece)
}

#[cfg(test)]
mod tests {
    use realtime::clock::nearest_integer;

    use super::*;

    #[test]
    fn the_piece_has_its_notes_at_their_times() {
        let piece = piece(Path::new("piece.mid")).expect("times that there are");
        let strike = |(at, message): &(f64, Message)| match *message.encode() {
            [0x90, note, 70] => Some((nearest_integer(at * 1e3), note)),
            _ => None,
        };
        let score: Vec<_> = piece.messages().iter().filter_map(strike).collect();
        assert_eq!(score.first(), Some(&(500, CHORD[0])));
        assert_eq!(score.last(), Some(&(u64::from(LENGTH) - 500, REPEATED)));
        assert_eq!(score.len(), 3 + 118);
        assert_eq!(piece.messages().len(), 2 * score.len(), "each of them ends");
    }
}
