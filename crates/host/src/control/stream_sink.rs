use std::collections::BTreeMap;

use telemetry::stream::{ParameterSetting, Publisher};
use telemetry::{Catalogue, Topic, Update};

use super::current_voices::setting_of;
use crate::observe::MessageSink;

/// A sink that publishes telemetry to the clients that follow its topics.
#[derive(Debug)]
pub struct StreamSink {
    publisher: Publisher,
    /// Parameter names of each model that may play, by its name and version.
    parameters: BTreeMap<(String, u32), Vec<String>>,
    published: BTreeMap<u32, Vec<ParameterSetting>>,
    followings: u64,
}

impl StreamSink {
    pub const fn new(publisher: Publisher) -> Self {
        let parameters = BTreeMap::new();
        Self { publisher, parameters, published: BTreeMap::new(), followings: 0 }
    }

    fn publish_changed(&mut self, voice: &telemetry::Voice) {
        let values = self.values_of(voice);
        let before = self.published.get(&voice.key);
        let is_new =
            |value: &&ParameterSetting| before.is_none_or(|before| !before.contains(value));
        let changed: Vec<_> = values.iter().filter(is_new).cloned().collect();
        if !changed.is_empty() {
            self.publisher.parameters_changed(&changed);
        }
        self.published.insert(voice.key, values);
    }

    fn values_of(&self, voice: &telemetry::Voice) -> Vec<ParameterSetting> {
        let model = (voice.model.clone(), voice.version);
        let Some(parameters) = self.parameters.get(&model) else { return Vec::new() };
        let key = u8::try_from(voice.key).unwrap_or(u8::MAX);
        let values = parameters.iter().zip(&voice.values);
        values.map(|(parameter, value)| setting_of(key, parameter, *value)).collect()
    }

    fn note_models(&mut self, catalogue: &Catalogue) {
        for model in &catalogue.models {
            let names = model.parameters.iter().map(|it| it.name.clone()).collect();
            self.parameters.insert((model.name.clone(), model.version), names);
        }
    }
}

impl MessageSink for StreamSink {
    fn take(&mut self, at: u64, update: &Update) {
        // The host's log publishes its own lines.
        if !matches!(update, Update::Log(_)) {
            self.publisher.publish(at, update);
        }
        if let Update::Catalogue(catalogue) = update {
            self.note_models(catalogue);
        } else if let Update::Voice(voice) = update {
            self.publish_changed(voice);
        }
    }

    fn wants(&self, topic: Topic) -> bool {
        // Clients that connect later get these at once.
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
