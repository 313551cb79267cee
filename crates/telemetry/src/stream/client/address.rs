//! The address of a host.

use tokio_tungstenite::tungstenite::http::Uri;

const PORT: u16 = 8765;

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct HostAddress {
    pub(super) scheme: Scheme,
    /// A name or an IP address, without brackets.
    pub(super) host: String,
    pub(super) port: u16,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Scheme {
    Ws,
    Wss,
}

#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("{0:?} is no host's address: give one as ws://127.0.0.1:8765")]
pub(super) struct NoAddress(String);

impl HostAddress {
    pub(super) fn parse(text: &str) -> Result<Self, NoAddress> {
        let no_address = || NoAddress(text.to_owned());
        let (scheme, rest) = match text.trim().split_once("://") {
            Some(("ws", rest)) => (Scheme::Ws, rest),
            Some(("wss", rest)) => (Scheme::Wss, rest),
            Some(_) => return Err(no_address()),
            None => (Scheme::Ws, text.trim()),
        };
        let uri: Uri = format!("ws://{rest}").parse().map_err(|_no_uri| no_address())?;
        let host = uri.host().ok_or_else(no_address)?;
        let port = match uri.authority().and_then(|it| it.as_str().strip_prefix(host)) {
            Some("") => Some(PORT),
            Some(port) => port.strip_prefix(':').and_then(|digits| digits.parse().ok()),
            // A user name precedes the host.
            None => None,
        };
        let host = host.trim_start_matches('[').trim_end_matches(']').to_owned();
        let is_plain = uri.path() == "/" && uri.query().is_none();
        if host.is_empty() || !is_plain {
            return Err(no_address());
        }
        Ok(Self { scheme, host, port: port.ok_or_else(no_address)? })
    }

    pub(super) fn uri(&self) -> Option<Uri> {
        let is_ipv6 = self.host.contains(':');
        let host = if is_ipv6 { format!("[{}]", self.host) } else { self.host.clone() };
        let scheme = match self.scheme {
            Scheme::Ws => "ws",
            Scheme::Wss => "wss",
        };
        format!("{scheme}://{host}:{}/", self.port).parse().ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, scheme: Scheme, host: &str, port: u16) {
        let address = HostAddress { scheme, host: host.to_owned(), port };
        assert_eq!(HostAddress::parse(text), Ok(address));
    }

    #[test]
    fn scheme_and_port_may_be_left_out() {
        check("ws://127.0.0.1:9000", Scheme::Ws, "127.0.0.1", 9000);
        check("wss://piano.local", Scheme::Wss, "piano.local", 8765);
        check("localhost", Scheme::Ws, "localhost", 8765);
        check(" localhost:1 ", Scheme::Ws, "localhost", 1);
        check("wss://[::1]:9000/", Scheme::Wss, "::1", 9000);
    }

    #[test]
    fn what_is_none_is_refused() {
        for text in ["", "http://x", "ws://", "ws://a b", "ws://x:99999", "ws://x/path", "u@x"] {
            assert!(HostAddress::parse(text).is_err(), "{text}");
        }
    }
}
