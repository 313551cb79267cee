//! `letoff stop`: no force on any key, at once.

use std::io::Write;

use super::{Failure, ask};
use host::control::Request;

/// Stops the running host of this user, and with it every board.
pub(super) fn run(out: &mut dyn Write) -> Result<(), Failure> {
    ask::ask(&Request::Stop {}, Failure::Running, out)
}
