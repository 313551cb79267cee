//! Values of a tape while they are rearranged to take fewer operations.

use std::collections::BTreeSet;

use super::{Argument, ArgumentLayout};
use crate::expressions::graph::{
    BinaryFunction, Graph, Node, NodeMap, NodeOperation, Place, UnaryFunction,
};

pub(super) type FormId = usize;

#[derive(Clone, PartialEq, Debug)]
pub(super) enum TapeForm {
    Number(f64),
    Argument(Argument),
    /// Number, and forms times a factor each, sorted by form.
    Sum(f64, Vec<(FormId, f64)>),
    /// Forms to a whole power each, sorted by form.
    Product(Vec<(FormId, i32)>),
    Inverse(FormId),
    Unary(UnaryFunction, FormId),
    Binary(BinaryFunction, FormId, FormId),
    Select([FormId; 3]),
}

impl TapeForm {
    pub(super) fn operands(&self, mut see: impl FnMut(FormId)) {
        match self {
            Self::Number(_) | Self::Argument(_) => {}
            Self::Sum(_, terms) => terms.iter().for_each(|(id, _)| see(*id)),
            Self::Product(factors) => factors.iter().for_each(|(id, _)| see(*id)),
            Self::Inverse(x) | Self::Unary(_, x) => see(*x),
            Self::Binary(_, x, y) => [*x, *y].into_iter().for_each(see),
            Self::Select(all) => all.iter().copied().for_each(see),
        }
    }
}

#[derive(Clone, Debug, Default)]
pub(super) struct Forms {
    pub(super) all: Vec<TapeForm>,
    pub(super) outputs: Vec<FormId>,
    pub(super) ids: NodeMap<Node, FormId>,
}

impl Forms {
    /// Returns the forms of `outputs`, one per node that is computed or read.
    ///
    /// # Errors
    /// A symbol without an argument in `layout`.
    pub(super) fn new(
        graph: &Graph,
        layout: &ArgumentLayout,
        outputs: &[Node],
    ) -> Result<Self, Place> {
        let mut forms = Self::default();
        for node in needed(graph, layout, outputs) {
            let form = match layout.ready.get(&node) {
                Some(argument) => TapeForm::Argument(*argument),
                None => form(graph, layout, &forms.ids, node)?,
            };
            let id = forms.push(form);
            forms.ids.insert(node, id);
        }
        forms.outputs = outputs.iter().map(|node| forms.ids[node]).collect();
        Ok(forms)
    }

    pub(super) fn push(&mut self, form: TapeForm) -> FormId {
        self.all.push(form);
        self.all.len() - 1
    }

    pub(super) fn uses(&self) -> Vec<u32> {
        let mut uses = vec![0_u32; self.all.len()];
        for form in &self.all {
            form.operands(|id| uses[id] += 1);
        }
        for output in &self.outputs {
            uses[*output] += 1;
        }
        uses
    }
}

/// Returns the nodes that are computed or read, operands first; ready nodes hide their operands.
fn needed(graph: &Graph, layout: &ArgumentLayout, outputs: &[Node]) -> Vec<Node> {
    let mut wanted: BTreeSet<Node> = outputs.iter().copied().collect();
    let mut all = Vec::new();
    while let Some(node) = wanted.pop_last() {
        all.push(node);
        if !layout.ready.contains_key(&node) {
            graph.operation(node).operands(|operand| {
                wanted.insert(operand);
            });
        }
    }
    all.reverse();
    all
}

fn form(
    graph: &Graph,
    layout: &ArgumentLayout,
    ids: &NodeMap<Node, FormId>,
    node: Node,
) -> Result<TapeForm, Place> {
    let id = |it: &Node| ids[it];
    Ok(match graph.operation(node) {
        NodeOperation::Number(bits) => TapeForm::Number(f64::from_bits(*bits)),
        NodeOperation::Symbol(place) => {
            TapeForm::Argument(*layout.places.get(place).ok_or(*place)?)
        }
        NodeOperation::Sum(number, terms) => {
            let terms = terms.iter().map(|(it, by)| (id(it), f64::from_bits(*by))).collect();
            TapeForm::Sum(f64::from_bits(*number), terms)
        }
        NodeOperation::Product(factors) => {
            TapeForm::Product(factors.iter().map(|(it, by)| (id(it), *by)).collect())
        }
        NodeOperation::Unary(function, x) => TapeForm::Unary(*function, id(x)),
        NodeOperation::Binary(function, x, y) => TapeForm::Binary(*function, id(x), id(y)),
        NodeOperation::Select(all) => TapeForm::Select(all.map(|it| id(&it))),
    })
}
