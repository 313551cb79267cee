//! A virtual coupling: a spring and a damper between the player's key and the model's.

use instruments::Playable;
use pode::input::Cubic;
use pode::{Motion, Signal as _};

/// Constants of a coupling at the key's front: stiffness (N/m) and damping (N s/m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CouplingConstants {
    pub stiffness: f64,
    pub damping: f64,
}

/// The key of a model, moved by a coupling instead of the player's key.
///
/// A model whose force follows its key's acceleration, such as rigid bodies, cannot be moved by
/// measured accelerations: the encoder's rounding would be felt as blows. So the model's key has
/// the model's inertia, and moves under the forces of coupling and model; the player feels the
/// coupling. A force that is passive for the coupling's end is passive for the player.
///
/// The virtual coupling of `[CSB95]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coupling {
    constants: CouplingConstants,
    /// Position of the model's key, and its rate (model input, 1/s of it).
    position: f64,
    rate: f64,
    /// Impulse of the last tick's events on the model's key (readout s).
    impulse: f64,
    /// Energy in the spring (J).
    stored: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CoupledTick {
    pub(crate) signal: Cubic,
    /// Force of the coupling (readout).
    pub(crate) force: f64,
    /// Increase of the spring's energy in the tick (J).
    pub(crate) stored: f64,
}

/// Minimum inertia of a model's key (readout per acceleration), so that it lags its coupling.
const LEAST_INERTIA: f64 = 1e-9;

impl Coupling {
    pub const fn new(constants: CouplingConstants) -> Self {
        Self { constants, position: 0.0, rate: 0.0, impulse: 0.0, stored: 0.0 }
    }

    pub const fn constants(&self) -> CouplingConstants {
        self.constants
    }

    pub(crate) const fn place(&mut self, key: &Motion) {
        let Motion { position, rate, .. } = *key;
        *self = Self { position, rate, ..Self::new(self.constants) };
    }

    pub(crate) fn succeed(&mut self, before: &Self) {
        // The same distance of the keys is another energy in another spring.
        let stiffer = self.constants.stiffness / before.constants.stiffness;
        *self = Self { constants: self.constants, stored: before.stored * stiffer, ..*before };
    }

    pub(crate) fn key(&self) -> Motion {
        Motion { position: self.position, rate: self.rate, ..Motion::default() }
    }

    /// Returns the energy in the spring (J).
    pub(crate) const fn stored(&self) -> f64 {
        self.stored
    }

    /// Records an event's impulse on the model's key (readout s).
    pub(crate) fn strike(&mut self, impulse: f64) {
        self.impulse += impulse;
    }

    /// Moves the model's key over a tick of `h` (s) in which the player's moves as `key`, at
    /// `scale` model inputs per metre. Evaluated at its end: stable for any stiffness.
    ///
    /// # Real-time
    /// Two readouts, one division or two.
    pub(crate) fn follow<M: Playable>(
        &mut self,
        (model, mode, state): (&M, M::Mode, &M::State),
        key: &Cubic,
        scale: f64,
        h: f64,
    ) -> CoupledTick {
        let at = |acceleration: f64| {
            let Self { position, rate, .. } = *self;
            model.readout(mode, state, &Motion { position, rate, acceleration, jerk: 0.0 })
        };
        let still = at(0.0);
        let inertia = (at(1.0) - still).max(LEAST_INERTIA);
        self.rate -= core::mem::take(&mut self.impulse) / inertia;
        let per_scale = 1.0 / (scale * scale);
        let (stiffness, damping) =
            (self.constants.stiffness * per_scale, self.constants.damping * per_scale);
        let end = key.at(1.0);
        let way = end.position - self.position - self.rate * h;
        let pull = stiffness * way + damping * (end.rate - self.rate);
        let acceleration = (pull - still) / (inertia + h * (damping + h * stiffness));
        let signal = Cubic::ballistic(self.position, self.rate, acceleration, h);
        self.rate += h * acceleration;
        self.position += h * self.rate - 0.5 * h * h * acceleration;
        let stretch = end.position - self.position;
        let before = core::mem::replace(&mut self.stored, 0.5 * stiffness * stretch * stretch);
        let force = still + inertia * acceleration;
        CoupledTick { signal, force, stored: self.stored - before }
    }
}
