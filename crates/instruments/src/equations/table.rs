//! All of a model but its arithmetic: names, sizes, and the number of each function.
//!
//! A table is constant, made once for a description and shared by all that play it. Names and units
//! are `&'static str`, as everywhere in `pode`; prose is owned.
#![expect(clippy::disallowed_types, reason = "a table is made once, off the tick")]

use alloc::boxed::Box;
use alloc::sync::Arc;
use alloc::vec::Vec;

use pode::contacts::ContactSpec;
use pode::{Enclosure, EquationKind, Fires, GuardSpec, Motion, Part, Reads};

/// The number of a function of a model.
pub type FunctionId = u16;

/// What the functions of a model are given.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Arguments<'a> {
    /// The parameters, then what follows from them alone.
    pub constants: &'a [f64],
    pub state: &'a [f64],
    /// The input s and its rates s', s'', s'''.
    pub input: &'a [f64; 4],
    /// What else the function asks for.
    pub extra: &'a [f64],
}

/// The arithmetic of a model: pure functions, by number.
///
/// Each is a straight line of operations, with no loop and no memory of its own.
pub trait Functions: Send + Sync {
    /// Writes the values of `function` to `out`, which has at least as many places; a number that
    /// no function has writes nothing. Where `out` or an argument is shorter than the function
    /// needs, all of `out` becomes NaN.
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]);
}

/// A table and the arithmetic that its numbers are of.
pub trait Equations: Functions {
    /// Returns all of the model but its arithmetic.
    fn table(&self) -> &ModelTable;
}

impl<F: Functions + ?Sized> Functions for &F {
    #[inline]
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        (**self).call(function, arguments, out);
    }
}

impl<E: Equations + ?Sized> Equations for &E {
    #[inline]
    fn table(&self) -> &ModelTable {
        (**self).table()
    }
}

impl<F: Functions + ?Sized> Functions for Arc<F> {
    #[inline]
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        (**self).call(function, arguments, out);
    }
}

impl<E: Equations + ?Sized> Equations for Arc<E> {
    #[inline]
    fn table(&self) -> &ModelTable {
        (**self).table()
    }
}

/// All of a model but its arithmetic.
#[derive(Clone, PartialEq, Debug)]
pub struct ModelTable {
    /// Name in scenes and on the command line.
    pub name: &'static str,
    /// What it is, in one line.
    pub summary: Box<str>,
    pub parameters: Vec<ParameterTable>,
    /// Named values; the first is the default.
    pub presets: Vec<PresetTable>,
    pub states: Vec<NamedQuantity>,
    /// How many leading states are coordinates.
    pub coordinates: usize,
    pub constants: ConstantTable,
    pub input: DriveTable,
    pub modes: Vec<ModeTable>,
    pub contacts: Vec<ContactTable>,
    pub automata: AutomatonTable,
    pub outputs: Vec<NamedQuantity>,
    pub rest: RestTable,
    pub sound: SoundTable,
    pub drawing: DrawingTable,
}

/// The parameters and what follows from them alone.
#[derive(Clone, PartialEq, Debug)]
pub struct ConstantTable {
    /// Number of constants, the parameters included.
    pub count: usize,
    /// Computes the constants behind the parameters from `constants[..parameters.len()]`.
    pub derive: FunctionId,
    /// Conditions under which the values are possible.
    pub requirements: Vec<RequirementTable>,
}

/// What drives a model.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DriveTable {
    pub quantity: NamedQuantity,
    /// Computes the input per metre of key-front travel from the constants.
    pub per_metre: FunctionId,
}

/// A model's contacts and guards as `pode` watches them.
#[derive(Clone, PartialEq, Debug)]
pub struct AutomatonTable {
    pub contacts: Vec<ContactSpec>,
    /// The guards of all modes, each id once, for a model with contacts.
    pub guards: Vec<GuardSpec>,
}

/// What sounds, and what becomes of it in MIDI.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SoundTable {
    pub damper: Option<DamperTable>,
    pub midi: MidiTable,
}

/// A quantity with its name and unit.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NamedQuantity {
    pub name: &'static str,
    /// SI unit; `"1"` for a ratio.
    pub unit: &'static str,
}

/// Whether an output is the pose of a frame that a drawing follows: it is called after it, as
/// `key.angle`.
pub fn is_pose(output: &str) -> bool {
    output.contains('.')
}

/// A parameter with its unit and range.
#[derive(Clone, PartialEq, Debug)]
pub struct ParameterTable {
    pub name: &'static str,
    /// Name for people, on sliders.
    pub title: Box<str>,
    pub unit: &'static str,
    pub range: (f64, f64),
    pub doc: Box<str>,
}

/// A preset: its values come from a function of the key alone (`extra[0]`, 0 to 87).
#[derive(Clone, PartialEq, Debug)]
pub struct PresetTable {
    pub name: &'static str,
    pub doc: Box<str>,
    /// From the key to one value per parameter.
    pub values: FunctionId,
}

/// A condition on the parameters.
#[derive(Clone, PartialEq, Debug)]
pub struct RequirementTable {
    /// As people read it: `string > trip`.
    pub text: Box<str>,
    /// From constants to a number that is positive where it is met.
    pub margin: FunctionId,
}

/// A structural mode: its functions by number, and how it ends.
#[derive(Clone, PartialEq, Debug)]
pub struct ModeTable {
    pub name: &'static str,
    /// To the derivative of the whole state, without contacts.
    pub derivative: FunctionId,
    /// What moves by equations; none in a mode without degrees of freedom.
    pub parts: Vec<PartTable>,
    /// The same parts without natures of their own.
    pub part_list: Vec<Part>,
    pub constraints: ConstraintTable,
    pub forces: ForceTable,
    /// To the derivative's derivative by the state, row by row.
    pub jacobian: FunctionId,
    /// Its Taylor series, where it has one.
    pub series: Option<SeriesTable>,
    /// What its equations are like; the fastest rate is found from the Jacobian at the rest pose.
    pub kind: EquationKind,
    /// From constants to a number that is 0 where these values let nothing be lost: the mode is
    /// conservative then. None where it is so always or never.
    pub loss: Option<FunctionId>,
    /// Whether its fastest rate is that of the state at hand, as of a felt that is pressed.
    pub is_stiffening: bool,
    pub guards: Vec<GuardTable>,
    /// The same guards as they are watched.
    pub guard_specs: Vec<GuardSpec>,
    /// What each contact does here; one that cannot close here has no entry.
    pub contacts: Vec<ContactModeTable>,
    /// Degrees of freedom p, coordinates n and constraints m, in the paper's letters.
    pub freedom: Freedom,
}

/// The functions that keep a state on the constraints of a mode.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ConstraintTable {
    /// Puts the slaved entries of the whole state in place; `None` if nothing is slaved.
    pub slaved: Option<FunctionId>,
    /// Takes one Newton step towards the constraints that are not slaved; behind the state stands
    /// how far each was from zero.
    pub projection: Option<FunctionId>,
    /// Number of constraints of the projection.
    pub projected: usize,
    /// Computes from the constants how far an event may move a coordinate onto the constraints, in
    /// the unit of the coordinate; farther is a fault. `None` allows any distance.
    pub longest_projection: Option<FunctionId>,
}

/// The functions of what a mode is felt and seen by, without contacts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ForceTable {
    pub readout: FunctionId,
    /// Computes the slopes of the readout by the input's position and by its rate, along the
    /// constraints.
    pub slopes: FunctionId,
    /// Computes all outputs of the model.
    pub outputs: FunctionId,
    /// Computes energy (J), supplied and dissipated power (W).
    pub balance: FunctionId,
}

impl ModeTable {
    /// A number that no function has.
    const NO_FUNCTION: FunctionId = FunctionId::MAX;

    /// A mode in which nothing moves and nothing is known.
    pub const NOTHING: Self = Self {
        name: "",
        derivative: Self::NO_FUNCTION,
        parts: Vec::new(),
        part_list: Vec::new(),
        constraints: ConstraintTable {
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
        },
        forces: ForceTable {
            readout: Self::NO_FUNCTION,
            slopes: Self::NO_FUNCTION,
            outputs: Self::NO_FUNCTION,
            balance: Self::NO_FUNCTION,
        },
        jacobian: Self::NO_FUNCTION,
        series: None,
        kind: EquationKind::Smooth,
        loss: None,
        is_stiffening: false,
        guards: Vec::new(),
        guard_specs: Vec::new(),
        contacts: Vec::new(),
        freedom: Freedom { n: 0, m: 0, p: 0 },
    };
}

/// The Taylor series of a mode: two functions, and how many numbers they exchange.
///
/// A lane is a pair of factors whose products are summed up over the orders; the functions give
/// the factors and take the sums.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SeriesTable {
    /// To the outputs where the series begins, and behind them what the steps are given of it.
    ///
    /// The outputs are the derivative of what moves by equations, then what is slaved, guards and
    /// conditions.
    pub start: FunctionId,
    /// From the coefficients of order k of state and input, and in `extra` k, 1/k, what `start` gave
    /// and the lanes' sums: to the outputs' coefficients of order k, the first factors of all
    /// lanes, and the second ones.
    pub step: FunctionId,
    /// The entries of the state that move by equations, as bits.
    pub entries: u64,
    /// How many guards have a series, the first of the mode's list.
    pub guards: usize,
    /// How many values there are at whose zeros the equations change their form.
    pub conditions: usize,
    pub lanes: usize,
    /// How many numbers the steps are given of the start.
    pub carried: usize,
}

/// Degrees of freedom of a mode. `[GC93]` table 1.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Freedom {
    /// Generalised coordinates of its mechanics.
    pub n: u8,
    /// Constraints among these coordinates.
    pub m: u8,
    /// Independent speeds, n − m.
    pub p: u8,
}

/// A part of a mode that moves apart from the others.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PartTable {
    /// Its entries of the state, as bits.
    pub entries: u64,
    /// To the derivative of the whole state, where only its entries count.
    pub derivative: FunctionId,
    pub kind: EquationKind,
    /// As [`ModeTable::loss`], of what is lost by its entries.
    pub loss: Option<FunctionId>,
    pub reads: Reads,
}

/// A guard in one mode.
#[derive(Clone, PartialEq, Debug)]
pub struct GuardTable {
    /// Its number in the model; guards of several modes with one name have one number.
    pub id: u8,
    pub name: &'static str,
    /// SI unit of the guard; `""` where it is not known.
    pub unit: &'static str,
    pub priority: u8,
    pub scale: f64,
    pub fires: Fires,
    pub reads: Reads,
    /// To the guard and its rate.
    pub value: FunctionId,
    /// From an enclosure in `extra` (see [`EnclosureLayout`]) to bounds of its move and bend.
    pub bound: Option<FunctionId>,
    /// Where it leads, the first way whose condition is positive.
    pub ways: Vec<WayTable>,
    /// To the speed of what strikes (m/s), before the reset.
    pub sounds: Option<FunctionId>,
}

/// A way out of a mode.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct WayTable {
    /// To a number that is positive where this way is taken; none is always.
    pub when: Option<FunctionId>,
    /// The number of the next mode.
    pub to: u8,
    /// To the state after it, and behind it the impulse on the input; none keeps the state.
    pub reset: Option<FunctionId>,
    /// Where such impacts come to rest; none where they are no impacts, or never do.
    pub resting: Option<RestingTable>,
}

/// How an impact with a restitution comes to rest.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RestingTable {
    /// The mode in which the surfaces stay together.
    pub to: u8,
    /// To the state in it after an impact without rebound, and behind it the impulse.
    pub state: FunctionId,
    /// To the speed at which the surfaces approach (m/s or rad/s), and the restitution.
    pub meeting: FunctionId,
}

/// A contact or bearing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ContactTable {
    pub name: &'static str,
    /// Typical size of the gap (m); none for a bearing.
    pub gap: Option<f64>,
    /// Name of its friction, and typical sizes of its force (N) and slip speed (m/s).
    pub friction: Option<(&'static str, f64, f64)>,
}

/// A contact in one mode.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ContactModeTable {
    /// Its number in the model.
    pub contact: u8,
    /// To the gap and its rate.
    pub gap: Option<FunctionId>,
    /// From an enclosure to bounds of the gap's move and bend.
    pub bound: Option<FunctionId>,
    /// To what the closed contact adds to the derivative.
    pub normal: Option<FunctionId>,
    /// To what it adds to the derivative's derivative by the state, row by row.
    pub jacobian: Option<FunctionId>,
    /// To what it adds to readout, energy (J), supplied and dissipated power (W).
    pub balance: Option<FunctionId>,
    /// To the slip speed, its rate by time alone, and its gradient by the state.
    pub slip: Option<FunctionId>,
    /// From an enclosure to bounds of the slip speed's move and bend.
    pub slip_bound: Option<FunctionId>,
    /// To stiction and kinetic friction.
    pub limits: Option<FunctionId>,
    /// To what 1 N of friction adds to the derivative, and behind it to the readout.
    pub response: Option<FunctionId>,
    /// To what it adds to the readout's slopes by the input's position and by its rate; none where
    /// its friction is felt at the input.
    pub slopes: Option<FunctionId>,
    /// To the speed of what strikes where it closes (m/s), 0 where it opens.
    pub sounds: Option<FunctionId>,
}

/// Where a model rests.
#[derive(Clone, PartialEq, Debug)]
pub struct RestTable {
    pub mode: u8,
    /// Other modes at rest, each where a function of the constants is positive; the first counts.
    pub instead: Vec<(FunctionId, u8)>,
    /// To the state to start from.
    pub state: FunctionId,
    /// Whether that is improved to the equilibrium.
    pub is_improved: bool,
}

/// A damper that the key lifts, and what sounds at all.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DamperTable {
    /// Key-front travel at which it leaves the string, and at which it is back (m).
    pub lift: f64,
    pub fall: f64,
    /// Speed below which what strikes does not sound (m/s).
    pub softest_tone: f64,
}

/// What becomes of strikes and of the key's force in MIDI.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct MidiTable {
    /// Speeds of a strike that are as soft and as loud as a grand's softest and loudest tone (m/s);
    /// none where what strikes is a hammer as fast as a grand's.
    pub speeds: Option<(f64, f64)>,
    /// The velocity of every note, 1 ..= 127, of an instrument without dynamics.
    pub velocity: Option<u8>,
    /// What is sent while a key is held down.
    pub pressure: Option<PressureTable>,
}

impl MidiTable {
    /// A hammer as fast as a grand's, and no pressure.
    pub const HAMMER: Self = Self { speeds: None, velocity: None, pressure: None };
}

/// Aftertouch: a force on the key as MIDI pressure.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PressureTable {
    pub kind: PressureKind,
    /// Force at which it begins, and at which it is greatest (N).
    pub range: (f64, f64),
}

/// Whom a pressure concerns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PressureKind {
    /// All notes: that of the key that is pressed hardest.
    Channel,
    /// The key's own note.
    Key,
}

/// How a model looks from the side; numbers come from one function of the constants.
#[derive(Clone, PartialEq, Debug)]
pub struct DrawingTable {
    /// To left, bottom, right and top of the view (m), then the coordinates of all points.
    pub numbers: FunctionId,
    /// How many numbers that gives; 0 without a drawing.
    pub count: usize,
    pub bodies: Vec<BodyTable>,
    pub springs: Vec<SpringTable>,
}

/// What is drawn as one: the three outputs from `output` on are its origin (m) and angle (rad).
#[derive(Clone, PartialEq, Debug)]
pub struct BodyTable {
    pub name: &'static str,
    /// Number of the first of its outputs, which others may follow too; none on the ground.
    pub output: Option<usize>,
    pub outlines: Vec<OutlineTable>,
}

/// A line of a body.
#[derive(Clone, PartialEq, Debug)]
pub struct OutlineTable {
    pub material: Material,
    pub is_closed: bool,
    /// Number of its first coordinate among the drawing's numbers, and of its points.
    pub points: (usize, usize),
    /// Modes in which it is shown; all if there are none.
    pub modes: Vec<u8>,
}

/// What a line is made of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Material {
    Wood,
    Felt,
    Metal,
    String,
    /// What does not move.
    Ground,
    Finger,
}

/// A spring between points of two drawn bodies.
#[derive(Clone, PartialEq, Debug)]
pub struct SpringTable {
    pub name: &'static str,
    /// A body, and the number of the point's first coordinate.
    pub from: (usize, usize),
    pub to: (usize, usize),
    pub modes: Vec<u8>,
}

/// Where an enclosure's numbers stand in `extra`.
///
/// The state at the start of the step is the function's state. Its input are the largest
/// magnitudes of the input and its rates over the step; infinite where they are not known.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct EnclosureLayout;

impl EnclosureLayout {
    /// Numbers of each entry of the state.
    pub const STRIDE: usize = 4;

    /// Returns the place of the bound of |x(τ) − x(0)| of an entry.
    pub const fn moves(entry: usize) -> usize {
        Self::STRIDE * entry
    }

    /// Returns the place of the bound of |dx/dτ| of an entry.
    pub const fn speed(entry: usize) -> usize {
        Self::STRIDE * entry + 1
    }

    /// Returns the place of the bound of |d²x/dτ²| of an entry.
    pub const fn bend(entry: usize) -> usize {
        Self::STRIDE * entry + 2
    }

    /// Returns the place of the step's length (s).
    pub const fn step() -> usize {
        3
    }

    /// Returns the place of the input's position at the start of the step, of a state with two
    /// entries or more.
    pub const fn input_start() -> usize {
        Self::STRIDE + 3
    }

    /// Returns the bounds, the length and the input's start as they stand in `extra`.
    #[inline]
    pub fn numbers<const N: usize>(over: &Enclosure<[f64; N], Motion>) -> [[f64; 4]; N] {
        core::array::from_fn(|i| {
            let step = if i == 1 { over.input_start.position } else { over.h };
            [over.moves[i], over.speeds[i], over.bends[i], step]
        })
    }
}
