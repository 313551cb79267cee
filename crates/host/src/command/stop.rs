//! `letoff stop`: no force on any key, at once.

use std::io::Write;

use super::Failure;
use crate::control::{Reply, Stop, StopKind, send, socket_path};

/// Stops the running host of this user, and with it every board.
pub(super) fn run(out: &mut dyn Write) -> Result<(), Failure> {
    match send(&socket_path(), &Stop { stop: StopKind::Emergency }) {
        Ok(Reply::Stopped) => {
            writeln!(out, "stopped: no board renders a force until it is started anew")?;
            Ok(())
        }
        Ok(Reply::Switched(_)) => Err(Failure::Running("the host did something else".into())),
        Ok(Reply::Refused(why)) => Err(Failure::Running(why)),
        Err(error) => Err(Failure::Running(error.to_string())),
    }
}
