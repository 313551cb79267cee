//! A client of the stream without our library, as other people's viewers and web pages.
#![expect(clippy::wildcard_enum_match_arm, reason = "a test looks for one thing")]

use std::net::TcpStream;
use std::time::Duration;

use telemetry::stream::protocol::{
    ClientFrame, FromClient, FromServer, ParameterValue, ServerFrame, Service, Subscription,
    Text as _, channel_id,
};
use telemetry::{Request, Topic};
use tokio_tungstenite::tungstenite::client::{ClientRequestBuilder, client_with_config};
use tokio_tungstenite::tungstenite::{Error, HandshakeError, Message, WebSocket};

/// Maximum wait, for any machine: it only ends failed tests.
const PATIENCE: Duration = Duration::from_mins(1);

pub(crate) struct Stranger(WebSocket<TcpStream>);

impl Stranger {
    /// Connects to `url`, as `ws://127.0.0.1:8765`, or returns the status of the rejection.
    pub(crate) fn knock(url: &str, headers: &[(&str, &str)]) -> Result<Self, u16> {
        let address = url.strip_prefix("ws://").expect("an address");
        let stream = TcpStream::connect(address).expect("a connection");
        stream.set_read_timeout(Some(PATIENCE)).expect("a time limit");
        let uri = format!("{url}/").parse().expect("a URI");
        let mut request = ClientRequestBuilder::new(uri).with_sub_protocol("foxglove.sdk.v1");
        for (name, value) in headers {
            request = request.with_header(*name, *value);
        }
        match client_with_config(request, stream, None) {
            Ok((socket, _response)) => Ok(Self(socket)),
            Err(HandshakeError::Failure(Error::Http(response))) => Err(response.status().as_u16()),
            Err(other) => unreachable!("{other}"),
        }
    }

    pub(crate) fn say(&mut self, message: &FromClient) {
        let text = message.encode().expect("a text");
        self.0.send(Message::text(text)).expect("it is sent");
    }

    /// Returns the next text that `found` accepts.
    pub(crate) fn hear<T>(&mut self, found: impl Fn(FromServer) -> Option<T>) -> T {
        loop {
            if let Message::Text(text) = self.0.read().expect("a message")
                && let Some(found) = found(FromServer::decode(&text).expect("a text"))
            {
                return found;
            }
        }
    }

    pub(crate) fn watch(&mut self) {
        let subscription = Subscription { id: 1, channel_id: channel_id(Topic::Overview) };
        self.say(&FromClient::Subscribe { subscriptions: vec![subscription] });
        self.hear_message(|message| match message {
            Message::Binary(bytes) => {
                matches!(ServerFrame::decode(bytes), Ok(ServerFrame::Message { .. })).then_some(())
            }
            _ => None,
        });
    }

    pub(crate) fn read_values(&mut self) {
        self.say(&FromClient::GetParameters { parameter_names: vec![], id: Some("get".into()) });
        self.hear(|said| match said {
            FromServer::ParameterValues { id: Some(id), .. } if id == "get" => Some(()),
            _ => None,
        });
    }

    /// Returns the result of `request`, even if not advertised; `None` without a service for it.
    pub(crate) fn ask(&mut self, request: &Request) -> Option<Result<(), String>> {
        if let Request::Set { changes } = request {
            let parameters = changes.iter().map(|it| ParameterValue::new(it.name(), it.value));
            let (parameters, id) = (parameters.collect(), Some("set".to_owned()));
            self.say(&FromClient::SetParameters { parameters, id });
        } else {
            let service = Service::of(request)?.id();
            let payload = Service::payload(request);
            let call =
                ClientFrame::Request { service, call: 1, encoding: "json", payload: &payload };
            self.0.send(Message::binary(call.encode())).expect("it is sent");
        }
        Some(self.hear_message(answer))
    }

    /// Returns the next message that `found` accepts.
    fn hear_message<T>(&mut self, found: impl Fn(&Message) -> Option<T>) -> T {
        loop {
            if let Some(found) = found(&self.0.read().expect("a message")) {
                return found;
            }
        }
    }
}

/// Returns the result of a request, if this is its answer.
fn answer(message: &Message) -> Option<Result<(), String>> {
    match message {
        Message::Binary(bytes) => {
            matches!(ServerFrame::decode(bytes), Ok(ServerFrame::Response { .. })).then_some(Ok(()))
        }
        Message::Text(text) => match FromServer::decode(text).expect("a text") {
            FromServer::ParameterValues { reply: Some(_), .. } => Some(Ok(())),
            FromServer::ServiceCallFailure { message, .. }
            | FromServer::Status { message, id: Some(_), .. } => Some(Err(message)),
            _ => None,
        },
        _ => None,
    }
}
