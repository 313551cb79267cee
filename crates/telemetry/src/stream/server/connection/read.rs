//! Messages of a client, and their dispatch.

use std::{sync::Arc, time::Duration};

use futures_util::{StreamExt as _, stream::SplitStream};
use tokio::sync::mpsc;
use tokio::time::{Instant, sleep, timeout};
use tokio_tungstenite::WebSocketStream;
use tokio_tungstenite::tungstenite::{Error, Message};

use super::answer::{ClientRequest, PendingAnswer, Receipt};
use super::{ConnectionEnd, token_bucket::TokenBucket};
use crate::Request;
use crate::stream::byte_stream::BoxedStream;
use crate::stream::protocol::{ClientFrame, FromClient, Level, Service, Text as _};
use crate::stream::server::hub_handle::HubCommand;
use crate::stream::server::outbox::Outbox;
use crate::stream::server::state::ServerState;
use crate::stream::server::{Publisher, Who};

/// Most subscriptions in one message; there are fewer channels.
const MOST_SUBSCRIPTIONS: usize = 1000;

pub(super) struct RequestReader {
    publisher: Publisher,
    outbox: Arc<Outbox>,
    who: Who,
    asked: mpsc::Sender<PendingAnswer>,
    urgent: mpsc::Sender<PendingAnswer>,
    messages: TokenBucket,
    requests: TokenBucket,
    idle: Duration,
}

impl RequestReader {
    pub(super) fn new(
        state: &ServerState,
        outbox: Arc<Outbox>,
        who: Who,
        asked: mpsc::Sender<PendingAnswer>,
        urgent: mpsc::Sender<PendingAnswer>,
    ) -> Self {
        let limits = &state.settings.limits;
        let limit = |per_second| TokenBucket::new(per_second, Instant::now());
        Self {
            publisher: state.publisher.clone(),
            outbox,
            who,
            asked,
            urgent,
            messages: limit(limits.messages_per_second),
            requests: limit(limits.requests_per_second),
            idle: limits.idle,
        }
    }

    /// Reads until the client closes the connection or falls silent.
    pub(super) async fn run(
        &mut self,
        stream: &mut SplitStream<WebSocketStream<BoxedStream>>,
    ) -> ConnectionEnd {
        loop {
            let message = match timeout(self.idle, stream.next()).await {
                Ok(Some(Ok(message))) => message,
                Ok(Some(Err(Error::Capacity(_)))) => return ConnectionEnd::TooLarge,
                Ok(Some(Err(_)) | None) => return ConnectionEnd::Left,
                Err(_elapsed) => return ConnectionEnd::Silent,
            };
            let wait = self.messages.book(Instant::now());
            // Even a wait of zero would be rounded up to a tick of the timer.
            if !wait.is_zero() {
                sleep(wait).await;
            }
            match message {
                Message::Text(text) => self.text(&text),
                Message::Binary(bytes) => self.binary(&bytes),
                // The library answers these itself.
                Message::Ping(_) | Message::Pong(_) | Message::Close(_) | Message::Frame(_) => {}
            }
        }
    }

    fn text(&mut self, text: &str) {
        let number = self.who.number;
        match FromClient::decode(text) {
            Ok(FromClient::Subscribe { subscriptions }) => {
                if subscriptions.len() > MOST_SUBSCRIPTIONS {
                    let text = format!("at most {MOST_SUBSCRIPTIONS} subscriptions in a message");
                    return self.send_error(text);
                }
                self.publisher.command(HubCommand::Subscribe(number, subscriptions));
            }
            Ok(FromClient::Unsubscribe { subscription_ids }) => {
                self.publisher.command(HubCommand::Unsubscribe(number, subscription_ids));
            }
            Ok(FromClient::SubscribeParameterUpdates { parameter_names }) => {
                self.publisher.command(HubCommand::Watch(number, parameter_names));
            }
            Ok(FromClient::UnsubscribeParameterUpdates { parameter_names }) => {
                self.publisher.command(HubCommand::Unwatch(number, parameter_names));
            }
            Ok(FromClient::GetParameters { parameter_names, id }) => {
                self.ask(Receipt::Parameters(id), ClientRequest::Get(parameter_names));
            }
            Ok(FromClient::SetParameters { parameters, id }) => {
                self.ask(Receipt::Parameters(id), ClientRequest::Set(parameters));
            }
            Ok(FromClient::Other) => {
                self.send_error("this host has not said that it could do this".to_owned());
            }
            Err(error) => self.send_error(error.to_string()),
        }
    }

    fn binary(&mut self, bytes: &[u8]) {
        let (service, call, encoding, payload) = match ClientFrame::decode(bytes) {
            Ok(ClientFrame::Request { service, call, encoding, payload }) => {
                (service, call, encoding, payload)
            }
            Err(error) => return self.send_error(error.to_string()),
        };
        let request = request(service, encoding, payload);
        self.ask(Receipt::Call(service, call), ClientRequest::Call(request));
    }

    fn ask(&mut self, receipt: Receipt, request: ClientRequest) {
        let answer = PendingAnswer { receipt, request };
        let queue = if answer.is_urgent() { &self.urgent } else { &self.asked };
        // A stop is executed however many other requests there are.
        if !answer.is_urgent() && !self.requests.take(Instant::now()) {
            let text = "too many requests come at once: this one was not done, ask more slowly";
            return answer.receipt.refuse(&self.outbox, text.to_owned());
        }
        if let Err(full) = queue.try_send(answer) {
            let text = "too many requests wait already: this one was not done, ask more slowly";
            full.into_inner().receipt.refuse(&self.outbox, text.to_owned());
        }
    }

    fn send_error(&self, text: String) {
        self.outbox.status(Level::Error, text, None);
    }
}

fn request(service: u32, encoding: &str, payload: &[u8]) -> Result<Request, String> {
    let service =
        Service::numbered(service).ok_or_else(|| format!("there is no service {service} here"))?;
    if encoding != "json" {
        return Err(format!("{} is asked in json", service.name()));
    }
    service.request(payload)
}
