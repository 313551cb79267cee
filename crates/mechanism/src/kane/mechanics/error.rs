use std::fmt;

use crate::kane::graph::WorkEnd;

/// Reason for which a mechanism has no equations of motion, with a remedy.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DerivationError {
    /// Number of the mode; `None` if it concerns them all.
    pub mode: Option<usize>,
    pub mode_name: String,
    pub obstacle: DerivationObstacle,
}

/// Obstacle to the equations of motion; names are those of the description.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum DerivationObstacle {
    /// A speed moves no mass at the rest pose.
    Massless { speed: String },
    /// One constraint follows from the others at the rest pose.
    DependentConstraints { constraints: Vec<String> },
    /// The constraints lose their rank at a pose within the ranges.
    SingularConstraints { constraints: Vec<String>, pose: String },
    /// The stated independent speeds do not determine the others at the rest pose.
    ImpossibleSpeeds { speeds: Vec<String>, constraints: Vec<String> },
    /// The `solved` expressions of these coordinates depend on one another.
    CircularSolution { coordinates: Vec<String> },
    /// The `solved` expressions do not meet a constraint.
    UnmetConstraint { constraint: String },
    /// The equations do not determine a reaction that an expression uses.
    UndeterminedReaction { constraint: String },
    /// An expression needs a rate of the input beyond the third.
    TooManyInputRates { what: String },
    /// A plain equation or a force depends on accelerations or reactions.
    ImplicitForce { what: String },
    /// A reset map sets a quantity outside the state.
    NotInState { guard: String, name: String },
    /// The derivation was given up.
    GivenUp(WorkEnd),
}

impl fmt::Display for DerivationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.mode.is_some() {
            write!(f, "mode {}: ", self.mode_name)?;
        }
        self.obstacle.fmt(f)
    }
}

impl fmt::Display for DerivationObstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Massless { speed } => write!(
                f,
                "at the rest pose nothing with mass moves with {speed}; give a body that it \
                 moves a mass or an inertia, tie it by a constraint, or state it in `solved` or \
                 `equations`"
            ),
            Self::DependentConstraints { constraints } => write!(
                f,
                "at the rest pose the constraints {} depend on one another; leave one of them \
                 out, or take a rest pose where they do not",
                constraints.join(", ")
            ),
            Self::SingularConstraints { constraints, pose } => write!(
                f,
                "at {pose} the rate of {} vanishes, so that it holds nothing there; write it so \
                 that it changes with what it holds, or narrow the ranges",
                constraints.join(", ")
            ),
            Self::ImpossibleSpeeds { speeds, constraints } => write!(
                f,
                "at the rest pose the other speeds do not follow from {} by the constraints {}; \
                 name other speeds in `independent`, or leave it out",
                speeds.join(", "),
                constraints.join(", ")
            ),
            Self::CircularSolution { coordinates } => write!(
                f,
                "the solved coordinates {} are made of one another; write one of them without \
                 the others",
                coordinates.join(", ")
            ),
            Self::UnmetConstraint { constraint } => write!(
                f,
                "what `solved` says does not meet the constraint {constraint}; correct the \
                 expressions, or leave them to the derivation"
            ),
            Self::UndeterminedReaction { constraint } => write!(
                f,
                "the reaction of {constraint} is not determined by the motion; leave out \
                 constraints that follow from others, or state what asks for it"
            ),
            Self::TooManyInputRates { what } => write!(
                f,
                "the rate of {what} would need the fourth rate of the input; put a spring \
                 between the input and what it drives, or state another guard"
            ),
            Self::ImplicitForce { what } => write!(
                f,
                "{what} depends on accelerations or reactions, which follow from it; write it \
                 over coordinates, speeds and the input"
            ),
            Self::NotInState { guard, name } => write!(
                f,
                "the reset map of {guard} sets {name}, which is solved in every mode; set what \
                 it follows from"
            ),
            Self::GivenUp(end) => write!(f, "{end}; describe a smaller model"),
        }
    }
}

impl std::error::Error for DerivationError {}
