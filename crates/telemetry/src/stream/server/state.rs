use std::sync::{Arc, atomic::AtomicU64};

use tokio::sync::{Semaphore, watch};
use tokio_rustls::TlsAcceptor;
use tokio_tungstenite::tungstenite::Message;

use super::{Backend, Publisher, ServerSettings};

pub(super) struct ServerState {
    pub(super) settings: ServerSettings,
    pub(super) publisher: Publisher,
    pub(super) backend: Arc<dyn Backend>,
    /// The channels, encoded once for all clients.
    pub(super) advertised: Message,
    pub(super) acceptor: Option<TlsAcceptor>,
    pub(super) places: Arc<Semaphore>,
    /// Permits for clients that are no owners.
    pub(super) others: Arc<Semaphore>,
    pub(super) count: AtomicU64,
    pub(super) closing: watch::Receiver<Option<String>>,
}

impl ServerState {
    pub(super) async fn closing(&self) {
        if self.closing.clone().wait_for(Option::is_some).await.is_err() {
            std::future::pending::<()>().await;
        }
    }

    pub(super) fn reason(&self) -> String {
        self.closing.borrow().clone().unwrap_or_default()
    }
}
