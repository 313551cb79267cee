//! One client, from its first message to its end.

mod answer;
mod read;
mod token_bucket;
mod write;

use std::{collections::BTreeMap, pin::pin, sync::Arc, time::Duration};

use futures_util::StreamExt as _;
use tokio::{sync::mpsc, time::timeout};
use tokio_tungstenite::{WebSocketStream, tungstenite::Message};

use answer::Answerer;
use read::RequestReader;

use super::hub_handle::HubCommand;
use super::outbox::Outbox;
use super::state::ServerState;
use super::{Publisher, Role, ServerSettings, Who};
use crate::stream::byte_stream::BoxedStream;
use crate::stream::protocol::{FromServer, Service, Text as _, channels};

/// Longest time for the last answers of a closing server, and for the client to read them.
const CLOSING: Duration = Duration::from_secs(1);

/// Requests of a client that wait for earlier ones; more are rejected.
const WAITING: usize = 64;

pub(super) async fn run(state: &Arc<ServerState>, socket: WebSocketStream<BoxedStream>, who: Who) {
    let limits = &state.settings.limits;
    let (outbox, control) = Outbox::new(limits);
    let outbox = Arc::new(outbox);
    outbox.tell(&information(&state.settings, who.role));
    outbox.send(state.advertised.clone());
    outbox.tell(&services(who.role));
    let _member = Membership::join(&state.publisher, who, &outbox);
    let (mut sink, mut stream) = socket.split();
    let (asked, to_answer) = mpsc::channel(WAITING);
    let (urgent, to_answer_first) = mpsc::channel(WAITING);
    let answerer = Answerer::new(Arc::clone(state), Arc::clone(&outbox), who);
    let presence = Presence::begin(&answerer);
    let mut reader = RequestReader::new(state, Arc::clone(&outbox), who, asked, urgent);
    let mut writing = Box::pin(write::run(&mut sink, control, &outbox, limits));
    let mut answering =
        pin!(async { tokio::join!(answerer.run(to_answer), answerer.run(to_answer_first)) });
    let end = tokio::select! {
        end = reader.run(&mut stream) => end,
        end = &mut writing => end,
        _ended = &mut answering => ConnectionEnd::Left,
        () = outbox.cut() => ConnectionEnd::Stalled,
        () = state.closing() => ConnectionEnd::Over,
    };
    // Nothing more is read from the client: the pending answers are completed.
    drop(reader);
    if end == ConnectionEnd::Over {
        let last_answers = async {
            answering.await;
            outbox.finish();
            writing.as_mut().await
        };
        let _sent = timeout(CLOSING, last_answers).await;
    }
    drop(writing);
    drop(presence);
    write::close(&mut sink, end, &state.reason()).await;
    if end == ConnectionEnd::Over {
        // A client that is still reading gets what was sent; otherwise it might be lost.
        let _gone = timeout(CLOSING, async { while stream.next().await.is_some() {} }).await;
    }
}

/// Registration of a client with the backend, until it is dropped.
struct Presence(Answerer);

impl Presence {
    fn begin(answerer: &Answerer) -> Self {
        answerer.arrive();
        Self(answerer.clone())
    }
}

impl Drop for Presence {
    fn drop(&mut self) {
        self.0.leave();
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum ConnectionEnd {
    Left,
    Stalled,
    Silent,
    TooLarge,
    Over,
}

/// Registration of a client with the hub, until it is dropped.
struct Membership {
    publisher: Publisher,
    number: u64,
}

impl Membership {
    fn join(publisher: &Publisher, who: Who, outbox: &Arc<Outbox>) -> Self {
        publisher.command(HubCommand::Join(who.number, Arc::clone(outbox)));
        Self { publisher: publisher.clone(), number: who.number }
    }
}

impl Drop for Membership {
    fn drop(&mut self) {
        self.publisher.command(HubCommand::Leave(self.number));
    }
}

fn information(settings: &ServerSettings, role: Role) -> FromServer {
    let capabilities = ["parameters", "parametersSubscribe", "services"];
    FromServer::ServerInfo {
        name: settings.name.clone(),
        capabilities: capabilities.into_iter().map(str::to_owned).collect(),
        supported_encodings: Some(vec!["json".to_owned()]),
        metadata: Some(BTreeMap::from([("role".to_owned(), role.name().to_owned())])),
        session_id: Some(settings.session.clone()),
    }
}

pub(super) fn advertised() -> Message {
    let advertise = FromServer::Advertise { channels: channels() };
    Message::text(advertise.encode().unwrap_or_default())
}

fn services(role: Role) -> FromServer {
    let may_ask = |service: &Service| Role::for_service(*service) <= role;
    let services = Service::ALL.into_iter().filter(may_ask).map(Service::advertised).collect();
    FromServer::AdvertiseServices { services }
}
