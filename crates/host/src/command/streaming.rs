//! Options of the stream to dashboards and viewers.

use std::io;
use std::net::SocketAddr;
use std::path::{Path, PathBuf};

use clap::Args;
use telemetry::stream::server::{Tls, Token};
use telemetry::stream::{Role, Server, Settings};

use super::tell;

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

/// Longest file of tokens [bytes].
const LONGEST: u64 = 1 << 16;

impl StreamArgs {
    /// The server that the options ask for, if any; `folder` keeps a certificate of our own.
    ///
    /// # Errors
    /// What is wrong, in a sentence.
    pub(super) fn server(&self, name: &str, folder: &Path) -> Result<Option<Server>, String> {
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
            tokens: self.tokens.as_deref().map_or_else(|| Ok(Vec::new()), tokens)?,
            tls: self.tls.as_deref().map(|tls| certificate(tls, folder)),
            insecure: self.insecure,
            ..Settings::default()
        };
        let is_usual = self.listen == DEFAULT && self.tokens.is_none() && self.tls.is_none();
        let listened = match Server::listen(settings.clone()) {
            // Another host has the usual port; who looks for this one asks it.
            Err(error) if error.kind() == io::ErrorKind::AddrInUse && is_usual => {
                Server::listen(Settings { address: SocketAddr::new(address.ip(), 0), ..settings })
            }
            listened => listened,
        };
        match listened {
            // Nobody asked for it: a machine without a network plays all the same.
            Err(error) if is_usual => {
                tell(&format!("nothing is streamed: {error}"));
                Ok(None)
            }
            listened => listened.map(Some).map_err(|error| error.to_string()),
        }
    }

    /// The secret of an owner, if there are secrets.
    pub(super) fn owner(&self) -> Option<String> {
        let tokens = tokens(self.tokens.as_deref()?).ok()?;
        tokens.into_iter().find(|token| token.role == Role::Owner).map(|token| token.secret)
    }
}

fn certificate(text: &str, folder: &Path) -> Tls {
    match text.split_once(',') {
        Some((chain, key)) => Tls::Files { chain: chain.into(), key: key.into() },
        None => Tls::SelfMade { names: vec!["localhost".into()], folder: Some(folder.to_owned()) },
    }
}

/// Reads who may do what.
fn tokens(file: &Path) -> Result<Vec<Token>, String> {
    use std::io::Read as _;
    let wrong = |what: &str| format!("{}: {what}", file.display());
    let opened = std::fs::File::open(file).map_err(|error| wrong(&error.to_string()))?;
    let mut text = String::new();
    let read = opened.take(LONGEST).read_to_string(&mut text);
    read.map_err(|error| wrong(&error.to_string()))?;
    let lines = (1..).zip(text.lines().map(str::trim));
    lines
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
        .map(|(n, line)| {
            let (role, secret) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
            let role =
                [Role::Viewer, Role::Tuner, Role::Owner].into_iter().find(|it| it.name() == role);
            match (role, secret.trim()) {
                (Some(role), secret) if !secret.is_empty() => {
                    Ok(Token { secret: secret.into(), role })
                }
                (Some(_) | None, _) => Err(wrong(&format!(
                    "line {n} is not `viewer SECRET`, `tuner SECRET` or `owner SECRET`"
                ))),
            }
        })
        .collect()
}
