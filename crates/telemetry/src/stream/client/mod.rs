//! The window's end of the stream.
//!
//! A separate thread connects and reconnects; the window never waits. If the window is slow, the
//! oldest arrivals are dropped, but no replies, and not the last catalogue and voice of each key.

mod address;
mod arrivals;
mod command;
mod connect;
mod pin;
mod reconnect;
mod session;
mod socket;

use std::{collections::BTreeSet, fmt, path::PathBuf, sync::Arc, thread};

use tokio::sync::mpsc::{self, UnboundedSender};

use arrivals::Arrivals;
use command::ClientCommand;
use reconnect::ReconnectingClient;

use super::{Fingerprint, Role};
use crate::{Arrival, ConnectionState, Reply, Request, Source, Topic, source::Ticket};

/// Callback for an arrival, from the client's own thread.
pub type Waker = Box<dyn Fn() + Send + Sync>;

/// The host to connect to.
#[derive(Clone, Default)]
pub struct Dial {
    /// Address, as `wss://piano.local`; by default the scheme is `ws://` and the port 8765.
    pub address: String,
    pub token: Option<String>,
    /// Fingerprint of the host's certificate, as the host printed it; `wss://` needs it.
    pub pin: Option<Fingerprint>,
    /// Control socket of a host on this machine. Each attempt to connect asks it for the present
    /// address and secret, so that a host that was started again is found; a stop without a
    /// connection is sent there.
    pub socket: Option<PathBuf>,
}

impl fmt::Debug for Dial {
    /// Omits the token, which must not get into a log.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let has_token = self.token.is_some();
        f.debug_struct("Dial")
            .field("address", &self.address)
            .field("has_token", &has_token)
            .field("pin", &self.pin)
            .field("socket", &self.socket)
            .finish()
    }
}

/// Connection to a live host, which is restored when it is lost.
pub struct Client {
    name: String,
    arrivals: Arc<Arrivals>,
    commands: UnboundedSender<ClientCommand>,
    tickets: u64,
}

impl Client {
    /// Starts to connect, and keeps the connection until the client is dropped.
    pub fn connect(dial: Dial, waker: Option<Waker>) -> Self {
        let name = match &dial.socket {
            Some(_) => "the host of this machine".to_owned(),
            None => dial.address.clone(),
        };
        let arrivals = Arc::new(Arrivals::new(waker));
        let (commands, incoming) = mpsc::unbounded_channel();
        let client = ReconnectingClient::new(dial, Arc::clone(&arrivals), incoming);
        let thread = thread::Builder::new().name("letoff-stream".to_owned());
        if let Err(error) = thread.spawn(move || client.run()) {
            arrivals.set_state(ConnectionState::Refused(format!(
                "the system gives no thread: {error}"
            )));
        }
        Self { name, arrivals, commands, tickets: 0 }
    }

    fn answer(&self, ticket: Ticket, result: Result<Reply, String>) {
        self.arrivals.push(Arrival::Reply { ticket, result }, 0);
    }
}

impl fmt::Debug for Client {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Client").field("name", &self.name).finish_non_exhaustive()
    }
}

impl Source for Client {
    fn next(&mut self) -> Option<Arrival> {
        self.arrivals.pop()
    }

    fn follow(&mut self, topics: &BTreeSet<Topic>) {
        self.arrivals.keep_only(topics);
        // After the thread's end, `standing` reports why.
        let _gone = self.commands.send(ClientCommand::Follow(topics.clone()));
    }

    fn ask(&mut self, request: Request) -> Ticket {
        self.tickets += 1;
        let ticket = Ticket(self.tickets);
        if self.commands.send(ClientCommand::Ask(ticket, request)).is_err() {
            self.answer(ticket, Err(reconnect::NOT_CONNECTED.to_owned()));
        }
        ticket
    }

    fn standing(&self) -> ConnectionState {
        self.arrivals.state()
    }

    fn name(&self) -> String {
        self.name.clone()
    }

    fn role(&self) -> Option<Role> {
        self.arrivals.role()
    }
}
