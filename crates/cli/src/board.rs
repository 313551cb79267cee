//! `letoff board`: simulated boards, for developing without hardware.

use std::fmt;
use std::fs;
use std::io::{self, Write};
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use boards::links::address::Address;
use boards::links::wire::WirePlan;
use boards::sim::board::{BoardMake, FakeIdentity};
use clap::{ArgGroup, Args};
use documents::shown;
use firmware_protocol::key::{BoardId, KEYS, KEYS_PER_BOARD};
use haptics::RigParameters;
use serde::Serialize;

use super::arguments::{number, ratio, seconds, share};
use super::signals::{Signals, runtime};
use super::{Failure, print_json, system};
use engine::realtime::clock;
use host::simulated::fault_script::FaultScript;
use host::simulated::{
    BoardProcess, ExitReport, WireEndpoint, faults_of, place, run as run_boards,
};
use keyboard::KeyRange;

/// Period of a simulated board's control of its motors (s).
const LAW_PERIOD: f64 = 100e-6;

/// What `letoff board` takes.
#[derive(Clone, Debug, Args)]
#[command(group(ArgGroup::new("wire").args(["loss", "flip", "baud", "late"]).multiple(true)))]
#[command(after_help = "Examples:
  letoff board                        board 0 on a pseudo-terminal; says how to reach it
  letoff board --count 8              a whole keybed, each board on its own
  letoff board --count 8 --on can:vcan0
  letoff board --number 3 --loss 0.001 --flip 0.001 --baud 1000000
  letoff board --count 2 --fate 1@2:mute=0.5 --fate 0@4:restart=1")]
pub struct BoardArgs {
    /// Number of the board, or of the first.
    #[arg(long, default_value_t = 0, value_parser = clap::value_parser!(u8).range(0..=14))]
    pub number: u8,
    /// How many boards to simulate.
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=15))]
    pub count: u8,
    /// Keys of the (first) board; without it eleven keys, those of its number.
    #[arg(long, value_name = "A0..G1")]
    pub keys: Option<String>,
    /// The link on which all boards shall be, instead of pseudo-terminals.
    #[arg(long, value_name = "can:INTERFACE", value_parser = Address::parse,
          conflicts_with_all = ["wire", "links"])]
    pub on: Option<Address>,
    #[command(flatten)]
    pub wire: WireArgs,
    /// Folder for links of fixed names to the pseudo-terminals: board0, board1 and so on.
    #[arg(long, value_name = "FOLDER")]
    pub links: Option<PathBuf>,
    /// What their encoders read when keys are at rest (counts).
    #[arg(long, default_value_t = 0, value_name = "COUNTS", allow_negative_numbers = true)]
    pub offset: i32,
    /// Force of their motors for a newton that is asked for.
    #[arg(long, default_value_t = 1.0, value_name = "RATIO", value_parser = ratio,
          allow_negative_numbers = true)]
    pub strength: f64,
    /// How much too fast their clocks run (1e-6).
    #[arg(long, default_value_t = 0.0, value_name = "PPM", value_parser = number,
          allow_negative_numbers = true)]
    pub drift: f64,
    /// What happens to a board, and when: NUMBER@SECONDS:WHAT, from its first arming on.
    #[arg(long = "fate", value_name = "FATE", value_parser = FaultScript::parse)]
    pub fates: Vec<FaultScript>,
    #[command(flatten)]
    pub fake: FakeIdentityArgs,
    /// How long they run (s); without it, until they are stopped.
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub duration: Option<f64>,
    /// Prints where they are, on one line, and in the end what became of them, both as JSON.
    #[arg(long)]
    pub json: bool,
}

/// Damage and limits of the wire between a board and its pseudo-terminal.
#[derive(Clone, Copy, Debug, Args)]
pub struct WireArgs {
    /// Share of the bytes on the wire that are lost.
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true)]
    pub loss: Option<f64>,
    /// Share of the bytes on the wire that come with an inverted bit.
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true)]
    pub flip: Option<f64>,
    /// Bits per second of the wire.
    #[arg(long, value_name = "BITS")]
    pub baud: Option<u32>,
    /// How much later everything comes over the wire, each way (ms).
    #[arg(long, value_name = "MS", value_parser = clap::value_parser!(u32).range(0..=1000))]
    pub late: Option<u32>,
    /// Where the wires' chance starts from, if there is a wire: 1 without.
    #[arg(long, requires = "wire")]
    pub seed: Option<u64>,
}

/// Claims of the boards about themselves that are not true.
#[derive(Clone, Copy, Debug, Args)]
pub struct FakeIdentityArgs {
    /// Another major version of the protocol that they say they speak.
    #[arg(long = "say-major", value_name = "MAJOR")]
    pub major: Option<u8>,
    /// Another schema of the cyclic layouts that they say they have.
    #[arg(long = "say-schema", value_name = "HASH")]
    pub schema: Option<u64>,
    /// Other keys than theirs that they say they carry: the first, and how many.
    #[arg(id = "say_keys", long = "say-keys", value_name = "FIRST,COUNT", value_parser = pair)]
    pub keys: Option<(u8, u8)>,
    /// The id that they all say they have, as six numbers.
    #[arg(long = "say-uid", value_name = "NUMBER")]
    pub uid: Option<u8>,
}

fn pair(text: &str) -> Result<(u8, u8), String> {
    let pair = text.split_once(',').and_then(|(a, b)| Some((a.parse().ok()?, b.parse().ok()?)));
    pair.ok_or_else(|| format!("`{text}` is no range: write FIRST,COUNT, as 0,11"))
}

/// Runs simulated boards, and reports how they ended.
pub(super) fn run(args: &BoardArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let mut boards = boards(args)?;
    let stop = Arc::new(AtomicBool::new(false));
    let duration = args.duration.map(clock::from_seconds);
    let boards = runtime()?.block_on(async {
        let its_stop = Arc::clone(&stop);
        let mut signals = Signals::new().map_err(system)?;
        let _names =
            args.links.as_ref().map(|folder| FixedNames::make(&boards, folder)).transpose()?;
        introduce(&boards, args, out)?;
        let mut running = tokio::task::spawn_blocking(move || {
            run_boards(&mut boards, duration, &its_stop, &mut report_light);
            boards
        });
        loop {
            tokio::select! {
                done = &mut running => {
                    return done.map_err(|panic| Failure::Running(panic.to_string()));
                }
                () = signals.next() => stop.store(true, Ordering::Release),
            }
        }
    })?;
    let reports: Vec<_> = boards.iter().map(BoardProcess::exit_report).collect();
    if args.json { print_json(&reports, out) } else { Ok(write!(out, "{}", BoardTable(&reports))?) }
}

/// Writes to stderr which board shows its light.
fn report_light(board: &BoardProcess) {
    let _nobody_reads = writeln!(io::stderr(), "{} shows its light", board.address);
}

/// Returns the boards that are asked for, where they are asked for.
fn boards(args: &BoardArgs) -> Result<Vec<BoardProcess>, Failure> {
    refuse_unknown_boards(args)?;
    let WireArgs { loss, flip, baud, late, seed } = args.wire;
    let at = if let Some(address) = &args.on {
        WireEndpoint::Shared(address.clone())
    } else if loss.or(flip).is_some() || baud.or(late).is_some() {
        WireEndpoint::Wire(WirePlan {
            seed: seed.unwrap_or(1),
            baud,
            loss: loss.unwrap_or(0.0),
            flip: flip.unwrap_or(0.0),
            late_us: 1_000 * late.unwrap_or(0),
            ..WirePlan::default()
        })
    } else {
        WireEndpoint::Pty
    };
    (0..args.count).map(|n| board(args, n, &at)).collect()
}

/// Refuses faults of boards that are not simulated.
fn refuse_unknown_boards(args: &BoardArgs) -> Result<(), Failure> {
    let last = args.number.saturating_add(args.count - 1);
    let unknown = args.fates.iter().filter(|it| !(args.number..=last).contains(&it.number));
    let wrong: Vec<_> = unknown
        .map(|it| format!("--fate {}@{}: there is no board {0}", it.number, it.at))
        .collect();
    if wrong.is_empty() {
        return Ok(());
    }
    let all = if args.number == last { String::new() } else { format!(" to {last}") };
    let help = format!("; give fates to board {}{all}, or another --count", args.number);
    Err(Failure::Usage(wrong.join("\nletoff: ") + &help))
}

/// Returns the n-th board.
fn board(args: &BoardArgs, n: u8, at: &WireEndpoint) -> Result<BoardProcess, Failure> {
    let usage = |error: boards::Error| Failure::Usage(error.to_string());
    let number = args.number.saturating_add(n);
    let id = BoardId::new(number).ok_or_else(|| {
        Failure::Usage(format!("no board has the number {number}; they end at 14"))
    })?;
    let (first_key, n_keys) = keys(args, n, number)?;
    let FakeIdentityArgs { major, schema, keys: claimed, uid } = args.fake;
    let uid = uid.map(|it| [it; 6]);
    let fake_identity = FakeIdentity { major, schema, keys: claimed, uid };
    let rig = RigParameters::default();
    let (period, offset, strength) = (LAW_PERIOD, args.offset, args.strength);
    let make = BoardMake { id, first_key, n_keys, period, rig, offset, strength, fake_identity };
    let placed = place(id, at).map_err(|error| Failure::Usage(error.to_string()))?;
    BoardProcess::new(make, placed, args.drift, faults_of(&args.fates, number)).map_err(usage)
}

/// Returns the keys of the n-th board, which has this number: the first, and how many.
fn keys(args: &BoardArgs, n: u8, number: u8) -> Result<(u8, usize), Failure> {
    let (first, len) = match &args.keys {
        Some(keys) => {
            let range = KeyRange::parse(keys).map_err(|error| Failure::Usage(error.to_string()))?;
            (range.first().index(), range.numbers().count())
        }
        None => (usize::from(number - n) * KEYS_PER_BOARD, KEYS_PER_BOARD),
    };
    let first = first + usize::from(n) * len;
    if KEYS < first + len {
        let sentence = format!("board {number} would carry keys beyond C8: give --keys");
        return Err(Failure::Usage(sentence));
    }
    Ok((u8::try_from(first).unwrap_or(u8::MAX), len))
}

/// Links of fixed names to the boards' ports, which are removed in the end.
#[derive(Default)]
struct FixedNames(Vec<(PathBuf, PathBuf)>);

impl FixedNames {
    /// Makes them in `folder`; one of an earlier run is replaced.
    fn make(boards: &[BoardProcess], folder: &Path) -> Result<Self, Failure> {
        let refuse = |path: &Path, error: io::Error| {
            Failure::Usage(format!(
                "--links: {} cannot be made: {error}; give a folder in which you may write",
                shown(path)
            ))
        };
        fs::create_dir_all(folder).map_err(|error| refuse(folder, error))?;
        let mut names = Self::default();
        for running in boards {
            let name = folder.join(format!("board{}", running.board.make().id.number()));
            let port = running.address.trim_start_matches("serial:");
            let port = PathBuf::from(port.rsplit_once('@').map_or(port, |(port, _baud)| port));
            if name.is_symlink() {
                let _gone = fs::remove_file(&name);
            }
            symlink(&port, &name).map_err(|error| refuse(&name, error))?;
            names.0.push((name, port));
        }
        Ok(names)
    }
}

impl Drop for FixedNames {
    fn drop(&mut self) {
        // Other boards may have taken a name.
        for (name, port) in &self.0 {
            if fs::read_link(name).is_ok_and(|there| there == *port) {
                let _gone = fs::remove_file(name);
            }
        }
    }
}

/// A board's address, as JSON.
#[derive(Serialize)]
struct Whereabouts<'a> {
    number: u8,
    keys: String,
    link: &'a str,
}

/// Says which boards there are, and how a host reaches them.
fn introduce(
    boards: &[BoardProcess],
    args: &BoardArgs,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let boards = boards.iter().map(|running| Whereabouts {
        number: running.board.make().id.number(),
        keys: running.keys().to_string(),
        link: &running.address,
    });
    let boards: Vec<_> = boards.collect();
    if args.json {
        writeln!(out, "{}", serde_json::json!({ "boards": boards }))?;
        return Ok(out.flush()?);
    }
    for Whereabouts { number, keys, link } in &boards {
        writeln!(out, "board {number}, {keys}: {link}")?;
    }
    let mut links: Vec<_> = boards.iter().map(|it| format!("--link {}", it.link)).collect();
    links.dedup();
    writeln!(out, "reach them with: letoff run {}", links.join(" "))?;
    Ok(out.flush()?)
}

/// The reports of the boards, as a table.
struct BoardTable<'a>(&'a [ExitReport]);

impl fmt::Display for BoardTable<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "board keys       samples   forces corrupt refused  stale unasw. trips oldest ms  force N  state"
        )?;
        for it in self.0 {
            let c = &it.counts;
            writeln!(
                f,
                "{:5} {:9} {:8} {:8} {:7} {:7} {:6} {:6} {:5} {:9.1} {:8.3}  {}",
                it.number,
                it.keys,
                c.samples,
                c.forces,
                c.corrupt,
                c.refused,
                c.stale,
                c.unanswered,
                c.trips,
                c.oldest_us as f64 * 1e-3,
                it.force_n,
                it.state,
            )?;
        }
        Ok(())
    }
}
