//! A short study, from the choice to the files.

#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, UNIX_EPOCH};

use lab::accuracy::{
    Effort, METHODS, MeasuredScenario, SequenceVerdict, StudyChoice, StudyRow, measure,
    measure_drifts,
};
use lab::part::StudyPart;
use lab::report::{self, Machine, StoredRuns, StudyReport, read_peers};
use mechanism::Library;
use pode::{Limits, Motion, Silent, Simulator, Work, stepper::Rk4};

const COUNTED: Effort = Effort { repeats: 1, budget: Duration::ZERO, is_quick: false };

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

fn study(scenarios: &[&str], methods: &[&str], effort: Effort) -> Vec<MeasuredScenario> {
    let choice = StudyChoice::new(&names(scenarios), &names(methods), effort).expect("known names");
    let runs = AtomicUsize::new(0);
    let count = |_: &StudyRow| _ = runs.fetch_add(1, Ordering::Relaxed);
    let mut measured = Vec::new();
    for entry in &choice.scenarios {
        measured.push(measure(entry, &choice, &count).expect("a reference"));
    }
    assert_eq!(runs.into_inner(), choice.count(), "each run is told of once");
    measured
}

/// Returns the run of `method` with ticks of `tick` (s).
#[track_caller]
fn run<'a>(measured: &'a MeasuredScenario, method: &str, tick: f64) -> &'a StudyRow {
    let is_it =
        |row: &&StudyRow| row.method.name == method && (row.setting.tick - tick).abs() < 1e-12;
    measured.rows.iter().find(is_it).expect("the run")
}

#[test]
fn errors_fall_with_the_order_of_the_method() {
    /// A quarter of the step: four to the power of the order. The next term of the error is
    /// below a tenth of the first at 1 ms, where ωh is 0.03.
    const METHODS: [(&str, f64); 4] =
        [("semi-implicit-euler", 1.0), ("heun", 2.0), ("bogacki-shampine", 3.0), ("rk4", 4.0)];
    let measured = study(&["figure-6"], &METHODS.map(|(name, _)| name), COUNTED);
    for (method, order) in METHODS {
        let [coarse, fine] = [1e-3, 2.5e-4].map(|tick| &run(&measured[0], method, tick).verdict);
        let check = |what: &str, coarse: Option<f64>, fine: Option<f64>| {
            let observed = (coarse.expect("an error") / fine.expect("an error")).log2() / 2.0;
            assert!((observed - order).abs() < 0.15, "{what} of {method}: order {observed:.2}");
        };
        check("event times", coarse.event_error, fine.event_error);
        check("states", coarse.state_error, fine.state_error);
        check("force", coarse.force_error, fine.force_error);
    }
}

#[test]
fn counts_are_those_that_pode_reports() {
    let measured = study(&["ball"], &["rk4"], COUNTED);
    let row = run(&measured[0], "rk4", 5e-3);
    let ball = Library::default().find("bouncing-ball", "".as_ref()).expect("the ball");
    let ball = ball.small().expect("a small model").with_values(&[9.81, 0.8, 1.0, 1.0, 1.0]);
    let (flight, state) = ball.at_rest(&Motion::default());
    let mut simulator = Simulator::new(ball, Rk4, Limits::default(), flight, state);
    let still = |_: f64| Motion::default();
    let ticks: Vec<Work> =
        (0..720).map(|_| simulator.advance(5e-3, &still, &mut Silent).work).collect();
    let sum = ticks.iter().fold(Work::default(), |sum, work| sum.plus(*work));
    let worst = |count: fn(&Work) -> u32| ticks.iter().map(count).max().expect("ticks");
    let counts = row.counts;
    let is_per_ms = |found: f64, sum: u32| (found * 3600.0 - f64::from(sum)).abs() < 1e-6;
    assert!(is_per_ms(counts.derivatives_per_ms, sum.derivatives), "{counts:?}, {sum:?}");
    assert!(is_per_ms(counts.evaluations_per_ms, sum.derivatives), "{counts:?}, {sum:?}");
    assert!(is_per_ms(counts.guards_per_ms, sum.guards), "{counts:?}, {sum:?}");
    assert!(is_per_ms(counts.readouts_per_ms, sum.readouts), "{counts:?}, {sum:?}");
    assert_eq!(counts.worst_derivatives, worst(|work| work.derivatives));
    assert_eq!(counts.worst_guards, worst(|work| work.guards));
    let steps = [counts.steps_certain, counts.steps_unknown];
    assert_eq!(steps, [sum.certain, sum.unknown].map(u64::from));
    assert_eq!(row.verdict.events, 10);
}

#[test]
fn the_step_that_is_studied_is_the_step_that_is_taken() {
    let measured = study(&["head-1e3"], &["rk4", "as-played"], COUNTED);
    let derivatives = |method| run(&measured[0], method, 1e-3).counts.derivatives_per_ms;
    // 1000 ticks of one step of 4 derivatives, and one step more for each of some 15 events.
    assert!((4.0..4.1).contains(&derivatives("rk4")), "{}", derivatives("rk4"));
    // The model cuts its contacts, five of 10 ms, into steps of 0.05 rad at 316 rad/s.
    assert!(derivatives("as-played") > 5.0, "{}", derivatives("as-played"));
}

#[test]
fn every_method_finds_the_events_of_the_pendulum_with_a_fine_step() {
    let measured = study(&["pendulum"], &[], COUNTED);
    for method in METHODS.iter() {
        let last = measured[0].rows.iter().rfind(|row| row.method.name == method.name);
        let verdict = &last.expect("a run").verdict;
        assert_eq!(verdict.sequence, SequenceVerdict::Right, "{}", method.name);
        // At 50 µs a method of order 1 errs by some 1e-4 of 10 s.
        assert!(verdict.event_error.expect("an error") < 1e-2, "{}: {verdict:?}", method.name);
    }
}

/// 100 times the difference of two methods, a part of it for each model's sensitivity.
#[test]
fn two_methods_agree_on_the_references_of_all_shipped_models() {
    let names = lab::scenario::SCENARIOS.iter().map(|entry| entry.name);
    let strokes: Vec<_> =
        names.filter(|it| it.ends_with("-soft") || it.ends_with("-forte")).collect();
    assert_eq!(strokes.len(), 24);
    for measured in study(&strokes, &["as-played"], Effort::QUICK) {
        let [events, states] = measured.rows[0].verdict.least_errors;
        let name = measured.entry.name;
        assert!(events < 1e-8 && states < 1e-5, "{name}: {events:e} s, {states:e}");
        assert!(states > 0.0, "{name}: compared");
    }
}

#[test]
fn joined_shares_are_the_whole_study_to_the_last_bit() {
    let scenarios = names(&["figure-6", "upright-forte", "long-run"]);
    let whole = StudyChoice::new(&scenarios, &names(&["heun", "rk4", "exact"]), Effort::QUICK);
    let whole = whole.expect("names");
    let run = |choice: &StudyChoice, name: &str| {
        let machine = Machine::this();
        let measure = |entry: &&_| measure(entry, choice, &|_row| ()).expect("a reference");
        let measured = choice.scenarios.iter().map(measure).collect();
        let drifts = measure_drifts(choice, &|_run| ()).expect("the bouncing head");
        let folder = folder(&format!("joined-{name}"));
        let report = StudyReport { measured, drifts, ..StudyReport::new(machine) };
        report.write(choice, &folder).expect("files");
        folder
    };
    let at_once = run(&whole, "at-once");
    let part = |index| StudyChoice { part: StudyPart { index, of: 3 }, ..whole.clone() };
    let parts = [1, 2, 3].map(|index| run(&part(index), &index.to_string()));
    let stored = StoredRuns::read(&parts[..2]).expect("files").expect("runs");
    let missing = stored.into_report(&whole).expect_err("a share is missing");
    assert!(missing[0].ends_with("join each share once"), "{missing:?}");
    let joined = StoredRuns::read(&parts)
        .expect("files")
        .expect("runs")
        .into_report(&whole)
        .expect("all runs");
    let folder = folder("joined");
    joined.write(&whole, &folder).expect("files");
    for file in ["accuracy.csv", "orders.csv", "long-run.svg", "upright-forte-counts.svg"] {
        assert_eq!(read(&folder, file), read(&at_once, file), "{file}");
    }
    let last = |method: &str| {
        let drift = joined.drifts.iter().find(|it| it.method.name == method).expect("its run");
        *drift.points.last().expect("points")
    };
    // A step of a contact spans ωh = 0.32 rad: RK4 loses (ωh)⁶/72 of the energy, the exact flow none.
    assert!(last("rk4").0 > 170.0 && (1e-2..1.0).contains(&last("rk4").1), "{:?}", last("rk4"));
    assert!(last("exact").1 < 1e-12, "{:?}", last("exact"));
}

#[test]
fn the_picture_of_the_readme_is_the_one_that_a_quick_study_draws() {
    let (folder, _) = written("readme", study(&["grand-forte"], &[], Effort::QUICK), Vec::new());
    let shown = concat!(env!("CARGO_MANIFEST_DIR"), "/../pode/grand-forte.svg");
    let shown = fs::read_to_string(shown).expect("the committed picture");
    let texts = |svg: &str| -> Vec<String> {
        let texts = svg.split("<text").skip(1).filter_map(|text| text.split_once("</text>"));
        texts.map(|(text, _)| text.rsplit('>').next().unwrap_or_default().to_owned()).collect()
    };
    assert_eq!(texts(&shown), texts(&read(&folder, "grand-forte-counts.svg")));
}

#[test]
fn a_wrong_sequence_is_marked_and_has_no_error() {
    // 32 radians of the contact in a step of 1 ms.
    let report = written("wrong", study(&["head-1e7"], &["heun"], COUNTED), Vec::new());
    let row = run(&report.1.measured[0], "heun", 1e-3);
    assert_ne!(row.verdict.sequence, SequenceVerdict::Right);
    assert_eq!(row.verdict.event_error, None);
    assert!(row.times.per_ms > 0.0, "it has a cost all the same");
    let table = read(&report.0, "accuracy.csv");
    let line = table.lines().find(|line| line.contains("heun,2,tick,0.001,")).expect("its row");
    assert!(line.contains(",wrong,") || line.contains(",failed,"), "{line}");
    assert!(read(&report.0, "index.html").contains("<td class=\"wrong\""));
}

#[test]
fn a_quick_study_of_two_scenarios_writes_a_table_plots_and_a_page() {
    let measured = study(&["pendulum", "figure-6"], &["heun", "rk4", "as-played"], Effort::QUICK);
    let runs: usize = measured.iter().map(|it| it.rows.len()).sum();
    // Every second of seven steps, and at most 20,000 ticks.
    assert_eq!(runs, 3 * (2 + 3));
    let (folder, _) = written("quick", measured, Vec::new());
    assert_eq!(read(&folder, "accuracy.csv").lines().count(), runs + 1);
    let page = read(&folder, "index.html");
    for name in ["pendulum", "figure-6"] {
        let svg = read(&folder, &format!("{name}.svg"));
        balanced(&svg);
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "every place is a number");
        assert!(svg.contains("as-played") && svg.contains("error of event times [s]"));
        assert!(page.contains(&svg), "the page has the plot of {name}");
    }
    for word in ["How to read this", "1970-01-02 00:00 UTC", "a test's machine", "All 6 runs"] {
        assert!(page.contains(word), "no {word:?}");
    }
    assert!(!page.contains("src=") && !page.contains("href="), "it needs no other file");
    let files = fs::read_dir(&folder).expect("the folder").count();
    assert_eq!(files, 9, "nothing half written is left");
}

#[test]
fn other_codes_are_drawn_into_the_plot_of_the_same_problem() {
    const ROWS: &str = r#"[
        {"problem": "ball", "code": "made-up <b>", "version": "1", "method": "m", "setting": "s",
         "tolerance_or_step": 1e-6, "events": 10, "sequence_ok": true, "event_error_s": 1e-7,
         "state_error": 1e-6, "rhs": 700, "ns_per_ms_min": 40.0, "ns_per_ms_median": 50.0,
         "note": "slow"},
        {"problem": "ball", "code": "made-up <b>", "version": "1", "method": "m", "setting": "s",
         "tolerance_or_step": 1e-3, "events": 9, "sequence_ok": false, "event_error_s": null,
         "state_error": null, "rhs": null, "ns_per_ms_min": null, "ns_per_ms_median": null}]"#;
    let file = folder("peers").join("results.json");
    fs::write(&file, ROWS).expect("a file");
    let peers = read_peers(&file).expect("rows");
    let measured = study(&["ball", "ball-rest-0.5"], &["rk4"], Effort::QUICK);
    let (folder, report) = written("peers", measured, peers);
    let name = "made-up &lt;b&gt; m (s)";
    let svg = read(&folder, "ball-peers.svg");
    balanced(&svg);
    assert!(svg.contains(name) && svg.contains("side by side"));
    assert!(!folder.join("ball-rest-0.5-peers.svg").exists());
    let page = read(&folder, "index.html");
    assert!(page.contains(&svg), "the page has it too");
    assert!(page.contains("All 2 runs of other codes") && page.contains("wrong events"));
    assert!(!page.contains("made-up <b>"), "names are text");
    let summary = serde_json::to_value(report.summary()).expect("JSON");
    let cheapest = &summary["scenarios"][0]["side_by_side"][1];
    assert_eq!(cheapest.as_array().map(Vec::len), Some(1), "only within 1e-6 s: {cheapest}");
    assert_eq!(cheapest[0]["ns_per_ms"], 40.0);
}

#[test]
fn what_cannot_be_written_is_said_with_its_place() {
    let file = folder("no-folder").join("file");
    fs::write(&file, "").expect("a file");
    let said = report::prepare(&file.join("report")).expect_err("no folder").to_string();
    assert!(said.starts_with("cannot write ") && said.contains("report"), "{said}");
}

fn written(
    test: &str,
    measured: Vec<MeasuredScenario>,
    peers: Vec<report::Peer>,
) -> (PathBuf, StudyReport) {
    let folder = folder(test).join("report");
    report::prepare(&folder).expect("a folder");
    let machine = Machine {
        processor: "a test's machine".to_owned(),
        processors: 1,
        system: String::new(),
        program: String::new(),
    };
    let date = UNIX_EPOCH + Duration::from_hours(24);
    let report = StudyReport { date, measured, peers, ..StudyReport::new(machine) };
    let choice = StudyChoice::new(&[], &[], COUNTED).expect("all");
    report.write(&choice, &folder).expect("files");
    (folder, report)
}

fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("lab").join(test);
    let _none = fs::remove_dir_all(folder.join("report"));
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn read(folder: &Path, file: &str) -> String {
    fs::read_to_string(folder.join(file)).expect("a file")
}

#[track_caller]
fn balanced(svg: &str) {
    let mut open = Vec::new();
    for tag in svg.split('<').skip(1) {
        let (tag, _) = tag.split_once('>').expect("a closed tag");
        let name = tag.split_whitespace().next().expect("a name");
        match name.strip_prefix('/') {
            Some(name) => assert_eq!(open.pop(), Some(name)),
            None if tag.ends_with('/') => {}
            None => open.push(name),
        }
    }
    assert!(open.is_empty() && svg.starts_with("<svg "), "{open:?}");
}
