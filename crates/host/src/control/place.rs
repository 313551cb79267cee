//! The path of the control socket, and its owner.
//!
//! A process that may connect acts as the host's owner, and a process that listens there is
//! trusted. So the socket is in a folder that only its user can write, its mode lets only that user
//! connect, and a command checks the user of the host.

use std::os::unix::fs::{DirBuilderExt as _, FileTypeExt as _, MetadataExt as _};
use std::path::{Path, PathBuf};
use std::{fs, io, os::unix::ffi::OsStrExt as _};

use documents::shown;
use rustix::process::getuid;

const SERVICE: &str = "/run/letoff/letoff.sock";

/// Mode bits by which others may write into a folder.
const OTHERS_WRITE: u32 = 0o022;
/// Mode bit of a folder in which only owners remove their files.
const STICKY: u32 = 0o1000;

/// Returns the socket of this user's host: the value of `LETOFF_SOCKET`, or in the runtime
/// directory if that is this user's, else in the user's folder among temporary files.
pub fn socket_path() -> PathBuf {
    if let Some(path) = chosen() {
        return path;
    }
    session().unwrap_or_else(temporary).join("letoff.sock")
}

/// Returns the runtime directory if it is this user's: a user switch may keep the first one's.
fn session() -> Option<PathBuf> {
    let runtime = std::env::var_os("XDG_RUNTIME_DIR").map(PathBuf::from);
    runtime.filter(|folder| owner(folder) == Some(user()))
}

/// Returns the folder for files that outlive a host and not the machine: the service's own, or this
/// user's, into which no other user can write. The error is a sentence.
pub(crate) fn runtime_folder() -> io::Result<PathBuf> {
    let service = std::env::var_os("RUNTIME_DIRECTORY").map(PathBuf::from);
    let folder = service.filter(|folder| owner(folder) == Some(user())).or_else(session);
    let Some(folder) = folder else { return temporary_folder() };
    check_folder(&folder.join("letoff.sock"))?;
    Ok(folder)
}

/// Returns this user's folder among temporary files, which any user could have made before.
fn temporary() -> PathBuf {
    std::env::temp_dir().join(format!("letoff-{}", user()))
}

/// Makes this user's folder among temporary files; the error is a sentence, also for a folder that
/// is another user's.
pub fn temporary_folder() -> io::Result<PathBuf> {
    let folder = temporary();
    prepare_folder(&folder.join("letoff.sock"))?;
    Ok(folder)
}

pub(super) fn chosen() -> Option<PathBuf> {
    std::env::var_os("LETOFF_SOCKET").map(PathBuf::from)
}

pub(crate) fn user() -> u32 {
    getuid().as_raw()
}

pub(crate) fn owner(path: &Path) -> Option<u32> {
    Some(fs::metadata(path).ok()?.uid())
}

/// Makes the folder of the socket at `path`, for this user only, inside an existing folder.
///
/// # Errors
/// A sentence, if that fails or another user could put a socket there.
pub(crate) fn prepare_folder(path: &Path) -> io::Result<()> {
    let folder = folder(path);
    match fs::DirBuilder::new().mode(0o700).create(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            let above = shown(folder.parent().unwrap_or(folder));
            let text = format!("there is no folder {above} (make it first, or correct TMPDIR)");
            return Err(io::Error::new(error.kind(), text));
        }
        Err(error) if error.kind() != io::ErrorKind::AlreadyExists => return Err(error),
        Ok(()) | Err(_) => {}
    }
    check_folder(path)
}

/// Rejects a folder in which another user could put a socket; the error is a sentence.
pub(super) fn check_folder(path: &Path) -> io::Result<()> {
    let folder = folder(path);
    let is_trusted = |uid: u32| uid == user() || uid == 0;
    // The owner of a symbolic link decides its target.
    let (link, target) = (fs::symlink_metadata(folder)?, fs::metadata(folder)?);
    let stranger =
        [&link, &target].into_iter().map(fs::Metadata::uid).find(|uid| !is_trusted(*uid));
    if let Some(uid) = stranger {
        return refuse(format!(
            "the folder {} belongs to user {uid}, who could answer in a host's place",
            shown(folder)
        ));
    }
    let mode = target.mode();
    if mode & OTHERS_WRITE != 0 && mode & STICKY == 0 {
        return refuse(format!(
            "others can write into {0} and could answer in a host's place (`chmod go-w {0}`)",
            shown(folder)
        ));
    }
    Ok(())
}

/// Returns `true` if root named this path, or it is the service's, whose folder only root makes.
pub(super) fn is_allowed_to_root(path: &Path) -> bool {
    user() == 0 && (is_service(path) || chosen().is_some_and(|chosen| chosen == path))
}

/// Removes the socket that a host of this user left at `path`.
///
/// # Errors
/// A sentence, if the file is no socket or a host listens.
pub(crate) fn clear(path: &Path) -> io::Result<()> {
    let found = match fs::symlink_metadata(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        found => found?,
    };
    if !found.file_type().is_socket() {
        return refuse("what is there is no socket, and is left alone".to_owned());
    }
    if found.uid() != user() {
        return refuse(format!("the socket there is user {}'s, and is left alone", found.uid()));
    }
    match std::os::unix::net::UnixStream::connect(path) {
        Ok(_host) => Err(io::Error::new(io::ErrorKind::AddrInUse, "another host is running")),
        Err(error) if error.kind() == io::ErrorKind::ConnectionRefused => fs::remove_file(path),
        Err(error) => Err(error),
    }
}

/// Returns the name at which host `pid` receives stops; it vanishes with its process.
pub(super) fn stop_name(pid: u32) -> Vec<u8> {
    format!("{}{pid}", stop_prefix()).into_bytes()
}

fn stop_prefix() -> String {
    format!("letoff/{}/", user())
}

pub(super) fn hosts() -> Vec<u32> {
    let listed = fs::read_to_string("/proc/net/unix").unwrap_or_default();
    let prefix = format!("@{}", stop_prefix());
    let names = listed.lines().filter_map(|line| line.split_whitespace().nth(7));
    let pids = names.filter_map(|name| name.strip_prefix(&prefix)?.parse().ok());
    let mut pids: Vec<u32> = pids.collect();
    pids.sort_unstable();
    pids.dedup();
    pids
}

/// Returns `true` if process `pid` was started with this process's `LETOFF_SOCKET`.
pub(super) fn shares_socket(pid: u32) -> bool {
    let environment = fs::read(format!("/proc/{pid}/environ")).unwrap_or_default();
    let mut variables = environment.split(|byte| *byte == 0);
    let own = chosen().map(PathBuf::into_os_string);
    let its = variables.find_map(|variable| variable.strip_prefix(b"LETOFF_SOCKET="));
    its == own.as_ref().map(|own| own.as_bytes())
}

/// Returns the sockets of this machine's hosts, except `path`, with their visible owners.
pub(super) fn others(path: &Path) -> Vec<(PathBuf, Option<u32>)> {
    let listed = fs::read_to_string("/proc/net/unix").unwrap_or_default();
    let mut others: Vec<PathBuf> = listening(&listed).filter(|other| other != path).collect();
    others.sort();
    others.dedup();
    others.into_iter().map(|other| (owner(&other), other)).map(|(uid, it)| (it, uid)).collect()
}

fn listening(listed: &str) -> impl Iterator<Item = PathBuf> {
    const LISTENS: &str = "00010000";
    listed.lines().filter_map(|line| {
        let mut words = line.split_whitespace();
        let flags = words.nth(3)?;
        let path = PathBuf::from(words.nth(3)?);
        let is_host = flags == LISTENS && path.file_name()? == "letoff.sock";
        (is_host && is_plain(&path)).then_some(path)
    })
}

/// Returns `true` if `path` is safe in a command: others may choose characters that a shell obeys.
fn is_plain(path: &Path) -> bool {
    let is_plain = |it: &u8| it.is_ascii_alphanumeric() || b"/._-+@:".contains(it);
    path.is_absolute() && path.as_os_str().as_bytes().iter().all(is_plain)
}

pub(super) fn service() -> &'static Path {
    Path::new(SERVICE)
}

pub(super) fn is_service(path: &Path) -> bool {
    path == service()
}

fn folder(path: &Path) -> &Path {
    path.parent().filter(|it| !it.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

fn refuse<T>(text: String) -> io::Result<T> {
    Err(io::Error::new(io::ErrorKind::PermissionDenied, text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hosts_are_found_in_the_system_s_list() {
        let listed = "\
Num       RefCount Protocol Flags    Type St Inode Path
0000000000000000: 00000002 00000000 00010000 0001 01 17 /run/letoff/letoff.sock
0000000000000000: 00000003 00000000 00000000 0001 03 18 /run/user/7/letoff.sock
0000000000000000: 00000002 00000000 00010000 0001 01 19 /run/systemd/private
0000000000000000: 00000002 00000000 00010000 0001 01 22 /tmp/a$(touch${IFS}b)/letoff.sock
0000000000000000: 00000002 00000000 00010000 0001 01 23 /tmp/\x1b[2J/letoff.sock
0000000000000000: 00000002 00000000 00010000 0001 01 24 b/letoff.sock
0000000000000000: 00000002 00000000 00010000 0001 01 20
0000000000000000: 00000002 00000000 00010000 0001 01 21 @letoff.sock\n";
        assert_eq!(listening(listed).collect::<Vec<_>>(), [Path::new(SERVICE)]);
    }
}
