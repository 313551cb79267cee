//! Access to the hub from any thread.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use tokio::sync::{Notify, mpsc, mpsc::error::TrySendError, oneshot};

use super::{following::Following, outbox::Outbox, sample::StreamSample};
use crate::stream::protocol::{ParameterValue, Subscription};
use crate::{Topic, Update};

/// Most messages that wait for the runtime; further ones are dropped, and counted.
const QUEUE: usize = 4096;

pub(super) type ClientNumber = u64;

#[derive(Debug)]
pub(super) enum HubCommand {
    Join(ClientNumber, Arc<Outbox>),
    Leave(ClientNumber),
    Subscribe(ClientNumber, Vec<Subscription>),
    Unsubscribe(ClientNumber, Vec<u32>),
    Watch(ClientNumber, Vec<String>),
    Unwatch(ClientNumber, Vec<String>),
    Changed(Vec<ParameterValue>),
    /// All samples so far are to be distributed, and then this answered.
    Flush(oneshot::Sender<()>),
}

#[derive(Debug)]
pub(super) struct HubHandle {
    pub(super) following: Following,
    /// Samples that must not be dropped and found no room, by slot, until the hub takes them.
    retained: Mutex<BTreeMap<u16, StreamSample>>,
    order: AtomicU64,
    pub(super) log_lines: AtomicU64,
    /// Notified when a sample was put aside.
    pub(super) is_retained: Notify,
    samples: mpsc::Sender<StreamSample>,
    commands: mpsc::UnboundedSender<HubCommand>,
    pub(super) lost: AtomicU64,
}

#[derive(Debug)]
pub(super) struct HubReceivers {
    pub(super) samples: mpsc::Receiver<StreamSample>,
    pub(super) commands: mpsc::UnboundedReceiver<HubCommand>,
}

impl HubHandle {
    pub(super) fn channel() -> (Arc<Self>, HubReceivers) {
        let (sender, samples) = mpsc::channel(QUEUE);
        let (commands, received) = mpsc::unbounded_channel();
        let handle = Self {
            following: Following::default(),
            retained: Mutex::default(),
            order: AtomicU64::new(0),
            log_lines: AtomicU64::new(0),
            is_retained: Notify::new(),
            samples: sender,
            commands,
            lost: AtomicU64::new(0),
        };
        (Arc::new(handle), HubReceivers { samples, commands: received })
    }

    /// Sends `update` from `at` (ns since 1970), which replaces earlier ones in `slot`.
    pub(super) fn send_retained(&self, topic: Topic, at: u64, update: &Update, slot: u16) {
        let order = self.order.fetch_add(1, Ordering::Relaxed);
        self.send(StreamSample::new(topic, at, update).retained(slot, order));
    }

    /// Keeps a sample without room in the queue if it must not be dropped.
    fn put_aside(&self, sample: StreamSample) {
        let Some((slot, _)) = sample.retained else {
            self.lost.fetch_add(1, Ordering::Relaxed);
            return;
        };
        // Locked only to insert or remove, never while anything is sent.
        self.retained.lock().unwrap_or_else(PoisonError::into_inner).insert(slot, sample);
        self.is_retained.notify_one();
    }

    pub(super) fn take_retained(&self) -> BTreeMap<u16, StreamSample> {
        std::mem::take(&mut *self.retained.lock().unwrap_or_else(PoisonError::into_inner))
    }

    pub(super) fn send(&self, sample: StreamSample) {
        match self.samples.try_send(sample) {
            Ok(()) => {}
            Err(TrySendError::Full(sample) | TrySendError::Closed(sample)) => {
                self.put_aside(sample);
            }
        }
    }

    pub(super) fn command(&self, command: HubCommand) {
        // Without a hub there are no clients.
        let _no_hub = self.commands.send(command);
    }
}
