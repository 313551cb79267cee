//! Connects to a host, and again whenever the connection is lost.

use std::{collections::BTreeSet, path::PathBuf, sync::Arc, time::Duration};

use tokio::sync::mpsc::UnboundedReceiver;

use super::connect::{ConnectError, connect};
use super::session::{ClientSession, SessionEnd};
use super::{Dial, arrivals::Arrivals, command::ClientCommand, socket};
use crate::{Arrival, ConnectionState, Request, Topic, source::Ticket};

/// Answer to a request without a connection.
pub(super) const NOT_CONNECTED: &str = "no host is connected: wait until one is, and ask again";

/// Shortest and longest pause before another attempt.
const PAUSES: (Duration, Duration) = (Duration::from_millis(250), Duration::from_secs(2));

/// Pause after a host rejected the connection: it counts and delays attempts.
const REFUSED: Duration = Duration::from_secs(5);

/// Longest pause between the questions to a socket of this machine.
const SOCKET: Duration = Duration::from_millis(500);

pub(super) struct ReconnectingClient {
    dial: Dial,
    arrivals: Arc<Arrivals>,
    commands: UnboundedReceiver<ClientCommand>,
    wanted: BTreeSet<Topic>,
}

struct WindowClosed;

impl ReconnectingClient {
    pub(super) const fn new(
        dial: Dial,
        arrivals: Arc<Arrivals>,
        commands: UnboundedReceiver<ClientCommand>,
    ) -> Self {
        Self { dial, arrivals, commands, wanted: BTreeSet::new() }
    }

    pub(super) fn run(mut self) {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
        match runtime {
            Ok(runtime) => {
                let Err(WindowClosed) = runtime.block_on(self.keep_connected());
            }
            Err(error) => {
                let text = format!("the system gives no network: {error}");
                self.arrivals.set_state(ConnectionState::Refused(text));
            }
        }
    }

    async fn keep_connected(&mut self) -> Result<std::convert::Infallible, WindowClosed> {
        let mut pause = PAUSES.0;
        loop {
            let (known, socket) = (self.dial.clone(), self.dial.socket.is_some());
            let attempt = async move {
                let dial = present(known).await.map_err(ConnectError::Lost)?;
                connect(&dial).await
            };
            let (state, longest) = match self.wait_for(Box::pin(attempt)).await? {
                Ok(socket) => {
                    pause = PAUSES.0;
                    let session = ClientSession::new(socket, &self.arrivals);
                    match Box::pin(session.run(&mut self.commands, &mut self.wanted)).await {
                        SessionEnd::Gone => return Err(WindowClosed),
                        SessionEnd::Lost(text) => (ConnectionState::Lost(text), PAUSES.1),
                    }
                }
                Err(ConnectError::Lost(text)) => (ConnectionState::Lost(text), PAUSES.1),
                Err(ConnectError::Refused(text)) => {
                    pause = REFUSED;
                    (ConnectionState::Refused(text), REFUSED)
                }
            };
            self.arrivals.set_state(state);
            pause = pause.min(if socket { SOCKET } else { longest });
            self.wait_for(tokio::time::sleep(pause)).await?;
            pause *= 2;
        }
    }

    /// Waits for `work`; rejects requests meanwhile.
    async fn wait_for<T>(&mut self, work: impl Future<Output = T>) -> Result<T, WindowClosed> {
        let mut work = std::pin::pin!(work);
        loop {
            tokio::select! {
                done = &mut work => return Ok(done),
                command = self.commands.recv() => match command {
                    Some(ClientCommand::Follow(topics)) => self.wanted = topics,
                    Some(ClientCommand::Ask(ticket, request)) => {
                        let socket = self.dial.socket.clone();
                        tokio::spawn(unconnected(socket, ticket, request, Arc::clone(&self.arrivals)));
                    }
                    None => return Err(WindowClosed),
                }
            }
        }
    }
}

async fn present(dial: Dial) -> Result<Dial, String> {
    match &dial.socket {
        Some(path) => socket::whereabouts(path).await,
        None => Ok(dial),
    }
}

/// Answers a request without a connection: a stop goes by the control socket, if any.
async fn unconnected(
    socket: Option<PathBuf>,
    ticket: Ticket,
    request: Request,
    arrivals: Arc<Arrivals>,
) {
    let result = match (socket, request) {
        (Some(path), Request::Stop {}) => socket::ask(&path, &Request::Stop {}).await,
        (_, _) => Err(NOT_CONNECTED.to_owned()),
    };
    arrivals.push(Arrival::Reply { ticket, result }, 0);
}
