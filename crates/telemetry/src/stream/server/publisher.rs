//! Where the host hands in its messages.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use tokio::sync::mpsc::error::TrySendError;
use tokio::sync::{Notify, mpsc};

use super::ParameterSetting;
use super::following::Following;
use super::hub::{Hub, HubCommand};
use super::sample::StreamSample;
use crate::stream::latch::latch;
use crate::stream::protocol::ParameterValue;
use crate::{Topic, Update};

/// Messages that wait for the runtime; more are dropped, and counted.
const FEED: usize = 4096;

/// Where the host hands in its messages, from any thread.
#[derive(Clone, Debug)]
pub struct Publisher(Arc<HubHandle>);

/// What publishers and the hub share.
#[derive(Debug)]
pub(super) struct HubHandle {
    pub(super) following: Following,
    /// Of those that every client gets the latest that found no room, until the hub takes them.
    latched: Mutex<BTreeMap<u16, StreamSample>>,
    order: AtomicU64,
    /// That there is something in it.
    pub(super) is_latched: Notify,
    feed: mpsc::Sender<StreamSample>,
    commands: mpsc::UnboundedSender<HubCommand>,
    lost: AtomicU64,
}

/// Both ends.
pub(super) fn pair() -> (Publisher, Hub) {
    let (feed, samples) = mpsc::channel(FEED);
    let (sender, commands) = mpsc::unbounded_channel();
    let desk = Arc::new(HubHandle {
        following: Following::default(),
        latched: Mutex::default(),
        order: AtomicU64::new(0),
        is_latched: Notify::new(),
        feed,
        commands: sender,
        lost: AtomicU64::new(0),
    });
    (Publisher(Arc::clone(&desk)), Hub::new(desk, samples, commands))
}

impl Publisher {
    /// Sends `update`, made at `at` (ns since 1970), to whom it may concern.
    ///
    /// It waits for no client: what nobody follows is not even encoded, and what the runtime has no
    /// time for is dropped and counted.
    /// The last catalogue and the last voice of each key are kept for those who come later.
    pub fn publish(&self, at: u64, update: &Update) {
        let Some(topic) = update.topic() else { return };
        if let Some(number) = latch(update) {
            let order = self.0.order.fetch_add(1, Ordering::Relaxed);
            self.0.feed(StreamSample::new(topic, at, update).latched(number, order));
        } else if self.is_followed(topic) {
            self.0.feed(StreamSample::new(topic, at, update));
        }
    }

    /// Whether anybody follows `topic`; if not, its messages need not be made.
    ///
    /// Those of [`Topic::Catalogue`] and [`Topic::Voices`] are to be published nevertheless.
    pub fn is_followed(&self, topic: Topic) -> bool {
        self.0.following.has(topic)
    }

    /// How often somebody began to follow a topic, since the start: when this changes, somebody is
    /// there who does not know how the keys are that have not moved since.
    pub fn followings(&self) -> u64 {
        self.0.following.begun()
    }

    /// Keys of which somebody follows blocks or states: bit n is key n.
    pub fn followed_blocks(&self) -> u128 {
        self.0.following.keys()
    }

    /// Tells those who want to know that parameters have these values now.
    pub fn parameters_changed(&self, values: &[ParameterSetting]) {
        let parameters: Vec<_> =
            values.iter().map(|it| ParameterValue::new(it.name.clone(), it.value)).collect();
        self.0.command(HubCommand::Changed(parameters));
    }

    /// Messages that the runtime had no time for, since the start.
    pub fn lost(&self) -> u64 {
        self.0.lost.load(Ordering::Relaxed)
    }

    /// Tells the hub something.
    pub(super) fn command(&self, command: HubCommand) {
        self.0.command(command);
    }
}

impl HubHandle {
    /// Of those that must not be dropped the latest is put aside.
    fn put_aside(&self, sample: StreamSample) {
        let Some((number, _)) = sample.latch else {
            self.lost.fetch_add(1, Ordering::Relaxed);
            return;
        };
        // Held only to put in or to take out, never while anything is sent.
        self.latched.lock().unwrap_or_else(PoisonError::into_inner).insert(number, sample);
        self.is_latched.notify_one();
    }

    /// What was put aside since this was last asked.
    pub(super) fn take_latched(&self) -> BTreeMap<u16, StreamSample> {
        std::mem::take(&mut *self.latched.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn feed(&self, sample: StreamSample) {
        match self.feed.try_send(sample) {
            Ok(()) => {}
            Err(TrySendError::Full(sample) | TrySendError::Closed(sample)) => {
                self.put_aside(sample);
            }
        }
    }

    fn command(&self, command: HubCommand) {
        // Without a hub there are no clients whom it could concern.
        let _nobody = self.commands.send(command);
    }
}
