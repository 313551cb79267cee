//! One run of the program, with limits of memory and processor time.

use std::process::{Command, Stdio};
use std::{io, path::Path};

const MEMORY: &str = "3000000";

/// Limit of the processor time (s), enforced by the system.
const CPU: &str = "20";

/// Limit of the time (s), for a program that waits.
const PATIENCE: &str = "120";

/// Processor time that a run may always take (s).
const SHORT: f64 = 5.0;

/// Longest processor time of a passing run in that of the undamaged file, on the same machine.
const SLOWER: f64 = 3.0;

/// Runs the program, then prints the processor time of all children in POSIX form.
const SCRIPT: &str = "\
ulimit -v \"$1\"; ulimit -t \"$2\"; ulimit -c 0
timeout -s KILL \"$3\" \"$0\" \"${@:4}\" >/dev/null
code=$?; times; exit $code";

pub(super) struct FuzzTrial {
    pub(super) code: Option<i32>,
    /// Processor time of the program (s).
    pub(super) cpu: f64,
    stderr: String,
}

impl FuzzTrial {
    pub(super) fn run(program: &Path, folder: &Path, arguments: &[String]) -> io::Result<Self> {
        let mut shell = Command::new("bash");
        shell.args(["-c", SCRIPT]).arg(program).args([MEMORY, CPU, PATIENCE]).args(arguments);
        shell.current_dir(folder).env("LETOFF_SOCKET", folder.join("socket"));
        shell.env("XDG_CONFIG_HOME", folder).stdin(Stdio::null());
        let output = shell.output()?;
        let times = String::from_utf8_lossy(&output.stdout).into_owned();
        Ok(Self {
            code: output.status.code(),
            cpu: times.lines().nth(1).map_or(f64::NAN, seconds),
            stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
        })
    }

    /// Returns the failure of the run, if any, where the undamaged file takes `usual` (s).
    pub(super) fn failure(&self, usual: f64) -> Option<String> {
        let aloud = ["panicked at", "overflowed its stack", "memory allocation of"];
        let code = self.code.unwrap_or(-1);
        if let Some(line) =
            self.stderr.lines().find(|line| aloud.iter().any(|it| line.contains(it)))
        {
            Some(format!("exit code {code}, {line}"))
        } else if !(0..=2).contains(&code) {
            Some(format!("exit code {code}"))
        } else if self.cpu.is_nan() || SHORT.max(SLOWER * usual) < self.cpu {
            Some(format!("{:.1} s of processor time", self.cpu))
        } else {
            None
        }
    }
}

/// Parses a line of `times`, "0m0.120s 0m0.030s", as the sum (s).
fn seconds(line: &str) -> f64 {
    let one = |time: &str| {
        let (minutes, seconds) = time.strip_suffix('s')?.split_once('m')?;
        Some(minutes.parse::<f64>().ok()? * 60.0 + seconds.parse::<f64>().ok()?)
    };
    line.split_whitespace().map(|time| one(time).unwrap_or(f64::NAN)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(script: &str, failure: Option<&str>) {
        let run = FuzzTrial::run(Path::new("sh"), Path::new("/"), &["-c".into(), script.into()]);
        let failed = run.expect("bash").failure(0.0);
        assert_eq!(failed.is_some(), failure.is_some(), "{script}: {failed:?}");
        assert!(failed.is_none_or(|it| it.contains(failure.unwrap_or_default())), "{script}");
    }

    #[test]
    fn only_documented_exit_codes_without_a_panic_are_right() {
        check("exit 2", None);
        check("exit 3", Some("exit code 3"));
        check("kill -SEGV $$", Some("exit code 139"));
        check("echo \"thread 'x' panicked at y\" >&2; exit 1", Some("panicked at y"));
    }

    #[test]
    fn processor_time_is_counted_in_seconds() {
        assert!((seconds("0m0.120s 1m0.030s") - 60.15).abs() < 1e-9);
        assert!(seconds("nonsense").is_nan());
    }
}
