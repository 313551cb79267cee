use std::time::Duration;

use telemetry::Update;
use telemetry::recording::{BlackBox, Recording};

use crate::common::{KEYS, at, catalogue, performance, read, voice};

#[test]
fn a_dump_has_the_last_seconds_and_what_they_need() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fault.mcap");
    let mut told = performance(10_000);
    told.insert(told.len() / 4, (at(2500), voice(39, 99, "wall", "brick")));
    let mut black_box = BlackBox::new(Duration::from_secs(2), 1 << 30);
    for (at, update) in &told {
        black_box.keep(*at, update).expect("kept");
    }
    let size = black_box.dump(&path, "the run").expect("written");
    assert_eq!(size, path.metadata().expect("the file").len());
    let recording = Recording::open(&path).expect("a recording");
    assert_eq!(recording.tear(), None);
    let (found, _) = read(&recording);
    let said_again = 1 + KEYS.len();
    let last: Vec<_> = told.iter().filter(|(when, _)| at(8000) <= *when).cloned().collect();
    assert_eq!(found[said_again..], last[..]);
    assert_eq!(found[0].1, catalogue());
    let voices = recording.voices_at(at(10_000)).expect("read");
    let instruments = voices.iter().map(|(at, voice)| (*at, voice.instrument.as_str()));
    let expected = [(at(0), "grand"), (at(2500), "brick"), (at(0), "grand")];
    assert_eq!(instruments.collect::<Vec<_>>(), expected);
    assert!(black_box.dump(&path, "the run").is_err(), "nothing is overwritten");
}

#[test]
fn it_never_holds_more_than_it_may() {
    let most = 300_000;
    let mut black_box = BlackBox::new(Duration::from_hours(1), most);
    for (at, update) in performance(20_000) {
        black_box.keep(at, &update).expect("kept");
        assert!(black_box.bytes() <= most);
    }
    assert!(most / 2 < black_box.bytes());
    let stray = telemetry::KeyState::default();
    assert!(black_box.keep(0, &Update::State(200, stray)).is_err());
}
