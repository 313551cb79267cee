//! The host's end of the control socket: one request per line, bounded in size and time.

use std::fs;
use std::io;
use std::os::unix::fs::MetadataExt as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use rustix::fs::Mode;
use rustix::process::umask;
use tokio::io::{AsyncBufReadExt as _, AsyncReadExt as _, AsyncWriteExt as _, BufReader};
use tokio::net::{UnixListener, UnixStream};
use tokio::sync::Semaphore;

use super::{Answer, Request, place};

/// Longest request (bytes).
const MAX_REQUEST: u64 = 4096;

/// Most clients at once; all are this user's.
const MOST_CLIENTS: u32 = 64;

/// Longest time that one client is served.
const PATIENCE: Duration = Duration::from_secs(2);

/// Answers requests of the control socket.
pub trait Answers: Send + Sync + 'static {
    /// Does what `request` asks, and returns when it is done; it may block.
    ///
    /// # Errors
    /// If it is refused; a sentence.
    fn reply_to(&self, request: &Request) -> Answer;
}

/// A socket that is removed when the host ends.
#[derive(Debug)]
pub struct ControlServer {
    listener: UnixListener,
    path: PathBuf,
    /// The file that was made: its device and number.
    made: (u64, u64),
}

impl ControlServer {
    /// Listens at `path`, for this user only; a socket that a killed host of this user left is
    /// replaced, and anything else that is there is left alone.
    ///
    /// # Errors
    /// If another host listens there, something else lies there, or others could put a socket of
    /// theirs there; a sentence.
    pub fn listen(path: &Path) -> io::Result<Self> {
        place::prepare_folder(path)?;
        place::clear(path)?;
        // Only this user has access to the socket from the beginning.
        let before = umask(Mode::RWXG | Mode::RWXO | Mode::XUSR);
        let bound = UnixListener::bind(path);
        umask(before);
        Ok(Self { listener: bound?, path: path.to_owned(), made: file(path)? })
    }
}

/// Returns the device and the number of the file at `path`.
fn file(path: &Path) -> io::Result<(u64, u64)> {
    let found = fs::symlink_metadata(path)?;
    Ok((found.dev(), found.ino()))
}

impl Drop for ControlServer {
    fn drop(&mut self) {
        // Another process may have replaced it.
        if file(&self.path).is_ok_and(|there| there == self.made) {
            let _gone = fs::remove_file(&self.path);
        }
    }
}

/// Counts the clients that are being answered.
#[derive(Clone, Debug)]
pub struct Clients(Arc<Semaphore>);

impl Default for Clients {
    /// Returns a count of no clients.
    fn default() -> Self {
        Self(Arc::new(Semaphore::new(MOST_CLIENTS as usize)))
    }
}

impl Clients {
    /// Waits until all clients have their answer, for half a second at most.
    pub async fn leave(&self) {
        /// Longer than it takes to write a line.
        const GRACE: Duration = Duration::from_millis(500);
        let _left = tokio::time::timeout(GRACE, self.0.acquire_many(MOST_CLIENTS)).await;
    }
}

/// Answers clients, so many at once, until it is dropped.
#[expect(clippy::infinite_loop, reason = "its task is ended from outside")]
pub async fn serve<A: Answers>(server: ControlServer, answers: Arc<A>, clients: Clients) {
    /// Pause when the system has no more descriptors.
    const PAUSE: Duration = Duration::from_millis(50);
    loop {
        let Ok((client, _address)) = server.listener.accept().await else {
            tokio::time::sleep(PAUSE).await;
            continue;
        };
        // A client beyond the limit is dropped, so that the others are served in time.
        if let Ok(place) = Arc::clone(&clients.0).try_acquire_owned() {
            let answers = Arc::clone(&answers);
            tokio::spawn(async move {
                // A client that fails, stalls or talks nonsense is dropped.
                let _served = tokio::time::timeout(PATIENCE, converse(client, &answers)).await;
                drop(place);
            });
        }
    }
}

async fn converse<A: Answers>(client: UnixStream, answers: &Arc<A>) -> io::Result<()> {
    let (reader, mut writer) = client.into_split();
    let mut line = String::new();
    BufReader::new(reader.take(MAX_REQUEST)).read_line(&mut line).await?;
    let reply: Answer = match serde_json::from_str::<Request>(&line) {
        // Building a keyboard of voices may take a while: not on the thread that hears signals.
        Ok(request) => {
            let answers = Arc::clone(answers);
            let answer = move || answers.reply_to(&request);
            let answered = tokio::task::spawn_blocking(answer).await;
            answered.unwrap_or_else(|panic| Err(panic.to_string()))
        }
        Err(error) => Err(format!("this is no request of letoff's: {error}")),
    };
    let mut text = serde_json::to_string(&reply)?;
    text.push('\n');
    writer.write_all(text.as_bytes()).await
}
