//! How much of a recording is saved when its file is damaged at random places.

use std::fmt;
use std::fs;

use mcap::records::Record;
use mcap::sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions};
use telemetry::recording::{Recording, recover};
use telemetry::{KeyBlock, Update};

use crate::common::{noise, performance, read, record};

/// Length of the recording (ms), and the share of it that a chunk holds at most.
const LENGTH: u64 = 20_000;
const CHUNK: f64 = 0.5 / 20.0;

/// Damaged files that are tried; `DAMAGED_RECORDINGS` asks for more.
fn damages() -> u64 {
    std::env::var("DAMAGED_RECORDINGS").ok().and_then(|it| it.parse().ok()).unwrap_or(200)
}

/// What was done to a file.
#[derive(Clone, Copy, Debug)]
enum Damage {
    Flipped(usize),
    Zeroed(usize, usize),
    Cut(usize),
    Appended(usize),
}

impl Damage {
    /// The damage with this number, at a random place of a file of `size` bytes.
    fn number(n: u64, size: usize) -> Self {
        let place = scaled(noise(2 * n), size);
        let length = 1 + scaled(noise(2 * n + 1), 64 << 10);
        match n % 4 {
            0 => Self::Flipped(place),
            1 => Self::Zeroed(place, length.min(size - place)),
            2 => Self::Cut(place),
            _ => Self::Appended(length),
        }
    }

    fn of(self, whole: &[u8]) -> Vec<u8> {
        let mut bytes = whole.to_vec();
        match self {
            Self::Flipped(at) => bytes[at] ^= 1 << (at % 8),
            Self::Zeroed(at, length) => bytes[at..at + length].fill(0),
            Self::Cut(at) => bytes.truncate(at),
            Self::Appended(length) => bytes.extend((0_u64..).take(length).map(|byte| {
                let [low, ..] = noise(byte).to_bits().to_le_bytes();
                low
            })),
        }
        bytes
    }

    /// The share of rows that must be saved: all that lie in chunks which were not hit.
    fn floor(self, size: usize) -> f64 {
        let share = |bytes: usize| bytes as f64 / size as f64;
        let spared = match self {
            Self::Flipped(_) => 1.0,
            Self::Zeroed(_, length) => 1.0 - share(length),
            Self::Cut(at) => share(at),
            Self::Appended(_) => return 1.0,
        };
        // A hit may lie on the border of two chunks, and time is not quite even in the file.
        spared - 2.5 * CHUNK
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a share of something small"
)]
fn scaled(share: f64, of: usize) -> usize {
    (share * of as f64) as usize
}

fn rows(told: &[(u64, Update)]) -> usize {
    let of =
        |it: &Update| if let Update::Block(KeyBlock { after, .. }) = it { after.len() } else { 0 };
    told.iter().map(|(_, update)| of(update)).sum()
}

/// Messages that the plainest reader finds which checks what it reads: from the beginning up to
/// the first chunk or record that is damaged.
fn plain_reader(bytes: &[u8]) -> usize {
    let options = LinearReaderOptions::default().with_prevalidate_chunk_crcs(true);
    let mut reader = LinearReader::new_with_options(options.with_record_length_limit(1 << 28));
    let (mut rest, mut messages) = (bytes, 0);
    while let Some(Ok(event)) = reader.next_event() {
        match event {
            LinearReadEvent::ReadRequest(wanted) => {
                let (next, later) = rest.split_at(wanted.min(rest.len()));
                reader.insert(next.len()).copy_from_slice(next);
                reader.notify_read(next.len());
                rest = later;
            }
            LinearReadEvent::Record { opcode, data } => {
                let record = mcap::parse_record(opcode, data);
                let is_told = matches!(record, Ok(Record::Message { header, .. })
                    if header.log_time == header.publish_time);
                messages += usize::from(is_told);
            }
        }
    }
    messages
}

/// Shares of rows that were saved.
#[derive(Default)]
struct Saved(Vec<f64>);

impl fmt::Display for Saved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shares = self.0.clone();
        shares.sort_by(f64::total_cmp);
        let (least, median) = (shares[0] * 100.0, shares[shares.len() / 2] * 100.0);
        write!(f, "{} files, at least {least:.1} % of rows, median {median:.1} %", shares.len())
    }
}

#[test]
fn a_file_that_is_damaged_at_random_loses_what_was_hit_and_its_neighbours_at_most() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("whole.mcap");
    let told = performance(LENGTH);
    record(&path, &told);
    let whole = fs::read(&path).expect("the file");
    let all = rows(&told) as f64;
    let (hit, new) = (folder.path().join("hit.mcap"), folder.path().join("new.mcap"));
    let mut saved: [Saved; 4] = Default::default();
    for n in 0..damages() {
        let damage = Damage::number(n, whole.len());
        let bytes = damage.of(&whole);
        fs::write(&hit, &bytes).expect("a file");
        let _before = fs::remove_file(&new);
        let found = match recover(&hit, &new) {
            Ok(_) => read(&Recording::open(&new).expect("it is complete")).0,
            Err(error) => {
                assert!(!error.to_string().contains('\n'), "{error}");
                Vec::new()
            }
        };
        let plain = plain_reader(&bytes);
        assert!(plain <= found.len(), "{damage:?}: {} messages of {plain}", found.len());
        let share = rows(&found) as f64 / all;
        let floor = damage.floor(whole.len());
        assert!(floor <= share, "{damage:?} saves {share}, and should {floor}");
        saved[usize::try_from(n % 4).expect("below four")].0.push(share);
    }
    for (what, saved) in
        ["a bit", "up to 64 KiB zeroed", "cut", "garbage behind"].iter().zip(&saved)
    {
        println!("{what}: {saved}");
    }
}
