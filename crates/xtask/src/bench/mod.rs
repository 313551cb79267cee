//! Latency benches, compared with a baseline.
//!
//! Each time is stored as a multiple of a loop of arithmetic that the same process has just
//! measured (`calibration` in `benches/setting`). Programs alternate over several rounds. The
//! fastest sample of each round counts; the spread of the middle half of the rounds is the noise.

mod baseline;
mod sample;
mod scenes;

use std::{collections::BTreeMap, fs, path::Path, process::Stdio};

use crate::command::{cargo, root, run, target};
use crate::error::Error;
use crate::peers;
use baseline::{BenchBaseline, RoundRange};

/// Codec, strike to MIDI, a whole tick by activity, and one key from sample to force by model.
const PROGRAMS: [&str; 4] = ["frame_codec", "strike_to_midi", "tick_88_voices", "voices"];

const ROUNDS: usize = 9;

/// Short measurements, which the number of rounds compensates.
const SHORT: &str = "--warm-up-time 0.1 --measurement-time 0.3 --sample-size 20 --nresamples 1001 \
                     --noplot --quiet";

/// Loop that is the unit of all others.
const CALIBRATION: &str = "calibration";

const BASELINE: &str = "benches/baseline.toml";

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum BaselineUse {
    Compare,
    Write,
}

pub(crate) fn measure(usage: BaselineUse) -> Result<(), Error> {
    let path = root().join(BASELINE);
    let before = match usage {
        BaselineUse::Compare => Some(BenchBaseline::read(&path)?),
        BaselineUse::Write => None,
    };
    let benches = PROGRAMS.iter().chain([&scenes::PROGRAM]).flat_map(|name| ["--bench", name]);
    run(&mut cargo(["bench", "--workspace", "--no-run"].into_iter().chain(benches)))?;
    let now = BenchBaseline { machine: machine(), ranges: ranges()? };
    let Some(before) = before else {
        fs::write(&path, now.to_string()).map_err(|cause| Error::file(&path, cause))?;
        println!("{} benches are kept in {BASELINE}", now.ranges.len());
        return scenes::write(&scenes::measure()?, &now.machine);
    };
    print!("{}{}", before.table(&now), scenes::measure()?);
    let slower = before.slower(&now);
    if slower.is_empty() { peers::compare_counts() } else { Err(Error::Slower(slower)) }
}

/// Returns the range of each bench over all rounds, as multiples of the calibration.
fn ranges() -> Result<BTreeMap<String, RoundRange>, Error> {
    let home = target()?.join("latency");
    let mut rounds = BTreeMap::<String, Vec<f64>>::new();
    for round in 1..=ROUNDS {
        println!("round {round} of {ROUNDS}");
        for program in PROGRAMS {
            for (name, multiple) in round_of(program, &home)? {
                rounds.entry(name).or_default().push(multiple);
            }
        }
    }
    Ok(rounds.into_iter().map(|(name, rounds)| (name, RoundRange::of(rounds))).collect())
}

fn round_of(program: &str, home: &Path) -> Result<Vec<(String, f64)>, Error> {
    if home.exists() {
        fs::remove_dir_all(home).map_err(|cause| Error::file(home, cause))?;
    }
    let select = ["bench", "--quiet", "--workspace", "--bench", program, "--"];
    let mut command = cargo(select.into_iter().chain(SHORT.split_whitespace()));
    run(command.env("CRITERION_HOME", home).stdout(Stdio::null()).stderr(Stdio::null()))?;
    let mut times = sample::fastest_of(home)?;
    let unit = times.remove(CALIBRATION);
    let unit = unit.ok_or_else(|| Error::unobtainable("the calibration", program))?;
    Ok(times.into_iter().map(|(name, time)| (name, time / unit)).collect())
}

/// Returns name and number of processors: multiples of different machines are not comparable.
fn machine() -> String {
    let about = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let names = about.lines().filter_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let names: Vec<_> = names.map(|(_, name)| name.replace('"', "")).collect();
    names.first().map_or_else(|| "unknown".to_owned(), |name| format!("{} x {name}", names.len()))
}
