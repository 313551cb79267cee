//! Plays to real ALSA ports in a guest; `checks.sh` contains the expectations.

use std::time::Duration;

use crate::guest::{GuestCheck, GuestSystem, SCENE, TriedProgram, piece};
use crate::tools::Tool;

const PROGRAMS: [Tool; 2] = [("aseqdump", "alsa-utils"), ("aconnect", "alsa-utils")];

/// Returns the guest with the sequencer, four virtual cables, and Midi Through.
pub(crate) fn guest(program: TriedProgram) -> GuestCheck {
    GuestCheck {
        name: "midi",
        plays_on: "real ALSA ports",
        system: GuestSystem::Busybox,
        modules: &["snd-seq", "snd-virmidi", "snd-seq-dummy"],
        programs: &PROGRAMS,
        // alsa-lib reads this first.
        copies: &["/usr/share/alsa/alsa.conf"],
        more: Vec::new(),
        files: vec![
            ("scene.toml", SCENE.into()),
            ("piece.mid", piece::file()),
            ("checks.sh", include_str!("checks.sh").into()),
        ],
        parts: &["midi"],
        // It takes three minutes of one processor.
        time_limit: Duration::from_mins(20),
        program,
    }
}
