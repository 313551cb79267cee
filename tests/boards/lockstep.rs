//! The whole host in virtual time: the reference firmware and other programs in lockstep.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

use crate::letoff::{self, Said};
use crate::machine_time::say;
use crate::rig::count;

/// Builds the fault rig, keys C4 to D#4, by its README; skips without a C compiler.
pub(crate) fn build(folder: &Path) -> Option<PathBuf> {
    if Command::new("cc").arg("--version").output().is_err() {
        say("SKIPPED: the host in lockstep with the fault rig: cc is not installed");
        return None;
    }
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("firmware-protocol/c/rig");
    let readme = std::fs::read_to_string(source.join("README.md")).expect("the rig's README");
    let command = readme.split("```sh\n").nth(1).and_then(|it| it.split("```").next());
    let command = command.expect("the command").replace("-o rig", "-o \"$PROGRAM\"");
    let program = folder.join("rig");
    let mut shell = Command::new("sh");
    shell.args(["-e", "-c", &command]).env("PROGRAM", &program).current_dir(source);
    assert!(shell.status().expect("a shell").success(), "the rig cannot be built");
    Some(program)
}

/// Runs a scene that is stable on the rig in virtual time, while the pianist plays `piece`.
fn run(folder: &Path, piece: &str, links: &[&str]) -> Said {
    let run = ["run", "springs", "--virtual-time", "--duration", "3", "--json"];
    let run = run.into_iter().chain(["--performance", piece]);
    let links = links.iter().flat_map(|link| ["--link", link]);
    letoff::run(folder, &run.chain(links).collect::<Vec<_>>())
}

fn report(said: &Said) -> Value {
    let mut report = said.report();
    report["started"].take();
    report
}

#[test]
fn a_host_in_lockstep_with_an_honest_board_gives_the_same_bits_every_time() {
    let folder = letoff::folder("lockstep");
    let Some(program) = build(&folder) else { return };
    let told = folder.join("rig.json");
    let link = format!("rig:{} --lockstep --report {}", program.display(), told.display());
    let outcomes = [(); 2].map(|()| {
        let _none = std::fs::remove_file(&told);
        let said = run(&folder, "none", &[&link]);
        assert_eq!(said.code, Some(0), "{said:?}");
        // The rig must have exited in order, or its last report would not be the final one.
        (said, std::fs::read_to_string(&told).expect("what the rig tells"))
    });
    let [(one, rig), (other, again)] = outcomes;
    let report = report(&one);
    assert_eq!((&report, &one.err, rig), (&self::report(&other), &other.err, again));
    assert_eq!(report["boards"][0]["state"], "armed", "{report}");
    // The samples of the final ramp, in which all forces fade, count as well.
    let hz = report["boards"][0]["samples_hz"].as_f64().expect("a rate");
    assert!((1_000.0..1_030.0).contains(&hz), "{report}");
    let troubles = ["/faults", "/links/gaps", "/links/refused", "/links/rearmed"];
    assert_eq!(troubles.map(|it| count(&report, it)), [0; 4], "{report}");
    assert!(0 < count(&report, "/strikes"), "the finger of the rig plays: {report}");
    assert!(one.err.contains("C4 to D#4: armed"), "{one:?}");
}

#[test]
fn the_pianist_plays_a_board_in_lockstep() {
    let folder = letoff::folder("lockstep-pianist");
    let Some(program) = build(&folder) else { return };
    let link = format!("rig:{} --lockstep --finger none", program.display());
    let report = report(&run(&folder, "bach-bwv-846", &[&link]));
    let [played, struck] = ["/notes/played", "/notes/struck"].map(|it| count(&report, it));
    assert!(0 < played && played == struck, "{report}");
}

#[test]
fn a_program_that_is_no_rig_is_named_with_what_it_did() {
    let folder = letoff::folder("lockstep-refused");
    let check = |link, words: &[&str]| {
        let said = run(&folder, "none", &[link]);
        assert_eq!(said.code, Some(1), "{said:?}");
        letoff::check_words(&said, words);
    };
    check("rig:/no/such/rig --lockstep", &["`/no/such/rig --lockstep`", "cannot be started"]);
    check("rig:false", &["`false`", "it ended (exit status: 1)"]);
}

#[test]
fn boards_and_the_run_live_by_the_same_time() {
    let folder = letoff::folder("lockstep-time");
    let said = run(&folder, "none", &["rig:true", "serial:/dev/null"]);
    assert_eq!(said.code, Some(2), "{said:?}");
    letoff::check_words(&said, &["boards go by their own time", "rig: links"]);
    let words = ["rig:true lives in virtual time only", "--virtual-time"];
    letoff::check(&folder, &["run", "--link", "rig:true"], 2, &words);
}
