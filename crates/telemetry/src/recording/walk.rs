//! A cursor over a recording's messages in the order of writing.

use std::collections::BTreeSet;

use super::chunk::{Chunk, Inside};
use super::{missing::MissingPiece, part_file::PartFile, raw_message::RawMessage};
use crate::Topic;

/// Cursor in a recording's messages, with one chunk in memory at a time.
pub(super) struct Walk {
    part: usize,
    position: usize,
    open: Option<Chunk>,
    passed: usize,
    /// Part, chunk and message of its end; `None` for the recording's end.
    stop: Option<(usize, usize, usize)>,
    pub(super) topics: BTreeSet<Topic>,
    /// Time of the first wanted messages (ns since 1970).
    from: u64,
    /// Time of the last wanted messages (ns since 1970).
    last: u64,
    /// `true` if a chunk was unreadable since catalogue and voices came last.
    has_lost: bool,
    /// Time of the repeated messages that make up for a loss (ns since 1970).
    made_up: Option<u64>,
}

impl Walk {
    pub(super) const fn new(from: u64, last: u64, topics: BTreeSet<Topic>) -> Self {
        Self {
            part: 0,
            position: 0,
            open: None,
            passed: 0,
            stop: None,
            topics,
            from,
            last,
            has_lost: false,
            made_up: None,
        }
    }

    /// Returns a walk over the messages that this one has passed, from `from` on (ns since 1970).
    pub(super) fn past(&self, from: u64, topics: BTreeSet<Topic>) -> Self {
        let passed = if self.open.is_some() { self.passed } else { 0 };
        Self { stop: Some((self.part, self.position, passed)), ..Self::new(from, u64::MAX, topics) }
    }

    /// Returns the next message; after an error it continues behind the damage.
    pub(super) fn next(&mut self, parts: &[PartFile]) -> Option<Result<RawMessage, MissingPiece>> {
        loop {
            let is_open = if self.open.is_none() { self.open(parts)? } else { Ok(()) };
            let found = match is_open {
                Ok(()) => self.next_inside(parts),
                Err(error) => Some(Err(error)),
            };
            if matches!(found, Some(Ok(_))) {
                return found;
            }
            self.open = None;
            self.position += 1;
            if found.is_some() {
                self.has_lost = true;
                return found;
            }
        }
    }

    fn open(&mut self, parts: &[PartFile]) -> Option<Result<(), MissingPiece>> {
        self.passed = 0;
        Some(self.open_next(parts)?.map(|chunk| self.open = Some(chunk)))
    }

    /// Opens this chunk, or the next one that may have wanted messages; `None` at the end.
    fn open_next(&mut self, parts: &[PartFile]) -> Option<Result<Chunk, MissingPiece>> {
        loop {
            let part = parts.get(self.part)?;
            let Some(position) = part.index.positions.get(self.position) else {
                self.part += 1;
                self.position = 0;
                continue;
            };
            if self
                .stop
                .is_some_and(|(part, position, _)| (part, position) < (self.part, self.position))
            {
                return None;
            }
            let is_in_range = position.first <= self.last && self.from <= position.last;
            if is_in_range && position.may_have(|topic| self.topics.contains(&topic)) {
                return Some(part.chunk(position));
            }
            self.position += 1;
        }
    }

    fn next_inside(&mut self, parts: &[PartFile]) -> Option<Result<RawMessage, MissingPiece>> {
        let part = parts.get(self.part)?;
        let position = part.index.positions.get(self.position)?;
        let chunk = self.open.as_mut()?;
        loop {
            let (topics, range) = (&self.topics, self.from..=self.last);
            let (passed, here, stop) = (&mut self.passed, (self.part, self.position), self.stop);
            let (has_lost, made_up) = (&mut self.has_lost, &mut self.made_up);
            let inside = chunk.next(|header| {
                *passed += 1;
                // Skip repeated messages unless the earlier ones are missing or were lost.
                let is_again = header.publish_time != header.log_time;
                let is_beginning = here == (0, 0) && *passed == 1;
                let begins = is_again && (is_beginning || std::mem::take(has_lost));
                *made_up = begins.then_some(header.log_time).or(*made_up);
                let is_new = !is_again || *made_up == Some(header.log_time);
                is_new
                    && stop.is_none_or(|stop| (here.0, here.1, *passed) <= stop)
                    && range.contains(&header.log_time)
                    && part.topic(header).is_some_and(|topic| topics.contains(&topic))
            });
            match inside? {
                Err(error) => return Some(Err(part.is_damaged(position, &error))),
                Ok(Inside::Channel(..)) => {}
                Ok(Inside::Message(header, bytes)) => return part.raw(&header, bytes).map(Ok),
            }
        }
    }
}
