//! `cargo xtask soak`: a trial of the whole host, with dense random music on all keys and faults in
//! everything around it.
//!
//! | module | contents |
//! |---|---|
//! | `plan` | the music and the faults, all from one seed |
//! | `music` | the strokes of the fingers |
//! | `watch` | between scheduler and keys: spoils samples, checks forces |
//! | `actions` | actions of a tuner, failing models and a full disk, by tick |
//! | `synthesizer` | the destination of MIDI, whose port vanishes |
//! | `telling` | events and log lines of the run |
//! | `recordings` | checks of the recordings |
//! | `strangers` | in real time: bad clients, busy processors, a stopped process |
//! | `trial` | settings and result of one run |
//! | `judge` | the verdicts |
//! | `report` | the trial in words |
//! | `run` | plays the plan, and the same music without faults |
//!
//! In virtual time the same music is played a second time without faults: spared keys must feel the
//! same to the last bit.
#![forbid(unsafe_code)]
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a command for people")]

mod actions;
mod judge;
mod music;
mod plan;
mod recordings;
mod report;
mod run;
mod strangers;
mod synthesizer;
mod telling;
mod trial;
mod watch;

use std::error::Error;
use std::fs::DirBuilder;
use std::os::unix::fs::DirBuilderExt as _;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use rustix::process::Signal;
use scene::{Library, LinksConfig, Override, Scene};
use tokio::signal::unix::{SignalKind, signal};

use trial::{SoakChoice, SoakTime};

/// Shortest trial (s), with time to fail and to recover.
const SHORTEST: i64 = 10;

/// Tries the whole host under random music and faults in everything around it.
#[derive(Clone, Debug, Parser)]
#[command(
    name = "cargo xtask soak",
    after_help = "Examples:
  cargo xtask soak --duration 60 --seed 7
  cargo xtask soak springs --duration 600 --real-time --out report

tests/soak/README.md lists the faults and the promises.

Exit codes: 0 every promise was kept; 1 one was broken; 2 wrong usage."
)]
struct SoakArgs {
    /// A scene's name or file; its links, pianist and MIDI output are not used.
    #[arg(default_value = "default")]
    scene: String,
    /// Length of the trial (s), 10 or more.
    #[arg(long, value_name = "SECONDS", default_value_t = 60,
          value_parser = clap::value_parser!(u32).range(SHORTEST..))]
    duration: u32,
    /// Seed of all random numbers.
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// By the clock, beside busy processors and strangers.
    #[arg(long)]
    real_time: bool,
    /// Folder for the recordings; without it nothing is kept.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

fn main() -> ExitCode {
    match soak(&SoakArgs::parse()) {
        Ok(is_kept) => ExitCode::from(u8::from(!is_kept)),
        Err(error) => {
            eprintln!("soak: {error}");
            ExitCode::FAILURE
        }
    }
}

fn soak(args: &SoakArgs) -> Result<bool, Box<dyn Error>> {
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
    let _entered = runtime.enter();
    // With a handler, a write beyond `RLIMIT_FSIZE` is an error and does not end the process.
    let _too_large = signal(SignalKind::from_raw(Signal::XFSZ.as_raw()))?;
    let name = format!("letoff-soak-{}", std::process::id());
    let folder = args.out.clone().unwrap_or_else(|| std::env::temp_dir().join(name));
    DirBuilder::new().recursive(args.out.is_some()).mode(0o700).create(&folder)?;
    let choice = SoakChoice {
        scene: scene(&args.scene)?,
        seed: args.seed,
        seconds: f64::from(args.duration),
        time: if args.real_time { SoakTime::Real } else { SoakTime::Virtual },
        folder: folder.clone(),
    };
    let tried = run::soak(&choice);
    if args.out.is_none() {
        std::fs::remove_dir_all(&folder)?;
    }
    let (text, verdicts) = tried?;
    print!("{text}");
    Ok(verdicts.iter().all(|verdict| verdict.is_kept))
}

fn scene(name: &str) -> Result<Scene, Box<dyn Error>> {
    let set = [("pianist.performance", "none"), ("midi.output", "none")];
    let set = set.map(|(name, value)| Override::from((name.to_owned(), value.to_owned())));
    let scene =
        Scene::load_as_typed(&Library::default(), name, &set).map_err(|wrong| wrong.to_string())?;
    Ok(Scene { links: LinksConfig::Simulated, ..scene })
}
