//! `letoff manual`: man pages and completions of shells, for packages.

use std::io;
use std::path::{Path, PathBuf};

use clap::{Args, CommandFactory};
use clap_complete::aot::{Shell, generate_to};
use documents::shown;

use super::{Failure, Letoff};

const SHELLS: [Shell; 3] = [Shell::Bash, Shell::Zsh, Shell::Fish];

/// What `letoff manual` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Example:
  letoff manual pages && man -l pages/letoff-run.1")]
pub struct ManualArgs {
    /// Folder for `letoff.1`, a page for each command, and the completions.
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}

pub(super) fn run(args: &ManualArgs) -> Result<(), Failure> {
    write::<Letoff>("letoff", &args.folder)
}

/// Writes the man pages and completions of the program called `name` into `folder`.
pub fn write<P: CommandFactory>(name: &str, folder: &Path) -> Result<(), Failure> {
    let try_write = || {
        std::fs::create_dir_all(folder)?;
        clap_mangen::generate_to(P::command(), folder)?;
        SHELLS.into_iter().try_for_each(|shell| {
            generate_to(shell, &mut P::command(), name, folder).map(|_page| ())
        })
    };
    try_write().map_err(|error: io::Error| {
        let place = shown(folder);
        Failure::Usage(format!("{place} cannot be written to: {error}; choose another folder"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the visible commands, as `lab-accuracy`, with their long options.
    fn commands(command: &clap::Command, name: &str) -> Vec<(String, Vec<String>)> {
        let visible = command.get_subcommands().filter(|it| !it.is_hide_set());
        let below = visible.flat_map(|it| commands(it, &format!("{name}-{}", it.get_name())));
        let options = command.get_arguments().filter(|it| !it.is_hide_set());
        let options = options.filter_map(|it| it.get_long().map(str::to_owned)).collect();
        std::iter::once((name.to_owned(), options)).chain(below).collect()
    }

    #[test]
    fn every_command_has_a_page_with_its_options_and_every_shell_knows_it() {
        let folder = tempfile::tempdir().unwrap();
        run(&ManualArgs { folder: folder.path().to_owned() }).unwrap();
        let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
        let shells = ["letoff.bash", "_letoff", "letoff.fish"].map(read);
        let commands = commands(&Letoff::command(), "letoff");
        assert!(commands.len() > 20, "{commands:?}");
        for (name, options) in commands {
            let page = read(&format!("{name}.1")).replace("\\-", "-");
            for option in options {
                assert!(page.contains(&format!("--{option}")), "{name}: --{option}");
            }
            let last = name.rsplit('-').next().unwrap_or_default();
            assert!(shells.iter().all(|it| it.contains(last)), "{name}");
        }
    }

    #[test]
    fn a_folder_that_cannot_be_written_to_is_named() {
        let folder = std::env::current_exe().unwrap();
        let failure = run(&ManualArgs { folder: folder.clone() }).unwrap_err();
        let Failure::Usage(text) = failure else { unreachable!("{failure:?}") };
        assert!(text.contains(&shown(&folder)), "{text}");
    }
}
