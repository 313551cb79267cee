//! Where the energy of a simulation came from and where it went.

use crate::input::Signal;
use crate::model::Model;
use crate::watch::{Event, Piece, Watch};

/// A model that can account for its energy.
pub trait Energetic: Model {
    /// Energy stored in `x` (J).
    fn energy(&self, mode: Self::Mode, x: &Self::State, input: &Self::Input) -> f64;

    /// Power that whoever drives the input puts in (W).
    fn supplied(&self, mode: Self::Mode, x: &Self::State, input: &Self::Input) -> f64;

    /// Power that dampers and friction take (W).
    fn dissipated(&self, _mode: Self::Mode, _x: &Self::State, _input: &Self::Input) -> f64 {
        0.0
    }
}

/// Sums of energy (J) since the start: supplied − dissipated + jumps = stored.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct EnergyAudit {
    /// Work done by whoever drives the input.
    pub supplied: f64,
    /// Taken by dampers and friction.
    pub dissipated: f64,
    /// Change at events: what impacts took (negative) or reset maps added.
    pub jumps: f64,
    /// Change of the stored energy, over pieces and events.
    pub stored: f64,
}

impl EnergyAudit {
    /// What the sums leave unexplained: the integration error, as energy (J).
    pub fn residual(&self) -> f64 {
        self.stored - (self.supplied - self.dissipated + self.jumps)
    }

    /// Adds another audit's sums.
    pub fn add(&mut self, other: &Self) {
        self.supplied += other.supplied;
        self.dissipated += other.dissipated;
        self.jumps += other.jumps;
        self.stored += other.stored;
    }
}

impl<M: Energetic> Watch<M> for EnergyAudit {
    fn piece<S: Signal<M::Input>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        let [start, middle, end] = [0.0, 0.5, 1.0].map(|part| {
            let (x, input) = piece.at(part);
            (model.constrain(piece.mode, &x, &input), input)
        });
        // Simpson's rule, of the dense output's own order.
        let mean = |power: &dyn Fn(&M::State, &M::Input) -> f64| {
            (power(&start.0, &start.1) + 4.0 * power(&middle.0, &middle.1) + power(&end.0, &end.1))
                / 6.0
        };
        let mode = piece.mode;
        let h = piece.duration();
        self.supplied += h * mean(&|x, u| model.supplied(mode, x, u));
        self.dissipated += h * mean(&|x, u| model.dissipated(mode, x, u));
        self.stored +=
            model.energy(mode, &piece.end, &end.1) - model.energy(mode, &start.0, &start.1);
    }

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        let energy = |(mode, x): &(M::Mode, M::State)| model.energy(*mode, x, &event.input);
        let jump = energy(&event.after) - energy(&event.before);
        self.jumps += jump;
        self.stored += jump;
    }
}
