//! MIDI bytes written to a device file or a FIFO.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::os::unix::fs::{FileTypeExt as _, OpenOptionsExt as _};
use std::path::{Path, PathBuf};

use documents::shown;
use rustix::fs::OFlags;

use super::reconnecting::{MidiSystem, ReconnectingPort};
use super::{MidiSendError, Output, Unavailable};
use crate::message::Message;

/// Writes raw MIDI bytes to a MIDI device, as `/dev/snd/midiC1D0`, or a FIFO.
///
/// Writing never waits: a message that a device or reader does not accept at once is lost. The
/// notes that it may still sound end when it accepts messages again.
#[derive(Debug)]
pub struct RawPort(ReconnectingPort<DeviceFile>);

impl RawPort {
    /// Opens the device or FIFO at `path`.
    ///
    /// # Errors
    /// It does not exist, may not be written to, or is a FIFO without a reader.
    pub fn open(path: &Path) -> Result<Self, Unavailable> {
        let device = DeviceFile { path: path.to_owned(), file: None };
        ReconnectingPort::connect(device, shown(path)).map(Self)
    }

    /// Keeps a ledger in `folder`: see [`ReconnectingPort::keep_ledger`].
    pub fn keep_ledger(&mut self, folder: &Path) -> io::Result<()> {
        self.0.keep_ledger(folder)
    }
}

impl Output for RawPort {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        self.0.send(at, message)
    }

    fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        self.0.poll(now)
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        Ok(())
    }
}

#[derive(Debug)]
struct DeviceFile {
    path: PathBuf,
    file: Option<File>,
}

impl DeviceFile {
    fn open(&self) -> Result<File, String> {
        let told = |error: io::Error| {
            if error.kind() == io::ErrorKind::NotFound {
                return "there is no such file; `ls /dev/snd` shows MIDI devices".to_owned();
            }
            if error.kind() == io::ErrorKind::PermissionDenied {
                return "it may not be opened; join the group audio, and log in again".to_owned();
            }
            error.to_string()
        };
        let kind = fs::metadata(&self.path).map_err(told)?.file_type();
        if !kind.is_char_device() && !kind.is_fifo() {
            return Err(
                "it is neither a device nor a FIFO; a name that ends in .mid writes a file"
                    .to_owned(),
            );
        }
        let flags = i32::try_from((OFlags::NONBLOCK | OFlags::NOCTTY).bits()).unwrap_or_default();
        let opened = OpenOptions::new().write(true).custom_flags(flags).open(&self.path);
        opened.map_err(|error| {
            let is_unread = error.raw_os_error() == Some(rustix::io::Errno::NXIO.raw_os_error());
            if is_unread && kind.is_fifo() {
                return "nothing reads from it; start the reader first".to_owned();
            }
            told(error)
        })
    }
}

impl MidiSystem for DeviceFile {
    fn connect(&mut self) -> Result<(), Unavailable> {
        self.file = None;
        let opened = self.open();
        let path = || shown(&self.path);
        self.file = Some(opened.map_err(|reason| Unavailable::NoDevice { path: path(), reason })?);
        Ok(())
    }

    fn send(&mut self, bytes: &[u8]) -> bool {
        self.file.as_mut().is_some_and(|file| file.write_all(bytes).is_ok())
    }

    fn is_there(&mut self) -> bool {
        self.file.is_some()
    }

    fn destination(&self) -> Option<String> {
        Some(format!("raw:{}", self.path.to_string_lossy()))
    }
}

#[cfg(test)]
mod tests {
    use std::io::Read as _;

    use super::*;
    use crate::note::{Note, Velocity};

    /// Returns a FIFO, removed after its test.
    fn fifo() -> tempfile::TempPath {
        let make = |path: &Path| {
            let mode = rustix::fs::Mode::RUSR | rustix::fs::Mode::WUSR;
            rustix::fs::mknodat(rustix::fs::CWD, path, rustix::fs::FileType::Fifo, mode, 0)?;
            Ok(())
        };
        tempfile::Builder::new().make(make).unwrap().into_temp_path()
    }

    fn reader(fifo: &Path) -> File {
        let flags = i32::try_from(OFlags::NONBLOCK.bits()).unwrap();
        OpenOptions::new().read(true).custom_flags(flags).open(fifo).unwrap()
    }

    fn note() -> Note {
        Note::from_number(60).unwrap()
    }

    fn on() -> Message {
        Message::NoteOn { note: note(), velocity: Velocity::MAX }
    }

    fn read(reader: &mut File) -> Vec<u8> {
        let mut bytes = vec![0; 256];
        let n = reader.read(&mut bytes).unwrap();
        bytes.truncate(n);
        bytes
    }

    #[test]
    fn a_fifo_carries_the_bytes_of_a_cable() {
        let fifo = fifo();
        let mut reader = reader(&fifo);
        let mut port = RawPort::open(&fifo).unwrap();
        port.send(0.0, on()).unwrap();
        assert_eq!(read(&mut reader), [0x90, 60, 127]);
    }

    #[test]
    fn a_reader_that_comes_back_hears_note_offs_first() {
        let fifo = fifo();
        let mut port = {
            let _reader = reader(&fifo);
            let mut port = RawPort::open(&fifo).unwrap();
            port.send(0.0, on()).unwrap();
            port
        };
        assert!(port.send(1.0, on()).is_err(), "nobody reads");
        let mut reader = reader(&fifo);
        port.send(2.5, on()).unwrap();
        let bytes = read(&mut reader);
        assert_eq!(bytes[..3], [0x80, 60, 64]);
        assert!(bytes.ends_with(&[0x90, 60, 127]), "{bytes:?}");
    }

    #[test]
    fn what_is_no_device_is_refused_and_left_alone() {
        let fifo = fifo();
        let refused = |path: &Path| RawPort::open(path).unwrap_err().to_string();
        assert!(refused(&fifo).contains("start the reader first"), "{}", refused(&fifo));
        let nowhere = Path::new("/dev/snd/midiC99D0");
        assert!(refused(nowhere).contains("there is no such file"), "{}", refused(nowhere));
        let folder = std::env::temp_dir();
        assert!(refused(&folder).contains("neither a device nor a FIFO"), "{}", refused(&folder));
    }
}
