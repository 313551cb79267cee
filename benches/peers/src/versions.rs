//! Versions of the codes, and the machine.

use std::fs;
use std::process::Command;

use serde::Serialize;

const LOCK: &str = include_str!("../Cargo.lock");

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

/// Machine and tools: a time means nothing without them.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Machine {
    pub(crate) cpu: String,
    pub(crate) cores: usize,
    pub(crate) kernel: String,
    pub(crate) rustc: String,
    pub(crate) date: String,
}

impl Machine {
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
