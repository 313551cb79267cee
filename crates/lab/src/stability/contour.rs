//! Zero lines of a function of two variables, joined from square to square.

pub(super) type MapPlace = (f64, f64);

/// Squares along each side.
const SQUARES: usize = 96;

/// Returns the lines in the unit square on which `margin` is zero. In each square of a grid the
/// zeros on the edges are joined; neighbours share the zero on their common edge bit for bit.
pub(super) fn zero_lines(margin: &dyn Fn(MapPlace) -> f64) -> Vec<Vec<MapPlace>> {
    let at = |place: usize| place as f64 / SQUARES as f64;
    let row = |y: usize| (0..=SQUARES).map(|x| margin((at(x), at(y)))).collect::<Vec<_>>();
    let mut pieces = Vec::new();
    let mut below = row(0);
    for y in 0..SQUARES {
        let above = row(y + 1);
        for x in 0..SQUARES {
            let corners = [
                ((at(x), at(y)), below[x]),
                ((at(x + 1), at(y)), below[x + 1]),
                ((at(x + 1), at(y + 1)), above[x + 1]),
                ((at(x), at(y + 1)), above[x]),
            ];
            pieces.extend(pieces_of(&corners));
        }
        below = above;
    }
    joined(pieces)
}

fn pieces_of(corners: &[(MapPlace, f64); 4]) -> Vec<[MapPlace; 2]> {
    let edges = (0..4).filter_map(|it| zero(corners[it], corners[(it + 1) % 4]));
    let zeros: Vec<_> = edges.collect();
    match *zeros.as_slice() {
        [a, b] => vec![[a, b]],
        [a, b, c, d] => vec![[a, b], [c, d]],
        _ => Vec::new(),
    }
}

fn zero(a: (MapPlace, f64), b: (MapPlace, f64)) -> Option<MapPlace> {
    // The order must not depend on the square.
    let (a, b) = if a.0 < b.0 { (a, b) } else { (b, a) };
    let differ = (a.1 > 0.0) != (b.1 > 0.0);
    let share = if (a.1 - b.1).is_finite() { a.1 / (a.1 - b.1) } else { 0.5 };
    let between = |from: f64, to: f64| from + share * (to - from);
    differ.then(|| (between(a.0.0, b.0.0), between(a.0.1, b.0.1)))
}

fn joined(mut pieces: Vec<[MapPlace; 2]>) -> Vec<Vec<MapPlace>> {
    let mut lines = Vec::new();
    while let Some([a, b]) = pieces.pop() {
        let mut line = vec![a, b];
        for _end in 0..2 {
            while let Some(next) = line.last().and_then(|end| take_from(&mut pieces, *end)) {
                line.push(next);
            }
            line.reverse();
        }
        lines.push(line);
    }
    lines
}

fn take_from(pieces: &mut Vec<[MapPlace; 2]>, end: MapPlace) -> Option<MapPlace> {
    let found = pieces.iter().position(|it| it.contains(&end))?;
    let [a, b] = pieces.swap_remove(found);
    Some(if a == end { b } else { a })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_is_one_closed_line_of_its_radius() {
        let lines = zero_lines(&|(x, y)| 0.3 - (x - 0.5).hypot(y - 0.5));
        assert_eq!(lines.len(), 1);
        let line = &lines[0];
        assert_eq!(line.first(), line.last());
        for (x, y) in line {
            // The function is a cone, bent across an edge by 1 / radius times its square over 8.
            let error = (x - 0.5).hypot(y - 0.5) - 0.3;
            assert!(error.abs() < 1.0 / 0.3 / 8.0 / (SQUARES * SQUARES) as f64, "{error}");
        }
    }

    #[test]
    fn two_branches_are_two_lines_and_nothing_is_none() {
        let lines = zero_lines(&|(x, _)| (x - 0.305).abs() - 0.1);
        assert_eq!(lines.len(), 2);
        assert!(zero_lines(&|_| 1.0).is_empty());
    }

    #[test]
    fn a_margin_that_is_infinite_on_one_side_has_its_line_between() {
        let lines = zero_lines(&|(x, _)| if x < 0.5 { 1.0 } else { f64::NEG_INFINITY });
        assert!(lines.len() == 1 && lines[0].iter().all(|it| (it.0 - 0.5).abs() < 0.02));
    }
}
