//! The constant description of a contact: names, sizes, and its friction.

use crate::GuardId;

/// Maximum of contacts and bearings with friction in one model.
pub const MAX_FRICTIONS: usize = 16;

/// One contact, or one bearing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ContactSpec {
    pub name: &'static str,
    /// Typical size of the gap's terms (m), above rounding; `None` for a bearing.
    pub gap: Option<f64>,
    pub friction: Option<FrictionSpec>,
}

impl ContactSpec {
    /// Builds a contact without friction; its gap has terms of size `scale` (m).
    pub const fn new(name: &'static str, scale: f64) -> Self {
        Self { name, gap: Some(scale), friction: None }
    }

    /// Builds a friction that always acts, without a contact that opens.
    pub const fn bearing(name: &'static str, friction: FrictionSpec) -> Self {
        Self { name, gap: None, friction: Some(friction) }
    }

    #[must_use]
    pub const fn with_friction(self, friction: FrictionSpec) -> Self {
        Self { friction: Some(friction), ..self }
    }
}

/// Sizes of a friction, to distinguish motion from rounding.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FrictionSpec {
    pub name: &'static str,
    /// Typical size of the friction force's terms (N, or N m for a turning slip).
    pub force: f64,
    /// Typical size of the slip speed's terms (m/s, or rad/s).
    pub slip: f64,
    /// Largest jump of the slip speed, where the input jumps, that does not end a stick (m/s). An
    /// input built from samples jumps a little at each tick: declare its largest jump.
    pub slack: f64,
    pub kind: SlipKind,
}

/// Meaning of a slip.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SlipKind {
    /// A speed, from which the force takes power.
    Speed,
    /// The condition of a branch in the equations: the force is minus its sign, without power.
    Condition,
}

impl FrictionSpec {
    /// Builds a friction of sizes `force` (N) and `slip` (m/s); it follows jumps up to `slip`/64.
    pub const fn new(name: &'static str, force: f64, slip: f64) -> Self {
        Self { name, force, slip, slack: slip / 64.0, kind: SlipKind::Speed }
    }

    /// Builds a switch between two sets of equations by the sign of a condition of size `slip`.
    pub const fn switch(name: &'static str, slip: f64) -> Self {
        Self { kind: SlipKind::Condition, ..Self::new(name, 1.0, slip) }
    }

    /// Slip speed that counts as zero where an event was located by it (m/s).
    pub(super) const fn located(&self) -> f64 {
        self.slip / 1_048_576.0
    }

    /// Slip speed that counts as zero beside another one that is zero (m/s).
    pub(super) const fn same(&self) -> f64 {
        self.located() / 65_536.0
    }

    /// Rounding of the slip speed (m/s).
    pub(super) const fn rounding(&self) -> f64 {
        self.slip * f64::EPSILON
    }
}

/// Owner of a guard.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ContactGuard {
    Gap(usize),
    Friction(usize),
    Structure(GuardId),
}

/// First id of frictions, after the contacts; the structure's follow.
pub(super) const FRICTIONS: u8 = 64;
pub(super) const STRUCTURE: u8 = 128;

impl ContactGuard {
    pub fn of(id: GuardId) -> Self {
        match id.0 {
            contact @ 0..FRICTIONS => Self::Gap(usize::from(contact)),
            friction @ FRICTIONS..STRUCTURE => Self::Friction(usize::from(friction - FRICTIONS)),
            guard @ STRUCTURE.. => Self::Structure(GuardId(guard - STRUCTURE)),
        }
    }
}
