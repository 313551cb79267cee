//! The whole host against the fault rig: the reference firmware with motors, encoders, a finger
//! and every known fault of boards. Both live in virtual time, so each row is exact.
//!
//! the log and the exit code. The bounds are those of the classes in `firmware-protocol/BOARDS.md`.

use std::path::Path;

use serde_json::Value;

use crate::letoff::{self, Said};
use crate::lockstep::build;

#[derive(Clone, Copy, PartialEq, Debug)]
enum Class {
    AtArming,
    /// Damages samples or frames: almost no energy reaches the key.
    InSamples,
    InRun,
    BeyondHost,
}

struct Row {
    fault: &'static str,
    /// Begin, after the first arming (s).
    from: &'static str,
    class: Class,
    /// Delay from the begin until it shows (s).
    shows: f64,
    /// Work beyond the bound that the host cannot prevent yet (mJ).
    beyond: f64,
    code: i32,
    words: &'static str,
}

const fn row(
    fault: &'static str,
    from: &'static str,
    class: Class,
    code: i32,
    words: &'static str,
) -> Row {
    Row { fault, from, class, shows: 0.0, beyond: 0.0, code, words }
}

impl Row {
    const fn shows(self, seconds: f64) -> Self {
        Self { shows: seconds, ..self }
    }

    /// Marks a fault that misses its bound. A path length that changes by two periods per sample
    /// looks like samples that slide past the ticks, until a law on the board holds the forces.
    const fn missing_by(self, millijoules: f64) -> Self {
        Self { beyond: millijoules, ..self }
    }
}

use Class::{AtArming, BeyondHost, InRun, InSamples};

#[rustfmt::skip]
const ROWS: &[Row] = &[
    row("half", "0", AtArming, 1, "confirmed a sample every 1.00 ms and sends one every 2.00 ms"),
    row("burst", "0", AtArming, 1, "its samples come in bursts every 16 ms"),
    row("burst=4", "0", AtArming, 1, "its samples come in bursts every 4 ms"),
    row("latency", "0", AtArming, 1, "with the delay of these links, C4 with key-hammer-springs"),
    row("wronglen", "0", AtArming, 1, "forces were refused: their packing or their length"),
    row("stale", "0", AtArming, 1, "forces were stale: they answer samples it has forgotten"),
    row("drift=40000", "0", AtArming, 1, "its clock runs 4.0 % too fast"),
    row("motorsign", "0", AtArming, 1, "C4 is muted: it moves against its motor's force; exchange its motor's wires"),
    row("deadmotor", "0", AtArming, 1, "C4 is muted: its motor does not move it"),
    row("encsign", "0", AtArming, 1, "C4 is muted: its readings lie far beyond its rest"),
    row("hot", "0", AtArming, 1, "C4 is muted: its board reports that its motor is too hot; let it cool down"),
    row("nothomed", "0", AtArming, 1, "its encoders do not know where C4 is"),
    row("noise=100", "0", AtArming, 1, "C4 is muted: its readings go to and fro faster than a key can"),
    row("brown=0.6", "0", AtArming, 1, "it restarted 5 times of late (its supply gave way, reason 2)"),
    row("spike", "0", InSamples, 0, "armed"),
    row("bigspike", "6", InSamples, 1, "C4 is muted: its readings have slipped"),
    row("noise", "0", InSamples, 0, "armed"),
    row("latency", "6", InSamples, 1, "periods later than when it was armed, so it gets less force"),
    row("jitter", "6", InSamples, 1, "C4 is muted: its force went to and fro").missing_by(20.0),
    row("drop", "6", InSamples, 0, "of its samples were lost on the way"),
    row("dropdown", "6", InSamples, 0, "of its samples were never answered"),
    row("corrupt", "6", InSamples, 0, "armed"),
    row("echo", "0", InSamples, 0, "armed"),
    row("text", "0", InSamples, 0, "armed"),
    row("boottext", "0", InSamples, 0, "armed"),
    row("repeat", "0", InSamples, 0, "armed"),
    row("drift", "0", InSamples, 0, "armed"),
    row("oldminor", "0", InSamples, 0, "armed"),
    row("velsign", "0", InSamples, 0, "armed"),
    row("hang", "0", InSamples, 0, "being brought up"),
    row("cogging", "0", InSamples, 0, "armed"),
    row("half", "6", InRun, 1, "left alone: it confirmed a sample every 1.00 ms, and sends one every 2.00 ms"),
    row("burst=4", "6", InRun, 1, "its samples come in bursts every 4 ms"),
    row("shift", "6", InRun, 1, "C4 is muted: its readings have slipped: counts were lost"),
    row("shift=3000", "6", InRun, 1, "C4 is muted: its readings have slipped: counts were lost"),
    row("motorsign", "6", InRun, 1, "see to its motor's wires"),
    row("deadmotor", "6", InRun, 1, "C4 is muted: it does not follow its motor's force"),
    row("jumpy", "6", InRun, 1, "C4 is muted: its readings go to and fro faster than a key can"),
    row("noise=100", "6", InRun, 1, "C4 is muted: its readings go to and fro faster than a key can"),
    row("encsign", "6", InRun, 1, "C4 is muted: its readings lie far beyond"),
    row("keyfault", "6", InRun, 1, "C4 is muted: its board reports that its motor is too hot"),
    row("overheat", "6", InRun, 1, "C4 is muted: its board reports that its motor is too hot").shows(1.7),
    row("scale", "0", InRun, 1, "C4 is muted: its readings lie far beyond").shows(1.1),
    row("weak", "6", InRun, 1, "C4 is muted: it does not follow its motor's force").shows(2.3),
    row("frozen", "8", InRun, 1, "C4 is muted: it does not follow its motor's force").shows(5.1),
    row("restart=2", "0", InRun, 1, "left off: it restarted").shows(6.0),
    row("stuck", "0", BeyondHost, 1, "its motor pushes by itself (then cut its supply)"),
    row("stuck", "8", BeyondHost, 1, "if the motor pushes by itself, cut its supply"),
    row("stuck=-8 --finger none", "0", BeyondHost, 1, "C4 is muted: its motor does not move it"),
];

/// Largest push of a proof (N), with the overshoot of a current loop.
const MOST_PUSH: f64 = 1.55;

/// Work (mJ) and push along a motion (N) that a damaged board may add to an honest one's.
const MORE_WORK: f64 = 5.0;
const MORE_PUSH: f64 = 2.0;

/// Time from the sign of a fault to the end of all forces (s): 100 ms, then 20 ms of fading.
const SILENCED: f64 = 0.12;

const MAX_FORCE: f64 = 30.0;

struct Felt {
    key: Value,
}

impl Felt {
    fn get(&self, name: &str) -> f64 {
        self.key[name].as_f64().unwrap_or_default()
    }
}

fn play(rig: &Path, instrument: &str, seconds: &str, arguments: &str) -> (Said, Option<Felt>) {
    let name: String =
        arguments.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
    let folder = letoff::folder(&format!("fault-rig/{instrument}{name}"));
    let report = folder.join("rig.json");
    let _none = std::fs::remove_file(&report);
    let link =
        format!("rig:{} --lockstep --report {} {arguments}", rig.display(), report.display());
    let scene = format!(
        "title = \"one board\"\ntick_hz = 1000\n[render]\npassivity = \"control\"\n[[keys]]\n\
         range = \"C4..D#4\"\ninstrument = \"{instrument}\"\n[midi]\noutput = \"none\"\n"
    );
    std::fs::write(folder.join("scene.toml"), scene).expect("a scene");
    let run = ["run", "scene.toml", "--link", &link, "--performance", "none", "--virtual-time"];
    let said = letoff::run(&folder, &[&run[..], &["--duration", seconds, "--json"]].concat());
    let felt = std::fs::read_to_string(report).ok().map(|text| {
        let report: Value = serde_json::from_str(&text).expect("a report");
        Felt { key: report["keys"][0].clone() }
    });
    (said, felt)
}

struct Honest {
    handed_out: f64,
    along: f64,
}

impl Honest {
    fn of(rig: &Path) -> Self {
        let phases = ["", "--fault drift=300", "--fault drift=-2000", "--seed 2"];
        let felt = phases.map(|phase| {
            let (said, felt) = play(rig, "grand-springs", "20", phase);
            assert_eq!(said.code, Some(0), "{said:?}");
            felt.expect("a report")
        });
        let most = |name| felt.iter().map(|it| it.get(name)).fold(0.0, f64::max);
        Self { handed_out: most("handed_out_mj"), along: most("largest_along_n") }
    }
}

fn judge(rig: &Path, honest: &Honest, row: &Row) -> Vec<String> {
    let Row { fault, from, class, shows, beyond, code, words } = row;
    let (said, felt) = play(rig, "grand-springs", "20", &format!("--fault {fault} --from {from}"));
    let felt = felt.expect("a report");
    let (handed, force) = (felt.get("handed_out_mj"), felt.get("largest_force_n"));
    let (along, last) = (felt.get("largest_along_n"), felt.get("last_force_s"));
    let wrong = |is_wrong: bool, what: String| {
        is_wrong.then(|| format!("{fault} from {from} ({class:?}): {what}"))
    };
    let found = match class {
        AtArming => vec![wrong(MOST_PUSH < force, format!("{force} N"))],
        InSamples => vec![
            wrong(honest.handed_out + MORE_WORK + beyond < handed, format!("{handed} mJ")),
            wrong(honest.along + MORE_PUSH < along, format!("{along} N along the motion")),
        ],
        InRun => vec![
            wrong(MAX_FORCE < force, format!("{force} N")),
            wrong(shows + SILENCED < last, format!("a force {last} s after its beginning")),
        ],
        BeyondHost => Vec::new(),
    };
    let sentences = [
        wrong(said.code != Some(*code), format!("exit code {:?}", said.code)),
        wrong(!said.err.contains(words), format!("nobody said \"{words}\": {}", said.err)),
    ];
    found.into_iter().chain(sentences).flatten().collect()
}

#[test]
fn every_fault_of_a_board_stays_within_its_bounds_and_is_named() {
    let Some(rig) = build(&letoff::folder("fault-rig")) else { return };
    let honest = Honest::of(&rig);
    let wrong: Vec<_> = ROWS.iter().flat_map(|row| judge(&rig, &honest, row)).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Instruments that an honest board plays without shaking at 1 kHz. The others need a law on the
/// board and are softened or refused.
const STABLE: &str = "bouncing-ball cart-pendulum clavichord dashpot grand-map grand-reduced \
                      grand-springs hammond harpsichord mass organ paper-springs rhodes spring \
                      spring-wall synth upright viennese";

/// `LETOFF_HONEST_SECONDS=600` runs the long form, a quarter of an hour.
#[test]
fn an_honest_board_plays_every_instrument_that_is_stable_there_without_an_alarm() {
    let Some(rig) = build(&letoff::folder("honest-rig")) else { return };
    let seconds = std::env::var("LETOFF_HONEST_SECONDS").unwrap_or_else(|_unset| "13".into());
    for instrument in STABLE.split(' ') {
        let (said, _felt) = play(&rig, instrument, &seconds, "");
        assert_eq!(said.code, Some(0), "{instrument}: {said:?}");
        let board = &said.report()["boards"][0];
        assert_eq!(board["muted"], serde_json::json!([]), "{instrument}");
        assert_eq!(board["softened"], serde_json::json!([]), "{instrument}");
    }
}
