//! Passes the memory layout to the linker, and writes the list of vectors.

use std::path::{Path, PathBuf};

fn main() {
    let root = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").expect("set by cargo"));
    println!("cargo::rustc-link-arg=-T{}", root.join("link.ld").display());
    println!("cargo::rerun-if-changed=link.ld");
    let folder = root.join("../vectors");
    println!("cargo::rerun-if-changed={}", folder.display());
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("set by cargo"));
    std::fs::write(out.join("vectors.rs"), list(&folder)).expect("OUT_DIR can be written");
}

fn list(folder: &Path) -> String {
    let files = std::fs::read_dir(folder).expect("the folder of vectors");
    let mut paths: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|end| end == "hex"));
    paths.sort();
    let items = paths.iter().map(|path| {
        let name = path.file_stem().expect("a name").to_string_lossy();
        format!("    ({name:?}, include_str!({:?})),\n", path.display().to_string())
    });
    format!("&[\n{}]\n", items.collect::<String>())
}
