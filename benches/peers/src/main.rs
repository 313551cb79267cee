//! Other ODE solvers and `pode`, side by side on the same problems. See README.md.

mod arguments;
mod cases;
mod counts;
mod entry;
mod external;
mod judge;
mod log;
mod measure;
mod peers;
mod probes;
mod problem;
mod problems;
mod reference;
mod report;
mod rounds;
mod row;
mod table;
mod versions;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use arguments::Arguments;
use external::External;
use rounds::Plan;

fn main() -> ExitCode {
    let done = Arguments::parse(std::env::args().skip(1)).and_then(|arguments| run(&arguments));
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("peers: {why}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), String> {
    let plan = if arguments.quick {
        Plan { rounds: 1, budget: Duration::from_millis(2), last: 10 }
    } else {
        Plan { rounds: 3, budget: Duration::from_millis(15), last: 13 }
    };
    let cases = cases::all()?;
    if let Some(results) = &arguments.counts {
        return counts::compare(&cases, results);
    }
    let probes = probes::all();
    let out = &arguments.out;
    std::fs::create_dir_all(out).map_err(|error| format!("{}: {error}", out.display()))?;
    let work = parameter_folder(out)?;
    let mut outcome = rounds::run(&cases, &externals(arguments), plan, &work);
    std::fs::remove_dir_all(&work).map_err(|error| format!("{}: {error}", work.display()))?;
    outcome.skipped.extend(arguments.skipped.iter().cloned());
    report::write(out, &cases, &outcome, &probes, plan)
}

fn parameter_folder(out: &Path) -> Result<PathBuf, String> {
    let folder = out.join("parameters");
    std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    Ok(folder)
}

const CONTACTS: &[&str] = &["cradle-1", "cradle-0.8", "block"];

fn externals(arguments: &Arguments) -> Vec<External> {
    let script = |name: &str| Path::new(env!("CARGO_MANIFEST_DIR")).join("external").join(name);
    let mut all = Vec::new();
    if let Some(program) = &arguments.cvode {
        let only = &["figure-6", "ball", "stiff-10"];
        all.push(External {
            code: "CVODE",
            command: vec![program.clone()],
            rounds: u32::MAX,
            only,
        });
    }
    let mut with = |python: &Option<PathBuf>, code, name, only: &'static [&'static str]| {
        let command = python.iter().map(|python| vec![python.clone(), script(name)]);
        // Soft contacts take seconds per run: time them once.
        let rounds = if only == CONTACTS { 1 } else { u32::MAX };
        all.extend(command.map(|command| External { code, command, rounds, only }));
    };
    let python = &arguments.python;
    with(python, "SciPy", "scipy_peer.py", &[]);
    with(python, "heyoka", "heyoka_peer.py", &[]);
    with(python, "MuJoCo", "mujoco_peer.py", &["ball"]);
    with(python, "MuJoCo", "mujoco_contacts.py", CONTACTS);
    with(python, "Drake", "drake_peer.py", CONTACTS);
    with(&arguments.siconos, "Siconos", "siconos_peer.py", &["cradle-1", "cradle-0.8"]);
    all
}
