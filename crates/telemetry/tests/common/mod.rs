//! Messages of a host, and a recording of them.

use std::path::{Path, PathBuf};

use telemetry::event::Kind;
use telemetry::recording::{
    Recorder, Recording, RecordingLimits, RecordingSettings, RecordingStatus,
};
use telemetry::{
    Catalogue, Deadlines, Event, KeyBlock, KeyState, Links, Log, Midi, Model, Overview, Signal,
    Ticks, Update, Voice,
};
use tempfile::TempDir;

/// Time of tick 0 (ns since 1970).
pub(crate) const BEGAN: u64 = 1_700_000_000_000_000_000;
/// Length of a tick (ns).
pub(crate) const TICK: u64 = 1_000_000;
pub(crate) const BLOCK: u64 = 20;
pub(crate) const KEYS: [u32; 3] = [38, 39, 40];
pub(crate) const SIGNALS: [(&str, &str); 3] = [("hammer", "m"), ("speed", "m/s"), ("gap", "")];

/// Returns the time of `tick` (ns since 1970).
pub(crate) const fn at(tick: u64) -> u64 {
    BEGAN + tick * TICK
}

pub(crate) fn catalogue() -> Update {
    let signal = |(name, unit): (&str, &str)| Signal {
        name: name.to_owned(),
        unit: unit.to_owned(),
        ..Signal::default()
    };
    let model = |name: &str, signals: &[(&str, &str)]| Model {
        name: name.to_owned(),
        modes: vec!["free".to_owned(), "in contact".to_owned()],
        signals: signals.iter().copied().map(signal).collect(),
        ..Model::default()
    };
    Update::Catalogue(Catalogue {
        run: "the run".to_owned(),
        began: BEGAN,
        tick_hz: 1000,
        models: vec![model("springs", &SIGNALS), model("wall", &[])],
        ..Catalogue::default()
    })
}

pub(crate) fn voice(key: u32, revision: u32, model: &str, instrument: &str) -> Update {
    Update::Voice(Voice {
        key,
        revision,
        model: model.to_owned(),
        instrument: instrument.to_owned(),
        values: vec![f64::from(key), 0.1],
        ..Voice::default()
    })
}

pub(crate) fn noise(seed: u64) -> f64 {
    let mut bits = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5555_5555;
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

#[expect(clippy::cast_possible_truncation, reason = "signals are single")]
const fn single(value: f64) -> f32 {
    value as f32
}

pub(crate) fn block(key: u32, tick: u64) -> Update {
    let rows: Vec<u64> = (0..BLOCK).collect();
    let random = |row: &u64, column: u64| noise((tick + row) * 1000 + u64::from(key) * 10 + column);
    let count = rows.len();
    Update::Block(KeyBlock {
        key,
        tick,
        after: (0..).take(count).collect(),
        position: rows.iter().map(|row| random(row, 0) * 0.01).collect(),
        age: vec![0; count],
        taken: vec![0.0; count],
        velocity: Vec::new(),
        limit: Vec::new(),
        late_limit: Vec::new(),
        force: rows.iter().map(|row| random(row, 1)).collect(),
        sent: rows.iter().map(|row| random(row, 2)).collect(),
        mode: vec![1; count],
        flags: vec![5; count],
        fault: vec![0; count],
        revision: vec![key; count],
        unrun: vec![0; count],
        events: vec![0; count],
        signals: rows
            .iter()
            .flat_map(|row| (3..6).map(|column| single(random(row, column))).collect::<Vec<_>>())
            .collect(),
    })
}

pub(crate) fn event(kind: Kind, tick: u64, theta: f64, key: u32) -> Update {
    let text = if kind == Kind::Fault { "it panicked" } else { "" };
    let event = Event { tick, theta, key, speed: 1.25, text: text.to_owned(), ..Event::default() };
    Update::Event(Event { kind: kind.into(), ..event })
}

pub(crate) fn performance(ticks: u64) -> Vec<(u64, Update)> {
    let mut told = vec![(at(0), catalogue())];
    told.extend(KEYS.map(|key| (at(0), voice(key, key, "springs", "grand"))));
    for tick in (0..ticks).step_by(usize::try_from(BLOCK).expect("few")) {
        let now = at(tick + BLOCK);
        told.extend(KEYS.map(|key| (now, block(key, tick))));
        told.push((now, Update::State(39, KeyState { tick, force: 1.0, ..KeyState::default() })));
        told.push((
            now,
            Update::Overview(Overview { tick, mode: vec![1; 88], ..Overview::default() }),
        ));
        told.push((now, Update::Ticks(Ticks { tick, work: vec![3.5; 20], ..Ticks::default() })));
        if tick % 100 == 0 {
            told.push((now, event(Kind::Strike, tick, 0.1 + 0.2, 39)));
            told.push((now, Update::Midi(Midi { bytes: vec![0x90, 60, 70], ..Midi::default() })));
        }
        if tick % 1000 == 0 {
            told.push((now, Update::Deadlines(Deadlines { ticks: tick, ..Deadlines::default() })));
            told.push((now, Update::Links(Links::default())));
            told.push((now, Update::Log(Log { text: "all is well".to_owned(), ..Log::default() })));
        }
    }
    told
}

pub(crate) fn settings(path: &Path) -> RecordingSettings {
    RecordingSettings {
        limits: RecordingLimits { lowest_free: 0, ..RecordingLimits::default() },
        ..RecordingSettings::new(path, "the run")
    }
}

/// Returns settings whose files have the least size.
pub(crate) fn small(path: &Path) -> RecordingSettings {
    limited(path, |limits| limits.largest_file = RecordingLimits::LEAST_FILE)
}

pub(crate) fn limited(path: &Path, change: impl FnOnce(&mut RecordingLimits)) -> RecordingSettings {
    let mut settings = settings(path);
    change(&mut settings.limits);
    settings
}

pub(crate) fn unrecorded() -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("take.mcap");
    (folder, path)
}

pub(crate) fn recorded(told: &[(u64, Update)]) -> (TempDir, PathBuf) {
    let (folder, path) = unrecorded();
    record(&path, told);
    (folder, path)
}

pub(crate) fn record(path: &Path, told: &[(u64, Update)]) {
    record_as(settings(path), told);
}

pub(crate) fn record_as(settings: RecordingSettings, told: &[(u64, Update)]) -> RecordingStatus {
    let mut recorder = Recorder::create(settings).expect("a new file");
    for (at, update) in told {
        recorder.write(*at, update).expect("a message");
    }
    recorder.finish().expect("a complete file")
}

pub(crate) fn read(recording: &Recording) -> (Vec<(u64, Update)>, Vec<String>) {
    let (mut told, mut wrong) = (Vec::new(), Vec::new());
    for message in recording.messages() {
        match message {
            Ok(message) => told.push(message),
            Err(error) => wrong.push(error.to_string()),
        }
    }
    (told, wrong)
}
