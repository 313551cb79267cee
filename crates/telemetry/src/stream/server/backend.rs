//! The host's side of the stream.

use std::{fmt, net::SocketAddr};

use super::Role;
use crate::{Reply, Request};

/// The host, as the stream knows it.
pub trait Backend: Send + Sync {
    /// Returns parameters by their names, in any order; all if `None`. Unknown names are left out.
    fn parameters(&self, names: Option<&[String]>) -> Vec<ParameterSetting>;

    /// Executes a request and returns after it; a set is done as a whole or not at all.
    ///
    /// The calling thread may wait. Calls of one client come one after the other, except for a
    /// stop, which overtakes. A client that set values gets them as the answer; the host informs
    /// those that follow parameters with [`super::Publisher::parameters_changed`].
    ///
    /// # Errors
    /// The host rejects the request; a sentence.
    fn ask(&self, request: Request, who: &Who) -> Result<Reply, String>;

    /// Returns figures in the text format of Prometheus, for `GET /metrics`; it must not wait.
    fn metrics(&self) -> Option<String> {
        None
    }

    fn connected(&self, who: &Who) {
        let _ = who;
    }

    /// Handles the disconnection of `who`, for any reason: its pressed keys must be released. No
    /// press of this client follows.
    ///
    /// The runtime's thread calls this; it must not wait.
    fn disconnected(&self, who: &Who) {
        let _ = who;
    }

    fn refused(&self, address: SocketAddr, why: &str) {
        let _ = (address, why);
    }
}

/// A parameter with its value.
#[derive(Clone, PartialEq, Debug)]
pub struct ParameterSetting {
    /// Name, as `/key/39/k2`.
    pub name: String,
    pub value: f64,
}

/// A client of the stream.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Who {
    pub number: u64,
    pub address: SocketAddr,
    pub role: Role,
}

impl fmt::Display for Who {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "client {} ({}) at {}", self.number, self.role.name(), self.address.ip())
    }
}
