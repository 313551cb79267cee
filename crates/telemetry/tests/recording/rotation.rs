//! A recording of several files, and its end.

use std::{fs, time::Duration};

use telemetry::Update;
use telemetry::recording::{
    RecordError, Recorder, Recording, RecordingLimits, RecordingSettings, recover,
};

use crate::common::{
    KEYS, at, catalogue, limited, performance, read, record, record_as, settings, small, unrecorded,
};

#[test]
fn a_recording_goes_on_in_another_file_and_is_read_as_one() {
    let (folder, path) = unrecorded();
    let told = performance(40_000);
    let recorded = record_as(small(&path), &told);
    assert!(4 < recorded.files.len(), "{:?}", recorded.files);
    assert_eq!(recorded.files[1], folder.path().join("take-0002.mcap"));
    for file in &recorded.files {
        let size = file.metadata().expect("the file").len();
        assert!(size <= RecordingLimits::LEAST_FILE, "{} has {size} bytes", file.display());
    }
    let recording = Recording::open(&path).expect("a recording");
    assert_eq!(recording.files().count(), recorded.files.len());
    assert_eq!(read(&recording), (told.clone(), vec![]));
    let third = Recording::open(&recorded.files[2]).expect("a recording");
    assert_eq!(third.catalogue().expect("read").map(Update::Catalogue), Some(catalogue()));
    let (from, to) = third.span().expect("messages");
    assert!(at(0) < from && to == at(40_000));
    assert_eq!(third.voices_at(from).expect("read").len(), KEYS.len());
    let (rest, wrong) = read(&third);
    assert_eq!((rest.len(), wrong), (told.len() - before(&told, from, rest.len()), vec![]));
}

/// Counts the messages before the last `rest`, of which the first four are repetitions.
fn before(told: &[(u64, Update)], from: u64, rest: usize) -> usize {
    let before = told.len() - (rest - 4);
    assert!(told[before].0 >= from);
    before - 4
}

#[test]
fn a_recording_that_became_too_large_keeps_its_last_files() {
    let (folder, path) = unrecorded();
    let most = 3 * RecordingLimits::LEAST_FILE;
    let settings = limited(&path, |limits| {
        (limits.largest_total, limits.largest_file) = (most, RecordingLimits::LEAST_FILE);
    });
    let recorded = record_as(settings, &performance(40_000));
    assert!(recorded.bytes <= most, "{} bytes", recorded.bytes);
    assert!(0 < recorded.removed && !path.exists());
    assert_eq!(fs::read_dir(folder.path()).expect("the folder").count(), recorded.files.len());
    let recording = Recording::open(&recorded.files[0]).expect("a recording");
    assert_eq!(recording.span().expect("messages").1, at(40_000));
    assert_eq!(recording.files().count(), recorded.files.len());
    assert!(recording.catalogue().expect("read").is_some());
}

#[test]
fn a_file_has_no_more_than_the_time_that_it_may() {
    let (_folder, path) = unrecorded();
    let told = performance(20_000);
    let settings = limited(&path, |limits| limits.longest_file = Some(Duration::from_secs(6)));
    let recorded = record_as(settings, &told);
    assert_eq!(recorded.files.len(), 4, "{:?}", recorded.files);
    for file in &recorded.files {
        let (from, to) = Recording::open_file(file).expect("a file").span().expect("messages");
        assert!(to - from < 6_000_000_000, "{} has {} ns", file.display(), to - from);
    }
    assert_eq!(read(&Recording::open(&path).expect("a recording")), (told, vec![]));
}

#[test]
fn a_file_that_is_missing_or_none_is_said_and_the_others_are_read() {
    let (folder, path) = unrecorded();
    record_as(small(&path), &performance(40_000));
    let third = folder.path().join("take-0003.mcap");
    let whole = read(&Recording::open(&path).expect("a recording")).0;
    let check = |expected: &str| {
        let recording = Recording::open(&path).expect("a recording");
        assert_eq!(recording.files().count(), 2);
        let (found, wrong) = read(&recording);
        assert_eq!((&found[..], wrong), (&whole[..found.len()], vec![]));
        let tear = recording.tear().expect("there is more").to_string();
        assert!(tear.contains(expected), "{tear}");
    };
    fs::write(&third, "something else").expect("a file");
    check("take-0003.mcap is no recording: it does not begin as an MCAP file does; what was");
    fs::remove_file(&third).expect("gone");
    check("the file before ");
}

#[test]
fn a_file_that_breaks_off_before_the_next_is_a_hole_also_once_it_is_recovered() {
    let (folder, path) = unrecorded();
    record_as(small(&path), &performance(40_000));
    let second = folder.path().join("take-0002.mcap");
    let whole = fs::read(&second).expect("a file");
    fs::write(&second, &whole[..whole.len() / 2]).expect("a file");
    let (found, wrong) = read(&Recording::open(&path).expect("a recording"));
    let [hole] = wrong.as_slice() else { panic!("{wrong:?}") };
    assert!(hole.contains("take-0002.mcap breaks off at byte "), "{hole}");
    let (_, when) = hole.split_once("what it had from ").expect("when");
    let made = folder.path().join("made.mcap");
    recover(&second, &made).expect("recovered");
    let alone = Recording::open(&made).expect("a recording");
    assert_eq!(read(&alone).1, [""; 0], "nothing comes behind it");
    fs::rename(&made, &second).expect("moved");
    let recording = Recording::open(&path).expect("a recording");
    assert_eq!(recording.tear(), None);
    let (still, wrong) = read(&recording);
    let [hole] = wrong.as_slice() else { panic!("{wrong:?}") };
    assert!(hole.contains("was recovered from take-0002.mcap, which breaks off"), "{hole}");
    let (when, _advice) = when.split_once(", and").expect("advice");
    assert!(hole.ends_with(when), "{hole}");
    assert_eq!(still.len(), found.len());
}

#[test]
fn files_of_other_runs_are_not_taken_for_this_one_s() {
    let (folder, path) = unrecorded();
    let told = performance(100);
    record(&path, &told);
    // Another recording whose own name looks like a second file's.
    record(&folder.path().join("take-0002.mcap"), &told);
    let recording = Recording::open(&path).expect("a recording");
    assert_eq!((recording.files().count(), recording.tear()), (1, None));
}

#[test]
fn nothing_is_overwritten() {
    let folder = tempfile::tempdir().expect("a folder");
    for (there, new) in [("take.mcap", "take.mcap"), ("slow-0002.mcap", "slow.mcap")] {
        let there = folder.path().join(there);
        fs::write(&there, "precious").expect("a file");
        let error = Recorder::create(settings(&folder.path().join(new))).expect_err("refused");
        assert!(matches!(error, RecordError::Exists(_)), "{error}");
        let expected = format!("{} is there already", there.display());
        assert!(error.to_string().starts_with(&expected), "{error}");
        assert_eq!(fs::read_to_string(&there).expect("the file"), "precious");
    }
    let nowhere = folder.path().join("no/such/folder.mcap");
    let error = Recorder::create(settings(&nowhere)).expect_err("refused").to_string();
    assert!(error.contains("folder.mcap cannot be made: No such file"), "{error}");
}

#[test]
fn a_recording_ends_before_the_disk_is_full() {
    let (_folder, path) = unrecorded();
    let settings = limited(&path, |limits| limits.lowest_free = u64::MAX);
    let error = Recorder::create(settings).expect_err("refused").to_string();
    assert!(error.starts_with(&format!("{} is not begun: only ", path.display())), "{error}");
    assert!(error.contains(" MiB are free there") && error.contains("--min-free"), "{error}");
    assert!(!path.exists());
}

#[test]
fn a_message_of_no_key_is_refused_and_the_recording_goes_on() {
    let (_folder, path) = unrecorded();
    let mut recorder = Recorder::create(settings(&path)).expect("a new file");
    let stray = telemetry::KeyBlock { key: 88, ..telemetry::KeyBlock::default() };
    let error = recorder.write(at(0), &Update::Block(stray)).expect_err("refused");
    assert!(error.to_string().starts_with("a message is of key 88,"), "{error}");
    recorder.write(at(1), &catalogue()).expect("written");
    assert_eq!(recorder.finish().expect("complete").messages, 1);
}

fn left_behind(path: &std::path::Path) -> usize {
    read(&Recording::open(path).expect("a recording")).0.len()
}

#[test]
fn nothing_waits_in_memory_for_longer_than_asked() {
    let (_folder, path) = unrecorded();
    let settings = RecordingSettings { flush: Duration::from_mins(1), ..settings(&path) };
    let mut recorder = Recorder::create(settings).expect("a new file");
    let told = performance(3000);
    for (index, (now, update)) in told.iter().enumerate() {
        recorder.write(*now, update).expect("written");
        if index % 500 == 0 {
            let second_ago = told.iter().filter(|(at, _)| at + 1_000_000_000 <= *now).count();
            assert!(second_ago <= left_behind(&path));
        }
    }
    recorder.attend(5_000_000_000).expect("attended");
    recorder.attend(6_000_000_000).expect("attended");
    assert_eq!(left_behind(&path), told.len());
}
