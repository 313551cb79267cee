//! Build order of dependent items, without recursion, and cycles.

/// Order in which every item follows its needs, and the cycles without an order.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct BuildOrder {
    pub(super) order: Vec<usize>,
    pub(super) circles: Vec<Vec<usize>>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Visit {
    New,
    Open,
    Done,
}

pub(super) fn sorted(needs: &[Vec<usize>]) -> BuildOrder {
    let mut found = BuildOrder::default();
    let mut visits = vec![Visit::New; needs.len()];
    for start in 0..needs.len() {
        if visits.get(start) == Some(&Visit::New) {
            walk(start, needs, &mut visits, &mut found);
        }
    }
    found
}

/// Searches depth first with an explicit stack of items and numbers of visited needs.
fn walk(start: usize, needs: &[Vec<usize>], visits: &mut [Visit], found: &mut BuildOrder) {
    let mut path = vec![(start, 0)];
    mark(visits, start, Visit::Open);
    while let Some((at, seen)) = path.last_mut() {
        let at = *at;
        let Some(next) = needs.get(at).and_then(|all| all.get(*seen)).copied() else {
            mark(visits, at, Visit::Done);
            found.order.push(at);
            path.pop();
            continue;
        };
        *seen += 1;
        match visits.get(next) {
            Some(Visit::New) => {
                mark(visits, next, Visit::Open);
                path.push((next, 0));
            }
            Some(Visit::Open) => {
                let circle = path.iter().map(|(it, _)| *it).skip_while(|it| *it != next);
                found.circles.push(circle.collect());
            }
            Some(Visit::Done) | None => {}
        }
    }
}

fn mark(visits: &mut [Visit], at: usize, visit: Visit) {
    if let Some(slot) = visits.get_mut(at) {
        *slot = visit;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn needs_come_first_whatever_the_depth() {
        let deep: Vec<Vec<usize>> =
            (0..100_000).map(|i| if i < 99_999 { vec![i + 1] } else { vec![] }).collect();
        let found = sorted(&deep);
        assert!(found.circles.is_empty());
        assert_eq!(found.order.first(), Some(&99_999));
        assert_eq!(found.order.last(), Some(&0));
    }

    #[test]
    fn a_circle_is_named_whole() {
        let found = sorted(&[vec![1], vec![2], vec![1], vec![]]);
        assert_eq!(found.circles, [vec![1, 2]]);
    }
}
