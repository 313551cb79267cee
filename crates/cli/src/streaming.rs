//! Options of the stream to dashboards and viewers.

use std::io;
use std::net::SocketAddr;
use std::path::PathBuf;

use boards::calibration::file::usual_folder;
use clap::Args;
use telemetry::recording::RecordingLimits;
use telemetry::stream::server::{Tls, Token};
use telemetry::stream::{Role, ServerSettings, StreamServer};

use super::{Failure, tell, tokens};
use host::control::Folders;

/// Where and to whom the host streams.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Stream to dashboards and viewers")]
pub struct StreamArgs {
    /// Where it streams: an address and port, or `none`; 127.0.0.1:8765 without, or another port if
    /// that one is taken. Anything but this machine needs --tokens and --tls.
    #[arg(long, value_name = "ADDRESS:PORT|none")]
    pub listen: Option<String>,
    /// A file with who may do what: lines of `viewer`, `tuner` or `owner` and a secret. Without
    /// it there is one secret, made for this run, that this user's `letoff dash` learns.
    #[arg(long, value_name = "FILE")]
    pub tokens: Option<PathBuf>,
    /// Encrypts the stream: with a certificate and key (PEM), or one that is made here.
    #[arg(long, value_name = "self-made|CHAIN.pem,KEY.pem")]
    pub tls: Option<String>,
    /// Web pages from there may connect, as `https://app.foxglove.dev`.
    #[arg(long, value_name = "ORIGIN")]
    pub origin: Vec<String>,
    /// Lets everybody who reaches the stream do everything, without tokens and encryption: every
    /// user of this machine, and whoever is on its network.
    #[arg(long)]
    pub insecure: bool,
    /// Where recordings go that clients begin; in the user's own folder for what programs leave
    /// behind if none is given.
    #[arg(long, value_name = "FOLDER")]
    pub recordings: Option<PathBuf>,
    /// Where instruments are that clients may use beside those of the program; the user's own
    /// folder of instruments if none is given.
    #[arg(long, value_name = "FOLDER")]
    pub instruments: Option<PathBuf>,
}

/// Address that Foxglove's own viewers try first.
const DEFAULT: &str = "127.0.0.1:8765";

#[derive(Debug)]
pub(super) struct WantedStream {
    settings: ServerSettings,
    pub(super) folders: Folders,
    /// `true` for the default, without an option.
    is_usual: bool,
}

impl StreamArgs {
    /// Returns the requested stream, if any; `folder` keeps our own certificate between runs.
    pub(super) fn wanted(
        &self,
        name: &str,
        folder: Option<PathBuf>,
    ) -> Result<Option<WantedStream>, String> {
        let listen = self.listen.as_deref().unwrap_or(DEFAULT);
        if listen == "none" {
            return Ok(None);
        }
        let address: SocketAddr = listen.parse().map_err(|_no_address| {
            format!("--listen {listen} is no address and port: write {DEFAULT} or none")
        })?;
        let mut settings = ServerSettings {
            address,
            name: format!("letoff: {name}"),
            origins: self.origin.clone(),
            tokens: self.tokens.as_deref().map_or_else(|| Ok(Vec::new()), tokens::read)?,
            tls: self.tls.as_deref().map(|tls| certificate(tls, folder)).transpose()?,
            insecure: self.insecure,
            ..ServerSettings::default()
        };
        settings.check().map_err(|error| error.to_string())?;
        if settings.tokens.is_empty() && !self.insecure {
            // Every user of this machine can reach its loopback.
            settings.tokens.push(Token::random(Role::Owner).map_err(|error| error.to_string())?);
        }
        let is_usual = self.listen.is_none() && self.tokens.is_none() && self.tls.is_none();
        Ok(Some(WantedStream { settings, folders: self.folders(), is_usual }))
    }

    /// Returns the folders in which clients may name files: those given, or the user's own.
    fn folders(&self) -> Folders {
        let recordings = || Some(own_state_folder()?.join("recordings"));
        let instruments = || Some(usual_folder()?.with_file_name("instruments"));
        Folders {
            recordings: self.recordings.clone().or_else(recordings),
            limits: RecordingLimits::default(),
            instruments: self.instruments.clone().or_else(instruments),
        }
    }
}

/// Returns the user's own folder for state files, if the user has a home.
pub(super) fn own_state_folder() -> Option<PathBuf> {
    let home = || std::env::var_os("HOME").map(|home| PathBuf::from(home).join(".local/state"));
    let state = std::env::var_os("XDG_STATE_HOME").map(PathBuf::from).or_else(home)?;
    Some(state.join("letoff"))
}

/// Returns the user's own folder for files that can be made again, if the user has a home.
pub(super) fn own_cache_folder() -> Option<PathBuf> {
    let home = || std::env::var_os("HOME").map(|home| PathBuf::from(home).join(".cache"));
    let cache = std::env::var_os("XDG_CACHE_HOME").map(PathBuf::from).or_else(home)?;
    Some(cache.join("letoff"))
}

impl WantedStream {
    /// Listens; `None` if it cannot and no option asks for it.
    ///
    /// # Errors
    /// A sentence with the cause; an address that is taken or not there yet may be free later.
    pub(super) fn listen(&self) -> Result<Option<StreamServer>, Failure> {
        let Self { settings, is_usual, .. } = self;
        let listened = match StreamServer::listen(settings.clone()) {
            // Another host has the default port; clients ask this one for its port.
            Err(error) if error.kind() == io::ErrorKind::AddrInUse && *is_usual => {
                let address = SocketAddr::new(settings.address.ip(), 0);
                StreamServer::listen(ServerSettings { address, ..settings.clone() })
            }
            listened => listened,
        };
        match listened {
            // A machine without a network plays nevertheless.
            Err(error) if *is_usual => {
                tell(&format!("nothing is streamed: {error}"));
                Ok(None)
            }
            listened => listened.map(Some).map_err(|error| {
                let text = error.to_string();
                if matches!(
                    error.kind(),
                    io::ErrorKind::AddrInUse | io::ErrorKind::AddrNotAvailable
                ) {
                    return Failure::Running(text);
                }
                Failure::Usage(text)
            }),
        }
    }

    pub(super) fn news(&self, url: &str) -> String {
        let wanted = self.settings.address;
        if self.is_usual && !url.ends_with(&wanted.to_string()) {
            return format!("streams at {url}, since another program has {wanted}");
        }
        format!("streams at {url}")
    }

    pub(super) fn owner(&self) -> Option<String> {
        let owner = self.settings.tokens.iter().find(|token| token.role == Role::Owner)?;
        Some(owner.secret.clone())
    }
}

fn certificate(text: &str, folder: Option<PathBuf>) -> Result<Tls, String> {
    match text.split_once(',') {
        Some((chain, key)) => Ok(Tls::Files { chain: chain.into(), key: key.into() }),
        None if text == "self-made" => {
            Ok(Tls::SelfMade { names: vec!["localhost".into()], folder })
        }
        None => Err(format!(
            "--tls {text} names no key: write CHAIN.pem,KEY.pem with a comma between, or self-made"
        )),
    }
}
