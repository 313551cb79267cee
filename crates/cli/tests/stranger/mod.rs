//! A client of the stream that talks as it pleases, as other people's viewers and web pages do.
#![allow(dead_code, reason = "each test program uses its own part")]

use std::net::TcpStream;
use std::time::Duration;

use telemetry::stream::protocol::{FromClient, FromServer, Text as _};
use tokio_tungstenite::tungstenite::client::{ClientRequestBuilder, client_with_config};
use tokio_tungstenite::tungstenite::{Error, HandshakeError, Message, WebSocket};

/// Long enough for any machine: it only ends what has failed.
const PATIENCE: Duration = Duration::from_mins(1);

pub(crate) struct Stranger(WebSocket<TcpStream>);

impl Stranger {
    /// Comes in at `url`, as `ws://127.0.0.1:8765`, with more headers; or the status of the
    /// refusal.
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

    /// The next text that `found` takes.
    pub(crate) fn hear<T>(&mut self, found: impl Fn(FromServer) -> Option<T>) -> T {
        loop {
            if let Message::Text(text) = self.0.read().expect("a message")
                && let Some(found) = found(FromServer::decode(&text).expect("a text"))
            {
                return found;
            }
        }
    }
}
