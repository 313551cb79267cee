//! The host's end of the stream.
//!
//! ```text
//! any thread: Publisher ──bounded, never waits──▶ hub ──▶ a client's outbox ──▶ its connection
//!                                                  ▲        control: never dropped, or it is cut
//! a connection's requests ──subscriptions──────────┘        data: the oldest are dropped
//!                         ──calls──▶ Backend, beside the runtime's thread
//! ```
//!
//! A browser sends the origin of its page, a program sends none: only listed origins are admitted,
//! or any page open on the machine could move motors. Any user of a machine reaches its loopback,
//! so a server gives each client a token ([`Token::random`] makes one for a run). Beyond loopback
//! it needs TLS as well.

mod accept;
mod admission;
mod backend;
mod connection;
mod following;
mod hub;
mod hub_handle;
mod outbox;
mod plain_http;
mod publisher;
mod role;
mod sample;
mod settings;
mod state;
mod tls;
mod watched;

use std::io;
use std::net::{SocketAddr, TcpListener};

use hub::Hub;

pub use accept::{Closer, serve};
pub use backend::{Backend, ParameterSetting, Who};
pub use publisher::Publisher;
pub use role::Role;
pub use settings::{ServerLimits, ServerSettings, Tls, Token, Unsafe};

use super::Fingerprint;

/// A server that listens, and does not answer before [`serve`] runs.
#[derive(Debug)]
pub struct StreamServer {
    listener: TcpListener,
    address: SocketAddr,
    settings: ServerSettings,
    tls: Option<tls::TlsIdentity>,
    publisher: Publisher,
    hub: Hub,
    closer: Closer,
}

impl StreamServer {
    /// Listens with `settings`; an error is a sentence.
    pub fn listen(settings: ServerSettings) -> io::Result<Self> {
        settings.check().map_err(|error| io::Error::new(io::ErrorKind::InvalidInput, error))?;
        let tls = settings.tls.as_ref().map(tls::TlsIdentity::new).transpose()?;
        let listener = TcpListener::bind(settings.address).map_err(|error| {
            let text = format!(
                "the stream cannot listen at {}: {error}; choose another address",
                settings.address
            );
            io::Error::new(error.kind(), text)
        })?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        let (handle, hub) = Hub::new();
        let (publisher, closer) = (Publisher::new(handle), Closer::default());
        Ok(Self { listener, address, settings, tls, publisher, hub, closer })
    }

    /// Returns the listening address, with the port that the system chose for port 0.
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Returns the address for clients, as `ws://127.0.0.1:8765`.
    pub fn url(&self) -> String {
        let scheme = if self.tls.is_some() { "wss" } else { "ws" };
        format!("{scheme}://{}", self.address)
    }

    pub fn fingerprint(&self) -> Option<Fingerprint> {
        self.tls.as_ref().map(|identity| identity.fingerprint)
    }

    pub fn closer(&self) -> Closer {
        self.closer.clone()
    }

    pub fn publisher(&self) -> Publisher {
        self.publisher.clone()
    }
}
