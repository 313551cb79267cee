use std::collections::BTreeSet;

use crate::source::Ticket;
use crate::{Request, Topic};

/// Command of a window to its connection.
#[derive(Debug)]
pub(super) enum ClientCommand {
    Follow(BTreeSet<Topic>),
    Ask(Ticket, Request),
}
