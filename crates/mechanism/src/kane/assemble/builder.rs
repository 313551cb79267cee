//! What the makers of one mode's table share.

use instruments::equations::table::FunctionId;

use super::AssemblyError;
use super::functions::FunctionList;
use super::guard_numbers::GuardNumbers;
use super::jacobian::StateOfMode;
use crate::kane::graph::{Graph, Node, Place};
use crate::kane::mechanism::Mechanism;
use crate::kane::system::ModeEquations;

pub(super) struct ModeContext<'a> {
    pub(super) mechanism: &'a Mechanism,
    pub(super) places: &'a [Place],
    pub(super) coordinates: usize,
    pub(super) modes: &'a [ModeEquations],
    pub(super) numbers: &'a GuardNumbers,
}

pub(super) struct ModeBuilder<'a> {
    pub(super) context: &'a ModeContext<'a>,
    pub(super) name: &'a str,
    pub(super) equations: &'a ModeEquations,
    pub(super) state: StateOfMode<'a>,
    pub(super) follows_input: bool,
}

impl ModeBuilder<'_> {
    pub(super) fn add(
        &self,
        graph: &mut Graph,
        functions: &mut FunctionList,
        what: &str,
        outputs: &[Node],
    ) -> Result<FunctionId, AssemblyError> {
        functions.add(graph, &format!("{}_{what}", self.name), outputs)
    }
}
