//! Topics: names of messages on the stream, and their types.

use std::fmt;

use prost::Message as _;

use crate::{
    Catalogue, Deadlines, Event, KEYS, KeyBlock, KeyIndex, KeyState, Links, Log, Midi, Overview,
    Status, Ticks, Voice,
};

/// Name under which messages are sent.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Topic {
    Catalogue,
    Voices,
    Overview,
    Block(u8),
    /// One key, for viewers of single values.
    State(u8),
    Events,
    Ticks,
    Deadlines,
    Links,
    Midi,
    Log,
    Status,
}

impl Topic {
    /// Topics that are not of one key.
    pub const COMMON: [Self; 10] = [
        Self::Catalogue,
        Self::Voices,
        Self::Overview,
        Self::Events,
        Self::Ticks,
        Self::Deadlines,
        Self::Links,
        Self::Midi,
        Self::Log,
        Self::Status,
    ];

    /// Returns every topic, those of keys after the common ones.
    pub fn all() -> impl Iterator<Item = Self> {
        let keys = (0..=u8::MAX).take(KEYS);
        Self::COMMON.into_iter().chain(keys.flat_map(|key| [Self::Block(key), Self::State(key)]))
    }

    pub fn named(name: &str) -> Option<Self> {
        if let Some((key, kind)) = name.strip_prefix("/key/").and_then(|it| it.split_once('/')) {
            let key = key_number(key)?;
            return match kind {
                "block" => Some(Self::Block(key)),
                "state" => Some(Self::State(key)),
                _ => None,
            };
        }
        Self::COMMON.into_iter().find(|topic| topic.common_name() == Some(name))
    }

    const fn common_name(self) -> Option<&'static str> {
        match self {
            Self::Catalogue => Some("/catalogue"),
            Self::Voices => Some("/voices"),
            Self::Overview => Some("/keys/overview"),
            Self::Events => Some("/events"),
            Self::Ticks => Some("/ticks"),
            Self::Deadlines => Some("/deadlines"),
            Self::Links => Some("/links"),
            Self::Midi => Some("/midi"),
            Self::Log => Some("/log"),
            Self::Status => Some("/status"),
            Self::Block(_) | Self::State(_) => None,
        }
    }

    /// Returns the full name of its messages' type, which [`crate::DESCRIPTORS`] describe.
    pub const fn schema(self) -> &'static str {
        match self {
            Self::Catalogue => "letoff.telemetry.Catalogue",
            Self::Voices => "letoff.telemetry.Voice",
            Self::Overview => "letoff.telemetry.Overview",
            Self::Block(_) => "letoff.telemetry.KeyBlock",
            Self::State(_) => "letoff.telemetry.KeyState",
            Self::Events => "letoff.telemetry.Event",
            Self::Ticks => "letoff.telemetry.Ticks",
            Self::Deadlines => "letoff.telemetry.Deadlines",
            Self::Links => "letoff.telemetry.Links",
            Self::Midi => "letoff.telemetry.Midi",
            Self::Log => "letoff.telemetry.Log",
            Self::Status => "letoff.telemetry.Status",
        }
    }
}

impl fmt::Display for Topic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Block(key) => write!(f, "/key/{key}/block"),
            Self::State(key) => write!(f, "/key/{key}/state"),
            Self::Catalogue
            | Self::Voices
            | Self::Overview
            | Self::Events
            | Self::Ticks
            | Self::Deadlines
            | Self::Links
            | Self::Midi
            | Self::Log
            | Self::Status => f.write_str(self.common_name().unwrap_or_default()),
        }
    }
}

/// Parses the number of a key as topics write it: without a sign or leading zeros.
fn key_number(text: &str) -> Option<u8> {
    let is_plain = text.bytes().all(|byte| byte.is_ascii_digit());
    let has_zeros = text.len() > 1 && text.starts_with('0');
    let number = text.parse().ok().filter(|_| is_plain && !has_zeros)?;
    KeyIndex::new(number).map(KeyIndex::number)
}

/// Reason why bytes are no message of a topic.
#[derive(Debug, thiserror::Error)]
#[error("what came under {topic} is no {schema}: {cause}", schema = .topic.schema())]
pub struct TopicDecodeError {
    pub topic: Topic,
    pub cause: prost::DecodeError,
}

/// A message of any topic.
#[derive(Clone, PartialEq, Debug)]
pub enum Update {
    Catalogue(Catalogue),
    Voice(Voice),
    Overview(Overview),
    Block(KeyBlock),
    /// A state, which does not itself contain its key.
    State(u8, KeyState),
    Event(Event),
    Ticks(Ticks),
    Deadlines(Deadlines),
    Links(Links),
    Midi(Midi),
    Log(Log),
    Status(Status),
}

impl Update {
    pub fn topic(&self) -> Option<Topic> {
        let is_key = |key: u8| usize::from(key) < KEYS;
        match self {
            Self::Catalogue(_) => Some(Topic::Catalogue),
            Self::Voice(_) => Some(Topic::Voices),
            Self::Overview(_) => Some(Topic::Overview),
            Self::Block(block) => {
                u8::try_from(block.key).ok().filter(|key| is_key(*key)).map(Topic::Block)
            }
            Self::State(key, _) => is_key(*key).then_some(Topic::State(*key)),
            Self::Event(_) => Some(Topic::Events),
            Self::Ticks(_) => Some(Topic::Ticks),
            Self::Deadlines(_) => Some(Topic::Deadlines),
            Self::Links(_) => Some(Topic::Links),
            Self::Midi(_) => Some(Topic::Midi),
            Self::Log(_) => Some(Topic::Log),
            Self::Status(_) => Some(Topic::Status),
        }
    }

    pub fn encode(&self) -> Vec<u8> {
        match self {
            Self::Catalogue(it) => it.encode_to_vec(),
            Self::Voice(it) => it.encode_to_vec(),
            Self::Overview(it) => it.encode_to_vec(),
            Self::Block(it) => it.encode_to_vec(),
            Self::State(_, it) => it.encode_to_vec(),
            Self::Event(it) => it.encode_to_vec(),
            Self::Ticks(it) => it.encode_to_vec(),
            Self::Deadlines(it) => it.encode_to_vec(),
            Self::Links(it) => it.encode_to_vec(),
            Self::Midi(it) => it.encode_to_vec(),
            Self::Log(it) => it.encode_to_vec(),
            Self::Status(it) => it.encode_to_vec(),
        }
    }

    pub fn decode(topic: Topic, bytes: &[u8]) -> Result<Self, TopicDecodeError> {
        let decoded = match topic {
            Topic::Catalogue => Catalogue::decode(bytes).map(Self::Catalogue),
            Topic::Voices => Voice::decode(bytes).map(Self::Voice),
            Topic::Overview => Overview::decode(bytes).map(Self::Overview),
            // The topic determines the key, whatever the message contains.
            Topic::Block(key) => KeyBlock::decode(bytes)
                .map(|block| Self::Block(KeyBlock { key: key.into(), ..block })),
            Topic::State(key) => KeyState::decode(bytes).map(|state| Self::State(key, state)),
            Topic::Events => Event::decode(bytes).map(Self::Event),
            Topic::Ticks => Ticks::decode(bytes).map(Self::Ticks),
            Topic::Deadlines => Deadlines::decode(bytes).map(Self::Deadlines),
            Topic::Links => Links::decode(bytes).map(Self::Links),
            Topic::Midi => Midi::decode(bytes).map(Self::Midi),
            Topic::Log => Log::decode(bytes).map(Self::Log),
            Topic::Status => Status::decode(bytes).map(Self::Status),
        };
        decoded.map_err(|cause| TopicDecodeError { topic, cause })
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_topic_is_found_by_its_name() {
        let names: BTreeSet<_> = Topic::all().map(|topic| topic.to_string()).collect();
        assert_eq!(names.len(), Topic::COMMON.len() + 2 * KEYS);
        for topic in Topic::all() {
            assert_eq!(Topic::named(&topic.to_string()), Some(topic));
        }
        for foreign in
            ["", "/key/88/block", "/key/-1/block", "/key/07/block", "/voices ", "/key/+7/block"]
        {
            assert_eq!(Topic::named(foreign), None, "{foreign}");
        }
    }

    #[test]
    fn foreign_bytes_are_refused_in_a_sentence() {
        let refused = Update::decode(Topic::Events, &[0xff; 9]).expect_err("no event").to_string();
        assert!(refused.starts_with("what came under /events is no letoff.telemetry.Event: "));
    }
}
