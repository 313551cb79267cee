//! Bytes in and out without waiting.

use rustix::fd::{AsFd, BorrowedFd, OwnedFd};
use rustix::io::{Errno, ioctl_fionread};

#[derive(Debug)]
pub(crate) struct NonBlockingFd(OwnedFd);

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Disconnected;

impl NonBlockingFd {
    pub(super) const fn new(descriptor: OwnedFd) -> Self {
        Self(descriptor)
    }

    /// Reads available bytes, up to the length of `bytes`, which is not 0; returns their number.
    ///
    /// Asks for the number of bytes first. Linux lets a read of an empty terminal wait until a
    /// worker thread has moved the bytes under way (`n_tty_read`), even without blocking. The
    /// worker has no priority: on a busy machine, that took up to 0.3 s.
    pub(crate) fn read(&self, bytes: &mut [u8]) -> Result<usize, Disconnected> {
        if ioctl_fionread(&self.0).map_err(|_hung_up| Disconnected)? == 0 {
            return Ok(0);
        }
        match rustix::io::read(&self.0, bytes) {
            // A terminal that was hung up is at its end.
            Ok(0) => Err(Disconnected),
            outcome => taken(outcome),
        }
    }

    /// Writes the first part of `bytes`, as far as there is room; returns its length.
    pub(crate) fn write(&self, bytes: &[u8]) -> Result<usize, Disconnected> {
        taken(rustix::io::write(&self.0, bytes))
    }
}

impl AsFd for NonBlockingFd {
    fn as_fd(&self) -> BorrowedFd<'_> {
        self.0.as_fd()
    }
}

/// Returns 0 for a call that would have waited; any other error is final.
const fn taken(outcome: Result<usize, Errno>) -> Result<usize, Disconnected> {
    match outcome {
        Ok(n) => Ok(n),
        Err(Errno::AGAIN | Errno::INTR) => Ok(0),
        Err(_broken) => Err(Disconnected),
    }
}
