use serde::{Deserialize, Serialize};

use super::ParameterValue;

/// A text from a client.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(tag = "op", rename_all = "camelCase", rename_all_fields = "camelCase")]
pub enum FromClient {
    /// Subscribes to messages of channels.
    Subscribe { subscriptions: Vec<Subscription> },
    /// Ends the subscriptions with these numbers.
    Unsubscribe { subscription_ids: Vec<u32> },
    /// Asks for parameters' values.
    GetParameters {
        /// Names of parameters; all if empty.
        parameter_names: Vec<String>,
        /// Name of the answer, chosen by the client.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        id: Option<String>,
    },
    /// Sets parameters: all of them or none.
    SetParameters {
        parameters: Vec<ParameterValue>,
        /// Name of the answer, chosen by the client.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        id: Option<String>,
    },
    /// Follows changes of values.
    SubscribeParameterUpdates {
        /// Names of parameters; all if empty.
        parameter_names: Vec<String>,
    },
    /// Stops following changes of values.
    UnsubscribeParameterUpdates {
        /// Names of parameters; all if empty.
        parameter_names: Vec<String>,
    },
    /// An operation that this server never offered.
    #[serde(other, skip_serializing)]
    Other,
}

/// Subscription of a client to a channel.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Subscription {
    /// The client's own number for it.
    pub id: u32,
    pub channel_id: u32,
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::stream::protocol::Text as _;

    #[test]
    fn texts_are_as_the_protocol_says() {
        let text = r#"{"op":"subscribe","subscriptions":[{"id":1,"channelId":2}]}"#;
        let subscriptions = vec![Subscription { id: 1, channel_id: 2 }];
        let message = FromClient::Subscribe { subscriptions };
        assert_eq!(message.encode().as_deref(), Some(text));
        assert_eq!(FromClient::decode(text).expect("a message"), message);
        let text = r#"{"op":"getParameters","parameterNames":[],"id":"x"}"#;
        let message =
            FromClient::GetParameters { parameter_names: vec![], id: Some("x".to_owned()) };
        assert_eq!(FromClient::decode(text).expect("a message"), message);
    }

    #[test]
    fn an_op_that_is_not_known_is_no_mistake_of_the_text() {
        let text = r#"{"op":"fetchAsset","uri":"package://x"}"#;
        assert_eq!(FromClient::decode(text).expect("a message"), FromClient::Other);
    }

    #[test]
    fn what_is_none_is_refused() {
        let nan = r#"{"op":"setParameters","parameters":[{"name":"/key/39/k2","value":NaN}]}"#;
        let huge = nan.replace("NaN", "1e999");
        let deep = "[".repeat(100_000);
        for foreign in ["", "null", "[]", r#"{"op":1}"#, r#"{"op":"subscribe"}"#, nan, &huge, &deep]
        {
            let refused = FromClient::decode(foreign).expect_err(foreign).to_string();
            assert!(refused.starts_with("what came is no message of the protocol: "), "{refused}");
        }
    }

    proptest! {
        #[test]
        fn a_value_that_is_set_comes_to_the_last_bit(value in prop::num::f64::NORMAL) {
            let parameters = vec![ParameterValue::new("/key/39/k2", value)];
            let text = FromClient::SetParameters { parameters, id: None }.encode().expect("text");
            let FromClient::SetParameters { parameters, .. } =
                FromClient::decode(&text).expect("a message")
            else {
                panic!("another message came back");
            };
            let change = parameters[0].change().expect("a change");
            prop_assert_eq!(change.value.to_bits(), value.to_bits());
        }
    }
}
