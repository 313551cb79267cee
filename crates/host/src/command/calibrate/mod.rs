//! `letoff calibrate`: how the keys of boards read and push, measured and written down.
//!
//! The keys move by themselves: down with 1.5 N at most, and up again, one after the other; with
//! a weight, once more with twice its force and 0.5 N at most.

mod bring_up;
mod measure;
mod operator;
mod table;
mod write;

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use hardware::calibrate::WEIGHTS;

use self::operator::Operator;
use self::write::Record;
use super::target::Target;
use super::{Failure, print_json};

/// What `letoff calibrate` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff calibrate --link serial:/dev/ttyACM0
  letoff calibrate my-scene.toml --board 3 --weight 50

Nobody may touch the keys meanwhile: each goes down and up by itself, with 1.5 N
at most; with --weight, once more with twice the weight's force and 0.5 N at most.")]
pub struct CalibrateArgs {
    /// Whose keys shall be measured.
    #[command(flatten)]
    pub target: Target,
    /// Only the board with this number, on whatever link.
    #[arg(long, value_name = "N")]
    pub board: Option<u8>,
    /// Overwrites files without asking; the old ones are kept as .bak.
    #[arg(long)]
    pub yes: bool,
    /// Prints what was measured as JSON.
    #[arg(long)]
    pub json: bool,
    /// Measures motors by a weight of so many grams, which is put on each key.
    #[arg(long, value_name = "GRAMS", value_parser = grams, allow_negative_numbers = true)]
    pub weight: Option<f64>,
    /// Where the files shall be; without it, where `links.calibration` of the scene says, or in
    /// the user's own folder.
    #[arg(long, value_name = "DIR")]
    pub folder: Option<PathBuf>,
}

fn grams(text: &str) -> Result<f64, String> {
    let (least, most) = (1e3 * WEIGHTS.0, 1e3 * WEIGHTS.1);
    match text.parse::<f64>() {
        Ok(grams) if (least..=most).contains(&grams) => Ok(grams),
        Ok(_) | Err(_) => Err(format!("`{text}` is no weight: give {least} to {most} grams")),
    }
}

/// Measures, writes, and prints a table.
pub(super) fn run(args: &CalibrateArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let operator = Operator::new(args);
    if args.weight.is_some() {
        operator.must_be_there("--weight")?;
    }
    let folder = args.folder.clone();
    let (boards, bench) = bring_up::arm(&args.target, args.board, folder, &operator)?;
    let mut record = Record::default();
    let keybed = measure::all(&boards, bench, args.weight, &mut record);
    record.tell(keybed);
    let Record { written, wrong, .. } = record;
    if args.json {
        print_json(&written, out)?;
    } else {
        table::print(&written, out)?;
    }
    if wrong.is_empty() { Ok(()) } else { Err(Failure::Running(wrong.join("\nletoff: "))) }
}
