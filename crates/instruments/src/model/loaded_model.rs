//! The few types of all models, and operations on a model of any of them.

use alloc::sync::Arc;
use core::ops::Deref;

use crate::equations::table::{Equations as _, ModelTable};
use crate::equations::{DoesNotFit, EquationModel};
use pode::contacts::{TooManyGuards, WithContacts};

use crate::equations::table::MAX_CODED_CONTACTS;
use crate::model::describe::Playable;
use crate::model::entry::ModelEntry;
use crate::model::parts::ModelParts;
use crate::model::source::ModelSource;

pub use crate::model::entry::SharedFunctions;

/// Maximum number of states, and of constants (parameters and derived numbers), of a model.
pub const LARGEST: (usize, usize) = (32, 512);

type Loaded<const N: usize, const C: usize> = EquationModel<Arc<ModelParts>, N, C>;

/// Reason why a model cannot be loaded, with the number found.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DoesNotLoad {
    States(usize),
    Constants(usize),
    Modes(usize),
    /// More contacts than [`MAX_CODED_CONTACTS`].
    Contacts(usize),
    /// More guards, contacts and frictions than `pode` can watch.
    Guards,
}

impl From<DoesNotFit> for DoesNotLoad {
    fn from(why: DoesNotFit) -> Self {
        match why {
            DoesNotFit::States(n) => Self::States(n),
            DoesNotFit::Constants(n) => Self::Constants(n),
            DoesNotFit::Modes(n) => Self::Modes(n),
        }
    }
}

impl From<TooManyGuards> for DoesNotLoad {
    fn from(why: TooManyGuards) -> Self {
        match why {
            TooManyGuards::Contacts(n) => Self::Contacts(n),
            TooManyGuards::Frictions | TooManyGuards::Guards | TooManyGuards::Id(_) => Self::Guards,
        }
    }
}

/// A model of up to 4 states without contacts, for callers that need its type.
pub type SmallModel = Loaded<4, 192>;

type Contacting<const N: usize, const C: usize> = WithContacts<Loaded<N, C>>;

/// A model with the values of its default preset, as one of a few types.
///
/// The types differ by the size of their arrays, so that a model in the tick needs no heap and a
/// new description no new type. Each type is compiled with all methods wherever models are visited,
/// so there are few: a large model, or one with contacts, hardly notices spare room.
#[derive(Debug)]
#[expect(clippy::large_enum_variant, reason = "one for each description that was read")]
enum Prototype {
    Small(SmallModel),
    Medium(Loaded<16, 384>),
    MediumWithContacts(Contacting<16, 384>),
    /// Up to 32 states and 512 constants, with contacts or without.
    Large(Contacting<32, 512>),
}

impl Prototype {
    /// Uses the smallest type into which the model fits.
    #[expect(clippy::large_stack_frames, reason = "once for a description, off the tick")]
    fn new(parts: Arc<ModelParts>) -> Result<Self, DoesNotLoad> {
        let table = parts.table();
        let (states, contacts) = (table.states.len(), table.contacts.len());
        let constants = table.constants.count.max(table.parameters.len());
        let fits = |room: (usize, usize)| states <= room.0 && constants <= room.1;
        Ok(if contacts > MAX_CODED_CONTACTS {
            return Err(DoesNotLoad::Contacts(contacts));
        } else if contacts == 0 && fits((4, 192)) {
            Self::Small(Loaded::new(parts, &[])?)
        } else if contacts == 0 && fits((16, 384)) {
            Self::Medium(Loaded::new(parts, &[])?)
        } else if fits((16, 384)) {
            Self::MediumWithContacts(WithContacts::new(Loaded::new(parts, &[])?)?)
        } else {
            Self::Large(WithContacts::new(Loaded::new(parts, &[])?)?)
        })
    }
}

/// A model from a description: its entry, and its value for a [`Visitor`].
#[derive(Debug)]
pub struct LoadedModel {
    parts: Arc<ModelParts>,
    prototype: Prototype,
}

impl LoadedModel {
    /// Builds the model as a new version, read from `source`; fails for a model that is too large.
    #[expect(clippy::large_stack_frames, reason = "once for a description, off the tick")]
    pub fn new(
        table: ModelTable,
        functions: SharedFunctions,
        source: Option<ModelSource>,
    ) -> Result<Self, DoesNotLoad> {
        let entry = ModelEntry::new(&table, &functions, source);
        let parts = Arc::new(ModelParts::new(entry, table, functions));
        Ok(Self { prototype: Prototype::new(Arc::clone(&parts))?, parts })
    }

    pub fn small(&self) -> Option<SmallModel> {
        if let Prototype::Small(model) = &self.prototype { Some(model.clone()) } else { None }
    }

    /// Calls `report` with each condition on the parameters that `values` violate, as
    /// `string > trip`.
    pub fn unmet(&self, values: &[f64], report: &mut dyn FnMut(&str)) {
        // The natures of modes, which take a thousand times longer, say nothing about this.
        let parts: &ModelParts = &self.parts;
        let model =
            EquationModel::<_, { LARGEST.0 }, { LARGEST.1 }>::without_natures(parts, values);
        let Ok(model) = model else { return };
        model.unmet().for_each(|condition| report(&condition.text));
    }

    /// Calls `visitor` with the model, which has the values of its default preset.
    #[expect(clippy::large_stack_frames, reason = "once for a voice, off the tick")]
    pub fn visit<V: Visitor>(&self, visitor: V) -> V::Output {
        match &self.prototype {
            Prototype::Small(model) => visitor.visit(model.clone()),
            Prototype::Medium(model) => visitor.visit(model.clone()),
            Prototype::MediumWithContacts(model) => visitor.visit(model.clone()),
            Prototype::Large(model) => visitor.visit(model.clone()),
        }
    }
}

impl Deref for LoadedModel {
    type Target = ModelEntry;

    fn deref(&self) -> &ModelEntry {
        &self.parts
    }
}

/// An operation on a model of a type that only its [`LoadedModel`] knows.
pub trait Visitor: Sized {
    type Output;

    /// Runs on `model`, which has the values of its default preset.
    fn visit<M: Playable>(self, model: M) -> Self::Output;
}
