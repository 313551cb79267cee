use std::io::{self, BufRead, IsTerminal as _, Write as _};
use std::path::PathBuf;

use boards::calibrate::Bench;
use documents::shown;

use super::CalibrateArgs;
use crate::Failure;

/// The operator, if there is a terminal.
#[derive(Debug)]
pub(super) struct Operator {
    is_there: bool,
    agrees: bool,
}

impl Operator {
    pub(super) fn new(args: &CalibrateArgs) -> Self {
        Self { is_there: io::stdin().is_terminal(), agrees: args.yes }
    }

    pub(super) fn must_be_there(&self, what: &str) -> Result<(), Failure> {
        if self.is_there {
            return Ok(());
        }
        Err(Failure::Usage(format!("{what} needs somebody at a terminal; leave it out here")))
    }

    pub(super) fn may_overwrite(&self, files: &[PathBuf]) -> Result<(), Failure> {
        if files.is_empty() || self.agrees {
            return Ok(());
        }
        let names: Vec<_> = files.iter().map(|it| shown(it)).collect();
        let names = names.join(", ");
        if !self.is_there {
            let text = format!("{names} would be overwritten; give --yes to do so");
            return Err(Failure::Usage(text));
        }
        tell(&format!("overwrite {names}? [y/N] "));
        let mut answer = String::new();
        // An unreadable answer is no consent.
        match io::stdin().lock().read_line(&mut answer).map(|_len| answer.trim()) {
            Ok("y" | "Y" | "yes") => Ok(()),
            Ok(_) | Err(_) => {
                Err(Failure::Usage("nothing was measured, and nothing overwritten".into()))
            }
        }
    }

    /// Asks for an action, and keeps the boards armed meanwhile; returns `false` if stopped.
    pub(super) fn wait_for(bench: &mut Bench, what: &str) -> bool {
        tell(&format!("{what}, then press Enter (Ctrl-D stops) "));
        // The thread ends with the line, or with the program.
        let reader = std::thread::spawn(|| is_line(&mut io::stdin().lock()));
        bench.wait(|| reader.is_finished());
        reader.is_finished() && reader.join().unwrap_or(false)
    }
}

/// Reads a line; `false` at the end of the input.
fn is_line(input: &mut impl BufRead) -> bool {
    input.read_line(&mut String::new()).is_ok_and(|len| 0 < len)
}

fn tell(text: &str) {
    let mut stderr = io::stderr();
    let _unheard = write!(stderr, "{text}").and_then(|()| stderr.flush());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_end_of_input_is_no_enter() {
        assert!(is_line(&mut &b"\n"[..]));
        assert!(!is_line(&mut &b""[..]));
    }
}
