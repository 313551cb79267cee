//! One key with its encoder, its motor and the finger that plays it.

use super::encoder::Encoder;
use super::felt::Felt;
use super::finger::{Finger, FingerParameters, Grasp, HandCommand};
use super::gesture::{Gesture, MuscleCommand};
use super::key::{KeyFront, KeyParameters};
use super::motor::{Motor, MotorParameters};

/// Longest substep (s): a hundredth of the fastest oscillation's period, 45 g on a felt.
pub const MAX_SUBSTEP: f64 = 50e-6;

/// Maximum substeps of a tick: ticks up to 20 ms keep to [`MAX_SUBSTEP`].
pub const MAX_SUBSTEPS: u32 = 400;

/// Slack against rounding when a tick is a whole number of substeps.
const SUBSTEP_SLACK: f64 = 1e-9;

/// Constants of a [`KeyRig`]; the default is the playable simulated keybed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigParameters {
    pub key: KeyParameters,
    pub motor: MotorParameters,
    pub finger: FingerParameters,
    /// Displacement per encoder count (m).
    pub quantum: f64,
}

impl RigParameters {
    /// Rig of the paper's section 6 `[GC93]`: an encoder of 50 lines an inch (3 inches for 45
    /// degrees), voice coils, a hand that grips the key. The rest is estimated (E).
    pub const PAPER: Self = Self {
        // E: a coil, its carriage and a grip on linear bearings.
        key: KeyParameters {
            mass: 0.15,
            // E: bearings, and eddy currents in the coil's former.
            damping: 30.0,
            coulomb: 0.2,
            stiction: 0.25,
            weight: 0.0,
            // E: rubber.
            rest_stop: Felt { position: 0.0, stiffness: 20e3, damping: 30.0 },
            bottom_stop: Felt { position: 76.2e-3, stiffness: 20e3, damping: 30.0 },
        },
        // E: a voice coil as a large disk drive has it, and its amplifier.
        motor: MotorParameters {
            limit: 40.0,
            bandwidth: core::f64::consts::TAU * 100.0,
            delay_steps: 0,
        },
        finger: FingerParameters::GRIP,
        quantum: 25.4e-3 / 50.0,
    };
}

impl Default for RigParameters {
    /// Confidence as in piano-facts: S read in a secondary source, C computed, E estimated.
    fn default() -> Self {
        let felt = |position| Felt {
            position,
            // E: key-bottom felt 30–100 kN/m.
            stiffness: 60e3,
            // E: a rebound of about 0.4 of the speed.
            damping: 30.0,
        };
        Self {
            key: KeyParameters {
                // E: key stick of 2.7e-3 kg m² at 0.2595 m from the balance rail. With 35 g,
                // grand-springs at 500 Hz and grand-reduced at 4 kHz (slow filter) make energy.
                mass: 0.040,
                // E: eddy-current damper, so that a 1 kHz loop can hold 2 b / T = 2 kN/m.
                damping: 1.0,
                // S: a real key's friction is 0.118 N; ours should not add more.
                coulomb: 0.10,
                stiction: 0.12,
                // E: a return spring. Under 0.2, 0.35 and 0.5 N of the motor the key rises, from
                // its bottom to 1 mm below its rest, in 49, 41 and 36 ms; a real one takes 30 to 45
                // (S: 35). Under the grands' models it takes 75 to 120. With 0.4 N it takes a tenth
                // less, but the paper's undamped springs then strike with no finger at the keys.
                weight: 0.3,
                // Position 0 under the return spring.
                rest_stop: felt(0.3 / 60e3),
                // S: key dip 9.9–10.7 mm.
                bottom_stop: felt(10.16e-3),
            },
            motor: MotorParameters {
                // E: above the 15–20 N of a forte.
                limit: 30.0,
                // E: a current loop of 1 kHz.
                bandwidth: core::f64::consts::TAU * 1e3,
                delay_steps: 0,
            },
            finger: FingerParameters::ORDINARY,
            // E: one count per 1 ms is 1 mm/s, a twentieth of the softest stroke; and walls
            // up to 2 f / Δ = 200 kN/m stay quiet in friction [AO05], above the felts.
            quantum: 1e-6,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Playing {
    Nothing,
    /// A gesture with its start (s).
    Gesture(f64),
    Path,
    Hand,
}

/// A simulated key under a finger and a force, stepped tick by tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeyRig {
    key: KeyFront,
    encoder: Encoder,
    motor: Motor,
    finger: Finger,
    /// Parameters of the finger without a hand.
    own: FingerParameters,
    /// Target of a hand (m).
    held: Option<f64>,
    playing: Playing,
    /// Force between finger and key (N).
    contact: f64,
    /// Force of a weight on the key's front (N).
    weight: f64,
}

impl KeyRig {
    /// Creates a rig at rest: key up, no force, no finger.
    ///
    /// # Panics
    /// Unless the encoder's quantum is finite and positive.
    pub fn new(parameters: RigParameters) -> Self {
        Self {
            key: KeyFront::new(parameters.key),
            encoder: Encoder::new(parameters.quantum),
            motor: Motor::new(parameters.motor),
            finger: Finger::new(parameters.finger),
            own: parameters.finger,
            held: None,
            playing: Playing::Nothing,
            contact: 0.0,
            weight: 0.0,
        }
    }

    /// Advances by one tick, from `t` to `t + h` (s), with `force` (N) on the finger, up positive.
    ///
    /// The finger is present while `gesture` is active; one with another start places a new finger
    /// at its command. An invalid `h` only sets the force.
    ///
    /// # Real-time
    /// One substep per [`MAX_SUBSTEP`] or part of it in `h`, at most [`MAX_SUBSTEPS`].
    pub fn advance(&mut self, t: f64, h: f64, force: f64, gesture: Option<&Gesture>) {
        self.tick((t, h), force, |rig, t, h| match (rig.held, gesture) {
            (Some(place), _) => rig.lead_hand(h, place),
            (None, Some(gesture)) if gesture.is_active(t) => rig.play(t, h, gesture),
            (None, _) => rig.rest(),
        });
    }

    /// Grips the key with a hand from now on and leads it to `place` (m, down positive), up to
    /// twice the dip from its rest, without gestures. Without a finite `place` the hand lets go.
    fn hold(&mut self, place: Option<f64>) {
        let most = 2.0 * self.dip();
        let place = place.filter(|it| it.is_finite()).map(|it| it.clamp(-most, most));
        if place.is_some() != self.held.is_some() {
            let hand =
                if self.own.grasp == Grasp::Grips { self.own } else { FingerParameters::GRIP };
            self.finger = Finger::new(if place.is_some() { hand } else { self.own });
            self.playing = Playing::Nothing;
        }
        self.held = place;
    }

    /// Like [`Self::advance`], but with the muscle commanded by `path`, a function of time (s). Any
    /// other finger lets go, and this finger is placed on the path.
    ///
    /// # Real-time
    /// As [`Self::advance`], with at most two calls of `path` per substep.
    pub fn follow(&mut self, t: f64, h: f64, force: f64, path: impl Fn(f64) -> MuscleCommand) {
        self.tick((t, h), force, |rig, t, h| rig.lead(t, h, &path));
    }

    /// Replaces the hand's command from now on.
    pub fn command(&mut self, hand: HandCommand) {
        let (newtons, place) = match hand {
            HandCommand::Weight(newtons) => (newtons, None),
            HandCommand::Grip(depth) => (0.0, Some(depth * self.dip())),
        };
        self.lay(newtons);
        self.hold(place);
    }

    /// Lays a weight of `newtons` on the key's front; 0, and any invalid force, removes it.
    pub fn lay(&mut self, newtons: f64) {
        self.weight = if newtons.is_finite() { newtons.max(0.0) } else { 0.0 };
    }

    pub fn counts(&self) -> i32 {
        self.encoder.counts(self.key.position())
    }

    /// Returns the displacement per count (m).
    pub const fn quantum(&self) -> f64 {
        self.encoder.quantum()
    }

    /// Returns the travel of the key's front from rest to bottom (m).
    pub const fn dip(&self) -> f64 {
        self.key.dip()
    }

    /// Returns the true position of the key's front (m), down positive.
    pub const fn position(&self) -> f64 {
        self.key.position()
    }

    /// Returns the true velocity of the key's front (m/s).
    pub const fn velocity(&self) -> f64 {
        self.key.velocity()
    }

    /// Returns the force of the motor on the key (N), up positive.
    pub const fn motor_force(&self) -> f64 {
        self.motor.force()
    }

    /// Returns the force of the key on the finger (N), up positive; negative only in a grip.
    pub const fn finger_force(&self) -> f64 {
        self.contact
    }

    /// Returns `true` if nothing moves: key stuck, motor settled, no finger. Then [`Self::advance`]
    /// with the same force and no active gesture changes nothing, and may be skipped.
    pub fn is_still(&self) -> bool {
        self.playing == Playing::Nothing
            && self.held.is_none()
            && self.motor.is_settled()
            && self.key.holds(self.motor.force() - self.weight)
    }

    /// Runs one tick from `t` over `h` (s); `touch` moves the finger and returns its force (N).
    fn tick(&mut self, (t, h): (f64, f64), force: f64, touch: impl Fn(&mut Self, f64, f64) -> f64) {
        self.motor.command(force);
        if !h.is_finite() || h <= 0.0 {
            return;
        }
        let substeps = substeps(h);
        let substep = h / f64::from(substeps);
        for i in 0..substeps {
            let finger = touch(self, t + f64::from(i) * substep, substep);
            self.contact = finger + self.weight;
            let motor = self.motor.step(substep);
            self.key.step(motor - self.contact, substep);
        }
    }

    fn play(&mut self, t: f64, h: f64, gesture: &Gesture) -> f64 {
        let is_here =
            matches!(self.playing, Playing::Gesture(start) if start - gesture.start == 0.0);
        if !is_here {
            self.playing = Playing::Gesture(gesture.start);
            self.finger.place(gesture.command(t), gesture.speed);
        }
        self.press(h, gesture.command(t + h))
    }

    fn lead(&mut self, t: f64, h: f64, path: impl Fn(f64) -> MuscleCommand) -> f64 {
        if self.playing != Playing::Path {
            self.playing = Playing::Path;
            self.finger.place(path(t), 0.0);
        }
        self.press(h, path(t + h))
    }

    /// Moves the hand towards `place` (m); returns the force on the key (N).
    fn lead_hand(&mut self, h: f64, place: f64) -> f64 {
        if self.playing != Playing::Hand {
            self.playing = Playing::Hand;
            let here = MuscleCommand { position: self.key.position(), velocity: 0.0 };
            self.finger.place(here, 0.0);
        }
        self.press(h, MuscleCommand { position: place, velocity: 0.0 })
    }

    /// Moves the finger over `h` (s) to its command at the end; returns the contact force (N).
    fn press(&mut self, h: f64, command: MuscleCommand) -> f64 {
        let contact = self.finger.contact(self.key.position(), self.key.velocity());
        self.finger.step(command.position, command.velocity, contact, h);
        contact
    }

    fn rest(&mut self) -> f64 {
        if self.playing != Playing::Nothing {
            self.playing = Playing::Nothing;
            self.finger.leave();
        }
        0.0
    }
}

/// Returns the substeps of a tick of `h` (s), in `1 ..= MAX_SUBSTEPS`.
fn substeps(h: f64) -> u32 {
    let wanted = (h / MAX_SUBSTEP - SUBSTEP_SLACK).ceil().clamp(1.0, f64::from(MAX_SUBSTEPS));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped above")]
    let substeps = wanted as u32;
    substeps
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_weight_presses_the_key_down_until_it_is_taken_away() {
        let mut rig = KeyRig::new(RigParameters::default());
        let live = |rig: &mut KeyRig, ticks: u32| {
            for tick in 0..ticks {
                rig.advance(f64::from(tick) * 1e-3, 1e-3, 0.4, None);
            }
        };
        live(&mut rig, 200);
        let up = rig.position();
        rig.lay(3.0);
        live(&mut rig, 1000);
        assert!(rig.position() - up > 8e-3, "the key lies on its bed: {}", rig.position());
        assert!((rig.finger_force() - 3.0).abs() < 1e-12 && rig.is_still());
        rig.lay(0.0);
        live(&mut rig, 1000);
        assert!((rig.position() - up).abs() < 1e-4, "{}", rig.position());
        rig.lay(f64::NAN);
        live(&mut rig, 10);
        assert!(rig.position().is_finite());
    }

    #[test]
    fn a_hand_leads_a_key_down_and_up_against_a_force_and_lets_go() {
        let mut rig = KeyRig::new(RigParameters::default());
        let live = |rig: &mut KeyRig, force: f64| {
            for tick in 0..1000 {
                rig.advance(f64::from(tick) * 1e-3, 1e-3, force, None);
            }
            rig.position()
        };
        let up = live(&mut rig, 0.0);
        rig.hold(Some(4e-3));
        // Muscle and pulp each give way by the force over their stiffness.
        let FingerParameters { stiffness, pulp_stiffness, .. } = FingerParameters::GRIP;
        let parameters = RigParameters::default().key;
        for force in [3.0, -3.0] {
            let given = (force + parameters.weight) * (1.0 / stiffness + 1.0 / pulp_stiffness);
            let stuck = parameters.stiction * (1.0 / stiffness + 1.0 / pulp_stiffness);
            let place = live(&mut rig, force);
            assert!((place - (4e-3 - given)).abs() <= stuck, "{place} under {force}");
        }
        rig.hold(Some(f64::INFINITY));
        assert!((live(&mut rig, 0.0) - up).abs() < 1e-4 && rig.is_still(), "it was let go");
    }

    #[test]
    fn a_tick_has_no_more_substeps_than_it_needs() {
        for (h, count) in [(1e-3, 20), (5e-4, 10), (1e-4, 2), (5e-5, 1), (1e-6, 1), (1.01e-4, 3)] {
            assert_eq!(substeps(h), count, "{h}");
        }
        assert_eq!(substeps(1.0), MAX_SUBSTEPS);
    }
}
