//! The few types of which all models are, and what is done with one of any of them.

use contacts::{TooManyGuards, WithContacts};
use equations::table::ModelTable;
use equations::{DoesNotFit, EquationModel};

use crate::describe::{Described as _, Playable};
use crate::entry::ModelEntry;
use crate::equation_model::{LoadedFunctions, MAX_CODED_CONTACTS};

/// Most states, and most parameters and numbers that follow from them, of a model.
pub const LARGEST: (usize, usize) = (32, 512);

/// A model without contacts, with N states and C constants.
type Loaded<const N: usize, const C: usize> = EquationModel<LoadedFunctions, N, C>;

/// Why a model cannot be loaded, with how many there are.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DoesNotLoad {
    /// More states than [`LARGEST`] has.
    States(usize),
    /// More constants than [`LARGEST`] has.
    Constants(usize),
    /// More modes than a model can have.
    Modes(usize),
    /// More contacts than [`MAX_CODED_CONTACTS`].
    Contacts(usize),
    /// More guards, contacts and frictions than can be followed.
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

/// A model of up to 4 states without contacts, as most of those that are part of the program.
pub type SmallModel = Loaded<4, 192>;

/// A model with contacts, or one that is large.
type Contacting<const N: usize, const C: usize> = WithContacts<Loaded<N, C>>;

/// A model that was read from a file, of one of a few types, with the values of its default
/// preset.
///
/// The types differ by what their arrays hold, so that a model needs no heap and a new model no
/// new type. Each of them is compiled with all methods wherever models are visited, so there are
/// no more than pay: what is large, or has contacts, hardly notices that it might have others.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
#[expect(clippy::large_enum_variant, reason = "one for each description that was read")]
pub enum LoadedModel {
    /// Up to 4 states and 192 constants, without contacts.
    Small(SmallModel),
    /// Up to 16 states and 384 constants, without contacts.
    Medium(Loaded<16, 384>),
    /// Up to 16 states and 384 constants, with contacts.
    MediumWithContacts(Contacting<16, 384>),
    /// Up to 32 states and 512 constants, with contacts or without.
    Large(Contacting<32, 512>),
}

impl LoadedModel {
    /// The smallest type into which the model of `table` fits.
    ///
    /// # Errors
    /// A model that fits into none.
    #[expect(clippy::large_stack_frames, reason = "once for a description, off the tick")]
    pub fn new(
        table: &'static ModelTable,
        functions: LoadedFunctions,
    ) -> Result<Self, DoesNotLoad> {
        let (states, contacts) = (table.states.len(), table.contacts.len());
        let constants = table.constants.max(table.parameters.len());
        let fits = |room: (usize, usize)| states <= room.0 && constants <= room.1;
        Ok(if contacts > MAX_CODED_CONTACTS {
            return Err(DoesNotLoad::Contacts(contacts));
        } else if contacts == 0 && fits((4, 192)) {
            Self::Small(Loaded::new(table, functions, &[])?)
        } else if contacts == 0 && fits((16, 384)) {
            Self::Medium(Loaded::new(table, functions, &[])?)
        } else if fits((16, 384)) {
            Self::MediumWithContacts(WithContacts::new(Loaded::new(table, functions, &[])?)?)
        } else {
            Self::Large(WithContacts::new(Loaded::new(table, functions, &[])?)?)
        })
    }

    /// The entry of the model.
    pub(crate) fn entry(&self) -> &'static ModelEntry {
        match self {
            Self::Small(model) => model.entry(),
            Self::Medium(model) => model.entry(),
            Self::MediumWithContacts(model) => model.entry(),
            Self::Large(model) => model.entry(),
        }
    }

    #[expect(clippy::large_stack_frames, reason = "once for a voice, off the tick")]
    pub(crate) fn visit<V: Visitor>(&self, visitor: V) -> V::Output {
        match self {
            Self::Small(model) => visitor.visit_small(*model),
            Self::Medium(model) => visitor.visit(*model),
            Self::MediumWithContacts(model) => visitor.visit(*model),
            Self::Large(model) => visitor.visit(*model),
        }
    }
}

/// Something to be done with a model whose type is known by its entry only.
pub trait Visitor: Sized {
    /// What the visitor makes of a model.
    type Output;

    /// Does it with `model`, which has the values of its default preset.
    fn visit<M: Playable>(self, model: M) -> Self::Output;

    /// Does it with a model of the smallest type, which most keys play: who compiles something for
    /// that type alone says so here.
    fn visit_small(self, model: SmallModel) -> Self::Output {
        self.visit(model)
    }
}
