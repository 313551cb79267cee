//! One run of the program, with limits of memory and processor time.

use std::io;
use std::path::Path;
use std::process::{Command, Stdio};

/// Most memory that the program may ask for (KiB).
const MEMORY: &str = "3000000";

/// Processor time after which the system ends the program (s).
const CPU: &str = "20";

/// Time after which a program is ended that waits for something (s).
const PATIENCE: &str = "120";

/// Longest processor time that an answer may take (s).
const SLOW: f64 = 5.0;

/// Runs the program, then prints the processor time of all children, as POSIX has it.
const SCRIPT: &str = "\
ulimit -v \"$1\"; ulimit -t \"$2\"; ulimit -c 0
timeout -s KILL \"$3\" \"$0\" \"${@:4}\" >/dev/null
code=$?; times; exit $code";

/// What became of a run.
pub(super) struct FuzzTrial {
    pub(super) code: Option<i32>,
    /// Processor time of the program (s).
    pub(super) cpu: f64,
    stderr: String,
}

impl FuzzTrial {
    /// Runs `program` with `arguments` in `folder`.
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

    /// Returns what is wrong with the run, if anything is.
    pub(super) fn failure(&self) -> Option<String> {
        let aloud = ["panicked at", "overflowed its stack", "memory allocation of"];
        let code = self.code.unwrap_or(-1);
        if let Some(line) =
            self.stderr.lines().find(|line| aloud.iter().any(|it| line.contains(it)))
        {
            Some(format!("exit code {code}, {line}"))
        } else if !(0..=2).contains(&code) {
            Some(format!("exit code {code}"))
        } else if self.cpu.is_nan() || SLOW < self.cpu {
            Some(format!("{:.1} s of processor time", self.cpu))
        } else {
            None
        }
    }
}

/// Reads a line of `times`, "0m0.120s 0m0.030s": the sum (s).
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
        let failed = run.expect("bash").failure();
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
