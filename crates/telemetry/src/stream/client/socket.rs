//! The control socket of a host on this machine: one request, one reply.

use std::{io, path::Path, time::Duration};

use tokio::io::{AsyncBufReadExt as _, AsyncReadExt as _, AsyncWriteExt as _, BufReader};
use tokio::{net::UnixStream, time::timeout};

use super::Dial;
use crate::{Reply, Request, stream::Fingerprint};

/// Longest wait for a reply; a stop waits up to 4.5 s for boards that are being armed.
const PATIENCE: Duration = Duration::from_secs(5);

/// Longest reply (bytes).
const MAX_REPLY: u64 = 1 << 20;

/// Sends `request` to the host at the socket `path`. The error is a sentence.
pub(super) async fn ask(path: &Path, request: &Request) -> Result<Reply, String> {
    let exchanged = timeout(PATIENCE, exchange(path, request)).await;
    let at = || documents::shown(path);
    match exchanged {
        Ok(Ok(reply)) => reply,
        Ok(Err(error)) => Err(format!("no host runs here ({}): {error}", at())),
        Err(_elapsed) => Err(format!("the host here ({}) does not answer", at())),
    }
}

async fn exchange(path: &Path, request: &Request) -> io::Result<Result<Reply, String>> {
    let mut stream = UnixStream::connect(path).await?;
    let (own, peer) = (rustix::process::getuid().as_raw(), stream.peer_cred()?.uid());
    if own != 0 && peer != 0 && peer != own {
        let text = format!("it belongs to user {peer}");
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, text));
    }
    let mut text = serde_json::to_string(request)?;
    text.push('\n');
    stream.write_all(text.as_bytes()).await?;
    let mut line = String::new();
    BufReader::new(stream.take(MAX_REPLY)).read_line(&mut line).await?;
    Ok(serde_json::from_str(&line)?)
}

/// Returns address and secret of the host at the socket `path`. The error is a sentence.
pub(super) async fn whereabouts(path: &Path) -> Result<Dial, String> {
    let Reply::Where { address, token } = ask(path, &Request::Where {}).await? else {
        return Err("the host here sent another reply than its address".to_owned());
    };
    let (address, pin) = match address.split_once('#') {
        Some((address, pin)) => {
            (address, Some(pin.parse::<Fingerprint>().map_err(|error| error.to_string())?))
        }
        None => (address.as_str(), None),
    };
    Ok(Dial { address: address.to_owned(), token, pin, socket: Some(path.to_owned()) })
}
