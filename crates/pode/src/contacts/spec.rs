//! The constant description of a contact: names, sizes, and whether it has friction.

use crate::GuardId;

/// Most contacts and bearings with friction in one model.
pub const MAX_FRICTIONS: usize = 16;

/// One contact, or one bearing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ContactSpec {
    /// Its name in logs and files.
    pub name: &'static str,
    /// Typical size of the gap's terms (m), by which rounding is told from motion; none for
    /// a bearing, which never opens and has no guard for it.
    pub gap: Option<f64>,
    /// Its friction, if it has any.
    pub friction: Option<FrictionSpec>,
}

impl ContactSpec {
    /// A contact without friction; its gap has terms of size `scale` (m).
    pub const fn new(name: &'static str, scale: f64) -> Self {
        Self { name, gap: Some(scale), friction: None }
    }

    /// A friction that always acts, without a contact that opens.
    pub const fn bearing(name: &'static str, friction: FrictionSpec) -> Self {
        Self { name, gap: None, friction: Some(friction) }
    }

    /// The same contact with friction.
    #[must_use]
    pub const fn with_friction(self, friction: FrictionSpec) -> Self {
        Self { friction: Some(friction), ..self }
    }
}

/// The sizes of a friction, by which rounding is told from motion.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FrictionSpec {
    /// Its name in logs and files.
    pub name: &'static str,
    /// Typical size of the friction force's terms (N, or N m for a turning slip).
    pub force: f64,
    /// Typical size of the slip speed's terms (m/s, or rad/s).
    pub slip: f64,
    /// Largest jump of the slip speed, where the input jumps, that does not end a stick (m/s).
    ///
    /// An input that is put together from samples jumps a little at each tick, where the real
    /// one went on: say how much that can be.
    pub slack: f64,
}

impl FrictionSpec {
    /// A friction with forces of size `force` (N) and slip speeds of size `slip` (m/s); a jump
    /// of the slip speed by 1/64 of that is followed.
    pub const fn new(name: &'static str, force: f64, slip: f64) -> Self {
        Self { name, force, slip, slack: slip / 64.0 }
    }

    /// The same with another largest jump that a stick follows (m/s).
    #[must_use]
    pub const fn with_slack(self, slack: f64) -> Self {
        Self { slack, ..self }
    }

    /// A slip speed below this is zero where an event was located by it (m/s).
    pub(super) const fn located(&self) -> f64 {
        self.slip / 1_048_576.0
    }

    /// A slip speed below this is zero together with another one that is (m/s).
    pub(super) const fn same(&self) -> f64 {
        self.located() / 65_536.0
    }

    /// Rounding of the slip speed (m/s).
    pub(super) const fn rounding(&self) -> f64 {
        self.slip * f64::EPSILON
    }
}

/// Which part of a model a guard belongs to.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ContactGuard {
    /// A contact opens or closes.
    Gap(usize),
    /// A friction sticks or slips, by the number of its contact.
    Friction(usize),
    /// The structure's own guard.
    Structure(GuardId),
}

/// The first ids of frictions and of the structure; contacts come first.
pub(super) const FRICTIONS: u8 = 64;
pub(super) const STRUCTURE: u8 = 128;

impl ContactGuard {
    /// Returns what the guard `id` of a [`WithContacts`] belongs to.
    pub fn of(id: GuardId) -> Self {
        match id.0 {
            contact @ 0..FRICTIONS => Self::Gap(usize::from(contact)),
            friction @ FRICTIONS..STRUCTURE => Self::Friction(usize::from(friction - FRICTIONS)),
            guard @ STRUCTURE.. => Self::Structure(GuardId(guard - STRUCTURE)),
        }
    }
}
