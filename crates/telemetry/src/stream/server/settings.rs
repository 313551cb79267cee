//! Settings and limits of a server.

use std::net::{Ipv4Addr, SocketAddr};
use std::{io, path::PathBuf, time::Duration};

use ring::rand::SecureRandom as _;

use super::Role;

/// Settings of a server.
#[derive(Clone, Debug)]
pub struct ServerSettings {
    pub address: SocketAddr,
    /// Name that viewers show.
    pub name: String,
    /// Name of the run, by which viewers recognise a new one.
    pub session: String,
    /// Web pages that may connect, as `https://app.example`; programs send no origin.
    pub origins: Vec<String>,
    /// Tokens with their roles; if empty, every client is an owner.
    pub tokens: Vec<Token>,
    pub tls: Option<Tls>,
    /// Allows addresses at which others could read along or need no token.
    pub insecure: bool,
    pub limits: ServerLimits,
}

impl Default for ServerSettings {
    /// Listens for programs of this machine, at port 8765.
    fn default() -> Self {
        Self {
            address: SocketAddr::from((Ipv4Addr::LOCALHOST, 8765)),
            name: "letoff".to_owned(),
            session: String::new(),
            origins: Vec::new(),
            tokens: Vec::new(),
            tls: None,
            insecure: false,
            limits: ServerLimits::default(),
        }
    }
}

/// A secret, and the role that it grants.
#[derive(Clone)]
pub struct Token {
    /// At least [`Self::SHORTEST`] letters, digits and `-._~`, so that it is valid in an address.
    pub secret: String,
    pub role: Role,
}

impl Token {
    /// Fewest characters of a secret: 64 random bits in hexadecimal digits.
    pub const SHORTEST: usize = 16;

    /// Makes a token of `role` with a secret of 256 random bits, if the system has random numbers.
    pub fn random(role: Role) -> io::Result<Self> {
        let mut bytes = [0; 32];
        let filled = ring::rand::SystemRandom::new().fill(&mut bytes);
        filled.map_err(|_none| io::Error::other("the system gives no random numbers"))?;
        let digits = bytes.into_iter().flat_map(|byte| [byte >> 4, byte & 0xf]);
        let secret = digits.filter_map(|digit| char::from_digit(digit.into(), 16)).collect();
        Ok(Self { secret, role })
    }

    /// Returns `true` if the secret is valid in an address as it is.
    pub fn is_plain(&self) -> bool {
        let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~".contains(&byte);
        self.secret.bytes().all(is_plain)
    }

    /// Returns `true` if the secret is long enough not to be guessed, if random.
    pub const fn is_long(&self) -> bool {
        Self::SHORTEST <= self.secret.len()
    }
}

impl std::fmt::Debug for Token {
    /// Omits the secret, which must not get into a log.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Token").field("role", &self.role).finish_non_exhaustive()
    }
}

/// Source of a certificate.
#[derive(Clone, Debug)]
pub enum Tls {
    /// Files in PEM form.
    Files {
        /// The server's certificate, and those that vouch for it.
        chain: PathBuf,
        key: PathBuf,
    },
    /// Self-made, for names or addresses; clients recognise it by its fingerprint.
    SelfMade {
        names: Vec<String>,
        /// Folder that keeps it; if `None`, each run has another one.
        folder: Option<PathBuf>,
    },
}

/// Limits of a server.
#[derive(Clone, Copy, Debug)]
pub struct ServerLimits {
    /// Clients at once; further ones are rejected.
    pub clients: usize,
    /// Places among these for owners only.
    pub owners: usize,
    /// Clients at once before admission; the next one replaces the oldest.
    pub handshakes: usize,
    /// Longest message from a client (bytes).
    pub message_bytes: usize,
    /// Messages from a client (1/s); one that sends more is read more slowly.
    pub messages_per_second: u32,
    /// Requests from a client (1/s); more are rejected.
    pub requests_per_second: u32,
    /// Data that waits for a slow client (bytes); the oldest are dropped.
    pub data_bytes: usize,
    /// Replies and the like that wait for a slow client; one with more is cut.
    pub control_messages: usize,
    pub control_bytes: usize,
    pub handshake: Duration,
    /// Time until a wrong token is rejected.
    pub wrong_token: Duration,
    /// Longest time in which a client reads nothing; then it is cut.
    pub stall: Duration,
    /// Longest time in which a client sends nothing; it is pinged three times meanwhile.
    pub idle: Duration,
}

impl Default for ServerLimits {
    fn default() -> Self {
        Self {
            clients: 64,
            owners: 8,
            handshakes: 256,
            message_bytes: 1 << 20,
            messages_per_second: 1000,
            requests_per_second: 200,
            data_bytes: 8 << 20,
            control_messages: 1024,
            control_bytes: 16 << 20,
            handshake: Duration::from_secs(5),
            wrong_token: Duration::from_millis(250),
            stall: Duration::from_secs(10),
            idle: Duration::from_secs(30),
        }
    }
}

/// Reason why a server rejects its settings.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum Unsafe {
    #[error(
        "the stream would listen at {0} without {1}: give it both --tokens and --tls, or listen at \
         127.0.0.1"
    )]
    Open(SocketAddr, &'static str),
    #[error("a token of the stream has other than letters, digits and -._~ in it")]
    Token,
    #[error(
        "a token of the stream has fewer than {shortest} characters: `openssl rand -hex 16` makes \
         one that nobody guesses",
        shortest = Token::SHORTEST
    )]
    Short,
    #[error(
        "the origin {0:?} is no web page's: give the page's scheme and name, as https://app.example"
    )]
    Origin(String),
}

impl ServerSettings {
    pub fn check(&self) -> Result<(), Unsafe> {
        let is_open = !self.address.ip().is_loopback() && !self.insecure;
        if let Some(lack) = self.missing_protection().filter(|_lack| is_open) {
            return Err(Unsafe::Open(self.address, lack));
        }
        if !self.tokens.iter().all(Token::is_plain) {
            return Err(Unsafe::Token);
        }
        if !self.tokens.iter().all(Token::is_long) {
            return Err(Unsafe::Short);
        }
        match self.origins.iter().find(|origin| !is_origin(origin)) {
            Some(origin) => Err(Unsafe::Origin(origin.clone())),
            None => Ok(()),
        }
    }

    /// Returns the protection that is missing against other machines.
    const fn missing_protection(&self) -> Option<&'static str> {
        match (self.tokens.is_empty(), self.tls.is_none()) {
            (true, true) => Some("tokens and TLS"),
            (true, false) => Some("tokens"),
            (false, true) => Some("TLS"),
            (false, false) => None,
        }
    }
}

/// Returns `true` if a web page can have this origin: a scheme and a name, without a path. Every
/// sandboxed frame has the origin "null", whatever its page.
fn is_origin(text: &str) -> bool {
    let parts = text.split_once("://");
    parts.is_some_and(|(scheme, name)| {
        !scheme.is_empty() && !name.is_empty() && !name.contains(['/', '*', ' '])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn open() -> ServerSettings {
        ServerSettings {
            address: SocketAddr::from((Ipv4Addr::UNSPECIFIED, 0)),
            ..ServerSettings::default()
        }
    }

    fn token(secret: &str) -> Vec<Token> {
        vec![Token { secret: secret.to_owned(), role: Role::Viewer }]
    }

    #[test]
    fn other_machines_need_a_token_and_tls() {
        assert_eq!(ServerSettings::default().check(), Ok(()));
        let open_without = |lack| Err(Unsafe::Open(open().address, lack));
        assert_eq!(open().check(), open_without("tokens and TLS"));
        let with_token = ServerSettings { tokens: token("sixteen-or-more-1"), ..open() };
        assert_eq!(with_token.check(), open_without("TLS"));
        let tls = Some(Tls::SelfMade { names: vec![], folder: None });
        assert_eq!(ServerSettings { tls: tls.clone(), ..open() }.check(), open_without("tokens"));
        assert_eq!(ServerSettings { tls, ..with_token }.check(), Ok(()));
        assert_eq!(ServerSettings { insecure: true, ..open() }.check(), Ok(()));
    }

    #[test]
    fn secrets_and_origins_are_what_can_be_compared() {
        for secret in ["two words", "a&b", "ä"] {
            let settings = ServerSettings { tokens: token(secret), ..ServerSettings::default() };
            assert_eq!(settings.check(), Err(Unsafe::Token), "{secret}");
        }
        for origin in ["null", "", "*", "https://", "https://app.example/", "https://*.example"] {
            let settings =
                ServerSettings { origins: vec![origin.to_owned()], ..ServerSettings::default() };
            assert_eq!(settings.check(), Err(Unsafe::Origin(origin.to_owned())), "{origin}");
        }
        let origins = vec!["https://app.example:8443".to_owned()];
        assert_eq!(ServerSettings { origins, ..ServerSettings::default() }.check(), Ok(()));
    }

    #[test]
    fn a_secret_that_can_be_guessed_is_refused() {
        for (secret, refused) in [
            ("", Err(Unsafe::Short)),
            ("012345678901234", Err(Unsafe::Short)),
            ("0123456789012345", Ok(())),
        ] {
            let settings = ServerSettings { tokens: token(secret), ..ServerSettings::default() };
            assert_eq!(settings.check(), refused, "{secret}");
        }
    }

    #[test]
    fn a_random_secret_is_another_each_time_and_can_stand_in_an_address() {
        let one = Token::random(Role::Owner).expect("random numbers");
        let other = Token::random(Role::Owner).expect("random numbers");
        assert!(one.is_plain() && one.secret.len() == 64 && one.secret != other.secret);
    }

    #[test]
    fn a_secret_is_not_shown() {
        assert!(!format!("{:?}", token("abracadabra")).contains("abracadabra"));
    }
}
