//! A bounded list, newest last.

use std::collections::{VecDeque, vec_deque::Iter};

/// A bounded list that forgets its oldest entries.
#[derive(Clone, Debug)]
pub struct Journal<T> {
    entries: VecDeque<T>,
    most: usize,
    forgotten: u64,
}

impl<T> Journal<T> {
    pub const fn new(most: usize) -> Self {
        Self { entries: VecDeque::new(), most, forgotten: 0 }
    }

    pub fn push(&mut self, entry: T) {
        if self.entries.len() == self.most {
            self.entries.pop_front();
            self.forgotten += 1;
        }
        self.entries.push_back(entry);
    }

    pub fn iter(&self) -> Iter<'_, T> {
        self.entries.iter()
    }

    pub fn len(&self) -> usize {
        self.entries.len()
    }

    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Returns the number of all entries so far, also forgotten ones.
    pub fn count(&self) -> u64 {
        self.forgotten + self.entries.len() as u64
    }

    /// Returns the entries after the first `seen` of all so far.
    pub fn since(&self, seen: u64) -> impl Iterator<Item = &T> {
        let skipped = usize::try_from(seen.saturating_sub(self.forgotten)).unwrap_or(usize::MAX);
        self.entries.iter().skip(skipped)
    }

    /// Forgets all entries; they stay counted.
    pub fn clear(&mut self) {
        self.forgotten += self.entries.len() as u64;
        self.entries.clear();
    }
}

impl<'a, T> IntoIterator for &'a Journal<T> {
    type Item = &'a T;
    type IntoIter = Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_oldest_are_forgotten() {
        let mut journal = Journal::new(3);
        (0..5).for_each(|i| journal.push(i));
        assert_eq!(journal.iter().copied().collect::<Vec<_>>(), [2, 3, 4]);
        assert_eq!(journal.count(), 5);
        assert_eq!(journal.since(4).copied().collect::<Vec<_>>(), [4]);
        assert_eq!(journal.since(0).count(), 3);
        assert_eq!(journal.since(9).count(), 0);
        journal.clear();
        assert!(journal.is_empty());
        assert_eq!(journal.count(), 5);
    }
}
