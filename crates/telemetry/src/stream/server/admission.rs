//! Admission of clients by their origin, protocol and token.

use subtle::ConstantTimeEq as _;
use tokio_tungstenite::tungstenite::handshake::server::{ErrorResponse, Request};
use tokio_tungstenite::tungstenite::http::{HeaderMap, Response, StatusCode, header};

use super::{Role, ServerSettings, Token};
use crate::stream::protocol::SUBPROTOCOLS;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum AdmissionError {
    Origin,
    Protocol,
    NoToken,
    Token,
    Full,
}

impl AdmissionError {
    pub(super) const fn status(self) -> StatusCode {
        match self {
            Self::Origin => StatusCode::FORBIDDEN,
            Self::Protocol => StatusCode::BAD_REQUEST,
            Self::NoToken | Self::Token => StatusCode::UNAUTHORIZED,
            Self::Full => StatusCode::SERVICE_UNAVAILABLE,
        }
    }

    pub(super) const fn text(self) -> &'static str {
        match self {
            Self::Origin => {
                "this web page may not connect: add its origin to those that the host lets in"
            }
            Self::Protocol => "this host speaks foxglove.sdk.v1: ask for it as the subprotocol",
            Self::NoToken => {
                "this host asks for a token: give it as ?token=... or as a Bearer; `letoff dash \
                 --print` on its machine tells it to its user"
            }
            Self::Token => {
                "this host does not know the given token, which may be of an earlier run: `letoff \
                 dash --print` on its machine prints the present one to its user"
            }
            Self::Full => "this host has as many clients as it takes: close one of them",
        }
    }

    pub(super) fn response(self) -> ErrorResponse {
        let mut response = Response::new(Some(format!("{}\n", self.text())));
        *response.status_mut() = self.status();
        let length = header::HeaderValue::from(self.text().len() + 1);
        response.headers_mut().insert(header::CONTENT_LENGTH, length);
        let close = header::HeaderValue::from_static("close");
        response.headers_mut().insert(header::CONNECTION, close);
        response
    }
}

pub(super) fn admit(
    settings: &ServerSettings,
    request: &Request,
) -> Result<(Role, &'static str), AdmissionError> {
    check_origin(&settings.origins, request.headers())?;
    let protocol = protocol(request.headers())?;
    Ok((role(&settings.tokens, request)?, protocol))
}

/// Checks the origin: a program sends none, a page's must be listed.
pub(super) fn check_origin(listed: &[String], headers: &HeaderMap) -> Result<(), AdmissionError> {
    let is_listed = |origin: &header::HeaderValue| {
        listed.iter().any(|it| origin.as_bytes().eq_ignore_ascii_case(it.as_bytes()))
    };
    let all_listed = headers.get_all(header::ORIGIN).iter().all(is_listed);
    if all_listed { Ok(()) } else { Err(AdmissionError::Origin) }
}

fn protocol(headers: &HeaderMap) -> Result<&'static str, AdmissionError> {
    let offered: Vec<&str> = headers
        .get_all(header::SEC_WEBSOCKET_PROTOCOL)
        .iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|value| value.split(',').map(str::trim))
        .collect();
    SUBPROTOCOLS.into_iter().find(|ours| offered.contains(ours)).ok_or(AdmissionError::Protocol)
}

/// Returns the role of the request's token; an error if one is needed and not known.
pub(super) fn role(tokens: &[Token], request: &Request) -> Result<Role, AdmissionError> {
    if tokens.is_empty() {
        return Ok(Role::Owner);
    }
    let given = given(request).ok_or(AdmissionError::NoToken)?;
    // All are compared to the end, so that the time reveals nothing.
    let known =
        tokens.iter().filter(|token| bool::from(token.secret.as_bytes().ct_eq(given.as_bytes())));
    known.map(|token| token.role).max().ok_or(AdmissionError::Token)
}

/// Returns `true` if a request has an unknown token, as a guessing client does.
pub(super) fn guesses(tokens: &[Token], request: &Request) -> bool {
    !tokens.is_empty() && given(request).is_some() && role(tokens, request).is_err()
}

fn given(request: &Request) -> Option<&str> {
    bearer(request.headers()).or_else(|| queried(request.uri().query()?))
}

fn bearer(headers: &HeaderMap) -> Option<&str> {
    let (scheme, token) = headers.get(header::AUTHORIZATION)?.to_str().ok()?.split_once(' ')?;
    scheme.eq_ignore_ascii_case("bearer").then_some(token.trim())
}

fn queried(query: &str) -> Option<&str> {
    query.split('&').find_map(|pair| pair.strip_prefix("token="))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings() -> ServerSettings {
        let token = |secret: &str, role| Token { secret: secret.to_owned(), role };
        ServerSettings {
            origins: vec!["https://app.example".to_owned()],
            tokens: vec![token("see", Role::Viewer), token("tune", Role::Tuner)],
            ..ServerSettings::default()
        }
    }

    fn try_admit(uri: &str, headers: &[(&str, &str)]) -> Result<Role, AdmissionError> {
        let mut builder = Request::builder().uri(uri);
        for (name, value) in headers {
            builder = builder.header(*name, *value);
        }
        let request = builder.body(()).expect("a request");
        admit(&settings(), &request).map(|(role, _)| role)
    }

    const PROTOCOL: (&str, &str) = ("Sec-WebSocket-Protocol", "other, foxglove.sdk.v1");

    #[test]
    fn a_token_makes_the_role() {
        assert_eq!(try_admit("/?token=see", &[PROTOCOL]), Ok(Role::Viewer));
        assert_eq!(try_admit("/?a=b&token=tune", &[PROTOCOL]), Ok(Role::Tuner));
        assert_eq!(try_admit("/", &[PROTOCOL, ("Authorization", "Bearer tune")]), Ok(Role::Tuner));
        for wrong in ["/?token=", "/?token=tun", "/?token=tunes"] {
            assert_eq!(try_admit(wrong, &[PROTOCOL]), Err(AdmissionError::Token), "{wrong}");
        }
        for none in ["/", "/?Token=tune"] {
            assert_eq!(try_admit(none, &[PROTOCOL]), Err(AdmissionError::NoToken), "{none}");
        }
        assert_eq!(
            try_admit("/?token=see", &[PROTOCOL, ("Authorization", "Bearer x")]),
            Err(AdmissionError::Token)
        );
    }

    #[test]
    fn only_listed_pages_come_in() {
        let from = |origin| try_admit("/?token=see", &[PROTOCOL, ("Origin", origin)]);
        assert_eq!(from("https://app.example"), Ok(Role::Viewer));
        for evil in ["null", "https://app.example.evil", "http://app.example", ""] {
            assert_eq!(from(evil), Err(AdmissionError::Origin), "{evil}");
        }
        let two = [PROTOCOL, ("Origin", "https://app.example"), ("Origin", "https://evil.example")];
        assert_eq!(try_admit("/?token=see", &two), Err(AdmissionError::Origin));
    }

    #[test]
    fn both_names_of_the_protocol_are_spoken_and_no_other() {
        let old = ("sec-websocket-protocol", "foxglove.websocket.v1");
        assert_eq!(try_admit("/?token=see", &[old]), Ok(Role::Viewer));
        assert_eq!(try_admit("/?token=see", &[]), Err(AdmissionError::Protocol));
        let other = ("sec-websocket-protocol", "foxglove.sdk.v2");
        assert_eq!(try_admit("/?token=see", &[other]), Err(AdmissionError::Protocol));
    }
}
