//! A model without its arithmetic: names, sizes, and the numbers of its functions.
//!
//! A table is constant, built once per description and shared by all its voices. Names and units
//! are `&'static str`, as in `pode`; prose is owned.
#![expect(clippy::disallowed_types, reason = "a table is made once, off the tick")]

use alloc::boxed::Box;
use alloc::sync::Arc;
use alloc::vec::Vec;

use pode::contacts::ContactSpec;
use pode::contacts::restitution::ImpactLaw;
use pode::{Enclosure, EquationKind, Fires, GuardSpec, MAX_SPEEDS, Motion, Part, Reads};

/// Number of a function of a model.
pub type FunctionId = u16;

/// Arguments of a function of a model.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Arguments<'a> {
    /// The parameters, then the constants derived from them.
    pub constants: &'a [f64],
    pub state: &'a [f64],
    /// The input s and its rates s', s'', s'''.
    pub input: &'a [f64; 4],
    pub extra: &'a [f64],
}

/// The arithmetic of a model: pure functions, by number, each without loops and memory.
pub trait Functions: Send + Sync {
    /// Writes the values of `function` to `out`, which may be longer; an unknown number writes
    /// nothing. If `out` or an argument is shorter than required, all of `out` becomes NaN.
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]);
}

/// A table with the arithmetic of its function numbers.
pub trait Equations: Functions {
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

/// A model without its arithmetic.
#[derive(Clone, PartialEq, Debug)]
pub struct ModelTable {
    pub name: &'static str,
    pub summary: Box<str>,
    pub parameters: Vec<ParameterTable>,
    /// Presets; the first is the default.
    pub presets: Vec<PresetTable>,
    pub states: Vec<NamedQuantity>,
    /// Number of leading states that are coordinates.
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

/// The parameters and the constants derived from them.
#[derive(Clone, PartialEq, Debug)]
pub struct ConstantTable {
    /// Number of constants, the parameters included.
    pub count: usize,
    /// Computes the derived constants from `constants[..parameters.len()]`.
    pub derive: FunctionId,
    pub requirements: Vec<RequirementTable>,
}

/// The input of a model.
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
    pub impacts: Vec<ImpactTable>,
}

impl AutomatonTable {
    /// Returns the impacts of the family of a mode.
    pub fn impacts_in(&self, mode: u8) -> Option<&ImpactTable> {
        self.impacts.iter().find(|family| family.members.iter().any(|it| it.0 == mode))
    }
}

/// Impacts of the rigid contacts of a family of modes, which differ by those that are closed.
#[derive(Clone, PartialEq, Debug)]
pub struct ImpactTable {
    pub law: ImpactLaw,
    /// Modes of the family, each with its closed contacts as bits.
    pub members: Vec<(u8, u32)>,
    /// Typical size of the gap of each contact (m or rad).
    pub scales: Vec<f64>,
    /// Computes the gaps of all contacts, then their rates, their restitution, and the Delassus
    /// matrix row by row.
    pub meeting: FunctionId,
    /// Computes, for each contact, the change of the state by a unit impulse, then the impulse on
    /// the input.
    pub responses: Vec<FunctionId>,
}

/// Sound of a model, and its conversion to MIDI.
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

/// Returns `true` if an output is the pose of a drawn frame, such as `key.angle`.
pub fn is_pose(output: &str) -> bool {
    output.contains('.')
}

/// A parameter with its unit and range.
#[derive(Clone, PartialEq, Debug)]
pub struct ParameterTable {
    pub name: &'static str,
    pub title: Box<str>,
    pub unit: &'static str,
    pub range: (f64, f64),
    pub doc: Box<str>,
    pub reading: Reading,
}

/// Display of a parameter to people, as `per·value + offset`, and its step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Reading {
    pub per: f64,
    pub offset: f64,
    /// Step of a hand, in the displayed value; `None` if it follows from unit and size.
    pub step: Option<f64>,
}

impl Default for Reading {
    fn default() -> Self {
        Self { per: 1.0, offset: 0.0, step: None }
    }
}

/// A preset: its values come from a function of the key alone (`extra[0]`, 0 to 87).
#[derive(Clone, PartialEq, Debug)]
pub struct PresetTable {
    pub name: &'static str,
    pub doc: Box<str>,
    pub values: FunctionId,
}

/// A condition on the parameters.
#[derive(Clone, PartialEq, Debug)]
pub struct RequirementTable {
    /// Readable form: `string > trip`.
    pub text: Box<str>,
    /// Computes from the constants a number that is positive if the condition is met.
    pub margin: FunctionId,
}

/// A structural mode: its functions by number, and its guards.
#[derive(Clone, PartialEq, Debug)]
pub struct ModeTable {
    pub name: &'static str,
    /// Computes the derivative of the whole state, without contacts.
    pub derivative: FunctionId,
    /// Entries that move by equations; empty in a mode without degrees of freedom.
    pub parts: Vec<PartTable>,
    /// The same parts without their own natures.
    pub part_list: Vec<Part>,
    pub constraints: ConstraintTable,
    pub forces: ForceTable,
    /// Computes the Jacobian of the derivative by the state, row by row; `None` for a large mode,
    /// whose derivative is differenced instead.
    pub jacobian: Option<FunctionId>,
    pub mechanics: Option<MechanicsTable>,
    /// Kind of the equations; their fastest rate comes from the Jacobian at the rest pose.
    pub kind: EquationKind,
    /// Computes from the constants a number that is 0 if these values lose nothing: the mode is
    /// then conservative. `None` if it always or never is.
    pub loss: Option<FunctionId>,
    /// `true` if the fastest rate depends on the state, as of a felt that is pressed.
    pub is_stiffening: bool,
    pub guards: Vec<GuardTable>,
    pub guard_specs: Vec<GuardSpec>,
    pub contacts: Vec<ContactModeTable>,
    /// Degrees of freedom p, coordinates n and constraints m, in the paper's letters.
    pub freedom: Freedom,
}

/// The functions that keep a state on the constraints of a mode.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ConstraintTable {
    /// Puts the slaved entries of the whole state in place; `None` if nothing is slaved.
    pub slaved: Option<FunctionId>,
    /// Takes one Newton step towards the constraints that are not slaved; the distance of each from
    /// zero follows the state.
    pub projection: Option<FunctionId>,
    /// Number of distances of the projection.
    pub projected: usize,
    /// `true` if multipliers hold constraints between entries that all move by equations.
    pub is_held: bool,
    /// Computes from the constants the distance that an event may move a coordinate onto the
    /// constraints, in its unit; farther is a fault. `None` allows any distance.
    pub longest_projection: Option<FunctionId>,
}

/// The functions of a mode's forces and outputs, without contacts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ForceTable {
    pub readout: FunctionId,
    /// Computes the readout's slopes by the input's position and rate, along the constraints.
    pub slopes: FunctionId,
    pub outputs: FunctionId,
    /// Computes energy (J), supplied and dissipated power (W).
    pub balance: FunctionId,
    /// Computes the derivative between the sides of all switches; `None` without any.
    pub averaged: Option<FunctionId>,
}

impl ModeTable {
    const NO_FUNCTION: FunctionId = FunctionId::MAX;

    pub const NOTHING: Self = Self {
        name: "",
        derivative: Self::NO_FUNCTION,
        parts: Vec::new(),
        part_list: Vec::new(),
        constraints: ConstraintTable {
            slaved: None,
            projection: None,
            projected: 0,
            is_held: false,
            longest_projection: None,
        },
        forces: ForceTable {
            readout: Self::NO_FUNCTION,
            slopes: Self::NO_FUNCTION,
            outputs: Self::NO_FUNCTION,
            balance: Self::NO_FUNCTION,
            averaged: None,
        },
        jacobian: Some(Self::NO_FUNCTION),
        mechanics: None,
        kind: EquationKind::Smooth,
        loss: None,
        is_stiffening: false,
        guards: Vec::new(),
        guard_specs: Vec::new(),
        contacts: Vec::new(),
        freedom: Freedom { n: 0, m: 0, p: 0 },
    };
}

/// The mechanical form of a mode, with numbers in `extra` by [`MechanicsLayout`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MechanicsTable {
    /// Predicts coordinates and speeds at the end of a step from the state at its start.
    pub prediction: FunctionId,
    /// Computes the values at the predicted state: internal states at the step's end, the lower
    /// triangle of M, Q, the lower triangles of K = −∂Q/∂q and D = −∂Q/∂u, and the stiffness rows
    /// ∂f/∂q of the elements.
    pub values: FunctionId,
    /// Computes from the state at the step's start and the values: the state at its end, the terms
    /// of τ, τ² and τ³ of the cubic to it, the accelerations, the error, and error and rate
    /// of the closed contacts.
    pub correction: FunctionId,
    pub speeds: usize,
    pub internal: usize,
    /// The state's entry of each speed.
    pub speed_entries: [u8; MAX_SPEEDS],
}

/// Layout of a mechanical step's numbers in `extra`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MechanicsLayout;

impl MechanicsLayout {
    pub const STEP: usize = 0;
    /// First acceleration.
    pub const ACCELERATION: usize = 1;
    /// First sum of magnitudes of the closed contacts' stiffness rows.
    pub const CONTACTS: usize = Self::ACCELERATION + MAX_SPEEDS;
    /// First value.
    pub const VALUES: usize = Self::CONTACTS + MAX_SPEEDS;
    pub const MAX_VALUES: usize = 160;
    pub const COUNT: usize = Self::VALUES + Self::MAX_VALUES;

    /// Returns the number of entries of a lower triangle of `n` rows.
    pub const fn packed(n: usize) -> usize {
        n * (n + 1) / 2
    }
}

impl MechanicsTable {
    /// Returns the index of the first value that a contact adds: to Q.
    pub const fn first_added(&self) -> usize {
        self.internal + MechanicsLayout::packed(self.speeds)
    }

    /// Returns the number of values that a contact adds: to Q, K and D.
    pub const fn added(&self) -> usize {
        self.speeds + 2 * MechanicsLayout::packed(self.speeds)
    }
}

/// Coordinates n, constraints m and independent speeds p = n − m of a mode. `[GC93]` table 1.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Freedom {
    pub n: u8,
    pub m: u8,
    pub p: u8,
}

/// A part of a mode that moves independently of the others.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PartTable {
    /// Entries of the state, as bits.
    pub entries: u64,
    /// Computes the derivative of the whole state; only the part's entries count.
    pub derivative: FunctionId,
    pub kind: EquationKind,
    /// As [`ModeTable::loss`], for losses of the part's entries.
    pub loss: Option<FunctionId>,
    pub reads: Reads,
}

/// A guard in one mode.
#[derive(Clone, PartialEq, Debug)]
pub struct GuardTable {
    /// Number in the model; guards of several modes with one name share it.
    pub id: u8,
    pub name: &'static str,
    /// SI unit of the guard; `""` if unknown.
    pub unit: &'static str,
    pub priority: u8,
    pub scale: f64,
    pub fires: Fires,
    pub reads: Reads,
    /// Computes the guard and its rate.
    pub value: FunctionId,
    /// Computes bounds of its move and bend from an enclosure in `extra` (see [`EnclosureLayout`]).
    pub bound: Option<FunctionId>,
    /// Contact of the mode's [`ImpactTable`] that closes here; it then replaces the ways out.
    pub closes: Option<u8>,
    /// Computes what 1 N of each friction of the mode adds to the guard; `None` if nothing.
    pub pressed: Option<FunctionId>,
    /// Ways out; the first with a positive condition counts.
    pub ways: Vec<WayTable>,
    /// Computes the speed of the strike (m/s), before the reset.
    pub sounds: Option<FunctionId>,
}

/// A way out of a mode.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct WayTable {
    /// Computes a number that is positive if this way is valid; `None` for always.
    pub when: Option<FunctionId>,
    pub to: u8,
    /// Computes the next state, followed by the impulse on the input; `None` keeps the state.
    pub reset: Option<FunctionId>,
    /// Rest of repeated impacts; `None` if they are no impacts, or never come to rest.
    pub resting: Option<RestingTable>,
    /// Guard of the contact that opens on this way since its force vanished.
    pub releases: Option<u8>,
}

/// The end of impacts with a restitution.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RestingTable {
    /// Mode in which the surfaces stay together.
    pub to: u8,
    /// Computes the state in it after an impact without rebound, followed by the impulse.
    pub state: FunctionId,
    /// Computes the speed at which the surfaces approach (m/s or rad/s), and the restitution.
    pub meeting: FunctionId,
}

/// Maximum number of contacts whose states fit into a [`ModeCode`](crate::ModeCode): 5²⁴ is less
/// than 2⁵⁶. A function can take the sides or the frictions of as many.
pub const MAX_CODED_CONTACTS: usize = 24;

/// A contact or bearing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ContactTable {
    pub name: &'static str,
    /// Typical size of the gap (m); `None` for a bearing.
    pub gap: Option<f64>,
    /// Name of its friction, and typical sizes of its force (N) and slip speed (m/s).
    pub friction: Option<(&'static str, f64, f64)>,
}

/// Functions of the slopes of a contact's force in one mode; `None` for a bearing.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct ContactGradientTable {
    /// Computes its contribution to the Jacobian, row by row.
    pub jacobian: Option<FunctionId>,
    /// Computes the square of its rate (1/s²) and the rate of its loss (1/s), without all else.
    pub rates: Option<FunctionId>,
    /// Computes its contribution to forces, stiffness and damping of the mechanical form, then its
    /// stiffness row.
    pub mechanics: Option<FunctionId>,
    pub apart: Option<ApartTable>,
}

/// A struck contact that presses one speed alone, whose mass is coupled to no other: it can be
/// followed apart from all else.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ApartTable {
    /// Computes the depth (m), its slope by the speed, and the speed's mass.
    pub place: FunctionId,
    /// Computes the force (N), its slope by the depth, and its slope by the depth's rate, from depth
    /// and rate in `extra`.
    pub law: FunctionId,
    /// Number of the speed.
    pub speed: u8,
    /// The state's entry of its coordinate.
    pub coordinate: u8,
}

/// A contact in one mode.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ContactModeTable {
    pub contact: u8,
    /// Computes the gap and its rate.
    pub gap: Option<FunctionId>,
    /// Computes bounds of the gap's move and bend from an enclosure.
    pub bound: Option<FunctionId>,
    /// Computes the contribution of the closed contact to the derivative.
    pub normal: Option<FunctionId>,
    pub gradients: ContactGradientTable,
    /// Computes its contribution to readout, energy (J), supplied and dissipated power (W).
    pub balance: Option<FunctionId>,
    /// Computes the slip speed, its rate by time alone, and its gradient by the state.
    pub slip: Option<FunctionId>,
    /// Computes bounds of the slip speed's move and bend from an enclosure.
    pub slip_bound: Option<FunctionId>,
    /// Computes stiction and kinetic friction.
    pub limits: Option<FunctionId>,
    /// Computes the contribution of 1 N of friction to the derivative, then to the readout, from the
    /// sides of switches (1 or −1, 0 while they stick) in `extra`, by their numbers.
    pub response: Option<FunctionId>,
    /// Computes, as `slip`, what a stick keeps at zero where its force does not change the slip's
    /// rate; `None` if that is the slip itself.
    pub kept: Option<FunctionId>,
    /// `true` if it leaves the Jacobian constant while it is closed, or a switch on one side.
    pub is_linear: bool,
    /// Computes what 1 N of each friction of the mode adds to stiction and kinetic friction, pair
    /// by pair; `None` if nothing.
    pub pressed: Option<FunctionId>,
    /// Computes its part of the readout's slopes; `None` if its friction is felt at the input.
    pub slopes: Option<FunctionId>,
    /// Computes the speed of the strike when it closes (m/s), 0 when it opens.
    pub sounds: Option<FunctionId>,
}

/// Rest of a model.
#[derive(Clone, PartialEq, Debug)]
pub struct RestTable {
    pub mode: u8,
    /// Other modes at rest, each where a function of the constants is positive; the first counts.
    pub instead: Vec<(FunctionId, u8)>,
    pub state: FunctionId,
    /// `true` if the guess is refined to the equilibrium.
    pub is_improved: bool,
}

/// A damper that the key lifts, and the softest tone.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DamperTable {
    /// Key-front travel at which the damper leaves the string, and at which it is back (m).
    pub lift: f64,
    pub fall: f64,
    /// Speed below which a strike does not sound (m/s).
    pub softest_tone: f64,
}

/// Conversion of strikes and of the key's force to MIDI.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct MidiTable {
    /// Strike speeds as soft and loud as a grand's extremes (m/s); `None` for those of a grand.
    pub speeds: Option<(f64, f64)>,
    /// Velocity of every note, 1 ..= 127, of an instrument without dynamics.
    pub velocity: Option<u8>,
    pub pressure: Option<PressureTable>,
}

impl MidiTable {
    pub const HAMMER: Self = Self { speeds: None, velocity: None, pressure: None };
}

/// Aftertouch: a force on the key as MIDI pressure.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PressureTable {
    pub kind: PressureKind,
    /// Forces at which the pressure begins, and at which it is greatest (N).
    pub range: (f64, f64),
}

/// Notes that a pressure concerns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PressureKind {
    /// All notes, with the pressure of the key that is pressed hardest.
    Channel,
    /// The note of the key.
    Key,
}

/// Drawing of a model from the side; one function of the constants computes its numbers.
#[derive(Clone, PartialEq, Debug)]
pub struct DrawingTable {
    /// Computes left, bottom, right and top of the view (m), then the coordinates of all points.
    pub numbers: FunctionId,
    /// Count of numbers; 0 without a drawing.
    pub count: usize,
    pub bodies: Vec<BodyTable>,
    pub springs: Vec<SpringTable>,
}

/// A rigid body: the three outputs from `output` on are its origin (m) and angle (rad).
#[derive(Clone, PartialEq, Debug)]
pub struct BodyTable {
    pub name: &'static str,
    /// Index of its first output, which others may follow too; `None` for the ground.
    pub output: Option<usize>,
    pub outlines: Vec<OutlineTable>,
}

/// A line of a body.
#[derive(Clone, PartialEq, Debug)]
pub struct OutlineTable {
    pub material: Material,
    pub is_closed: bool,
    /// Index of its first coordinate among the drawing's numbers, and number of its points.
    pub points: (usize, usize),
    /// Modes that show the line; empty for all.
    pub modes: Vec<u8>,
}

/// Material of a line.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Material {
    Wood,
    Felt,
    Metal,
    String,
    Ground,
    Finger,
}

/// A spring between points of two drawn bodies.
#[derive(Clone, PartialEq, Debug)]
pub struct SpringTable {
    pub name: &'static str,
    /// A body, and the index of the point's first coordinate.
    pub from: (usize, usize),
    pub to: (usize, usize),
    pub modes: Vec<u8>,
}

/// Layout of an enclosure's numbers in `extra`.
///
/// The function's state is that at the start of the step. Its input contains the largest magnitudes
/// of the input and its rates over the step; infinite if unknown.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct EnclosureLayout;

impl EnclosureLayout {
    /// Count of numbers for each entry of the state.
    pub const STRIDE: usize = 4;

    /// Returns the index of the bound of |x(τ) − x(0)| of an entry.
    pub const fn moves(entry: usize) -> usize {
        Self::STRIDE * entry
    }

    /// Returns the index of the bound of |dx/dτ| of an entry.
    pub const fn speed(entry: usize) -> usize {
        Self::STRIDE * entry + 1
    }

    /// Returns the index of the bound of |d²x/dτ²| of an entry.
    pub const fn bend(entry: usize) -> usize {
        Self::STRIDE * entry + 2
    }

    /// Returns the index of the step's length (s).
    pub const fn step() -> usize {
        3
    }

    /// Returns the index of the input's position at the start; the state has two entries or more.
    pub const fn input_start() -> usize {
        Self::STRIDE + 3
    }

    #[inline]
    pub fn numbers<const N: usize>(over: &Enclosure<[f64; N], Motion>) -> [[f64; 4]; N] {
        core::array::from_fn(|i| {
            let step = if i == 1 { over.input_start.position } else { over.h };
            [over.moves[i], over.speeds[i], over.bends[i], step]
        })
    }
}
