//! `letoff calibrate`: measures how the keys of boards read and push.
//!
//! The keys move one after the other: down with 1.5 N at most, and up again; with a weight, once
//! more with twice its force and 0.5 N at most. With `--range` one key renders a spring, a dashpot
//! and a mass with 8 N at most.

mod bring_up;
mod measure;
mod operator;
mod range;
mod table;
mod write;

use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use boards::calibrate::{Ending, WEIGHTS};
use boards::keybed::{Armed, Keybed};
use clap::Args;
use firmware_protocol::key::KeyIndex;

use self::bring_up::Ready;
use self::operator::Operator;
use self::write::CalibrationRecord;
use super::arguments::note;
use super::signals::{Signals, runtime};
use super::target::SceneTarget;
use super::{Failure, endpoints, print_json, system};
use host::connected_boards::stop_all;
use host::control::EmergencyStop;

/// What `letoff calibrate` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff calibrate --link serial:/dev/ttyACM0
  letoff calibrate my-scene.toml --board 3 --weight 50
  letoff calibrate --range --key C4 --link can:can0

Nobody may touch the keys meanwhile: each goes down and up by itself, with 1.5 N
at most; with --weight, once more with twice the weight's force and 0.5 N at most.
When it is stopped or a key fails, what was measured is kept: in the board's file if
that has the other keys from before, otherwise beside it for the next time.

With --range one key goes down and up, and then renders a spring, a dashpot and a
mass at the scene's tick_hz and with its estimator, with 8 N at most. Each is raised
by a quarter at a time; a pulse of the motor sets the key in motion, and nobody has
to touch it. Where it does not come to rest it is let go in the same tick, and the
value before is tried again. A finger that rests on the key makes more stable.
No file is written.

`letoff stop` takes the force away at once; Ctrl-C ends it and disarms all boards.")]
pub struct CalibrateArgs {
    /// Whose keys shall be measured.
    #[command(flatten)]
    pub target: SceneTarget,
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
    /// Says what the rig can render instead: a spring, a dashpot and a mass are raised on one key
    /// until it shakes.
    #[arg(long, conflicts_with_all = ["weight", "yes"])]
    pub range: bool,
    /// The key for --range, as C4; without it, the first of the first board.
    #[arg(long, value_name = "KEY", requires = "range", value_parser = note)]
    pub key: Option<KeyIndex>,
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

#[derive(Clone, Default)]
struct Endings {
    /// `letoff stop`: the boards render no force from then on, and stay stopped.
    emergency: Arc<EmergencyStop>,
    /// A signal: the push is withdrawn, and the boards are disarmed.
    is_over: Arc<AtomicBool>,
}

impl Endings {
    fn look(&self, keybed: &mut Keybed<Armed>) -> Option<Ending> {
        if self.emergency.is_asked() {
            self.emergency.answer(stop_all(keybed));
            return Some(Ending::AtOnce);
        }
        self.is_over.load(Ordering::Acquire).then_some(Ending::Gently)
    }
}

pub(super) fn run(args: &CalibrateArgs, out: &mut dyn Write) -> Result<(), Failure> {
    if args.range {
        return range::run(args, out);
    }
    let operator = Operator::new(args);
    if args.weight.is_some() {
        operator.must_be_there("--weight")?;
    }
    let (target, only, folder) = (args.target.clone(), args.board, args.folder.clone());
    let (find, weight) = (move || bring_up::find(&target, only, folder, &operator), args.weight);
    let measure = move |Ready { boards, keybed }, endings: &Endings| {
        let mut record = CalibrationRecord::default();
        let bench = bring_up::arm(keybed, bring_up::HZ, endings)?;
        match measure::all(&boards, bench, weight, &mut record) {
            // Stopped boards are left alone.
            (_stopped, Some(Ending::AtOnce)) => {}
            (keybed, Some(Ending::Gently) | None) => record.tell(keybed),
        }
        Ok(record)
    };
    let CalibrationRecord { written, wrong, .. } = attended(find, measure)?;
    if args.json {
        print_json(&written, out)?;
    } else {
        table::print(&written, out)?;
    }
    if wrong.is_empty() { Ok(()) } else { Err(Failure::Running(wrong.join("\nletoff: "))) }
}

/// Runs `find`, which arms no board, then `measure`; signals and `letoff stop` end both.
fn attended<F: Send + 'static, M: Send + 'static>(
    find: impl FnOnce() -> Result<F, Failure> + Send + 'static,
    measure: impl FnOnce(F, &Endings) -> Result<M, Failure> + Send + 'static,
) -> Result<M, Failure> {
    let runtime = runtime()?;
    let Some(measured) = runtime.block_on(measured(find, measure))? else {
        // Do not wait for the blocked thread: no board is armed.
        runtime.shutdown_background();
        return Err(Failure::Running("stopped before any board was armed".into()));
    };
    Ok(measured)
}

/// Like [`attended`]; returns `None` if stopped before any board was armed.
async fn measured<F: Send + 'static, M: Send + 'static>(
    find: impl FnOnce() -> Result<F, Failure> + Send + 'static,
    measure: impl FnOnce(F, &Endings) -> Result<M, Failure> + Send + 'static,
) -> Result<Option<M>, Failure> {
    let mut signals = Signals::new().map_err(system)?;
    let endings = Endings::default();
    let (clients, reach) = endpoints::listen(&endings.emergency);
    reach.check()?;
    let Some(found) = signals.unless_stopped(&endings.emergency, find).await? else {
        clients.leave().await;
        return Ok(None);
    };
    let (found, its_endings) = (found?, endings.clone());
    let mut measuring = tokio::task::spawn_blocking(move || measure(found, &its_endings));
    let measured = loop {
        tokio::select! {
            measured = &mut measuring => break measured,
            () = signals.next() => endings.is_over.store(true, Ordering::Release),
        }
    };
    clients.leave().await;
    measured.map_err(panicked)?.map(Some)
}

#[expect(clippy::needless_pass_by_value, reason = "fits map_err")]
fn panicked(panic: tokio::task::JoinError) -> Failure {
    Failure::Running(panic.to_string())
}
