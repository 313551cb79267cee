//! A link that is reopened when it goes down, as after a cable was unplugged and replugged. A
//! separate thread opens and closes; the tick only polls a ring.

use std::sync::atomic::{AtomicBool, Ordering};
use std::{sync::Arc, time::Duration};

use rtrb::{Consumer, Producer, RingBuffer};

use super::{Health, Link, RecvError, SendError};
use crate::links::{Error, pause};

type AnyLink = Box<dyn Link + Send>;

const RETRY: Duration = Duration::from_millis(200);

/// A link that is reopened when it goes down.
pub struct ReconnectingLink {
    link: Option<AnyLink>,
    opened: Consumer<AnyLink>,
    /// Links that went down, on their way to be closed.
    closed: Producer<AnyLink>,
    shared: Arc<ReconnectState>,
    /// Condition and counts of the earlier links.
    before: Health,
    reopened: u64,
}

#[derive(Debug, Default)]
struct ReconnectState {
    wanted: AtomicBool,
    over: AtomicBool,
}

impl std::fmt::Debug for ReconnectingLink {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ReconnectingLink")
            .field("is_up", &self.link.is_some())
            .finish_non_exhaustive()
    }
}

impl ReconnectingLink {
    /// Opens a link by `open`, now and whenever it has gone down.
    ///
    /// # Errors
    /// If the first opening fails, or the system has no thread left.
    pub fn open(open: impl Fn() -> Result<AnyLink, Error> + Send + 'static) -> Result<Self, Error> {
        let link = Some(open()?);
        let (newly, opened) = RingBuffer::new(1);
        let (closed, lately) = RingBuffer::new(2);
        let shared = Arc::<ReconnectState>::default();
        let its_shared = Arc::clone(&shared);
        let thread = std::thread::Builder::new().name("letoff-open".into());
        thread.spawn(move || attend(&open, newly, lately, &its_shared)).map_err(Error::Thread)?;
        Ok(Self { link, opened, closed, shared, before: Health::default(), reopened: 0 })
    }

    pub const fn reopened(&self) -> u64 {
        self.reopened
    }

    fn current(&mut self) -> Option<&mut AnyLink> {
        if self.link.is_none()
            && let Ok(link) = self.opened.pop()
        {
            self.link = Some(link);
            self.reopened += 1;
        }
        self.link.as_mut()
    }

    /// Hands a link that is down to the closing thread, and requests another.
    fn lose(&mut self) {
        let Some(link) = self.link.take() else { return };
        let before = added(self.before, link.health());
        match self.closed.push(link) {
            Ok(()) => {
                self.before = before;
                self.shared.wanted.store(true, Ordering::Release);
            }
            // The closing thread is behind: try again later.
            Err(rtrb::PushError::Full(link)) => self.link = Some(link),
        }
    }
}

impl Drop for ReconnectingLink {
    fn drop(&mut self) {
        self.shared.over.store(true, Ordering::Release);
    }
}

/// # Real-time
/// One poll of a ring, beside the link itself.
impl Link for ReconnectingLink {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        let sent = self.current().map_or(Err(SendError::Down), |link| link.try_send(frame));
        if sent == Err(SendError::Down) {
            self.lose();
        }
        sent
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        let received = self.current().map_or(Err(RecvError::Down), |link| link.try_recv(buffer));
        if received == Err(RecvError::Down) {
            self.lose();
        }
        received
    }

    fn health(&self) -> Health {
        let health = self.link.as_ref().map_or(self.before, |it| added(self.before, it.health()));
        Health { restarts: health.restarts + self.reopened, ..health }
    }
}

/// Returns the condition of a link, with the counts of those before it.
fn added(before: Health, now: Health) -> Health {
    Health {
        reports: before.reports + now.reports,
        restarts: before.restarts + now.restarts,
        dropped: before.dropped + now.dropped,
        ..now
    }
}

/// Closes links that went down, and opens new ones, until the owner is gone.
fn attend(
    open: &impl Fn() -> Result<AnyLink, Error>,
    mut newly: Producer<AnyLink>,
    mut lately: Consumer<AnyLink>,
    shared: &ReconnectState,
) {
    while !shared.over.load(Ordering::Acquire) {
        while let Ok(link) = lately.pop() {
            drop(link);
        }
        if shared.wanted.load(Ordering::Acquire)
            && let Ok(link) = open()
        {
            shared.wanted.store(false, Ordering::Release);
            // There is room: only one link is wanted at a time.
            let _room = newly.push(link);
        }
        pause(RETRY);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::AtomicU32;

    struct Brief(u32);

    impl Link for Brief {
        fn try_send(&mut self, _frame: &[u8]) -> Result<(), SendError> {
            self.0 = self.0.checked_sub(1).ok_or(SendError::Down)?;
            Ok(())
        }

        fn try_recv(&mut self, _buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
            Ok(None)
        }

        fn health(&self) -> Health {
            Health { reports: 3, restarts: 1, dropped: 2, ..Health::default() }
        }
    }

    #[test]
    fn a_link_that_goes_down_is_opened_again_as_soon_as_that_is_possible() {
        let attempts = Arc::new(AtomicU32::new(0));
        let its_attempts = Arc::clone(&attempts);
        let open = move || {
            let attempt = its_attempts.fetch_add(1, Ordering::Relaxed);
            if attempt == 1 {
                Err(Error::Pty(std::io::ErrorKind::NotFound.into()))
            } else {
                Ok(Box::new(Brief(2)) as AnyLink)
            }
        };
        let mut link = ReconnectingLink::open(open).unwrap();
        assert_eq!([(); 3].map(|()| link.try_send(b"x").is_ok()), [true, true, false]);
        let mut sent = 0;
        for _ in 0..1_000 {
            sent += u32::from(link.try_send(b"x").is_ok());
            if sent == 2 {
                break;
            }
            pause(Duration::from_millis(5));
        }
        assert_eq!((sent, link.reopened(), attempts.load(Ordering::Relaxed)), (2, 1, 3));
        let Health { reports, restarts, dropped, .. } = link.health();
        assert_eq!((reports, restarts, dropped), (6, 3, 4), "of both, and opened again once");
    }
}
