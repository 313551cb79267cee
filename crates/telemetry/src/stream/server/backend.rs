//! What the host supplies.

use std::fmt;
use std::net::SocketAddr;

use super::Role;
use crate::{Reply, Request};

/// The host, as the stream knows it.
pub trait Backend: Send + Sync {
    /// Returns parameters by their names, in any order; all without names. Those that are not known
    /// are left out.
    fn parameters(&self, names: Option<&[String]>) -> Vec<ParameterSetting>;

    /// Does what is asked, and returns when it is done; a set is done as a whole or not at all.
    ///
    /// It is called on a thread that may wait, for each client one call after the other, except for
    /// a stop, which overtakes.
    /// A client that set values gets them as the answer; those that follow parameters are told by
    /// the host, with [`super::Publisher::parameters_changed`].
    ///
    /// # Errors
    /// If it is refused; a sentence.
    fn ask(&self, request: Request, who: &Who) -> Result<Reply, String>;

    /// Returns figures in the text format of Prometheus, for `GET /metrics`; it must not wait.
    fn metrics(&self) -> Option<String> {
        None
    }

    /// Hears that `who` has come in.
    fn connected(&self, who: &Who) {
        let _ = who;
    }

    /// Hears that the connection of `who` is over, however it ended: what it had pressed is to
    /// be let go. No press of this client is asked for afterwards.
    ///
    /// It is called on the runtime's thread and must not wait.
    fn disconnected(&self, who: &Who) {
        let _ = who;
    }

    /// Hears that a client at `address` was refused, and why.
    fn refused(&self, address: SocketAddr, why: &str) {
        let _ = (address, why);
    }
}

/// A parameter with its value.
#[derive(Clone, PartialEq, Debug)]
pub struct ParameterSetting {
    /// Name, as `/key/39/k2`.
    pub name: String,
    /// Value in the parameter's unit.
    pub value: f64,
}

/// A client of the stream.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Who {
    /// Number of the client, counted in a run.
    pub number: u64,
    pub address: SocketAddr,
    pub role: Role,
}

impl fmt::Display for Who {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "client {} ({}) at {}", self.number, self.role.name(), self.address.ip())
    }
}
