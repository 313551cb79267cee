//! The spring wall's equations, by hand, in the form that generated ones will take.

use pode::{
    Enclosure, Energetic, EquationKind, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Model,
    Motion, Nature, Part, ReadoutSlopes, Reset, Resets, Sloped,
};

use super::{Mode, SpringWall};

const TOUCH: GuardId = GuardId(0);

const FREE: [GuardSpec; 1] = [GuardSpec::new(0, "touch")];
const CONTACT: [GuardSpec; 1] = [GuardSpec::new(1, "leave")];

impl SpringWall {
    /// How far the key is in the wall (m); negative before it.
    pub(super) fn depth(&self, s: &Motion) -> f64 {
        s.position - self.wall
    }

    /// K (s − wall) + B s' (N): never pulls.
    pub(super) fn force(&self, mode: Mode, s: &Motion) -> f64 {
        match mode {
            Mode::Free => 0.0,
            Mode::Contact => (self.stiffness * self.depth(s) + self.damping * s.rate).max(0.0),
        }
    }
}

impl Model for SpringWall {
    type Mode = Mode;
    type State = [f64; 0];
    type Input = Motion;
    const COORDS: usize = 0;

    /// Nothing moves but the key.
    fn parts(&self, _mode: Mode) -> &[Part] {
        &[]
    }

    fn derivative(&self, _mode: Mode, _x: &[f64; 0], _s: &Motion) -> [f64; 0] {
        []
    }

    fn nature(&self, _mode: Mode) -> Nature {
        Nature::new(EquationKind::Affine, 0.0)
    }

    fn readout(&self, mode: Mode, _x: &[f64; 0], s: &Motion) -> f64 {
        self.force(mode, s)
    }
}

impl Guarded for SpringWall {
    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        match mode {
            Mode::Free => &FREE,
            Mode::Contact => &CONTACT,
        }
    }

    /// Both guards go as far as the key.
    #[inline]
    fn guard_bound(
        &self,
        _mode: Mode,
        _guard: GuardId,
        over: &Enclosure<[f64; 0], Motion>,
    ) -> GuardBound {
        over.position()
    }

    fn guard(&self, _mode: Mode, guard: GuardId, _x: &[f64; 0], s: &Motion) -> GuardValue {
        let depth = self.depth(s);
        match guard {
            TOUCH => GuardValue::new(-depth, -s.rate),
            _ => GuardValue::new(depth, s.rate),
        }
    }
}

impl Resets for SpringWall {
    fn reset(&self, mode: Mode, _guard: GuardId, _x: &[f64; 0], _s: &Motion) -> Reset<Self> {
        let next = match mode {
            Mode::Free => Mode::Contact,
            Mode::Contact => Mode::Free,
        };
        Reset::to(next, [])
    }
}

impl Energetic for SpringWall {
    fn energy(&self, mode: Mode, _x: &[f64; 0], s: &Motion) -> f64 {
        let depth = self.depth(s);
        match mode {
            Mode::Free => 0.0,
            Mode::Contact => 0.5 * self.stiffness * depth * depth,
        }
    }

    fn supplied(&self, mode: Mode, _x: &[f64; 0], s: &Motion) -> f64 {
        self.force(mode, s) * s.rate
    }

    /// B s'², and what is left in the spring when the key is faster than it.
    fn dissipated(&self, mode: Mode, _x: &[f64; 0], s: &Motion) -> f64 {
        match mode {
            Mode::Free => 0.0,
            Mode::Contact => (self.force(mode, s) - self.stiffness * self.depth(s)) * s.rate,
        }
    }
}

impl Sloped for SpringWall {
    fn slopes(&self, mode: Mode, _x: &[f64; 0], s: &Motion) -> ReadoutSlopes {
        if self.force(mode, s) > 0.0 {
            ReadoutSlopes { per_position: self.stiffness, per_rate: self.damping }
        } else {
            ReadoutSlopes::default()
        }
    }
}
