//! A synthetic host on its stream, clients of ours, and raw clients.

#[path = "../../examples/stream_demo/synthetic.rs"]
pub(crate) mod synthetic;

use std::net::{SocketAddr, TcpStream};
use std::sync::mpsc::{self, Receiver};
use std::time::{Duration, Instant};
use std::{sync::Arc, thread::JoinHandle};

use synthetic::Synthetic;
use telemetry::source::Ticket;
use telemetry::stream::protocol::{FromClient, FromServer, Text as _};
use telemetry::stream::server::ServerLimits;
use telemetry::stream::{
    Backend, Client, Closer, Dial, Fingerprint, Publisher, ServerSettings, StreamServer, serve,
};
use telemetry::{Arrival, ConnectionState, Reply, Request, Source as _, Topic, Update};
use tokio::{runtime::Handle, sync::oneshot};
use tokio_tungstenite::tungstenite::client::ClientRequestBuilder;
use tokio_tungstenite::tungstenite::protocol::WebSocketConfig;
use tokio_tungstenite::tungstenite::{Error, Message, WebSocket, client::client_with_config};

/// Last resort on a busy machine.
pub(crate) const PATIENCE: Duration = Duration::from_mins(2);

pub(crate) struct TestServer {
    pub(crate) address: SocketAddr,
    pub(crate) url: String,
    pub(crate) fingerprint: Option<Fingerprint>,
    pub(crate) publisher: Publisher,
    pub(crate) host: Arc<Synthetic>,
    pub(crate) runtime: Handle,
    pub(crate) closer: Closer,
    end: Option<oneshot::Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl TestServer {
    pub(crate) fn with(settings: ServerSettings) -> Self {
        let host = Arc::new(Synthetic::default());
        Self::of(settings, Arc::clone(&host), host)
    }

    pub(crate) fn of(
        mut settings: ServerSettings,
        host: Arc<Synthetic>,
        backend: Arc<dyn Backend>,
    ) -> Self {
        if settings.address == ServerSettings::default().address {
            settings.address.set_port(0);
        }
        let server = StreamServer::listen(settings).expect("a server");
        let (address, url) = (server.address(), server.url());
        let (fingerprint, publisher) = (server.fingerprint(), server.publisher());
        host.tell_by(publisher.clone());
        let closer = server.closer();
        let (end, ended) = oneshot::channel();
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
        let runtime = runtime.expect("a runtime");
        let handle = runtime.handle().clone();
        let thread = std::thread::spawn(move || {
            runtime.block_on(async {
                tokio::select! {
                    served = serve(server, backend) => served.expect("it serves"),
                    _ended = ended => {}
                }
            });
        });
        let (end, thread) = (Some(end), Some(thread));
        Self { address, url, fingerprint, publisher, host, runtime: handle, closer, end, thread }
    }

    pub(crate) fn new() -> Self {
        Self::with(ServerSettings::default())
    }

    pub(crate) fn within(limits: ServerLimits) -> Self {
        Self::with(ServerSettings { limits, ..ServerSettings::default() })
    }

    pub(crate) fn watcher(&self) -> Watcher {
        let mut watcher = Watcher::new(Dial { address: self.url.clone(), ..Dial::default() });
        watcher.connected();
        watcher
    }

    pub(crate) fn raw_client(&self) -> RawClient {
        RawClient::connect(self.address, "/", &[]).expect("a connection")
    }

    pub(crate) fn meet(&self, watcher: &mut Watcher) {
        watcher.follow(&[Topic::Overview]);
        eventually("a client follows", || self.publisher.is_followed(Topic::Overview));
        self.publisher.publish(1, &synthetic::overview(7, 1));
        watcher.update(|update| matches!(update, Update::Overview(_)).then_some(()));
    }
}

impl Drop for TestServer {
    fn drop(&mut self) {
        drop(self.end.take());
        if let Some(thread) = self.thread.take() {
            thread.join().expect("the server did not panic");
        }
    }
}

#[track_caller]
pub(crate) fn eventually(what: &str, mut is_so: impl FnMut() -> bool) {
    let begun = Instant::now();
    while !is_so() {
        assert!(begun.elapsed() < PATIENCE, "not even after {PATIENCE:?}: {what}");
        std::thread::sleep(Duration::from_millis(2));
    }
}

pub(crate) struct Watcher {
    pub(crate) client: Client,
    woken: Receiver<()>,
}

impl Watcher {
    pub(crate) fn new(dial: Dial) -> Self {
        let (wake, woken) = mpsc::channel();
        let waker = Box::new(move || {
            let _nobody_waits = wake.send(());
        });
        Self { client: Client::connect(dial, Some(waker)), woken }
    }

    #[track_caller]
    pub(crate) fn next(&mut self) -> Arrival {
        loop {
            match self.client.next() {
                Some(arrival) => return arrival,
                None => self.woken.recv_timeout(PATIENCE).expect("something comes"),
            }
        }
    }

    #[track_caller]
    pub(crate) fn connected(&mut self) {
        while self.next() != Arrival::Anew {}
    }

    #[track_caller]
    pub(crate) fn update<T>(&mut self, found: impl Fn(Update) -> Option<T>) -> T {
        loop {
            if let Arrival::Update { update, .. } = self.next()
                && let Some(found) = found(*update)
            {
                return found;
            }
        }
    }

    #[track_caller]
    pub(crate) fn ask(&mut self, request: Request) -> Result<Reply, String> {
        let ticket = self.client.ask(request);
        self.reply(ticket)
    }

    #[track_caller]
    pub(crate) fn reply(&mut self, ticket: Ticket) -> Result<Reply, String> {
        loop {
            match self.next() {
                Arrival::Reply { ticket: of, result } if of == ticket => return result,
                Arrival::Reply { .. } | Arrival::Update { .. } | Arrival::Anew => {}
            }
        }
    }

    pub(crate) fn follow(&mut self, topics: &[Topic]) {
        self.client.follow(&topics.iter().copied().collect());
    }

    #[track_caller]
    pub(crate) fn stands(&mut self, is_so: impl Fn(&ConnectionState) -> bool) -> ConnectionState {
        eventually("the standing", || is_so(&self.client.standing()));
        self.client.standing()
    }
}

pub(crate) fn set(parameter: &str, value: f64) -> telemetry::request::Change {
    telemetry::request::Change { key: 39, parameter: parameter.to_owned(), value }
}

pub(crate) struct RawClient {
    pub(crate) socket: WebSocket<TcpStream>,
}

impl RawClient {
    pub(crate) fn connect(
        address: SocketAddr,
        path: &str,
        headers: &[(&str, &str)],
    ) -> Result<Self, Box<Error>> {
        let stream = TcpStream::connect(address).expect("a connection");
        stream.set_read_timeout(Some(PATIENCE)).expect("a time limit");
        let uri = format!("ws://{address}{path}").parse().expect("a URI");
        let mut request = ClientRequestBuilder::new(uri).with_sub_protocol("foxglove.websocket.v1");
        for (name, value) in headers {
            request = request.with_header(*name, *value);
        }
        let config = Some(WebSocketConfig::default());
        match client_with_config(request, stream, config) {
            Ok((socket, _response)) => Ok(Self { socket }),
            Err(error) => Err(Box::new(match error {
                tokio_tungstenite::tungstenite::HandshakeError::Failure(error) => error,
                tokio_tungstenite::tungstenite::HandshakeError::Interrupted(_) => {
                    Error::ConnectionClosed
                }
            })),
        }
    }

    pub(crate) fn say(&mut self, message: &FromClient) {
        self.text(message.encode().expect("a text"));
    }

    pub(crate) fn text(&mut self, text: String) {
        self.socket.send(Message::text(text)).expect("it is sent");
    }

    pub(crate) fn hear(&mut self) -> Result<Message, Box<Error>> {
        self.socket.read().map_err(Box::new)
    }

    #[track_caller]
    pub(crate) fn hear_text<T>(&mut self, found: impl Fn(FromServer) -> Option<T>) -> T {
        loop {
            if let Message::Text(text) = self.hear().expect("a message")
                && let Some(found) = found(FromServer::decode(&text).expect("a text"))
            {
                return found;
            }
        }
    }
}
