//! Something to be done with a model of any type.

use crate::describe::Playable;
use crate::registry::SmallModel;

/// Something to be done with a model whose type is known by its entry only.
pub trait Visitor: Sized {
    /// What comes out.
    type Output;

    /// Does it with `model`, which has the values of its default preset.
    fn visit<M: Playable>(self, model: M) -> Self::Output;

    /// Does it with a model of the smallest type, which most keys play: who compiles something for
    /// that type alone says so here.
    fn visit_small(self, model: SmallModel) -> Self::Output {
        self.visit(model)
    }
}
