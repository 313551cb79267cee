//! How a server listens, and what it puts up with.

use std::io;
use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::time::Duration;

use ring::rand::SecureRandom as _;

use super::Role;

/// How a server listens.
#[derive(Clone, Debug)]
pub struct ServerSettings {
    /// The address; port 0 takes any that is free.
    pub address: SocketAddr,
    /// The name that viewers show.
    pub name: String,
    /// The name of the run, by which viewers know that another one has begun.
    pub session: String,
    /// Web pages that may connect, as `https://app.example`; programs send no origin.
    pub origins: Vec<String>,
    /// Tokens and what each allows; without any, every client is an owner.
    pub tokens: Vec<Token>,
    /// How it is encrypted, if it is.
    pub tls: Option<Tls>,
    /// Listens even where others could read along or need no token.
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

/// A secret, and what it is good for.
#[derive(Clone)]
pub struct Token {
    /// At least [`Self::SHORTEST`] letters, digits and `-._~`, so that it can stand in an address.
    pub secret: String,
    pub role: Role,
}

impl Token {
    /// Fewest characters of a secret: 64 random bits in hexadecimal digits.
    pub const SHORTEST: usize = 16;

    /// Makes a token of `role` with a secret of 256 random bits.
    ///
    /// # Errors
    /// If the system gives no random numbers.
    pub fn random(role: Role) -> io::Result<Self> {
        let mut bytes = [0; 32];
        let filled = ring::rand::SystemRandom::new().fill(&mut bytes);
        filled.map_err(|_none| io::Error::other("the system gives no random numbers"))?;
        let digits = bytes.into_iter().flat_map(|byte| [byte >> 4, byte & 0xf]);
        let secret = digits.filter_map(|digit| char::from_digit(digit.into(), 16)).collect();
        Ok(Self { secret, role })
    }

    /// Returns whether the secret can stand in an address as it is.
    pub fn is_plain(&self) -> bool {
        let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~".contains(&byte);
        self.secret.bytes().all(is_plain)
    }

    /// Returns whether nobody can guess the secret, if it is random.
    pub const fn is_long(&self) -> bool {
        Self::SHORTEST <= self.secret.len()
    }
}

impl std::fmt::Debug for Token {
    /// Leaves out the secret, which must not get into a log.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Token").field("role", &self.role).finish_non_exhaustive()
    }
}

/// Where a certificate comes from.
#[derive(Clone, Debug)]
pub enum Tls {
    /// From files in PEM form.
    Files {
        /// The server's certificate, and those that vouch for it.
        chain: PathBuf,
        key: PathBuf,
    },
    /// Self-made, for names or addresses; clients recognise it by its fingerprint.
    SelfMade {
        /// Names and addresses of the machine.
        names: Vec<String>,
        /// The folder in which it is kept; without, it is another one in each run.
        folder: Option<PathBuf>,
    },
}

/// The limits of a server.
#[derive(Clone, Copy, Debug)]
pub struct ServerLimits {
    /// Clients at once; the next ones are turned away.
    pub clients: usize,
    /// Of these, places that only owners take.
    pub owners: usize,
    /// Clients at once that are not in yet; the next one takes the place of the oldest.
    pub handshakes: usize,
    /// Longest message from a client (bytes).
    pub message_bytes: usize,
    /// Messages from a client (1/s); one that sends more is read more slowly.
    pub messages_per_second: u32,
    /// Requests from a client (1/s); more are refused.
    pub requests_per_second: u32,
    /// Data that waits for a slow client (bytes); the oldest are dropped.
    pub data_bytes: usize,
    /// Replies and the like that wait for a slow client; one with more is cut.
    pub control_messages: usize,
    /// The same (bytes).
    pub control_bytes: usize,
    /// Longest time to get in.
    pub handshake: Duration,
    /// Time until a wrong token is refused.
    pub wrong_token: Duration,
    /// Longest time in which a client takes nothing; then it is cut.
    pub stall: Duration,
    /// Longest time in which nothing is heard of a client, which is pinged three times meanwhile.
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

/// Why a server does not listen as it is told.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum Unsafe {
    /// Beyond this machine, without what keeps others out.
    #[error(
        "the stream would listen at {0} without {1}: give it both --tokens and --tls, or listen at \
         127.0.0.1"
    )]
    Open(SocketAddr, &'static str),
    /// A token that cannot stand in an address.
    #[error("a token of the stream has other than letters, digits and -._~ in it")]
    Token,
    /// A token that can be guessed.
    #[error(
        "a token of the stream has fewer than {shortest} characters: `openssl rand -hex 16` makes \
         one that nobody guesses",
        shortest = Token::SHORTEST
    )]
    Short,
    /// An origin that any page can send.
    #[error(
        "the origin {0:?} is no web page's: give the page's scheme and name, as https://app.example"
    )]
    Origin(String),
}

impl ServerSettings {
    /// Checks that the settings are safe; a server listens with no others.
    ///
    /// # Errors
    /// If they are not, and why.
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

    /// Returns what is missing to keep other machines out.
    const fn missing_protection(&self) -> Option<&'static str> {
        match (self.tokens.is_empty(), self.tls.is_none()) {
            (true, true) => Some("tokens and TLS"),
            (true, false) => Some("tokens"),
            (false, true) => Some("TLS"),
            (false, false) => None,
        }
    }
}

/// Returns whether a web page can have this origin: a scheme and a name, without a path.
///
/// Every sandboxed frame has the origin "null", of whatever page it is.
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
