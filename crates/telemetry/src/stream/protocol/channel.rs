//! Channels: topics as the protocol numbers them.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::schema;
use crate::Topic;

/// A topic, as it is advertised.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Channel {
    pub id: u32,
    pub topic: String,
    /// Encoding of its messages: `protobuf`.
    pub encoding: String,
    /// Full name of the messages' type.
    pub schema_name: String,
    /// Descriptors of the messages' type, in base64.
    pub schema: String,
    /// Encoding of the schema: `protobuf`.
    #[serde(default)]
    pub schema_encoding: Option<String>,
}

impl Channel {
    fn of(topic: Topic, schema: String) -> Self {
        Self {
            id: channel_id(topic),
            topic: topic.to_string(),
            encoding: "protobuf".to_owned(),
            schema_name: topic.schema().to_owned(),
            schema,
            schema_encoding: Some("protobuf".to_owned()),
        }
    }
}

pub fn channels() -> Vec<Channel> {
    // Hundreds of channels share a dozen schemas.
    let mut schemas = BTreeMap::new();
    let mut channel = |topic: Topic| {
        let schema = schemas.entry(topic.schema()).or_insert_with(|| schema(topic));
        Channel::of(topic, schema.clone())
    };
    Topic::all().map(&mut channel).collect()
}

/// Returns the number of `topic`'s channel, from 1 on in the order of [`Topic::all`].
pub fn channel_id(topic: Topic) -> u32 {
    u32::try_from(place(topic) + 1).unwrap_or(0)
}

/// Returns the index of `topic` in [`Topic::all`]; one beyond its end if its key is unknown.
pub(crate) fn place(topic: Topic) -> usize {
    match topic {
        Topic::Block(key) => Topic::COMMON.len() + 2 * usize::from(key),
        Topic::State(key) => Topic::COMMON.len() + 2 * usize::from(key) + 1,
        Topic::Catalogue
        | Topic::Voices
        | Topic::Overview
        | Topic::Events
        | Topic::Ticks
        | Topic::Deadlines
        | Topic::Links
        | Topic::Midi
        | Topic::Log
        | Topic::Status => {
            let common = Topic::COMMON.into_iter().position(|other| other == topic);
            common.unwrap_or(usize::MAX - 1)
        }
    }
}

pub fn topic_of(id: u32) -> Option<Topic> {
    let place = usize::try_from(id).ok()?.checked_sub(1)?;
    Topic::all().nth(place)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_channel_s_number_leads_to_its_topic() {
        for topic in Topic::all() {
            assert_eq!(topic_of(channel_id(topic)), Some(topic));
        }
        for foreign in [0, 187, u32::MAX] {
            assert_eq!(topic_of(foreign), None, "{foreign}");
        }
    }

    #[test]
    fn all_channels_fit_into_the_message_size_that_clients_take() {
        // The usual limit of Python's `websockets` is 1 MiB.
        let text = serde_json::to_string(&channels()).expect("JSON");
        assert!(text.len() < 512 << 10, "{} bytes", text.len());
    }
}
