//! Connects, again and again.

use std::collections::BTreeSet;
use std::sync::Arc;
use std::time::Duration;

use tokio::sync::mpsc::UnboundedReceiver;

use super::Dial;
use super::arrivals::Arrivals;
use super::connect::{ConnectError, connect};
use super::session::{ClientSession, SessionEnd};
use crate::source::Ticket;
use crate::{Arrival, ConnectionState, Request, Topic};

/// What is asked of a host that is not there.
pub(super) const NOT_CONNECTED: &str = "no host is connected: wait until one is, and ask again";

/// Before it is tried again: at first, and at last.
const PAUSES: (Duration, Duration) = (Duration::from_millis(250), Duration::from_secs(5));

/// What the window wants.
#[derive(Debug)]
pub(super) enum ClientCommand {
    /// These topics, and no others.
    Follow(BTreeSet<Topic>),
    Ask(Ticket, Request),
}

/// Connects, again and again.
pub(super) struct ReconnectingClient {
    dial: Dial,
    arrivals: Arc<Arrivals>,
    orders: UnboundedReceiver<ClientCommand>,
    wanted: BTreeSet<Topic>,
}

/// The window is gone.
struct WindowClosed;

impl ReconnectingClient {
    /// To whom `dial` says.
    pub(super) const fn new(
        dial: Dial,
        arrivals: Arc<Arrivals>,
        orders: UnboundedReceiver<ClientCommand>,
    ) -> Self {
        Self { dial, arrivals, orders, wanted: BTreeSet::new() }
    }

    /// Runs until the window is gone.
    pub(super) fn run(mut self) {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
        match runtime {
            Ok(runtime) => {
                let Err(WindowClosed) = runtime.block_on(self.keep());
            }
            Err(error) => {
                let text = format!("the system gives no network: {error}");
                self.arrivals.stand(ConnectionState::Refused(text));
            }
        }
    }

    /// Connects, again and again.
    async fn keep(&mut self) -> Result<std::convert::Infallible, WindowClosed> {
        let mut pause = PAUSES.0;
        loop {
            let dial = self.dial.clone();
            match self.meanwhile(Box::pin(connect(&dial))).await? {
                Ok(socket) => {
                    pause = PAUSES.0;
                    let session = ClientSession::new(socket, &self.arrivals);
                    match Box::pin(session.run(&mut self.orders, &mut self.wanted)).await {
                        SessionEnd::Gone => return Err(WindowClosed),
                        SessionEnd::Lost(text) => self.arrivals.stand(ConnectionState::Lost(text)),
                    }
                }
                Err(ConnectError::Lost(text)) => self.arrivals.stand(ConnectionState::Lost(text)),
                Err(ConnectError::Refused(text)) => {
                    self.arrivals.stand(ConnectionState::Refused(text));
                    return self.meanwhile(std::future::pending()).await;
                }
            }
            self.meanwhile(tokio::time::sleep(pause)).await?;
            pause = (2 * pause).min(PAUSES.1);
        }
    }

    /// Waits for `work`; what is asked meanwhile is refused.
    async fn meanwhile<T>(&mut self, work: impl Future<Output = T>) -> Result<T, WindowClosed> {
        let mut work = std::pin::pin!(work);
        loop {
            tokio::select! {
                done = &mut work => return Ok(done),
                order = self.orders.recv() => match order {
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
