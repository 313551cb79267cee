//! The host's way to hand in messages.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use super::ParameterSetting;
use super::hub_handle::{HubCommand, HubHandle};
use super::sample::StreamSample;
use crate::stream::protocol::ParameterValue;
use crate::stream::retained::retained_slot;
use crate::{Topic, Update};

/// The host's way to hand in messages, from any thread.
#[derive(Clone, Debug)]
pub struct Publisher(Arc<HubHandle>);

impl Publisher {
    /// Creates a publisher to the hub of `handle`.
    pub(super) const fn new(handle: Arc<HubHandle>) -> Self {
        Self(handle)
    }

    /// Sends `update`, made at `at` (ns since 1970), to the clients that follow its topic.
    ///
    /// It waits for no client: a message that no client follows is not encoded, and one for which
    /// the runtime has no time is dropped and counted.
    /// The last catalogue and the last voice of each key are kept for clients that come later.
    pub fn publish(&self, at: u64, update: &Update) {
        let Some(topic) = update.topic() else { return };
        if let Some(slot) = retained_slot(update) {
            self.0.send_retained(topic, at, update, slot);
        } else if self.is_followed(topic) {
            self.0.send(StreamSample::new(topic, at, update));
        }
    }

    /// Returns whether a client follows `topic`; if not, its messages need not be made.
    ///
    /// Those of [`Topic::Catalogue`] and [`Topic::Voices`] are to be published nevertheless.
    pub fn is_followed(&self, topic: Topic) -> bool {
        self.0.following.has(topic)
    }

    /// Returns how often a client began to follow a topic, since the start.
    ///
    /// When this changes, a client does not know the keys that have not moved since.
    pub fn followings(&self) -> u64 {
        self.0.following.begun()
    }

    /// Returns the keys whose blocks or states a client follows: bit n is key n.
    pub fn followed_blocks(&self) -> u128 {
        self.0.following.keys()
    }

    /// Sends new values of parameters to the clients that follow them.
    pub fn parameters_changed(&self, values: &[ParameterSetting]) {
        let parameters: Vec<_> =
            values.iter().map(|it| ParameterValue::new(it.name.clone(), it.value)).collect();
        self.0.command(HubCommand::Changed(parameters));
    }

    /// Returns how many messages the runtime had no time for, since the start.
    pub fn lost(&self) -> u64 {
        self.0.lost.load(Ordering::Relaxed)
    }

    /// Sends a command to the hub.
    pub(super) fn command(&self, command: HubCommand) {
        self.0.command(command);
    }
}
