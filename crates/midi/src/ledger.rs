//! File with the notes that a port's destination may sound; it outlives the process.
//!
//! Each process that holds a port has its own ledger and locks it as long as it lives. The next
//! process that opens the port ends what unlocked ledgers hold, and removes them.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read as _, Seek as _, Write as _};
use std::path::{Path, PathBuf};

use crate::held::HeldNotes;
use crate::message::Message;

const EXTENSION: &str = "notes";

/// Largest number of ledgers that are read, and of names that are tried for a new one.
const MOST_LEDGERS: usize = 1000;

/// Longest ledger (B): what is held, and the name of the port.
const LONGEST: u64 = 4096;

#[derive(Debug)]
pub(crate) struct NoteLedger {
    file: File,
    path: PathBuf,
    held: HeldNotes,
}

impl NoteLedger {
    /// Creates a ledger in `folder` for the port called `port`. Also returns what dead processes
    /// have left at that port, without what a running one holds there, too.
    pub(crate) fn open(folder: &Path, port: &str) -> io::Result<(Self, HeldNotes)> {
        let mut ledger = Self::create(folder)?;
        let (mut left, mut running) = (HeldNotes::default(), HeldNotes::default());
        let mut found = Vec::new();
        for path in ledgers(folder)?.filter(|path| *path != ledger.path).take(MOST_LEDGERS) {
            let Ok(file) = OpenOptions::new().read(true).write(true).open(&path) else { continue };
            let is_running = match file.try_lock() {
                Ok(()) => false,
                Err(TryLockError::WouldBlock) => true,
                Err(TryLockError::Error(_)) => continue,
            };
            let Some((held, is_this_port)) = read(&file, port) else { continue };
            if is_running && is_this_port {
                running.add(&held);
            } else if !is_running && (is_this_port || held.is_silent()) {
                left.add(&held);
                found.push((path, file));
            }
        }
        left.remove(&running);
        // Write before the others are removed: this process may be killed as well.
        ledger.held = left.clone();
        ledger.rename(port)?;
        for (path, _locked) in found {
            fs::remove_file(path)?;
        }
        Ok((ledger, left))
    }

    fn create(folder: &Path) -> io::Result<Self> {
        let pid = std::process::id();
        let paths = (0..MOST_LEDGERS).map(|n| folder.join(format!("{pid}-{n}.{EXTENSION}")));
        for path in paths {
            match OpenOptions::new().write(true).create_new(true).open(&path) {
                Ok(file) => {
                    file.try_lock()?;
                    return Ok(Self { file, path, held: HeldNotes::default() });
                }
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(io::ErrorKind::AlreadyExists.into())
    }

    /// Assigns the ledger to the port called `port`.
    pub(crate) fn rename(&mut self, port: &str) -> io::Result<()> {
        self.file.set_len(0)?;
        self.write(&[&self.held.to_bytes(), port.as_bytes()].concat())
    }

    /// Writes what `message` begins, before it is sent: the process may be killed at any time.
    pub(crate) fn begin(&mut self, message: Message) -> io::Result<()> {
        let mut held = self.held.clone();
        held.follow(message);
        held.add(&self.held);
        self.note(held)
    }

    /// Writes what `message` has ended, after it was sent.
    pub(crate) fn end(&mut self, message: Message) -> io::Result<()> {
        let mut held = self.held.clone();
        held.follow(message);
        self.note(held)
    }

    fn note(&mut self, held: HeldNotes) -> io::Result<()> {
        if held == self.held {
            return Ok(());
        }
        self.held = held;
        self.write(&self.held.to_bytes())
    }

    fn write(&self, bytes: &[u8]) -> io::Result<()> {
        let mut file = &self.file;
        file.rewind()?;
        file.write_all(bytes)
    }
}

impl Drop for NoteLedger {
    fn drop(&mut self) {
        if self.held.is_silent() {
            let _gone = fs::remove_file(&self.path);
        }
    }
}

fn ledgers(folder: &Path) -> io::Result<impl Iterator<Item = PathBuf>> {
    let paths = fs::read_dir(folder)?.filter_map(|entry| Some(entry.ok()?.path()));
    Ok(paths.filter(|path| path.extension().is_some_and(|end| end == EXTENSION)))
}

/// Returns what a ledger holds, and `true` if it belongs to `port`; `None` if it is still empty.
fn read(file: &File, port: &str) -> Option<(HeldNotes, bool)> {
    let mut bytes = Vec::new();
    file.take(LONGEST).read_to_end(&mut bytes).ok()?;
    let held = HeldNotes::from_bytes(&bytes)?;
    Some((held, bytes.get(HeldNotes::LEN..)? == port.as_bytes()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::note::{Note, Velocity};

    fn on(number: u8) -> Message {
        Message::NoteOn { note: Note::from_number(number).unwrap(), velocity: Velocity::UNKNOWN }
    }

    /// Leaves the file of `ledger` unlocked, as a killed process does.
    fn kill(ledger: NoteLedger) {
        let copy = ledger.path.with_extension("copy");
        let path = ledger.path.clone();
        fs::copy(&path, &copy).unwrap();
        drop(ledger);
        fs::rename(copy, path).unwrap();
    }

    fn offs(mut held: HeldNotes) -> Vec<Vec<u8>> {
        held.release().iter().map(|it| it.encode().to_vec()).collect()
    }

    #[test]
    fn what_a_killed_process_left_is_found_once_and_what_a_running_one_holds_is_not() {
        let folder = tempfile::tempdir().unwrap();
        let open = |port: &str| NoteLedger::open(folder.path(), port).unwrap();
        let (mut killed, left) = open("plug");
        assert!(left.is_silent());
        killed.begin(on(60)).unwrap();
        killed.begin(on(62)).unwrap();
        kill(killed);
        let (mut running, left) = open("other");
        assert!(left.is_silent(), "another port's");
        running.begin(on(64)).unwrap();
        running.rename("plug").unwrap();
        running.begin(on(62)).unwrap();
        let (next, left) = open("plug");
        assert_eq!(offs(left), [[0x80, 60, 64]]);
        kill(next);
        let (_last, left) = open("plug");
        assert_eq!(offs(left), [[0x80, 60, 64]], "killed before it could send");
        drop(running);
    }
}
