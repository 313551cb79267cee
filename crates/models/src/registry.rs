//! Models that are read from files while the program runs.
//!
//! A list that only grows, for the whole process: whoever reads a description leaks a
//! [`Registration`] on purpose and appends it here. Voices that play a version of a model keep it
//! when a newer one is registered under its name; a look-up by name finds the newest. A version
//! takes what its table and its machine code take, some 10 to 500 KiB, and a description that is
//! saved a hundred times while somebody works on it takes a hundred of them: tens of megabytes at
//! most, until the program ends.

use std::sync::OnceLock;

use contacts::{TooManyGuards, WithContacts};
use equations::table::ModelTable;
use equations::{DoesNotFit, EquationModel};

use crate::built_in;
use crate::describe::Described as _;
use crate::entry::ModelEntry;
use crate::equation_model::LoadedFunctions;
use crate::visitor::Visitor;

pub use crate::equation_model::MAX_CODED_CONTACTS;

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
    /// Up to 12 states and 256 constants, without contacts.
    Medium(Loaded<12, 256>),
    /// Up to 12 states and 256 constants, with contacts.
    MediumWithContacts(Contacting<12, 256>),
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
        } else if contacts == 0 && fits((12, 256)) {
            Self::Medium(Loaded::new(table, functions, &[])?)
        } else if fits((12, 256)) {
            Self::MediumWithContacts(WithContacts::new(Loaded::new(table, functions, &[])?)?)
        } else {
            Self::Large(WithContacts::new(Loaded::new(table, functions, &[])?)?)
        })
    }

    /// The entry of the model.
    fn entry(&self) -> &'static ModelEntry {
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

/// A version of a model in the list of those that were read from files.
#[derive(Debug)]
pub struct Registration {
    model: LoadedModel,
    /// The one that was registered next.
    next: OnceLock<&'static Self>,
}

impl Registration {
    /// A version that is not in the list yet.
    #[expect(clippy::large_stack_frames, reason = "once for a description, off the tick")]
    pub const fn new(model: LoadedModel) -> Self {
        Self { model, next: OnceLock::new() }
    }
}

/// The oldest registration.
static FIRST: OnceLock<&'static Registration> = OnceLock::new();

/// Appends a version of a model, from which on it is the one that its name finds.
///
/// One that is in the list already stays where it is.
pub fn register(registration: &'static Registration) {
    let mut place = &FIRST;
    // Each turn is one registration further, or ends.
    while place.set(registration).is_err() {
        let Some(taken) = place.get() else { return };
        if core::ptr::eq(*taken, registration) {
            return;
        }
        place = &taken.next;
    }
}

/// Every registration, the oldest first.
fn all() -> impl Iterator<Item = &'static Registration> {
    core::iter::successors(FIRST.get().copied(), |it| it.next.get().copied())
}

/// The newest version of each model, in the order in which their first versions were registered.
pub(crate) fn newest() -> impl Iterator<Item = &'static ModelEntry> {
    let entry = |index: usize| all().nth(index).map(|it| it.model.entry());
    let is_first =
        move |index: usize, name: &str| all().take(index).all(|it| it.model.entry().name != name);
    let names = (0..).map_while(entry).enumerate();
    names.filter(move |(index, it)| is_first(*index, it.name)).filter_map(|(_, it)| find(it.name))
}

/// The newest version of the model called `name`.
pub(crate) fn find(name: &str) -> Option<&'static ModelEntry> {
    all().map(|it| it.model.entry()).filter(|it| it.name == name).last()
}

/// The model of `entry`, if it is part of the program or in the list.
pub(crate) fn model(entry: &ModelEntry) -> Option<&'static LoadedModel> {
    built_in::model(entry).or_else(|| {
        let found = all().find(|it| it.model.entry().is(entry))?;
        Some(&found.model)
    })
}
