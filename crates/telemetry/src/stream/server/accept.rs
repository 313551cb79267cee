//! Admission of clients, a bounded number at once.

use std::sync::atomic::{AtomicU64, Ordering};
use std::{collections::VecDeque, io, net::SocketAddr, sync::Arc, time::Duration};

use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, oneshot, watch};
use tokio::task::JoinSet;
use tokio_tungstenite::tungstenite::handshake::server::{ErrorResponse, Request, Response};
use tokio_tungstenite::tungstenite::http::{HeaderValue, header};
use tokio_tungstenite::tungstenite::protocol::WebSocketConfig;
use tokio_tungstenite::{WebSocketStream, accept_hdr_async_with_config};

use super::admission::{self, AdmissionError};
use super::{Backend, Role, StreamServer, Who, connection, plain_http, state::ServerState};
use crate::stream::byte_stream::BoxedStream;

/// Closes a server after its last answers, and tells each client why.
#[derive(Clone, Debug)]
pub struct Closer(watch::Sender<Option<String>>);

impl Default for Closer {
    fn default() -> Self {
        Self(watch::Sender::new(None))
    }
}

impl Closer {
    /// Lets [`serve`] answer earlier requests, send every client `why`, and return.
    pub fn close(&self, why: String) {
        self.0.send_replace(Some(why));
    }
}

/// Serves clients until its [`Closer`] closes it or it is dropped, with all connections.
pub async fn serve(server: StreamServer, backend: Arc<dyn Backend>) -> io::Result<()> {
    /// Longest time from closing to the return.
    const CLOSING: Duration = Duration::from_secs(3);
    let StreamServer { listener, settings, tls, publisher, hub, closer, .. } = server;
    let listener = TcpListener::from_std(listener)?;
    let state = Arc::new(ServerState {
        places: Arc::new(Semaphore::new(settings.limits.clients)),
        others: Arc::new(Semaphore::new(
            settings.limits.clients.saturating_sub(settings.limits.owners),
        )),
        advertised: connection::advertised(),
        acceptor: tls.map(|identity| identity.acceptor),
        count: AtomicU64::new(0),
        closing: closer.0.subscribe(),
        settings,
        publisher,
        backend,
    });
    // The hub runs until the last connection is over.
    let mut hub_task = JoinSet::new();
    hub_task.spawn(hub.run());
    let mut tasks = JoinSet::new();
    tokio::select! {
        () = state.closing() => {}
        () = receive_all(&state, listener, &mut tasks) => {}
    }
    let ends = async { while tasks.join_next().await.is_some() {} };
    let _in_time = tokio::time::timeout(CLOSING, ends).await;
    Ok(())
}

#[expect(clippy::infinite_loop, reason = "a future that is dropped ends")]
async fn receive_all(state: &Arc<ServerState>, listener: TcpListener, tasks: &mut JoinSet<()>) {
    let mut handshakes = Handshakes::default();
    loop {
        let (stream, address) = next(&listener, tasks).await;
        let crowded_out = handshakes.begin(state.settings.limits.handshakes);
        tasks.spawn(receive(Arc::clone(state), stream, address, crowded_out));
    }
}

/// Clients before admission, the oldest first; each waits for the end of its own channel.
#[derive(Default)]
struct Handshakes(VecDeque<oneshot::Sender<()>>);

impl Handshakes {
    /// Adds another one, of `most` at once; the returned receiver ends when newer ones replace it.
    /// An honest client is admitted after milliseconds: the oldest one sends nothing.
    fn begin(&mut self, most: usize) -> oneshot::Receiver<()> {
        self.0.retain(|it| !it.is_closed());
        let crowded = (self.0.len() + 1).saturating_sub(most.max(1));
        self.0.drain(..crowded);
        let (held, crowded_out) = oneshot::channel();
        self.0.push_back(held);
        crowded_out
    }
}

/// Waits for the next connection; meanwhile forgets those that have ended.
async fn next(listener: &TcpListener, tasks: &mut JoinSet<()>) -> (TcpStream, SocketAddr) {
    /// Pause when the system has no more descriptors.
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

struct AdmittedClient {
    socket: WebSocketStream<BoxedStream>,
    who: Who,
    _place: ClientPlace,
}

struct ClientPlace {
    _any: OwnedSemaphorePermit,
    _other: Option<OwnedSemaphorePermit>,
}

/// Admits a client, unless it is crowded out before, and serves its connection.
async fn receive(
    state: Arc<ServerState>,
    stream: TcpStream,
    address: SocketAddr,
    crowded_out: oneshot::Receiver<()>,
) {
    let limit = state.settings.limits.handshake;
    let entry = tokio::time::timeout(limit, enter(&state, stream, address));
    let entry = tokio::select! {
        entry = entry => entry,
        _newer = crowded_out => return,
        () = state.closing() => return,
    };
    let Ok(Some(client)) = entry else { return };
    connection::run(&state, client.socket, client.who).await;
}

/// Encrypts the stream if required; returns it if it asks for a WebSocket.
async fn open(state: &ServerState, stream: TcpStream, address: SocketAddr) -> Option<BoxedStream> {
    stream.set_nodelay(true).ok()?;
    let stream: BoxedStream = match &state.acceptor {
        Some(acceptor) => Box::new(acceptor.accept(stream).await.ok()?),
        None => Box::new(stream),
    };
    plain_http::websocket_or_answer(state, stream, address).await
}

/// Makes both handshakes; returns `None` after answering a client that gets no WebSocket.
async fn enter(
    state: &ServerState,
    stream: TcpStream,
    address: SocketAddr,
) -> Option<AdmittedClient> {
    let stream = Box::pin(open(state, stream, address)).await?;
    let mut admitted = None;
    #[expect(clippy::result_large_err, reason = "the library's answer, made once")]
    let decide = |request: &Request, response| match admit(state, request) {
        Ok((role, protocol, place)) => {
            admitted = Some((role, place));
            Ok(with_protocol(response, protocol))
        }
        Err(error) => {
            state.backend.refused(address, error.text());
            Err::<_, ErrorResponse>(error.response())
        }
    };
    let config = Some(config(state));
    let socket = Box::pin(accept_hdr_async_with_config(stream, decide, config)).await.ok()?;
    let (role, place) = admitted?;
    let number = state.count.fetch_add(1, Ordering::Relaxed) + 1;
    Some(AdmittedClient { socket, who: Who { number, address, role }, _place: place })
}

fn admit(
    state: &ServerState,
    request: &Request,
) -> Result<(Role, &'static str, ClientPlace), AdmissionError> {
    let (role, protocol) = admission::admit(&state.settings, request)?;
    let take = |places: &Arc<Semaphore>| {
        Arc::clone(places).try_acquire_owned().map_err(|_taken| AdmissionError::Full)
    };
    let other = (role != Role::Owner).then(|| take(&state.others)).transpose()?;
    Ok((role, protocol, ClientPlace { _any: take(&state.places)?, _other: other }))
}

fn config(state: &ServerState) -> WebSocketConfig {
    /// Large enough for the usual messages of clients (bytes).
    const READ_BUFFER: usize = 16 << 10;
    let most = Some(state.settings.limits.message_bytes);
    WebSocketConfig::default()
        .read_buffer_size(READ_BUFFER)
        .max_message_size(most)
        .max_frame_size(most)
}

fn with_protocol(mut response: Response, protocol: &'static str) -> Response {
    let protocol = HeaderValue::from_static(protocol);
    response.headers_mut().insert(header::SEC_WEBSOCKET_PROTOCOL, protocol);
    response
}
