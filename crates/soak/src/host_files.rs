//! The folder of a supervised host: its scene and piece, and where its MIDI goes.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io;
use std::os::unix::fs::OpenOptionsExt as _;
use std::path::{Path, PathBuf};

use rustix::fs::{CWD, FileType, Mode, OFlags, mknodat};

/// An octave, so that it is rehearsed at once.
const SCENE: &str = r#"
tick_hz = 1000
[[keys]]
range = "C4..C5"
instrument = "grand-springs"
[links]
kind = "simulated"
[pianist]
performance = "piece.mid"
"#;

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
        fs::write(&self.scene, SCENE)?;
        fs::write(self.folder.join("piece.mid"), piece())?;
        mknodat(CWD, &self.midi, FileType::Fifo, Mode::RUSR | Mode::WUSR, 0)?;
        // Open for writing, too: a host that dies is no end.
        let mut options = OpenOptions::new();
        let flags = i32::try_from(OFlags::NONBLOCK.bits()).unwrap_or_default();
        options.read(true).write(true).custom_flags(flags).open(&self.midi)
    }
}

/// Returns the piece as a MIDI file, a tick of which is a millisecond.
fn piece() -> Vec<u8> {
    let mut events: Vec<(u32, [u8; 3])> = CHORD.map(|note| (500, [0x90, note, 70])).to_vec();
    for at in (1000..LENGTH).step_by(500) {
        events.extend([(at, [0x90, REPEATED, 70]), (at + 250, [0x80, REPEATED, 64])]);
    }
    events.extend(CHORD.map(|note| (LENGTH, [0x80, note, 64])));
    let (mut track, mut now) = (Vec::new(), 0);
    for (at, bytes) in events {
        let [.., high, low] = (at - now).to_be_bytes();
        let wait = u16::from_be_bytes([high, low]);
        let [more, last] = [wait >> 7, wait & 0x7f].map(|it| it.to_le_bytes()[0]);
        track.extend([more | 0x80, last]);
        track.extend(bytes);
        now = at;
    }
    track.extend([0, 0xff, 0x2f, 0]);
    // 500 ticks in a quarter note, of which there are two in a second.
    let mut file = b"MThd\0\0\0\x06\0\0\0\x01\x01\xF4MTrk".to_vec();
    file.extend(u32::try_from(track.len()).unwrap_or(u32::MAX).to_be_bytes());
    file.extend(track);
    file
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_piece_has_its_notes_at_their_times() {
        let score = performance_of(&piece());
        assert_eq!(score.first(), Some(&(500, CHORD[0])));
        assert_eq!(score.last(), Some(&(LENGTH - 500, REPEATED)));
        assert_eq!(score.len(), 3 + 118);
    }

    /// The strikes of a file of one track, by their time (ms) and note.
    fn performance_of(file: &[u8]) -> Vec<(u32, u8)> {
        let (mut rest, mut now, mut strikes) = (&file[22..], 0, Vec::new());
        while let [more, last, status, note, _, others @ ..] = rest
            && *more >= 0x80
        {
            now += u32::from(more & 0x7f) * 128 + u32::from(*last);
            strikes.extend((*status == 0x90).then_some((now, *note)));
            rest = others;
        }
        strikes
    }
}
