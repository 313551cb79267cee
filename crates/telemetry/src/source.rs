//! Where a window gets what it shows: a live host, or a recording.

use std::collections::BTreeSet;
use std::fmt;

use crate::{Reply, Request, Topic, Update};

/// The number of a request, which its reply carries.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Ticket(pub u64);

/// What a source delivers.
#[derive(Clone, PartialEq, Debug)]
pub enum Arrival {
    /// A message, and when it was made (ns since 1970).
    Update { at: u64, update: Box<Update> },
    /// The answer to a request.
    Reply {
        ticket: Ticket,
        /// The reply, or a refusal as a sentence.
        result: Result<Reply, String>,
    },
    /// A new run, or another place in a recording, begins: messages before it are obsolete.
    Anew,
}

/// The state of a source's connection.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ConnectionState {
    /// The host has not answered yet.
    Connecting,
    Live,
    /// The host does not answer, for this reason, and is tried again.
    Lost(String),
    /// The host refuses the connection, for this reason, and is not tried again.
    Refused(String),
    Recording,
}

/// A live host or a recording. Nothing here waits.
pub trait Source: fmt::Debug {
    /// Returns what came next, if anything has come.
    fn next(&mut self) -> Option<Arrival>;

    /// Follows these topics from now on, and no others.
    fn follow(&mut self, topics: &BTreeSet<Topic>);

    /// Sends a request; its answer is an [`Arrival::Reply`], and that of a recording a refusal.
    fn ask(&mut self, request: Request) -> Ticket;

    /// Returns the state of the connection.
    fn standing(&self) -> ConnectionState;

    /// Returns the address or the file that it comes from, to be shown.
    fn name(&self) -> String;

    /// Returns its timeline, if its time can be chosen.
    fn timeline(&mut self) -> Option<&mut dyn Timeline> {
        None
    }
}

/// A moment of a recording that is worth finding again.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Mark {
    /// Time of the moment (ns since 1970).
    pub at: u64,
    pub text: String,
    /// Whether something went wrong.
    pub is_fault: bool,
}

/// A source whose time can be chosen.
pub trait Timeline {
    /// Returns the times of its beginning and its end (ns since 1970).
    fn span(&self) -> (u64, u64);

    /// Returns the time at which it is (ns since 1970).
    fn at(&self) -> u64;

    /// Goes there (ns since 1970): what follows begins with [`Arrival::Anew`] and the seconds
    /// before it.
    fn seek(&mut self, at: u64);

    /// Returns the speed: recorded seconds that go by in one; 0 stands still.
    fn speed(&self) -> f64;

    /// Sets the speed: recorded seconds that go by in one; 0 stands still.
    fn set_speed(&mut self, speed: f64);

    /// Returns moments worth finding again, as far as they are known yet.
    fn marks(&self) -> &[Mark];
}
