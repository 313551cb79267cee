//! From telemetry messages to the stream's clients.

use std::collections::BTreeMap;

use telemetry::stream::{ParameterSetting, Publisher};
use telemetry::{Topic, Update};

use super::current_voices::setting_of;
use crate::observe::MessageSink;

/// Publishes telemetry messages to the clients that follow their topics.
#[derive(Debug)]
pub struct StreamSink {
    publisher: Publisher,
    /// The values of each key's voice as they were published last.
    published: BTreeMap<u32, Vec<ParameterSetting>>,
    /// The number of followings at the last look.
    followings: u64,
}

impl StreamSink {
    /// Returns a sink that sends by `publisher`.
    pub const fn new(publisher: Publisher) -> Self {
        Self { publisher, published: BTreeMap::new(), followings: 0 }
    }

    /// Publishes the values that changed.
    fn publish_changed(&mut self, voice: &telemetry::Voice) {
        let values = values_of(voice);
        let before = self.published.get(&voice.key);
        let is_new =
            |value: &&ParameterSetting| before.is_none_or(|before| !before.contains(value));
        let changed: Vec<_> = values.iter().filter(is_new).cloned().collect();
        if !changed.is_empty() {
            self.publisher.parameters_changed(&changed);
        }
        self.published.insert(voice.key, values);
    }
}

impl MessageSink for StreamSink {
    fn take(&mut self, at: u64, update: &Update) {
        self.publisher.publish(at, update);
        if let Update::Voice(voice) = update {
            self.publish_changed(voice);
        }
    }

    fn wants(&self, topic: Topic) -> bool {
        // Clients that come later get these at once.
        matches!(topic, Topic::Catalogue | Topic::Voices) || self.publisher.is_followed(topic)
    }

    fn is_thinned(&self) -> bool {
        true
    }

    fn has_newcomers(&mut self) -> bool {
        let now = self.publisher.followings();
        std::mem::replace(&mut self.followings, now) != now
    }
}

/// Returns the values of a voice as parameters of the stream.
fn values_of(voice: &telemetry::Voice) -> Vec<ParameterSetting> {
    let Some(model) = models::catalogue::find(&voice.model) else { return Vec::new() };
    let key = u8::try_from(voice.key).unwrap_or(u8::MAX);
    let values = model.parameters.iter().zip(&voice.values);
    values.map(|(parameter, value)| setting_of(key, parameter.name, *value)).collect()
}
