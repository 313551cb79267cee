//! Switches: branches of a mode's equations whose sides differ where their condition is zero.
//!
//! A step that passes such a place with one side's equations is wrong in first order, and a kind
//! that is found from derivatives does not see it. Each condition becomes a bearing beside the modes
//! ([`pode::contacts`]), with the mean of both sides as the derivative and half their difference as
//! the response, so that every method ends a step there. Branches without a jump, such as a felt's
//! corner, become switches only in modes that are linear on each side: a method's order is low there,
//! but their exact flow would be wrong.

use pode::contacts::{MAX_FRICTIONS, SlipKind};

use super::jacobian::StateOfMode;
use super::kinds::{is_linear_in_state, is_of_input, is_of_state};
use crate::kane::graph::{
    BinaryFunction, Graph, Node, NodeOperation, Place, Substitution, Tangent, UnaryFunction,
};
use crate::kane::mechanics::NumericPose;
use crate::kane::mechanism::{DryFriction, Mechanism, MechanismContact};
use crate::kane::system::{ContactEquations, ForceResponse, FrictionEquations, ModeEquations};

/// Adds the switches of all modes, as many as there is room for: jumps first.
pub(super) fn add(
    graph: &mut Graph,
    mechanism: &mut Mechanism,
    state: &[Place],
    modes: &mut [ModeEquations],
) {
    let frictions = mechanism.contacts.iter().filter(|it| it.friction.is_some()).count();
    let room = MAX_FRICTIONS.saturating_sub(frictions);
    let first = mechanism.contacts.len();
    let poses = poses(graph, mechanism);
    for mode in modes {
        let mut rates = mode.derivative.clone();
        let mut chosen = chosen(graph, &poses, state, mode);
        let known = |it: &SwitchSurface, contacts: &[MechanismContact]| {
            let is_its = |contact: &MechanismContact| {
                contact.friction.as_ref().is_some_and(|friction| friction.slip == it.condition)
            };
            contacts.iter().skip(first).position(is_its).map(|at| first + at)
        };
        chosen.retain(|it| {
            let number = known(it, &mechanism.contacts);
            let has_room = number.is_some() || mechanism.contacts.len() - first < room;
            if number.is_none() && has_room {
                let name = format!("switch_{}", mechanism.contacts.len() - first + 1);
                mechanism.contacts.push(contact(graph, name, it));
            }
            has_room
        });
        let mut responses = Vec::new();
        for (at, surface) in chosen.iter().enumerate() {
            let [above, below] = sides(graph, &rates, surface.condition);
            let mut mean = |by: [f64; 2]| -> Vec<Node> {
                let both = above.iter().zip(&below);
                both.map(|(a, b)| graph.sum(&[(*a, by[0]), (*b, by[1])])).collect()
            };
            let response = mean([-0.5, 0.5]);
            rates = mean([0.5, 0.5]);
            let others: Vec<_> = chosen[at + 1..]
                .iter()
                .filter_map(|it| Some((it.condition, known(it, &mechanism.contacts)?)))
                .collect();
            responses.push(by_sides(graph, &response, &others));
        }
        for (surface, response) in chosen.iter().zip(responses) {
            let number = known(surface, &mechanism.contacts).unwrap_or(first);
            let friction = friction(graph, state, surface, (&rates, response));
            mode.contacts.push(equations(number, friction));
        }
        if !chosen.is_empty() {
            mode.averaged = rates;
        }
    }
}

/// A condition and what it does where it is zero.
#[derive(Clone, Copy, PartialEq, Debug)]
struct SwitchSurface {
    condition: Node,
    /// Its typical size.
    scale: f64,
    jumps: bool,
    /// Whether the jump changes the condition's rate.
    turns: bool,
}

/// The switches of a mode, those first on which its motion can slide.
fn chosen(
    graph: &mut Graph,
    poses: &[NumericPose],
    state: &[Place],
    mode: &ModeEquations,
) -> Vec<SwitchSurface> {
    let conditions = conditions(graph, &mode.derivative);
    let surface = |graph: &mut Graph, condition: &Node| {
        surface(graph, poses, state, (&mode.derivative, *condition))
    };
    let mut all: Vec<_> = conditions.iter().map(|it| surface(graph, it)).collect();
    let has_kinks = all.iter().any(|it| !it.jumps);
    let is_linear = |graph: &mut Graph| is_linear_on_each_side(graph, state, mode, &conditions);
    if has_kinks && (all.len() > MAX_FRICTIONS || !is_linear(graph)) {
        all.retain(|it| it.jumps);
    }
    all.sort_by_key(|it| (!it.turns, !it.jumps));
    all
}

fn is_linear_on_each_side(
    graph: &mut Graph,
    state: &[Place],
    mode: &ModeEquations,
    conditions: &[Node],
) -> bool {
    let sides: Vec<_> = conditions.iter().copied().zip(0..).collect();
    let rates = by_sides(graph, &mode.derivative, &sides);
    let state = StateOfMode::new(graph, state, mode);
    is_linear_in_state(graph, &state, &rates)
}

/// The conditions of branches over the state or the input; opposite ones are one.
fn conditions(graph: &mut Graph, nodes: &[Node]) -> Vec<Node> {
    let mut found = Vec::new();
    for node in graph.reached(nodes) {
        let Some((condition, _)) = branch(graph, node) else { continue };
        let opposite = graph.negate(condition);
        let is_known = found.contains(&condition) || found.contains(&opposite);
        if !is_known && (is_of_state(graph, condition) || is_of_input(graph, condition)) {
            found.push(condition);
        }
    }
    found
}

/// Whether `node` is zero on one side of a condition over the state or the input.
pub(in crate::kane) fn stays_at_zero(graph: &mut Graph, node: Node) -> bool {
    let conditions = conditions(graph, &[node]);
    conditions.into_iter().any(|condition| {
        let both = sides(graph, &[node], condition);
        both.iter().flatten().any(|side| graph.is_zero(*side))
    })
}

/// The condition of a branch, and what the branch is above and below its zero.
fn branch(graph: &mut Graph, node: Node) -> Option<(Node, [Node; 2])> {
    match graph.operation(node).clone() {
        NodeOperation::Unary(UnaryFunction::Abs, x) => Some((x, [x, graph.negate(x)])),
        NodeOperation::Unary(UnaryFunction::Sign, x) => {
            Some((x, [1.0, -1.0].map(|side| graph.constant(side))))
        }
        NodeOperation::Binary(BinaryFunction::Max, x, y) => Some((graph.subtract(x, y), [x, y])),
        NodeOperation::Binary(BinaryFunction::Min, x, y) => Some((graph.subtract(x, y), [y, x])),
        NodeOperation::Select([condition, above, below]) => Some((condition, [above, below])),
        NodeOperation::Unary(..)
        | NodeOperation::Binary(..)
        | NodeOperation::Number(_)
        | NodeOperation::Symbol(_)
        | NodeOperation::Sum(..)
        | NodeOperation::Product(_) => None,
    }
}

/// The `nodes` with branches replaced by what `by` makes of a condition and both sides.
fn replaced(
    graph: &mut Graph,
    nodes: &[Node],
    mut by: impl FnMut(&mut Graph, Node, [Node; 2]) -> Option<Node>,
) -> Vec<Node> {
    let mut held = Substitution::new([]);
    for node in graph.reached(nodes) {
        let Some((condition, sides)) = branch(graph, node) else { continue };
        let sides = sides.map(|side| held.of(graph, side));
        if let Some(by) = by(graph, condition, sides) {
            held.set(node, by);
        }
    }
    nodes.iter().map(|node| held.of(graph, *node)).collect()
}

/// The `nodes` with branches by the numbers of their conditions' sides instead.
fn by_sides(graph: &mut Graph, nodes: &[Node], numbers: &[(Node, usize)]) -> Vec<Node> {
    let opposites: Vec<_> = numbers.iter().map(|(it, _)| graph.negate(*it)).collect();
    replaced(graph, nodes, |graph, condition, [above, below]| {
        let of = |it: &(&(Node, usize), &Node)| it.0.0 == condition || *it.1 == condition;
        let (known, opposite) = numbers.iter().zip(&opposites).find(of)?;
        let by = if *opposite == condition { -0.5 } else { 0.5 };
        let side = graph.symbol(Place::Extra(u16::try_from(known.1).unwrap_or(u16::MAX)));
        let difference = graph.subtract(above, below);
        let moved = graph.multiply(side, difference);
        Some(graph.sum(&[(above, 0.5), (below, 0.5), (moved, by)]))
    })
}

/// The `nodes` above and below the zero of `condition`.
pub(super) fn sides(graph: &mut Graph, nodes: &[Node], condition: Node) -> [Vec<Node>; 2] {
    let opposite = graph.negate(condition);
    [true, false].map(|is_above| {
        replaced(graph, nodes, |_, found, [above, below]| {
            let is_turned = found == opposite;
            let side = if is_above == is_turned { below } else { above };
            (is_turned || found == condition).then_some(side)
        })
    })
}

fn surface(
    graph: &mut Graph,
    poses: &[NumericPose],
    state: &[Place],
    (rates, condition): (&[Node], Node),
) -> SwitchSurface {
    /// Fraction of the difference of both sides elsewhere that counts as a jump.
    const JUMP: f64 = 1e-6;
    let [above, below] = sides(graph, rates, condition);
    let differences: Vec<_> =
        above.iter().zip(&below).map(|(a, b)| graph.subtract(*a, *b)).collect();
    let gradient: Vec<_> = state.iter().map(|place| graph.partial(condition, *place)).collect();
    let zeros: Vec<_> = poses.iter().filter_map(|pose| zero(graph, pose, condition)).collect();
    let size = |numbers: &[f64]| numbers.iter().fold(0.0, |most: f64, it| most.max(it.abs()));
    let scale = poses.iter().map(|pose| pose.value(graph, condition).abs()).fold(0.0, f64::max);
    let most = poses.iter().map(|it| size(&it.all(graph, &differences))).fold(0.0, f64::max);
    let (mut jumps, mut turns) = (false, false);
    for pose in &zeros {
        let (slopes, numbers) = (pose.all(graph, &gradient), pose.all(graph, &differences));
        let changes: Vec<_> = slopes.iter().zip(&numbers).map(|(a, b)| a * b).collect();
        let sum = changes.iter().map(|it| it.abs()).sum::<f64>();
        let is_jump = size(&numbers) > JUMP * most;
        jumps |= is_jump;
        turns |= is_jump && changes.iter().sum::<f64>().abs() > JUMP * sum;
    }
    let scale = if scale > 0.0 && scale.is_finite() { scale } else { 1.0 };
    SwitchSurface { condition, scale, jumps, turns }
}

/// The pose nearby at which `condition` is zero; `None` if there is none.
fn zero(graph: &mut Graph, pose: &NumericPose, condition: Node) -> Option<NumericPose> {
    const ROUNDS: usize = 40;
    let mut places = Vec::new();
    for node in graph.reached(&[condition]) {
        if let NodeOperation::Symbol(place) = graph.operation(node) {
            places.push(*place);
        }
    }
    places.retain(|it| matches!(it, Place::Coordinate(_) | Place::Speed(_) | Place::Input(_)));
    let size = pose.value(graph, condition).abs();
    places.into_iter().find_map(|place| {
        let slope = graph.partial(condition, place);
        let mut near = pose.clone();
        for _ in 0..ROUNDS {
            let [value, slope] = near.all(graph, &[condition, slope])[..] else { return None };
            if value.abs() <= 1e-13 * size {
                return Some(near);
            }
            near.set(place, near.get(place) - value / slope);
        }
        None
    })
}

/// Poses all over the ranges, at the default values of the parameters or beside a zero.
fn poses(graph: &Graph, mechanism: &Mechanism) -> Vec<NumericPose> {
    const COUNT: usize = 6;
    let rest = NumericPose::at_rest(graph, mechanism);
    let per_metre = mechanism.input.per_metre.map_or(1.0, |it| rest.value(graph, it));
    let mut drawn = 0.0;
    // Fractional parts of multiples of the golden ratio never coincide.
    let mut within = |(low, high): (f64, f64)| {
        drawn += 1.0;
        let (low, high) =
            if low.is_finite() && high.is_finite() { (low, high) } else { (-1.0, 1.0) };
        low + (high - low) * (0.618_033_988_75_f64 * drawn).fract()
    };
    let mut draw = |_| {
        let mut pose = rest.clone();
        for (number, parameter) in (0..).zip(&mechanism.parameters) {
            if pose.get(Place::Parameter(number)).abs() <= 0.0 {
                pose.set(Place::Parameter(number), within(parameter.range));
            }
        }
        for (number, coordinate) in (0..).zip(&mechanism.coordinates) {
            pose.set(Place::Coordinate(number), within(coordinate.range));
        }
        for (number, speed) in (0..).zip(&mechanism.speeds) {
            pose.set(Place::Speed(number), within(speed.range));
        }
        for (rate, size) in (0..).zip([0.01, 1.0, 100.0]) {
            pose.set(Place::Input(rate), size * per_metre * within((-1.0, 1.0)));
        }
        pose
    };
    (0..COUNT).map(&mut draw).collect()
}

fn contact(graph: &mut Graph, name: String, surface: &SwitchSurface) -> MechanismContact {
    let one = graph.constant(1.0);
    let friction = DryFriction {
        name: name.clone(),
        slip: surface.condition,
        stiction: one,
        kinetic: one,
        scales: (1.0, surface.scale),
        kind: SlipKind::Condition,
    };
    MechanismContact {
        name,
        gap: None,
        scale: 1.0,
        force: None,
        friction: Some(friction),
        sounds: None,
    }
}

fn friction(
    graph: &mut Graph,
    state: &[Place],
    surface: &SwitchSurface,
    (rates, response): (&[Node], Vec<Node>),
) -> FrictionEquations {
    let gradient = |graph: &mut Graph, node: Node| -> Vec<Node> {
        state.iter().map(|place| graph.partial(node, *place)).collect()
    };
    let by_time = |graph: &mut Graph, node: Node| {
        let seeds = (0..3).map(|k| (Place::Input(k), graph.symbol(Place::Input(k + 1))));
        Tangent::new(seeds.collect::<Vec<_>>()).of(graph, node)
    };
    let slopes = gradient(graph, surface.condition);
    let drift = by_time(graph, surface.condition);
    let kept = (!surface.turns).then(|| {
        let along: Vec<_> = slopes.iter().zip(rates).map(|(a, b)| graph.multiply(*a, *b)).collect();
        let terms: Vec<_> = along.iter().chain([&drift]).map(|it| (*it, 1.0)).collect();
        let rate = graph.sum(&terms);
        [vec![rate, by_time(graph, rate)], gradient(graph, rate)].concat()
    });
    let (one, zero) = (graph.constant(1.0), graph.constant(0.0));
    FrictionEquations {
        slip: surface.condition,
        gradient: slopes,
        drift,
        response: ForceResponse { derivative: response, readout: Some(zero), motor: Some(zero) },
        stiction: one,
        kinetic: one,
        pressed: Vec::new(),
        kept,
    }
}

fn equations(contact: usize, friction: FrictionEquations) -> ContactEquations {
    ContactEquations {
        contact,
        gap: None,
        normal: None,
        normal_response: ForceResponse::default(),
        sounds: None,
        friction: Some(friction),
    }
}
