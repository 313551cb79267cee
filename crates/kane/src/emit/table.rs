//! The table of a model as a constant expression.

use contacts::{ContactSpec, FrictionSpec};
use equations::table::{
    BodyTable, ContactModeTable, ContactTable, DamperTable, DrawingTable, Freedom, GuardTable,
    Material, MidiTable, ModeTable, ModelTable, NamedQuantity, OutlineTable, ParameterTable,
    PartTable, PresetTable, PressureKind, PressureTable, RequirementTable, RestTable, RestingTable,
    SeriesTable, SpringTable, WayTable,
};
use pode::{EquationKind, Fires, GuardId, GuardSpec, Part, Reads};

use super::layout::Literal;
use super::number;

/// What can be written as a constant expression.
pub(super) trait Constant {
    /// Returns it as a constant expression.
    fn literal(&self) -> Literal;
}

/// Structures, field by field: one that gets another field does not compile here until it is
/// written too.
macro_rules! structures {
    ($($name:ident { $($field:ident),+ $(,)? })+) => {$(
        impl Constant for $name {
            fn literal(&self) -> Literal {
                let Self { $($field),+ } = self;
                Literal::Struct(
                    stringify!($name),
                    vec![$((stringify!($field), $field.literal())),+],
                )
            }
        }
    )+};
}

/// Enumerations, variant by variant.
macro_rules! enumerations {
    ($($name:ident { $($variant:ident),+ $(,)? })+) => {$(
        impl Constant for $name {
            fn literal(&self) -> Literal {
                let name = match self {
                    $(Self::$variant => stringify!($variant)),+
                };
                Literal::Word(format!("{}::{name}", stringify!($name)))
            }
        }
    )+};
}

structures! {
    ModelTable {
        name, summary, parameters, presets, requirements, states, coordinates, constants,
        derive_constants, input, input_per_metre, modes, contacts, contact_specs, guard_specs, outputs,
        rest, damper, midi, drawing,
    }
    NamedQuantity { name, unit }
    ParameterTable { name, title, unit, range, doc }
    PresetTable { name, doc, values }
    RequirementTable { text, margin }
    ModeTable {
        name, derivative, parts, part_list, slaved, projection, projected, longest_projection,
        readout, slopes, outputs, balance, jacobian, series, kind, loss, is_stiffening, guards,
        guard_specs, contacts, freedom,
    }
    Freedom { n, m, p }
    SeriesTable { start, step, entries, guards, conditions, lanes, carried }
    PartTable { entries, derivative, kind, loss, reads }
    GuardTable { id, name, unit, priority, scale, fires, reads, value, bound, ways, sounds }
    WayTable { when, to, reset, resting }
    RestingTable { to, state, meeting }
    GuardSpec { id, name, priority, scale, fires, reads }
    ContactSpec { name, gap, friction }
    FrictionSpec { name, force, slip, slack }
    ContactTable { name, gap, friction }
    ContactModeTable {
        contact, gap, bound, normal, jacobian, balance, slip, slip_bound, limits, response, slopes,
        sounds,
    }
    RestTable { mode, instead, state, is_improved }
    DamperTable { lift, fall, softest_tone }
    MidiTable { speeds, velocity, pressure }
    PressureTable { kind, range }
    DrawingTable { numbers, count, bodies, springs }
    BodyTable { name, output, outlines }
    OutlineTable { material, is_closed, points, modes }
    SpringTable { name, from, to, modes }
}

enumerations! {
    Material { Wood, Felt, Metal, String, Ground, Finger }
    EquationKind { Affine, Linear, Smooth, Conservative, Stiff }
    Fires { WhileNegative, OnCrossing }
    PressureKind { Channel, Key }
    Reads { StateAndInput, State }
}

impl Constant for GuardId {
    fn literal(&self) -> Literal {
        Literal::Word(format!("GuardId({})", self.0))
    }
}

impl Constant for Part {
    /// By its entries: a table's parts have no natures of their own.
    fn literal(&self) -> Literal {
        let entries: Vec<_> = (0..64).filter(|entry| self.has(*entry)).collect();
        let of = if entries.len() == 64 {
            "Part::WHOLE".to_owned()
        } else {
            let entries: Vec<_> = entries.iter().map(ToString::to_string).collect();
            format!("Part::of(&[{}])", entries.join(", "))
        };
        let of_state = if self.reads() == Reads::State { ".of_state()" } else { "" };
        Literal::Word(format!("{of}{of_state}"))
    }
}

macro_rules! words {
    ($($name:ty),+) => {$(
        impl Constant for $name {
            fn literal(&self) -> Literal {
                Literal::Word(self.to_string())
            }
        }
    )+};
}

words!(u8, u16, usize, bool);

impl Constant for u64 {
    /// In groups of hexadecimal digits: such numbers are bits.
    fn literal(&self) -> Literal {
        let digits = format!("{self:x}");
        let short = digits.len() <= 4;
        Literal::Word(if short { format!("0x{digits}") } else { number::hexadecimal(*self) })
    }
}

impl Constant for f64 {
    fn literal(&self) -> Literal {
        Literal::Word(number::literal(*self))
    }
}

impl Constant for &str {
    fn literal(&self) -> Literal {
        Literal::Text((*self).to_owned())
    }
}

impl<T: Constant> Constant for &[T] {
    fn literal(&self) -> Literal {
        Literal::Slice(self.iter().map(Constant::literal).collect())
    }
}

impl<T: Constant> Constant for Option<T> {
    fn literal(&self) -> Literal {
        match self {
            Some(value) => Literal::Some(Box::new(value.literal())),
            None => Literal::Word("None".to_owned()),
        }
    }
}

impl<A: Constant, B: Constant> Constant for (A, B) {
    fn literal(&self) -> Literal {
        Literal::Tuple(vec![self.0.literal(), self.1.literal()])
    }
}

impl<A: Constant, B: Constant, C: Constant> Constant for (A, B, C) {
    fn literal(&self) -> Literal {
        Literal::Tuple(vec![self.0.literal(), self.1.literal(), self.2.literal()])
    }
}
