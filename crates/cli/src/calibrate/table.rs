//! The table of measurements.

use std::io::Write;

use documents::shown;

use super::write::{MeasuredKeyRow, Written};
use crate::Failure;

pub(super) fn print(boards: &[Written], out: &mut dyn Write) -> Result<(), Failure> {
    for Written { link, number, uid, file, keys } in boards {
        writeln!(out, "board {number} on {link} ({uid}), in {}", shown(file))?;
        writeln!(
            out,
            "  {:4} {:>9} {:>9} {:>10} {:>10} {:>6}",
            "key", "rest", "bottom", "travel mm", "friction N", "gain"
        )?;
        for MeasuredKeyRow { key, rest, bottom, travel_mm, friction_n, gain } in keys {
            writeln!(
                out,
                "  {key:4} {rest:9} {bottom:9} {travel_mm:10.2} {friction_n:10.3} {gain:6.3}"
            )?;
        }
    }
    Ok(())
}
