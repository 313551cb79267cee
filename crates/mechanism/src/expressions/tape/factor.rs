//! Common factors taken out of sums: a x + b x becomes (a + b) x.

use std::collections::BTreeMap;

use super::forms::{FormId, Forms, TapeForm};
use crate::expressions::graph::Graph;

const DEEPEST: u8 = 12;

const MOST_TERMS: usize = 256;
/// Most work on all sums of a tape, in terms squared; beyond it only short sums are searched.
const MOST_WORK: usize = 2_000_000;
const SHORT: usize = 8;

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Side {
    Below,
    Above,
}

const fn side_of(exponent: i32) -> Side {
    if exponent > 0 { Side::Above } else { Side::Below }
}

/// Number times forms to whole powers.
type Monomial = (f64, Vec<(FormId, i32)>);

impl Forms {
    /// Factors all sums; only products without other users are taken apart.
    pub(super) fn factor_sums(&mut self, graph: &Graph) {
        let uses = self.uses();
        let lengths = self
            .all
            .iter()
            .map(|form| if let TapeForm::Sum(_, terms) = form { terms.len() } else { 0 });
        let lengths = lengths.filter(|it| *it <= MOST_TERMS);
        let work: usize = lengths.map(|it| it * it).sum();
        let longest = if work <= MOST_WORK { MOST_TERMS } else { SHORT };
        for id in 0..uses.len() {
            let TapeForm::Sum(number, terms) = &self.all[id] else { continue };
            if terms.len() > longest || graph.given_up().is_some() {
                continue;
            }
            graph.spend(terms.len() * terms.len());
            let monomials: Vec<Monomial> = terms
                .iter()
                .map(|(term, factor)| (*factor, self.factors_of(*term, uses[*term])))
                .collect();
            if most_common(&monomials).is_some() {
                let number = *number;
                let terms = self.factored(monomials, DEEPEST);
                self.all[id] = TapeForm::Sum(number, terms);
            }
        }
    }

    /// Returns the factors of a product that is used once; any other form is its own only factor.
    fn factors_of(&self, term: FormId, uses: u32) -> Vec<(FormId, i32)> {
        if let (TapeForm::Product(factors), 1) = (&self.all[term], uses) {
            return factors.clone();
        }
        vec![(term, 1)]
    }

    fn factored(&mut self, mut monomials: Vec<Monomial>, depth: u8) -> Vec<(FormId, f64)> {
        let mut terms = Vec::new();
        while depth > 0
            && let Some(common) = most_common(&monomials)
        {
            let has = |it: &Monomial| power_of(it, common) > 0;
            let (with, without): (Vec<_>, Vec<_>) = monomials.into_iter().partition(has);
            monomials = without;
            let taken = with.iter().map(|it| power_of(it, common)).min().unwrap_or(1);
            let (base, side) = common;
            let exponent = if side == Side::Above { taken } else { -taken };
            let inner = with.into_iter().map(|it| divided(it, base, exponent)).collect();
            terms.push(self.product_of_sum(inner, (base, exponent), depth));
        }
        terms.extend(monomials.into_iter().map(|it| self.term(it)));
        collected(terms)
    }

    fn product_of_sum(
        &mut self,
        inner: Vec<Monomial>,
        outer: (FormId, i32),
        depth: u8,
    ) -> (FormId, f64) {
        let (numbers, inner): (Vec<_>, Vec<_>) = inner.into_iter().partition(|it| it.1.is_empty());
        let number = numbers.iter().map(|it| it.0).sum();
        let inner = self.factored(inner, depth - 1);
        let sum = self.push(TapeForm::Sum(number, inner));
        let mut factors = vec![outer, (sum, 1)];
        factors.sort_unstable();
        (self.push(TapeForm::Product(factors)), 1.0)
    }

    fn term(&mut self, (factor, factors): Monomial) -> (FormId, f64) {
        match factors.as_slice() {
            [(only, 1)] => (*only, factor),
            _ => (self.push(TapeForm::Product(factors)), factor),
        }
    }
}

/// Returns the base, above or below the fraction line, in most monomials; at least in two.
fn most_common(monomials: &[Monomial]) -> Option<(FormId, Side)> {
    let mut counts: BTreeMap<(FormId, Side), usize> = BTreeMap::new();
    for (_, factors) in monomials {
        for (base, exponent) in factors {
            *counts.entry((*base, side_of(*exponent))).or_default() += 1;
        }
    }
    let most = counts
        .into_iter()
        .filter(|it| it.1 > 1)
        .max_by_key(|(key, count)| (*count, core::cmp::Reverse(*key)));
    most.map(|it| it.0)
}

fn power_of(monomial: &Monomial, (base, side): (FormId, Side)) -> i32 {
    let found = monomial.1.iter().find(|it| it.0 == base).map_or(0, |it| it.1);
    if side == Side::Above { found } else { -found }
}

fn divided((factor, mut factors): Monomial, base: FormId, exponent: i32) -> Monomial {
    for it in &mut factors {
        if it.0 == base {
            it.1 -= exponent;
        }
    }
    factors.retain(|it| it.1 != 0);
    (factor, factors)
}

fn collected(terms: Vec<(FormId, f64)>) -> Vec<(FormId, f64)> {
    let mut collected: BTreeMap<FormId, f64> = BTreeMap::new();
    for (id, factor) in terms {
        *collected.entry(id).or_default() += factor;
    }
    collected.into_iter().collect()
}
