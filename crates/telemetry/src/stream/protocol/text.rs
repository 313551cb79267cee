//! JSON encoding of both sides' texts.

use serde::{Serialize, de::DeserializeOwned};

use super::{FromClient, FromServer, ProtocolError};

/// A text of the protocol: a JSON object with an `op`.
pub trait Text: Serialize + DeserializeOwned {
    /// Encodes the message as JSON; `None` for an `op` that is only read, as `Other`.
    fn encode(&self) -> Option<String> {
        serde_json::to_string(self).ok()
    }

    fn decode(text: &str) -> Result<Self, ProtocolError> {
        Ok(serde_json::from_str(text)?)
    }
}

impl Text for FromClient {}

impl Text for FromServer {}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn any_text_is_read_or_refused(text: String) {
            let _either = FromClient::decode(&text);
            let _either = FromServer::decode(&text);
        }
    }
}
