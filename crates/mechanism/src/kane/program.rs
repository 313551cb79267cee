use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use documents::{Diagnostic, Diagnostics};

use crate::kane::assemble::Program;
use crate::kane::description::{Bases, Description, read};
use crate::kane::mechanics::{DerivationError, DerivationObstacle, derive};
use crate::kane::rest_check;
use crate::kane::system::EquationSystem;

/// Description, its equations, and their program.
#[derive(Clone, Debug)]
pub struct DerivedModel {
    pub description: Description,
    pub system: EquationSystem,
    pub program: Program,
}

/// Reads the description `text`, derives its equations and assembles their program; `name` appears
/// in mistakes and is passed to `bases`.
///
/// # Errors
/// All mistakes of the file; obstacles of all modes; an invalid `[rest]`; more work than
/// [`crate::kane::graph::MAX_WORK`].
pub fn derive_model(
    name: &str,
    text: &str,
    bases: &dyn Bases,
) -> Result<DerivedModel, Diagnostics> {
    derive_unless_cancelled(name, text, bases, &Arc::default())
}

/// Like [`derive_model`], but ends early, with a mistake, once `is_cancelled` is set.
///
/// # Errors
/// Those of [`derive_model`].
#[expect(clippy::large_stack_frames, reason = "once for a description, off the tick")]
pub fn derive_unless_cancelled(
    name: &str,
    text: &str,
    bases: &dyn Bases,
    is_cancelled: &Arc<AtomicBool>,
) -> Result<DerivedModel, Diagnostics> {
    let mut description = read(name, text, bases)?;
    description.mechanism.graph.cancel_by(Arc::clone(is_cancelled));
    let mut system = derive(description.mechanism.clone()).map_err(|errors| {
        Diagnostics::new(errors.iter().map(|it| obstacle(name, text, it)).collect())
    })?;
    let program = system.clone().assemble().map_err(|error| {
        let help = "describe a smaller model, or leave out what it does not need";
        Diagnostics::new(vec![at(name, None, error.to_string(), help)])
    })?;
    if let Some(mistake) =
        rest_check::check(&description.mechanism, &program, &system.state, is_cancelled)
    {
        return Err(Diagnostics::new(vec![mistake]));
    }
    // Printing it later is not limited.
    description.mechanism.graph.lift_limits();
    system.mechanism.graph.lift_limits();
    Ok(DerivedModel { description, system, program })
}

fn obstacle(name: &str, text: &str, error: &DerivationError) -> Diagnostic {
    let line_of = |heading: &str, from: usize| {
        let found = text.lines().skip(from).position(|it| it.trim_start().starts_with(heading));
        found.map(|line| from + line)
    };
    let entry_of = |tables: &[&str], name: &str| {
        let table = |table: &&str| {
            let whole = line_of(&format!("[{table}.{name}]"), 0);
            whole.or_else(|| line_of(&format!("{name} ="), line_of(&format!("[{table}]"), 0)?))
        };
        tables.iter().find_map(table)
    };
    let line = match &error.obstacle {
        DerivationObstacle::DependentConstraints { constraints }
        | DerivationObstacle::SingularConstraints { constraints, .. }
        | DerivationObstacle::ImpossibleSpeeds { constraints, .. } => {
            constraints.last().and_then(|it| entry_of(&["constraints", "contacts"], it))
        }
        DerivationObstacle::Massless { speed } => {
            entry_of(&["coordinates", "speeds"], speed.trim_end_matches('\''))
        }
        DerivationObstacle::CircularSolution { .. }
        | DerivationObstacle::UnmetConstraint { .. }
        | DerivationObstacle::UndeterminedReaction { .. }
        | DerivationObstacle::TooManyInputRates { .. }
        | DerivationObstacle::ImplicitForce { .. }
        | DerivationObstacle::NotInState { .. }
        | DerivationObstacle::GivenUp(_) => None,
    };
    let line = line.or_else(|| line_of(&format!("[modes.{}]", error.mode_name), 0));
    let message = error.to_string();
    match message.split_once("; ") {
        Some((message, help)) => at(name, line, message.to_owned(), help),
        None => at(name, line, message, "change the mode's constraints or bodies"),
    }
}

fn at(name: &str, line: Option<usize>, message: String, help: &str) -> Diagnostic {
    Diagnostic {
        file: name.to_owned(),
        line: line.map(|line| line + 1),
        column: line.map(|_line| 1),
        message,
        help: help.to_owned(),
    }
}
