use std::sync::{Arc, atomic::Ordering};

use tokio::sync::oneshot;

use super::hub_handle::{HubCommand, HubHandle};
use super::{ParameterSetting, sample::StreamSample};
use crate::stream::retained::{log_slot, retained_slot};
use crate::{Topic, Update, stream::protocol::ParameterValue};

/// Access of the host to the stream, from any thread.
#[derive(Clone, Debug)]
pub struct Publisher(Arc<HubHandle>);

impl Publisher {
    pub(super) const fn new(handle: Arc<HubHandle>) -> Self {
        Self(handle)
    }

    /// Sends `update`, made at `at` (ns since 1970), to the clients that follow its topic.
    ///
    /// It waits for no client. A message without followers is not encoded, and one for which the
    /// runtime has no time is dropped and counted. The last catalogue, status and voice of each
    /// key, and the last 100 log lines, are kept for clients that connect later.
    pub fn publish(&self, at: u64, update: &Update) {
        let Some(topic) = update.topic() else { return };
        if matches!(update, Update::Log(_)) {
            let number = self.0.log_lines.fetch_add(1, Ordering::Relaxed);
            self.0.send_retained(topic, at, update, log_slot(number));
        } else if let Some(slot) = retained_slot(update) {
            self.0.send_retained(topic, at, update, slot);
        } else if self.is_followed(topic) {
            self.0.send(StreamSample::new(topic, at, update));
        }
    }

    /// Returns `true` if a client follows `topic`; if not, its messages are not needed, except
    /// those of [`Topic::Catalogue`], [`Topic::Voices`], [`Topic::Status`] and [`Topic::Log`].
    pub fn is_followed(&self, topic: Topic) -> bool {
        self.0.following.has(topic)
    }

    /// Returns the number of subscriptions so far. When it changes, a client lacks resting keys.
    pub fn followings(&self) -> u64 {
        self.0.following.begun()
    }

    /// Returns the keys whose blocks or states a client follows: bit n is key n.
    pub fn followed_blocks(&self) -> u128 {
        self.0.following.keys()
    }

    pub fn parameters_changed(&self, values: &[ParameterSetting]) {
        let parameters: Vec<_> =
            values.iter().map(|it| ParameterValue::new(it.name.clone(), it.value)).collect();
        self.0.command(HubCommand::Changed(parameters));
    }

    /// Waits until the messages so far are in the queues of the clients that follow them.
    pub async fn flush(&self) {
        let (done, flushed) = oneshot::channel();
        self.command(HubCommand::Flush(done));
        let _no_hub = flushed.await;
    }

    /// Returns the number of messages for which the runtime had no time, since the start.
    pub fn lost(&self) -> u64 {
        self.0.lost.load(Ordering::Relaxed)
    }

    pub(super) fn command(&self, command: HubCommand) {
        self.0.command(command);
    }
}
