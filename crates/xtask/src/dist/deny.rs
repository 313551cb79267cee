//! Reads `deny.toml`, the rules for linked crates, also for `cargo deny`.

use crate::{command::root, error::Error, files};

/// Returns the quoted texts of each line of the list called `key`.
pub(super) fn list(key: &str) -> Result<Vec<Vec<String>>, Error> {
    let path = root().join("deny.toml");
    let text = files::read(&path)?;
    let (_before, rest) = text.split_once(&format!("\n{key} = [\n")).ok_or_else(|| {
        Error::unobtainable(format!("the list {key} of deny.toml"), "it is missing")
    })?;
    let lines = rest.lines().take_while(|line| *line != "]");
    let quoted = |line: &str| line.split('"').skip(1).step_by(2).map(str::to_owned).collect();
    Ok(lines.map(quoted).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::{self, cargo};

    fn built() -> Vec<String> {
        let target = ["--target", "x86_64-unknown-linux-gnu"];
        let all = ["tree", "--locked", "--offline", "--workspace", "--edges", "no-dev"];
        let form = ["--prefix", "none", "--format", "{p}"];
        let said = command::answer(&mut cargo([&all[..], &target, &form].concat()));
        let said = said.expect("a graph of crates");
        let words = |line: &str| {
            let mut words = line.split_whitespace();
            Some(format!("{}@{}", words.next()?, words.next()?.trim_start_matches('v')))
        };
        let mut all: Vec<_> = said.lines().filter_map(words).collect();
        all.sort();
        all.dedup();
        all
    }

    #[test]
    fn every_second_version_of_a_crate_has_a_reason() {
        let skipped = list("skip").expect("deny.toml");
        let reason = |it: &str| skipped.iter().find(|entry| entry[0] == it).map(|entry| &entry[1]);
        let built = built();
        let name = |it: &str| it.split('@').next().unwrap_or_default().to_owned();
        let mut once = built.iter().filter(|it| reason(it).is_none_or(String::is_empty));
        let mut last = String::new();
        let double: Vec<_> =
            once.by_ref().filter(|it| std::mem::replace(&mut last, name(it)) == name(it)).collect();
        assert!(double.is_empty(), "second versions without a reason in deny.toml: {double:?}");
        for entry in &skipped {
            assert!(built.contains(&entry[0]), "{} is not built any more", entry[0]);
        }
    }

    #[test]
    fn every_crate_comes_from_the_registry() {
        let lock = files::read(&root().join("Cargo.lock")).expect("Cargo.lock");
        let registry = "source = \"registry+https://github.com/rust-lang/crates.io-index\"";
        let other = lock.lines().find(|line| line.starts_with("source") && *line != registry);
        assert_eq!(other, None);
    }

    #[test]
    fn every_accepted_advisory_has_a_crate_that_is_built_a_date_and_a_reason() {
        let built = built();
        for entry in list("ignore").expect("deny.toml") {
            let [id, reason] = entry.as_slice() else { panic!("{entry:?}") };
            let (named, judged) = reason.split_once(", judged 20").expect("a crate and a date");
            assert!(
                built.contains(&named.replace(' ', "@")),
                "{id}: {named} is not built any more"
            );
            let why = judged.split_once(": ").map(|(_date, why)| why);
            assert!(why.is_some_and(|why| 20 < why.len()), "{id}: {reason}");
        }
    }
}
