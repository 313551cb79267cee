use std::collections::BTreeSet;

use crate::{Request, Topic, source::Ticket};

#[derive(Debug)]
pub(super) enum ClientCommand {
    Follow(BTreeSet<Topic>),
    Ask(Ticket, Request),
}
