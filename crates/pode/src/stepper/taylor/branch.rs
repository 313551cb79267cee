//! The end of a series where the equations change their form.

use crate::series::{Expansion, Fall, GuardPolynomial, GuardSeries, first_fall};
use crate::state::State;

/// Rounding of a condition, in units of all its coefficients.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Relative excess of a step beyond a condition's zero, so that the next one sees the other sign.
/// The orbit's error beyond the zero is at most a rate times this.
const BEYOND: f64 = 1e-12;
/// Maximum of halvings of a step whose condition only touches zero.
const HALVINGS: u32 = 8;

/// Returns the time (s) within `reach` (s) for which the series holds, just beyond the first zero
/// of a condition; `None` if a condition leaves zero to the other side at once.
pub(super) fn before<S: State>(expansion: &Expansion<S>, reach: f64) -> Option<f64> {
    let mut reach = reach;
    for index in 0..expansion.known_conditions {
        let mut holds = None;
        for _ in 0..HALVINGS {
            match end(expansion, index, reach) {
                BranchEnd::Behind => holds = Some(reach),
                BranchEnd::At(part) => holds = Some(reach * part * (1.0 + BEYOND)),
                BranchEnd::Here => return None,
                BranchEnd::Unclear => {
                    reach *= 0.5;
                    continue;
                }
            }
            break;
        }
        reach = holds?;
    }
    Some(reach)
}

enum BranchEnd {
    Behind,
    At(f64),
    Here,
    Unclear,
}

fn end<S: State>(expansion: &Expansion<S>, index: usize, reach: f64) -> BranchEnd {
    let all = GuardSeries {
        terms: &expansion.conditions,
        known: expansion.known_conditions,
        order: expansion.order,
        ratio: reach / expansion.scale,
    };
    let Some(condition) = all.guard(index) else { return BranchEnd::Unclear };
    let falls = |condition: &GuardPolynomial| {
        let [first, others @ ..] = condition.terms() else { return BranchEnd::Unclear };
        let most: f64 = others.iter().map(|it| it.abs()).sum();
        if *first > most {
            return BranchEnd::Behind;
        }
        match first_fall(condition, ROUNDING * (first.abs() + most)) {
            Fall::None => BranchEnd::Behind,
            Fall::Within(from, to) => BranchEnd::At(root(condition, from, to)),
            Fall::Open => BranchEnd::Unclear,
        }
    };
    let size: f64 = condition.terms().iter().map(|it| it.abs()).sum();
    let start = condition.terms[0];
    let condition = if start > 0.0 { condition } else { condition.negated() };
    if start.abs() > ROUNDING * size {
        return falls(&condition);
    }
    // It leaves zero, as every condition does behind its zero; or it stays zero.
    let next = condition.departed();
    match next.terms().iter().find(|it| it.abs() > ROUNDING * size) {
        None => BranchEnd::Behind,
        Some(first) if *first < 0.0 => BranchEnd::Here,
        Some(_) if next.terms[0] > ROUNDING * size => falls(&next),
        Some(_) => BranchEnd::Unclear,
    }
}

fn root(condition: &GuardPolynomial, from: f64, to: f64) -> f64 {
    /// Reaches the last bit of a straight line's root at a millionth of the reach.
    const BISECTIONS: u32 = 76;
    let (mut from, mut to) = (from, to);
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (from + to);
        if condition.at(middle).0 > 0.0 {
            from = middle;
        } else {
            to = middle;
        }
    }
    to
}
