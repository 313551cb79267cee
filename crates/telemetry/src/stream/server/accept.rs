//! Lets clients in, so many at once.

use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, watch};
use tokio::task::JoinSet;
use tokio_rustls::TlsAcceptor;
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::tungstenite::handshake::server::{ErrorResponse, Request, Response};
use tokio_tungstenite::tungstenite::http::{HeaderValue, header};
use tokio_tungstenite::tungstenite::protocol::WebSocketConfig;
use tokio_tungstenite::{WebSocketStream, accept_hdr_async_with_config};

use super::connection;
use super::door::{self, Closed};
use super::{Backend, Publisher, Role, ServerSettings, StreamServer, Who};
use crate::stream::carrier::Boxed;

/// What all connections share.
pub(super) struct ServerState {
    pub(super) settings: ServerSettings,
    pub(super) publisher: Publisher,
    pub(super) backend: Arc<dyn Backend>,
    /// What everybody is told first, but for who they are.
    pub(super) advertised: Message,
    acceptor: Option<TlsAcceptor>,
    places: Arc<Semaphore>,
    count: AtomicU64,
    /// Why the server closes, once it does.
    closing: watch::Receiver<Option<String>>,
}

/// Closes a server: what was asked is answered, and each client is told why.
#[derive(Clone, Debug)]
pub struct Closer(watch::Sender<Option<String>>);

impl Default for Closer {
    fn default() -> Self {
        Self(watch::Sender::new(None))
    }
}

impl Closer {
    /// Lets [`serve`] answer what was asked already, tell every client `why`, and return.
    pub fn close(&self, why: String) {
        self.0.send_replace(Some(why));
    }
}

/// Answers clients, until its [`Closer`] closes it or it is dropped; with it go all connections.
///
/// # Errors
/// If the runtime cannot use the listening socket.
pub async fn serve(server: StreamServer, backend: Arc<dyn Backend>) -> io::Result<()> {
    /// Longest time from the closing to the end.
    const CLOSING: Duration = Duration::from_secs(3);
    let StreamServer { listener, settings, tls, publisher, hub, closer, .. } = server;
    let listener = TcpListener::from_std(listener)?;
    let handshakes = Arc::new(Semaphore::new(settings.limits.handshakes.max(1)));
    let house = Arc::new(ServerState {
        places: Arc::new(Semaphore::new(settings.limits.clients)),
        advertised: connection::advertised(),
        acceptor: tls.map(|armour| armour.acceptor),
        count: AtomicU64::new(0),
        closing: closer.0.subscribe(),
        settings,
        publisher,
        backend,
    });
    // Hands out until the last connection is over.
    let mut hands_out = JoinSet::new();
    hands_out.spawn(hub.run());
    let mut tasks = JoinSet::new();
    tokio::select! {
        () = house.closing() => {}
        () = receive_all(&house, listener, &handshakes, &mut tasks) => {}
    }
    let ends = async { while tasks.join_next().await.is_some() {} };
    let _in_time = tokio::time::timeout(CLOSING, ends).await;
    Ok(())
}

/// Receives whoever comes, until it is dropped.
async fn receive_all(
    house: &Arc<ServerState>,
    listener: TcpListener,
    handshakes: &Arc<Semaphore>,
    tasks: &mut JoinSet<()>,
) {
    loop {
        // Those that find no place wait in the system's queue, and come in as others time out.
        let Ok(step) = Arc::clone(handshakes).acquire_owned().await else { return };
        let (stream, address) = next(&listener, tasks).await;
        let house = Arc::clone(house);
        tasks.spawn(async move { house.receive(stream, address, step).await });
    }
}

/// Who comes next; meanwhile those who went are forgotten.
async fn next(listener: &TcpListener, tasks: &mut JoinSet<()>) -> (TcpStream, SocketAddr) {
    /// How long to wait when the system has no more descriptors.
    const PAUSE: Duration = Duration::from_millis(50);
    loop {
        tokio::select! {
            accepted = listener.accept() => match accepted {
                Ok(accepted) => return accepted,
                Err(_none) => tokio::time::sleep(PAUSE).await,
            },
            Some(_ended) = tasks.join_next() => {}
        }
    }
}

/// Somebody who is in.
struct Connection {
    socket: WebSocketStream<Boxed>,
    who: Who,
    _place: OwnedSemaphorePermit,
}

impl ServerState {
    async fn receive(
        self: Arc<Self>,
        stream: TcpStream,
        address: SocketAddr,
        step: OwnedSemaphorePermit,
    ) {
        let entry =
            tokio::time::timeout(self.settings.limits.handshake, self.enter(stream, address));
        let entry = tokio::select! {
            entry = entry => entry,
            () = self.closing() => return,
        };
        let Ok(Some(guest)) = entry else { return };
        drop(step);
        connection::hold(&self, guest.socket, guest.who).await;
    }

    /// Both handshakes; `None` if somebody is not let in, which has been answered then.
    async fn enter(&self, stream: TcpStream, address: SocketAddr) -> Option<Connection> {
        stream.set_nodelay(true).ok()?;
        let carrier: Boxed = match &self.acceptor {
            Some(acceptor) => Box::new(Box::pin(acceptor.accept(stream)).await.ok()?),
            None => Box::new(stream),
        };
        let mut admitted = None;
        #[expect(clippy::result_large_err, reason = "the library's answer, made once")]
        let decide = |request: &Request, response| match self.admit(request) {
            Ok((role, protocol, place)) => {
                admitted = Some((role, place));
                Ok(spoken(response, protocol))
            }
            Err(closed) => {
                self.backend.refused(address, closed.text());
                Err::<_, ErrorResponse>(closed.response())
            }
        };
        let socket = Box::pin(accept_hdr_async_with_config(carrier, decide, Some(self.config())))
            .await
            .ok()?;
        let (role, place) = admitted?;
        let number = self.count.fetch_add(1, Ordering::Relaxed) + 1;
        Some(Connection { socket, who: Who { number, address, role }, _place: place })
    }

    /// Waits until the server closes.
    pub(super) async fn closing(&self) {
        if self.closing.clone().wait_for(Option::is_some).await.is_err() {
            std::future::pending::<()>().await;
        }
    }

    /// Why the server closes; nothing as long as it does not.
    pub(super) fn reason(&self) -> String {
        self.closing.borrow().clone().unwrap_or_default()
    }

    fn admit(
        &self,
        request: &Request,
    ) -> Result<(Role, &'static str, OwnedSemaphorePermit), Closed> {
        let (role, protocol) = door::admit(&self.settings, request)?;
        let Ok(place) = Arc::clone(&self.places).try_acquire_owned() else {
            return Err(Closed::Full);
        };
        Ok((role, protocol, place))
    }

    fn config(&self) -> WebSocketConfig {
        /// Large enough for what clients usually send (bytes).
        const READ_BUFFER: usize = 16 << 10;
        let most = Some(self.settings.limits.message_bytes);
        WebSocketConfig::default()
            .read_buffer_size(READ_BUFFER)
            .max_message_size(most)
            .max_frame_size(most)
    }
}

/// `response`, saying what will be spoken.
fn spoken(mut response: Response, protocol: &'static str) -> Response {
    let protocol = HeaderValue::from_static(protocol);
    response.headers_mut().insert(header::SEC_WEBSOCKET_PROTOCOL, protocol);
    response
}
