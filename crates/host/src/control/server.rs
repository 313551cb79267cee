//! The host's end of the control socket: one request per line, bounded in size and time.

use std::os::unix::net::{SocketAddr, UnixListener as StdListener};
use std::path::{Path, PathBuf};
use std::{
    fs, io, os::linux::net::SocketAddrExt as _, os::unix::fs::MetadataExt as _, sync::Arc,
    time::Duration,
};

use rustix::{fs::Mode, process::umask};
use tokio::io::{
    AsyncBufReadExt as _, AsyncReadExt as _, AsyncWriteExt as _, BufReader, Interest, Ready,
};
use tokio::net::{UnixListener, UnixStream};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::timeout;

use super::{Answer, Request, place};

/// Longest request (bytes).
const MAX_REQUEST: u64 = 4096;

/// Maximum number of clients, all of this user.
const MOST_CLIENTS: u32 = 64;

/// Longest time for a client's request, and for reading the answer.
const PATIENCE: Duration = Duration::from_secs(2);

/// First connection of the socket; clients of the stream are counted from 1.
const FIRST: u64 = 1 << 63;

/// An answering service behind the control socket.
pub trait Answers: Send + Sync + 'static {
    /// Handles `request` of `connection` and returns when it is done; may block.
    ///
    /// # Errors
    /// A sentence why it is rejected.
    fn reply_to(&self, request: &Request, connection: u64) -> Answer;

    fn left(&self, connection: u64) {
        let _ = connection;
    }
}

const FIRST_BY_NAME: u64 = FIRST | 1 << 62;

/// A socket that is removed when the host ends.
#[derive(Debug)]
pub struct ControlServer {
    listener: UnixListener,
    first: u64,
    file: Option<SocketFile>,
}

#[derive(Debug)]
struct SocketFile {
    path: PathBuf,
    /// Device and inode.
    made: (u64, u64),
}

impl ControlServer {
    /// Listens at `path`, for this user only. Replaces only what a killed host of this user left.
    ///
    /// # Errors
    /// A sentence, if another host listens, the file is no socket, or others could put a socket
    /// there.
    pub fn listen(path: &Path) -> io::Result<Self> {
        place::prepare_folder(path)?;
        place::clear(path)?;
        // Only this user, and the service's group, have access to the socket from the beginning.
        let group = if place::is_service(path) { Mode::XGRP } else { Mode::RWXG };
        let before = umask(group | Mode::RWXO | Mode::XUSR);
        let bound = UnixListener::bind(path);
        umask(before);
        let file = SocketFile { path: path.to_owned(), made: file(path)? };
        Ok(Self { listener: bound?, first: FIRST, file: Some(file) })
    }

    /// Listens at a name of this process for `letoff stop`, whatever its path. Rejects other users.
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

/// Counter of the clients that are being answered.
#[derive(Clone, Debug)]
pub struct Clients(Arc<Semaphore>);

impl Default for Clients {
    fn default() -> Self {
        Self(Arc::new(Semaphore::new(MOST_CLIENTS as usize)))
    }
}

impl Clients {
    /// Waits until all clients have their answer, at most 0.5 s.
    pub async fn leave(&self) {
        /// Longer than it takes to write a line.
        const GRACE: Duration = Duration::from_millis(500);
        let _left = timeout(GRACE, self.0.acquire_many(MOST_CLIENTS)).await;
    }
}

/// Answers clients, a limited number at once, until it is dropped.
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

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum ClientRights {
    /// The host's user and root may send any request.
    Owner,
    /// Members of the service's group may stop the host and read its status.
    Group,
}

impl ClientRights {
    /// Returns the rights of the peer of `stream`; `None` for a stranger. Only the service's group
    /// and its owner may open the socket's file.
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

struct ControlClient<A> {
    connection: u64,
    rights: ClientRights,
    answers: Arc<A>,
    holders: Arc<Semaphore>,
}

struct HeldConnection {
    stream: UnixStream,
    _permit: OwnedSemaphorePermit,
}

impl HeldConnection {
    /// Waits until the client closes it or sends more, which no client does.
    async fn until_it_ends(&mut self) {
        let _end = self.stream.read_u8().await;
    }
}

impl<A: Answers> ControlClient<A> {
    /// Answers `stream`; drops a client that fails, stalls or is invalid.
    async fn attend(self, stream: UnixStream, place: OwnedSemaphorePermit) {
        if let Ok(Some(mut held)) = self.converse(stream, place).await {
            held.until_it_ends().await;
        }
        self.answers.left(self.connection);
    }

    /// Answers one request while holding `place`. Returns the connection if it holds a key.
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

    /// Answers on a blocking thread, since building many voices would delay signals.
    async fn answer(&self, request: Request, stream: &UnixStream) -> Answer {
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
