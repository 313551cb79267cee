//! Opens input files without waiting forever for a pipe that has no writer.

use std::io::{self, Read as _};
use std::{fs::File, path::Path};

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{CWD, Mode, OFlags, fcntl_setfl, openat};

/// Time for a program to start writing into the pipe.
const PATIENCE: Timespec = Timespec { tv_sec: 1, tv_nsec: 0 };

/// Opens a file, or a pipe into which a program writes.
///
/// A pipe without a writer within 1 s reads as empty. A blocking read would never return.
pub fn open_input(path: &Path) -> io::Result<File> {
    let flags = OFlags::RDONLY | OFlags::CLOEXEC | OFlags::NONBLOCK | OFlags::NOCTTY;
    let opened = openat(CWD, path, flags, Mode::empty())?;
    let _readable = poll(&mut [PollFd::new(&opened, PollFlags::IN)], Some(&PATIENCE))?;
    fcntl_setfl(&opened, OFlags::empty())?;
    Ok(File::from(opened))
}

/// Reads what [`open_input`] opens: of a file longer than `longest` bytes, one byte more.
pub fn read_input(path: &Path, longest: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    open_input(path)?.take(longest + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
