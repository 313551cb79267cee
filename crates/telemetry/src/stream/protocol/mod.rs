//! The Foxglove WebSocket protocol, as much of it as a host and a window need.
//!
//! Texts are JSON objects with an `op`: [`FromServer`] and [`FromClient`]. Binary messages begin
//! with a kind byte: [`ServerFrame`] and [`ClientFrame`]. Decoders accept any bytes.

mod binary;
mod channel;
mod error;
mod from_client;
mod from_server;
mod parameter;
mod schema;
mod service;
mod text;

pub use binary::{ClientFrame, ServerFrame};
pub(crate) use channel::place;
pub use channel::{Channel, channel_id, channels, topic_of};
pub use error::ProtocolError;
pub use from_client::{FromClient, Subscription};
pub use from_server::{FromServer, Level};
pub use parameter::{ParameterError, ParameterValue};
pub use schema::schema;
pub use service::{AdvertisedService, Service, ServiceSchema};
pub use text::Text;

/// Names of the protocol, the present one first.
pub const SUBPROTOCOLS: [&str; 2] = ["foxglove.sdk.v1", "foxglove.websocket.v1"];
