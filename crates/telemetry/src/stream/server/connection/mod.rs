//! One client, from its first message to its end.

mod answer;
mod bucket;
mod read;
mod write;

use std::collections::BTreeMap;
use std::sync::Arc;

use futures_util::StreamExt as _;
use tokio::sync::mpsc;
use tokio_tungstenite::WebSocketStream;
use tokio_tungstenite::tungstenite::Message;

use answer::Answerer;
use read::Reader;

use super::accept::House;
use super::hub::Command;
use super::outbox::Outbox;
use super::{Publisher, Role, Settings, Who};
use crate::stream::carrier::Boxed;
use crate::stream::protocol::{FromServer, Service, Text as _, channels};

/// Requests of a client that wait for those before; more are refused.
const WAITING: usize = 64;

/// Talks with `who` until either side has enough.
pub(super) async fn hold(house: &Arc<House>, socket: WebSocketStream<Boxed>, who: Who) {
    let limits = &house.settings.limits;
    let (outbox, control) = Outbox::new(limits);
    let outbox = Arc::new(outbox);
    outbox.tell(&information(&house.settings, who.role));
    outbox.send(house.advertised.clone());
    if who.role > Role::Viewer {
        outbox.tell(&services());
    }
    let _member = Membership::join(&house.publisher, who, &outbox);
    let (mut sink, stream) = socket.split();
    let (asked, to_answer) = mpsc::channel(WAITING);
    let (urgent, to_answer_first) = mpsc::channel(WAITING);
    let answerer = Answerer::new(Arc::clone(house), Arc::clone(&outbox), who);
    let mut reader = Reader::new(house, Arc::clone(&outbox), who, asked, urgent);
    let end = tokio::select! {
        end = reader.run(stream) => end,
        end = write::run(&mut sink, control, &outbox, limits) => end,
        () = answerer.run(to_answer) => End::Left,
        () = answerer.run(to_answer_first) => End::Left,
        () = outbox.cut() => End::Stalled,
    };
    write::bid_farewell(&mut sink, end).await;
}

/// How a conversation ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum End {
    /// The client went.
    Left,
    /// It does not take what is sent.
    Stalled,
    /// Nothing is heard of it.
    Silent,
    /// It sent more at once than is taken.
    TooLarge,
}

/// That somebody is there, as long as this is.
struct Membership {
    publisher: Publisher,
    number: u64,
}

impl Membership {
    fn join(publisher: &Publisher, who: Who, outbox: &Arc<Outbox>) -> Self {
        publisher.command(Command::Join(who.number, Arc::clone(outbox)));
        Self { publisher: publisher.clone(), number: who.number }
    }
}

impl Drop for Membership {
    fn drop(&mut self) {
        self.publisher.command(Command::Leave(self.number));
    }
}

/// Who we are, and what somebody in this role can ask.
fn information(settings: &Settings, role: Role) -> FromServer {
    let mut capabilities = vec!["parameters", "parametersSubscribe"];
    if role > Role::Viewer {
        capabilities.push("services");
    }
    FromServer::ServerInfo {
        name: settings.name.clone(),
        capabilities: capabilities.into_iter().map(str::to_owned).collect(),
        supported_encodings: Some(vec!["json".to_owned()]),
        metadata: Some(BTreeMap::from([("role".to_owned(), role.name().to_owned())])),
        session_id: Some(settings.session.clone()),
    }
}

/// What can be followed: the same for everybody, and long.
pub(super) fn advertised() -> Message {
    let advertise = FromServer::Advertise { channels: channels() };
    Message::text(advertise.encode().unwrap_or_default())
}

fn services() -> FromServer {
    let services = Service::ALL.into_iter().map(Service::advertised).collect();
    FromServer::AdvertiseServices { services }
}
