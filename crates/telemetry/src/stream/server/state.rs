//! What all connections of a server share.

use std::sync::Arc;
use std::sync::atomic::AtomicU64;

use tokio::sync::{Semaphore, watch};
use tokio_rustls::TlsAcceptor;
use tokio_tungstenite::tungstenite::Message;

use super::{Backend, Publisher, ServerSettings};

/// What all connections share.
pub(super) struct ServerState {
    pub(super) settings: ServerSettings,
    pub(super) publisher: Publisher,
    pub(super) backend: Arc<dyn Backend>,
    /// The channels, encoded once for all clients.
    pub(super) advertised: Message,
    pub(super) acceptor: Option<TlsAcceptor>,
    /// A permit for each client that is let in.
    pub(super) places: Arc<Semaphore>,
    /// A permit for each of those that are no owners.
    pub(super) others: Arc<Semaphore>,
    /// Number of clients that were let in so far.
    pub(super) count: AtomicU64,
    /// Why the server closes, once it does.
    pub(super) closing: watch::Receiver<Option<String>>,
}

impl ServerState {
    /// Waits until the server closes.
    pub(super) async fn closing(&self) {
        if self.closing.clone().wait_for(Option::is_some).await.is_err() {
            std::future::pending::<()>().await;
        }
    }

    /// Returns why the server closes; nothing as long as it does not.
    pub(super) fn reason(&self) -> String {
        self.closing.borrow().clone().unwrap_or_default()
    }
}
