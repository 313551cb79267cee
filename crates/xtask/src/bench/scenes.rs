//! The README's table of scenes: time of a tick beside the error of the force.

use std::fs;

use crate::command::{answer, cargo, root};
use crate::error::Error;

pub(super) const PROGRAM: &str = "scenes";

const BEGIN: &str = "<!-- scenes: begin; written by `cargo xtask bench --write-baseline` -->\n";
const END: &str = "<!-- scenes: end -->";

const HEAD: &str = "\
| scene, rate | 88 keys move | ten hammers strike in one tick | error of the force in a loud stroke |
|---|--:|--:|--:|
";

/// Returns the rows that the program prints.
pub(super) fn measure() -> Result<String, Error> {
    let rows = answer(&mut cargo(["bench", "--quiet", "--workspace", "--bench", PROGRAM]))?;
    Ok(format!("{rows}\n"))
}

/// Puts the rows into the README.
pub(super) fn write(rows: &str, machine: &str) -> Result<(), Error> {
    let path = root().join("README.md");
    let text = fs::read_to_string(&path).map_err(|cause| Error::file(&path, cause))?;
    let text = with_table(&text, &format!("{HEAD}{rows}\nLeast times on one lane of {machine}.\n"));
    let text = text.ok_or_else(|| Error::unobtainable("the table of scenes", BEGIN))?;
    fs::write(&path, text).map_err(|cause| Error::file(&path, cause))
}

fn with_table(text: &str, table: &str) -> Option<String> {
    let (before, rest) = text.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{BEGIN}{table}{END}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_takes_the_place_of_the_last_one() {
        let text = format!("before\n{BEGIN}old\n{END}\nafter\n");
        let expected = format!("before\n{BEGIN}new\n{END}\nafter\n");
        assert_eq!(with_table(&text, "new\n"), Some(expected));
        assert_eq!(with_table("no table", "new\n"), None);
    }
}
