//! Records what a model draws, and puts it where a moment's signals say.

pub mod play;

use instruments::Playable;
use instruments::draw::{Body, Coil, Ends, Follow, Material, Sketch};
use play::Moment;

pub type Point = [f64; 2];

/// A line of a body, in the body's axes.
#[derive(Clone, Debug)]
pub struct Outline {
    pub material: Material,
    pub points: Vec<Point>,
}

#[derive(Clone, Debug)]
pub struct Part {
    pub name: &'static str,
    pub pose: [Follow; 3],
    pub modes: Vec<u8>,
    pub outlines: Vec<Outline>,
}

impl Part {
    pub fn is_shown(&self, moment: &Moment) -> bool {
        shown(&self.modes, moment)
    }

    pub fn place(&self, moment: &Moment, [px, py]: Point) -> Point {
        let [x, y, angle] = self.pose.map(|it| moment.follow(&it));
        let (sin, cos) = angle.sin_cos();
        [x + px * cos - py * sin, y + px * sin + py * cos]
    }

    pub fn placed(&self, moment: &Moment, outline: usize) -> Vec<Point> {
        let points = &self.outlines[outline].points;
        points.iter().map(|point| self.place(moment, *point)).collect()
    }

    pub fn points(&self, moment: &Moment) -> Vec<Point> {
        (0..self.outlines.len()).flat_map(|outline| self.placed(moment, outline)).collect()
    }

    pub fn of(&self, material: Material) -> Vec<usize> {
        (0..self.outlines.len()).filter(|it| self.outlines[*it].material == material).collect()
    }
}

fn shown(modes: &[u8], moment: &Moment) -> bool {
    modes.is_empty() || modes.iter().any(|mode| usize::from(*mode) == moment.mode)
}

#[derive(Clone, Debug)]
pub struct Spring {
    pub name: &'static str,
    /// Indices of bodies, with points of them.
    pub ends: [(usize, Point); 2],
    pub modes: Vec<u8>,
}

#[derive(Clone, Debug, Default)]
pub struct Drawing {
    /// Left, bottom, right, top (m) of each call.
    pub views: Vec<[f64; 4]>,
    pub parts: Vec<Part>,
    pub springs: Vec<Spring>,
}

impl Drawing {
    pub fn of<M: Playable>(model: &M) -> Self {
        let mut drawing = Self::default();
        model.draw(&mut drawing);
        drawing
    }

    #[track_caller]
    pub fn part(&self, name: &str, moment: &Moment) -> &Part {
        let found = |it: &&Part| it.name == name && it.is_shown(moment);
        self.parts.iter().find(found).expect("a part of that name")
    }

    pub fn coils(&self, moment: &Moment) -> Vec<(&Spring, [Point; 2])> {
        let shown = self.springs.iter().filter(|it| shown(&it.modes, moment));
        shown
            .map(|it| (it, it.ends.map(|(body, point)| self.parts[body].place(moment, point))))
            .collect()
    }
}

impl Sketch for Drawing {
    fn view(&mut self, edges: [f64; 4]) {
        self.views.push(edges);
    }

    fn body(&mut self, body: Body<'_>) {
        let Body { name, x, y, angle, modes } = body;
        let modes = modes.to_vec();
        self.parts.push(Part { name, pose: [x, y, angle], modes, outlines: vec![] });
    }

    fn outline(&mut self, material: Material, points: &[Point], _: Ends) {
        let part = self.parts.last_mut().expect("a body before its lines");
        part.outlines.push(Outline { material, points: points.to_vec() });
    }

    fn coil(&mut self, coil: Coil<'_>) {
        let Coil { name, from, to, modes } = coil;
        let ends = [from, to].map(|(body, point)| (body as usize, point));
        self.springs.push(Spring { name, ends, modes: modes.to_vec() });
    }
}

/// Returns the shortest distance of the edges of two closed lines that do not cross (m).
pub fn distance(a: &[Point], b: &[Point]) -> f64 {
    corners_to_edges(a, b).min(corners_to_edges(b, a))
}

fn corners_to_edges(corners: &[Point], edges: &[Point]) -> f64 {
    let mut least = f64::INFINITY;
    for (i, from) in edges.iter().enumerate() {
        let to = edges[(i + 1) % edges.len()];
        for corner in corners {
            least = least.min(to_edge(*corner, *from, to));
        }
    }
    least
}

fn to_edge(p: Point, a: Point, b: Point) -> f64 {
    let (along, off) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let square = along[0] * along[0] + along[1] * along[1];
    let t = ((off[0] * along[0] + off[1] * along[1]) / square).clamp(0.0, 1.0);
    (off[0] - t * along[0]).hypot(off[1] - t * along[1])
}
