//! Health of a board and its keys: polled once a second, key by key in turns.

use firmware_protocol::acyclic::Operation;
use firmware_protocol::acyclic::health::{BoardHealth, KeyHealth, MuteKey, ReadKeyHealth};
use firmware_protocol::acyclic::health::{NOT_MEASURED, key_fault};
use firmware_protocol::frame::hello::feature;
use firmware_protocol::key::MOST_KEYS;
use firmware_protocol::{Nothing, Record as _};

use crate::rt::{board::BoardStatistics, terms::BoardAgreement};
use crate::{periods::HEALTH_US, request_channel::RequestChannel};

#[derive(Clone, Copy, Debug)]
pub(super) struct HealthWatch {
    /// `true` if the board has the health feature.
    is_known: bool,
    n_keys: u8,
    /// Failed keys in its report, slot 0 in bit 0, and their causes.
    failed: u16,
    causes: [Option<u8>; MOST_KEYS],
    /// Keys with motors that the board was asked to switch off.
    muted: u16,
    /// Time of the next request (us), and its key.
    next_board: u64,
    next_key: u64,
    slot: u8,
    asked: u8,
    hottest: Option<i16>,
}

impl HealthWatch {
    pub(super) fn new(agreed: &BoardAgreement) -> Self {
        Self {
            is_known: agreed.features & feature::HEALTH != 0,
            n_keys: u8::try_from(agreed.place.n_keys).unwrap_or(u8::MAX),
            failed: 0,
            causes: [None; MOST_KEYS],
            muted: 0,
            next_board: 0,
            next_key: 0,
            slot: 0,
            asked: 0,
            hottest: None,
        }
    }

    pub(super) fn forget(&mut self) {
        (self.failed, self.muted) = (0, 0);
        self.causes = [None; MOST_KEYS];
    }

    /// Returns the hottest reported motor (0.1 °C).
    pub(super) const fn hottest(&self) -> Option<i16> {
        self.hottest
    }

    /// Returns `true` if the cause of every reported failure is known.
    pub(super) fn is_settled(&self) -> bool {
        self.unexplained().is_none()
    }

    /// Returns failed keys with their causes, one of [`key_fault`].
    pub(super) fn failed(&self) -> impl Iterator<Item = (usize, u8)> {
        let causes = self.causes.iter().enumerate();
        causes.filter_map(|(slot, cause)| {
            cause.filter(|_| self.failed >> slot & 1 == 1).map(|it| (slot, it))
        })
    }

    fn unexplained(&self) -> Option<u8> {
        (0..self.n_keys)
            .find(|slot| self.failed >> slot & 1 == 1 && self.causes[usize::from(*slot)].is_none())
    }

    /// Sends the request due at `now` (us) to an armed board; returns `true` if there is one.
    pub(super) fn ask(
        &mut self,
        now: u64,
        statistics: &BoardStatistics,
        channel: &mut RequestChannel,
    ) -> bool {
        if !self.is_known {
            return false;
        }
        let muted = statistics.keys.muted.iter().enumerate();
        let unwanted = muted.fold(0, |bits, (slot, it)| bits | u16::from(it.is_some()) << slot);
        let to_mute = unwanted & !self.muted;
        if let Some(slot) = self.unexplained() {
            self.ask_key(slot, channel);
        } else if to_mute != 0 {
            #[expect(clippy::cast_possible_truncation, reason = "below 16")]
            let slot = to_mute.trailing_zeros() as u8;
            self.asked = slot;
            channel.ask(Operation::MuteKey, &MuteKey { slot, muted: 1 });
        } else if self.next_board <= now {
            self.next_board = now + HEALTH_US;
            channel.ask(Operation::BoardHealth, &Nothing);
        } else if self.next_key <= now {
            self.next_key = now + HEALTH_US;
            self.slot = (self.slot + 1) % self.n_keys.max(1);
            self.ask_key(self.slot, channel);
        } else {
            return false;
        }
        true
    }

    fn ask_key(&mut self, slot: u8, channel: &mut RequestChannel) {
        self.asked = slot;
        channel.ask(Operation::KeyHealth, &ReadKeyHealth { slot });
    }

    pub(super) fn take_board(&mut self, health: &BoardHealth) {
        self.failed = health.faults;
    }

    /// Stores the answer about the last key; `None` if it was declined.
    pub(super) fn take_key(&mut self, record: Option<&[u8]>) {
        let health = record.and_then(KeyHealth::take);
        let Some(cause) = self.causes.get_mut(usize::from(self.asked)) else { return };
        // A key that the board counts as failed has some fault, whatever the answer.
        let fault = health.map_or(key_fault::OTHER, |it| it.fault);
        let is_failed = self.failed >> self.asked & 1 == 1;
        *cause = match fault {
            key_fault::NONE => is_failed.then_some(key_fault::OTHER),
            fault => is_failed.then_some(fault),
        };
        let temperature = health.map(|it| it.temperature).filter(|it| *it != NOT_MEASURED);
        self.hottest = self.hottest.max(temperature);
    }

    pub(super) const fn on_muted(&mut self) {
        self.muted |= 1 << self.asked;
    }
}
