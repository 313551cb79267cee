//! `letoff lab stability`: maps of stable walls and instruments, in files and as JSON.

use std::path::Path;

use serde_json::Value;

use crate::letoff::{check, check_words, folder, run};

const FEW: [&str; 4] = ["lab", "stability", "--cells", "8"];

fn report(folder: &Path, arguments: &[&str]) -> Value {
    let said = run(folder, &[&FEW[..], arguments, &["--json"]].concat());
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""), "{said:?}");
    said.report()
}

#[test]
fn the_boundary_of_a_wall_is_that_of_its_poles_and_of_passivity_where_the_load_is_the_worst() {
    let folder = folder("stability-wall");
    // A key that diverges within a fiftieth of a period: 20 mg with 1 N s/m at 1 ms.
    let worst = ["--mass", "20 mg", "--device-damping", "1 N*s/m", "--period", "1 ms"];
    let axes = ["--x", "stiffness=200..1800", "--y", "damping=0.01..2", "--out", "out"];
    let report = report(&folder, &[&worst[..], &axes[..]].concat());
    let ratios = &report["maps"][0]["ratios"];
    for theory in ["colgate_schenkel", "poles"] {
        let ratio = |which: &str| ratios[theory][which].as_f64().expect("a ratio");
        // Within 10 % of the stiffness; for the rest, B at 1.7 kN/m, the limit is wider.
        assert!((ratio("median") - 1.0).abs() < 0.1, "{theory}: {ratios}");
    }
    assert_eq!(report["maps"][0]["boundary"].as_array().expect("rows").len(), 8);
    assert_eq!(report["settings"]["period"], 1e-3);
    for file in ["index.html", "map.csv", "boundary.csv", "backward-difference.svg"] {
        assert!(folder.join("out").join(file).is_file(), "no {file}");
    }
}

#[test]
fn a_delay_makes_the_stable_region_smaller_and_a_finger_larger() {
    let folder = folder("stability-axes");
    let rests = |arguments: &[&str]| {
        let report = report(&folder, arguments);
        report["maps"][0]["cells"]["rests"].as_u64().expect("a count")
    };
    let [prompt, late] = ["0", "2 ms"].map(|delay| rests(&["--delay", delay]));
    assert!(late < prompt, "{late} and {prompt} cells");
    let report = report(
        &folder,
        &["--x", "period", "--y", "finger", "--stiffness", "5 kN/m", "--damping", "2"],
    );
    assert_eq!(report["x"]["name"], "finger");
    let longest = |column: usize| {
        let measured = &report["maps"][0]["boundary"][column]["measured"];
        measured[0].as_f64().expect("a boundary")
    };
    assert!(longest(0) < longest(2), "a finger's damping helps: {report}");
}

#[test]
fn model_b_is_stable_with_soft_springs_and_not_with_stiff_ones() {
    let folder = folder("stability-springs");
    let what = ["--what", "key-hammer-springs", "--x", "k1=30..5000", "--y", "k2=5e3..5e4"];
    let report = report(&folder, &[&what[..], &["--out", "out"]].concat());
    assert_eq!(report["name"], "grand-springs on C4");
    for map in report["maps"].as_array().expect("maps") {
        let count = |what: &str| map["cells"][what].as_u64().expect("a count");
        assert!(count("rests") >= 24 && count("rests") < 64, "{}", map["cells"]);
    }
    for file in ["backward-difference.svg", "kalman.svg"] {
        assert!(folder.join("out").join(file).is_file(), "no {file}");
    }
}

#[test]
fn a_map_without_a_stable_cell_says_so_and_is_written_all_the_same() {
    let folder = folder("stability-none");
    let axes = ["--x", "stiffness=200e3..500e3", "--y", "damping=300..900", "--out", "out"];
    let said = run(&folder, &[&FEW[..], &axes[..]].concat());
    assert_eq!(said.code, Some(1), "{said:?}");
    check_words(&said, &["wall comes to rest nowhere in the map of backward-difference"]);
    assert!(folder.join("out/index.html").is_file(), "no page");
}

#[test]
fn what_cannot_be_studied_is_said_in_one_sentence() {
    let folder = folder("stability-mistakes");
    for (arguments, words) in [
        (&["--period", "-1 ms"][..], &["--period -0.001 is not from", "to 0.02 s"][..]),
        (&["--period", "1 N"], &["--period \"1 N\" is no number of s"]),
        (&["--x", "stifness"], &["there is no axis \"stifness\": use \"stiffness\""]),
        (&["--x", "period=2 ms..1 ms"], &["period goes from 0.002 to 0.001 s", "no range"]),
        (&["--x", "damping"], &["--x and --y are both damping"]),
        (&["--delay", "20 ms"], &["longer than 16 periods of 0.001 s"]),
        (&["--finger", "thumb"], &["--finger \"thumb\" is none"]),
        (&["--estimator", "kalmann"], &["--estimator \"kalmann\" is none: use \"kalman\""]),
        (&["--what", "grnd"], &["grnd"]),
        (&["--what", "grand-springs", "--damping", "-5"], &["a coupling's damping is -5 N·s/m"]),
        (&["--what", "grand-springs", "--set", "k9=1"], &["there is no parameter \"k9\""]),
        (&["--what", "grand-springs", "--key", "H4"], &["--key \"H4\" is no key"]),
    ] {
        let arguments = [&FEW[..], arguments, &["--json"]].concat();
        check(&folder, &arguments, 2, words);
    }
}
