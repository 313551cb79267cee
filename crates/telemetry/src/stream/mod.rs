//! The stream: a server for a host, and a client for a window, on a public protocol.
//!
//! Both use the [Foxglove WebSocket protocol](https://github.com/foxglove/ws-protocol), so
//! Foxglove, Lichtblick and PlotJuggler can watch a host like our own window.
//!
//! | part | contents |
//! |---|---|
//! | [`protocol`] | encoders, and decoders that accept any bytes |
//! | [`server`] | the host's end: admission, subscriptions, slow clients |
//! | [`client`] | the window's end: a [`crate::Source`] that reconnects by itself |
//!
//! Two extensions, which other clients may ignore: `parameterValues` carries a reply beside the
//! values (field `reply`), and a rejection is a `status` with the request's own id.

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
