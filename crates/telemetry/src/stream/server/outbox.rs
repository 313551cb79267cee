//! Messages that wait for a client: a queue that is never dropped, and one that may lose samples.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use tokio::sync::{Notify, mpsc};
use tokio_tungstenite::tungstenite::Message;

use super::{ServerLimits, sample::StreamSample};
use crate::stream::backlog::{Backlog, Worth};
use crate::stream::protocol::{FromServer, Level, ServerFrame, Text as _};

#[derive(Debug)]
pub(super) struct Outbox {
    control: mpsc::Sender<Message>,
    control_bytes: AtomicUsize,
    most_control_bytes: usize,
    data: Mutex<Backlog<QueuedSample>>,
    is_data: Notify,
    is_cut: Notify,
    is_finished: AtomicBool,
    finishes: Notify,
}

#[derive(Debug)]
struct QueuedSample {
    subscription: u32,
    sample: StreamSample,
}

impl Outbox {
    pub(super) fn new(limits: &ServerLimits) -> (Self, mpsc::Receiver<Message>) {
        let (control, receiver) = mpsc::channel(limits.control_messages.max(1));
        let outbox = Self {
            control,
            control_bytes: AtomicUsize::new(0),
            most_control_bytes: limits.control_bytes,
            data: Mutex::new(Backlog::new(limits.data_bytes)),
            is_data: Notify::new(),
            is_cut: Notify::new(),
            is_finished: AtomicBool::new(false),
            finishes: Notify::new(),
        };
        (outbox, receiver)
    }

    /// Adds a text; a client without room for it is cut.
    pub(super) fn tell(&self, message: &FromServer) {
        if let Some(text) = message.encode() {
            self.send(Message::text(text));
        }
    }

    /// Adds a sentence for people; a rejection has the request's own name as `id`.
    pub(super) fn status(&self, level: Level, message: String, id: Option<String>) {
        self.tell(&FromServer::Status { level, message, id });
    }

    /// Adds a message; a client without room for it is cut.
    pub(super) fn send(&self, message: Message) {
        let before = self.control_bytes.fetch_add(message.len(), Ordering::Relaxed);
        if before > self.most_control_bytes || self.control.try_send(message).is_err() {
            self.is_cut.notify_one();
        }
    }

    pub(super) fn taken(&self, message: &Message) {
        self.control_bytes.fetch_sub(message.len(), Ordering::Relaxed);
    }

    pub(super) fn finish(&self) {
        self.is_finished.store(true, Ordering::Release);
        self.finishes.notify_one();
    }

    pub(super) async fn finished(&self) {
        while !self.is_finished.load(Ordering::Acquire) {
            self.finishes.notified().await;
        }
    }

    pub(super) async fn cut(&self) {
        self.is_cut.notified().await;
    }

    /// Adds a sample; the oldest are dropped if there is no room.
    pub(super) fn post(&self, subscription: u32, sample: StreamSample) {
        let worth = sample.retained.map_or(Worth::Passing, |(slot, _)| Worth::Latest(slot));
        let bytes = sample.payload.len();
        self.with_data(|data| data.push(QueuedSample { subscription, sample }, worth, bytes));
        self.is_data.notify_one();
    }

    pub(super) fn forget(&self, subscription: u32) {
        self.with_data(|data| data.forget(|queued| queued.subscription == subscription));
    }

    pub(super) async fn sample(&self) -> Message {
        loop {
            if let Some(queued) = self.with_data(Backlog::pop) {
                return queued.into_message();
            }
            self.is_data.notified().await;
        }
    }

    pub(super) fn take_dropped(&self) -> u64 {
        self.with_data(Backlog::take_dropped)
    }

    fn with_data<T>(&self, work: impl FnOnce(&mut Backlog<QueuedSample>) -> T) -> T {
        work(&mut self.data.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl QueuedSample {
    fn into_message(self) -> Message {
        let Self { subscription, sample } = self;
        let frame = ServerFrame::Message { subscription, at: sample.at, payload: &sample.payload };
        Message::binary(frame.encode())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn few_replies_that_are_long_are_too_many_as_well() {
        let limits = ServerLimits { control_bytes: 1000, ..ServerLimits::default() };
        let (outbox, mut control) = Outbox::new(&limits);
        for _ in 0..5 {
            outbox.status(Level::Info, "x".repeat(900), None);
            let message = control.recv().await.expect("it is there");
            outbox.taken(&message);
        }
        for _ in 0..3 {
            outbox.status(Level::Info, "x".repeat(900), None);
        }
        outbox.cut().await;
    }
}
