//! The models that are part of the program: the only file that knows all of them.

use std::ptr;
use std::sync::LazyLock;

use crate::emitted::{
    bouncing_ball, cart_pendulum, key_hammer_rigid, key_hammer_springs, reduced_grand, spring_wall,
};
use crate::entry::ModelEntry;
use crate::entry_of_table::entry;
use crate::equation_model::LoadedFunctions;
use crate::loaded_model::{LoadedModel, SmallModel, Visitor};

use equations::EquationModel;
use equations::table::{Functions, ModelTable};

/// A description's table and functions, as they were emitted.
type Emitted = (&'static ModelTable, &'static dyn Functions);

/// Table and functions of each, in the order in which they are listed.
const EMITTED: [Emitted; 6] = [
    (&key_hammer_springs::TABLE, &key_hammer_springs::KeyHammerSpringsFunctions),
    (&key_hammer_rigid::TABLE, &key_hammer_rigid::KeyHammerRigidFunctions),
    (&reduced_grand::TABLE, &reduced_grand::ReducedGrandFunctions),
    (&bouncing_ball::TABLE, &bouncing_ball::BouncingBallFunctions),
    (&cart_pendulum::TABLE, &cart_pendulum::CartPendulumFunctions),
    (&spring_wall::TABLE, &spring_wall::SpringWallFunctions),
];

/// The models, each with its entry; made once.
static MODELS: LazyLock<Vec<(&'static ModelEntry, LoadedModel)>> =
    LazyLock::new(|| EMITTED.into_iter().filter_map(made).collect());

/// A model with its entry; a test asks that none is too large for all types.
#[expect(clippy::large_stack_frames, reason = "once for a model, off the tick")]
fn made((table, functions): Emitted) -> Option<(&'static ModelEntry, LoadedModel)> {
    let entry = entry(table, functions, None);
    Some((entry, LoadedModel::new(table, LoadedFunctions::new(functions, entry)).ok()?))
}

/// Every model that is part of the program.
pub fn entries() -> impl Iterator<Item = &'static ModelEntry> + Clone {
    MODELS.iter().map(|(entry, _)| *entry)
}

/// The model called `name`, if it is part of the program and small; for those who need its type.
pub fn small(name: &str) -> Option<SmallModel> {
    let (_, model) = MODELS.iter().find(|(entry, _)| entry.name == name)?;
    if let LoadedModel::Small(model) = model { Some(*model) } else { None }
}

/// Does something with `model` as a type of its own, if it is the paper's A or B: its equations are
/// part of each step then, and no calls.
///
/// Each of them is compiled with all that the visitor does, and it pays only where the equations are
/// short: those of the reduced grand take longer so.
pub fn visit_by_type<V: Visitor>(model: SmallModel, visitor: V) -> V::Output {
    use crate::emitted::{key_hammer_rigid as rigid, key_hammer_springs as springs};
    if ptr::eq(model.table(), &raw const springs::TABLE) {
        visitor.visit(of_type(&model, springs::KeyHammerSpringsFunctions))
    } else if ptr::eq(model.table(), &raw const rigid::TABLE) {
        visitor.visit(of_type(&model, rigid::KeyHammerRigidFunctions))
    } else {
        visitor.visit(model)
    }
}

fn of_type<F>(model: &SmallModel, functions: F) -> EquationModel<LoadedFunctions<F>, 4, 192> {
    let functions = model.functions().of_type(functions);
    model.with_functions(functions)
}

/// The model of `entry`, if it is part of the program.
pub(crate) fn model(entry: &ModelEntry) -> Option<&'static LoadedModel> {
    MODELS.iter().find(|(known, _)| entry.is(known)).map(|(_, model)| model)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_emitted_model_fits_into_a_type() {
        assert_eq!(entries().count(), EMITTED.len());
    }
}
