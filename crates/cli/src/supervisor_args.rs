//! What the supervisor of `letoff run --supervised` tells the host that it starts.

use std::fs;
use std::path::PathBuf;

use clap::Args;
use rustix::process::{Pid, Signal, getppid, set_parent_process_death_signal};

use super::{Failure, system, tell};

/// What a supervisor tells the host that it starts.
#[derive(Clone, Debug, Args)]
pub(crate) struct SupervisorArgs {
    /// The process whose end also ends the host.
    #[arg(long, value_name = "PID", hide = true)]
    supervisor: Option<i32>,
    /// Where the last minutes are kept for when the host is killed.
    #[arg(long, value_name = "FILE", hide = true)]
    pub(super) last_minutes: Option<PathBuf>,
    /// Where the text of the scene is kept that was taken last; it is played if there is one.
    #[arg(long, value_name = "FILE", hide = true)]
    last_scene: Option<PathBuf>,
}

impl SupervisorArgs {
    /// Returns the text of the scene that the host before this one has taken; none if there was no
    /// host before.
    pub(super) fn last_scene(&self) -> Option<String> {
        fs::read_to_string(self.last_scene.as_ref()?).ok()
    }

    /// Keeps `text` for the host that is started after a crash, which then depends on no file that
    /// is being edited.
    pub(super) fn keep_scene(&self, text: &str) {
        let Some(file) = &self.last_scene else { return };
        let part = file.with_extension("part");
        if let Err(error) = fs::write(&part, text).and_then(|()| fs::rename(&part, file)) {
            tell(&format!("after a crash the scene would be read again from its file: {error}"));
        }
    }

    /// Forgets the scene, at an end in good order: the supervisor may have gone before.
    pub(super) fn forget_scene(&self) {
        let _gone = self.last_scene.as_ref().map(fs::remove_file);
    }

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
