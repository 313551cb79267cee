//! The crates linked into the programs, with their licences and texts.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::deny;
use crate::command::{self, cargo};
use crate::{error::Error, files};

const NAMES: [&str; 6] = ["license", "licence", "copying", "copyright", "notice", "unlicense"];

const FOLDERS: [&str; 4] = ["", "license", "licenses", "fonts"];

const HEAD: &str = "\
The programs of this package contain, besides Letoff itself, the crates of this list, and the
standard library of Rust (MIT OR Apache-2.0, The Rust Project Contributors). The licences follow
with the texts that came with the crates; each text stands once, below the names of the crates
that have it. Of crates that came without, MIT is the text in /usr/share/doc/letoff/copyright, and
Apache-2.0 the one in /usr/share/common-licenses, under the names of their authors.
The source text of each crate, of those under MPL-2.0 too, is at its address.

";

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct LinkedCrate {
    name: String,
    version: String,
    /// SPDX expression of the licence.
    licence: String,
    address: String,
}

impl LinkedCrate {
    /// Parses a line of `cargo tree`; our crates have a path, and return `None`.
    fn parse(line: &str) -> Option<Self> {
        let mut columns = line.trim_end_matches(" (*)").split('|').map(str::trim);
        let (name, version) = columns.next()?.split_once(" v")?;
        if version.contains(' ') {
            return None;
        }
        let (licence, address) = (columns.next()?.to_owned(), columns.next()?.to_owned());
        Some(Self { name: name.to_owned(), version: version.to_owned(), licence, address })
    }

    fn folder_name(&self) -> String {
        format!("{}-{}", self.name, self.version)
    }
}

/// Lists all linked crates with their licences' texts; fails if a licence forbids linking.
pub(super) fn third_party() -> Result<String, Error> {
    let crates = linked()?;
    let accepted = accepted()?;
    if let Some(refused) = crates.iter().find(|it| !is_accepted(&it.licence, &accepted)) {
        let LinkedCrate { name, licence, .. } = refused;
        let because = format!("{name} is linked, and its licence is \"{licence}\"");
        return Err(Error::unobtainable("a package that may be passed on", because));
    }
    let metadata = command::answer(&mut cargo(["metadata", "--format-version", "1", "--locked"]))?;
    let folders = folders(&metadata);
    let mut parts = vec![HEAD.to_owned()];
    let mut texts = BTreeMap::<String, Vec<String>>::new();
    for it in &crates {
        let found = folders.get(&it.folder_name()).map_or_else(Vec::new, |it| texts_in(it));
        let note = if found.is_empty() { "; its package has no text of it" } else { "" };
        parts.push(format!("{} {}: {}{note}\n", it.name, it.version, it.licence));
        parts.push(format!("    {}\n", it.address));
        for path in found {
            let content = files::read(&path)?;
            texts.entry(content.trim().replace('\r', "")).or_default().push(it.folder_name());
        }
    }
    for (content, owners) in texts {
        let bar = "=".repeat(72);
        parts.push(format!("\n{bar}\n{}\n\n{content}\n", owners.join(", ")));
    }
    Ok(parts.concat())
}

fn linked() -> Result<Vec<LinkedCrate>, Error> {
    let said = command::answer(&mut cargo([
        "tree",
        "--locked",
        "--package",
        "cli",
        "--package",
        "dashboard",
        "--edges",
        "normal,no-proc-macro",
        "--prefix",
        "none",
        "--format",
        "{p}|{l}|{r}",
    ]))?;
    let mut crates: Vec<_> = said.lines().filter_map(LinkedCrate::parse).collect();
    crates.sort();
    crates.dedup();
    Ok(crates)
}

fn accepted() -> Result<Vec<String>, Error> {
    Ok(deny::list("allow")?.into_iter().flatten().collect())
}

/// Returns `true` if an accepted licence meets each part of the expression.
fn is_accepted(expression: &str, accepted: &[String]) -> bool {
    let plain = expression.replace(['(', ')'], "").replace('/', " OR ");
    let is_known = |licence: &str| accepted.iter().any(|it| it == licence.trim());
    plain.split(" AND ").all(|part| part.split(" OR ").any(is_known))
}

fn folders(metadata: &str) -> BTreeMap<String, PathBuf> {
    let manifests = metadata.split("\"manifest_path\":\"").skip(1);
    let paths = manifests.filter_map(|rest| Path::new(rest.split('"').next()?).parent());
    let named =
        paths.filter_map(|path| Some((path.file_name()?.to_str()?.to_owned(), path.into())));
    named.collect()
}

fn texts_in(folder: &Path) -> Vec<PathBuf> {
    let all = FOLDERS.iter().filter_map(|name| files::list(&folder.join(name)).ok()).flatten();
    let has_text = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
        let is_of_font = path.parent().is_some_and(|it| it.ends_with("fonts"))
            && path.extension().is_some_and(|it| it == "txt");
        path.is_file() && (is_of_font || NAMES.iter().any(|it| name.starts_with(it)))
    };
    all.filter(has_text).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_crate_that_is_linked_may_be() {
        let crates = linked().expect("a graph of crates");
        assert!(crates.len() > 100, "{} crates", crates.len());
        let accepted = accepted().expect("deny.toml");
        let refused: Vec<_> =
            crates.iter().filter(|it| !is_accepted(&it.licence, &accepted)).collect();
        assert!(refused.is_empty(), "{refused:?}");
    }

    #[test]
    fn an_expression_is_accepted_if_each_part_of_it_can_be() {
        let accepted = ["MIT", "Unicode-3.0"].map(String::from);
        for good in ["MIT", "MIT/Apache-2.0", "MIT OR GPL-3.0-only", "(MIT OR X) AND Unicode-3.0"] {
            assert!(is_accepted(good, &accepted), "{good}");
        }
        for bad in ["", "GPL-3.0-only", "MIT AND GPL-3.0-only", "(MIT OR ISC) AND AGPL-3.0", "AND"]
        {
            assert!(!is_accepted(bad, &accepted), "{bad}");
        }
    }

    #[test]
    fn a_crate_of_ours_is_not_others_work() {
        assert_eq!(LinkedCrate::parse("cli v0.1.0 (/w/crates/cli)|MIT|https://x"), None);
        let parsed = LinkedCrate::parse("libm v0.2.15|MIT|https://x (*)").expect("a crate");
        assert_eq!(
            (parsed.folder_name().as_str(), parsed.address.as_str()),
            ("libm-0.2.15", "https://x")
        );
    }

    #[test]
    fn folders_are_those_of_the_manifests() {
        let metadata = r#"{"packages":[{"manifest_path":"/r/libm-0.2.15/Cargo.toml","x":1}]}"#;
        let folders = folders(metadata);
        assert_eq!(folders.get("libm-0.2.15"), Some(&PathBuf::from("/r/libm-0.2.15")));
    }
}
