//! Derived state, equations, guards and reset maps of each mode, as nodes of one graph.
//!
//! Every node is over parameters, coordinates and speeds of the state, and the input; accelerations
//! and reactions are eliminated. Coordinates that are solved in every mode are no entries of the
//! state.

use crate::kane::graph::{Node, Place};
use crate::kane::mechanism::{Fires, GuardBranch, Mechanism};

/// Equations of a mechanism.
#[derive(Clone, Debug)]
pub struct EquationSystem {
    pub mechanism: Mechanism,
    /// State: coordinates, then speeds, each by its place.
    pub state: Vec<Place>,
    /// Number of leading entries that are coordinates.
    pub coordinates: usize,
    pub modes: Vec<ModeEquations>,
}

/// Equations of one mode; lists have one entry per entry of the state unless noted.
#[derive(Clone, Debug, Default)]
pub struct ModeEquations {
    /// Derivative without contacts. An entry that the mode slaves has the rate of its master.
    pub derivative: Vec<Node>,
    /// Derivative between both sides of all switches among the contacts; empty without any.
    pub averaged: Vec<Node>,
    /// Entries as the mode sets them; the entry itself where it moves by equations.
    pub slaved: Vec<Node>,
    /// `true` for entries that move by equations.
    pub is_free: Vec<bool>,
    /// One Newton step towards constraints that are not solved in closed form; may be empty.
    pub projection: Vec<Node>,
    /// Distance of each such constraint from zero, and the rates of those that multipliers hold.
    pub drift: Vec<Node>,
    /// `true` if multipliers hold constraints, whose coordinates and speeds all move by equations.
    pub is_held: bool,
    /// Mass matrix, forces and their slopes; `None` without a mechanical form.
    pub mechanical: Option<MechanicalEquations>,
    /// Contributions of contacts to the derivative per unit of normal force and of friction.
    pub contacts: Vec<ContactEquations>,
    /// Generalised force on the driver of the input, without contacts.
    pub readout: Option<Node>,
    pub outputs: Vec<Node>,
    pub balance: ModeBalance,
    pub guards: Vec<GuardEquations>,
    /// Impacts of the family whose first mode this is.
    pub impacts: Option<ImpactEquations>,
}

/// Energy of a mode (J), and the powers that it receives and loses (W), without contacts.
#[derive(Clone, Copy, Debug, Default)]
pub struct ModeBalance {
    pub energy: Option<Node>,
    pub supplied: Option<Node>,
    pub dissipated: Option<Node>,
}

/// Role of a state's entry in a mechanical form; the numbers count speeds and internal states.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EntryRole {
    /// Coordinate with the rate of this speed.
    Coordinate(usize),
    Speed(usize),
    Internal(usize),
    /// Set by the mode's constraints.
    Slaved,
}

/// Mechanical form of a mode, over the state, the step's length and its accelerations.
#[derive(Clone, Debug)]
pub struct MechanicalEquations {
    /// Role of each entry of the state.
    pub roles: Vec<EntryRole>,
    pub speeds: usize,
    /// Values at the predicted state, see [`MechanicsTable`](instruments::equations::table::MechanicsTable).
    pub values: Vec<Node>,
    /// Element and speed of each stiffness slope.
    pub slopes: Vec<(usize, usize)>,
    pub contacts: Vec<Option<PressedForce>>,
}

impl MechanicalEquations {
    /// Returns the state's entry with this role.
    pub fn entry(&self, role: EntryRole) -> Option<usize> {
        self.roles.iter().position(|it| *it == role)
    }
}

/// Force of a closed contact in a mechanical form.
#[derive(Clone, Debug)]
pub struct PressedForce {
    /// What it adds to forces, stiffness and damping, then its stiffness row.
    pub added: Vec<Node>,
    pub apart: Option<ApartForce>,
}

/// Force on one speed alone, whose mass is coupled to no other.
#[derive(Clone, Debug)]
pub struct ApartForce {
    /// Depth, its slope by the speed, and the speed's mass.
    pub place: [Node; 3],
    /// Force and its slopes by depth and rate, which are the first two numbers in `extra`.
    pub law: [Node; 3],
    pub speed: usize,
}

/// Impacts of a family's rigid contacts, without any of them closed.
#[derive(Clone, Debug)]
pub struct ImpactEquations {
    /// Gaps, their rates, restitution, then the Delassus matrix row by row.
    pub meeting: Vec<Node>,
    /// Change of the state by a unit impulse at each contact, then the impulse on the driver.
    pub responses: Vec<Vec<Node>>,
}

/// Contact in one mode.
#[derive(Clone, Debug)]
pub struct ContactEquations {
    pub contact: usize,
    /// Gap and its rate; `None` for a bearing.
    pub gap: Option<[Node; 2]>,
    /// Normal force while it is closed (N), its energy (J), and the power that it takes (W).
    pub normal: Option<[Node; 3]>,
    /// Contribution of 1 N of normal force; empty for a bearing.
    pub normal_response: ForceResponse,
    /// Speed of the striking part at closing (m/s).
    pub sounds: Option<Node>,
    pub friction: Option<FrictionEquations>,
}

/// Contribution of 1 N (or 1 N·m) of a contact or friction.
#[derive(Clone, Debug, Default)]
pub struct ForceResponse {
    /// To the derivative, entry by entry.
    pub derivative: Vec<Node>,
    /// To the readout; `None` where it is undetermined.
    pub readout: Option<Node>,
    /// To the power of clocks and of surfaces that move by themselves (W).
    pub motor: Option<Node>,
}

/// Friction of a contact in one mode.
#[derive(Clone, Debug)]
pub struct FrictionEquations {
    /// Slip speed, its gradient by the state, and its rate by time alone.
    pub slip: Node,
    pub gradient: Vec<Node>,
    pub drift: Node,
    /// Contribution of 1 N in the direction of positive slip.
    pub response: ForceResponse,
    pub stiction: Node,
    pub kinetic: Node,
    /// As slip, drift and gradient: what a stick keeps at zero instead, of a switch.
    pub kept: Option<Vec<Node>>,
    /// What 1 N of each friction of the mode adds to both, pair by pair; may be empty.
    pub pressed: Vec<Node>,
}

/// Guard in one mode.
#[derive(Clone, Debug)]
pub struct GuardEquations {
    pub name: String,
    /// SI unit of its value; empty if unknown.
    pub unit: String,
    pub value: Node,
    pub rate: Node,
    pub scale: f64,
    pub priority: u8,
    pub fires: Fires,
    /// What 1 N of each friction of the mode adds to the value; may be empty.
    pub pressed: Vec<Node>,
    /// Contact of the mode's family that closes here.
    pub closes: Option<u8>,
    /// Targets in the order of the description, with their reset maps.
    pub ways: Vec<Way>,
    pub sounds: Option<Node>,
}

/// Branch of a guard into another mode.
#[derive(Clone, Debug)]
pub struct Way {
    pub branch: GuardBranch,
    pub state: Vec<Node>,
    /// Impulse on the driver of the input (readout × s).
    pub impulse: Node,
    /// Number in the next mode of the guard of a contact that opens here by its own reaction.
    pub releases: Option<usize>,
}
