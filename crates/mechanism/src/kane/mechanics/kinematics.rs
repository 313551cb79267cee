//! Positions and velocities of bodies, and their accelerations at constant speeds.

use super::vector::{Components, FrameVector, Orientations, cross};
use crate::kane::graph::{Graph, Node, Place, Tangent};
use crate::kane::mechanism::Mechanism;

#[derive(Debug)]
pub(super) struct BodyMotion {
    pub(super) position: FrameVector,
    pub(super) velocity: FrameVector,
    /// Angular velocity (rad/s).
    pub(super) rotation: FrameVector,
    /// Accelerations at constant speeds and a constant rate of the input.
    pub(super) acceleration: FrameVector,
    pub(super) angular_acceleration: FrameVector,
}

impl BodyMotion {
    /// Turns position, velocity and acceleration into components along the ground's axes.
    pub(super) fn put_on_ground(&mut self, graph: &mut Graph, axes: &mut Orientations<'_>) {
        for vector in [&mut self.position, &mut self.velocity, &mut self.acceleration] {
            *vector = FrameVector::of(0, axes.express(graph, vector, 0));
        }
    }
}

#[derive(Clone, Debug, Default)]
struct FrameMotion {
    position: FrameVector,
    velocity: FrameVector,
    rotation: FrameVector,
}

/// Returns the direction of the motion at constant speeds and a constant rate of the input.
pub(super) fn along_places(graph: &mut Graph, mechanism: &Mechanism) -> Tangent {
    let coordinates = mechanism.coordinates.iter().enumerate();
    let mut seeds: Vec<_> =
        coordinates.map(|(i, it)| (Place::Coordinate(number(i)), it.rate)).collect();
    seeds.push((Place::Input(0), graph.symbol(Place::Input(1))));
    Tangent::new(seeds)
}

pub(super) fn number(index: usize) -> u16 {
    u16::try_from(index).unwrap_or(u16::MAX)
}

pub(super) fn bodies(
    graph: &mut Graph,
    axes: &mut Orientations<'_>,
    mechanism: &Mechanism,
) -> Vec<BodyMotion> {
    let mut moving = Moving { rates: along_places(graph, mechanism), axes, frames: Vec::new() };
    for frame in 0..mechanism.frames.len() {
        let motion = moving.frame(graph, mechanism, frame);
        moving.frames.push(motion);
    }
    mechanism
        .masses
        .bodies
        .iter()
        .map(|body| {
            let (position, velocity) = moving.point(graph, body.frame, body.centre);
            let rotation = moving.frames[body.frame].rotation.clone();
            let acceleration = moving.derivative(graph, &velocity);
            let angular_acceleration = moving.derivative(graph, &rotation);
            BodyMotion { position, velocity, rotation, acceleration, angular_acceleration }
        })
        .collect()
}

struct Moving<'a, 'b> {
    rates: Tangent,
    axes: &'a mut Orientations<'b>,
    frames: Vec<FrameMotion>,
}

impl Moving<'_, '_> {
    fn frame(&mut self, graph: &mut Graph, mechanism: &Mechanism, frame: usize) -> FrameMotion {
        if frame == 0 {
            return FrameMotion::default();
        }
        let described = &mechanism.frames[frame];
        let (position, velocity) = self.point(graph, described.parent, described.origin);
        let mut rotation = self.frames[described.parent].rotation.clone();
        if let Some((axis, angle)) = described.turn {
            let mut components = [graph.constant(0.0); 3];
            components[axis] = self.rates.of(graph, angle);
            rotation = rotation.plus(graph, &FrameVector::of(described.parent, components));
        }
        FrameMotion { position, velocity, rotation }
    }

    /// Returns position and velocity of a point that may move along the axes of `frame`.
    fn point(
        &mut self,
        graph: &mut Graph,
        frame: usize,
        at: [Option<Node>; 3],
    ) -> (FrameVector, FrameVector) {
        let zero = graph.constant(0.0);
        let at = at.map(|it| it.unwrap_or(zero));
        let offset = FrameVector::of(frame, at);
        let rate = self.derivative(graph, &offset);
        let of = self.frames[frame].clone();
        (of.position.plus(graph, &offset), of.velocity.plus(graph, &rate))
    }

    fn derivative(&mut self, graph: &mut Graph, vector: &FrameVector) -> FrameVector {
        let mut rate = FrameVector::default();
        for (frame, components) in &vector.parts {
            let own = components.map(|component| self.rates.of(graph, component));
            let turned = self.turned(graph, *frame, *components);
            let sum = [0, 1, 2].map(|i| graph.add(own[i], turned[i]));
            rate = rate.plus(graph, &FrameVector::of(*frame, sum));
        }
        rate
    }

    fn turned(&mut self, graph: &mut Graph, frame: usize, components: Components) -> Components {
        let rotation = self.frames[frame].rotation.clone();
        let rotation = self.axes.express(graph, &rotation, frame);
        cross(graph, rotation, components)
    }
}
