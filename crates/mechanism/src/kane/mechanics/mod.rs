//! The equations of motion of a mechanism, by Kane's method.
//!
//! Generalised forces and inertia forces are projected on the partial velocities of the bodies'
//! mass centres, F + F* = 0 `[KL85]`. Each mode solves what coordinates and speeds it can from its
//! constraints; reactions are the remainders of the rows of dependent speeds. Where the pivot of
//! dependent speeds sinks within reach, multipliers hold the constraints instead.

mod balance;
mod closing;
mod contact;
mod coordinates;
mod equations;
mod error;
mod explicit;
mod generalised;
mod inertia;
mod kinematics;
mod left_out;
mod linear;
mod mass_factor;
mod mechanical;
mod motion;
mod multipliers;
mod numeric;
mod poses;
mod projection;
mod reset;
mod scales;
mod singular;
mod sinking;
mod speed_checks;
mod speeds;
mod vector;

pub use error::{DerivationError, DerivationObstacle};
pub(in crate::kane) use mechanical::extra;
pub(crate) use poses::turned;

use crate::kane::graph::{Graph, Place};
use crate::kane::mechanism::Mechanism;
use crate::kane::system::EquationSystem;
use equations::ModeScope;
use inertia::InertiaTerms;
use motion::ModeMotion;
pub(in crate::kane) use numeric::NumericPose;

/// Returns the equations of motion of `mechanism` in each of its modes.
///
/// # Errors
/// Every reason for which a mode has none.
pub fn derive(mut mechanism: Mechanism) -> Result<EquationSystem, Vec<DerivationError>> {
    let mut graph = std::mem::take(&mut mechanism.graph);
    poses::add(&mut graph, &mut mechanism);
    let result = derived(&mut graph, mechanism.clone()).or_else(|errors| {
        let Some(gone) = left_out::dependent(&mechanism, &errors) else { return Err(errors) };
        left_out::leave_out(&mut mechanism, &gone);
        derived(&mut graph, mechanism)
    });
    let mut system = result?;
    system.mechanism.graph = graph;
    Ok(system)
}

fn derived(
    graph: &mut Graph,
    mechanism: Mechanism,
) -> Result<EquationSystem, Vec<DerivationError>> {
    let pose = NumericPose::at_rest(graph, &mechanism);
    let inertia = InertiaTerms::of(graph, &mechanism);
    let mut errors = Vec::new();
    let mut motions = Vec::new();
    for (number, mode) in mechanism.modes.iter().enumerate() {
        let obstacles = equations::implicit(graph, &mechanism, mode);
        let motion = if obstacles.is_empty() {
            ModeMotion::of(graph, &pose, &mechanism, &inertia, mode)
        } else {
            Err(obstacles)
        };
        if let Some(end) = graph.given_up() {
            return Err(in_mode(&mechanism, number, vec![DerivationObstacle::GivenUp(end)]));
        }
        match motion {
            Ok(motion) => motions.push(motion),
            Err(obstacles) => errors.extend(in_mode(&mechanism, number, obstacles)),
        }
    }
    if !errors.is_empty() {
        return Err(errors);
    }
    let state = state(graph, &mechanism, &motions);
    let mut modes = Vec::new();
    for number in 0..mechanism.modes.len() {
        let scope = ModeScope {
            mechanism: &mechanism,
            inertia: &inertia,
            motions: &motions,
            number,
            state: &state,
        };
        let equations = scope.equations(graph);
        if let Some(end) = graph.given_up() {
            return Err(in_mode(&mechanism, number, vec![DerivationObstacle::GivenUp(end)]));
        }
        match equations {
            Ok(equations) => modes.push(equations),
            Err(obstacles) => errors.extend(in_mode(&mechanism, number, obstacles)),
        }
    }
    if !errors.is_empty() {
        return Err(errors);
    }
    scales::settle(graph, &mechanism, &mut modes);
    let coordinates = state.iter().filter(|it| matches!(it, Place::Coordinate(_))).count();
    Ok(EquationSystem { mechanism, state, coordinates, modes })
}

fn in_mode(
    mechanism: &Mechanism,
    mode: usize,
    obstacles: Vec<DerivationObstacle>,
) -> Vec<DerivationError> {
    let mode_name = &mechanism.modes[mode].name;
    let error =
        |obstacle| DerivationError { mode: Some(mode), mode_name: mode_name.clone(), obstacle };
    obstacles.into_iter().map(error).collect()
}

/// Returns the entries of the state: coordinates that some mode does not solve, and their speeds.
fn state(graph: &Graph, mechanism: &Mechanism, motions: &[ModeMotion]) -> Vec<Place> {
    let is_solved = |i: usize| motions.iter().all(|motion| motion.solved.contains_key(&i));
    let is_dependent = |j: usize| motions.iter().all(|it| it.speeds.dependent.contains(&j));
    let left_out: Vec<usize> = (0..mechanism.coordinates.len())
        .filter(|i| is_solved(*i))
        .filter_map(|i| coordinates::plain_speed(graph, mechanism, i))
        .filter(|j| is_dependent(*j))
        .collect();
    contact::places(mechanism, |place| {
        let is_left_out = match place {
            Place::Coordinate(i) => is_solved(i.into()),
            Place::Speed(j) => left_out.contains(&j.into()),
            Place::Parameter(_)
            | Place::Acceleration(_)
            | Place::Input(_)
            | Place::Reaction(_)
            | Place::Contact(_)
            | Place::Friction(_)
            | Place::Extra(_)
            | Place::Key => true,
        };
        !is_left_out
    })
}
