//! Sends a request to the running host of this user or of the service, and prints the reply.

use std::io::Write;

use super::Failure;
use host::control::{Reply, Request, send_to_host};
use telemetry::request::KeyFigure;

pub(super) fn ask(
    request: &Request,
    refused: fn(String) -> Failure,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let answer = send_to_host(request).map_err(|error| Failure::Running(error.to_string()))?;
    match answer.map_err(refused)? {
        Reply::Done { text } | Reply::Stopped { text, .. } => writeln!(out, "{text}")?,
        Reply::Scene { toml } => write!(out, "{toml}")?,
        Reply::Where { address, token: _ } => writeln!(out, "{address}")?,
        Reply::Status { status } => writeln!(out, "{}", status.line())?,
        Reply::Figures { figures, warnings, .. } => {
            for KeyFigure { title, value, .. } in figures {
                writeln!(out, "{title:66} {value:>10.3}")?;
            }
            if !warnings.is_empty() {
                return Err(Failure::Running(warnings.join("\n")));
            }
        }
    }
    Ok(())
}
