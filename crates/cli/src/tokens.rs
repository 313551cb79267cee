//! The file with the rights of the stream's clients.

use std::io::{self, Read as _};
use std::os::unix::fs::PermissionsExt as _;
use std::path::Path;

use documents::shown;
use telemetry::stream::Role;
use telemetry::stream::server::Token;

use super::tell;

const LONGEST: u64 = 1 << 16;

/// Bits of a file's mode by which others may read or write.
const OTHERS: u32 = 0o006;

/// Mistakes named in one message.
const MOST_TOLD: usize = 10;

/// Reads the rights of clients; warns if others on this machine may read or write the file.
///
/// # Errors
/// All mistakes in a sentence without a secret.
pub(super) fn read(file: &Path) -> Result<Vec<Token>, String> {
    let wrong = |what: &str| format!("{}: {what}", shown(file));
    let (text, mode) = text(file).map_err(|error| wrong(&error.to_string()))?;
    if u64::try_from(text.len()).is_ok_and(|length| LONGEST < length) {
        return Err(wrong("it is longer than 64 KiB, which no file of tokens is"));
    }
    let tokens = parse(&text).map_err(|mistakes| wrong(&mistakes))?;
    if mode & OTHERS != 0 {
        let file = shown(file);
        tell(&format!(
            "everybody on this machine can read or change the tokens in {file}: `chmod 600 {file}`"
        ));
    }
    Ok(tokens)
}

fn text(file: &Path) -> io::Result<(String, u32)> {
    let opened = documents::open_input(file)?;
    let mode = opened.metadata()?.permissions().mode();
    let mut text = String::new();
    opened.take(LONGEST + 1).read_to_string(&mut text)?;
    Ok((text, mode))
}

fn parse(text: &str) -> Result<Vec<Token>, String> {
    let mut tokens = Vec::new();
    let mut wrong = Vec::new();
    let lines = (1..).zip(text.lines().map(str::trim));
    for (n, line) in lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#')) {
        match token(line, &tokens) {
            Ok(token) => tokens.push(token),
            Err(what) => wrong.push(format!("line {n} {what}")),
        }
    }
    let more = wrong.len().saturating_sub(MOST_TOLD);
    wrong.truncate(MOST_TOLD);
    if 0 < more {
        wrong.push(format!("and {more} more"));
    }
    if !wrong.is_empty() {
        return Err(wrong.join("; "));
    }
    if tokens.is_empty() {
        // Without tokens every client would be an owner, which a named file must prevent.
        return Err("nobody is named in it: write lines as `owner SECRET`".to_owned());
    }
    Ok(tokens)
}

/// Parses `line` as a token; its secret must differ from those `before`.
fn token(line: &str, before: &[Token]) -> Result<Token, &'static str> {
    let (role, secret) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
    let role = [Role::Viewer, Role::Tuner, Role::Owner].into_iter().find(|it| it.name() == role);
    let token = role.map(|role| Token { secret: secret.trim().to_owned(), role });
    let token = token.filter(|token| !token.secret.is_empty());
    let token = token.ok_or("is not `viewer SECRET`, `tuner SECRET` or `owner SECRET`")?;
    if !token.is_plain() {
        return Err("has a secret with other than letters, digits and -._~ in it");
    }
    if !token.is_long() {
        return Err("has a secret that can be guessed: `openssl rand -hex 16` makes one");
    }
    if before.iter().any(|it| it.secret == token.secret) {
        return Err("has the secret of a line before it");
    }
    Ok(token)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Padding to the minimum length of a secret.
    const REST: &str = "-0123456789abcdef";

    #[test]
    fn all_mistakes_are_told_and_no_secret() {
        let text = format!(
            "viewer see{REST}\nadmin aaaa\nowner\ntuner bb&bb\nowner see{REST}\nowner two words\n\
             viewer short"
        );
        let said = parse(&text).expect_err("mistakes");
        let lines = ["line 2 is not", "line 3 is not", "line 4 has a", "line 5 has the", "line 6"];
        for line in [&lines[..], &["line 7 has a secret that can be guessed"]].concat() {
            assert!(said.contains(line), "{line}: {said}");
        }
        for secret in ["aaaa", "bb&bb", "see", "two words", "short"] {
            assert!(!said.contains(secret), "{said}");
        }
        assert!(parse(&"x\n".repeat(50)).expect_err("mistakes").ends_with("and 40 more"));
    }
}
