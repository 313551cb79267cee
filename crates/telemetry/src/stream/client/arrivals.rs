//! Arrivals that wait for the window.

use std::collections::BTreeSet;
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::Waker;
use crate::stream::backlog::{Backlog, Worth};
use crate::{Arrival, ConnectionState, Topic, stream::Role, stream::retained::retained_slot};

/// Messages that wait for a window (bytes); more are dropped.
const ROOM: usize = 32 << 20;

pub(super) struct Arrivals {
    waiting: Mutex<Backlog<Arrival>>,
    state: Mutex<ConnectionState>,
    role: Mutex<Option<Role>>,
    waker: Option<Waker>,
}

impl Arrivals {
    pub(super) fn new(waker: Option<Waker>) -> Self {
        Self {
            waiting: Mutex::new(Backlog::new(ROOM)),
            state: Mutex::new(ConnectionState::Connecting),
            role: Mutex::default(),
            waker,
        }
    }

    pub(super) fn push(&self, arrival: Arrival, bytes: usize) {
        let worth = worth(&arrival);
        self.waiting().push(arrival, worth, bytes);
        self.wake();
    }

    /// Clears the queue, except replies, for a new connection with rights `role`.
    pub(super) fn begin(&self, role: Option<Role>) {
        *self.role.lock().unwrap_or_else(PoisonError::into_inner) = role;
        self.waiting().forget(|arrival| !matches!(arrival, Arrival::Reply { .. }));
        self.push(Arrival::Anew, 0);
        self.set_state(ConnectionState::Live);
    }

    pub(super) fn pop(&self) -> Option<Arrival> {
        self.waiting().pop()
    }

    pub(super) fn keep_only(&self, topics: &BTreeSet<Topic>) {
        self.waiting().forget(|arrival| match arrival {
            Arrival::Update { update, .. } => {
                update.topic().is_none_or(|topic| !topics.contains(&topic))
            }
            Arrival::Reply { .. } | Arrival::Anew => false,
        });
    }

    pub(super) fn set_state(&self, state: ConnectionState) {
        *self.state.lock().unwrap_or_else(PoisonError::into_inner) = state;
        self.wake();
    }

    pub(super) fn role(&self) -> Option<Role> {
        let is_live = self.state() == ConnectionState::Live;
        is_live.then(|| *self.role.lock().unwrap_or_else(PoisonError::into_inner)).flatten()
    }

    pub(super) fn state(&self) -> ConnectionState {
        self.state.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn waiting(&self) -> MutexGuard<'_, Backlog<Arrival>> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn wake(&self) {
        if let Some(waker) = &self.waker {
            waker();
        }
    }
}

fn worth(arrival: &Arrival) -> Worth {
    match arrival {
        Arrival::Update { update, .. } => {
            retained_slot(update).map_or(Worth::Passing, Worth::Latest)
        }
        Arrival::Reply { .. } | Arrival::Anew => Worth::Kept,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Catalogue, Event, Update, source::Ticket};

    fn update(update: Update) -> Arrival {
        Arrival::Update { at: 0, update: Box::new(update) }
    }

    #[test]
    fn a_window_that_does_not_look_loses_data_but_no_reply() {
        let arrivals = Arrivals::new(None);
        arrivals.push(update(Update::Catalogue(Catalogue::default())), 1000);
        arrivals.push(Arrival::Reply { ticket: Ticket(1), result: Err("no".to_owned()) }, 0);
        for _ in 0..100 {
            arrivals.push(update(Update::Event(Event::default())), 1 << 20);
        }
        let all: Vec<_> = std::iter::from_fn(|| arrivals.pop()).collect();
        assert!(all.len() < 40, "{}", all.len());
        assert!(matches!(&all[0], Arrival::Update { .. }));
        assert!(matches!(&all[1], Arrival::Reply { ticket: Ticket(1), .. }));
    }

    #[test]
    fn a_new_run_and_other_topics_leave_no_old_messages() {
        let arrivals = Arrivals::new(None);
        arrivals.push(update(Update::Event(Event::default())), 10);
        arrivals.begin(Some(Role::Tuner));
        assert_eq!(arrivals.pop(), Some(Arrival::Anew));
        assert_eq!(arrivals.pop(), None);
        arrivals.push(update(Update::Event(Event::default())), 10);
        arrivals.keep_only(&BTreeSet::from([Topic::Log]));
        assert_eq!(arrivals.pop(), None);
        assert_eq!(arrivals.state(), ConnectionState::Live);
        assert_eq!(arrivals.role(), Some(Role::Tuner));
    }
}
