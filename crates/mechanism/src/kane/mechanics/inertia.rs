//! The mass matrix and inertia forces, by partial velocities.
//!
//! The last row and column are those of the input's rate, which is prescribed: its row is the
//! generalised force that drives the input. If coordinates move where all speeds are 0, as clocks
//! do, one more row is that of their motion, and its force times 1 is the power that drives them.

use super::kinematics::{self, BodyMotion, number};
use super::vector::{Components, FrameVector, Orientations, cross};
use crate::kane::graph::{Graph, Node, Place, Substitution, Tangent};
use crate::kane::mechanism::Mechanism;

/// Most frames along whose axes a velocity is a sum. A product of two longer sums has more terms
/// than one along the ground's axes.
const MOST_PARTS: usize = 9;

/// Inertia and weight of all bodies, over all speeds, the input's rate and the clocks, if any.
#[derive(Debug)]
pub(super) struct InertiaTerms {
    pub(super) mass: Vec<Vec<Node>>,
    /// Generalised inertia forces at constant speeds, with the sign of mass × acceleration.
    pub(super) bias: Vec<Node>,
    pub(super) weight: Vec<Node>,
    /// Kinetic energy and that of gravity (J).
    pub(super) energy: Node,
}

pub(super) fn rates(mechanism: &Mechanism) -> Vec<Place> {
    let speeds = (0..mechanism.speeds.len()).map(|j| Place::Speed(number(j)));
    speeds.chain([Place::Input(1)]).collect()
}

/// Returns the slopes of a node that is linear in the speeds and the input's rate.
pub(super) fn gradient(graph: &mut Graph, mechanism: &Mechanism, node: Node) -> Vec<Node> {
    rates(mechanism).into_iter().map(|place| graph.partial(node, place)).collect()
}

/// Returns the value of a rate where the speeds and the input's rate are 0.
pub(super) fn drift(graph: &mut Graph, mechanism: &Mechanism, rate: Node) -> Node {
    let zero = graph.constant(0.0);
    Substitution::new(rates(mechanism).into_iter().map(|place| (place, zero))).of(graph, rate)
}

impl InertiaTerms {
    pub(super) fn of(graph: &mut Graph, mechanism: &Mechanism) -> Self {
        let mut axes = Orientations::new(&mechanism.frames);
        let mut bodies = kinematics::bodies(graph, &mut axes, mechanism);
        let is_long = bodies.iter().any(|it| it.velocity.parts.len() > MOST_PARTS);
        if is_long {
            for motion in &mut bodies {
                motion.put_on_ground(graph, &mut axes);
            }
        }
        let places = rates(mechanism);
        let zero = graph.constant(0.0);
        let has_clocks = mechanism.coordinates.iter().any(|it| {
            let drift = drift(graph, mechanism, it.rate);
            !graph.is_zero(drift)
        });
        let rows = places.len() + usize::from(has_clocks);
        let mut sums = InertiaSums {
            mass: vec![vec![Vec::new(); rows]; rows],
            bias: vec![Vec::new(); rows],
            weight: vec![Vec::new(); rows],
            potential: Vec::new(),
            direct: Vec::new(),
            is_long,
        };
        for (body, motion) in mechanism.masses.bodies.iter().zip(&bodies) {
            let inertia = body.inertia.map(|it| it.unwrap_or(zero));
            let gravity = FrameVector::of(0, mechanism.masses.gravity.map(|it| it.unwrap_or(zero)));
            let one = BodyTerms { frame: body.frame, mass: body.mass, inertia, gravity, motion };
            one.enter(graph, &mut axes, &places, &mut sums);
        }
        sums.finish(graph, mechanism, &bodies)
    }
}

struct InertiaSums {
    mass: Vec<Vec<Vec<(Node, f64)>>>,
    bias: Vec<Vec<(Node, f64)>>,
    weight: Vec<Vec<(Node, f64)>>,
    potential: Vec<(Node, f64)>,
    direct: Vec<(Node, f64)>,
    is_long: bool,
}

struct BodyTerms<'a> {
    frame: usize,
    mass: Node,
    inertia: [Node; 6],
    gravity: FrameVector,
    motion: &'a BodyMotion,
}

struct Partial {
    velocity: FrameVector,
    rotation: Components,
    momentum: Components,
}

impl BodyTerms<'_> {
    fn enter(
        &self,
        graph: &mut Graph,
        axes: &mut Orientations<'_>,
        places: &[Place],
        sums: &mut InertiaSums,
    ) {
        let motion = self.motion;
        let rotation = axes.express(graph, &motion.rotation, self.frame);
        let turning = axes.express(graph, &motion.angular_acceleration, self.frame);
        let mut partials = self.partials(graph, rotation, places);
        if places.len() < sums.bias.len() {
            partials.push(self.drift(graph, rotation, places));
        }
        let momentum = self.times_inertia(graph, rotation);
        let gyroscopic = cross(graph, rotation, momentum);
        let torque = self.times_inertia(graph, turning);
        let torque = [0, 1, 2].map(|i| graph.add(torque[i], gyroscopic[i]));
        for (r, one) in partials.iter().enumerate() {
            for (c, other) in partials.iter().enumerate().take(r + 1) {
                let term = self.pair(graph, axes, one, other);
                sums.enter_mass([r, c], term);
            }
            let inertia = axes.dot(graph, &one.velocity, &motion.acceleration);
            sums.bias[r].push((graph.multiply(self.mass, inertia), 1.0));
            sums.bias[r].push((inner(graph, one.rotation, torque), 1.0));
            let weight = axes.dot(graph, &one.velocity, &self.gravity);
            sums.weight[r].push((graph.multiply(self.mass, weight), 1.0));
        }
        let height = axes.dot(graph, &motion.position, &self.gravity);
        sums.potential.push((graph.multiply(self.mass, height), -1.0));
        let square = axes.dot(graph, &motion.velocity, &motion.velocity);
        sums.direct.push((graph.multiply(self.mass, square), 0.5));
        sums.direct.push((inner(graph, rotation, momentum), 0.5));
    }

    fn partials(&self, graph: &mut Graph, rotation: Components, places: &[Place]) -> Vec<Partial> {
        places
            .iter()
            .map(|place| {
                let mut slope = Tangent::new([(*place, graph.constant(1.0))]);
                let velocity = self.motion.velocity.map(graph, |graph, it| slope.of(graph, it));
                let rotation = rotation.map(|it| slope.of(graph, it));
                let momentum = self.times_inertia(graph, rotation);
                Partial { velocity, rotation, momentum }
            })
            .collect()
    }

    /// Returns the motion where all speeds are 0.
    fn drift(&self, graph: &mut Graph, rotation: Components, places: &[Place]) -> Partial {
        let zero = graph.constant(0.0);
        let mut still = Substitution::new(places.iter().map(|place| (*place, zero)));
        let velocity = self.motion.velocity.map(graph, |graph, it| still.of(graph, it));
        let rotation = rotation.map(|it| still.of(graph, it));
        Partial { velocity, rotation, momentum: self.times_inertia(graph, rotation) }
    }

    fn pair(
        &self,
        graph: &mut Graph,
        axes: &mut Orientations<'_>,
        x: &Partial,
        y: &Partial,
    ) -> Node {
        let product = axes.dot(graph, &x.velocity, &y.velocity);
        // Term by term, so that mass × arm² and an inertia about the centre meet in one sum.
        let moved = times_terms(graph, self.mass, product);
        let turned = inner(graph, x.rotation, y.momentum);
        graph.add(moved, turned)
    }

    fn times_inertia(&self, graph: &mut Graph, rotation: Components) -> Components {
        let [xx, yy, zz, xy, yz, zx] = self.inertia;
        [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]].map(|row| inner(graph, row, rotation))
    }
}

/// Returns the product of `factor` with a sum, multiplied out.
fn times_terms(graph: &mut Graph, factor: Node, sum: Node) -> Node {
    let crate::kane::graph::NodeOperation::Sum(number, terms) = graph.operation(sum).clone() else {
        return graph.multiply(factor, sum);
    };
    let mut products: Vec<_> = terms
        .iter()
        .map(|(term, by)| (graph.multiply(factor, *term), f64::from_bits(*by)))
        .collect();
    products.push((factor, f64::from_bits(number)));
    graph.sum(&products)
}

/// Returns the scalar product of components along common axes; a sum is multiplied out.
fn inner(graph: &mut Graph, x: Components, y: Components) -> Node {
    let terms = [0, 1, 2].map(|i| {
        let is_number = graph.number(x[i]).is_some();
        (if is_number { times_terms(graph, x[i], y[i]) } else { graph.multiply(x[i], y[i]) }, 1.0)
    });
    graph.sum(&terms)
}

impl InertiaSums {
    fn enter_mass(&mut self, [row, column]: [usize; 2], term: Node) {
        self.mass[row][column].push((term, 1.0));
        if row != column {
            self.mass[column][row].push((term, 1.0));
        }
    }

    fn finish(
        self,
        graph: &mut Graph,
        mechanism: &Mechanism,
        bodies: &[BodyMotion],
    ) -> InertiaTerms {
        let mut vector = |rows: Vec<Vec<(Node, f64)>>| -> Vec<Node> {
            rows.iter().map(|terms| graph.sum(terms)).collect()
        };
        let mass: Vec<Vec<Node>> = self.mass.into_iter().map(&mut vector).collect();
        let (bias, weight) = (vector(self.bias), vector(self.weight));
        let kinetic = if self.is_long || has_drift(graph, mechanism, bodies) {
            graph.sum(&self.direct)
        } else {
            half_square(graph, &rates(mechanism), &mass)
        };
        let potential = graph.sum(&self.potential);
        InertiaTerms { energy: graph.add(kinetic, potential), mass, bias, weight }
    }
}

/// Returns ½ Σ M u u.
fn half_square(graph: &mut Graph, places: &[Place], mass: &[Vec<Node>]) -> Node {
    let mut terms = Vec::new();
    for (r, row) in mass.iter().enumerate().take(places.len()) {
        for (c, entry) in row.iter().enumerate().take(r + 1) {
            let (u, v) = (graph.symbol(places[r]), graph.symbol(places[c]));
            let product = graph.product(&[(*entry, 1), (u, 1), (v, 1)]);
            terms.push((product, if r == c { 0.5 } else { 1.0 }));
        }
    }
    graph.sum(&terms)
}

fn has_drift(graph: &mut Graph, mechanism: &Mechanism, bodies: &[BodyMotion]) -> bool {
    let zero = graph.constant(0.0);
    let mut still = Substitution::new(rates(mechanism).into_iter().map(|place| (place, zero)));
    let vectors = bodies.iter().flat_map(|body| [&body.velocity, &body.rotation]);
    let components: Vec<Node> =
        vectors.flat_map(|it| it.parts.values().flatten().copied()).collect();
    components.into_iter().any(|component| {
        let left = still.of(graph, component);
        !graph.is_zero(left)
    })
}
