//! Overload: the order of simplifications while a tick has more work than time.
//!
//! | simplification | what it leaves out |
//! |---|---|
//! | telemetry | rows of single keys on the stream; the overview and recordings continue |
//! | slopes | the force's slopes between two ticks; boards hold |
//! | rest | equations of a voice that has just come to rest: it sleeps sooner |
//! | steps | every other step of methods with fixed steps |
//! | fidelity | parts of the action of keys at rest: the instrument's next lower fidelity |
//!
//! Load is the fraction of a tick that its work takes: by the processor's time where a clock is
//! read, and by counted evaluations where the scene limits their number.
//! One simplification is added while the load is above a limit, and the last one is removed after
//! the load was below another limit for some time. That time doubles whenever the removed one is
//! needed again: one that saves more than the two limits are apart swings ever more rarely.

use crate::time::Period;

/// Part of the work that may be left out under overload.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Simplification {
    Telemetry,
    Slopes,
    Rest,
    Steps,
    Fidelity,
}

impl Simplification {
    /// All simplifications in their usual order.
    pub const ALL: [Self; 5] =
        [Self::Telemetry, Self::Slopes, Self::Rest, Self::Steps, Self::Fidelity];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Telemetry => "telemetry",
            Self::Slopes => "slopes",
            Self::Rest => "rest",
            Self::Steps => "steps",
            Self::Fidelity => "fidelity",
        }
    }

    const fn bit(self) -> u8 {
        1 << self as u8
    }
}

/// Set of simplifications in force in a tick.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Simplifications(u8);

impl Simplifications {
    pub const NONE: Self = Self(0);

    #[must_use]
    pub const fn with(self, one: Simplification) -> Self {
        Self(self.0 | one.bit())
    }

    pub const fn contains(self, one: Simplification) -> bool {
        self.0 & one.bit() != 0
    }

    /// Returns the set as bits, in the order of [`Simplification::ALL`].
    pub const fn bits(self) -> u8 {
        self.0
    }

    /// Returns the known simplifications of `bits`.
    pub const fn of_bits(bits: u8) -> Self {
        Self(bits & ((1 << Simplification::ALL.len()) - 1))
    }

    pub fn iter(self) -> impl Iterator<Item = Simplification> {
        Simplification::ALL.into_iter().filter(move |it| self.contains(*it))
    }
}

/// Order and limits of simplifications.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct OverloadRules {
    /// Simplifications, the first to apply first; `None` behind the last one.
    pub order: [Option<Simplification>; Simplification::ALL.len()],
    /// Load above which one more is applied.
    pub above: f64,
    /// Load below which the last one is removed.
    pub below: f64,
    /// Evaluations of derivatives and guards for all voices in a tick; `None`: only time counts.
    pub evaluations: Option<u32>,
}

impl OverloadRules {
    pub const OFF: Self = Self {
        order: [None; Simplification::ALL.len()],
        above: f64::INFINITY,
        below: 0.0,
        evaluations: None,
    };
}

impl Default for OverloadRules {
    /// Returns all of them in their usual order, above 80 % of a tick, and back below 40 %.
    fn default() -> Self {
        Self { order: Simplification::ALL.map(Some), above: 0.8, below: 0.4, evaluations: None }
    }
}

/// Time over which load is averaged (s).
const SPAN: f64 = 10e-3;

/// Time after a change for its effect to show (s).
const SETTLED: f64 = 30e-3;

/// Time of low load before a simplification is removed (s): first and largest value.
const CALM: (f64, f64) = (1.0, 64.0);

/// Largest load of a tick that counts: one stopped by a hypervisor does not predict the next.
const MOST: f64 = 2.0;

/// Decides in each tick which simplifications apply.
#[derive(Clone, Debug)]
pub struct OverloadController {
    rules: OverloadRules,
    /// Duration of a tick (s).
    h: f64,
    /// Number of simplifications of the order that apply.
    level: usize,
    now: Simplifications,
    /// Load of the last tick, and its average.
    last: f64,
    load: f64,
    /// Time since the last change, and of low load since then (s).
    since: f64,
    calm: f64,
    /// Time of low load before one is removed (s).
    patience: f64,
    has_fallen: bool,
}

impl OverloadController {
    pub fn new(rules: OverloadRules, period: Period) -> Self {
        let h = period.as_secs_f64();
        Self {
            rules,
            h,
            level: 0,
            now: Simplifications::NONE,
            last: 0.0,
            load: 0.0,
            since: 0.0,
            calm: 0.0,
            patience: CALM.0,
            has_fallen: false,
        }
    }

    /// Applies `simplified` from the next tick on, whatever the load.
    pub const fn set(&mut self, simplified: Simplifications) {
        self.now = simplified;
    }

    /// Notes that the last tick took the fraction `load` of its time.
    pub const fn note_load(&mut self, load: f64) {
        self.last = self.last.max(load);
    }

    /// Notes the `evaluations` of all voices in the last tick.
    pub fn note_evaluations(&mut self, evaluations: u32) {
        if let Some(most) = self.rules.evaluations {
            self.note_load(f64::from(evaluations) / f64::from(most.max(1)));
        }
    }

    pub fn decide(&mut self) -> Simplifications {
        let part = (self.h / SPAN).min(1.0);
        self.load += part * (self.last.min(MOST) - self.load);
        self.last = 0.0;
        self.since += self.h;
        self.calm = if self.load < self.rules.below { self.calm + self.h } else { 0.0 };
        if SETTLED <= self.since {
            if self.rules.above < self.load {
                self.rise();
            } else if 0 < self.level && self.patience <= self.calm {
                self.fall();
            }
        }
        self.now
    }

    fn rise(&mut self) {
        let Some(Some(next)) = self.rules.order.get(self.level) else { return };
        if self.has_fallen {
            let is_soon = self.since < 2.0 * self.patience;
            self.patience = if is_soon { (2.0 * self.patience).min(CALM.1) } else { CALM.0 };
        }
        self.level += 1;
        self.now = self.now.with(*next);
        (self.since, self.calm, self.has_fallen) = (0.0, 0.0, false);
    }

    fn fall(&mut self) {
        self.level -= 1;
        let left = self.rules.order.iter().take(self.level).flatten();
        self.now = left.fold(Simplifications::NONE, |all, one| all.with(*one));
        (self.since, self.calm, self.has_fallen) = (0.0, 0.0, true);
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::*;

    const KHZ: u32 = 1000;

    /// Returns the changes in `ticks` at 1 kHz, where tick n has the load `load(n, level)`.
    fn changes(ticks: u64, load: impl Fn(u64, usize) -> f64) -> Vec<(u64, u8)> {
        let period = Period::from_hz(KHZ).expect("a rate");
        let mut controller = OverloadController::new(OverloadRules::default(), period);
        let mut before = Simplifications::NONE;
        let change = |tick| {
            let now = controller.decide();
            controller.note_load(load(tick, controller.level));
            let is_other = now != core::mem::replace(&mut before, now);
            is_other.then(|| (tick, now.bits()))
        };
        (0..ticks).filter_map(change).collect()
    }

    #[test]
    fn one_thing_more_is_left_out_in_the_stated_order_until_the_load_fits_and_all_comes_back() {
        let found = changes(20_000, |tick, _| if tick < 1000 { 1.5 } else { 0.1 });
        let bits: Vec<_> = found.iter().map(|(_, bits)| *bits).collect();
        assert_eq!(bits, [1, 3, 7, 15, 31, 15, 7, 3, 1, 0]);
        let (first, last) = (found[0].0, found[4].0);
        assert!((3..60).contains(&first) && last - first <= 130, "{found:?}");
        let back: Vec<_> = found[5..].iter().map(|(tick, _)| *tick).collect();
        assert!(back.windows(2).all(|it| (990..1100).contains(&(it[1] - it[0]))), "{found:?}");
    }

    #[test]
    fn what_is_taken_back_too_soon_is_taken_back_ever_more_rarely() {
        // Each simplification saves more than the two limits are apart by: the worst case.
        let swings = changes(120_000, |_, level| if level == 0 { 1.0 } else { 0.3 });
        assert!(swings.len() <= 14, "{} changes in two minutes", swings.len());
    }

    #[test]
    fn a_tick_that_a_hypervisor_stopped_is_no_overload() {
        let is_stopped = |tick: u64| tick.is_multiple_of(100);
        assert_eq!(changes(5000, |tick, _| if is_stopped(tick) { 50.0 } else { 0.35 }), []);
        assert_eq!(changes(5000, |_, _| 0.7), [], "between the limits");
    }

    #[test]
    fn nothing_is_left_out_where_nothing_may() {
        let period = Period::from_hz(KHZ).expect("a rate");
        let mut controller = OverloadController::new(OverloadRules::OFF, period);
        for _ in 0..500 {
            controller.note_load(3.0);
            assert_eq!(controller.decide(), Simplifications::NONE);
        }
    }

    #[test]
    fn counted_evaluations_are_a_load_of_their_own_where_their_number_is_limited() {
        let period = Period::from_hz(KHZ).expect("a rate");
        let is_loaded = |evaluations| {
            let rules = OverloadRules { evaluations, ..OverloadRules::default() };
            let mut controller = OverloadController::new(rules, period);
            for _ in 0..500 {
                controller.note_evaluations(90);
                controller.decide();
            }
            controller.now != Simplifications::NONE
        };
        assert_eq!([Some(100), Some(200), None].map(is_loaded), [true, false, false]);
    }

    #[test]
    fn bits_of_a_later_version_are_left_alone() {
        assert_eq!(Simplifications::of_bits(0xff).iter().count(), Simplification::ALL.len());
    }
}
