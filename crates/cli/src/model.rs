//! `letoff model`: derives equations from a description, or writes a first one.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand, ValueEnum};
use mechanism::kane::readable::{Notation, mode_equations, system_equations};
use mechanism::{MissingModel, derive, description};

use super::{Failure, ask};
use documents::{choice, quoted, shown};
use host::control::Request;

/// What `letoff model` takes.
#[derive(Clone, Debug, Args)]
pub struct ModelArgs {
    #[command(subcommand)]
    pub command: ModelCommand,
}

/// What is done with a description.
#[derive(Clone, Debug, Subcommand)]
pub enum ModelCommand {
    /// Prints the equations of motion that follow from a description.
    Derive(DeriveArgs),
    /// Writes a description to start from.
    New(NewArgs),
    /// Lets the running host read a description, and play it.
    Load(LoadArgs),
}

/// What `letoff model derive` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff model derive key-hammer-springs
  letoff model derive my-action.toml --mode flight --notation latex")]
pub struct DeriveArgs {
    /// A model of the program, or the path of a description.
    pub model: String,
    /// Only the mode of this name.
    #[arg(long)]
    pub mode: Option<String>,
    /// How the equations are written.
    #[arg(long, value_enum, default_value_t = NotationName::Text)]
    pub notation: NotationName,
}

/// How equations are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum NotationName {
    Text,
    Latex,
}

/// What `letoff model new` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff model new my-ball.toml
  letoff model new my-action.toml --from key-hammer-springs")]
pub struct NewArgs {
    /// The file to write; one that is there is left alone.
    pub file: PathBuf,
    /// The model of the program whose description is copied.
    #[arg(long, value_name = "MODEL", default_value = "bouncing-ball")]
    pub from: String,
}

/// What `letoff model load` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff model load my-action.toml               the keys that play it go on with what it says now
  letoff model load my-action.toml --keys C4..B4")]
pub struct LoadArgs {
    /// The description, which may have been loaded before.
    pub file: PathBuf,
    /// Which keys, as `C4..B5` or `60..83`; those that play it without.
    #[arg(long)]
    pub keys: Option<String>,
}

pub(super) fn run(args: &ModelArgs, out: &mut dyn Write) -> Result<(), Failure> {
    match &args.command {
        ModelCommand::Derive(args) => print_equations(args, out),
        ModelCommand::New(args) => new(args, out),
        ModelCommand::Load(args) => load(args, out),
    }
}

/// Asks the running host, which may have another working folder.
fn load(args: &LoadArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let path = std::path::absolute(&args.file).unwrap_or_else(|_unknown| args.file.clone());
    let description = path.to_string_lossy().into_owned();
    ask::ask(&Request::Load { description, keys: args.keys.clone() }, Failure::Usage, out)
}

fn print_equations(args: &DeriveArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let wrong = |missing: MissingModel| Failure::Usage(missing.rendered());
    let model = derive(&args.model).map_err(wrong)?;
    let notation = match args.notation {
        NotationName::Text => Notation::Text,
        NotationName::Latex => Notation::Latex,
    };
    let text = match &args.mode {
        None => system_equations(&model.system, notation),
        Some(name) => {
            let modes = &model.system.mechanism.modes;
            let Some(mode) = modes.iter().position(|mode| mode.name == *name) else {
                let help = choice(name, modes.iter().map(|mode| &mode.name));
                return Err(Failure::Usage(format!("there is no mode {}; {help}", quoted(name))));
            };
            mode_equations(&model.system, mode, notation)
        }
    };
    Ok(out.write_all(text.as_bytes())?)
}

fn new(args: &NewArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let Some(text) = description(&args.from) else {
        return Err(Failure::Usage(mechanism::unknown_model(&args.from).rendered()));
    };
    let file: &Path = &args.file;
    let refused = |error: std::io::Error| {
        Failure::Usage(format!("{} cannot be written, {error}; take another name", shown(file)))
    };
    let mut written = std::fs::File::create_new(file).map_err(refused)?;
    written.write_all(text.as_bytes()).map_err(refused)?;
    Ok(writeln!(
        out,
        "{0}: a copy of {1}; `letoff check {0}` names mistakes, `letoff simulate {0}` runs it",
        shown(file),
        args.from
    )?)
}
