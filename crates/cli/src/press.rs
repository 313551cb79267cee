//! `letoff press KEY`: presses a simulated key of the running host while this command runs.

use std::io::Write;
use std::os::unix::net::UnixStream;
use std::time::Duration;

use clap::Args;
use telemetry::KeyIndex;
use tokio::io::AsyncReadExt as _;

use super::arguments::{number, seconds};
use super::signals::{Signals, runtime};
use super::{Failure, system};
use figures::weight::weight_for;
use host::control::{Reply, Request, hold, send_to_host};
use midi::Velocity;
use scene::{Library, Scene};

/// What `letoff press` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff press C4 --for 0.5          half a second, with 5 N
  letoff press 60 --force 12         until Ctrl-C
  letoff press C4 --velocity 80      with the weight under which it sounds so

The key is let go when the command ends, however it ends.")]
pub struct PressArgs {
    /// The key's name, as C4, or its MIDI number.
    #[arg(value_parser = key)]
    pub key: KeyIndex,
    /// The force of the finger (N).
    #[arg(long, value_name = "N", default_value_t = 5.0, value_parser = number)]
    pub force: f64,
    /// The MIDI velocity at which it is to sound, instead of a force, 1 to 127.
    #[arg(long, value_name = "V", conflicts_with = "force", value_parser = velocity)]
    pub velocity: Option<Velocity>,
    /// How long it is pressed (s); until the command is ended without.
    #[arg(long = "for", value_name = "SECONDS", value_parser = seconds)]
    pub length: Option<f64>,
}

pub(super) fn run(args: &PressArgs, out: &mut dyn Write) -> Result<(), Failure> {
    runtime()?.block_on(async {
        // Catch signals before the press, so that the command always ends it.
        let signals = Signals::new().map_err(system)?;
        let newtons = match args.velocity {
            Some(velocity) => weight(args.key, velocity)?,
            None => args.force,
        };
        let request = Request::Press { key: args.key.number(), newtons };
        let (answer, connection) =
            hold(&request).map_err(|error| Failure::Running(error.to_string()))?;
        if let Reply::Done { text } = answer.map_err(Failure::Usage)? {
            writeln!(out, "{text}")?;
            out.flush()?;
        }
        wait(args.length, connection, signals).await
    })
}

/// Returns the weight (N) under which `key` sounds at `velocity` in the running host.
fn weight(key: KeyIndex, velocity: Velocity) -> Result<f64, Failure> {
    let answer = send_to_host(&Request::Scene {});
    let answer = answer.map_err(|error| Failure::Running(error.to_string()))?;
    let Reply::Scene { toml } = answer.map_err(Failure::Usage)? else {
        return Err(Failure::Running("what answered is no host of this version".to_owned()));
    };
    let scene = Scene::from_text(&Library::default(), "the host's scene", toml);
    let scene = scene.map_err(|wrong| Failure::Running(wrong.to_string()))?;
    let found = weight_for(&scene, key, velocity);
    found.map_err(|error| Failure::Usage(error.to_string()))
}

async fn wait(
    length: Option<f64>,
    connection: UnixStream,
    mut signals: Signals,
) -> Result<(), Failure> {
    connection.set_nonblocking(true).map_err(system)?;
    let mut connection = tokio::net::UnixStream::from_std(connection).map_err(system)?;
    let over = async {
        match length {
            Some(seconds) => {
                let length = Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX);
                tokio::time::sleep(length).await;
            }
            None => std::future::pending().await,
        }
    };
    tokio::select! {
        () = over => Ok(()),
        () = signals.next() => Ok(()),
        _ended = connection.read_u8() => Err(Failure::Running(
            "the host ended while the key was pressed".to_owned(),
        )),
    }
}

fn velocity(text: &str) -> Result<Velocity, String> {
    let velocity = text.parse().ok().and_then(Velocity::new);
    velocity.ok_or_else(|| format!("`{text}` is no velocity: give 1 to 127"))
}

pub(super) fn key(text: &str) -> Result<KeyIndex, String> {
    let numbered = text.parse().ok().and_then(KeyIndex::from_midi);
    let named = || text.parse().ok();
    numbered.or_else(named).ok_or_else(|| {
        format!("`{text}` is no key: write its name, A0 to C8, or its MIDI number, 21 to 108")
    })
}
