//! Where a series ends before its coefficients say so: the equations change their form.

use crate::series::{Expansion, Fall, GuardPolynomial, GuardSeries, first_fall};
use crate::state::State;

/// Rounding of a condition, in units of all its coefficients.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// So much longer is a step that ends where a condition does, in units of itself: what follows
/// sees the other sign. Beyond the zero the orbit is wrong by no more than a rate times this.
const BEYOND: f64 = 1e-12;
/// How often a step is halved where a condition only touches zero.
const HALVINGS: u32 = 8;

/// How far (s) the series holds within `reach` (s): to just behind the first zero of a condition.
///
/// None where it does not hold at all, since a condition leaves zero to the other side.
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

/// Where a condition ends.
enum BranchEnd {
    /// Not within the step.
    Behind,
    /// At this part of the step.
    At(f64),
    /// Right at the start of the step.
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
    // It leaves zero, as every condition does behind its zero; or it is zero, and stays.
    let next = condition.departed();
    match next.terms().iter().find(|it| it.abs() > ROUNDING * size) {
        None => BranchEnd::Behind,
        Some(first) if *first < 0.0 => BranchEnd::Here,
        Some(_) if next.terms[0] > ROUNDING * size => falls(&next),
        Some(_) => BranchEnd::Unclear,
    }
}

/// The only root between a place where it is positive and one where it is negative.
fn root(condition: &GuardPolynomial, from: f64, to: f64) -> f64 {
    /// To the last bit of a root that is a millionth of the reach, as that of a straight line.
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
