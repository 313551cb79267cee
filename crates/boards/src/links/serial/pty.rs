//! Pseudo-terminals: a board in this process behind a port that any program can open.

use std::{ffi::OsString, io, os::unix::ffi::OsStringExt as _, path::PathBuf};

use rustix::fd::OwnedFd;
use rustix::fs::{Mode, OFlags, fcntl_getfl, fcntl_setfl};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};

use super::{Keeper, NonBlockingFd, Serial};
use crate::links::Error;

/// A pseudo-terminal: a link for the board that this process simulates, and the port to reach it.
#[derive(Debug)]
pub struct Pty {
    pub board: Serial,
    /// The host's side, to be opened by its path any number of times.
    pub path: PathBuf,
}

impl Pty {
    pub fn open() -> Result<Self, Error> {
        let PtyPair { stream, other, path } = PtyPair::open().map_err(Error::Pty)?;
        Ok(Self { board: Serial::new(stream, Keeper::OtherEnd(other)), path })
    }
}

#[derive(Debug)]
pub(crate) struct PtyPair {
    pub(crate) stream: NonBlockingFd,
    /// The other side; while it is held, this side survives the exit of a client.
    pub(crate) other: OwnedFd,
    pub(crate) path: PathBuf,
}

impl PtyPair {
    /// Makes a pseudo-terminal that does not change bytes.
    pub(crate) fn open() -> io::Result<Self> {
        let this = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC)?;
        grantpt(&this)?;
        unlockpt(&this)?;
        fcntl_setfl(&this, fcntl_getfl(&this)? | OFlags::NONBLOCK)?;
        let path = PathBuf::from(OsString::from_vec(ptsname(&this, Vec::new())?.into_bytes()));
        let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC;
        let other = rustix::fs::open(&path, flags, Mode::empty())?;
        let mut settings = tcgetattr(&other)?;
        settings.make_raw();
        tcsetattr(&other, OptionalActions::Now, &settings)?;
        Ok(Self { stream: NonBlockingFd::new(this), other, path })
    }
}
