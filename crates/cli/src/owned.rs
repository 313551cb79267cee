//! Programs that this one starts, and that end with it.

use std::io;
use std::process::{Child, Command, ExitStatus};
use std::time::Duration;

use rustix::process::{Pid, Signal, kill_process};

use super::signals::Signals;

/// Between two looks whether a program has ended.
const LOOK: Duration = Duration::from_millis(50);

/// Looks until a program that has nothing to lose is not waited for any longer: five seconds.
const LOOKS: u32 = 100;

/// How a program is made to end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Farewell {
    /// It has nothing to lose: it is asked, and killed if it does not go.
    Brief,
    /// As Ctrl-C would: forces fade and notes end, which takes as long as it takes.
    Patient,
}

/// A program that ends when this is dropped, if it has not before.
#[derive(Debug)]
pub(super) struct Owned {
    child: Child,
    farewell: Farewell,
}

impl Owned {
    /// Starts `command`.
    pub(super) fn start(command: &mut Command, farewell: Farewell) -> io::Result<Self> {
        Ok(Self { child: command.spawn()?, farewell })
    }

    /// How it ended, if it has.
    pub(super) fn ended(&mut self) -> io::Result<Option<ExitStatus>> {
        self.child.try_wait()
    }

    /// Waits until it has ended, and how; nothing if this program is to end before.
    pub(super) async fn end(&mut self, signals: &mut Signals) -> io::Result<Option<ExitStatus>> {
        let mut looks = tokio::time::interval(LOOK);
        loop {
            // Ctrl-C is for both, and then nothing went wrong with the other.
            if signals.come_before(&mut looks).await {
                return Ok(None);
            }
            if let Some(status) = self.ended()? {
                return Ok(Some(status));
            }
        }
    }

    /// Whether it is there; until it was seen to end, its number is nobody else's.
    fn is_there(&mut self) -> bool {
        matches!(self.child.try_wait(), Ok(None))
    }

    fn tell(&self, signal: Signal) {
        let id = i32::try_from(self.child.id()).ok().and_then(Pid::from_raw);
        // One that is gone is as good.
        let _gone = id.map(|id| kill_process(id, signal));
    }

    /// Whether it goes within its time.
    fn goes(&mut self) -> bool {
        for _ in 0..LOOKS {
            if !self.is_there() {
                return true;
            }
            std::thread::sleep(LOOK);
        }
        false
    }
}

impl Drop for Owned {
    fn drop(&mut self) {
        if !self.is_there() {
            return;
        }
        match self.farewell {
            Farewell::Patient => self.tell(Signal::INT),
            Farewell::Brief => {
                self.tell(Signal::TERM);
                if !self.goes() {
                    self.tell(Signal::KILL);
                }
            }
        }
        let _ended = self.child.wait();
    }
}
