//! Through a recording's messages in the order in which they were written.

use std::collections::BTreeSet;

use super::chunk::{Chunk, Inside};
use super::error::ReadError;
use super::part_file::PartFile;
use super::raw::Raw;
use crate::Topic;

/// A place among a recording's messages, from which it goes on.
///
/// One chunk is in memory at a time.
pub(super) struct Walk {
    part: usize,
    place: usize,
    open: Option<Chunk>,
    /// Messages of the open chunk that were passed.
    passed: usize,
    /// Where it ends; at the end of the recording if it is none.
    stop: Option<(usize, usize, usize)>,
    pub(super) topics: BTreeSet<Topic>,
    /// Messages from this time on (ns since 1970) …
    from: u64,
    /// … up to this one.
    last: u64,
    /// Whether something could not be read since catalogue and voices were said last.
    has_lost: bool,
    /// When they were said again that make up for it (ns since 1970).
    made_up: Option<u64>,
}

impl Walk {
    pub(super) const fn new(from: u64, last: u64, topics: BTreeSet<Topic>) -> Self {
        Self {
            part: 0,
            place: 0,
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

    /// A walk over what this one has passed, from `from` on.
    pub(super) fn past(&self, from: u64, topics: BTreeSet<Topic>) -> Self {
        let passed = if self.open.is_some() { self.passed } else { 0 };
        Self { stop: Some((self.part, self.place, passed)), ..Self::new(from, u64::MAX, topics) }
    }

    /// The next message; after an error it goes on behind what is damaged.
    pub(super) fn next(&mut self, parts: &[PartFile]) -> Option<Result<Raw, ReadError>> {
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
            self.place += 1;
            if found.is_some() {
                self.has_lost = true;
                return found;
            }
        }
    }

    fn open(&mut self, parts: &[PartFile]) -> Option<Result<(), ReadError>> {
        self.passed = 0;
        Some(self.open_next(parts)?.map(|chunk| self.open = Some(chunk)))
    }

    /// The chunk here, or the next one that may have something; none at the end.
    fn open_next(&mut self, parts: &[PartFile]) -> Option<Result<Chunk, ReadError>> {
        loop {
            let part = parts.get(self.part)?;
            let Some(place) = part.index.places.get(self.place) else {
                self.part += 1;
                self.place = 0;
                continue;
            };
            if self.stop.is_some_and(|(part, place, _)| (part, place) < (self.part, self.place)) {
                return None;
            }
            let is_in_range = place.first <= self.last && self.from <= place.last;
            if is_in_range && place.may_have(|topic| self.topics.contains(&topic)) {
                return Some(part.chunk(place));
            }
            self.place += 1;
        }
    }

    /// What comes next in the open chunk.
    fn next_inside(&mut self, parts: &[PartFile]) -> Option<Result<Raw, ReadError>> {
        let part = parts.get(self.part)?;
        let place = part.index.places.get(self.place)?;
        let chunk = self.open.as_mut()?;
        loop {
            let (topics, range) = (&self.topics, self.from..=self.last);
            let (passed, here, stop) = (&mut self.passed, (self.part, self.place), self.stop);
            let (has_lost, made_up) = (&mut self.has_lost, &mut self.made_up);
            let inside = chunk.next(|header| {
                *passed += 1;
                // What is said again was said before, unless that is not there or was lost.
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
                Err(error) => return Some(Err(part.is_damaged(place, &error))),
                Ok(Inside::Channel(..)) => {}
                Ok(Inside::Message(header, bytes)) => return part.raw(&header, bytes).map(Ok),
            }
        }
    }
}
