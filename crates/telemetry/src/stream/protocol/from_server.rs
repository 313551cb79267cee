use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::{AdvertisedService, Channel, ParameterValue};
use crate::Reply;

/// A text from a server.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(tag = "op", rename_all = "camelCase", rename_all_fields = "camelCase")]
pub enum FromServer {
    /// Name and capabilities of the server; the first message.
    ServerInfo {
        name: String,
        #[serde(default)]
        capabilities: Vec<String>,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        supported_encodings: Option<Vec<String>>,
        /// Further facts by name.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        metadata: Option<BTreeMap<String, String>>,
        /// Changes with each run.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        session_id: Option<String>,
    },
    /// A sentence for people.
    Status {
        level: Level,
        message: String,
        /// The request's own name, in a rejection.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        id: Option<String>,
    },
    /// Channels that can be followed.
    Advertise { channels: Vec<Channel> },
    /// Channels that no longer exist.
    Unadvertise { channel_ids: Vec<u32> },
    ParameterValues {
        parameters: Vec<ParameterValue>,
        /// The request's own name, if this is an answer.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        /// Result of the request; our extension, which others ignore.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        reply: Option<Reply>,
    },
    /// Services that can be called.
    AdvertiseServices { services: Vec<AdvertisedService> },
    /// Services that no longer exist.
    UnadvertiseServices { service_ids: Vec<u32> },
    /// A call was rejected.
    ServiceCallFailure {
        service_id: u32,
        /// Call, by the client's own number.
        call_id: u32,
        message: String,
    },
    /// A message that this client does not need.
    #[serde(other, skip_serializing)]
    Other,
}

/// Severity of a status.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
#[serde(into = "u8", from = "u8")]
pub enum Level {
    Info,
    Warning,
    Error,
}

impl From<Level> for u8 {
    fn from(level: Level) -> Self {
        match level {
            Level::Info => 0,
            Level::Warning => 1,
            Level::Error => 2,
        }
    }
}

impl From<u8> for Level {
    /// Treats an unknown higher level as an error.
    fn from(number: u8) -> Self {
        match number {
            0 => Self::Info,
            1 => Self::Warning,
            2.. => Self::Error,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stream::protocol::Text as _;

    #[track_caller]
    fn check(message: &FromServer, text: &str) {
        assert_eq!(message.encode().as_deref(), Some(text));
        assert_eq!(&FromServer::decode(text).expect("a message"), message);
    }

    #[test]
    fn texts_are_as_the_protocol_says() {
        check(
            &FromServer::Status { level: Level::Error, message: "no".to_owned(), id: None },
            r#"{"op":"status","level":2,"message":"no"}"#,
        );
        check(
            &FromServer::ParameterValues {
                parameters: vec![ParameterValue::new("/key/39/k2", 1.0)],
                id: Some("x".to_owned()),
                reply: None,
            },
            r#"{"op":"parameterValues","parameters":[{"name":"/key/39/k2","value":1.0,"type":"float64"}],"id":"x"}"#,
        );
        check(
            &FromServer::ServiceCallFailure { service_id: 1, call_id: 2, message: "no".to_owned() },
            r#"{"op":"serviceCallFailure","serviceId":1,"callId":2,"message":"no"}"#,
        );
        check(
            &FromServer::Unadvertise { channel_ids: vec![3] },
            r#"{"op":"unadvertise","channelIds":[3]}"#,
        );
    }

    #[test]
    fn another_server_s_information_is_read() {
        let text = r#"{"op":"serverInfo","name":"x","capabilities":["time"],"new":{}}"#;
        assert!(matches!(FromServer::decode(text), Ok(FromServer::ServerInfo { .. })));
        let text = r#"{"op":"connectionGraphUpdate","publishedTopics":[]}"#;
        assert!(matches!(FromServer::decode(text), Ok(FromServer::Other)));
    }
}
