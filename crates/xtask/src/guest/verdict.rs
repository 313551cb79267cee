//! The verdict of guests, from the lines of their consoles.

use std::fmt;

use crate::error::Error;

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct HeardNotes {
    n_passed: usize,
    failed: Vec<String>,
    /// Guests that have not reported their end.
    n_unfinished: usize,
}

impl HeardNotes {
    pub(super) const fn of(n_guests: usize) -> Self {
        Self { n_passed: 0, failed: Vec::new(), n_unfinished: n_guests }
    }

    pub(super) fn hear(&mut self, line: &str) {
        if line.starts_with("CHECK passed ") {
            self.n_passed += 1;
        } else if let Some(check) = line.strip_prefix("CHECK FAILED ") {
            self.failed.push(check.trim().to_owned());
        } else if line.starts_with("VERDICT ") {
            self.n_unfinished = self.n_unfinished.saturating_sub(1);
        }
    }

    /// Fails if a check failed, or not all were made.
    pub(super) fn into_result(self) -> Result<(), Error> {
        if self.n_unfinished == 0 && self.failed.is_empty() && 0 < self.n_passed {
            Ok(())
        } else {
            Err(Error::Guest(self.to_string()))
        }
    }
}

impl fmt::Display for HeardNotes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} checks passed, {} failed", self.n_passed, self.failed.len())?;
        if 0 < self.n_unfinished {
            write!(f, ", and {} of the guests did not come to its end", self.n_unfinished)?;
        }
        self.failed.iter().try_for_each(|check| write!(f, "\n  FAILED  {check}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heard(lines: &[&str]) -> HeardNotes {
        let mut verdict = HeardNotes::of(1);
        for line in lines {
            verdict.hear(line);
        }
        verdict
    }

    const PASSED: &str = "CHECK passed  2.4 s: a port (12 note-ons)";
    const FAILED: &str = "CHECK FAILED  9.0 s: another port (3 hanging)";
    const DONE: &str = "VERDICT 0 of 1 checks failed, after 9 s";

    #[test]
    fn checks_that_passed_and_an_end_are_a_pass() {
        assert!(heard(&[PASSED, "letoff devices", DONE]).into_result().is_ok());
    }

    #[test]
    fn a_failed_check_is_named() {
        let error = heard(&[PASSED, FAILED, DONE]).into_result().unwrap_err().to_string();
        assert!(error.contains("1 checks passed, 1 failed"), "{error}");
        assert!(error.contains("another port (3 hanging)"), "{error}");
    }

    #[test]
    fn a_guest_that_hangs_or_checks_nothing_is_no_pass() {
        assert!(heard(&[PASSED]).into_result().is_err());
        assert!(heard(&[DONE]).into_result().is_err());
        assert!(heard(&[]).into_result().is_err());
    }
}
