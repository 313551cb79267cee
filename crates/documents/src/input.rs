//! Files that people name are opened without waiting for a pipe that nobody writes into.

use std::fs::File;
use std::io::{self, Read as _};
use std::path::Path;

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{CWD, Mode, OFlags, fcntl_setfl, openat};

/// Time in which a program begins to write into a pipe that is read.
const PATIENCE: Timespec = Timespec { tv_sec: 1, tv_nsec: 0 };

/// Opens a file, or a pipe into which a program writes.
///
/// A pipe that nobody opens for writing meanwhile is empty: it would be waited for without end.
///
/// # Errors
/// If it cannot be opened.
pub fn open_input(path: &Path) -> io::Result<File> {
    let flags = OFlags::RDONLY | OFlags::CLOEXEC | OFlags::NONBLOCK | OFlags::NOCTTY;
    let opened = openat(CWD, path, flags, Mode::empty())?;
    let _readable = poll(&mut [PollFd::new(&opened, PollFlags::IN)], Some(&PATIENCE))?;
    fcntl_setfl(&opened, OFlags::empty())?;
    Ok(File::from(opened))
}

/// Returns what [`open_input`] opens at `path`: of a file that is longer than `longest` bytes, one
/// byte more.
///
/// # Errors
/// If it cannot be read.
pub fn read_input(path: &Path, longest: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    open_input(path)?.take(longest + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
