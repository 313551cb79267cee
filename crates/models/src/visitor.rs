//! Something to be done with a model of any type.

use crate::describe::Playable;

/// Something to be done with a model whose type is known by its entry only.
pub trait Visitor: Sized {
    /// What comes out.
    type Output;

    /// Does it with `model`, which has the values of its default preset.
    fn visit<M: Playable>(self, model: M) -> Self::Output;
}
