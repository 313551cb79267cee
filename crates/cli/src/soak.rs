//! `letoff lab soak`: the whole host, with faults in everything around it.

use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use diagnostics::shown;
use scene::{Library, LinksConfig, Override, Scene};
use soak::{HostFiles, SoakChoice, SoakError, SoakReport, SoakTime, SupervisedProgram, soak};

use super::arguments::seconds;
use super::signals::{Signals, runtime};
use super::{Failure, prepare_report, print_json, system};

/// Shortest trial (s): there must be time to fail and to recover.
const SHORTEST: f64 = 10.0;

/// What `letoff lab soak` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff lab soak --duration 60 --seed 7
  letoff lab soak springs --duration 600 --real-time --out report

Random dense music is played on all keys while frames are lost, damaged and late, boards fall
silent, sensors say NaN, models get impossible values, a tuner sets values, the MIDI port vanishes
and the disk is full. In virtual time a seed gives the same bits every time, and keys that nothing
befell are compared with a run without faults. In real time processors are busy beside, clients of
the stream stall and send rubbish, the process is stopped for moments, and a supervised host in
processes of its own is killed at random: it must play again, and no note of it may be stuck.

Exit codes: 0 every promise was kept; 1 one was broken; 2 wrong usage or file.")]
pub struct SoakArgs {
    /// A scene's name or file; its links, pianist and MIDI output are not used.
    #[arg(default_value = "default")]
    pub scene: String,
    /// Length of the trial (s), 10 or more.
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true,
          default_value = "60")]
    pub duration: f64,
    /// Seed of all random numbers.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// By the clock, beside busy processors and strangers.
    #[arg(long)]
    pub real_time: bool,
    /// Folder for soak.json and the recordings; without it nothing is kept.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Prints the report as JSON.
    #[arg(long)]
    pub json: bool,
}

/// Tries the host and prints the verdicts.
pub(super) fn run(args: &SoakArgs, out: &mut dyn Write) -> Result<(), Failure> {
    if args.duration < SHORTEST {
        let text = format!("--duration {}: a trial takes {SHORTEST} s or more", args.duration);
        return Err(Failure::Usage(text));
    }
    let scene = scene(&args.scene)?;
    prepare_report(args.out.as_deref())?;
    let kept = args.out.clone();
    let folder =
        kept.map_or_else(temporary, Ok).map_err(|error| Failure::Usage(error.to_string()))?;
    let time = if args.real_time { SoakTime::Real } else { SoakTime::Virtual };
    let choice = SoakChoice {
        scene,
        seed: args.seed,
        seconds: args.duration,
        time,
        folder: folder.clone(),
        supervised: Some(supervised(&folder)),
    };
    let tried = until_signal(choice);
    if args.out.is_none() {
        // It was made a moment ago; what cannot be removed lies among temporary files.
        let _left = std::fs::remove_dir_all(&folder);
    }
    let report = tried?;
    if let Some(folder) = &args.out {
        write(&report, &folder.join("soak.json"))?;
    }
    if args.json {
        print_json(&report, out)?;
    } else {
        write!(out, "{report}")?;
    }
    let broken = report.broken();
    if broken.is_empty() { Ok(()) } else { Err(Failure::Running(broken.join("\nletoff: "))) }
}

/// Returns this program as the supervisor of a host whose files are in `folder`.
fn supervised(folder: &Path) -> SupervisedProgram {
    let HostFiles { scene, midi, socket, last_minutes, .. } = HostFiles::in_folder(folder);
    let mut port = OsString::from("raw:");
    port.push(midi);
    let typed = ["run".into(), "--supervised".into(), "--listen".into(), "none".into()];
    let files = [scene.into(), "--midi".into(), port, "--black-box".into(), last_minutes.into()];
    SupervisedProgram {
        program: host::guardian::program(),
        arguments: typed.into_iter().chain(files).collect(),
        environment: vec![("LETOFF_SOCKET".into(), socket.into())],
    }
}

/// Returns the scene on simulated keys, without its pianist and its MIDI output.
fn scene(name: &str) -> Result<Scene, Failure> {
    let set = [("pianist.performance", "none"), ("midi.output", "none")];
    let set = set.map(|(name, value)| Override::from((name.to_owned(), value.to_owned())));
    let scene = Scene::load_as_typed(&Library::default(), name, &set);
    let scene = scene.map_err(|diagnostics| Failure::Usage(diagnostics.to_string()))?;
    super::stable::refuse_unstable(&scene)?;
    Ok(Scene { links: LinksConfig::Simulated, ..scene })
}

/// Tries the host until the end or a signal.
fn until_signal(choice: SoakChoice) -> Result<SoakReport, Failure> {
    runtime()?.block_on(async {
        let mut signals = Signals::new().map_err(system)?;
        let stop = Arc::new(AtomicBool::new(false));
        let its_stop = Arc::clone(&stop);
        let mut trying = tokio::task::spawn_blocking(move || soak(&choice, &its_stop));
        let tried = loop {
            tokio::select! {
                tried = &mut trying => break tried,
                () = signals.next() => stop.store(true, Ordering::Release),
            }
        };
        let tried = tried.map_err(|panic| Failure::Running(panic.to_string()))?;
        tried.map_err(|error| match error {
            SoakError::Session(error) => Failure::Usage(error.to_string()),
            SoakError::Synthesizer(_) | SoakError::System(_) | SoakError::Stopped => {
                Failure::Running(error.to_string())
            }
        })
    })
}

fn write(report: &SoakReport, path: &Path) -> Result<(), Failure> {
    let mut text = Vec::new();
    print_json(report, &mut text)?;
    let written = std::fs::write(path, text);
    written.map_err(|error| Failure::Running(format!("{}: {error}", shown(path))))
}

/// Makes a folder that only this user can look into.
fn temporary() -> std::io::Result<PathBuf> {
    use std::os::unix::fs::DirBuilderExt as _;
    let folder = std::env::temp_dir().join(format!("letoff-soak-{}", std::process::id()));
    std::fs::DirBuilder::new().mode(0o700).create(&folder)?;
    Ok(folder)
}
