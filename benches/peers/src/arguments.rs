//! The command line of the benchmark.

use std::path::PathBuf;

#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Arguments {
    /// `true` if there are fewer rounds and shorter repeats: a check that everything runs.
    pub(crate) quick: bool,
    pub(crate) out: PathBuf,
    /// A report whose counts are compared; nothing is timed.
    pub(crate) counts: Option<PathBuf>,
    /// A Python with SciPy, heyoka, MuJoCo and Drake.
    pub(crate) python: Option<PathBuf>,
    /// A Python with Siconos.
    pub(crate) siconos: Option<PathBuf>,
    /// The compiled program around CVODE.
    pub(crate) cvode: Option<PathBuf>,
    /// `code: reason` of each code that cannot run here.
    pub(crate) skipped: Vec<String>,
}

impl Arguments {
    pub(crate) fn parse(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut it = Self { out: PathBuf::from("results"), ..Self::default() };
        while let Some(word) = words.next() {
            if word == "--quick" {
                it.quick = true;
                continue;
            }
            let value = words.next().ok_or_else(|| format!("{word} needs a value"))?;
            match word.as_str() {
                "--out" => it.out = value.into(),
                "--counts" => it.counts = Some(value.into()),
                "--python" => it.python = Some(value.into()),
                "--siconos" => it.siconos = Some(value.into()),
                "--cvode" => it.cvode = Some(value.into()),
                "--skipped" => it.skipped.push(value),
                _ => return Err(format!("\"{word}\" is not understood")),
            }
        }
        Ok(it)
    }
}
