//! What a window asks of its connection.

use std::collections::BTreeSet;

use crate::source::Ticket;
use crate::{Request, Topic};

/// What a window asks of its connection.
#[derive(Debug)]
pub(super) enum ClientCommand {
    Follow(BTreeSet<Topic>),
    Ask(Ticket, Request),
}
