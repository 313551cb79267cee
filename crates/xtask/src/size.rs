//! The size of the project: lines of Rust, crates, the largest structs and the widest traits.
//!
//! Every line of a tracked `.rs` counts, as rustfmt leaves it. Product is everything outside
//! `tests/`, `benches/`, `examples/` and `fuzz/`, without inline test modules.

use std::io::{self, Write as _};
use std::{cmp::Reverse, collections::BTreeMap, path::Path, process::Command};

use crate::{command::root, error::Error, files};

/// Folders that are not product, anywhere.
const OTHER: [&str; 4] = ["tests", "benches", "examples", "fuzz"];

const SHOWN: usize = 10;

/// Largest number of fields of a struct, and of methods of a trait, provided ones included.
const MAX_MEMBERS: [usize; 2] = [15, 7];

const ALLOWANCE: &str = "tests/size.toml";

#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
struct RustLines {
    product: usize,
    tests: usize,
}

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct CountedItem {
    members: usize,
    name: String,
    file: String,
}

#[derive(Clone, PartialEq, Eq, Debug, Default)]
struct ProjectSize {
    lines: RustLines,
    crates: BTreeMap<String, usize>,
    structs: Vec<CountedItem>,
    traits: Vec<CountedItem>,
}

pub(crate) fn print() -> Result<(), Error> {
    let report = count()?.report(allowance()?);
    // A reader such as `head` may close early.
    let _closed = io::stdout().write_all(report.as_bytes());
    Ok(())
}

fn allowance() -> Result<RustLines, Error> {
    let text = files::read(&root().join(ALLOWANCE))?;
    let value = |name: &str| {
        let line = text.lines().find_map(|line| line.strip_prefix(name)?.trim().strip_prefix('='));
        let number = line.and_then(|value| value.trim().parse().ok());
        number.ok_or_else(|| {
            Error::unobtainable(format!("`{name}` of {ALLOWANCE}"), "it is no number")
        })
    };
    Ok(RustLines { product: value("product")?, tests: value("tests")? })
}

fn count() -> Result<ProjectSize, Error> {
    let mut command = Command::new("git");
    command.args(["ls-files", "*.rs"]).current_dir(root());
    let listed = command.output();
    let listed = listed.map_err(|cause| Error::NotStarted { command: "git".into(), cause })?;
    if !listed.status.success() {
        return Err(Error::unobtainable("the list of tracked files", "this is no git checkout"));
    }
    let mut size = ProjectSize::default();
    for path in String::from_utf8_lossy(&listed.stdout).lines() {
        // A file may be deleted and not yet committed.
        if root().join(path).exists() {
            size.add(path, &files::read(&root().join(path))?);
        }
    }
    Ok(size)
}

impl ProjectSize {
    fn report(&self, allowed: RustLines) -> String {
        let RustLines { product, tests } = self.lines;
        let mut lines = vec![
            format!("product  {product:7} lines of {} allowed", allowed.product),
            format!(
                "tests    {tests:7} lines of {} allowed, with benches and examples",
                allowed.tests
            ),
            format!("all Rust {:7} lines", product + tests),
            format!("\n{} crates and programs, by lines of product:", self.crates.len()),
        ];
        let mut crates: Vec<_> = self.crates.iter().collect();
        crates.sort_by_key(|(_, lines)| Reverse(**lines));
        lines.extend(crates.iter().map(|(name, lines)| format!("  {lines:6} {name}")));
        let items = [("fields", &self.structs), ("methods", &self.traits)];
        for ((what, items), max) in items.into_iter().zip(MAX_MEMBERS) {
            lines.push(format!("\nmost {what}, of {max} allowed:"));
            let mut items: Vec<_> = items.iter().collect();
            items.sort_by_key(|it| Reverse(*it));
            let item = |it: &&CountedItem| format!("  {:6} {} in {}", it.members, it.name, it.file);
            lines.extend(items.iter().take(SHOWN).map(item));
        }
        lines.push(String::new());
        lines.join("\n")
    }

    fn add(&mut self, path: &str, text: &str) {
        self.lines.tests += text.lines().count();
        let folders = Path::new(path).parent().unwrap_or(Path::new(""));
        if folders.iter().any(|folder| OTHER.iter().any(|other| folder == *other)) {
            return;
        }
        let lines = product_lines(text);
        self.lines.product += lines.len();
        self.lines.tests -= lines.len();
        let mut parts = path.split('/');
        let first = parts.next().unwrap_or_default();
        let name = if first == "crates" { parts.next().unwrap_or_default() } else { first };
        *self.crates.entry(name.to_owned()).or_default() += lines.len();
        let item = |(name, members): (&str, usize)| CountedItem {
            members,
            name: name.to_owned(),
            file: path.to_owned(),
        };
        self.structs.extend(items(&lines, "struct ", is_field).map(item));
        self.traits.extend(items(&lines, "trait ", is_method).map(item));
    }
}

fn product_lines(text: &str) -> Vec<&str> {
    let mut lines = Vec::new();
    let mut rest = text.lines().peekable();
    while let Some(line) = rest.next() {
        let is_for_tests = is_for_tests(line);
        let mut held = vec![line];
        while is_for_tests && rest.peek().is_some_and(|next| is_about_next(next)) {
            held.extend(rest.next());
        }
        let opening = rest.peek().filter(|next| is_for_tests && is_module_with_body(next));
        let Some(opening) = opening else {
            lines.extend(held);
            continue;
        };
        let end = format!("{}}}", indentation(opening));
        // In rustfmt's form the module ends with the first brace at its own indentation.
        rest.by_ref().find(|line| *line == end);
    }
    lines
}

fn is_for_tests(line: &str) -> bool {
    let mut words = line.split(|it: char| !it.is_alphanumeric());
    let names_tests = words.any(|word| word == "test") && !line.contains("not(test)");
    line.trim_start().starts_with("#[cfg(") && names_tests
}

fn is_about_next(line: &str) -> bool {
    line.trim_start().starts_with("#[") || line.trim_start().starts_with("//")
}

fn is_module_with_body(line: &str) -> bool {
    line.split_whitespace().any(|word| word == "mod") && line.ends_with('{')
}

fn indentation(line: &str) -> &str {
    line.split_at(line.len() - line.trim_start().len()).0
}

fn items<'a>(
    lines: &'a [&'a str],
    keyword: &'a str,
    is_member: fn(&str) -> bool,
) -> impl Iterator<Item = (&'a str, usize)> {
    lines.iter().enumerate().filter_map(move |(at, line)| {
        let (before, name) = line.split_once(keyword)?;
        let is_head = before.trim().is_empty() || before.trim_start().starts_with("pub");
        let name = name.split(|it: char| !it.is_alphanumeric() && it != '_').next()?;
        if !is_head || line.ends_with(';') {
            return None;
        }
        let end = format!("{}}}", indentation(line));
        let inside = format!("{}    ", indentation(line));
        let body = lines.get(at + 1..)?.iter().take_while(|line| **line != end);
        // Members of this item only, without their own content.
        let own = body.filter_map(|line| line.strip_prefix(&inside));
        Some((name, own.filter(|line| is_member(line)).count()))
    })
}

fn is_field(line: &str) -> bool {
    let name = line.trim_start_matches("pub(crate) ").trim_start_matches("pub(super) ");
    let name = name.trim_start_matches("pub ").split(':').next().unwrap_or_default();
    line.contains(':')
        && !name.is_empty()
        && name.chars().all(|it| it.is_alphanumeric() || it == '_')
}

fn is_method(line: &str) -> bool {
    ["fn ", "const fn ", "unsafe fn ", "async fn "].iter().any(|start| line.starts_with(start))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_project_keeps_its_allowance() {
        let size = match count() {
            Ok(size) => size,
            Err(why) => return eprintln!("SKIPPED: {why}"),
        };
        let (RustLines { product, tests }, allowed) = (size.lines, allowance().unwrap());
        assert!(product <= allowed.product, "{product} lines of product: delete as many");
        assert!(tests <= allowed.tests, "{tests} lines of tests: delete as many");
        assert!(product > allowed.product / 2, "{product} lines of product were found");
    }

    #[test]
    fn structs_and_traits_are_small() {
        let size = match count() {
            Ok(size) => size,
            Err(why) => return eprintln!("SKIPPED: {why}"),
        };
        for (items, max) in [&size.structs, &size.traits].into_iter().zip(MAX_MEMBERS) {
            let is_large = |it: &&CountedItem| max < it.members && !it.file.contains("/generated/");
            let large: Vec<_> = items.iter().filter(is_large).collect();
            assert!(large.is_empty(), "more than {max} members, group or split them: {large:#?}");
        }
    }

    const FILE: &str = "\
//! A file.

pub struct Point {
    /// Along the key.
    pub x: f64,
    y: f64,
}

trait Shape {
    fn area(&self) -> f64;
    fn twice(&self) -> f64 {
        2.0 * self.area()
    }
}

#[cfg(test)]
#[expect(clippy::panic, reason = \"a test\")]
mod tests {
    struct Hidden {
        z: f64,
    }
}

#[cfg(not(test))]
mod kept {
}
";

    #[test]
    fn inline_tests_are_no_product() {
        let mut size = ProjectSize::default();
        size.add("crates/x/src/lib.rs", FILE);
        size.add("crates/x/tests/main.rs", FILE);
        assert_eq!(size.lines, RustLines { product: 19, tests: 33 });
        assert_eq!(size.crates, BTreeMap::from([("x".to_owned(), 19)]));
        let named = |items: &[CountedItem]| -> Vec<(String, usize)> {
            items.iter().map(|it| (it.name.clone(), it.members)).collect()
        };
        assert_eq!(named(&size.structs), [("Point".to_owned(), 2)]);
        assert_eq!(named(&size.traits), [("Shape".to_owned(), 2)]);
    }
}
