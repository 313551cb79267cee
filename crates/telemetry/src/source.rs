//! Where a window gets what it shows: a live host, or a recording.

use std::collections::BTreeSet;
use std::fmt;

use crate::{Reply, Request, Topic, Update};

/// Which request a reply is to.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Ticket(pub u64);

/// What a source gives.
#[derive(Clone, PartialEq, Debug)]
pub enum Arrival {
    /// A message, and when it was made (ns since 1970).
    Update { at: u64, update: Box<Update> },
    /// What became of a request.
    Reply {
        ticket: Ticket,
        /// A refusal is a sentence.
        result: Result<Reply, String>,
    },
    /// A new run, or another place in a recording: what came before is of no use any more.
    Anew,
}

/// How a source stands.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ConnectionState {
    /// Nobody has answered yet.
    Connecting,
    Live,
    /// Nobody answers; it is tried again. Why, in a sentence.
    Lost(String),
    /// It will not give again. Why, in a sentence.
    Refused(String),
    Recording,
}

/// A live host or a recording. Nothing here waits.
pub trait Source: fmt::Debug {
    /// What came next, if anything has come.
    fn next(&mut self) -> Option<Arrival>;

    /// From now on these topics, and no others.
    fn follow(&mut self, topics: &BTreeSet<Topic>);

    /// Asks; the answer is an [`Arrival::Reply`]. A recording refuses.
    fn ask(&mut self, request: Request) -> Ticket;

    /// How it stands.
    fn standing(&self) -> ConnectionState;

    /// Where it comes from, for people: an address or a file.
    fn name(&self) -> String;

    /// Where in time it is, if that can be chosen.
    fn timeline(&mut self) -> Option<&mut dyn Timeline> {
        None
    }
}

/// A moment worth finding again.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Mark {
    /// When (ns since 1970).
    pub at: u64,
    /// What, in a few words.
    pub text: String,
    /// Whether something went wrong.
    pub is_fault: bool,
}

/// A source whose time can be chosen.
pub trait Timeline {
    /// From when to when it goes (ns since 1970).
    fn span(&self) -> (u64, u64);

    /// Where it is (ns since 1970).
    fn at(&self) -> u64;

    /// Goes there [ns since 1970]: what follows begins with [`Arrival::Anew`] and the seconds
    /// before it.
    fn seek(&mut self, at: u64);

    /// How many seconds go by in one; 0 stands still.
    fn speed(&self) -> f64;

    /// Sets [`Timeline::speed`].
    fn set_speed(&mut self, speed: f64);

    /// Moments worth finding again, as far as they are known yet.
    fn marks(&self) -> &[Mark];
}
