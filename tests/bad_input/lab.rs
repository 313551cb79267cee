//! Impossible studies, and reports that cannot be written.

use std::fs;

use crate::letoff::{check, check_words, folder, run};

const LITTLE: [&str; 7] = ["lab", "accuracy", "--quick", "--method", "rk4", "--scenario", "ball"];

#[test]
fn every_mistake_is_told_at_once() {
    let folder = folder("lab-mistakes");
    fs::write(folder.join("peers.json"), "{\"rows\": [{\"problem\": 1}]}").expect("a file");
    fs::write(folder.join("file"), "").expect("a file");
    let arguments = "lab accuracy --out file/report --scenario pendulm ball --method rk5 --peers \
                     peers.json";
    let arguments: Vec<_> = arguments.split_whitespace().collect();
    let said = run(&folder, &arguments);
    assert_eq!((said.code, said.lines().len()), (Some(2), 4), "{said:?}");
    check_words(&said, &["no scenario \"pendulm\": use \"pendulum\"", "no method \"rk5\""]);
    check_words(&said, &["peers.json: row 1: ", "cannot write file/report"]);
}

#[test]
fn a_study_without_a_place_for_its_report_is_wrong_usage() {
    let said = run(&folder("lab-nowhere"), &["lab", "accuracy", "--quick"]);
    assert_eq!(said.code, Some(2), "{said:?}");
    check_words(&said, &["--out <DIR>"]);
}

#[test]
fn other_codes_results_that_are_no_json_are_refused_before_anything_is_run() {
    let folder = folder("lab-peers");
    fs::write(folder.join("peers.json"), "ns,s").expect("a file");
    let arguments = [&LITTLE[..], &["--out", "report", "--peers", "peers.json"]].concat();
    check(&folder, &arguments, 2, &["peers.json: no JSON", "benches/peers"]);
    assert!(!folder.join("report/index.html").exists());
    let arguments = [&LITTLE[..], &["--json", "--peers", "nowhere.json"]].concat();
    check(&folder, &arguments, 2, &["nowhere.json: ", "No such file"]);
}

#[test]
fn a_study_is_in_its_folder_and_its_figures_on_stdout() {
    let folder = folder("lab");
    let said = run(&folder, &[&LITTLE[..], &["--out", "deep/report", "--json"]].concat());
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""), "{said:?}");
    let ball = &said.report()["scenarios"][0];
    assert_eq!((&ball["name"], &ball["failures"]), (&"ball".into(), &0.into()), "{ball}");
    for file in ["index.html", "accuracy.csv", "times.csv"] {
        assert!(folder.join("deep/report").join(file).is_file(), "no {file}");
    }
}
