//! What was derived: state, equations, guards and reset maps of each mode, as nodes of one graph.
//!
//! Every node is over parameters, coordinates and speeds of the state, and the input; nothing is
//! left of accelerations and reactions. Coordinates that are solved in every mode are no entries
//! of the state.

use crate::kane::graph::{Node, Place};
use crate::kane::mechanism::{Fires, GuardBranch, Mechanism};

/// The equations of a mechanism.
#[derive(Clone, Debug)]
pub struct EquationSystem {
    /// What they were derived from, with the graph of both.
    pub mechanism: Mechanism,
    /// The state: coordinates, then speeds, each by its place.
    pub state: Vec<Place>,
    /// How many leading entries of it are coordinates.
    pub coordinates: usize,
    pub modes: Vec<ModeEquations>,
}

/// The equations of one mode; lists have one entry per entry of the state unless it is said.
#[derive(Clone, Debug, Default)]
pub struct ModeEquations {
    /// The derivative without contacts. An entry that the mode slaves has the rate of what it is
    /// slaved to.
    pub derivative: Vec<Node>,
    /// The entries as the mode puts them in place; the entry itself where it moves by equations.
    pub slaved: Vec<Node>,
    /// Whether it moves by equations.
    pub is_free: Vec<bool>,
    /// One Newton step towards constraints that are not solved in closed form; empty if there are
    /// none.
    pub projection: Vec<Node>,
    /// How far each such constraint is from zero.
    pub drift: Vec<Node>,
    /// What a contact adds to the derivative, by its number in the mechanism, per unit of its
    /// force: normal, and friction.
    pub contacts: Vec<ContactEquations>,
    /// Generalised force on what drives the input, without contacts.
    pub readout: Option<Node>,
    pub outputs: Vec<Node>,
    pub energy: Option<Node>,
    pub supplied: Option<Node>,
    pub dissipated: Option<Node>,
    pub guards: Vec<GuardEquations>,
}

/// A contact in one mode.
#[derive(Clone, Debug)]
pub struct ContactEquations {
    /// Its number in the mechanism.
    pub contact: usize,
    /// Gap and its rate; none for a bearing.
    pub gap: Option<[Node; 2]>,
    /// The normal force while it is closed (N), its energy (J), and the power that it takes (W).
    pub normal: Option<[Node; 3]>,
    /// What 1 N of normal force adds to the derivative, and to the readout.
    pub normal_response: Vec<Node>,
    pub normal_readout: Option<Node>,
    /// Speed of what strikes where it closes (m/s).
    pub sounds: Option<Node>,
    pub friction: Option<FrictionEquations>,
}

/// The friction of a contact in one mode.
#[derive(Clone, Debug)]
pub struct FrictionEquations {
    /// Slip speed, its gradient by the state, and its rate by time alone.
    pub slip: Node,
    pub gradient: Vec<Node>,
    pub drift: Node,
    /// What 1 N in the direction of positive slip adds to the derivative, and to the readout.
    pub response: Vec<Node>,
    pub readout: Node,
    pub stiction: Node,
    pub kinetic: Node,
}

/// A guard in one mode.
#[derive(Clone, Debug)]
pub struct GuardEquations {
    pub name: String,
    /// SI unit of its value; empty where it is not known.
    pub unit: String,
    pub value: Node,
    /// Its rate along the motion.
    pub rate: Node,
    pub scale: f64,
    pub priority: u8,
    pub fires: Fires,
    /// Where it leads, as the description has it, and what follows from it.
    pub ways: Vec<Way>,
    pub sounds: Option<Node>,
}

/// A way out of a mode.
#[derive(Clone, Debug)]
pub struct Way {
    pub branch: GuardBranch,
    /// The state after it.
    pub state: Vec<Node>,
    /// Impulse on what drives the input (readout × s).
    pub impulse: Node,
}
