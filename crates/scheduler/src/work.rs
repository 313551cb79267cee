//! Work and its price: units that voices count, the time that a unit takes, the time of a lane.
//!
//! A deadline is a time, but a voice can bound itself only in units of work. The owner of the lanes
//! states the cost of a unit of each kind of voice, and a lane spends its time by these costs.
//! A wrong cost makes no voice wait: once the time is spent by the costs, the lane reads its clock
//! and continues while there is time.

/// Kinds of voices whose costs are known at once.
pub const MAX_KINDS: usize = 16;

/// Lowest cost of a unit (ns), assumed before measurements and in virtual time: a cheap evaluation.
pub const NOMINAL_UNIT_NS: f64 = 10.0;

/// Fraction of a lane's time that a turn may take, where [`TurnLimit`] is strict.
pub const TURN_FRACTION: f64 = 0.1;

/// Limit of the units of work of a turn.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TurnLimit {
    /// Units in the first quarter of the tick.
    pub early: u32,
    /// Units in the whole tick.
    pub most: u32,
}

impl TurnLimit {
    pub const NONE: Self = Self::of(u32::MAX);

    /// Units that a turn may always take in the first quarter of its tick.
    const EARLY: u32 = 64;

    pub const fn of(units: u32) -> Self {
        Self { early: units, most: units }
    }

    /// Returns the limit of a voice that failed recently: `units`, but no fewer than an ordinary
    /// turn takes, since a lane without time must not make it fail again.
    pub(crate) const fn of_suspect(units: u32) -> Self {
        Self::of(if units < Self::EARLY { Self::EARLY } else { units })
    }

    /// Returns the limit of a voice without recent failures that may take `units` by its lane's
    /// time, in a tick of 1/`hz` (s).
    ///
    /// The hardest strokes of the default action take up to 200 units at 1 kHz, a fifth of them in
    /// the first quarter of the tick. On a slow processor that is more than a tenth of a lane's
    /// time, and no stroke may be cut off: there the limit is strict for the first quarter only.
    pub(crate) const fn of_trusted(units: u32, hz: u32) -> Self {
        let (early, most) = (Self::EARLY, 128 + 384_000 / hz);
        Self {
            early: if units < early { early } else { units },
            most: if units < most { most } else { units },
        }
    }
}

/// Kind of voice: voices of the same model and method take the same time for a unit of work.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct VoiceKind(pub u32);

/// Cost of turns and of units of work, by kind of voice.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct WorkCosts {
    /// Cost of a turn beside its units (ns).
    pub turn: f64,
    /// Cost of a unit of each kind (ns).
    units: [(VoiceKind, f64); MAX_KINDS],
    n_kinds: usize,
    /// Cost of a unit of all other kinds (ns), if it is known.
    other: Option<f64>,
}

impl WorkCosts {
    pub const fn unknown() -> Self {
        Self { turn: 0.0, units: [(VoiceKind(0), 0.0); MAX_KINDS], n_kinds: 0, other: None }
    }

    /// Returns costs of `unit` (ns) for every unit and none for a turn.
    pub const fn constant(unit: f64) -> Self {
        Self { other: Some(unit), ..Self::unknown() }
    }

    /// Returns the highest known cost of a unit (ns), assumed for an unknown kind.
    fn highest(&self) -> f64 {
        let known = self.units[..self.n_kinds].iter().map(|(_, cost)| *cost);
        known.fold(NOMINAL_UNIT_NS, f64::max)
    }

    /// Returns the cost of a unit (ns), if it is known.
    #[inline]
    pub fn unit(&self, kind: VoiceKind) -> Option<f64> {
        let known = self.units[..self.n_kinds].iter().find(|(it, _)| *it == kind);
        known.map(|(_, cost)| *cost).or(self.other)
    }

    /// Sets the cost of a unit (ns) of `kind` at `index`, below [`MAX_KINDS`].
    pub fn set(&mut self, index: usize, kind: VoiceKind, cost: f64) {
        if let Some(entry) = self.units.get_mut(index) {
            *entry = (kind, cost);
            self.n_kinds = self.n_kinds.max(index + 1);
        }
    }
}

/// Clock of a lane.
pub trait LaneClock {
    /// Returns the time left for the lane in this tick (ns).
    fn left(&mut self) -> f64;
}

/// Absent clock: a lane may take as long as it needs, as in virtual time.
#[derive(Clone, Copy, Debug)]
pub struct NoClock;

impl LaneClock for NoClock {
    fn left(&mut self) -> f64 {
        f64::INFINITY
    }
}

/// Time of a lane in one tick, spent by the costs of what its voices do.
///
/// The lane reads the clock where half of the time is spent by the costs, and then whenever half
/// of the time left then is spent. A lane with little to do never reads the clock.
#[derive(Debug)]
pub struct LaneBudget<'a, C> {
    costs: &'a WorkCosts,
    clock: C,
    /// Time of the lane by its clock in a tick (ns).
    time: f64,
    /// Time that may be spent before the next read of the clock (ns).
    granted: f64,
    /// Time spent by the costs (ns).
    spent: f64,
    /// Longest time of a turn (ns).
    turn: f64,
    priced: Option<(VoiceKind, TurnPrice)>,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct TurnPrice {
    /// Cost of a unit (ns), if it is known.
    unit: Option<f64>,
    /// Most units of a turn.
    pub(crate) most: u32,
}

impl LaneBudget<'static, NoClock> {
    /// Returns a budget without a limit, in which a turn may take `turn` (ns) at the nominal cost.
    pub const fn unlimited(turn: f64) -> Self {
        const NOMINAL: &WorkCosts = &WorkCosts::constant(NOMINAL_UNIT_NS);
        Self {
            costs: NOMINAL,
            clock: NoClock,
            time: f64::INFINITY,
            granted: f64::INFINITY,
            spent: 0.0,
            turn,
            priced: None,
        }
    }
}

impl<'a, C: LaneClock> LaneBudget<'a, C> {
    /// Returns the budget of a lane with `time` (ns) by `clock`; a turn may take `turn` (ns).
    pub const fn new(costs: &'a WorkCosts, clock: C, time: f64, turn: f64) -> Self {
        Self { costs, clock, time, granted: 0.5 * time, spent: 0.0, turn, priced: None }
    }

    /// Returns the price of a turn, cached since neighbours are mostly of one kind.
    #[inline]
    pub(crate) fn price(&mut self, kind: VoiceKind) -> TurnPrice {
        if let Some((_, price)) = self.priced.filter(|(priced, _)| *priced == kind) {
            return price;
        }
        let unit = self.costs.unit(kind);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "as saturates")]
        let most = (self.turn / unit.unwrap_or_else(|| self.costs.highest())) as u32;
        let price = TurnPrice { unit, most };
        self.priced = Some((kind, price));
        price
    }

    /// Returns `true` if the lane has time for a turn of `units`, those of the voice's last turn.
    ///
    /// # Real-time
    /// Reads the clock where the time that was granted is spent by the costs.
    #[inline]
    pub(crate) fn has_time(&mut self, price: TurnPrice, units: u32) -> bool {
        0.0 < self.granted || self.look(price, units)
    }

    /// Reads the clock and grants half of the time left, if a turn of `units` fits into it.
    ///
    /// If the tick took less than its costs so far, so will the turn; no turn exceeds its limit.
    #[cold]
    fn look(&mut self, price: TurnPrice, units: u32) -> bool {
        let left = self.clock.left();
        let by_costs = self.cost(price, units).unwrap_or(self.costs.turn);
        let taken = self.time - left;
        let expected = if taken < self.spent { by_costs * taken / self.spent } else { by_costs };
        self.granted = (0.5 * left).max(expected);
        expected.min(self.turn) < left
    }

    /// Spends a turn of `units`; one of unknown cost is followed by a read of the clock.
    #[inline]
    pub(crate) fn spend(&mut self, price: TurnPrice, units: u32) {
        let Some(cost) = self.cost(price, units) else {
            self.granted = 0.0;
            return;
        };
        self.granted -= cost;
        self.spent += cost;
    }

    /// Returns the cost of a turn (ns), if that of its units is known.
    fn cost(&self, price: TurnPrice, units: u32) -> Option<f64> {
        if units == 0 {
            return Some(self.costs.turn);
        }
        Some(self.costs.turn + f64::from(units) * price.unit?)
    }
}
