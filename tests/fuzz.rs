//! `cargo xtask fuzz`, with few files of each kind.

use std::process::Command;

use crate::letoff::program;

#[test]
fn damaged_files_of_every_kind_are_refused_or_played() {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut fuzz = Command::new(cargo);
    fuzz.current_dir(env!("CARGO_MANIFEST_DIR"));
    fuzz.args(["xtask", "fuzz", "--mutations", "20", "--program"]).arg(program());
    let output = fuzz.output().expect("cargo");
    let [out, err] =
        [output.stdout, output.stderr].map(|it| String::from_utf8_lossy(&it).into_owned());
    assert!(output.status.success(), "{out}{err}");
}
