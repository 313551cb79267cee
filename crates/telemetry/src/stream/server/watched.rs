use std::collections::BTreeSet;

use crate::{request::Change, stream::protocol::ParameterValue};

/// Most names of a client, more than a full keyboard has.
const MOST_NAMES: usize = 16_384;

/// Longest name of a parameter (bytes).
const LONGEST_NAME: usize = 128;

/// The parameters whose values a client follows.
#[derive(Debug)]
pub(super) enum WatchedParameters {
    All,
    Only(BTreeSet<String>),
}

impl WatchedParameters {
    pub(super) const fn none() -> Self {
        Self::Only(BTreeSet::new())
    }

    /// Adds names; all parameters if `names` is empty.
    pub(super) fn add(&mut self, names: Vec<String>) {
        match self {
            Self::All => {}
            Self::Only(_) if names.is_empty() => *self = Self::All,
            Self::Only(set) => {
                let room = MOST_NAMES.saturating_sub(set.len());
                set.extend(names.into_iter().filter(|name| can_change(name)).take(room));
            }
        }
    }

    /// Removes names; all if `names` is empty. No single one can be left out of all parameters.
    pub(super) fn remove(&mut self, names: &[String]) {
        if names.is_empty() {
            *self = Self::none();
        }
        if let Self::Only(set) = self {
            for name in names {
                set.remove(name);
            }
        }
    }

    pub(super) fn of(&self, changed: &[ParameterValue]) -> Vec<ParameterValue> {
        match self {
            Self::All => changed.to_vec(),
            Self::Only(set) => {
                changed.iter().filter(|it| set.contains(&it.name)).cloned().collect()
            }
        }
    }
}

fn can_change(name: &str) -> bool {
    name.len() <= LONGEST_NAME && Change::named(name, 0.0).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heard(watched: &WatchedParameters) -> Vec<String> {
        let changed = ["/key/1/m", "/key/2/m"].map(|name| ParameterValue::new(name, 1.0));
        watched.of(&changed).into_iter().map(|parameter| parameter.name).collect()
    }

    fn names(names: &[&str]) -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn only_what_is_watched_is_heard_of() {
        let mut watched = WatchedParameters::none();
        assert!(heard(&watched).is_empty());
        watched.add(names(&["/key/2/m", "/key/99/m", "foreign"]));
        assert_eq!(heard(&watched), ["/key/2/m"]);
        watched.remove(&names(&["/key/2/m"]));
        assert!(heard(&watched).is_empty());
    }

    #[test]
    fn without_names_all_are_meant() {
        let mut watched = WatchedParameters::none();
        watched.add(vec![]);
        assert_eq!(heard(&watched), ["/key/1/m", "/key/2/m"]);
        watched.remove(&[]);
        assert!(heard(&watched).is_empty());
    }

    #[test]
    fn names_without_end_take_no_memory_without_end() {
        let mut watched = WatchedParameters::none();
        watched.add((0..100_000).map(|number| format!("/key/1/p{number}")).collect());
        watched.add(vec![format!("/key/1/{}", "x".repeat(1 << 20))]);
        assert!(matches!(watched, WatchedParameters::Only(set) if set.len() == MOST_NAMES));
    }
}
