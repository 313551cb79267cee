//! Connects, again and again.

use std::collections::BTreeSet;
use std::sync::Arc;
use std::time::Duration;

use tokio::sync::mpsc::UnboundedReceiver;

use super::Dial;
use super::arrivals::Arrivals;
use super::connect::{Trouble, connect};
use super::session::{End, Session};
use crate::source::Ticket;
use crate::{Arrival, Request, Standing, Topic};

/// What is asked of a host that is not there.
pub(super) const NOT_CONNECTED: &str = "no host is connected: wait until one is, and ask again";

/// Before it is tried again: at first, and at last.
const PAUSES: (Duration, Duration) = (Duration::from_millis(250), Duration::from_secs(5));

/// What the window wants.
#[derive(Debug)]
pub(super) enum Order {
    /// These topics, and no others.
    Follow(BTreeSet<Topic>),
    /// An answer.
    Ask(Ticket, Request),
}

/// Connects, again and again.
pub(super) struct Line {
    dial: Dial,
    arrivals: Arc<Arrivals>,
    orders: UnboundedReceiver<Order>,
    wanted: BTreeSet<Topic>,
}

/// The window is gone.
struct Gone;

impl Line {
    /// To whom `dial` says.
    pub(super) const fn new(
        dial: Dial,
        arrivals: Arc<Arrivals>,
        orders: UnboundedReceiver<Order>,
    ) -> Self {
        Self { dial, arrivals, orders, wanted: BTreeSet::new() }
    }

    /// Runs until the window is gone.
    pub(super) fn run(mut self) {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
        match runtime {
            Ok(runtime) => {
                let Err(Gone) = runtime.block_on(self.keep());
            }
            Err(error) => {
                let text = format!("the system gives no network: {error}");
                self.arrivals.stand(Standing::Refused(text));
            }
        }
    }

    /// Connects, again and again.
    async fn keep(&mut self) -> Result<std::convert::Infallible, Gone> {
        let mut pause = PAUSES.0;
        loop {
            let dial = self.dial.clone();
            match self.meanwhile(Box::pin(connect(&dial))).await? {
                Ok(socket) => {
                    pause = PAUSES.0;
                    let session = Session::new(socket, &self.arrivals);
                    match Box::pin(session.run(&mut self.orders, &mut self.wanted)).await {
                        End::Gone => return Err(Gone),
                        End::Lost(text) => self.arrivals.stand(Standing::Lost(text)),
                    }
                }
                Err(Trouble::Lost(text)) => self.arrivals.stand(Standing::Lost(text)),
                Err(Trouble::Refused(text)) => {
                    self.arrivals.stand(Standing::Refused(text));
                    return self.meanwhile(std::future::pending()).await;
                }
            }
            self.meanwhile(tokio::time::sleep(pause)).await?;
            pause = (2 * pause).min(PAUSES.1);
        }
    }

    /// Waits for `work`; what is asked meanwhile is refused.
    async fn meanwhile<T>(&mut self, work: impl Future<Output = T>) -> Result<T, Gone> {
        let mut work = std::pin::pin!(work);
        loop {
            tokio::select! {
                done = &mut work => return Ok(done),
                order = self.orders.recv() => match order {
                    Some(Order::Follow(topics)) => self.wanted = topics,
                    Some(Order::Ask(ticket, _)) => {
                        let result = Err(NOT_CONNECTED.to_owned());
                        self.arrivals.push(Arrival::Reply { ticket, result }, 0);
                    }
                    None => return Err(Gone),
                }
            }
        }
    }
}
