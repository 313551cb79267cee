//! The command's end of the control socket: one request, one reply.

use std::io::{self, BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{fmt, fs, os::unix::net::UnixStream};

use documents::shown;
use rustix::net::sockopt::{Timeout, set_socket_timeout, socket_peercred};
use rustix::net::{AddressFamily, SocketAddrUnix, SocketFlags, SocketType};

use super::{Answer, Request, place};

/// Default wait for a host's answer.
const PATIENCE: Duration = Duration::from_secs(5);

/// Reason for a missing reply.
#[derive(Debug, thiserror::Error)]
pub enum ControlError {
    #[error(
        "no host is running here ({path}){elsewhere}",
        path = shown(.path)
    )]
    NoHost {
        /// Socket at which it was expected.
        path: PathBuf,
        elsewhere: Elsewhere,
    },
    #[error("the host at {} is {owner}, and does not listen to you: {remedy}", shown(.path))]
    NotYours { path: PathBuf, owner: String, remedy: String },
    /// The socket is held by a program of an untrusted user.
    #[error(
        "what listens at {path} is user {uid}'s and no host of yours: nothing was asked; see what \
         it is, and give LETOFF_SOCKET the path of your own",
        path = shown(.path)
    )]
    Impostor { path: PathBuf, uid: u32 },
    /// The host connects and does not answer in time.
    #[error(
        "the host{} gave no answer within {} s: it hangs. Boards that hear nothing from it take \
         their forces away by themselves (their watchdogs, within some milliseconds); end it with \
         `{end}`, and cut the boards' power if a force stays",
        .pid.map_or_else(String::new, |pid| format!(" (process {pid})")),
        .patience.as_secs_f64()
    )]
    Hung {
        pid: Option<i32>,
        patience: Duration,
        /// Command that ends it for good.
        end: String,
    },
    /// The host went away or the connection failed.
    #[error("the host did not answer: {0}")]
    Silent(io::Error),
    #[error("what answered is no host of this version: {0}")]
    Foreign(#[from] serde_json::Error),
}

/// Hosts with other sockets.
#[derive(Debug)]
pub struct Elsewhere {
    hosts: Vec<(PathBuf, Option<u32>)>,
    command: &'static str,
}

impl fmt::Display for Elsewhere {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.hosts.is_empty() {
            return f.write_str(": start one with `letoff run`");
        }
        for (path, uid) in &self.hosts {
            let sudo = if *uid == Some(place::user()) { "" } else { "sudo " };
            let (owner, path) = (whose(path, *uid), shown(path));
            write!(
                f,
                "; {owner} listens at {path}: `{sudo}LETOFF_SOCKET={path} {}`",
                self.command
            )?;
        }
        Ok(())
    }
}

fn whose(path: &Path, uid: Option<u32>) -> String {
    match uid {
        _ if place::is_service(path) => "a service's host".to_owned(),
        Some(uid) if uid == place::user() => "another host of yours".to_owned(),
        Some(uid) => format!("user {uid}'s host"),
        None => "another user's host".to_owned(),
    }
}

const STOP: &str = "letoff stop";

const fn command(request: &Request) -> &'static str {
    match request {
        Request::Stop {} => STOP,
        Request::UseInstrument { .. } => "letoff instruments use NAME",
        Request::Load { .. } => "letoff model load FILE",
        Request::Render { .. } => "letoff set NAME=VALUE",
        Request::Status {} => "letoff status",
        Request::Press { .. } => "letoff press KEY",
        Request::Where {}
        | Request::Set { .. }
        | Request::Grip { .. }
        | Request::FollowBase { .. }
        | Request::SaveInstrument { .. }
        | Request::Margin { .. }
        | Request::Figures { .. }
        | Request::Identify { .. }
        | Request::Scene {}
        | Request::Record { .. } => "letoff dash",
    }
}

/// Sends `request` to the host at `path` and waits for its reply.
///
/// # Errors
/// If no trusted host is there, or it does not answer within 5 s.
pub fn send(path: &Path, request: &Request) -> Result<Answer, ControlError> {
    send_within(PATIENCE, path, request)
}

/// Wait of a stop for the next host after a crash; `RestartSec` of the service is 5 s.
const NEXT_START: Duration = Duration::from_secs(8);

const LOOK: Duration = Duration::from_millis(20);

/// A host that was asked to stop, and its answer.
#[derive(Debug)]
pub struct AskedHost {
    pub name: String,
    pub answer: Result<Answer, ControlError>,
}

/// Stops all hosts of this user and of the service and returns their answers. Asks only hosts with
/// this process's `LETOFF_SOCKET` if that is set, and the socket's path if no name is found.
pub fn stop_hosts() -> Vec<AskedHost> {
    let is_meant = |pid: &u32| place::chosen().is_none() || place::shares_socket(*pid);
    let pids: Vec<u32> = place::hosts().into_iter().filter(is_meant).collect();
    // In parallel, since a hanging host must not delay the others.
    std::thread::scope(|scope| {
        let ask = |pid| {
            let asked = scope.spawn(move || stop_process(pid));
            (pid, asked)
        };
        let asked: Vec<_> = pids.into_iter().map(ask).collect();
        let answers = asked.into_iter().map(|(pid, asked)| {
            let panicked = |_| Err(ControlError::Silent(io::ErrorKind::Other.into()));
            AskedHost { name: format!("host {pid}"), answer: asked.join().unwrap_or_else(panicked) }
        });
        // Another user may have taken a name: such a host is reached by its path.
        let answers = answers.chain(stop_service());
        let mut asked: Vec<_> =
            answers.filter(|it| !matches!(it.answer, Err(ControlError::Impostor { .. }))).collect();
        if asked.is_empty() {
            asked.push(AskedHost { name: "the host".to_owned(), answer: stop_host() });
        }
        asked
    })
}

/// Stops the host of the service, if there is one and no other is named.
fn stop_service() -> Option<AskedHost> {
    if place::chosen().is_some() {
        return None;
    }
    let answer = send(place::service(), &Request::Stop {});
    let is_there = !matches!(answer, Err(ControlError::NoHost { .. }));
    is_there.then(|| AskedHost { name: "the service's host".to_owned(), answer })
}

/// Returns this user's host processes with another `LETOFF_SOCKET`.
pub fn hosts_elsewhere() -> Vec<u32> {
    let all = place::hosts().into_iter();
    all.filter(|pid| place::chosen().is_some() && !place::shares_socket(*pid)).collect()
}

fn stop_process(pid: u32) -> Result<Answer, ControlError> {
    let address = SocketAddrUnix::new_abstract_name(&place::stop_name(pid));
    let address = address.map_err(|error| ControlError::Silent(error.into()))?;
    let end = i32::try_from(pid).map_or_else(|_| String::new(), end_command);
    let hung = |pid| ControlError::Hung { pid, patience: PATIENCE, end: end.clone() };
    let stream = connect(&address, PATIENCE).map_err(|error| match error {
        late if is_late(&late) => hung(i32::try_from(pid).ok()),
        error => ControlError::Silent(error),
    })?;
    let is_ours = |uid| uid == place::user() || uid == 0;
    let stranger =
        |uid| ControlError::Impostor { path: PathBuf::from(format!("process {pid}")), uid };
    exchange(stream, PATIENCE, &Request::Stop {}, (is_ours, stranger, hung)).map(|it| it.0)
}

/// Stops the host that [`send_to_host`] asks. If it has crashed, waits for the next one: a
/// restarted host must not arm the boards that were to be stopped.
fn stop_host() -> Result<Answer, ControlError> {
    let begun = Instant::now();
    // A host that ends in good order removes its socket.
    let is_left = |path: &Path| fs::symlink_metadata(path).is_ok();
    let is_service_left = place::chosen().is_none() && is_left(place::service());
    let has_crashed = is_left(&place::socket_path()) || is_service_left;
    loop {
        match send_to_host(&Request::Stop {}) {
            Err(ControlError::NoHost { .. } | ControlError::Silent(_))
                if has_crashed && begun.elapsed() < NEXT_START =>
            {
                std::thread::sleep(LOOK);
            }
            answered => return answered,
        }
    }
}

/// Sends `request` to this user's host, or to the service's if this user has none and
/// `LETOFF_SOCKET` names none.
pub fn send_to_host(request: &Request) -> Result<Answer, ControlError> {
    hold(request).map(|(answer, _connection)| answer)
}

/// Like [`send_to_host`], for a pressed key, which dropping the returned connection releases.
pub fn hold(request: &Request) -> Result<(Answer, UnixStream), ControlError> {
    let nobody = match converse(PATIENCE, &place::socket_path(), request) {
        Err(nobody @ ControlError::NoHost { .. }) if place::chosen().is_none() => nobody,
        answered => return answered,
    };
    match converse(PATIENCE, place::service(), request) {
        Err(ControlError::NoHost { .. }) => Err(nobody),
        answered => answered,
    }
}

/// Like [`send`], with a caller-supplied `patience`.
pub fn send_within(
    patience: Duration,
    path: &Path,
    request: &Request,
) -> Result<Answer, ControlError> {
    converse(patience, path, request).map(|(answer, _connection)| answer)
}

fn converse(
    patience: Duration,
    path: &Path,
    request: &Request,
) -> Result<(Answer, UnixStream), ControlError> {
    let hangs = |pid| hung(path, pid, patience);
    let address = SocketAddrUnix::new(path).map_err(|error| ControlError::Silent(error.into()))?;
    let stream = connect(&address, patience).map_err(|error| {
        if is_late(&error) { hangs(None) } else { absent(path, command(request), error) }
    })?;
    // Only root and the service manager make the folder of the service.
    let is_ours = |uid| {
        uid == place::user()
            || uid == 0
            || place::is_service(path)
            || place::is_allowed_to_root(path)
    };
    let stranger = |uid| ControlError::Impostor { path: path.to_owned(), uid };
    exchange(stream, patience, request, (is_ours, stranger, hangs))
}

/// Sends `request` by `stream` and returns the answer, if `is_ours` trusts the host's user.
fn exchange(
    mut stream: UnixStream,
    patience: Duration,
    request: &Request,
    (is_ours, stranger, hangs): (
        impl Fn(u32) -> bool,
        impl Fn(u32) -> ControlError,
        impl Fn(Option<i32>) -> ControlError,
    ),
) -> Result<(Answer, UnixStream), ControlError> {
    let peer = socket_peercred(&stream).map_err(|error| ControlError::Silent(error.into()))?;
    let (uid, pid) = (peer.uid.as_raw(), peer.pid.as_raw_nonzero().get());
    if !is_ours(uid) {
        return Err(stranger(uid));
    }
    let failed = |error: io::Error| {
        if is_late(&error) { hangs(Some(pid)) } else { ControlError::Silent(error) }
    };
    stream.set_read_timeout(Some(patience)).map_err(ControlError::Silent)?;
    let mut text = serde_json::to_string(request)?;
    text.push('\n');
    stream.write_all(text.as_bytes()).map_err(failed)?;
    let mut line = String::new();
    BufReader::new(&stream).read_line(&mut line).map_err(failed)?;
    Ok((serde_json::from_str(&line)?, stream))
}

fn hung(path: &Path, pid: Option<i32>, patience: Duration) -> ControlError {
    let end = match pid {
        _ if place::is_service(path) => END_SERVICE.to_owned(),
        None => "pkill -KILL letoff".to_owned(),
        Some(pid) => end_command(pid),
    };
    ControlError::Hung { pid, patience, end }
}

const END_SERVICE: &str = "systemctl stop letoff";

/// Returns the command that ends the host `pid` and keeps the service manager from restarting it.
pub fn end_command(pid: i32) -> String {
    let groups = fs::read(format!("/proc/{pid}/cgroup")).unwrap_or_default();
    if groups.split(|byte| *byte == b'\n').any(|group| group.ends_with(b"/letoff.service")) {
        return END_SERVICE.to_owned();
    }
    format!("kill -KILL {pid}")
}

/// Connects with a time limit, since a hanging host accepts no connection.
fn connect(address: &SocketAddrUnix, patience: Duration) -> io::Result<UnixStream> {
    let (family, flags) = (AddressFamily::UNIX, SocketFlags::CLOEXEC);
    let socket = rustix::net::socket_with(family, SocketType::STREAM, flags, None)?;
    set_socket_timeout(&socket, Timeout::Send, Some(patience))?;
    rustix::net::connect(&socket, address)?;
    Ok(UnixStream::from(socket))
}

fn absent(path: &Path, command: &'static str, error: io::Error) -> ControlError {
    if error.kind() == io::ErrorKind::PermissionDenied {
        let owner = whose(path, place::owner(path));
        let remedy = if place::is_service(path) && command == STOP {
            format!("`sudo {command}`, or without sudo as a member of the group letoff")
        } else {
            format!("`sudo LETOFF_SOCKET={} {command}`", shown(path))
        };
        return ControlError::NotYours { path: path.to_owned(), owner, remedy };
    }
    if matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::ConnectionRefused) {
        let elsewhere = Elsewhere { hosts: place::others(path), command };
        return ControlError::NoHost { path: path.to_owned(), elsewhere };
    }
    ControlError::Silent(error)
}

fn is_late(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_host_that_hangs_is_ended_with_what_would_start_it_again() {
        let command = |path, pid| {
            let text = hung(Path::new(path), pid, PATIENCE).to_string();
            text.split('`').nth(1).unwrap().to_owned()
        };
        assert_eq!(command("/run/letoff/letoff.sock", Some(7)), "systemctl stop letoff");
        assert_eq!(command("/tmp/letoff.sock", None), "pkill -KILL letoff");
        let own = i32::try_from(std::process::id()).unwrap();
        assert_eq!(command("/tmp/letoff.sock", Some(own)), format!("kill -KILL {own}"));
    }
}
