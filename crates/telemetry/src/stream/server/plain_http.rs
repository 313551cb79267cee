//! Requests at the stream's port that ask for no WebSocket: the metrics, or a proper rejection.
//!
//! The head of every request is read here first; a request for a WebSocket is passed on unread.

use std::io::{self, Cursor};
use std::net::{IpAddr, SocketAddr};

use tokio::io::{AsyncReadExt as _, AsyncWriteExt as _};
use tokio_tungstenite::tungstenite::handshake::server::Request;
use tokio_tungstenite::tungstenite::http::{StatusCode, header};

use super::admission::{self, AdmissionError};
use super::state::ServerState;
use crate::metrics::{CONTENT_TYPE, lost_messages};
use crate::stream::byte_stream::BoxedStream;

/// Longest head of a request (bytes), as for the WebSocket library.
const MOST_HEAD: usize = 16 << 10;

/// Most header fields of a request, as for the WebSocket library.
const MOST_HEADERS: usize = 124;

const METRICS: &str = "/metrics";

/// Reads the head of a request from `stream`. Returns the stream as if unread, if a WebSocket is
/// requested; anything else is answered here.
pub(super) async fn websocket_or_answer(
    state: &ServerState,
    mut stream: BoxedStream,
    address: SocketAddr,
) -> Option<BoxedStream> {
    let head = read_head(&mut stream).await.ok()?;
    let request = parse(&head);
    let settings = &state.settings;
    if request.as_ref().is_some_and(|request| admission::guesses(&settings.tokens, request)) {
        tokio::time::sleep(settings.limits.wrong_token).await;
    }
    if request.as_ref().is_some_and(asks_for_websocket) {
        let (reader, writer) = tokio::io::split(stream);
        return Some(Box::new(tokio::io::join(Cursor::new(head).chain(reader), writer)));
    }
    let answer = match &request {
        Some(request) => answer(state, request, address),
        None => PlainAnswer::refusal(StatusCode::BAD_REQUEST, "this is no request of HTTP"),
    };
    let wants_head = request.is_some_and(|request| request.method() == "HEAD");
    let text = if wants_head { "" } else { answer.text.as_str() };
    let _sent = stream.write_all((answer.head() + text).as_bytes()).await;
    let _closed = stream.shutdown().await;
    None
}

async fn read_head(stream: &mut BoxedStream) -> io::Result<Vec<u8>> {
    let mut head = Vec::new();
    while !head.windows(4).any(|it| it == b"\r\n\r\n") && head.len() < MOST_HEAD {
        if stream.read_buf(&mut head).await? == 0 {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
    }
    Ok(head)
}

fn parse(head: &[u8]) -> Option<Request> {
    let mut fields = [httparse::EMPTY_HEADER; MOST_HEADERS];
    let mut parsed = httparse::Request::new(&mut fields);
    parsed.parse(head).ok().filter(httparse::Status::is_complete)?;
    let mut request = Request::builder().method(parsed.method?).uri(parsed.path?);
    for field in parsed.headers.iter() {
        request = request.header(field.name, field.value);
    }
    request.body(()).ok()
}

fn asks_for_websocket(request: &Request) -> bool {
    let upgrade = request.headers().get(header::UPGRADE);
    upgrade.is_some_and(|it| it.as_bytes().eq_ignore_ascii_case(b"websocket"))
}

struct PlainAnswer {
    status: StatusCode,
    /// Further header fields, each with its end of line.
    fields: &'static str,
    content_type: &'static str,
    text: String,
}

impl PlainAnswer {
    fn refusal(status: StatusCode, text: &str) -> Self {
        let (fields, content_type) = ("", "text/plain; charset=utf-8");
        Self { status, fields, content_type, text: format!("{text}\n") }
    }

    fn head(&self) -> String {
        let Self { status, fields, content_type, text } = self;
        format!(
            "HTTP/1.1 {status}\r\n{fields}Content-Type: {content_type}\r\nContent-Length: {}\r\n\
             Cache-Control: no-store\r\nConnection: close\r\n\r\n",
            text.len()
        )
    }
}

fn answer(state: &ServerState, request: &Request, address: SocketAddr) -> PlainAnswer {
    let is_read = request.method() == "GET" || request.method() == "HEAD";
    match request.uri().path() {
        METRICS if !is_read => PlainAnswer {
            fields: "Allow: GET, HEAD\r\n",
            ..PlainAnswer::refusal(StatusCode::METHOD_NOT_ALLOWED, "metrics are read with GET")
        },
        METRICS => metrics(state, request, address),
        "/" => PlainAnswer {
            fields: "Upgrade: websocket\r\n",
            ..PlainAnswer::refusal(
                StatusCode::UPGRADE_REQUIRED,
                "this is the stream of a letoff host: open it with `letoff dash` or another \
                 viewer of foxglove.sdk.v1; its figures are at /metrics",
            )
        },
        _ => PlainAnswer::refusal(
            StatusCode::NOT_FOUND,
            "there is nothing here but the stream at / and its figures at /metrics",
        ),
    }
}

fn metrics(state: &ServerState, request: &Request, address: SocketAddr) -> PlainAnswer {
    if let Err(error) = may_read(state, request, address) {
        state.backend.refused(address, error.text());
        return PlainAnswer::refusal(error.status(), error.text());
    }
    match state.backend.metrics() {
        Some(text) => PlainAnswer {
            status: StatusCode::OK,
            fields: "",
            content_type: CONTENT_TYPE,
            text: text + &lost_messages(state.publisher.lost()),
        },
        None => PlainAnswer::refusal(StatusCode::NOT_FOUND, "this host has no figures"),
    }
}

/// Returns `true` for a client with a token, a program of this machine, or a listed web page.
fn may_read(
    state: &ServerState,
    request: &Request,
    address: SocketAddr,
) -> Result<(), AdmissionError> {
    admission::check_origin(&state.settings.origins, request.headers())?;
    if address.ip().is_loopback() && names_this_machine(request) {
        return Ok(());
    }
    admission::role(&state.settings.tokens, request).map(drop)
}

/// Returns `true` if the request was made to this machine by its own name or address. A page with
/// another name that leads here is not one of its programs.
fn names_this_machine(request: &Request) -> bool {
    let host = request.headers().get(header::HOST).and_then(|host| host.to_str().ok());
    let Some(host) = host else { return true };
    let name = match host.parse::<SocketAddr>() {
        Ok(address) => return address.ip().is_loopback(),
        Err(_no_port) => host.rsplit_once(':').map_or(host, |(name, _port)| name),
    };
    let address = name.trim_matches(['[', ']']).parse::<IpAddr>();
    name.eq_ignore_ascii_case("localhost") || address.is_ok_and(|it| it.is_loopback())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_this_machine_s_own_names_are_its_own() {
        let host = |host: &str| {
            let request = Request::builder().uri("/metrics").header("Host", host);
            names_this_machine(&request.body(()).expect("a request"))
        };
        for own in ["localhost", "LOCALHOST:8765", "127.0.0.1:8765", "127.0.0.1", "[::1]:8765"] {
            assert!(host(own), "{own}");
        }
        for foreign in ["evil.example", "evil.example:8765", "localhost.evil.example", "10.0.0.1:1"]
        {
            assert!(!host(foreign), "{foreign}");
        }
    }

    #[test]
    fn what_is_no_request_is_not_taken_for_one() {
        for foreign in [&b"\x16\x03\x01\r\n\r\n"[..], b"GET / HTTP/9.9\r\n\r\n", b"GET /\r\n\r\n"] {
            assert!(parse(foreign).is_none(), "{foreign:?}");
        }
        let request = parse(b"GET /metrics?token=x HTTP/1.1\r\nHost: a\r\n\r\n").expect("one");
        assert_eq!(request.uri().path(), METRICS);
    }
}
