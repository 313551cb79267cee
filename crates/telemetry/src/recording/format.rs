//! Names, numbers and versions of our files.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use mcap::records::Metadata;

use crate::Topic;

/// Version of the format: files with another number before the point are rejected.
pub const FORMAT: &str = "1.0";

/// Profile of the header, and name of the metadata.
pub(super) const PROFILE: &str = "letoff";

pub(super) const LIBRARY: &str = concat!("letoff ", env!("CARGO_PKG_VERSION"));

/// Size at which a chunk is closed (B): quick to read for a timeline, and worth compressing.
pub(super) const CHUNK: u64 = 1 << 20;

/// Largest accepted chunk (B), compressed or not; a greater length is damage.
pub(super) const LARGEST_CHUNK: usize = 64 << 20;

/// Largest accepted compression ratio of a chunk: lz4 reaches 255, and messages of keys far less.
pub(super) const LARGEST_RATIO: u64 = 1024;

/// Labels of a file: its run, part and format.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Labels {
    pub(super) run: String,
    pub(super) part: u32,
    pub(super) format: String,
}

impl Labels {
    pub(super) fn new(run: &str, part: u32) -> Self {
        Self { run: run.to_owned(), part, format: FORMAT.to_owned() }
    }

    pub(super) fn metadata(&self) -> Metadata {
        let entries = [
            ("format", self.format.clone()),
            ("part", self.part.to_string()),
            ("run", self.run.clone()),
        ];
        let entries = entries.map(|(name, value)| (name.to_owned(), value));
        Metadata { name: PROFILE.to_owned(), metadata: BTreeMap::from(entries) }
    }

    pub(super) fn of(metadata: &Metadata) -> Option<Self> {
        if metadata.name != PROFILE {
            return None;
        }
        let entry = |name: &str| metadata.metadata.get(name).cloned();
        let part = entry("part").and_then(|part| part.parse().ok()).unwrap_or(1);
        // A text that is no number is damage, not another version.
        let is_version = |format: &String| format.split('.').all(|it| it.parse::<u32>().is_ok());
        Some(Self { run: entry("run")?, part, format: entry("format").filter(is_version)? })
    }

    pub(super) fn is_ours(&self) -> bool {
        let major = |format: &str| format.split('.').next().map(str::to_owned);
        major(&self.format) == major(FORMAT)
    }
}

const BLOCKS: u16 = 100;
const STATES: u16 = 200;

/// Returns the number of a topic's channel, the same in every file that Letoff writes.
pub(super) const fn channel(topic: Topic) -> u16 {
    match topic {
        Topic::Catalogue => 1,
        Topic::Voices => 2,
        Topic::Overview => 3,
        Topic::Events => 4,
        Topic::Ticks => 5,
        Topic::Deadlines => 6,
        Topic::Links => 7,
        Topic::Midi => 8,
        Topic::Log => 9,
        // 10 and 11 are the schemas of blocks and states.
        Topic::Status => 12,
        Topic::Block(key) => BLOCKS + key as u16,
        Topic::State(key) => STATES + key as u16,
    }
}

/// Returns the number of a topic's schema; 0 would mean that there is none.
pub(super) const fn schema(topic: Topic) -> u16 {
    match channel(topic) {
        STATES.. => 11,
        BLOCKS.. => 10,
        common => common,
    }
}

pub(super) fn topics() -> BTreeMap<u16, Topic> {
    Topic::all().map(|topic| (channel(topic), topic)).collect()
}

/// Returns the path of part `part` of a recording: `take-0002.mcap` of the first file `take.mcap`.
pub(super) fn part_path(first: &Path, part: u32) -> PathBuf {
    if part <= 1 {
        return first.to_owned();
    }
    let stem = first.file_stem().unwrap_or_default().to_string_lossy();
    first.with_file_name(format!("{stem}-{part:04}.{}", extension(first)))
}

/// Returns the path of the first part of the recording whose part `part` is `path`.
pub(super) fn first_path(path: &Path, part: u32) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    match stem.strip_suffix(&format!("-{part:04}")) {
        Some(first) if part > 1 => path.with_file_name(format!("{first}.{}", extension(path))),
        _ => path.to_owned(),
    }
}

fn extension(path: &Path) -> String {
    path.extension().map_or_else(|| "mcap".to_owned(), |it| it.to_string_lossy().into_owned())
}
