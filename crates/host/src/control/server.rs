//! The host's end of the control socket: one request per line, bounded in size and time.

use std::fs;
use std::io;
use std::os::linux::net::SocketAddrExt as _;
use std::os::unix::fs::MetadataExt as _;
use std::os::unix::net::{SocketAddr, UnixListener as StdListener};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use rustix::fs::Mode;
use rustix::process::umask;
use tokio::io::{
    AsyncBufReadExt as _, AsyncReadExt as _, AsyncWriteExt as _, BufReader, Interest, Ready,
};
use tokio::net::{UnixListener, UnixStream};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::timeout;

use super::{Answer, Request, place};

/// Longest request (bytes).
const MAX_REQUEST: u64 = 4096;

/// Most clients at once; all are this user's.
const MOST_CLIENTS: u32 = 64;

/// Longest time that a client takes for its request, and for hearing the answer.
const PATIENCE: Duration = Duration::from_secs(2);

/// The number of the first connection: clients of the stream are counted from 1.
const FIRST: u64 = 1 << 63;

/// Answers requests of the control socket.
pub trait Answers: Send + Sync + 'static {
    /// Does what `request` asks, which came by `connection`, and returns when it is done; it may
    /// block.
    ///
    /// # Errors
    /// If it is refused; a sentence.
    fn reply_to(&self, request: &Request, connection: u64) -> Answer;

    /// Hears that `connection` has ended: what was pressed by it is let go.
    fn left(&self, connection: u64) {
        let _ = connection;
    }
}

/// The number of the first connection by a host's name.
const FIRST_BY_NAME: u64 = FIRST | 1 << 62;

/// A socket that is removed when the host ends.
#[derive(Debug)]
pub struct ControlServer {
    listener: UnixListener,
    /// The number of its first connection.
    first: u64,
    /// The file that was made, if it has one.
    file: Option<SocketFile>,
}

/// The file of a socket.
#[derive(Debug)]
struct SocketFile {
    path: PathBuf,
    /// Its device and number.
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
        // Only this user has access to the socket from the beginning, and the group of the service.
        let group = if place::is_service(path) { Mode::XGRP } else { Mode::RWXG };
        let before = umask(group | Mode::RWXO | Mode::XUSR);
        let bound = UnixListener::bind(path);
        umask(before);
        let file = SocketFile { path: path.to_owned(), made: file(path)? };
        Ok(Self { listener: bound?, first: FIRST, file: Some(file) })
    }

    /// Listens at a name of this process, by which `letoff stop` finds it whatever its path; other
    /// users are not let in.
    ///
    /// # Errors
    /// If the system has no such names, or another process has taken this one.
    pub fn listen_by_name() -> io::Result<Self> {
        let address = SocketAddr::from_abstract_name(place::stop_name(std::process::id()))?;
        let listener = StdListener::bind_addr(&address)?;
        listener.set_nonblocking(true)?;
        let listener = UnixListener::from_std(listener)?;
        Ok(Self { listener, first: FIRST_BY_NAME, file: None })
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
        if let Some(SocketFile { path, made }) = &self.file
            && file(path).is_ok_and(|there| there == *made)
        {
            let _gone = fs::remove_file(path);
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
        let _left = timeout(GRACE, self.0.acquire_many(MOST_CLIENTS)).await;
    }
}

/// Answers clients, so many at once, until it is dropped.
pub async fn serve<A: Answers>(server: ControlServer, answers: Arc<A>, clients: Clients) {
    /// Pause when the system has no more descriptors.
    const PAUSE: Duration = Duration::from_millis(50);
    let holders = Arc::new(Semaphore::new(MOST_CLIENTS as usize));
    for connection in server.first.. {
        let stream = loop {
            match server.listener.accept().await {
                Ok((stream, _address)) => break stream,
                Err(_none) => tokio::time::sleep(PAUSE).await,
            }
        };
        let Some(rights) = ClientRights::of(&stream, &server) else { continue };
        // A client beyond the limit is dropped, so that the others are served in time.
        if let Ok(place) = Arc::clone(&clients.0).try_acquire_owned() {
            let client = ControlClient {
                connection,
                rights,
                answers: Arc::clone(&answers),
                holders: Arc::clone(&holders),
            };
            tokio::spawn(client.attend(stream, place));
        }
    }
}

/// The requests that a client may make.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum ClientRights {
    /// The host's user and root ask for anything.
    Owner,
    /// Members of the service's group stop the host and ask how it goes.
    Group,
}

impl ClientRights {
    /// Returns the rights of who connects to `server` by `stream`; `None` if it is a stranger. Only
    /// the service's group may open the file of a socket beside its owner.
    fn of(stream: &UnixStream, server: &ControlServer) -> Option<Self> {
        let uid = stream.peer_cred().ok()?.uid();
        if uid == place::user() || uid == 0 {
            return Some(Self::Owner);
        }
        server.file.is_some().then_some(Self::Group)
    }

    const fn include(self, request: &Request) -> bool {
        match self {
            Self::Owner => true,
            Self::Group => matches!(request, Request::Stop {} | Request::Status {}),
        }
    }
}

/// A connection of the control socket.
struct ControlClient<A> {
    connection: u64,
    rights: ClientRights,
    answers: Arc<A>,
    /// A permit for each connection by which something is held.
    holders: Arc<Semaphore>,
}

/// A connection by which a key is pressed.
struct HeldConnection {
    stream: UnixStream,
    _permit: OwnedSemaphorePermit,
}

impl HeldConnection {
    /// Waits until the other side closes it, or says more, which nobody does.
    async fn until_it_ends(&mut self) {
        let _end = self.stream.read_u8().await;
    }
}

impl<A: Answers> ControlClient<A> {
    /// Answers the request that comes by `stream`; one that fails, stalls or talks nonsense is
    /// dropped.
    async fn attend(self, stream: UnixStream, place: OwnedSemaphorePermit) {
        if let Ok(Some(mut held)) = self.converse(stream, place).await {
            held.until_it_ends().await;
        }
        self.answers.left(self.connection);
    }

    /// Answers one request; `place` is for the time that this takes. Returns the connection if
    /// something is held by it.
    async fn converse(
        &self,
        mut stream: UnixStream,
        place: OwnedSemaphorePermit,
    ) -> io::Result<Option<HeldConnection>> {
        let mut line = String::new();
        let mut reader = BufReader::new((&mut stream).take(MAX_REQUEST));
        timeout(PATIENCE, reader.read_line(&mut line)).await??;
        let request = serde_json::from_str::<Request>(&line);
        let holds = matches!(request, Ok(Request::Press { .. } | Request::Grip { .. }));
        let permit = holds.then(|| Arc::clone(&self.holders).try_acquire_owned());
        let (permit, reply) = match (request, permit.transpose()) {
            (Ok(_), Err(_none)) => (None, Err("too many keys are held by commands".to_owned())),
            (Ok(request), Ok(_)) if !self.rights.include(&request) => {
                (None, Err("only the host's owner may ask for that".to_owned()))
            }
            (Ok(request), Ok(permit)) => (permit, self.answer(request, &stream).await),
            (Err(error), _) => (None, Err(format!("this is no request of letoff's: {error}"))),
        };
        let is_held = reply.is_ok();
        let mut text = serde_json::to_string(&reply)?;
        text.push('\n');
        timeout(PATIENCE, stream.write_all(text.as_bytes())).await??;
        drop(place);
        let held = permit.filter(|_| is_held);
        Ok(held.map(|permit| HeldConnection { stream, _permit: permit }))
    }

    /// Building a keyboard of voices may take a while: not on the thread that hears signals.
    async fn answer(&self, request: Request, stream: &UnixStream) -> Answer {
        /// Time between two looks whether the client is still there.
        const LOOK: Duration = Duration::from_millis(100);
        let (answers, connection) = (Arc::clone(&self.answers), self.connection);
        let mut answered =
            tokio::task::spawn_blocking(move || answers.reply_to(&request, connection));
        loop {
            if let Ok(answer) = timeout(LOOK, &mut answered).await {
                return answer.unwrap_or_else(|panic| Err(panic.to_string()));
            }
            // A client that sends no more may still read the answer.
            if stream.ready(Interest::WRITABLE).await.is_ok_and(Ready::is_write_closed) {
                self.answers.left(self.connection);
            }
        }
    }
}
