//! Triangles that fill an outline of any shape, by cutting its ears.
//!
//! An ear is a corner whose two neighbours see each other through the outline's inside; every
//! simple outline has one. Outlines from outside may cross or touch themselves, or have no area:
//! they are filled as well as possible in a bounded number of steps. The available library indexes
//! unchecked, which is too much trust for network data.

/// Most points of a filled outline: the work grows faster than their number.
const MOST: usize = 256;

pub(crate) type ScreenPoint = [f64; 2];

/// Returns `true` if an outline always turns the same way, once around.
pub(crate) fn is_convex(points: &[ScreenPoint]) -> bool {
    let all: Vec<usize> = (0..points.len()).collect();
    let turns = (0..all.len()).map(|at| turn(points, around(&all, at)));
    let (left, right) =
        turns.fold((false, false), |(left, right), turn| (left || 0.0 < turn, right || turn < 0.0));
    // A star also turns one way only, but reverses more than twice along an axis.
    !(left && right) && (0..2).all(|axis| reversals(points, axis) <= 2)
}

fn reversals(points: &[ScreenPoint], axis: usize) -> usize {
    let next = points.iter().cycle().skip(1);
    let steps = points.iter().zip(next).map(|(from, to)| to[axis] - from[axis]);
    let goes_up: Vec<bool> = steps.filter(|step| *step != 0.0).map(|step| 0.0 < step).collect();
    let next = goes_up.iter().cycle().skip(1);
    goes_up.iter().zip(next).filter(|(a, b)| a != b).count()
}

/// Returns triangles that fill an outline, as indices into `points`.
pub(crate) fn triangles(points: &[ScreenPoint]) -> Vec<[usize; 3]> {
    if MOST < points.len() || !points.iter().flatten().all(|it| it.is_finite()) {
        return Vec::new();
    }
    let mut left: Vec<usize> = (0..points.len()).collect();
    if doubled_area(points) < 0.0 {
        left.reverse();
    }
    let mut triangles = Vec::with_capacity(points.len().saturating_sub(2));
    while 3 <= left.len() {
        let at = corner(points, &left);
        let cut = around(&left, at);
        if 0.0 < turn(points, cut) {
            triangles.push(cut);
        }
        left.remove(at);
    }
    triangles
}

/// Returns the corner to cut: one without area, on an edge or at the end of a spike, else an ear,
/// else any that points outwards.
fn corner(points: &[ScreenPoint], left: &[usize]) -> usize {
    let turn = |at: usize| turn(points, around(left, at));
    let all = 0..left.len();
    let flat = all.clone().find(|at| turn(*at).abs() <= f64::MIN_POSITIVE);
    let ear = || all.clone().find(|at| is_ear(points, left, *at));
    let outward = || all.clone().find(|at| 0.0 < turn(*at));
    flat.or_else(ear).or_else(outward).unwrap_or(0)
}

/// Returns `true` for an outward corner whose triangle contains nothing else of the outline.
fn is_ear(points: &[ScreenPoint], left: &[usize], at: usize) -> bool {
    let cut = around(left, at);
    0.0 < turn(points, cut) && !(0..left.len()).any(|other| is_in_way(points, left, cut, other))
}

/// Returns `true` if the outline enters the triangle at its point `other`.
fn is_in_way(points: &[ScreenPoint], left: &[usize], cut: [usize; 3], other: usize) -> bool {
    let [before, here, after] = around(left, other);
    let is_here = |corner: &usize| distance(points[*corner], points[here]) <= 0.0;
    match cut.iter().position(is_here) {
        None => is_within(points, cut, here),
        // The outline touches itself at a corner of the triangle and may enter there.
        Some(corner) if cut[corner] != here => {
            let cut = [cut[corner], cut[(corner + 1) % 3], cut[(corner + 2) % 3]];
            leads_into(points, cut, before) || leads_into(points, cut, after)
        }
        Some(_) => false,
    }
}

/// Returns `true` if the path from a triangle's first corner to `other` begins in the triangle.
fn leads_into(points: &[ScreenPoint], [corner, next, last]: [usize; 3], other: usize) -> bool {
    0.0 < turn(points, [corner, next, other]) && 0.0 < turn(points, [corner, other, last])
}

fn around(left: &[usize], at: usize) -> [usize; 3] {
    let of = left.len();
    [left[(at + of - 1) % of], left[at], left[(at + 1) % of]]
}

fn distance(a: ScreenPoint, b: ScreenPoint) -> f64 {
    (a[0] - b[0]).abs() + (a[1] - b[1]).abs()
}

/// Returns twice the area of a triangle; positive if anticlockwise.
fn turn(points: &[ScreenPoint], [a, b, c]: [usize; 3]) -> f64 {
    let [a, b, c] = [points[a], points[b], points[c]];
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Returns `true` if a point is in an anticlockwise triangle, or on its edge.
fn is_within(points: &[ScreenPoint], [a, b, c]: [usize; 3], other: usize) -> bool {
    [[a, b], [b, c], [c, a]].into_iter().all(|[from, to]| 0.0 <= turn(points, [from, to, other]))
}

/// Returns twice the area of an outline; positive if anticlockwise.
fn doubled_area(points: &[ScreenPoint]) -> f64 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(points: &[ScreenPoint]) {
        let mut turned: Vec<ScreenPoint> = points.to_vec();
        for _ in 0..points.len() {
            turned.rotate_left(1);
            check_as_given(&turned);
            check_as_given(&turned.iter().rev().copied().collect::<Vec<_>>());
        }
    }

    #[track_caller]
    fn check_as_given(points: &[ScreenPoint]) {
        let triangles = triangles(points);
        let filled: f64 = triangles.iter().map(|cut| turn(points, *cut)).map(f64::abs).sum();
        let area = doubled_area(points).abs();
        assert!((filled - area).abs() <= 1e-9 * area, "{filled} for {area}: {triangles:?}");
    }

    #[test]
    fn concave_outlines_are_filled_and_nothing_beside_them() {
        let hook = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
        let comb = [
            [0.0, 0.0],
            [7.0, 0.0],
            [7.0, 4.0],
            [6.0, 4.0],
            [5.0, 1.0],
            [4.0, 4.0],
            [3.0, 1.0],
            [2.0, 4.0],
            [1.0, 1.0],
            [0.0, 4.0],
        ];
        let arrow = [[0.0, 0.0], [2.0, 2.0], [0.0, 4.0], [1.0, 2.0]];
        for outline in [&hook[..], &comb, &arrow] {
            check(outline);
            assert!(!is_convex(outline));
        }
    }

    #[test]
    fn points_on_an_edge_change_nothing() {
        check(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 1.0], [0.0, 2.0]]);
        check(&[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [2.0, 1.0], [1.0, 1.0], [0.0, 1.0]]);
        check(&[[0.0, 0.0], [0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [3.0, 1.0], [0.0, 1.0]]);
    }

    #[test]
    fn an_outline_may_touch_itself() {
        // A frame: around the outside, over a bridge, around the inside, and back.
        check_as_given(&[
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [0.0, 4.0],
            [0.0, 0.0],
            [1.0, 1.0],
            [1.0, 3.0],
            [3.0, 3.0],
            [3.0, 1.0],
            [1.0, 1.0],
        ]);
        check(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [2.0, 3.0], [1.0, 1.0], [0.0, 3.0]]);
    }

    #[test]
    fn what_is_no_outline_is_not_filled() {
        let line = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [3.0, 3.0]];
        let point = [[1.0, 1.0]; 5];
        let foreign = [[0.0, 0.0], [f64::NAN, 1.0], [1.0, f64::INFINITY], [0.0, 1.0]];
        let endless = vec![[0.0, 1.0]; MOST + 1];
        for outline in [&[][..], &line[..1], &line[..2], &line, &point, &foreign, &endless] {
            assert!(triangles(outline).is_empty(), "{outline:?}");
        }
    }

    #[test]
    fn an_outline_that_crosses_itself_ends() {
        let bow = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
        assert!(triangles(&bow).len() <= 2);
        let far = [[-1e300, 0.0], [1e300, 1e300], [0.0, -1e300], [1e300, -1e300], [0.0, 1e300]];
        assert!(triangles(&far).len() <= 3);
        let wild: Vec<ScreenPoint> =
            (0..MOST).map(|i| [((i * 7919) % 1009) as f64, ((i * 104_729) % 997) as f64]).collect();
        assert!(triangles(&wild).len() <= MOST - 2);
    }

    #[test]
    fn only_what_turns_once_around_is_convex() {
        let disc: Vec<ScreenPoint> =
            (0..48).map(|i| (f64::from(i) * 0.1309).sin_cos().into()).collect();
        assert!(is_convex(&disc));
        let star: Vec<ScreenPoint> =
            (0..5).map(|i| (f64::from(i) * 2.5133).sin_cos().into()).collect();
        assert!(!is_convex(&star));
        assert!(is_convex(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0]]));
    }
}
