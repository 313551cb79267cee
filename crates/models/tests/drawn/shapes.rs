//! What the lines of a body come to: circles, and the corners of all else.

use models::draw::Material;

use crate::sketch::play::Moment;
use crate::sketch::{Part, Point};

/// What a body shows of one material.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct PlacedShapes {
    /// Centres and radii.
    circles: Vec<[f64; 3]>,
    corners: Vec<Point>,
}

impl PlacedShapes {
    pub(super) fn of(part: &Part, material: Material, moment: &Moment) -> Self {
        let mut shapes = Self::default();
        for index in part.of(material) {
            let points = part.placed(moment, index);
            match circle(&points) {
                // A lead that is not there has no size.
                Some([_, _, radius]) if radius < 1e-12 => {}
                Some(circle) => shapes.circles.push(circle),
                None => shapes.corners.extend(points),
            }
        }
        shapes
    }

    /// How far the farthest corner or circle is from the nearest of the other, both ways (m).
    pub(super) fn distance(&self, other: &Self) -> f64 {
        let circles = farthest(&self.circles, &other.circles);
        let corners = farthest(&self.corners, &other.corners);
        circles.max(corners)
    }
}

/// Centre and radius of a polygon whose many corners lie on a circle.
fn circle(points: &[Point]) -> Option<[f64; 3]> {
    let count = points.len() as f64;
    let middle = |axis: usize| points.iter().map(|it| it[axis]).sum::<f64>() / count;
    let (x, y) = (middle(0), middle(1));
    let radius = points.iter().map(|it| (it[0] - x).hypot(it[1] - y));
    let (least, most) = radius.fold((f64::INFINITY, 0.0_f64), |(a, b), it| (a.min(it), b.max(it)));
    let is_round = points.len() >= 12 && most - least < 1e-9 * (1.0 + most);
    is_round.then_some([x, y, most])
}

fn farthest<const N: usize>(a: &[[f64; N]], b: &[[f64; N]]) -> f64 {
    let apart = |p: &[f64; N], q: &[f64; N]| {
        p.iter().zip(q).map(|(p, q)| (p - q).powi(2)).sum::<f64>().sqrt()
    };
    let nearest = |p: &[f64; N], all: &[[f64; N]]| {
        all.iter().map(|q| apart(p, q)).fold(f64::INFINITY, f64::min)
    };
    let there = a.iter().map(|p| nearest(p, b));
    let back = b.iter().map(|q| nearest(q, a));
    there.chain(back).fold(0.0, f64::max)
}
