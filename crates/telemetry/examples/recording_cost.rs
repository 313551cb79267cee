//! Cost of recording: all 88 keys at 1 kHz, and ten of them.
//!
//! `cargo run --release -p telemetry --example recording_cost [folder]`
#![expect(clippy::print_stdout, reason = "it prints what it measures")]

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{error::Error, fs};

use rustix::time::{ClockId, clock_gettime};
use telemetry::recording::{Recorder, Recording, RecordingLimits, RecordingSettings};
use telemetry::{Catalogue, KeyBlock, Overview, Source as _, Timeline as _, Topic, Update, Voice};

const SIGNALS: usize = 10;
/// Ticks of a block: from 16 to 33, as the window's frames fall.
const BLOCKS: [u64; 4] = [16, 33, 20, 27];
/// Length of a tick (ns).
const TICK: u64 = 1_000_000;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).map_or_else(std::env::temp_dir, PathBuf::from);
    let folder = folder.join(format!("letoff-recording-cost-{}", std::process::id()));
    fs::create_dir(&folder)?;
    for keys in [88, 10] {
        let cost = record(&folder.join(format!("{keys}.mcap")), keys, 60)?;
        println!("{keys:>2} keys: {cost}");
    }
    let path = folder.join("ten-minutes.mcap");
    let cost = record(&path, 10, 600)?;
    println!("ten minutes, 10 keys: {cost}");
    open(&path)?;
    fs::remove_dir_all(folder)?;
    Ok(())
}

fn record(path: &Path, keys: u32, seconds: u64) -> Result<String, Box<dyn Error>> {
    let limits = RecordingLimits {
        largest_file: u64::MAX,
        longest_file: None,
        largest_total: u64::MAX,
        lowest_free: 0,
    };
    let settings = RecordingSettings { limits, ..RecordingSettings::new(path, "cost") };
    let mut recorder = Recorder::create(settings)?;
    for update in beginning(keys) {
        recorder.write(0, &update)?;
    }
    let mut random = Random(1);
    let (mut tick, mut own) = (0, Duration::ZERO);
    for ticks in BLOCKS.iter().cycle() {
        if seconds * 1000 <= tick {
            break;
        }
        let now = (tick + ticks) * TICK;
        let mut updates: Vec<_> =
            (0..keys).map(|key| block(key, tick, *ticks, &mut random)).collect();
        updates.push(Update::Overview(overview(tick, &mut random)));
        let before = cpu();
        for update in &updates {
            recorder.write(now, update)?;
        }
        own += cpu().saturating_sub(before);
        tick += ticks;
    }
    let before = cpu();
    let recorded = recorder.finish()?;
    own += cpu().saturating_sub(before);
    let share = own.as_secs_f64() / seconds as f64 * 100.0;
    let size = recorded.bytes as f64 / 1e6 / (seconds as f64 / 60.0);
    Ok(format!("{share:.2} % of a core, {size:.1} MB a minute, {} messages", recorded.messages))
}

fn open(path: &Path) -> Result<(), Box<dyn Error>> {
    let began = Instant::now();
    let recording = Recording::open(path)?;
    let (opened, read) = (began.elapsed(), recording.bytes_read());
    println!("opened in {:.1} ms, {read} bytes of {}", millis(opened), path.metadata()?.len());
    let clock = Instant::now();
    let seconds = Box::new(move || clock.elapsed().as_secs_f64());
    let mut playback = telemetry::recording::Playback::new(recording, seconds);
    playback.set_speed(0.0);
    playback.follow(&(0..10).map(Topic::Block).chain([Topic::Overview]).collect());
    for second in [300, 30, 599] {
        let began = Instant::now();
        playback.seek(second * 1_000_000_000);
        let arrivals = std::iter::from_fn(|| playback.next()).count();
        println!("at {second} s in {:.1} ms: {arrivals} messages", millis(began.elapsed()));
    }
    Ok(())
}

fn millis(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e3
}

fn cpu() -> Duration {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    Duration::try_from(time).unwrap_or_default()
}

fn beginning(keys: u32) -> Vec<Update> {
    let catalogue = Catalogue { tick_hz: 1000, run: "cost".to_owned(), ..Catalogue::default() };
    let voice = |key| Update::Voice(Voice { key, values: vec![1.0; 30], ..Voice::default() });
    std::iter::once(Update::Catalogue(catalogue)).chain((0..keys).map(voice)).collect()
}

fn block(key: u32, tick: u64, ticks: u64, random: &mut Random) -> Update {
    let times: Vec<f64> = (tick..tick + ticks).map(|tick| tick as f64 * 1e-3).collect();
    let count = times.len();
    let stroke = |t: f64| 0.005 * (1.0 + (t * (5.0 + f64::from(key % 7)) + f64::from(key)).sin());
    // An encoder counts in steps of two micrometres.
    let position: Vec<f64> =
        times.iter().map(|t| ((stroke(*t) + 2e-6 * random.next()) / 2e-6).round() * 2e-6).collect();
    let force: Vec<f64> =
        position.iter().map(|position| 0.5 + 200.0 * position + 0.01 * random.next()).collect();
    let signals = position
        .iter()
        .flat_map(|position| {
            let signal = |index: usize| single(position * (1.0 + index as f64));
            (0..SIGNALS).map(signal).collect::<Vec<_>>()
        })
        .map(|signal| signal + single(1e-6 * random.next()))
        .collect();
    Update::Block(KeyBlock {
        key,
        tick,
        after: (0..).take(count).collect(),
        position,
        age: vec![0; count],
        taken: times.iter().map(|_| 0.01 * random.next()).collect(),
        sent: force.clone(),
        force,
        mode: vec![1; count],
        flags: vec![0; count],
        fault: vec![0; count],
        revision: vec![key; count],
        unrun: vec![0; count],
        events: vec![0; count],
        signals,
        velocity: Vec::new(),
        limit: Vec::new(),
        late_limit: Vec::new(),
    })
}

fn overview(tick: u64, random: &mut Random) -> Overview {
    let mut column = || (0..88).map(|_| single(random.next())).collect::<Vec<_>>();
    Overview {
        tick,
        ticks: 33,
        position_min: column(),
        position_max: column(),
        force_min: column(),
        force_max: column(),
        mode: vec![0; 88],
        flags: vec![0; 88],
        fault: vec![0; 88],
        dropped: 0,
    }
}

#[expect(clippy::cast_possible_truncation, reason = "signals are single")]
const fn single(value: f64) -> f32 {
    value as f32
}

struct Random(u64);

impl Random {
    const fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
