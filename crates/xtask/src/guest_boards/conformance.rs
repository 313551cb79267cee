//! The boards crate's own tests of links, for a real interface.

use std::path::PathBuf;

use crate::command::{self, cargo};

/// Builds the tests; `None` if that fails, which the guest reports.
pub(super) fn program() -> Option<PathBuf> {
    // Select the whole workspace as the tests do, so that nothing is compiled again.
    let arguments = ["--workspace", "--test", "conformance", "--no-run"];
    let mut command = cargo(["test", "--quiet", "--message-format=json"]);
    command.args(arguments).stderr(std::process::Stdio::inherit());
    println!("$ {}", command::words(&command));
    let output = command.output().ok()?;
    let messages = String::from_utf8_lossy(&output.stdout);
    executable(&messages).map(PathBuf::from)
}

fn executable(messages: &str) -> Option<&str> {
    const BEFORE: &str = "\"executable\":\"";
    let its = |line: &&str| line.contains("\"name\":\"conformance\"") && line.contains(BEFORE);
    let line = messages.lines().find(its)?;
    line.split_once(BEFORE)?.1.split('"').next()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_program_is_found_among_cargo_s_messages() {
        let messages = "{\"reason\":\"compiler-artifact\",\"target\":{\"name\":\"hardware\"},\
                        \"executable\":null}\n{\"target\":{\"name\":\"conformance\"},\
                        \"executable\":\"/target/debug/deps/conformance-1\",\"fresh\":true}\n";
        assert_eq!(executable(messages), Some("/target/debug/deps/conformance-1"));
        assert_eq!(executable("{\"reason\":\"build-finished\",\"success\":false}\n"), None);
    }
}
