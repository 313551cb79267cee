//! A queue between a fast writer and a reader that may be slow.

use std::collections::VecDeque;

/// Rule by which a waiting entry may be dropped.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Worth {
    /// The oldest of these are dropped when there is no room.
    Passing,
    /// Dropped only for a newer one with this number.
    Latest(u16),
    Kept,
}

/// Queue bounded in bytes; a slow reader misses the oldest `Passing` entries. There is one `Latest`
/// for each number, and as many `Kept` as the reader requested.
#[derive(Debug)]
pub(crate) struct Backlog<T> {
    waiting: VecDeque<Waiting<T>>,
    bytes: usize,
    most: usize,
    dropped: u64,
}

#[derive(Debug)]
struct Waiting<T> {
    what: T,
    worth: Worth,
    bytes: usize,
}

/// Cost of an entry beside its content (bytes).
const OVERHEAD: usize = 64;

impl<T> Backlog<T> {
    pub(crate) const fn new(most: usize) -> Self {
        Self { waiting: VecDeque::new(), bytes: 0, most, dropped: 0 }
    }

    /// Adds `what` with `bytes` of content.
    pub(crate) fn push(&mut self, what: T, worth: Worth, bytes: usize) {
        let bytes = bytes.saturating_add(OVERHEAD);
        match worth {
            Worth::Passing => self.bytes = self.bytes.saturating_add(bytes),
            Worth::Latest(_) => self.outdate(worth),
            Worth::Kept => {}
        }
        self.waiting.push_back(Waiting { what, worth, bytes });
        while self.bytes > self.most && self.drop_oldest() {}
    }

    pub(crate) fn pop(&mut self) -> Option<T> {
        let entry = self.waiting.pop_front()?;
        self.release(&entry);
        Some(entry.what)
    }

    pub(crate) fn forget(&mut self, is_gone: impl Fn(&T) -> bool) {
        self.waiting.retain(|entry| !is_gone(&entry.what));
        let passing = self.waiting.iter().filter(|entry| entry.worth == Worth::Passing);
        self.bytes = passing.map(|entry| entry.bytes).sum();
    }

    /// Returns the number of dropped entries since the last call.
    pub(crate) const fn take_dropped(&mut self) -> u64 {
        std::mem::replace(&mut self.dropped, 0)
    }

    fn outdate(&mut self, worth: Worth) {
        for entry in self.waiting.iter_mut().filter(|entry| entry.worth == worth) {
            entry.worth = Worth::Passing;
            self.bytes = self.bytes.saturating_add(entry.bytes);
        }
    }

    fn drop_oldest(&mut self) -> bool {
        let place = self.waiting.iter().position(|entry| entry.worth == Worth::Passing);
        let Some(entry) = place.and_then(|place| self.waiting.remove(place)) else { return false };
        self.release(&entry);
        self.dropped += 1;
        true
    }

    fn release(&mut self, entry: &Waiting<T>) {
        if entry.worth == Worth::Passing {
            self.bytes = self.bytes.saturating_sub(entry.bytes);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all<T>(backlog: &mut Backlog<T>) -> Vec<T> {
        std::iter::from_fn(|| backlog.pop()).collect()
    }

    #[test]
    fn the_oldest_are_dropped_and_counted() {
        let mut backlog = Backlog::new(3 * (100 + OVERHEAD));
        for number in 0..10 {
            backlog.push(number, Worth::Passing, 100);
        }
        assert_eq!(backlog.take_dropped(), 7);
        assert_eq!(all(&mut backlog), [7, 8, 9]);
        assert_eq!((backlog.take_dropped(), backlog.bytes), (0, 0));
    }

    #[test]
    fn what_is_kept_is_never_dropped_and_the_latest_stands_for_those_before() {
        let mut backlog = Backlog::new(100 + OVERHEAD);
        backlog.push("kept", Worth::Kept, 1000);
        backlog.push("voice 1", Worth::Latest(1), 1000);
        backlog.push("other voice", Worth::Latest(2), 1000);
        backlog.push("old", Worth::Passing, 100);
        backlog.push("voice 2", Worth::Latest(1), 1000);
        backlog.push("new", Worth::Passing, 100);
        assert_eq!(all(&mut backlog), ["kept", "other voice", "voice 2", "new"]);
    }

    #[test]
    fn what_is_larger_than_the_room_is_dropped_itself() {
        let mut backlog = Backlog::new(10);
        backlog.push(1, Worth::Passing, 1000);
        assert_eq!((backlog.take_dropped(), backlog.pop()), (1, None));
    }

    #[test]
    fn what_is_forgotten_leaves_its_room() {
        let mut backlog = Backlog::new(2 * OVERHEAD);
        backlog.push(1, Worth::Passing, 0);
        backlog.push(2, Worth::Passing, 0);
        backlog.forget(|number| *number == 1);
        backlog.push(3, Worth::Passing, 0);
        assert_eq!(backlog.take_dropped(), 0);
        assert_eq!(all(&mut backlog), [2, 3]);
    }
}
