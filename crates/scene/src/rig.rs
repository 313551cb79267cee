//! `[rig]`: the physical parameters of the keys, and the finger that plays them.

use haptics::RigParameters;
use haptics::plant::{
    Felt, FingerParameters, KeyParameters, MAX_DELAY_STEPS, MAX_SUBSTEP, MotorParameters,
};

use super::quantity::Quantity;
use super::read::TableReader;
use super::setting::{NamedValues, TableSetting as _, settings};
use documents::toml::FindingList;

const WAY: Quantity = Quantity { unit: "m", range: (1e-3, 0.2) };
const MASS: Quantity = Quantity { unit: "kg", range: (1e-3, 10.0) };
const DAMPING: Quantity = Quantity { unit: "N·s/m", range: (0.0, 1e3) };
const FRICTION: Quantity = Quantity { unit: "N", range: (0.0, 20.0) };
const RETURN: Quantity = Quantity { unit: "N", range: (-20.0, 20.0) };
const FELT: Quantity = Quantity { unit: "N/m", range: (100.0, 1e6) };
/// Below a nanometre a step is noise; a centimetre is a key's whole travel.
const ENCODER_STEP: Quantity = Quantity { unit: "m", range: (1e-9, 1e-2) };
const MOTOR_LIMIT: Quantity = Quantity { unit: "N", range: (0.1, 1e3) };
const BANDWIDTH: Quantity = Quantity { unit: "Hz", range: (1.0, 1e5) };
const DELAY: Quantity = Quantity { unit: "s", range: (0.0, MAX_DELAY_STEPS as f64 * MAX_SUBSTEP) };

const FINGERS: NamedValues<FingerName> = NamedValues {
    refusal: "there is no finger",
    all: || FingerName::ALL.map(|all| (all.name(), all)).into(),
};

const KINDS: NamedValues<RigKind> = NamedValues {
    refusal: "there is no rig",
    all: || vec![("keybed", RigKind::Keybed), ("paper", RigKind::Paper)],
};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum RigKind {
    Keybed,
    /// Apparatus of the paper's section 6.
    Paper,
}

/// Extreme of the fingers' parameters.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FingerName {
    Ordinary,
    Stiff,
    Limp,
    /// Hand that holds the key on both sides.
    Grip,
}

impl FingerName {
    const ALL: [Self; 4] = [Self::Ordinary, Self::Stiff, Self::Limp, Self::Grip];

    const fn name(self) -> &'static str {
        match self {
            Self::Ordinary => "ordinary",
            Self::Stiff => "stiff",
            Self::Limp => "limp",
            Self::Grip => "grip",
        }
    }

    const fn parameters(self) -> FingerParameters {
        match self {
            Self::Ordinary => FingerParameters::ORDINARY,
            Self::Stiff => FingerParameters::STIFF,
            Self::Limp => FingerParameters::LIMP,
            Self::Grip => FingerParameters::GRIP,
        }
    }
}

settings! {
    /// Parameters of a key, its encoder, its motor and the finger on it.
    ///
    /// Simulated keys have them; for keys on boards the estimator and predictions assume them.
    pub struct Rig;
    /// Travel of the key front from rest to bottom (m).
    dip: f64 = usual().key.bottom_stop.position, WAY;
    /// Moving mass at the front (kg).
    mass: f64 = usual().key.mass, MASS;
    /// Viscous damping (N s/m).
    damping: f64 = usual().key.damping, DAMPING;
    /// Friction while the key moves (N).
    friction: f64 = usual().key.coulomb, FRICTION;
    /// Friction that holds the key at rest (N); at least `friction` is used.
    stiction: f64 = usual().key.stiction, FRICTION;
    /// Force that brings the key up (N).
    return_force: f64 = usual().key.weight, RETURN;
    /// Stiffness of the felts at both ends (N/m).
    felt_stiffness: f64 = usual().key.bottom_stop.stiffness, FELT;
    /// Damping of the felts (N s/m).
    felt_damping: f64 = usual().key.bottom_stop.damping, DAMPING;
    /// Travel of one count (m).
    encoder_step: f64 = usual().quantum, ENCODER_STEP;
    /// Largest force of the motor (N).
    motor_limit: f64 = usual().motor.limit, MOTOR_LIMIT;
    /// Bandwidth of the motor's current loop (Hz).
    motor_bandwidth: f64 = usual().motor.bandwidth / core::f64::consts::TAU, BANDWIDTH;
    /// Time from a force's arrival to its effect (s).
    delay: f64 = 0.0, DELAY;
    finger: FingerName = FingerName::Ordinary, FINGERS;
}

fn usual() -> RigParameters {
    RigParameters::default()
}

impl Rig {
    pub const fn paper() -> Self {
        let RigParameters { key, motor, quantum, .. } = RigParameters::PAPER;
        Self {
            dip: key.bottom_stop.position,
            mass: key.mass,
            damping: key.damping,
            friction: key.coulomb,
            stiction: key.stiction,
            return_force: key.weight,
            felt_stiffness: key.bottom_stop.stiffness,
            felt_damping: key.bottom_stop.damping,
            encoder_step: quantum,
            motor_limit: motor.limit,
            motor_bandwidth: motor.bandwidth / core::f64::consts::TAU,
            delay: 0.0,
            finger: FingerName::Grip,
        }
    }

    pub fn parameters(&self) -> RigParameters {
        let felt = |position| Felt {
            position,
            stiffness: self.felt_stiffness,
            damping: self.felt_damping,
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 160")]
        let delay_steps = (self.delay / MAX_SUBSTEP).round() as usize;
        RigParameters {
            key: KeyParameters {
                mass: self.mass,
                damping: self.damping,
                coulomb: self.friction,
                stiction: self.stiction,
                weight: self.return_force,
                // The rest position at which the return force leaves the key at 0.
                rest_stop: felt(self.return_force.max(0.0) / self.felt_stiffness),
                bottom_stop: felt(self.dip),
            },
            motor: MotorParameters {
                limit: self.motor_limit,
                bandwidth: core::f64::consts::TAU * self.motor_bandwidth,
                delay_steps,
            },
            finger: self.finger.parameters(),
            quantum: self.encoder_step,
        }
    }
}

/// Reads the table `rig`, with the usual keybed for missing entries.
pub(super) fn read(report: &mut FindingList, scene: &mut TableReader<'_>) -> Rig {
    let Some(mut reader) = scene.table(report, "rig") else { return Rig::default() };
    let mut rig = match KINDS.read(report, &mut reader, "kind") {
        Some(RigKind::Paper) => Rig::paper(),
        Some(RigKind::Keybed) | None => Rig::default(),
    };
    rig.read_all(report, &mut reader);
    reader.finish(report);
    rig
}
