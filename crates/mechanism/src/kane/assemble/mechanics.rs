//! Steps of a mode in mechanical form: prediction, values and correction.
//!
//! The correction is over the values as symbols: what is 0 by structure costs nothing, and modes
//! with the same structure share it.

use instruments::equations::table::{MechanicsLayout as Layout, MechanicsTable};

use super::AssemblyError;
use super::builder::ModeBuilder;
use super::functions::FunctionList;
use crate::expressions::graph::{BinaryFunction, UnaryFunction};
use crate::kane::graph::{Graph, Node, Place};
use crate::kane::mechanics::extra;
use crate::kane::system::{EntryRole, MechanicalEquations, PressedForce};

/// A symmetric matrix by the rows of its lower triangle.
type Triangle = Vec<Vec<Node>>;

pub(super) fn mechanics(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
) -> Result<Option<MechanicsTable>, AssemblyError> {
    let equations = builder.equations;
    let form = equations.mechanical.as_ref().filter(|_| equations.averaged.is_empty());
    let Some(form) = form.filter(|it| it.values.len() <= Layout::MAX_VALUES) else {
        return Ok(None);
    };
    let mut step = StepForm::new(graph, form, builder.context.places);
    let (prediction, correction, internal) = (step.prediction(), step.correction(), step.internal);
    Ok(Some(MechanicsTable {
        prediction: functions.add_whole(graph, "prediction", &prediction)?,
        values: builder.add(graph, functions, "mechanics", &form.values)?,
        correction: functions.add_whole(graph, "correction", &correction)?,
        speeds: form.speeds,
        internal,
        speed_entries: core::array::from_fn(|k| speed_entry(form, k)),
    }))
}

/// Returns the state's entry of a speed; 0 for one that there is not.
fn speed_entry(form: &MechanicalEquations, k: usize) -> u8 {
    let entry = form.entry(EntryRole::Speed(k));
    entry.and_then(|it| u8::try_from(it).ok()).unwrap_or(0)
}

/// A step over its start, its accelerations and its values.
struct StepForm<'a> {
    graph: &'a mut Graph,
    form: &'a MechanicalEquations,
    places: &'a [Place],
    internal: usize,
    /// Values: numbers where they are constant, else symbols.
    values: Vec<Node>,
    h: Node,
    acceleration: Vec<Node>,
}

impl<'a> StepForm<'a> {
    fn new(graph: &'a mut Graph, form: &'a MechanicalEquations, places: &'a [Place]) -> Self {
        let is_internal = |it: &&EntryRole| matches!(it, EntryRole::Internal(_));
        let internal = form.roles.iter().filter(is_internal).count();
        let first = internal + Layout::packed(form.speeds);
        let mut values = Vec::new();
        for (i, value) in form.values.iter().enumerate() {
            let more = i.checked_sub(first);
            let adds = |it: &PressedForce| {
                more.and_then(|at| it.added.get(at)).is_some_and(|node| !graph.is_zero(*node))
            };
            let is_fixed = !form.contacts.iter().flatten().any(adds);
            let is_number = is_fixed && graph.number(*value).is_some();
            let symbol = extra(Layout::VALUES + i);
            values.push(if is_number { *value } else { graph.symbol(symbol) });
        }
        let h = graph.symbol(extra(Layout::STEP));
        let accelerations = 0..form.speeds;
        let acceleration =
            accelerations.map(|k| graph.symbol(extra(Layout::ACCELERATION + k))).collect();
        Self { graph, form, places, internal, values, h, acceleration }
    }

    fn n(&self) -> usize {
        self.form.speeds
    }

    /// Returns the speed `k` at the start.
    fn speed(&mut self, k: usize) -> Node {
        let entry = self.form.entry(EntryRole::Speed(k));
        self.graph.symbol(self.places[entry.unwrap_or_default()])
    }

    /// Returns the state with q + h u + h²/2 a and u + h a.
    fn prediction(&mut self) -> Vec<Node> {
        let mut all = Vec::new();
        for (place, role) in self.places.iter().zip(&self.form.roles) {
            let start = self.graph.symbol(*place);
            all.push(match *role {
                EntryRole::Coordinate(k) => {
                    let [linear, square] = self.way(k);
                    self.graph.sum(&[(start, 1.0), (linear, 1.0), (square, 1.0)])
                }
                EntryRole::Speed(k) => {
                    let more = self.graph.multiply(self.h, self.acceleration[k]);
                    self.graph.add(start, more)
                }
                EntryRole::Internal(_) | EntryRole::Slaved => start,
            });
        }
        all
    }

    /// Returns the rows of a triangle of values that begins at `first`.
    fn triangle(&self, first: usize) -> Triangle {
        let row = |i: usize| {
            let at = first + Layout::packed(i);
            self.values[at..=at + i].to_vec()
        };
        (0..self.n()).map(row).collect()
    }

    /// Returns the sum of `mass` and further triangles times factors.
    fn combined(&mut self, mass: &Triangle, others: &[(Node, &Triangle)]) -> Triangle {
        let mut sum = |i: usize, j: usize| {
            let mut terms = vec![(mass[i][j], 1.0)];
            for (by, other) in others {
                terms.push((self.graph.multiply(*by, other[i][j]), 1.0));
            }
            self.graph.sum(&terms)
        };
        (0..mass.len()).map(|i| (0..=i).map(|j| sum(i, j)).collect()).collect()
    }

    fn correction(&mut self) -> Vec<Node> {
        /// Margin of the stability limit.
        const MARGIN: f64 = 1.1;
        let first = self.internal + Layout::packed(self.n());
        let mass = self.triangle(self.internal);
        let stiffness = self.triangle(first + self.n());
        let damping = self.triangle(first + self.n() + Layout::packed(self.n()));
        let square = self.graph.power(self.h, 2);
        let tested = self.graph.scale(square, -MARGIN / 6.0);
        let mut tested = self.combined(&mass, &[(tested, &stiffness)]);
        let [accurate, quarter] = [1.0 / 12.0, 0.25].map(|beta| self.graph.constant(beta));
        let pivots = self.factored(&mut tested);
        let beta =
            pivots.iter().fold(accurate, |beta, pivot| self.graph.select(*pivot, beta, quarter));
        let weight = self.graph.multiply(beta, square);
        let half = self.graph.scale(self.h, 0.5);
        let mut matrix = self.combined(&mass, &[(half, &damping), (weight, &stiffness)]);
        let pivots = self.factored(&mut matrix);
        let right = self.forces(&mass, first);
        let delta = self.solved(&matrix, &pivots, right);
        let mut all = self.path(&delta, (half, weight));
        for (a, delta) in self.acceleration.clone().into_iter().zip(&delta) {
            all.push(self.graph.add(a, *delta));
        }
        all.push(self.error(&delta, square));
        all.extend(self.pressed(&delta, square, (&mass, &stiffness)));
        all
    }

    /// Returns Q − M a.
    fn forces(&mut self, mass: &Triangle, first: usize) -> Vec<Node> {
        let n = self.n();
        let mut all = Vec::new();
        for i in 0..n {
            let mut terms = vec![(self.values[first + i], 1.0)];
            for j in 0..n {
                let entry = mass[i.max(j)][i.min(j)];
                terms.push((self.graph.multiply(entry, self.acceleration[j]), -1.0));
            }
            all.push(self.graph.sum(&terms));
        }
        all
    }

    /// Factors a matrix in place as L D Lᵀ; returns the pivots.
    fn factored(&mut self, matrix: &mut Triangle) -> Vec<Node> {
        let mut pivots = Vec::new();
        for j in 0..matrix.len() {
            pivots.push(matrix[j][j]);
            let column: Vec<_> = matrix.iter().skip(j).map(|row| row[j]).collect();
            for row in matrix.iter_mut().skip(j + 1) {
                let by = self.graph.divide(row[j], column[0]);
                self.subtract_multiple(&mut row[j + 1..], by, &column[1..]);
                row[j] = by;
            }
        }
        pivots
    }

    fn subtract_multiple(&mut self, row: &mut [Node], by: Node, column: &[Node]) {
        for (entry, upper) in row.iter_mut().zip(column) {
            let less = self.graph.multiply(by, *upper);
            *entry = self.graph.subtract(*entry, less);
        }
    }

    fn solved(&mut self, factors: &Triangle, pivots: &[Node], mut x: Vec<Node>) -> Vec<Node> {
        for i in 0..x.len() {
            for k in 0..i {
                let less = self.graph.multiply(factors[i][k], x[k]);
                x[i] = self.graph.subtract(x[i], less);
            }
        }
        for i in (0..x.len()).rev() {
            x[i] = self.graph.divide(x[i], pivots[i]);
            for k in i + 1..x.len() {
                let less = self.graph.multiply(factors[k][i], x[k]);
                x[i] = self.graph.subtract(x[i], less);
            }
        }
        x
    }

    /// Returns the state at the end, and the cubic to it: a step's prediction and its correction,
    /// `speed` and `place` times `delta`. Internal states move along a line.
    fn path(&mut self, delta: &[Node], (speed, place): (Node, Node)) -> Vec<Node> {
        let zero = self.graph.constant(0.0);
        let (mut ends, mut terms) = (Vec::new(), [Vec::new(), Vec::new(), Vec::new()]);
        for (i, role) in self.form.roles.iter().enumerate() {
            let start = self.graph.symbol(self.places[i]);
            let cubic = match *role {
                EntryRole::Coordinate(k) => {
                    let [linear, square] = self.way(k);
                    [linear, square, self.graph.multiply(place, delta[k])]
                }
                EntryRole::Speed(k) => {
                    let linear = self.graph.multiply(self.h, self.acceleration[k]);
                    [linear, self.graph.multiply(speed, delta[k]), zero]
                }
                EntryRole::Internal(k) => [self.graph.subtract(self.values[k], start), zero, zero],
                EntryRole::Slaved => [zero; 3],
            };
            let sum = [(start, 1.0), (cubic[0], 1.0), (cubic[1], 1.0), (cubic[2], 1.0)];
            ends.push(self.graph.sum(&sum));
            terms.iter_mut().zip(cubic).for_each(|(all, term)| all.push(term));
        }
        ends.into_iter().chain(terms.into_iter().flatten()).collect()
    }

    /// Returns h u and h²/2 a.
    fn way(&mut self, k: usize) -> [Node; 2] {
        let u = self.speed(k);
        let linear = self.graph.multiply(self.h, u);
        let square = self.graph.product(&[(self.h, 2), (self.acceleration[k], 1)]);
        [linear, self.graph.scale(square, 0.5)]
    }

    fn magnitude(&mut self, x: Node) -> Node {
        self.graph.unary(UnaryFunction::Abs, x)
    }

    fn largest(&mut self, all: &[Node]) -> Node {
        let zero = self.graph.constant(0.0);
        let first = all.first().copied().unwrap_or(zero);
        let larger = |most, it: &Node| self.graph.binary(BinaryFunction::Max, most, *it);
        all.iter().skip(1).fold(first, larger)
    }

    /// Returns h²/12 times the largest |∂f/∂q Δ| of the elements.
    fn error(&mut self, delta: &[Node], square: Node) -> Node {
        let first = self.values.len() - self.form.slopes.len();
        let mut forces: Vec<(usize, Vec<(Node, f64)>)> = Vec::new();
        for (at, (element, speed)) in self.form.slopes.iter().enumerate() {
            let term = self.graph.multiply(self.values[first + at], delta[*speed]);
            match forces.last_mut() {
                Some((last, terms)) if last == element => terms.push((term, 1.0)),
                Some(_) | None => forces.push((*element, vec![(term, 1.0)])),
            }
        }
        let mut sizes = Vec::new();
        for (_, terms) in forces {
            let force = self.graph.sum(&terms);
            sizes.push(self.magnitude(force));
        }
        let most = self.largest(&sizes);
        let scaled = self.graph.multiply(square, most);
        self.graph.scale(scaled, 1.0 / 12.0)
    }

    /// Returns the force that the correction moves in closed contacts, and √(max Kᵢᵢ/Mᵢᵢ): the rate
    /// of a contact that is far stiffer than all else.
    fn pressed(
        &mut self,
        delta: &[Node],
        square: Node,
        (mass, stiffness): (&Triangle, &Triangle),
    ) -> Vec<Node> {
        if self.form.contacts.iter().all(Option::is_none) {
            return Vec::new();
        }
        let (mut forces, mut rates) = (Vec::new(), vec![self.graph.constant(1.0)]);
        for (k, delta) in delta.iter().enumerate() {
            let row = self.graph.symbol(extra(Layout::CONTACTS + k));
            let size = self.magnitude(*delta);
            forces.push((self.graph.multiply(row, size), 1.0 / 12.0));
            rates.push(self.graph.divide(stiffness[k][k], mass[k][k]));
        }
        let moved = self.graph.sum(&forces);
        let fastest = self.largest(&rates);
        vec![self.graph.multiply(square, moved), self.graph.sqrt(fastest)]
    }
}
