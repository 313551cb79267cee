//! `letoff lab figure6`: the paper's experiment as a user runs it.

use std::fs;
use std::path::Path;

use haptics::HandCommand;
use scheduler::port::{FinishedTick, TickObserver};

use crate::letoff::{check_words, folder, run};
use crate::stage::{self, Stage, key, keybed};

const SHOWN: &str = "crates/lab/src/figure6/figure6.svg";

fn committed(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect("a file of ours")
}

fn texts(svg: &str) -> Vec<&str> {
    let rests = svg.split("<text").skip(1).filter_map(|it| it.split_once('>'));
    rests.filter_map(|(_, rest)| rest.split_once('<')).map(|(text, _)| text.trim()).collect()
}

#[test]
fn the_experiment_writes_its_report_and_the_figure_that_the_readme_shows() {
    let folder = folder("figure6");
    let said = run(&folder, &["lab", "figure6", "--out", "out", "--json"]);
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""), "{said:?}");
    let report = said.report();
    let event = |index: usize| &report["readings"][0]["events"][index];
    assert_eq!(event(3)["guard"], "string", "{report}");
    assert!((event(4)["paper"].as_f64().expect("a time") - 1.5).abs() < 0.04, "{report}");
    let file = |name: &str| fs::read_to_string(folder.join("out").join(name)).expect("a file");
    assert_eq!(file("figure6.csv").lines().count(), 1502);
    assert_eq!(file("errors.csv").lines().count(), 6);
    assert!(file("events.csv").contains("figure6-real-time,string,B2,B2,"));
    assert!(
        file("errors.csv").contains(",true,12,") && file("event-errors.svg").contains("<circle")
    );
    assert!(file("figure6-real-time.svg").contains("each in 2 ms"));
    assert!(file("figure6-beside.svg").contains("same samples, located"));
    let json: serde_json::Value = serde_json::from_str(&file("figure6.json")).expect("JSON");
    let mut own = report.clone();
    let fields = own.as_object_mut().expect("a report");
    for field in ["format", "version", "started"] {
        assert!(fields.remove(field).is_some(), "a header has {field}");
    }
    assert_eq!(json, own);
    let readme = committed("crates/lab/README.md");
    for (reading, name) in ["2 ms in 7 ms", "2 ms in 2 ms"].into_iter().enumerate() {
        let time = |index: usize| report["readings"][reading]["events"][index]["paper"].as_f64();
        let times: Vec<_> = (0..5).filter_map(time).map(|t| format!(" {t:.3} s |")).collect();
        let row = format!("| {name} |{}", times.concat());
        assert!(readme.contains(&row), "{row}");
    }
    let shown = committed(SHOWN);
    assert_eq!(texts(&shown), texts(&file("figure6.svg")));
}

#[test]
fn another_pace_has_its_servo_and_what_is_wrong_is_told_in_a_sentence() {
    let folder = folder("figure6-wrong");
    let said = run(&folder, &["lab", "figure6", "--time-scale", "0.5", "--json"]);
    assert_eq!(said.report()["readings"][0]["servo"], 4e-3, "{said:?}");
    let said = run(&folder, &["lab", "figure6", "--time-scale", "3", "--out", "out"]);
    assert_eq!((said.code, said.lines().len()), (Some(2), 1), "{said:?}");
    check_words(&said, &["--time-scale 3 is not from 0.1 to 1"]);
    assert!(!folder.join("out").exists());
    fs::write(folder.join("file"), "").expect("a file");
    let said = run(&folder, &["lab", "figure6", "--out", "file/in"]);
    assert_eq!((said.code, said.lines().len()), (Some(2), 1), "{said:?}");
    check_words(&said, &["cannot write file/in", "choose another --out"]);
}

/// Holds middle C at each depth (fraction of its dip, 0.1 s); counts events and strikes after each.
fn thrown<const N: usize>(scene: &str, depths: [(f64, u32); N]) -> [(u32, usize); N] {
    let scene = stage::scene(scene, &[]);
    let mut stage = Stage::new(&scene, keybed(&scene)).watched_by(Hammer::default());
    depths.map(|(depth, tenths)| {
        stage.bus.press(key(MIDDLE_C), HandCommand::Grip(depth));
        for _ in 0..scene.tick_hz * tenths / 10 {
            stage.tick();
        }
        let Hammer { events, strikes } = std::mem::take(&mut stage.observer);
        (events, strikes)
    })
}

const MIDDLE_C: usize = 39;

#[derive(Debug, Default)]
struct Hammer {
    events: u32,
    strikes: usize,
}

impl TickObserver for Hammer {
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        let turn = &seen.turns[MIDDLE_C];
        self.events += turn.work.events;
        self.strikes += turn.events.strikes();
    }
}

#[test]
fn a_hand_throws_and_catches_the_hammer_on_the_paper_s_rig_and_on_a_key() {
    for scene in ["paper-rig", "springs"] {
        let way = [(0.0, 3), (0.4, 3), (0.0, 6), (1.0, 5)];
        let [held, soft, _back, hard] = thrown(scene, way);
        assert_eq!(held, (0, 0), "{scene}: held still");
        assert!(0 < soft.0 && soft.1 == 0, "{scene}: thrown and caught, {soft:?}");
        assert!(0 < hard.1, "{scene}: thrown against the string, {hard:?}");
    }
}
