//! Shared parts of sums and products, computed once.
//!
//! Pairs of terms or factors are counted over the whole tape; the most frequent pair becomes a
//! form, repeatedly ([Breuer's method]).
//!
//! [Breuer's method]: https://doi.org/10.1145/363034.363035

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, BinaryHeap};

use super::forms::{FormId, Forms, TapeForm};
use crate::expressions::graph::Graph;

/// Most parts of a sum or product that is searched; the lower limits apply to many of them.
const MOST_PARTS: [usize; 5] = [64, 32, 16, 8, 4];
/// Most pairs that are searched: about a second.
const MOST_PAIRS: usize = 400_000;

/// Work on a pair, in operands of the graph.
const PAIR: usize = 4;

/// Two parts: bases of products, or terms of sums with the second's factor over the first's.
type FormPair = (FormId, FormId, u64);

type Owners = BTreeMap<FormPair, BTreeSet<FormId>>;

impl Forms {
    /// Replaces divisions by one value in several products by products with its inverse.
    pub(super) fn share_inverses(&mut self) {
        let mut divisions: BTreeMap<FormId, u32> = BTreeMap::new();
        for form in &self.all {
            let TapeForm::Product(factors) = form else { continue };
            for (base, _) in factors.iter().filter(|it| it.1 < 0) {
                *divisions.entry(*base).or_default() += 1;
            }
        }
        divisions.retain(|_, count| *count > 1);
        let inverses: BTreeMap<FormId, FormId> =
            divisions.into_keys().map(|base| (base, self.push(TapeForm::Inverse(base)))).collect();
        for form in &mut self.all {
            let TapeForm::Product(factors) = form else { continue };
            factors.iter_mut().filter(|it| it.1 < 0).for_each(|it| with_inverse(it, &inverses));
            factors.sort_unstable();
        }
    }

    pub(super) fn share_products(&mut self, graph: &Graph) {
        self.share(graph, &FactorPairs);
    }

    pub(super) fn share_sums(&mut self, graph: &Graph) {
        self.share(graph, &TermPairs);
    }

    fn share(&mut self, graph: &Graph, kind: &dyn Pairs) {
        let Some(most_parts) = self.most_parts(kind) else { return };
        let mut owners = Owners::new();
        for (id, form) in self.all.iter().enumerate() {
            if kind.parts(form) > most_parts {
                continue;
            }
            let pairs = kind.pairs(form);
            graph.spend(PAIR * pairs.len());
            for pair in pairs {
                owners.entry(pair).or_default().insert(id);
            }
        }
        let mut queue: BinaryHeap<(usize, Reverse<FormPair>)> =
            owners.iter().map(|(pair, of)| (of.len(), Reverse(*pair))).collect();
        while let Some((count, Reverse(pair))) = queue.pop()
            && graph.given_up().is_none()
        {
            let now = owners.get(&pair).map_or(0, BTreeSet::len);
            if now < 2 {
                continue;
            }
            if now < count {
                queue.push((now, Reverse(pair)));
                continue;
            }
            let changed = self.extract(graph, kind, &mut owners, pair);
            let counted =
                changed.into_iter().map(|it| (owners.get(&it).map_or(0, BTreeSet::len), it));
            queue.extend(counted.filter(|it| it.0 > 1).map(|(count, it)| (count, Reverse(it))));
        }
    }

    fn most_parts(&self, kind: &dyn Pairs) -> Option<usize> {
        MOST_PARTS.into_iter().find(|most| {
            let parts = self.all.iter().map(|form| kind.parts(form)).filter(|it| it <= most);
            parts.map(|it| it * it / 2).sum::<usize>() <= MOST_PAIRS
        })
    }

    fn extract(
        &mut self,
        graph: &Graph,
        kind: &dyn Pairs,
        owners: &mut Owners,
        pair: FormPair,
    ) -> BTreeSet<FormPair> {
        let part = self.push(kind.form(pair));
        let mut new = BTreeSet::new();
        for owner in owners.remove(&pair).unwrap_or_default() {
            for old in kind.pairs(&self.all[owner]) {
                owners.entry(old).or_default().remove(&owner);
            }
            kind.replace(&mut self.all[owner], pair, part);
            let pairs = kind.pairs(&self.all[owner]);
            graph.spend(2 * PAIR * pairs.len());
            for pair in pairs {
                owners.entry(pair).or_default().insert(owner);
                new.insert(pair);
            }
        }
        new
    }
}

fn with_inverse(factor: &mut (FormId, i32), inverses: &BTreeMap<FormId, FormId>) {
    if let Some(inverse) = inverses.get(&factor.0) {
        *factor = (*inverse, -factor.1);
    }
}

trait Pairs {
    fn parts(&self, form: &TapeForm) -> usize;

    fn pairs(&self, form: &TapeForm) -> Vec<FormPair>;

    fn form(&self, pair: FormPair) -> TapeForm;

    fn replace(&self, form: &mut TapeForm, pair: FormPair, part: FormId);
}

struct FactorPairs;

impl Pairs for FactorPairs {
    fn parts(&self, form: &TapeForm) -> usize {
        if let TapeForm::Product(factors) = form { factors.len() } else { 0 }
    }

    fn pairs(&self, form: &TapeForm) -> Vec<FormPair> {
        let TapeForm::Product(factors) = form else { return Vec::new() };
        let above: Vec<FormId> = factors.iter().filter(|it| it.1 > 0).map(|it| it.0).collect();
        of_list(&above, |x, y| Some((x, y, 0)))
    }

    fn form(&self, (x, y, _): FormPair) -> TapeForm {
        TapeForm::Product(vec![(x, 1), (y, 1)])
    }

    fn replace(&self, form: &mut TapeForm, (x, y, _): FormPair, part: FormId) {
        let TapeForm::Product(factors) = form else { return };
        let exponent = |of: FormId| factors.iter().find(|it| it.0 == of).map_or(0, |it| it.1);
        let both = exponent(x).min(exponent(y));
        for it in factors.iter_mut().filter(|it| it.0 == x || it.0 == y) {
            it.1 -= both;
        }
        factors.retain(|it| it.1 != 0);
        factors.push((part, both));
    }
}

/// Pairs of terms with one ratio of factors.
struct TermPairs;

impl Pairs for TermPairs {
    fn parts(&self, form: &TapeForm) -> usize {
        if let TapeForm::Sum(_, terms) = form { terms.len() } else { 0 }
    }

    fn pairs(&self, form: &TapeForm) -> Vec<FormPair> {
        let TapeForm::Sum(_, terms) = form else { return Vec::new() };
        let factors: BTreeMap<FormId, f64> = terms.iter().copied().collect();
        let ids: Vec<FormId> = terms.iter().map(|it| it.0).collect();
        of_list(&ids, |x, y| {
            let ratio = factors[&y] / factors[&x];
            // Only where the ratio gives the second factor back to the bit.
            let is_exact = (ratio * factors[&x]).to_bits() == factors[&y].to_bits();
            is_exact.then_some((x, y, ratio.to_bits()))
        })
    }

    fn form(&self, (x, y, ratio): FormPair) -> TapeForm {
        TapeForm::Sum(0.0, vec![(x, 1.0), (y, f64::from_bits(ratio))])
    }

    fn replace(&self, form: &mut TapeForm, (x, y, _): FormPair, part: FormId) {
        let TapeForm::Sum(_, terms) = form else { return };
        let factor = terms.iter().find(|it| it.0 == x).map_or(0.0, |it| it.1);
        terms.retain(|it| it.0 != x && it.0 != y);
        terms.push((part, factor));
    }
}

fn of_list(all: &[FormId], pair: impl Fn(FormId, FormId) -> Option<FormPair>) -> Vec<FormPair> {
    let mut sorted = all.to_vec();
    sorted.sort_unstable();
    let mut pairs = Vec::new();
    for (at, x) in sorted.iter().enumerate() {
        pairs.extend(sorted[at + 1..].iter().filter_map(|y| pair(*x, *y)));
    }
    pairs
}
