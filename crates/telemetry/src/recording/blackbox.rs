//! The last seconds, kept to be written when something fails.

use std::{collections::VecDeque, path::Path, time::Duration};

use super::error::RecordError;
use super::format::Labels;
use super::latest::Latest;
use super::part::RecordingPart;
use super::raw_message::RawMessage;
use crate::Update;

/// The last seconds of messages, with their catalogue and voices, in bounded memory.
#[derive(Clone, Debug)]
pub struct BlackBox {
    /// Time for which a message is kept (ns).
    span: u64,
    most: usize,
    ring: VecDeque<RawMessage>,
    bytes: usize,
    before: Latest,
    newest: u64,
}

impl BlackBox {
    /// Creates a black box for the last `span`, but at most `most_bytes` (B).
    pub fn new(span: Duration, most_bytes: usize) -> Self {
        Self {
            span: u64::try_from(span.as_nanos()).unwrap_or(u64::MAX),
            most: most_bytes,
            ring: VecDeque::new(),
            bytes: 0,
            before: Latest::default(),
            newest: 0,
        }
    }

    /// Keeps `update` from `at` (ns since 1970), and forgets old ones; rejects an unknown key.
    pub fn keep(&mut self, at: u64, update: &Update) -> Result<(), RecordError> {
        let raw = RawMessage::of(at, update)?;
        self.newest = self.newest.max(at);
        self.bytes += cost(&raw);
        self.ring.push_back(raw);
        while self.is_too_much() {
            let Some(oldest) = self.ring.pop_front() else { break };
            self.bytes -= cost(&oldest);
            self.before.note(&oldest);
        }
        Ok(())
    }

    pub fn bytes(&self) -> usize {
        self.bytes + self.before.bytes()
    }

    /// Writes its messages of `run` to the new file `path`; returns its size (B).
    pub fn dump(&self, path: &Path, run: &str) -> Result<u64, RecordError> {
        let labels = Labels::new(run, 1);
        let mut part = RecordingPart::create(path, &labels)?;
        let mut latest = self.before.clone();
        let begins = self.ring.front().map_or(self.newest, |raw| raw.at);
        for raw in self.before.repeated(begins) {
            part.add(&raw)?;
        }
        for raw in &self.ring {
            part.add(raw)?;
            latest.note(raw);
            if part.is_chunk_full() {
                part.flush()?;
            }
        }
        part.write_trailer(&labels, &latest, self.newest)?;
        part.finish()
    }

    fn is_too_much(&self) -> bool {
        let oldest = self.newest.saturating_sub(self.span);
        self.bytes() > self.most || self.ring.front().is_some_and(|raw| raw.at < oldest)
    }
}

/// Returns the memory that `raw` takes (B).
const fn cost(raw: &RawMessage) -> usize {
    raw.bytes.capacity() + size_of::<RawMessage>()
}
