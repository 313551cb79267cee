//! `letoff stop`: removes all forces at once.

use std::io::Write;

use super::{Failure, tell};
use host::control::{AskedHost, Reply, hosts_elsewhere, stop_hosts};

pub(super) fn run(out: &mut dyn Write) -> Result<(), Failure> {
    let stopped = report(&stop_hosts(), out);
    for pid in hosts_elsewhere() {
        tell(&format!(
            "another host of yours plays on (process {pid}): `env -u LETOFF_SOCKET letoff stop`"
        ));
    }
    stopped
}

fn report(asked: &[AskedHost], out: &mut dyn Write) -> Result<(), Failure> {
    let mut failures = Vec::new();
    for AskedHost { name, answer } in asked {
        let name = if asked.len() == 1 { String::new() } else { format!("{name}: ") };
        match answer {
            Ok(Ok(Reply::Stopped { text, told, boards })) if told == boards => {
                writeln!(out, "{name}{text}")?;
            }
            Ok(Ok(Reply::Stopped { text, .. }) | Err(text)) => {
                failures.push(format!("{name}{text}"));
            }
            Ok(Ok(
                Reply::Done { .. }
                | Reply::Scene { .. }
                | Reply::Where { .. }
                | Reply::Figures { .. }
                | Reply::Status { .. },
            )) => failures.push(format!("{name}what answered is no host of this version")),
            Err(error) => failures.push(format!("{name}{error}")),
        }
    }
    if failures.is_empty() { Ok(()) } else { Err(Failure::Running(failures.join("\nletoff: "))) }
}
