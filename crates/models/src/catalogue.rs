//! From a name to a model: the only file that knows all models.

use crate::describe::{Parameter, Playable, Preset};
use crate::{
    BouncingBall, CartPendulum, KeyHammerRigid, KeyHammerSprings, ReducedGrand, SpringWall,
};

/// Something to be done with a model whose type is known by name only.
pub trait Visitor {
    /// What comes out.
    type Output;

    /// Does it with the model type `M`.
    fn visit<M: Playable>(self) -> Self::Output;
}

/// What is known of a model without building one.
#[derive(Clone, Copy, Debug)]
pub struct ModelEntry {
    pub name: &'static str,
    /// What it is, in one line.
    pub summary: &'static str,
    pub parameters: &'static [Parameter],
    /// Its presets; the first is the default.
    pub presets: &'static [Preset],
    /// Names of its state's entries.
    pub states: &'static [&'static str],
    /// SI unit of each of them.
    pub state_units: &'static [&'static str],
    /// Names of its outputs.
    pub outputs: &'static [&'static str],
    /// SI unit of each of them.
    pub output_units: &'static [&'static str],
}

macro_rules! catalogue {
    ($($model:ty),+ $(,)?) => {
        /// Every model.
        pub const ENTRIES: &[ModelEntry] = &[$(entry::<$model>()),+];

        /// Does something with the model called `name`, if there is one.
        pub fn visit<V: Visitor>(name: &str, visitor: V) -> Option<V::Output> {
            $(if name == <$model as crate::Described>::NAME {
                return Some(visitor.visit::<$model>());
            })+
            None
        }
    };
}

catalogue!(KeyHammerSprings, KeyHammerRigid, ReducedGrand, BouncingBall, CartPendulum, SpringWall);

const fn entry<M: Playable>() -> ModelEntry {
    ModelEntry {
        name: M::NAME,
        summary: M::SUMMARY,
        parameters: M::PARAMETERS,
        presets: M::PRESETS,
        states: M::STATES,
        state_units: M::STATE_UNITS,
        outputs: M::OUTPUTS,
        output_units: M::OUTPUT_UNITS,
    }
}

/// The entry called `name`, if there is one.
pub fn find(name: &str) -> Option<&'static ModelEntry> {
    ENTRIES.iter().find(|entry| entry.name == name)
}
