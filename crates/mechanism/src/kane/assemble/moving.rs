//! A mode as it moves: what parts and kinds are found from.

use super::jacobian::StateOfMode;
use crate::kane::graph::Node;

pub(super) struct Moving<'a> {
    pub(super) name: &'a str,
    pub(super) state: &'a StateOfMode<'a>,
    pub(super) rates: &'a [Node],
    pub(super) jacobian: &'a [Vec<Node>],
    pub(super) dissipated: Option<Node>,
    pub(super) parameters: u16,
}
