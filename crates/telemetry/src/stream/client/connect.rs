//! Connects to an address: TCP, TLS, then WebSocket.

use std::time::Duration;

use tokio::{net::TcpStream, time::timeout};
use tokio_rustls::rustls::pki_types::ServerName;
use tokio_tungstenite::tungstenite::Error;
use tokio_tungstenite::tungstenite::client::ClientRequestBuilder;
use tokio_tungstenite::tungstenite::handshake::client::Response;
use tokio_tungstenite::tungstenite::http::StatusCode;
use tokio_tungstenite::tungstenite::protocol::WebSocketConfig;
use tokio_tungstenite::{WebSocketStream, client_async_with_config};

use super::address::{HostAddress, Scheme};
use super::{Dial, pin};
use crate::stream::{byte_stream::BoxedStream, protocol::SUBPROTOCOLS};

const PATIENCE: Duration = Duration::from_secs(10);

/// Longest message from a host (bytes).
const MOST_BYTES: usize = 64 << 20;

#[derive(Debug)]
pub(super) enum ConnectError {
    Lost(String),
    Refused(String),
}

pub(super) async fn connect(dial: &Dial) -> Result<WebSocketStream<BoxedStream>, ConnectError> {
    let address = HostAddress::parse(&dial.address)
        .map_err(|error| ConnectError::Refused(error.to_string()))?;
    let connected = timeout(PATIENCE, async {
        let stream = open_stream(dial, &address).await?;
        handshake(dial, &address, stream).await
    });
    let slow = || ConnectError::Lost(format!("the host at {} does not answer", dial.address));
    connected.await.unwrap_or_else(|_elapsed| Err(slow()))
}

async fn open_stream(dial: &Dial, address: &HostAddress) -> Result<BoxedStream, ConnectError> {
    let lost = |error| ConnectError::Lost(format!("no host answers at {}: {error}", dial.address));
    let stream = TcpStream::connect((address.host.as_str(), address.port)).await.map_err(lost)?;
    stream.set_nodelay(true).map_err(lost)?;
    match address.scheme {
        Scheme::Ws => Ok(Box::new(stream)),
        Scheme::Wss => encrypted(dial, address, stream).await,
    }
}

async fn encrypted(
    dial: &Dial,
    address: &HostAddress,
    stream: TcpStream,
) -> Result<BoxedStream, ConnectError> {
    let pin = dial.pin.ok_or_else(|| {
        let text = "wss:// needs the fingerprint of the host's certificate, which the host prints";
        ConnectError::Refused(text.to_owned())
    })?;
    let refused = |text: String| ConnectError::Refused(text);
    let connector = pin::connector(pin).map_err(|error| refused(error.to_string()))?;
    let name = ServerName::try_from(address.host.clone());
    let name = name.map_err(|error| refused(format!("{}: {error}", dial.address)))?;
    match connector.connect(name, stream).await {
        Ok(stream) => Ok(Box::new(stream)),
        Err(error) => Err(pin::refusal(&error).map_or_else(
            || ConnectError::Lost(format!("the host at {} speaks no TLS: {error}", dial.address)),
            ConnectError::Refused,
        )),
    }
}

async fn handshake(
    dial: &Dial,
    address: &HostAddress,
    stream: BoxedStream,
) -> Result<WebSocketStream<BoxedStream>, ConnectError> {
    let uri = address.uri().ok_or_else(|| ConnectError::Refused(dial.address.clone()))?;
    let mut request = ClientRequestBuilder::new(uri);
    for protocol in SUBPROTOCOLS {
        request = request.with_sub_protocol(protocol);
    }
    if let Some(token) = &dial.token {
        if !token.bytes().all(|byte| byte.is_ascii_graphic()) {
            let text = "the token has other letters in it than a token has";
            return Err(ConnectError::Refused(text.to_owned()));
        }
        request = request.with_header("Authorization", format!("Bearer {token}"));
    }
    let config = WebSocketConfig::default()
        .max_message_size(Some(MOST_BYTES))
        .max_frame_size(Some(MOST_BYTES));
    match client_async_with_config(request, stream, Some(config)).await {
        Ok((socket, _response)) => Ok(socket),
        Err(error) => Err(connect_error(dial, error)),
    }
}

fn connect_error(dial: &Dial, error: Error) -> ConnectError {
    if let Error::Http(response) = error {
        return http_error(dial, &response);
    }
    ConnectError::Lost(format!("the host at {} speaks no WebSocket: {error}", dial.address))
}

fn http_error(dial: &Dial, response: &Response) -> ConnectError {
    let body = response.body().as_deref().unwrap_or_default();
    let text = String::from_utf8_lossy(body).trim().to_owned();
    let text = if text.is_empty() {
        format!("the host at {} answered {}", dial.address, response.status())
    } else {
        text
    };
    let will_not = [StatusCode::UNAUTHORIZED, StatusCode::FORBIDDEN, StatusCode::BAD_REQUEST];
    if will_not.contains(&response.status()) {
        ConnectError::Refused(text)
    } else {
        ConnectError::Lost(text)
    }
}
