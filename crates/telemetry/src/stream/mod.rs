//! The stream: a server for a host, and a client for a window, on other people's protocol.
//!
//! Both talk the [Foxglove WebSocket protocol](https://github.com/foxglove/ws-protocol), so that
//! Foxglove, Lichtblick and PlotJuggler can watch a host as well as our own window does.
//! What they share with ours: messages with their schemas, parameters, and services.
//!
//! | part | what it is |
//! |---|---|
//! | [`protocol`] | what travels: encoders, and decoders that take any bytes |
//! | [`server`] | the host's end: who may come in, who follows what, who is too slow |
//! | [`client`] | the window's end: a [`crate::Source`] that connects again by itself |
//!
//! Of ours on top, which others need not know:
//! a reply that `parameterValues` carries beside the values (its field `reply`), and a refusal
//! that is a `status` with the refused request's own id.

mod backlog;
mod byte_stream;
mod fingerprint;
mod retained;

pub mod client;
pub mod protocol;
pub mod server;

pub use client::{Client, Dial, Waker};
pub use fingerprint::Fingerprint;
pub use server::{
    Backend, Closer, ParameterSetting, Publisher, Role, ServerSettings, StreamServer, Who, serve,
};
