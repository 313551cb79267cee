//! Gives damaged files to the program: it must end in time, with a documented code and no panic.

mod kinds;
mod mutate;
mod trial;

use std::path::{Path, PathBuf};
use std::{ffi::OsString, io::Write as _};

use crate::command::{self, cargo, target};
use crate::{error::Error, files};
use kinds::{FuzzKind, KINDS, PreparedKind};
use mutate::{FuzzRandom, mutated};
use trial::FuzzTrial;

#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct FuzzOptions {
    pub(crate) mutations: u64,
    pub(crate) kind: Option<String>,
    pub(crate) seed: u64,
    /// Program to test; built if `None`.
    pub(crate) program: Option<PathBuf>,
}

impl FuzzOptions {
    pub(crate) fn parse(arguments: impl Iterator<Item = OsString>) -> Result<Option<Self>, Error> {
        let mut it = Self { mutations: 1000, kind: None, seed: 1994, program: None };
        let mut arguments = arguments.map(|it| it.to_string_lossy().into_owned());
        while let Some(name) = arguments.next() {
            let wrong = || Error::Argument(name.clone());
            if matches!(name.as_str(), "help" | "--help" | "-h") {
                return Ok(None);
            }
            let value = arguments.next().ok_or_else(wrong)?;
            match name.as_str() {
                "--mutations" => it.mutations = value.parse().map_err(|_no_number| wrong())?,
                "--seed" => it.seed = value.parse().map_err(|_no_number| wrong())?,
                "--program" => it.program = Some(value.into()),
                "--kind" if KINDS.iter().any(|kind| kind.name == value) => it.kind = Some(value),
                _ => return Err(Error::Argument(format!("{name} {value}"))),
            }
        }
        Ok(Some(it))
    }
}

#[derive(Default)]
struct KindReport {
    /// Numbers of runs that ended with 0, 1 and 2.
    codes: [u64; 3],
    /// Longest processor time (s).
    slowest: f64,
    failures: Vec<String>,
}

impl KindReport {
    fn line(&self, kind: &FuzzKind) -> String {
        let Self { codes: [done, failed, refused], slowest, failures } = self;
        let (name, failures) = (kind.name, failures.len());
        format!("{name:14}{done:>8}{failed:>8}{refused:>8}{failures:>10}{slowest:>12.2} s")
    }
}

pub(crate) fn run(options: &FuzzOptions) -> Result<(), Error> {
    let program = options.program.clone().map_or_else(build, Ok)?;
    let folder = target()?.join("fuzz");
    files::empty(&folder)?;
    let wanted = |kind: &&FuzzKind| options.kind.as_ref().is_none_or(|it| it == kind.name);
    let (mut lines, mut failed) = (Vec::new(), 0);
    for kind in KINDS.iter().filter(wanted) {
        let report = try_kind(kind, options, &program, &folder)?;
        lines.push(report.line(kind));
        failed += report.failures.len();
    }
    println!("\n{} mutations of each kind, seed {}", options.mutations, options.seed);
    println!(
        "{:14}{:>8}{:>8}{:>8}{:>10}{:>14}",
        "kind", "code 0", "code 1", "code 2", "failures", "slowest CPU"
    );
    println!("{}", lines.join("\n"));
    if failed == 0 { Ok(()) } else { Err(Error::Fuzz { failed, folder }) }
}

fn build() -> Result<PathBuf, Error> {
    command::run(&mut cargo(["build", "--release", "--package", "cli", "--bin", "letoff"]))?;
    Ok(target()?.join("release/letoff"))
}

fn try_kind(
    kind: &FuzzKind,
    options: &FuzzOptions,
    program: &Path,
    folder: &Path,
) -> Result<KindReport, Error> {
    let program = program.canonicalize().map_err(|cause| Error::file(program, cause))?;
    let prepared = kind.prepare(&program, folder)?;
    let mut report = KindReport::default();
    let mut usual = Vec::new();
    for (number, good) in (0..).zip(prepared.good.iter().cycle()).take(kind.commands.len()) {
        let (trial, _typed) = try_file(kind, (&prepared, number), good, (&program, folder))?;
        usual.push(trial.cpu);
    }
    for number in 0..options.mutations {
        // Each kind and file has its own seed, so that a failure can be reproduced alone.
        let place =
            kind.name.bytes().fold(number, |all, byte| all.wrapping_mul(31) + u64::from(byte));
        let mut random = FuzzRandom(options.seed.wrapping_add(place << 20));
        let bytes = mutated(&mut random, &prepared.good);
        let (trial, typed) = try_file(kind, (&prepared, number), &bytes, (&program, folder))?;
        report.slowest = report.slowest.max(trial.cpu);
        let code = trial.code.and_then(|it| usize::try_from(it).ok());
        if let Some(count) = code.and_then(|it| report.codes.get_mut(it)) {
            *count += 1;
        }
        let command = usize::try_from(number).unwrap_or(0) % usual.len();
        if let Some(failure) = trial.failure(usual[command]) {
            let kept =
                folder.join(format!("{}-{}-{number}.{}", kind.name, options.seed, kind.ending));
            files::write(&kept, &bytes)?;
            report.failures.push(failure.clone());
            println!("\r{}: {failure}: letoff {typed}", kept.display());
        }
        print!("\r{}: {} of {}", kind.name, number + 1, options.mutations);
        let _unseen = std::io::stdout().flush();
    }
    println!();
    Ok(report)
}

fn try_file(
    kind: &FuzzKind,
    (prepared, number): (&PreparedKind, u64),
    bytes: &[u8],
    (program, folder): (&Path, &Path),
) -> Result<(FuzzTrial, String), Error> {
    let usual = PathBuf::from(format!("damaged.{}", kind.ending));
    let file = prepared.place.as_ref().unwrap_or(&usual);
    files::write(&folder.join(file), bytes)?;
    let index = usize::try_from(number).unwrap_or(0) % kind.commands.len();
    let words = kind.commands[index].split(' ');
    let named = |word: &str| word.replace("FILE", &file.to_string_lossy());
    let arguments: Vec<_> = words.map(named).collect();
    let trial = FuzzTrial::run(program, folder, &arguments);
    Ok((trial.map_err(|cause| Error::file(program, cause))?, arguments.join(" ")))
}
