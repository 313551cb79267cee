//! One connection, from the host's first message to its end.

use std::collections::{BTreeMap, BTreeSet};
use std::time::Duration;

use futures_util::{SinkExt as _, StreamExt as _};
use tokio::sync::mpsc::UnboundedReceiver;
use tokio::time::{Instant, timeout};
use tokio_tungstenite::WebSocketStream;
use tokio_tungstenite::tungstenite::{Bytes, Message, protocol::CloseFrame};

use super::{arrivals::Arrivals, command::ClientCommand};
use crate::stream::protocol::{
    ClientFrame, FromClient, FromServer, Level, ParameterValue, ServerFrame, Service, Subscription,
    Text as _,
};
use crate::stream::{Role, byte_stream::BoxedStream};
use crate::{Arrival, Log, Reply, Request, Topic, Update, log, source::Ticket};

const PING: Duration = Duration::from_secs(5);

/// Longest time without a message from the host, or without progress in sending.
const PATIENCE: Duration = Duration::from_secs(20);

const GRACE: Duration = Duration::from_secs(1);

#[derive(Debug)]
pub(super) enum SessionEnd {
    Gone,
    Lost(String),
}

pub(super) struct ClientSession<'a> {
    socket: WebSocketStream<BoxedStream>,
    arrivals: &'a Arrivals,
    channels: BTreeMap<Topic, u32>,
    subscriptions: BTreeMap<u32, Topic>,
    /// Subscriptions without a message yet.
    fresh: BTreeSet<u32>,
    services: BTreeMap<String, u32>,
    /// `true` until the announced services are named.
    awaits_services: bool,
    waiting: Vec<(Ticket, Request)>,
    sets: BTreeMap<String, Ticket>,
    calls: BTreeMap<u32, Ticket>,
    count: u32,
    /// Time of the newest message (ns since 1970).
    at: u64,
}

type ToSend = Vec<Message>;

impl<'a> ClientSession<'a> {
    pub(super) const fn new(socket: WebSocketStream<BoxedStream>, arrivals: &'a Arrivals) -> Self {
        Self {
            socket,
            arrivals,
            channels: BTreeMap::new(),
            subscriptions: BTreeMap::new(),
            fresh: BTreeSet::new(),
            services: BTreeMap::new(),
            awaits_services: false,
            waiting: Vec::new(),
            sets: BTreeMap::new(),
            calls: BTreeMap::new(),
            count: 0,
            at: 0,
        }
    }

    /// Runs until either side ends; answers every request.
    pub(super) async fn run(
        mut self,
        commands: &mut UnboundedReceiver<ClientCommand>,
        wanted: &mut BTreeSet<Topic>,
    ) -> SessionEnd {
        let end = self.exchange(commands, wanted).await;
        let waiting = self.waiting.iter().map(|(ticket, _)| *ticket);
        for ticket in self.sets.values().chain(self.calls.values()).copied().chain(waiting) {
            let text = "the connection was lost before the host answered: whether it was done is \
                        not known";
            answer(self.arrivals, ticket, Err(text.to_owned()));
        }
        if matches!(end, SessionEnd::Gone) {
            let _heard = timeout(GRACE, self.socket.close(None)).await;
        }
        end
    }

    async fn exchange(
        &mut self,
        commands: &mut UnboundedReceiver<ClientCommand>,
        wanted: &mut BTreeSet<Topic>,
    ) -> SessionEnd {
        let mut pings = tokio::time::interval(PING);
        let mut heard = Instant::now();
        loop {
            let to_send = tokio::select! {
                message = self.socket.next() => match message {
                    Some(Ok(Message::Close(frame))) => return SessionEnd::Lost(close_reason(frame)),
                    Some(Ok(message)) => {
                        heard = Instant::now();
                        self.receive(message, wanted)
                    }
                    Some(Err(error)) => return SessionEnd::Lost(format!("the connection broke: {error}")),
                    None => return SessionEnd::Lost(close_reason(None)),
                },
                command = commands.recv() => match command {
                    Some(ClientCommand::Follow(topics)) => {
                        *wanted = topics;
                        self.follow(wanted)
                    }
                    Some(ClientCommand::Ask(ticket, request)) => self.ask(ticket, request),
                    None => return SessionEnd::Gone,
                },
                _now = pings.tick() => vec![Message::Ping(Bytes::new())],
            };
            if heard.elapsed() > PATIENCE {
                return SessionEnd::Lost("nothing is heard of the host any more".to_owned());
            }
            if let Err(text) = self.send(to_send).await {
                return SessionEnd::Lost(text);
            }
        }
    }

    async fn send(&mut self, messages: ToSend) -> Result<(), String> {
        for message in messages {
            match timeout(PATIENCE, self.socket.send(message)).await {
                Ok(Ok(())) => {}
                Ok(Err(error)) => return Err(format!("the connection broke: {error}")),
                Err(_elapsed) => return Err("the host takes nothing any more".to_owned()),
            }
        }
        Ok(())
    }

    fn receive(&mut self, message: Message, wanted: &BTreeSet<Topic>) -> ToSend {
        match message {
            Message::Text(text) => match FromServer::decode(&text) {
                Ok(message) => self.text(message, wanted),
                Err(error) => self.note(Level::Warning, error.to_string()),
            },
            Message::Binary(bytes) => match ServerFrame::decode(&bytes) {
                Ok(frame) => self.frame(&frame),
                Err(error) => self.note(Level::Warning, error.to_string()),
            },
            Message::Ping(_) | Message::Pong(_) | Message::Close(_) | Message::Frame(_) => vec![],
        }
    }

    fn text(&mut self, message: FromServer, wanted: &BTreeSet<Topic>) -> ToSend {
        match message {
            FromServer::ServerInfo { capabilities, metadata, .. } => {
                self.awaits_services = capabilities.iter().any(|it| it == "services");
                let role = metadata.and_then(|it| Role::named(it.get("role")?));
                self.arrivals.begin(role);
                vec![]
            }
            FromServer::Advertise { channels } => {
                let known = channels.iter().filter(|it| it.encoding == "protobuf");
                let numbers = known.filter_map(|it| Some((Topic::named(&it.topic)?, it.id)));
                self.channels.extend(numbers);
                self.follow(wanted)
            }
            FromServer::Unadvertise { channel_ids } => {
                self.channels.retain(|_, id| !channel_ids.contains(id));
                let channels = &self.channels;
                self.subscriptions.retain(|_, topic| channels.contains_key(topic));
                vec![]
            }
            FromServer::AdvertiseServices { services } => {
                self.services.extend(services.into_iter().map(|it| (it.name, it.id)));
                self.ask_waiting()
            }
            FromServer::UnadvertiseServices { service_ids } => {
                self.services.retain(|_, id| !service_ids.contains(id));
                vec![]
            }
            FromServer::Status { level, message, id } => self.status(level, message, id),
            FromServer::ParameterValues { id, reply, .. } => {
                let reply = reply.unwrap_or_else(|| Reply::Done { text: "done".to_owned() });
                self.answer_set(id, Ok(reply));
                vec![]
            }
            FromServer::ServiceCallFailure { call_id, message, .. } => {
                self.answer_call(call_id, Err(message));
                vec![]
            }
            FromServer::Other => vec![],
        }
    }

    fn ask_waiting(&mut self) -> ToSend {
        self.awaits_services = false;
        let waiting = std::mem::take(&mut self.waiting);
        waiting.into_iter().flat_map(|(ticket, request)| self.ask(ticket, request)).collect()
    }

    fn frame(&mut self, frame: &ServerFrame<'_>) -> ToSend {
        match *frame {
            ServerFrame::Message { subscription, at, payload } => {
                // A message on its way when the topic was left is of no use.
                let Some(topic) = self.subscriptions.get(&subscription) else { return vec![] };
                self.at = at;
                let mut update = match Update::decode(*topic, payload) {
                    Ok(update) => update,
                    Err(error) => return self.note(Level::Warning, error.to_string()),
                };
                if self.fresh.remove(&subscription)
                    && let Update::Block(block) = &mut update
                {
                    // A window that followed the key earlier has rows from then.
                    block.mark_missing();
                }
                let update = Box::new(update);
                self.arrivals.push(Arrival::Update { at, update }, payload.len());
                vec![]
            }
            ServerFrame::Response { call, payload, .. } => {
                let reply = serde_json::from_slice(payload);
                let reply = reply.map_err(|error| format!("the host's answer is none: {error}"));
                self.answer_call(call, reply);
                vec![]
            }
            ServerFrame::Time(_) => vec![],
        }
    }

    fn follow(&mut self, wanted: &BTreeSet<Topic>) -> ToSend {
        let left: Vec<u32> = self
            .subscriptions
            .iter()
            .filter(|(_, topic)| !wanted.contains(topic))
            .map(|(id, _)| *id)
            .collect();
        self.subscriptions.retain(|_, topic| wanted.contains(topic));
        self.fresh.retain(|id| self.subscriptions.contains_key(id));
        let followed: BTreeSet<Topic> = self.subscriptions.values().copied().collect();
        let mut subscriptions = Vec::new();
        for topic in wanted.difference(&followed) {
            let Some(channel_id) = self.channels.get(topic).copied() else { continue };
            let id = self.number();
            self.subscriptions.insert(id, *topic);
            self.fresh.insert(id);
            subscriptions.push(Subscription { id, channel_id });
        }
        let mut to_send = Vec::new();
        if !left.is_empty() {
            to_send.extend(written(&FromClient::Unsubscribe { subscription_ids: left }));
        }
        if !subscriptions.is_empty() {
            to_send.extend(written(&FromClient::Subscribe { subscriptions }));
        }
        to_send
    }

    fn ask(&mut self, ticket: Ticket, request: Request) -> ToSend {
        let Some(service) = Service::of(&request) else { return self.set(ticket, request) };
        if self.awaits_services {
            self.waiting.push((ticket, request));
            return vec![];
        }
        let Some(id) = self.services.get(&service.name()).copied() else {
            let text = format!("this host does not let us ask for {}", service.name());
            answer(self.arrivals, ticket, Err(text));
            return vec![];
        };
        let call = self.number();
        self.calls.insert(call, ticket);
        let payload = Service::payload(&request);
        let frame = ClientFrame::Request { service: id, call, encoding: "json", payload: &payload };
        vec![Message::binary(frame.encode())]
    }

    fn set(&mut self, ticket: Ticket, request: Request) -> ToSend {
        let Request::Set { changes } = request else { return vec![] };
        let id = format!("letoff-{}", ticket.0);
        self.sets.insert(id.clone(), ticket);
        let parameters =
            changes.iter().map(|it| ParameterValue::new(it.name(), it.value)).collect();
        written(&FromClient::SetParameters { parameters, id: Some(id) }).into_iter().collect()
    }

    fn status(&mut self, level: Level, message: String, id: Option<String>) -> ToSend {
        let is_refusal = id.as_ref().is_some_and(|id| self.sets.contains_key(id));
        if is_refusal {
            self.answer_set(id, Err(message));
            return vec![];
        }
        self.note(level, message)
    }

    fn note(&self, level: Level, text: String) -> ToSend {
        let level = match level {
            Level::Info => log::Level::Info,
            Level::Warning => log::Level::Warning,
            Level::Error => log::Level::Error,
        };
        let bytes = text.len();
        let update = Box::new(Update::Log(Log { level: level.into(), text }));
        self.arrivals.push(Arrival::Update { at: self.at, update }, bytes);
        vec![]
    }

    fn answer_set(&mut self, id: Option<String>, result: Result<Reply, String>) {
        if let Some(ticket) = id.and_then(|id| self.sets.remove(&id)) {
            answer(self.arrivals, ticket, result);
        }
    }

    fn answer_call(&mut self, call: u32, result: Result<Reply, String>) {
        if let Some(ticket) = self.calls.remove(&call) {
            answer(self.arrivals, ticket, result);
        }
    }

    const fn number(&mut self) -> u32 {
        self.count = self.count.wrapping_add(1);
        self.count
    }
}

fn close_reason(frame: Option<CloseFrame>) -> String {
    match frame {
        Some(frame) if !frame.reason.is_empty() => {
            format!("the host ended the connection: {}", frame.reason)
        }
        Some(_) | None => "the host ended the connection".to_owned(),
    }
}

fn answer(arrivals: &Arrivals, ticket: Ticket, result: Result<Reply, String>) {
    arrivals.push(Arrival::Reply { ticket, result }, 0);
}

fn written(message: &FromClient) -> Option<Message> {
    message.encode().map(Message::text)
}
