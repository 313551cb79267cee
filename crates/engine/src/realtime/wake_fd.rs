//! Wakes the MIDI thread from the tick: one non-blocking write on a descriptor opened before.

use std::io;
use std::os::fd::OwnedFd;
use std::time::Duration;

use rustix::event::{EventfdFlags, PollFd, PollFlags, Timespec, eventfd, poll};

/// An eventfd that one thread signals and another waits for.
#[derive(Debug)]
pub struct WakeFd(OwnedFd);

impl WakeFd {
    /// Returns a descriptor that is not signalled.
    ///
    /// # Errors
    /// If the system has no descriptor left.
    pub fn new() -> io::Result<Self> {
        Ok(Self(eventfd(0, EventfdFlags::NONBLOCK | EventfdFlags::CLOEXEC)?))
    }

    /// Signals the descriptor; never waits.
    ///
    /// # Real-time
    /// One non-blocking write. It may fail if the descriptor is signalled already.
    pub fn ring(&self) {
        let _already_ringing = rustix::io::write(&self.0, &1_u64.to_ne_bytes());
    }

    /// Waits until the descriptor is signalled, or `patience` is over; not for the tick.
    pub fn wait(&self, patience: Duration) {
        let timeout = Timespec::try_from(patience).ok();
        let mut fds = [PollFd::new(&self.0, PollFlags::IN)];
        // The caller checks its ring in any case: signalled, timed out or interrupted.
        let _why = poll(&mut fds, timeout.as_ref());
        let _silenced = rustix::io::read(&self.0, &mut [0_u8; 8]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ringing_before_waiting_is_not_lost() {
        let bell = WakeFd::new().expect("an eventfd");
        bell.ring();
        bell.ring();
        bell.wait(Duration::from_hours(1));
    }
}
