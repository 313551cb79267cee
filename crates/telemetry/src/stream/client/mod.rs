//! The window's end of the stream.
//!
//! A thread of its own connects, again and again; the window never waits.
//! What the window has no time for is dropped, the oldest first; replies never are, and of the
//! catalogue and of each key's voice the last one is kept.

mod address;
mod arrivals;
mod command;
mod connect;
mod pin;
mod reconnect;
mod session;

use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;
use std::thread;

use tokio::sync::mpsc::{self, UnboundedSender};

use arrivals::Arrivals;
use command::ClientCommand;
use reconnect::ReconnectingClient;

use super::Fingerprint;
use crate::source::Ticket;
use crate::{Arrival, ConnectionState, Reply, Request, Source, Topic};

/// Called when something has come, from the client's own thread.
pub type Waker = Box<dyn Fn() + Send + Sync>;

/// The host to connect to.
#[derive(Clone, Default)]
pub struct Dial {
    /// The address, as `ws://127.0.0.1:8765` or `wss://piano.local`; `ws://` and port 8765 without.
    pub address: String,
    /// The token, if the host asks for one.
    pub token: Option<String>,
    /// The fingerprint of the host's certificate, as the host printed it; `wss://` needs it.
    pub pin: Option<Fingerprint>,
}

impl fmt::Debug for Dial {
    /// Leaves out the token, which must not get into a log.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let has_token = self.token.is_some();
        f.debug_struct("Dial")
            .field("address", &self.address)
            .field("has_token", &has_token)
            .field("pin", &self.pin)
            .finish()
    }
}

/// A connection to a live host, which is made again when it is lost.
pub struct Client {
    name: String,
    arrivals: Arc<Arrivals>,
    commands: UnboundedSender<ClientCommand>,
    tickets: u64,
}

impl Client {
    /// Begins to connect, and keeps connecting until it is dropped.
    pub fn connect(dial: Dial, waker: Option<Waker>) -> Self {
        let name = dial.address.clone();
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
        // If the thread is gone, `standing` has said why.
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
}
