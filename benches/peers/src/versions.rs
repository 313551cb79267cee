//! Which version of a code was run, and on which machine.

use std::fs;
use std::process::Command;

use serde::Serialize;

/// The lock file that this program was built from.
const LOCK: &str = include_str!("../Cargo.lock");

/// The version of a Rust code; "-" for what has none.
pub(crate) fn version(code: &str) -> String {
    if code == "handwritten" {
        return "-".to_owned();
    }
    let mut lines = LOCK.lines();
    let name = format!("name = \"{code}\"");
    let found = lines.find(|line| **line == name).and_then(|_| lines.next());
    let version = found.and_then(|line| line.split('"').nth(1));
    version.unwrap_or("-").to_owned()
}

/// The machine and the tools: a time means nothing without them.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Machine {
    pub(crate) cpu: String,
    /// Number of cores that the system has.
    pub(crate) cores: usize,
    /// Kernel and its release.
    pub(crate) kernel: String,
    /// The compiler that built the Rust codes.
    pub(crate) rustc: String,
    pub(crate) date: String,
}

impl Machine {
    /// This machine, now.
    pub(crate) fn here() -> Self {
        Self {
            cpu: cpu().unwrap_or_else(|| "unknown".to_owned()),
            cores: std::thread::available_parallelism().map_or(0, usize::from),
            kernel: said("uname", &["-sr"]),
            rustc: said("rustc", &["--version"]),
            date: said("date", &["-u", "+%Y-%m-%d"]),
        }
    }
}

fn cpu() -> Option<String> {
    let info = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = info.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// What a program prints, or "unknown".
fn said(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).output();
    let text = output.map(|it| String::from_utf8_lossy(&it.stdout).trim().to_owned());
    text.ok().filter(|text| !text.is_empty()).unwrap_or_else(|| "unknown".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_those_of_the_lock_file() {
        assert_eq!(version("differential-equations"), "0.7.0");
        assert_eq!(version("ode_solvers"), "0.6.2");
        assert_eq!(version("handwritten"), "-");
    }
}
