//! Options of the stream to dashboards and viewers.

use std::io;
use std::net::SocketAddr;
use std::path::{Path, PathBuf};

use clap::Args;
use telemetry::stream::server::Tls;
use telemetry::stream::{Role, Server, Settings};

use super::{tell, tokens};

/// Where and to whom the host streams.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Stream to dashboards and viewers")]
pub struct StreamArgs {
    /// Where it streams: an address and port, or `none`. Anything but this machine needs
    /// --tokens and --tls.
    #[arg(long, value_name = "ADDRESS:PORT|none", default_value = DEFAULT)]
    pub listen: String,
    /// A file with who may do what: lines of `viewer`, `tuner` or `owner` and a secret.
    #[arg(long, value_name = "FILE")]
    pub tokens: Option<PathBuf>,
    /// Encrypts the stream: with a certificate and key (PEM), or one that is made here.
    #[arg(long, value_name = "self-made|CHAIN.pem,KEY.pem")]
    pub tls: Option<String>,
    /// Web pages from there may connect, as `https://app.foxglove.dev`.
    #[arg(long, value_name = "ORIGIN")]
    pub origin: Vec<String>,
    /// Streams beyond this machine without tokens and encryption, on a network that you trust.
    #[arg(long)]
    pub insecure: bool,
}

/// What Foxglove's own viewers look for first.
const DEFAULT: &str = "127.0.0.1:8765";

/// The stream that the options ask for.
#[derive(Debug)]
pub(super) struct Wanted {
    settings: Settings,
    /// Nobody asked for it: it is what is done without options.
    is_usual: bool,
}

impl StreamArgs {
    /// The stream that the options ask for, if any; `folder` keeps a certificate of our own.
    ///
    /// # Errors
    /// What is wrong with them, in a sentence.
    pub(super) fn wanted(&self, name: &str, folder: &Path) -> Result<Option<Wanted>, String> {
        if self.listen == "none" {
            return Ok(None);
        }
        let address: SocketAddr = self.listen.parse().map_err(|_no_address| {
            format!("--listen {} is no address and port: write {DEFAULT} or none", self.listen)
        })?;
        let settings = Settings {
            address,
            name: format!("letoff: {name}"),
            origins: self.origin.clone(),
            tokens: self.tokens.as_deref().map_or_else(|| Ok(Vec::new()), tokens::read)?,
            tls: self.tls.as_deref().map(|tls| certificate(tls, folder)).transpose()?,
            insecure: self.insecure,
            ..Settings::default()
        };
        settings.check().map_err(|error| error.to_string())?;
        let is_usual = self.listen == DEFAULT && self.tokens.is_none() && self.tls.is_none();
        Ok(Some(Wanted { settings, is_usual }))
    }
}

impl Wanted {
    /// Listens; nothing if it cannot and nobody asked for it.
    ///
    /// # Errors
    /// Why it cannot, in a sentence.
    pub(super) fn listen(&self) -> Result<Option<Server>, String> {
        let Self { settings, is_usual } = self;
        let listened = match Server::listen(settings.clone()) {
            // Another host has the usual port; who looks for this one asks it.
            Err(error) if error.kind() == io::ErrorKind::AddrInUse && *is_usual => {
                let address = SocketAddr::new(settings.address.ip(), 0);
                Server::listen(Settings { address, ..settings.clone() })
            }
            listened => listened,
        };
        match listened {
            // A machine without a network plays all the same.
            Err(error) if *is_usual => {
                tell(&format!("nothing is streamed: {error}"));
                Ok(None)
            }
            listened => listened.map(Some).map_err(|error| error.to_string()),
        }
    }

    /// The secret of an owner, if there are secrets.
    pub(super) fn owner(&self) -> Option<String> {
        let owner = self.settings.tokens.iter().find(|token| token.role == Role::Owner)?;
        Some(owner.secret.clone())
    }
}

fn certificate(text: &str, folder: &Path) -> Result<Tls, String> {
    match text.split_once(',') {
        Some((chain, key)) => Ok(Tls::Files { chain: chain.into(), key: key.into() }),
        None if text == "self-made" => {
            Ok(Tls::SelfMade { names: vec!["localhost".into()], folder: Some(folder.to_owned()) })
        }
        None => Err(format!(
            "--tls {text} names no key: write CHAIN.pem,KEY.pem with a comma between, or self-made"
        )),
    }
}
