//! What the supervisor of `letoff run --supervised` tells the host that it starts.

use std::path::PathBuf;

use clap::Args;
use rustix::process::{Pid, Signal, getppid, set_parent_process_death_signal};

use super::{Failure, system};

/// What a supervisor tells the host that it starts.
#[derive(Clone, Debug, Args)]
pub(crate) struct SupervisorArgs {
    /// The process whose end also ends the host.
    #[arg(long, value_name = "PID", hide = true)]
    supervisor: Option<i32>,
    /// Where the last minutes are kept for when the host is killed.
    #[arg(long, value_name = "FILE", hide = true)]
    pub(super) last_minutes: Option<PathBuf>,
}

impl SupervisorArgs {
    /// Has the system end this process, in good order, when its supervisor is gone.
    pub(super) fn end_with_it(&self) -> Result<(), Failure> {
        let Some(supervisor) = self.supervisor else { return Ok(()) };
        set_parent_process_death_signal(Some(Signal::TERM))
            .map_err(|error| system(error.into()))?;
        // It may have gone before the system knew.
        if getppid().map(Pid::as_raw_nonzero).map(i32::from) == Some(supervisor) {
            return Ok(());
        }
        Err(Failure::Running("the supervisor has ended before its host began".to_owned()))
    }
}
