//! The bouncing ball's equations, by hand, in the form that generated ones will take.

use pode::{
    Enclosure, Energetic, EquationKind, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Model,
    Motion, Nature, Part, Reset, Resets, Settling, Sloped,
};

use super::{BouncingBall, Mode};
use crate::impact::{Meeting, Parting};

const FLOOR: GuardId = GuardId(0);

const FLIGHT: [GuardSpec; 1] = [GuardSpec::new(0, "floor")];
/// Of the size of gravity.
const REST: [GuardSpec; 1] = [GuardSpec::new(1, "lift").scaled(10.0)];

impl BouncingBall {
    /// Force of the ball on the floor, downwards (N): m (g + s'') at rest.
    pub(super) fn contact(&self, mode: Mode, s: &Motion) -> f64 {
        match mode {
            Mode::Flight => 0.0,
            Mode::Rest => self.mass * (self.g + s.acceleration),
        }
    }

    /// v⁺ = s' − e (v − s'), with the ball exactly on the floor.
    fn meet_floor(&self, v: f64, s: &Motion) -> Reset<Self> {
        let closing = s.rate - v;
        let pressing = self.g + s.acceleration;
        let meeting = Meeting { closing, pressing, restitution: self.restitution };
        match meeting.part() {
            Parting::Already => Reset::to(Mode::Flight, [s.position, v]),
            Parting::Together => {
                // Negative after a hop that was too low to see: what it got is taken back.
                Reset::to(Mode::Rest, [s.position, s.rate]).with_impulse(self.mass * closing)
            }
            Parting::Rebound { speed, settles } => {
                let reset = Reset::to(Mode::Flight, [s.position, s.rate + speed])
                    .with_impulse(self.mass * (closing + speed));
                settles.map_or(reset, |after| reset.settling(self.settling(speed, after, s)))
            }
        }
    }

    /// The rest that a rebound at `speed` comes to `after` (s), on the moving floor.
    fn settling(&self, speed: f64, after: f64, s: &Motion) -> Settling<Self> {
        let e = self.restitution;
        let rate = s.rate + after * s.acceleration;
        Settling {
            after,
            ratio: e,
            mode: Mode::Rest,
            state: [s.position + 0.5 * after * (s.rate + rate), rate],
            impulse: self.mass * speed * (1.0 + e) / (1.0 - e),
        }
    }
}

impl Model for BouncingBall {
    type Mode = Mode;
    type State = [f64; 2];
    type Input = Motion;
    const COORDS: usize = 1;

    /// At rest the ball goes where the floor goes.
    fn parts(&self, mode: Mode) -> &[Part] {
        match mode {
            Mode::Flight => &[Part::WHOLE],
            Mode::Rest => &[],
        }
    }

    fn derivative(&self, _mode: Mode, x: &[f64; 2], _s: &Motion) -> [f64; 2] {
        [x[1], -self.g]
    }

    /// A parabola in flight; the floor's own motion on it.
    fn nature(&self, mode: Mode) -> Nature {
        let kind = match mode {
            Mode::Flight => EquationKind::Affine,
            Mode::Rest => EquationKind::Linear,
        };
        Nature::new(kind, 0.0)
    }

    fn readout(&self, mode: Mode, _x: &[f64; 2], s: &Motion) -> f64 {
        self.contact(mode, s)
    }

    fn constrain(&self, mode: Mode, x: &[f64; 2], s: &Motion) -> [f64; 2] {
        match mode {
            Mode::Flight => *x,
            Mode::Rest => [s.position, s.rate],
        }
    }

    /// 2 mm of the key: noise of 0.1 mm moves the landing by a tenth of that.
    fn longest_projection(&self, mode: Mode) -> f64 {
        match mode {
            Mode::Flight => f64::INFINITY,
            Mode::Rest => 2e-3 * self.scale.abs().max(1.0),
        }
    }
}

impl Guarded for BouncingBall {
    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        match mode {
            Mode::Flight => &FLIGHT,
            Mode::Rest => &REST,
        }
    }

    #[inline]
    fn guard_bound(
        &self,
        _mode: Mode,
        guard: GuardId,
        over: &Enclosure<[f64; 2], Motion>,
    ) -> GuardBound {
        match guard {
            FLOOR => over.entry(0).plus(over.position()),
            _ => over.acceleration(),
        }
    }

    fn guard(&self, _mode: Mode, guard: GuardId, x: &[f64; 2], s: &Motion) -> GuardValue {
        match guard {
            FLOOR => GuardValue::new(x[0] - s.position, x[1] - s.rate),
            _ => GuardValue::new(self.g + s.acceleration, s.jerk),
        }
    }
}

impl Resets for BouncingBall {
    /// The floor throws the ball back; lifting keeps the state.
    fn reset(&self, _mode: Mode, guard: GuardId, x: &[f64; 2], s: &Motion) -> Reset<Self> {
        match guard {
            FLOOR => self.meet_floor(x[1], s),
            _ => Reset::to(Mode::Flight, *x),
        }
    }
}

impl Energetic for BouncingBall {
    fn energy(&self, _mode: Mode, x: &[f64; 2], _s: &Motion) -> f64 {
        self.mass * (0.5 * x[1] * x[1] + self.g * x[0])
    }

    fn supplied(&self, mode: Mode, _x: &[f64; 2], s: &Motion) -> f64 {
        self.contact(mode, s) * s.rate
    }
}

impl Sloped for BouncingBall {}
