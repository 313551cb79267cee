//! The coefficients of one order after another.

use super::Writing;
use super::values::input_of;
use crate::tape::Slot;
use crate::taylor::lanes::{LaneFactor, ProductLane};
use crate::taylor::rules::TermRule;

impl Writing<'_> {
    /// The outputs' coefficients of order `k`.
    pub(super) fn outputs(&mut self, depth: usize, k: &str, next: &str) {
        let (entries, _) = self.recursion.outputs();
        let rates: Vec<_> =
            entries.iter().map(|slot| format!("by * {}", self.now(*slot, k))).collect();
        let rates = rates.join(", ");
        self.line(depth, &format!("let by = out.scale * PER_ORDER[{next}];"));
        self.line(depth, &format!("out.terms[{next}] = [{rates}];"));
        self.guards(depth, k);
    }

    fn guards(&mut self, depth: usize, k: &str) {
        for (index, slot) in self.guard_slots().iter().enumerate() {
            let value = self.now(*slot, k);
            self.line(depth, &format!("out.guards[{index}][{k}] = {value};"));
        }
    }

    /// The coefficient of order `k` of a value.
    fn now(&self, slot: Slot, k: &str) -> String {
        match k {
            "0" => format!("v{}", slot.0),
            _ if self.recursion.is_constant(slot) => "0.0".into(),
            _ => format!("w{}", slot.0),
        }
    }

    pub(super) fn orders(&mut self) {
        self.line(1, "for k in 1..out.order {");
        self.terms(2, &self.is_live.clone());
        self.outputs(2, "k", "k + 1");
        self.enter(2);
        self.line(1, "}");
    }

    /// The guards go as far as the state; of all else nobody asks for the last coefficient.
    pub(super) fn last_guards(&mut self) {
        let guards = self.guard_slots();
        self.line(1, &format!("out.known_guards = {};", guards.len()));
        if guards.is_empty() {
            return;
        }
        self.line(1, "let k = out.order;");
        self.terms(1, &self.recursion.last(guards));
        self.guards(1, "k");
    }

    /// The coefficients of order k of the values in `wanted`.
    fn terms(&mut self, depth: usize, wanted: &[bool]) {
        let reads_state = (0..wanted.len())
            .any(|at| wanted[at] && matches!(self.recursion.rules[at], TermRule::State(_)));
        if reads_state {
            self.line(depth, "let x = out.terms[k];");
        }
        for group in 0..self.groups().len() {
            self.line(depth, &format!("let e{group} = lanes{group}.inner(k);"));
        }
        let wanted: Vec<_> = (0..wanted.len()).filter(|at| wanted[*at]).collect();
        self.line(depth, "let per_k = PER_ORDER[k];");
        for at in wanted {
            let Some(term) = self.term(at) else { continue };
            self.line(depth, &format!("let w{at} = {term};"));
        }
    }

    /// As many lanes at a time as fit into the registers of a common processor.
    pub(super) fn groups(&self) -> Vec<Vec<ProductLane>> {
        const MOST: usize = 14;
        let count = self.lanes.len().div_ceil(MOST).max(1);
        let size = self.lanes.len().div_ceil(count).max(1);
        self.lanes.chunks(size).map(<[ProductLane]>::to_vec).collect()
    }

    /// What the orders before k add to a value's coefficient: the lane of that number.
    fn sum(&self, at: usize, number: usize) -> String {
        let groups = self.groups();
        let places = groups.iter().enumerate().flat_map(|(group, lanes)| {
            lanes.iter().enumerate().map(move |(lane, it)| (group, lane, it.of))
        });
        let place = places.filter(|it| it.2.index() == at).nth(number);
        place.map_or_else(
            || "0.0".into(),
            |(group, lane, _)| format!("e{group}[{}].both()[{}]", lane / 2, lane % 2),
        )
    }

    /// Enters this order into the lanes.
    fn enter(&mut self, depth: usize) {
        for (group, lanes) in self.groups().into_iter().enumerate() {
            let list = |of: fn(&ProductLane) -> LaneFactor| {
                let list: Vec<_> = lanes.iter().map(|lane| of(lane).text()).collect();
                let pair = |pair: &[String]| match pair {
                    [one, other] => format!("LanePair::new({one}, {other})"),
                    rest => format!("LanePair::new({}, 0.0)", rest.concat()),
                };
                list.chunks(2).map(pair).collect::<Vec<_>>().join(", ")
            };
            let (first, second) = (list(|lane| lane.first), list(|lane| lane.second));
            self.line(depth, &format!("lanes{group}.enter(k, [{first}], [{second}]);"));
        }
    }

    /// The coefficient of order k of a value that goes on.
    fn term(&self, at: usize) -> Option<String> {
        let now = |slot: Slot| self.now(slot, "k");
        let e = self.sum(at, 0);
        let is_constant = |slot: Slot| self.recursion.is_constant(slot);
        Some(match self.recursion.rules[at] {
            TermRule::Constant => return None,
            TermRule::State(index) => format!("x[{index}]"),
            TermRule::Input(rate) => input_of(rate),
            TermRule::Add(x, y) if is_constant(x) => now(y),
            TermRule::Add(x, y) if is_constant(y) => now(x),
            TermRule::Add(x, y) => format!("{} + {}", now(x), now(y)),
            TermRule::Subtract(x, y) if is_constant(x) => format!("-{}", now(y)),
            TermRule::Subtract(x, y) if is_constant(y) => now(x),
            TermRule::Subtract(x, y) => format!("{} - {}", now(x), now(y)),
            TermRule::Negate(x) => format!("-{}", now(x)),
            TermRule::Scale(by, x) => format!("v{} * {}", by.0, now(x)),
            TermRule::Product(x, y) => format!("{e} + v{0} * w{1} + w{0} * v{1}", x.0, y.0),
            TermRule::Square(x) => format!("{e} + 2.0 * v{0} * w{0}", x.0),
            TermRule::Quotient(x, y) => {
                format!("({} - {e} - v{at} * w{}) * per{at}", now(x), y.0)
            }
            TermRule::Over(x, _) => format!("{} * per{at}", now(x)),
            TermRule::Driven { slope, of } => {
                let (slope, is_negative) = self.recursion.slope(slope);
                let (open, close) = if is_negative { ("-(", ")") } else { ("", "") };
                format!("{open}{e} * per_k + w{} * v{}{close}", of.0, slope.0)
            }
            TermRule::Root(x) => format!("({} - {e}) * per{at}", now(x)),
            TermRule::Power(x, by) => format!(
                "((v{0} + 1.0) * {2} * per_k - {e} \
                 + v{0} * v{at} * w{1}) * per{at}",
                by.0,
                x.0,
                self.sum(at, 1)
            ),
            TermRule::Magnitude(x) => format!("sign{at} * {}", now(x)),
            TermRule::Choice(_, x, y) => {
                format!("if is{at} {{ {} }} else {{ {} }}", now(x), now(y))
            }
        })
    }
}
