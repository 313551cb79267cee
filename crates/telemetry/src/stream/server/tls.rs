//! Certificates, and encryption with them.

use std::{fs, io, path::Path, sync::Arc};

use documents::shown;
use tokio_rustls::TlsAcceptor;
use tokio_rustls::rustls::pki_types::{CertificateDer, PrivateKeyDer, pem::PemObject as _};
use tokio_rustls::rustls::{self, ServerConfig, crypto, version};

use super::Tls;
use crate::stream::Fingerprint;

pub(super) struct TlsIdentity {
    pub(super) fingerprint: Fingerprint,
    pub(super) acceptor: TlsAcceptor,
}

impl std::fmt::Debug for TlsIdentity {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TlsIdentity")
            .field("fingerprint", &self.fingerprint)
            .finish_non_exhaustive()
    }
}

/// A certificate with those that vouch for it, and its key.
type Identity = (Vec<CertificateDer<'static>>, PrivateKeyDer<'static>);

impl TlsIdentity {
    pub(super) fn new(tls: &Tls) -> io::Result<Self> {
        let (chain, key) = match tls {
            Tls::Files { chain, key } => read(chain, key)?,
            Tls::SelfMade { names, folder: None } => {
                let (chain, key) = make(names)?;
                parse(&chain, &key)?
            }
            Tls::SelfMade { names, folder: Some(folder) } => kept(names, folder)?,
        };
        let own = chain.first().ok_or_else(|| wrong("the certificate's file has none in it"))?;
        let fingerprint = Fingerprint::of(own);
        let config = config(chain, key)
            .map_err(|error| wrong(format!("certificate and key do not go together: {error}")))?;
        Ok(Self { fingerprint, acceptor: TlsAcceptor::from(Arc::new(config)) })
    }
}

fn config(
    chain: Vec<CertificateDer<'static>>,
    key: PrivateKeyDer<'static>,
) -> Result<ServerConfig, rustls::Error> {
    let provider = Arc::new(crypto::ring::default_provider());
    ServerConfig::builder_with_provider(provider)
        .with_protocol_versions(&[&version::TLS13])?
        .with_no_client_auth()
        .with_single_cert(chain, key)
}

fn kept(names: &[String], folder: &Path) -> io::Result<Identity> {
    let (chain, key) = (folder.join("certificate.pem"), folder.join("key.pem"));
    if !(chain.exists() && key.exists()) {
        let (chain_text, key_text) = make(names)?;
        let kept = fs::create_dir_all(folder)
            .and_then(|()| write_secret(&key, &key_text))
            .and_then(|()| fs::write(&chain, chain_text));
        kept.map_err(|error| {
            let text = format!(
                "the certificate cannot be kept in {}: {error}; let this user write there, or \
                 give a certificate's files",
                shown(folder)
            );
            io::Error::new(error.kind(), text)
        })?;
    }
    read(&chain, &key)
}

fn write_secret(path: &Path, text: &str) -> io::Result<()> {
    use io::Write as _;

    let mut options = fs::OpenOptions::new();
    options.write(true).create(true).truncate(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    options.open(path)?.write_all(text.as_bytes())
}

fn make(names: &[String]) -> io::Result<(String, String)> {
    let made = rcgen::generate_simple_self_signed(names)
        .map_err(|error| wrong(format!("no certificate can be made for {names:?}: {error}")))?;
    Ok((made.cert.pem(), made.signing_key.serialize_pem()))
}

fn read(chain: &Path, key: &Path) -> io::Result<Identity> {
    let text = |path: &Path| {
        let text = crate::file::open(path).and_then(io::read_to_string);
        text.map_err(|error| {
            io::Error::new(error.kind(), format!("{} cannot be read: {error}", shown(path)))
        })
    };
    parse(&text(chain)?, &text(key)?)
}

fn parse(chain: &str, key: &str) -> io::Result<Identity> {
    let chain: Result<Vec<_>, _> = CertificateDer::pem_slice_iter(chain.as_bytes()).collect();
    let chain = chain.map_err(|error| wrong(format!("the certificate is no PEM: {error}")))?;
    let key = PrivateKeyDer::from_pem_slice(key.as_bytes())
        .map_err(|error| wrong(format!("the certificate's key is no PEM: {error}")))?;
    Ok((chain, key))
}

fn wrong(text: impl Into<String>) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, text.into())
}
