//! The host's end: listens, one request per line, bounded in size and time.

use std::fs;
use std::io;
use std::os::unix::fs::{DirBuilderExt as _, PermissionsExt as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use tokio::io::{AsyncBufReadExt as _, AsyncReadExt as _, AsyncWriteExt as _, BufReader};
use tokio::net::{UnixListener, UnixStream};
use tokio::sync::Semaphore;

use super::{Answer, Request, Switchboard};

/// Longest request in bytes; a sentence would do.
const MAX_REQUEST: u64 = 4096;

/// Clients that are listened to at once; all are this user's.
const MOST_CLIENTS: u32 = 64;

/// Longest time that one client is listened to.
const PATIENCE: Duration = Duration::from_secs(2);

/// A socket that is removed when the host ends.
#[derive(Debug)]
pub struct Server {
    listener: UnixListener,
    path: PathBuf,
}

impl Server {
    /// Listens at `path`, for this user only; a socket that a killed host left is replaced.
    ///
    /// # Errors
    /// If another host listens there, or the socket cannot be made.
    pub fn listen(path: &Path) -> io::Result<Self> {
        if let Some(folder) = path.parent() {
            fs::DirBuilder::new().recursive(true).mode(0o700).create(folder)?;
        }
        if std::os::unix::net::UnixStream::connect(path).is_ok() {
            return Err(io::Error::new(io::ErrorKind::AddrInUse, "another host is running"));
        }
        if path.exists() {
            fs::remove_file(path)?;
        }
        let listener = UnixListener::bind(path)?;
        fs::set_permissions(path, fs::Permissions::from_mode(0o600))?;
        Ok(Self { listener, path: path.to_owned() })
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // Somebody may have removed it already, which is as good.
        let _gone = fs::remove_file(&self.path);
    }
}

/// Those who are being answered.
#[derive(Clone, Debug)]
pub struct Clients(Arc<Semaphore>);

impl Default for Clients {
    /// Nobody.
    fn default() -> Self {
        Self(Arc::new(Semaphore::new(MOST_CLIENTS as usize)))
    }
}

impl Clients {
    /// Waits until everybody has their answer, or a moment has passed.
    pub async fn leave(&self) {
        /// Longer than it takes to write a line.
        const GRACE: Duration = Duration::from_millis(500);
        let _left = tokio::time::timeout(GRACE, self.0.acquire_many(MOST_CLIENTS)).await;
    }
}

/// Answers clients, so many at once, until it is dropped.
#[expect(clippy::infinite_loop, reason = "whoever spawned it ends it")]
pub async fn serve(server: Server, switchboard: Arc<Switchboard>, clients: Clients) {
    loop {
        let Ok((client, _address)) = server.listener.accept().await else { continue };
        // One that finds no place goes away unheard, so that whoever has one may come in time.
        if let Ok(place) = Arc::clone(&clients.0).try_acquire_owned() {
            let switchboard = Arc::clone(&switchboard);
            tokio::spawn(async move {
                // A client that fails, stalls or talks nonsense is dropped.
                let _served = tokio::time::timeout(PATIENCE, converse(client, &switchboard)).await;
                drop(place);
            });
        }
    }
}

async fn converse(client: UnixStream, switchboard: &Arc<Switchboard>) -> io::Result<()> {
    let (reader, mut writer) = client.into_split();
    let mut line = String::new();
    BufReader::new(reader.take(MAX_REQUEST)).read_line(&mut line).await?;
    let reply: Answer = match serde_json::from_str::<Request>(&line) {
        // Building a keyboard of voices may take a while: not on the thread that hears signals.
        Ok(request) => {
            let switchboard = Arc::clone(switchboard);
            let answer = move || switchboard.answer(&request, "letoff");
            let answered = tokio::task::spawn_blocking(answer).await;
            answered.unwrap_or_else(|panic| Err(panic.to_string()))
        }
        Err(error) => Err(format!("this is no request of letoff's: {error}")),
    };
    let mut text = serde_json::to_string(&reply)?;
    text.push('\n');
    writer.write_all(text.as_bytes()).await
}
