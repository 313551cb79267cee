//! From a name to a model: the only file that knows all models that are part of the program.

pub use crate::entry::ModelEntry;
pub use crate::visitor::Visitor;

use crate::registry;

macro_rules! catalogue {
    ($($module:ident::$model:ident),+ $(,)?) => {
        /// Every model that is part of the program.
        pub static ENTRIES: &[&ModelEntry] = &[$(&crate::$module::ENTRY),+];

        /// Does something with the model of `entry`, which is part of the program; none if it is
        /// not.
        pub fn visit_built_in<V: Visitor>(entry: &ModelEntry, visitor: V) -> Option<V::Output> {
            $(if entry.is(&crate::$module::ENTRY) {
                return Some(visitor.visit(crate::$module::$model::default()));
            })+
            None
        }
    };
}

catalogue!(
    key_hammer_springs::KeyHammerSprings,
    key_hammer_rigid::KeyHammerRigid,
    reduced_grand::ReducedGrand,
    bouncing_ball::BouncingBall,
    cart_pendulum::CartPendulum,
    spring_wall::SpringWall,
);

/// Does something with the model of `entry`; none if it is a copy of an entry.
///
/// It is compiled for the types of all models, those of files included: what is done with models
/// of the program alone asks [`visit_built_in`].
pub fn visit<V: Visitor>(entry: &ModelEntry, visitor: V) -> Option<V::Output> {
    if ENTRIES.iter().any(|known| entry.is(known)) {
        return visit_built_in(entry, visitor);
    }
    registry::visit(entry, visitor)
}

/// Every model: those of the program, then the newest version of each that was read from a file,
/// in the order in which they were read first.
pub fn entries() -> impl Iterator<Item = &'static ModelEntry> {
    ENTRIES.iter().copied().chain(registry::newest())
}

/// The model called `name` that is part of the program, if there is one.
pub fn built_in(name: &str) -> Option<&'static ModelEntry> {
    ENTRIES.iter().copied().find(|entry| entry.name == name)
}

/// The newest version of the model called `name`: that of the file that was read last, else the
/// one that is part of the program, if there is one.
pub fn find(name: &str) -> Option<&'static ModelEntry> {
    registry::find(name).or_else(|| built_in(name))
}
