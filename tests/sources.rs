//! The project's Rust sources, parsed for the tests of rooms, words and comments.

use std::fs;
use std::path::{Path, PathBuf};

use syn::{Attribute, File, Item, Meta};

pub(crate) struct Source {
    /// Folder of its crate, as `pode`.
    pub(crate) room: String,
    pub(crate) path: PathBuf,
    /// Module path, as `["stepper", "rk4"]`; empty for the crate's root.
    pub(crate) module: Vec<String>,
    pub(crate) syntax: File,
}

/// Returns all product sources: `src` of each crate, without modules of tests.
pub(crate) fn all() -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let crates = fs::read_dir(root.join("crates")).expect("crates/").filter_map(Result::ok);
    let mut rooms: Vec<PathBuf> = crates.map(|entry| entry.path()).collect();
    rooms.push(root.join("firmware-protocol"));
    rooms.sort();
    let mut sources = Vec::new();
    for room in rooms {
        let name = room.file_name().expect("a folder").to_string_lossy().into_owned();
        let src = room.join("src");
        for path in rust_files(&src) {
            sources.extend(read(&name, &src, path));
        }
    }
    sources
}

pub(crate) fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let mut files = Vec::new();
    for path in entries.filter_map(Result::ok).map(|entry| entry.path()) {
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|it| it == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

fn read(room: &str, src: &Path, path: PathBuf) -> Option<Source> {
    let module = module(path.strip_prefix(src).ok()?);
    if module.iter().any(|name| name == "tests" || name == "testing") {
        return None;
    }
    let text = fs::read_to_string(&path).expect("a source file");
    let mut syntax = syn::parse_file(&text).expect("a file that compiles");
    syntax.items.retain(|item| !is_for_tests(attributes(item)));
    Some(Source { room: room.to_owned(), path, module, syntax })
}

pub(crate) fn examples(folder: &Path) -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let files = rust_files(&root);
    files.into_iter().filter_map(|path| read("examples", &root, path)).collect()
}

fn module(path: &Path) -> Vec<String> {
    let mut parts: Vec<String> =
        path.with_extension("").iter().map(|it| it.to_string_lossy().into_owned()).collect();
    if matches!(parts.last().map(String::as_str), Some("mod" | "lib" | "main")) {
        parts.pop();
    }
    parts
}

fn is_for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|it| match &it.meta {
        Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string() == "test",
        Meta::Path(_) | Meta::NameValue(_) => false,
    })
}

#[expect(clippy::wildcard_enum_match_arm, reason = "the enum of items is open")]
pub(crate) fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(it) => &it.attrs,
        Item::Enum(it) => &it.attrs,
        Item::Fn(it) => &it.attrs,
        Item::Impl(it) => &it.attrs,
        Item::Mod(it) => &it.attrs,
        Item::Static(it) => &it.attrs,
        Item::Struct(it) => &it.attrs,
        Item::Trait(it) => &it.attrs,
        Item::Type(it) => &it.attrs,
        Item::Use(it) => &it.attrs,
        _ => &[],
    }
}
