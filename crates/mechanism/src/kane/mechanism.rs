//! A description whose names, units and expressions were checked.
//!
//! Expressions are nodes of one graph over [`Place::Parameter`], [`Place::Coordinate`],
//! [`Place::Speed`] and [`Place::Input`]; in modes also over accelerations and reactions, which
//! the derivation replaces by what they are there. All numbers are SI.
//!
//! [`Place::Parameter`]: crate::kane::graph::Place::Parameter
//! [`Place::Coordinate`]: crate::kane::graph::Place::Coordinate
//! [`Place::Speed`]: crate::kane::graph::Place::Speed
//! [`Place::Input`]: crate::kane::graph::Place::Input

pub use instruments::equations::table::{Material, Reading};
pub use pode::Fires;
pub use pode::contacts::SlipKind;
pub use pode::contacts::restitution::ImpactLaw;

use instruments::equations::table::MidiTable;

use crate::kane::graph::{Graph, Node, Place};
use crate::kane::tape::{Argument, ArgumentLayout, Tape, TapeArguments};

/// Most modes of a mechanism, those that rigid contacts make included.
pub const fn most_modes() -> usize {
    instruments::equations::MAX_MODES
}

/// A mechanism, or a system of plain equations, in the modes that it has.
#[derive(Clone, Debug, Default)]
pub struct Mechanism {
    pub graph: Graph,
    pub name: String,
    pub instrument: InstrumentSpec,
    pub parameters: Vec<MechanismParameter>,
    pub input: InputSpec,
    pub coordinates: Vec<Coordinate>,
    pub speeds: Vec<Speed>,
    /// The first is the ground.
    pub frames: Vec<ReferenceFrame>,
    pub masses: Masses,
    pub forces: Vec<Force>,
    pub contacts: Vec<MechanismContact>,
    pub constraints: Vec<Constraint>,
    pub modes: Vec<Mode>,
    pub outputs: Vec<MechanismOutput>,
    pub rest: Rest,
}

impl Mechanism {
    /// Returns the first preset's value of each parameter for `key`; empty without presets.
    pub fn default_values(&self, key: u8) -> Vec<f64> {
        let mut layout = ArgumentLayout::default();
        layout.place(Place::Key, Argument::Extra(0));
        let values = self.instrument.presets.first().map_or(&[][..], |it| &it.values);
        let tape = Tape::lower(&self.graph, &layout, values).unwrap_or_default();
        tape.evaluate(&TapeArguments { extra: &[key.into()], ..TapeArguments::default() })
    }
}

/// The texts, values, sound and looks of the instrument that a mechanism makes.
#[derive(Clone, Debug, Default)]
pub struct InstrumentSpec {
    pub summary: String,
    /// Named values of the parameters; the first is the default.
    pub presets: Vec<MechanismPreset>,
    /// Must be positive, on every key: with what to say if one is not.
    pub requirements: Vec<Requirement>,
    /// Left out configurations of rigid contacts, since their constraints depend on one another.
    pub left_out: Vec<String>,
    pub impacts: RigidImpacts,
    pub sound: Option<StringDamper>,
    pub midi: MidiTable,
    pub drawing: Drawing,
}

/// Impacts of rigid contacts that close together.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct RigidImpacts {
    pub law: ImpactLaw,
    pub families: Vec<ContactFamily>,
}

/// Modes that differ by their closed rigid contacts: the mode without any first.
#[derive(Clone, PartialEq, Debug)]
pub struct ContactFamily {
    /// Modes, each with its closed contacts as bits.
    pub members: Vec<(usize, u32)>,
    /// Number of each contact's constraint, and its restitution.
    pub contacts: Vec<(usize, Node)>,
}

/// The bodies, and their weight.
#[derive(Clone, Debug, Default)]
pub struct Masses {
    pub bodies: Vec<RigidBody>,
    /// Acceleration of free fall in the ground's axes (m/s²).
    pub gravity: [Option<Node>; 3],
}

/// A parameter with its unit and range.
#[derive(Clone, PartialEq, Debug)]
pub struct MechanismParameter {
    pub name: String,
    pub title: String,
    /// SI unit; `"1"` for a ratio.
    pub unit: String,
    pub range: (f64, f64),
    pub doc: String,
    pub reading: Reading,
}

/// A named set of values; each is a formula of the key (`Place::Key`) and of other parameters.
#[derive(Clone, PartialEq, Debug)]
pub struct MechanismPreset {
    pub name: String,
    pub doc: String,
    /// One expression per parameter, of the key alone.
    pub values: Vec<Node>,
}

/// What must be positive for every key.
#[derive(Clone, PartialEq, Debug)]
pub struct Requirement {
    /// As it was written: `string > trip`.
    pub text: String,
    /// Positive where it is met; over the parameters.
    pub margin: Node,
    /// Line and column where it stands.
    pub place: (usize, usize),
}

/// What drives the mechanism.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct InputSpec {
    pub name: String,
    pub unit: String,
    /// Input per metre of key-front travel (unit of the input / m).
    pub per_metre: Option<Node>,
    /// Generalised force on what drives the input, where it is stated; else it is derived.
    pub readout: Option<Node>,
}

/// A coordinate with its unit and range.
#[derive(Clone, PartialEq, Debug)]
pub struct Coordinate {
    pub name: String,
    pub unit: String,
    /// Range of motion, over which bounds and rates are taken.
    pub range: (f64, f64),
    pub rate: Node,
}

/// A generalised speed with its unit and range.
#[derive(Clone, PartialEq, Debug)]
pub struct Speed {
    pub name: String,
    pub unit: String,
    pub range: (f64, f64),
}

/// Axes that move in another frame.
#[derive(Clone, PartialEq, Debug)]
pub struct ReferenceFrame {
    pub name: String,
    /// The frame in which it moves; the ground is its own.
    pub parent: usize,
    /// Where its origin is, in the parent's axes (m); none is 0.
    pub origin: [Option<Node>; 3],
    /// Axis of the parent (0 x, 1 y, 2 z) and angle about it (rad).
    pub turn: Option<(usize, Node)>,
}

/// A rigid body on a frame.
#[derive(Clone, PartialEq, Debug)]
pub struct RigidBody {
    pub name: String,
    pub frame: usize,
    pub mass: Node,
    /// Mass centre in the frame's axes (m); none is 0.
    pub centre: [Option<Node>; 3],
    /// Inertia xx, yy, zz, xy, yz, zx about the mass centre, in frame axes (kg·m²); none is 0.
    pub inertia: [Option<Node>; 6],
}

/// A force along a deformation: its power is −tension × rate of the stretch.
#[derive(Clone, PartialEq, Debug)]
pub struct Force {
    pub name: String,
    /// The deformation (m or rad), over coordinates and input.
    pub stretch: Node,
    /// Its rate, over coordinates, speeds and input.
    pub stretch_rate: Node,
    /// The force that makes the stretch smaller (N or N·m).
    pub tension: Node,
    /// Energy stored (J); what of the tension is not its slope is dissipated.
    pub energy: Node,
    /// The tension over symbols for the stretch and its rate, where it is built as a law of both.
    pub law: Option<Node>,
}

/// A stretch and its rate as symbols.
pub(crate) const STRETCH: [Place; 2] = [Place::Extra(u16::MAX), Place::Extra(u16::MAX - 1)];

/// A compliant contact, or a bearing with friction: an automaton of its own.
#[derive(Clone, PartialEq, Debug)]
pub struct MechanismContact {
    pub name: String,
    /// Positive while apart (m); a bearing has none.
    pub gap: Option<Node>,
    /// Typical size of the gap (m).
    pub scale: f64,
    /// The force while it is closed; its stretch is −gap.
    pub force: Option<Force>,
    pub friction: Option<DryFriction>,
    /// Speed of what strikes where it closes (m/s), over the state.
    pub sounds: Option<Node>,
}

/// Dry friction that sticks.
#[derive(Clone, PartialEq, Debug)]
pub struct DryFriction {
    pub name: String,
    /// Relative speed (m/s or rad/s), linear in the speeds.
    pub slip: Node,
    /// What can hold (N or N·m).
    pub stiction: Node,
    pub kinetic: Node,
    /// Typical sizes of force and slip.
    pub scales: (f64, f64),
    /// Whether the slip is a speed, or the condition of a switch.
    pub kind: SlipKind,
}

/// A condition on the motion.
#[derive(Clone, PartialEq, Debug)]
pub struct Constraint {
    pub name: String,
    pub kind: ConstraintKind,
    /// What stays zero: over coordinates and input, or linear in the speeds.
    pub zero: Node,
    /// Its rate along the motion, linear in the speeds; of a non-holonomic one `zero` itself.
    pub rate: Node,
}

/// What a constraint ties.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ConstraintKind {
    /// It ties places of bodies.
    Holonomic,
    /// It ties speeds only, as rolling does.
    Nonholonomic,
}

/// A structural configuration: what holds and acts, and what ends it.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Mode {
    pub name: String,
    /// Whether rigid contacts made it of another one, whose closed contacts are constraints here.
    pub is_configuration: bool,
    pub constraints: Vec<usize>,
    pub forces: Vec<usize>,
    pub contacts: Vec<usize>,
    /// Coordinates that follow from others and the input in closed form, with their expressions.
    pub solved: Vec<(usize, Node)>,
    /// Speeds that stay independent, where it is stated.
    pub independent: Option<Vec<usize>>,
    /// Rates of speeds by plain equations: these speeds take no part in the mechanics.
    pub equations: Vec<(usize, Node)>,
    /// Energy stored (J) and power dissipated (W) beyond what bodies and forces account for.
    pub energy: Option<Node>,
    pub dissipated: Option<Node>,
    pub readout: Option<Node>,
    /// How far an event may move a coordinate onto the constraints, over the parameters.
    pub longest_projection: Option<Node>,
    pub guards: Vec<Guard>,
}

/// End of a mode.
#[derive(Clone, PartialEq, Debug)]
pub struct Guard {
    /// Its name; guards of several modes with one name are one.
    pub name: String,
    /// SI unit of its value; empty where it is not known.
    pub unit: String,
    /// Positive while the mode is valid.
    pub value: Node,
    /// Typical size of its terms, in its own unit; `None` takes it from the expression.
    pub scale: Option<f64>,
    /// Who goes first when several cross at one instant: the lowest.
    pub priority: u8,
    pub fires: Fires,
    /// Contact of the mode's family that closes here, by the law of the family's impacts.
    pub closes: Option<u8>,
    /// Where it leads: the first branch whose condition is positive, or that has none.
    pub branches: Vec<GuardBranch>,
    /// Speed of what strikes (m/s), before the reset; over the state.
    pub sounds: Option<Node>,
}

/// A way out of a mode.
#[derive(Clone, PartialEq, Debug)]
pub struct GuardBranch {
    /// Positive where this way is taken.
    pub when: Option<Node>,
    pub to: usize,
    /// Coordinates and speeds that the reset map changes, over the state before.
    pub set: Vec<(Target, Node)>,
    /// An impulse along a constraint, from which the speeds follow.
    pub impact: Option<Impact>,
}

/// An entry that a reset map sets.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Target {
    Coordinate(usize),
    Speed(usize),
}

/// A rigid impact: its impulse follows from the mass matrix.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Impact {
    /// The rate at which the surfaces part, linear in the speeds.
    pub separation: Node,
    /// Restitution e of `[Newton]`: separation⁺ = −e separation⁻; 0 is a plastic catch.
    pub restitution: Node,
    /// Mode whose constraints hold in the impact beside those of the mode before; none without.
    pub within: Option<usize>,
    /// The mode in which ever shorter rebounds end, as a ball's do on a floor.
    pub settles: Option<usize>,
}

/// A quantity for files and plots.
#[derive(Clone, PartialEq, Debug)]
pub struct MechanismOutput {
    pub name: String,
    pub unit: String,
    /// Its expression, one per mode.
    pub values: Vec<Node>,
}

/// Rest of the mechanism.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Rest {
    pub mode: usize,
    /// Other modes at rest, the first whose condition on the parameters is positive.
    pub instead: Vec<(Node, usize)>,
    /// A guess of each coordinate, over the parameters and the input; improved to the equilibrium.
    pub coordinates: Vec<Option<Node>>,
    /// Speeds of a start, over the parameters and the input; 0 where none is stated.
    pub speeds: Vec<Option<Node>>,
    /// Whether the guess is what is meant: a ball that starts in the air.
    pub is_start: bool,
    /// File, line and column where it is stated; none without.
    pub place: Option<(String, usize, usize)>,
}

/// When the key lifts a damper, and what sounds at all.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StringDamper {
    /// Key-front travel at which it leaves the string, and at which it is back (m).
    pub lift: f64,
    pub fall: f64,
    /// Speed below which what strikes does not sound (m/s).
    pub softest_tone: f64,
}

/// View of the mechanism from the side.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Drawing {
    /// Left, bottom, right, top (m); over the parameters.
    pub view: Option<[Node; 4]>,
    /// What is drawn moves with these.
    pub frames: Vec<DrawnFrame>,
    /// From the back to the front.
    pub bodies: Vec<DrawnBody>,
    pub springs: Vec<DrawnSpring>,
}

/// A frame that is drawn, which can be another one in each mode.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DrawnFrame {
    pub name: String,
    /// The mechanism's frame in each mode.
    pub frames: Vec<usize>,
}

/// What moves as one, with its lines.
#[derive(Clone, PartialEq, Debug)]
pub struct DrawnBody {
    pub name: String,
    /// Number of its drawn frame; none stands on the ground.
    pub frame: Option<usize>,
    pub outlines: Vec<Outline>,
}

/// A line of a body.
#[derive(Clone, PartialEq, Debug)]
pub struct Outline {
    pub material: Material,
    pub is_closed: bool,
    /// Points in the frame's axes (m), over the parameters.
    pub points: Vec<[Node; 2]>,
    /// Modes in which it is shown; all if there are none.
    pub modes: Vec<usize>,
}

/// A spring between points of two bodies, by the bodies' numbers.
#[derive(Clone, PartialEq, Debug)]
pub struct DrawnSpring {
    pub name: String,
    pub from: (usize, [Node; 2]),
    pub to: (usize, [Node; 2]),
    pub modes: Vec<usize>,
}
