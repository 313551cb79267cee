use std::sync::atomic::{AtomicU64, Ordering};
use std::{collections::BTreeSet, path::Path, sync::Arc, thread};

use telemetry::event::Kind;
use telemetry::recording::{Playback, Recording, marks};
use telemetry::{
    Arrival, ConnectionState, Event, KEYS, KeyBlock, Request, Source as _, Timeline, Topic, Update,
};

use crate::common::{at, event, performance, record, recorded, unrecorded};

fn played(path: &Path) -> (Playback, Arc<AtomicU64>) {
    let millis = Arc::new(AtomicU64::new(0));
    let clock = Arc::clone(&millis);
    let seconds = move || clock.load(Ordering::Relaxed) as f64 / 1e3;
    let recording = Recording::open(path).expect("a recording");
    (Playback::new(recording, Box::new(seconds)), millis)
}

fn come(playback: &mut Playback) -> Vec<Option<(u64, Topic)>> {
    let mut come = Vec::new();
    while let Some(arrival) = playback.next() {
        come.push(match arrival {
            Arrival::Update { at, update } => update.topic().map(|topic| (at, topic)),
            Arrival::Anew | Arrival::Reply { .. } => None,
        });
    }
    come
}

fn ticks(come: &[Option<(u64, Topic)>], topic: Topic) -> Vec<u64> {
    let times = come.iter().flatten().filter(|(_, it)| *it == topic);
    times.map(|(when, _)| (when - at(0)) / 1_000_000).collect()
}

#[test]
fn it_begins_with_catalogue_and_voices_and_goes_on_by_the_clock() {
    let (_folder, path) = recorded(&performance(10_000));
    let (mut playback, clock) = played(&path);
    playback.follow(&BTreeSet::from([Topic::Block(39)]));
    let first = come(&mut playback);
    assert_eq!(first[0], None);
    assert_eq!(first[1], Some((at(0), Topic::Catalogue)));
    assert_eq!(ticks(&first, Topic::Voices).len() / 2 * 2, ticks(&first, Topic::Voices).len());
    assert_eq!(ticks(&first, Topic::Block(39)), [0; 0]);
    clock.store(50, Ordering::Relaxed);
    assert_eq!(ticks(&come(&mut playback), Topic::Block(39)), [20, 40]);
    playback.set_speed(2.0);
    clock.store(60, Ordering::Relaxed);
    assert_eq!(ticks(&come(&mut playback), Topic::Block(39)), [60]);
    assert_eq!(playback.at(), at(70));
    playback.set_speed(0.0);
    clock.store(10_000, Ordering::Relaxed);
    assert_eq!((come(&mut playback).len(), playback.at()), (0, at(70)));
    playback.set_speed(f64::NAN);
    assert!(playback.speed().abs() < f64::EPSILON);
    playback.set_speed(1e300);
    clock.store(10_001, Ordering::Relaxed);
    assert_eq!(playback.at(), at(10_000));
    assert_eq!(ticks(&come(&mut playback), Topic::Block(39)).last(), Some(&10_000));
    assert_eq!(Timeline::span(&playback), (at(0), at(10_000)));
}

#[test]
fn a_repeating_playback_begins_again_at_its_end() {
    let (_folder, path) = recorded(&performance(1_000));
    let (playback, clock) = played(&path);
    let mut playback = playback.repeating();
    playback.follow(&BTreeSet::from([Topic::Block(39)]));
    come(&mut playback);
    let (_, end) = playback.span();
    clock.store((end - at(0)) / 1_000_000 + 1, Ordering::Relaxed);
    let second = come(&mut playback);
    let anew = second.iter().position(Option::is_none).expect("it begins again");
    assert_eq!(second[anew + 1], Some((at(0), Topic::Catalogue)));
    assert_eq!(playback.at(), at(0));
    playback.set_speed(0.0);
    playback.seek(end);
    come(&mut playback);
    assert_eq!(playback.at(), end);
}

#[test]
fn another_place_begins_with_the_seconds_before_it() {
    let (_folder, path) = recorded(&performance(20_000));
    let (mut playback, clock) = played(&path);
    playback.set_speed(0.0);
    playback.follow(&BTreeSet::from([Topic::Block(39)]));
    come(&mut playback);
    for place in [12_000_u64, 8000] {
        playback.seek(at(place));
        let come = come(&mut playback);
        assert_eq!((come[0], come[1]), (None, Some((at(0), Topic::Catalogue))));
        assert_eq!(ticks(&come, Topic::Voices), [0; 3]);
        // The last rows before them come, too: a key may have rested since.
        let expected: Vec<_> = (place - 5020..=place).step_by(20).collect();
        assert_eq!(ticks(&come, Topic::Block(39)), expected);
    }
    playback.seek(0);
    assert_eq!(playback.at(), at(0));
    playback.seek(u64::MAX);
    assert_eq!(playback.at(), at(20_000));
    drop(clock);
}

#[test]
fn a_topic_that_is_followed_anew_begins_with_its_last_seconds_and_misses_nothing() {
    let (_folder, path) = recorded(&performance(12_000));
    let (mut playback, clock) = played(&path);
    playback.follow(&BTreeSet::from([Topic::Block(39)]));
    clock.store(7010, Ordering::Relaxed);
    come(&mut playback);
    playback.follow(&BTreeSet::from([Topic::Block(39), Topic::Block(40)]));
    let mut all = come(&mut playback);
    clock.store(12_000, Ordering::Relaxed);
    all.extend(come(&mut playback));
    let expected: Vec<_> = (2000..=12_000).step_by(20).collect();
    assert_eq!(ticks(&all, Topic::Block(40)), expected);
    assert_eq!(ticks(&all, Topic::Block(39)), (7020..=12_000).step_by(20).collect::<Vec<_>>());
    playback.follow(&BTreeSet::new());
    playback.seek(at(6000));
    let rest = come(&mut playback);
    assert!(rest.iter().flatten().all(|(_, it)| matches!(it, Topic::Catalogue | Topic::Voices)));
}

#[test]
fn a_key_that_lies_still_for_long_comes_with_its_last_rows() {
    let (_folder, path) = unrecorded();
    let is_still = |it: &(u64, Update)| matches!(&it.1, Update::Block(block) if block.key == 40 && 100 <= block.tick);
    let told: Vec<_> = performance(12_000).into_iter().filter(|it| !is_still(it)).collect();
    record(&path, &told);
    let (mut playback, clock) = played(&path);
    clock.store(11_000, Ordering::Relaxed);
    come(&mut playback);
    playback.follow(&BTreeSet::from([Topic::Block(40)]));
    assert_eq!(ticks(&come(&mut playback), Topic::Block(40)), [100]);
    playback.seek(at(10_000));
    assert_eq!(ticks(&come(&mut playback), Topic::Block(40)), [100]);
}

#[test]
fn a_topic_that_is_followed_anew_does_not_run_ahead() {
    let (_folder, path) = recorded(&performance(8000));
    let (mut playback, clock) = played(&path);
    playback.follow(&BTreeSet::from([Topic::Links]));
    clock.store(2100, Ordering::Relaxed);
    assert_eq!(ticks(&come(&mut playback), Topic::Links), [20, 1020, 2020]);
    playback.follow(&BTreeSet::from([Topic::Links, Topic::Block(39)]));
    let until = |last| (20..=last).step_by(20).collect::<Vec<u64>>();
    let mut all = come(&mut playback);
    assert_eq!(ticks(&all, Topic::Block(39)), until(2100));
    for millis in (2120..=8000).step_by(20) {
        clock.store(millis, Ordering::Relaxed);
        all.extend(come(&mut playback));
    }
    assert_eq!(ticks(&all, Topic::Block(39)), until(8000));
    assert_eq!(ticks(&all, Topic::Links), [3020, 4020, 5020, 6020, 7020]);
}

#[test]
fn a_recording_refuses_what_is_asked() {
    let (_folder, path) = recorded(&performance(100));
    let (mut playback, _clock) = played(&path);
    let ticket = playback.ask(Request::Stop {});
    playback.seek(at(50));
    let reply = std::iter::from_fn(|| playback.next()).find_map(|arrival| match arrival {
        Arrival::Reply { ticket, result } => Some((ticket, result)),
        Arrival::Update { .. } | Arrival::Anew => None,
    });
    let refusal = "this is a recording: nothing in it can be changed".to_owned();
    assert_eq!(reply, Some((ticket, Err(refusal))));
    assert_eq!(playback.standing(), ConnectionState::Recording);
    assert_eq!(playback.name(), path.display().to_string());
    assert!(playback.timeline().is_some());
}

#[test]
fn marks_are_what_is_worth_finding() {
    let (_folder, path) = unrecorded();
    let mut told = performance(5000);
    told.push((at(5001), event(Kind::Fault, 5001, 0.0, 39)));
    told.push((at(5002), event(Kind::Recovery, 5002, 0.0, 39)));
    told.extend((0..50).map(|tick| (at(5003 + tick), event(Kind::Miss, tick, 0.0, 255))));
    let Update::Event(change) = event(Kind::Change, 5060, 0.0, 39) else { unreachable!() };
    let text = "window: C4 k2 1 -> 2 N/m".to_owned();
    told.push((at(5060), Update::Event(Event { text, ..change })));
    told.push((at(6100), event(Kind::Miss, 6100, 0.0, 255)));
    record(&path, &told);
    let recording = Recording::open(&path).expect("a recording");
    let found: Vec<_> = marks(&recording).map(|mark| (mark.text, mark.is_fault)).collect();
    let strike = ("C4 struck".to_owned(), false);
    let fault = ("C4: fault: it panicked".to_owned(), true);
    let recovery = ("C4 recovered".to_owned(), false);
    let change = ("window: C4 k2 1 -> 2 N/m".to_owned(), false);
    let late = ("late × 50".to_owned(), true);
    // Each strike is a mark; late ticks within a second are one, in the order of time.
    let all = vec![strike; 50].into_iter().chain([fault, recovery, late, change]);
    assert_eq!(found, all.chain([("late".to_owned(), true)]).collect::<Vec<_>>());
    let (mut playback, _clock) = played(&path);
    while playback.marks().len() < found.len() {
        playback.next();
        thread::yield_now();
    }
    assert_eq!(playback.marks(), marks(&recording).collect::<Vec<_>>());
}

#[test]
fn marks_beyond_the_bound_are_counted() {
    let (_folder, path) = unrecorded();
    let mut told = performance(20);
    told.extend((0..50_010).map(|tick| (at(30 + tick), event(Kind::Fault, tick, 0.0, 39))));
    told.push((at(60_000), event(Kind::Strike, 60_000, 0.0, 40)));
    record(&path, &told);
    let recording = Recording::open(&path).expect("a recording");
    let found: Vec<_> = marks(&recording).collect();
    assert_eq!(found.len(), 1 + 50_000 + 1 + 1);
    assert_eq!(found[50_001].text, "C#4 struck", "faults displace no strike");
    let text = "not listed: 10 other moments; a list holds 50000 of each";
    assert_eq!((found[50_002].at, found[50_002].text.as_str()), (at(60_000), text));
}

#[test]
fn a_key_that_is_followed_again_has_a_marked_gap() {
    let (_folder, path) = recorded(&performance(12_000));
    let (mut playback, clock) = played(&path);
    let flags = |playback: &mut Playback| {
        let blocks = std::iter::from_fn(|| playback.next()).filter_map(|arrival| {
            let Arrival::Update { update, .. } = arrival else { return None };
            let Update::Block(block) = *update else { return None };
            Some(block.flags[0] & KeyBlock::MISSING)
        });
        blocks.collect::<Vec<_>>()
    };
    playback.follow(&BTreeSet::from([Topic::Block(39)]));
    clock.store(1000, Ordering::Relaxed);
    flags(&mut playback);
    playback.follow(&BTreeSet::new());
    clock.store(11_000, Ordering::Relaxed);
    flags(&mut playback);
    playback.follow(&BTreeSet::from([Topic::Block(39)]));
    let flags = flags(&mut playback);
    assert_eq!(flags[0], KeyBlock::MISSING);
    assert!(200 < flags.len() && flags[1..].iter().all(|it| *it == 0), "{flags:?}");
}

#[test]
fn a_cut_recording_says_so_and_is_played() {
    let (_folder, path) = recorded(&performance(3000));
    let bytes = std::fs::read(&path).expect("the file");
    std::fs::write(&path, &bytes[..bytes.len() / 2]).expect("a file");
    let (mut playback, clock) = played(&path);
    let keys = (0..u8::MAX).take(KEYS).map(Topic::Block);
    playback.follow(&keys.collect());
    clock.store(60_000, Ordering::Relaxed);
    let mut said = Vec::new();
    let mut blocks = 0;
    while let Some(arrival) = playback.next() {
        let Arrival::Update { update, .. } = arrival else { continue };
        blocks += usize::from(matches!(*update, Update::Block(_)));
        if let Update::Log(log) = *update {
            said.push(log.text);
        }
    }
    assert!(said.iter().any(|text| text.contains(" breaks off at byte ")), "{said:?}");
    assert!(100 < blocks, "{blocks}");
}
