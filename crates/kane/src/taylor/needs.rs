//! Which values' coefficients are looked back at, and in which order.

use super::recursion::Recursion;
use super::rules::Rule;
use crate::tape::Slot;

/// The rows that a recursion keeps.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Needs {
    pub(super) rising: Vec<bool>,
    pub(super) falling: Vec<bool>,
    /// Each coefficient times its order.
    pub(super) rate: Vec<bool>,
    /// Products whose factors are taken the other way round.
    pub(super) is_swapped: Vec<bool>,
}

impl Needs {
    /// Returns the rows that the live values of `recursion` take.
    pub(super) fn of(recursion: &Recursion, is_live: &[bool]) -> Self {
        let none = vec![false; recursion.rules.len()];
        let mut needs = Self {
            rising: none.clone(),
            falling: none.clone(),
            rate: none.clone(),
            is_swapped: none,
        };
        let live = || recursion.rules.iter().enumerate().filter(|(at, _)| is_live[*at]);
        for (at, rule) in live() {
            needs.enter(recursion, at, *rule);
        }
        // Products can go either way: the one that takes fewer rows.
        for (at, rule) in live() {
            if let Rule::Product(x, y) = *rule {
                needs.turn(at, x, y);
            }
        }
        needs
    }

    fn enter(&mut self, recursion: &Recursion, at: usize, rule: Rule) {
        match rule {
            Rule::Square(x) => {
                (self.rising[x.index()], self.falling[x.index()]) = (true, true);
            }
            Rule::Quotient(_, y) => (self.rising[y.index()], self.falling[at]) = (true, true),
            Rule::Driven { slope, of } => {
                let (slope, _) = recursion.slope(slope);
                (self.rate[of.index()], self.falling[slope.index()]) = (true, true);
            }
            Rule::Root(_) => (self.rising[at], self.falling[at]) = (true, true),
            Rule::Power(x, _) => {
                (self.rising[x.index()], self.rate[x.index()], self.falling[at]) =
                    (true, true, true);
            }
            Rule::Constant
            | Rule::State(_)
            | Rule::Input(_)
            | Rule::Add(..)
            | Rule::Subtract(..)
            | Rule::Negate(_)
            | Rule::Scale(..)
            | Rule::Product(..)
            | Rule::Over(..)
            | Rule::Magnitude(_)
            | Rule::Choice(..) => {}
        }
    }

    fn turn(&mut self, at: usize, x: Slot, y: Slot) {
        let rows = |rising: Slot, falling: Slot| {
            u8::from(!self.rising[rising.index()]) + u8::from(!self.falling[falling.index()])
        };
        self.is_swapped[at] = rows(y, x) < rows(x, y);
        let (rising, falling) = if self.is_swapped[at] { (y, x) } else { (x, y) };
        (self.rising[rising.index()], self.falling[falling.index()]) = (true, true);
    }
}
