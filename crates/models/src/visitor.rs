//! Something to be done with a model of any type.

use crate::describe::Playable;

/// Something to be done with a model whose type is known by its entry only.
pub trait Visitor: Sized {
    /// What comes out.
    type Output;

    /// Does it with `model`, which has the values of its default preset.
    fn visit<M: Playable>(self, model: M) -> Self::Output;

    /// Does it with a model that was read from a file: of one type, there are many of them.
    ///
    /// What is compiled for several methods where it matters can be compiled once for these.
    fn visit_loaded<M: Playable>(self, model: M) -> Self::Output {
        self.visit(model)
    }
}
