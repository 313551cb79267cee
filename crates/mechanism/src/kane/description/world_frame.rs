use crate::kane::graph::{Graph, Node, UnaryFunction};
use crate::kane::text::Dependence;

#[derive(Clone, Copy, Debug)]
pub(super) struct WorldFrame {
    pub(super) index: usize,
    origin: [Node; 3],
    turn: WorldTurn,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct WorldPoint {
    pub(super) at: [Node; 3],
    /// Dependence: the parameters alone where the point does not move.
    pub(super) reach: Dependence,
}

#[derive(Clone, Copy, Debug)]
enum WorldTurn {
    None,
    /// Rotation about one axis of the ground, by an angle.
    Axis(usize, Node),
    /// Rows of the matrix from the frame's to the ground's axes.
    Matrix([[Node; 3]; 3]),
}

impl WorldFrame {
    pub(super) fn ground(graph: &mut Graph) -> Self {
        let zero = graph.constant(0.0);
        Self { index: 0, origin: [zero; 3], turn: WorldTurn::None }
    }

    pub(super) fn point(&self, graph: &mut Graph, at: [Node; 3]) -> [Node; 3] {
        let turned = self.turn.apply(graph, at);
        [0, 1, 2].map(|axis| graph.add(self.origin[axis], turned[axis]))
    }

    pub(super) fn child(
        &self,
        graph: &mut Graph,
        index: usize,
        at: [Node; 3],
        turn: Option<(usize, Node)>,
    ) -> Self {
        let origin = self.point(graph, at);
        Self { index, origin, turn: self.turn.then(graph, turn) }
    }
}

impl WorldTurn {
    fn apply(self, graph: &mut Graph, at: [Node; 3]) -> [Node; 3] {
        let rows = match self {
            Self::None => return at,
            Self::Axis(axis, angle) => rotation(graph, axis, angle),
            Self::Matrix(rows) => rows,
        };
        rows.map(|row| dot(graph, row, at))
    }

    /// Appends a rotation; angles about one axis are added.
    fn then(self, graph: &mut Graph, turn: Option<(usize, Node)>) -> Self {
        let Some((axis, angle)) = turn else { return self };
        match self {
            Self::None => Self::Axis(axis, angle),
            Self::Axis(before, first) if before == axis => {
                Self::Axis(axis, graph.add(first, angle))
            }
            Self::Axis(before, first) => {
                let rows = rotation(graph, before, first);
                Self::Matrix(product(graph, rows, axis, angle))
            }
            Self::Matrix(rows) => Self::Matrix(product(graph, rows, axis, angle)),
        }
    }
}

fn dot(graph: &mut Graph, a: [Node; 3], b: [Node; 3]) -> Node {
    let terms = [0, 1, 2].map(|i| (graph.multiply(a[i], b[i]), 1.0));
    graph.sum(&terms)
}

fn rotation(graph: &mut Graph, axis: usize, angle: Node) -> [[Node; 3]; 3] {
    let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
    let sine = graph.unary(UnaryFunction::Sin, angle);
    let cosine = graph.unary(UnaryFunction::Cos, angle);
    let minus = graph.negate(sine);
    let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut rows = [[zero; 3]; 3];
    rows[axis % 3][axis % 3] = one;
    rows[first][first] = cosine;
    rows[first][second] = minus;
    rows[second][first] = sine;
    rows[second][second] = cosine;
    rows
}

fn product(graph: &mut Graph, rows: [[Node; 3]; 3], axis: usize, angle: Node) -> [[Node; 3]; 3] {
    let right = rotation(graph, axis, angle);
    rows.map(|row| [0, 1, 2].map(|column| dot(graph, row, [0, 1, 2].map(|k| right[k][column]))))
}
