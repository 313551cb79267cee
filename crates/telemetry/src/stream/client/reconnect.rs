//! Connects to a host, and again whenever the connection is lost.

use std::collections::BTreeSet;
use std::sync::Arc;
use std::time::Duration;

use tokio::sync::mpsc::UnboundedReceiver;

use super::Dial;
use super::arrivals::Arrivals;
use super::command::ClientCommand;
use super::connect::{ConnectError, connect};
use super::session::{ClientSession, SessionEnd};
use crate::{Arrival, ConnectionState, Topic};

/// Answer to a request without a connection.
pub(super) const NOT_CONNECTED: &str = "no host is connected: wait until one is, and ask again";

/// Shortest and longest pause before another attempt.
const PAUSES: (Duration, Duration) = (Duration::from_millis(250), Duration::from_secs(5));

/// Client that restores its connection.
pub(super) struct ReconnectingClient {
    dial: Dial,
    arrivals: Arc<Arrivals>,
    commands: UnboundedReceiver<ClientCommand>,
    wanted: BTreeSet<Topic>,
}

/// The window has dropped its [`super::Client`].
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

    /// Keeps a connection until the window is closed or the host rejects it.
    async fn keep_connected(&mut self) -> Result<std::convert::Infallible, WindowClosed> {
        let mut pause = PAUSES.0;
        loop {
            let dial = self.dial.clone();
            let lost = match self.wait_for(Box::pin(connect(&dial))).await? {
                Ok(socket) => {
                    pause = PAUSES.0;
                    let session = ClientSession::new(socket, &self.arrivals);
                    match Box::pin(session.run(&mut self.commands, &mut self.wanted)).await {
                        SessionEnd::Gone => return Err(WindowClosed),
                        SessionEnd::Lost(text) => text,
                    }
                }
                Err(ConnectError::Lost(text)) => text,
                Err(ConnectError::Refused(text)) => {
                    self.arrivals.set_state(ConnectionState::Refused(text));
                    return self.wait_for(std::future::pending()).await;
                }
            };
            self.arrivals.set_state(ConnectionState::Lost(lost));
            self.wait_for(tokio::time::sleep(pause)).await?;
            pause = (2 * pause).min(PAUSES.1);
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
                    Some(ClientCommand::Ask(ticket, _)) => {
                        let result = Err(NOT_CONNECTED.to_owned());
                        self.arrivals.push(Arrival::Reply { ticket, result }, 0);
                    }
                    None => return Err(WindowClosed),
                }
            }
        }
    }
}
