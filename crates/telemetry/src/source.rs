//! Source of a window's data: a live host, or a recording.

use std::{collections::BTreeSet, fmt};

use crate::{Reply, Request, Topic, Update, role::Role};

/// Number of a request, which its reply carries.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Ticket(pub u64);

/// Arrival from a source.
#[derive(Clone, PartialEq, Debug)]
pub enum Arrival {
    /// A message, and when it was made (ns since 1970).
    Update { at: u64, update: Box<Update> },
    Reply {
        ticket: Ticket,
        /// The reply, or an error as a sentence.
        result: Result<Reply, String>,
    },
    /// A new run, or another position in a recording, begins: messages before it are obsolete.
    Anew,
}

/// State of a source's connection.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ConnectionState {
    Connecting,
    Live,
    /// The host does not answer, for this reason; the source tries again.
    Lost(String),
    /// The host rejects the connection, for this reason; the source tries again at longer intervals.
    Refused(String),
    Recording,
    /// A recording that repeats.
    Demonstration,
}

/// A live host or a recording. Nothing here waits.
pub trait Source: fmt::Debug {
    fn next(&mut self) -> Option<Arrival>;

    /// Follows these topics from now on, and no others.
    fn follow(&mut self, topics: &BTreeSet<Topic>);

    /// Sends a request; its answer is an [`Arrival::Reply`], an error from a recording.
    fn ask(&mut self, request: Request) -> Ticket;

    fn standing(&self) -> ConnectionState;

    fn name(&self) -> String;

    /// Returns the rights that a host granted; `None` without a connection.
    fn role(&self) -> Option<Role> {
        None
    }

    fn timeline(&mut self) -> Option<&mut dyn Timeline> {
        None
    }
}

/// A moment of a recording that is worth finding again.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Mark {
    /// Time (ns since 1970).
    pub at: u64,
    pub text: String,
    pub is_fault: bool,
}

/// Control over a source's time.
pub trait Timeline {
    /// Returns the times of beginning and end (ns since 1970).
    fn span(&self) -> (u64, u64);

    /// Returns the position (ns since 1970).
    fn at(&self) -> u64;

    /// Moves to `at` (ns since 1970): [`Arrival::Anew`] follows, then the seconds before `at`.
    fn seek(&mut self, at: u64);

    /// Returns the speed: recorded seconds per second; 0 pauses.
    fn speed(&self) -> f64;

    fn set_speed(&mut self, speed: f64);

    /// Returns the moments worth finding again that are known so far.
    fn marks(&self) -> &[Mark];
}
