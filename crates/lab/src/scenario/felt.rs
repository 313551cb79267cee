//! A head that meets felt, F = k xⁿ (1 + λ v): one Hunt–Crossley contact. `[HC75]`
//!
//! With u = 1 + λ v, (u − ln u)/λ² and k xⁿ⁺¹/(m (n + 1)) have a constant sum, so the exit speed
//! does not depend on k. Times are quadratures: references/hunt_crossley.py.

use pode::{
    Enclosure, Energetic, EquationKind, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Model,
    Nature, Reset, Resets,
};

use super::{ExpectedEvent, ForceKind as Figure, MS, Plan, Reference, Scenario};

/// Mass of the head (kg).
const MASS: f64 = 0.01;
const POWER: f64 = 1.5;
/// Loss λ (s/m).
const LOSS: f64 = 0.6;
/// Entry speed (m/s).
const SPEED: f64 = 1.0;
/// Exit speed: (−W0(−u0 e^−u0) − 1)/λ, u0 = 1 + λ v0 (m/s).
const EXIT: f64 = -0.711_950_179_577_866_2;

/// Penetration (m) and its rate (m/s), without gravity.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct FeltPenetration {
    /// Stiffness (N/m^1.5).
    k: f64,
    /// Deepest point (m).
    depth: f64,
}

#[derive(Clone, Copy, Debug)]
struct ContactRecord {
    felt: FeltPenetration,
    /// Times of the deepest point and of the exit (s).
    times: [f64; 2],
    /// End, and time between samples (s).
    span: (f64, f64),
    ticks: &'static [f64],
}

pub(super) fn soft() -> FeltScenario {
    const TICKS: &[f64] =
        &[MS, 0.5 * MS, 0.25 * MS, 0.1 * MS, 0.05 * MS, 0.025 * MS, 0.01 * MS, 0.005 * MS];
    FeltScenario::new(ContactRecord {
        felt: FeltPenetration { k: 1e5, depth: 0.001_521_344_239_131_188_8 },
        times: [0.002_359_535_961_218_295, 0.005_332_605_765_717_41],
        span: (10.0 * MS, MS),
        ticks: TICKS,
    })
}

pub(super) fn hard() -> FeltScenario {
    const TICKS: &[f64] =
        &[0.5 * MS, 0.25 * MS, 0.1 * MS, 0.05 * MS, 0.025 * MS, 0.01 * MS, 0.005 * MS, 0.001 * MS];
    FeltScenario::new(ContactRecord {
        felt: FeltPenetration { k: 1e7, depth: 0.000_241_116_812_798_895_35 },
        times: [0.000_373_961_248_230_206_54, 0.000_845_161_057_616_440_6],
        span: (2.0 * MS, 0.5 * MS),
        ticks: TICKS,
    })
}

impl Model for FeltPenetration {
    type Mode = bool;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, touched: bool, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], -self.readout(touched, x, &()) / MASS]
    }

    /// Returns the force of the contact (N).
    fn readout(&self, touched: bool, x: &[f64; 2], (): &()) -> f64 {
        if touched { self.k * x[0].max(0.0).powf(POWER) * (1.0 + LOSS * x[1]) } else { 0.0 }
    }

    /// Steps in contact are a tenth of a radian at the deepest point.
    fn nature(&self, touched: bool) -> Nature {
        if touched {
            Nature::new(EquationKind::Smooth, self.rate()).with_longest_step(0.1 / self.rate())
        } else {
            Nature::new(EquationKind::Affine, 0.0)
        }
    }
}

impl FeltPenetration {
    /// Returns √(F'(x)/m) at the deepest point (rad/s).
    fn rate(self) -> f64 {
        (POWER * self.k * self.depth.powf(POWER - 1.0) / MASS).sqrt()
    }
}

impl Guarded for FeltPenetration {
    fn guards(&self, touched: bool) -> &'static [GuardSpec] {
        const TOUCHED: [GuardSpec; 2] =
            [GuardSpec::new(0, "leave").scaled(1e-3), GuardSpec::new(1, "deepest").on_crossing()];
        if touched { &TOUCHED } else { &[] }
    }

    fn guard_bound(
        &self,
        _touched: bool,
        guard: GuardId,
        over: &Enclosure<[f64; 2], ()>,
    ) -> GuardBound {
        over.entry(usize::from(guard.0))
    }

    fn guard(&self, touched: bool, guard: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        match guard.0 {
            0 => GuardValue::new(x[0], x[1]),
            _ => GuardValue::new(x[1], self.derivative(touched, x, &())[1]),
        }
    }
}

impl Resets for FeltPenetration {
    fn reset(&self, _touched: bool, guard: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        Reset::to(guard.0 != 0, *x)
    }
}

impl Energetic for FeltPenetration {
    fn energy(&self, touched: bool, x: &[f64; 2], (): &()) -> f64 {
        let n = POWER + 1.0;
        let felt = if touched { self.k * x[0].max(0.0).powf(n) / n } else { 0.0 };
        0.5 * MASS * x[1] * x[1] + felt
    }

    fn supplied(&self, _touched: bool, _x: &[f64; 2], (): &()) -> f64 {
        0.0
    }

    fn dissipated(&self, touched: bool, x: &[f64; 2], (): &()) -> f64 {
        if touched { self.k * x[0].max(0.0).powf(POWER) * LOSS * x[1] * x[1] } else { 0.0 }
    }
}

#[derive(Debug)]
pub(super) struct FeltScenario {
    known: ContactRecord,
    reference: Reference<FeltPenetration>,
}

impl FeltScenario {
    fn new(known: ContactRecord) -> Self {
        let [deepest, exit] = known.times;
        let event = |t, guard: &str, to| ExpectedEvent { t, guard: guard.to_owned(), to };
        let events = vec![event(deepest, "deepest", true), event(exit, "leave", false)];
        let (until, row) = known.span;
        let flight = |t: f64| ([EXIT * (t - exit), EXIT], MASS * (SPEED - EXIT));
        let after = |t: f64| (t > exit).then_some(flight(t));
        // The time in contact has no closed form.
        let samples = Reference::<FeltPenetration>::samples((row, until), 0.1 * MS, &[exit], after);
        let reference =
            Reference { events, is_whole: true, rest: None, names: Vec::new(), samples };
        Self { known, reference }
    }
}

impl Scenario for FeltScenario {
    type Model = FeltPenetration;

    fn plan(&self) -> Plan {
        let ContactRecord { span: (until, row), ticks, .. } = self.known;
        Plan {
            until,
            ticks,
            offline_tick: row,
            felt: Figure::Impulse,
            order_bound: Some(POWER + 1.0),
            ..Plan::EXACT
        }
    }

    fn start(&self) -> (FeltPenetration, bool, [f64; 2]) {
        (self.known.felt, true, [0.0, SPEED])
    }

    fn input(&self, _t: f64) {}

    fn reference(&self) -> &Reference<FeltPenetration> {
        &self.reference
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// u − ln u over λ², plus k xⁿ⁺¹/(m (n + 1)).
    fn invariant(k: f64, x: f64, v: f64) -> f64 {
        let (u, n) = (1.0 + LOSS * v, POWER + 1.0);
        (u - u.ln()) / (LOSS * LOSS) + k * x.powf(n) / (MASS * n)
    }

    #[test]
    fn entry_deepest_point_and_exit_have_the_same_invariant() {
        for (k, depth) in [(1e5, 0.001_521_344_239_131_188_8), (1e7, 0.000_241_116_812_798_895_35)]
        {
            let entry = invariant(k, 0.0, SPEED);
            assert!((invariant(k, depth, 0.0) - entry).abs() < 1e-14, "k {k}");
            assert!((invariant(k, 0.0, EXIT) - entry).abs() < 1e-14, "k {k}");
        }
    }
}
