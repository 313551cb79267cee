//! A derived system beside the model that was written by hand.

use models::{Described, ModeCode};
use pode::{Guarded, Motion};

use crate::evaluation::{Derived, close};

/// How closely both agree, relative to the value.
const AGREEMENT: f64 = 1e-12;

/// A model by hand and what was derived, with modes in the same order.
pub(crate) struct Pair<M> {
    pub(crate) hand: M,
    pub(crate) derived: Derived,
    /// Energy that is counted here and not by hand (J).
    pub(crate) more_energy: f64,
}

pub(crate) fn motion(input: [f64; 4]) -> Motion {
    let [position, rate, acceleration, jerk] = input;
    Motion { position, rate, acceleration, jerk }
}

impl<M, const N: usize> Pair<M>
where
    M: Described
        + pode::Model<State = [f64; N], Input = Motion>
        + Guarded
        + pode::Resets
        + pode::Energetic,
{
    /// The mode by hand with this number.
    fn mode(&self, number: usize) -> M::Mode {
        let code = u8::try_from(number).map(ModeCode::structural).expect("few modes");
        self.hand.mode(code).expect("a mode with this number")
    }

    /// Compares the entries that move by equations, readout, guards, energy and power.
    pub(crate) fn compare(&self, mode: usize, x: &[f64; N], input: [f64; 4]) {
        let (m, s) = (self.mode(mode), motion(input));
        let equations = &self.derived.system.modes[mode];
        let what = |of: &str| {
            format!("{of} in {} at {x:?}, {input:?}", self.hand.entry().modes[mode].name)
        };
        let found = self.derived.derivative(mode, x, input);
        let expected = self.hand.derivative(m, x, &s);
        for i in (0..N).filter(|i| equations.is_free[*i]) {
            close(found[i], expected[i], AGREEMENT, &what(&format!("derivative {i}")));
        }
        let one =
            |node: Option<kane::graph::Node>| self.derived.one(node.expect("derived"), x, input);
        close(one(equations.readout), self.hand.readout(m, x, &s), AGREEMENT, &what("readout"));
        let energy = self.hand.energy(m, x, &s) + self.more_energy;
        close(one(equations.energy), energy, AGREEMENT, &what("energy"));
        close(one(equations.supplied), self.hand.supplied(m, x, &s), AGREEMENT, &what("supplied"));
        let lost = self.hand.dissipated(m, x, &s);
        close(one(equations.dissipated), lost, AGREEMENT, &what("dissipated"));
        let guards = self.hand.guards(m);
        assert_eq!(guards.len(), equations.guards.len());
        for (guard, spec) in equations.guards.iter().zip(guards) {
            let found = self.derived.all(&[guard.value, guard.rate], x, input);
            let expected = self.hand.guard(m, spec.id, x, &s);
            close(found[0], expected.value, AGREEMENT, &what(&guard.name));
            close(found[1], expected.rate, AGREEMENT, &what(&format!("{}'s rate", guard.name)));
        }
    }

    /// Compares the state after a guard's first way, and the impulse on the input.
    pub(crate) fn compare_reset(&self, mode: usize, guard: usize, x: &[f64; N], input: [f64; 4]) {
        let (m, s) = (self.mode(mode), motion(input));
        let spec = self.hand.guards(m)[guard];
        let expected = self.hand.reset(m, spec.id, x, &s);
        let way = &self.derived.system.modes[mode].guards[guard].ways[0];
        let found = self.derived.all(&way.state, x, input);
        let what = format!("reset at {x:?}, {input:?}");
        for (found, expected) in found.iter().zip(expected.state) {
            close(*found, expected, AGREEMENT, &what);
        }
        close(self.derived.one(way.impulse, x, input), expected.impulse, AGREEMENT, "impulse");
    }
}
