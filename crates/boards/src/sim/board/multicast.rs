//! Multicast forces at a simulated board.
//!
//! Its keys may be in two groups of thirty. The older one counts, so no group keeps another alive.

use std::ops::Range;

use firmware_protocol::frame::key_forces::{ForcePacking, KeySlopes};
use firmware_protocol::frame::multicast_forces::{GROUP, GROUPS, MulticastForces};
use firmware_protocol::quantity::Millinewtons;

use super::SimulatedBoard;
use crate::sim::{force_interlock::ForceDecision, force_law::Law};

/// Times at which the newest forces of each group were computed, since arming (us).
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Groups {
    taken_us: [Option<u64>; GROUPS],
}

impl Groups {
    /// Records forces of `group`; returns the oldest time of the groups of `keys`, if complete.
    fn hear(&mut self, group: u8, taken_us: u64, keys: &Range<usize>) -> Option<u64> {
        *self.taken_us.get_mut(usize::from(group))? = Some(taken_us);
        let mine = keys.start / GROUP..keys.end.div_ceil(GROUP);
        // `None` is less than any time.
        self.taken_us.get(mine)?.iter().copied().min().flatten()
    }
}

impl SimulatedBoard {
    /// Accepts multicast forces that were agreed and are recent; they hold from `from_us` on.
    pub(super) fn take_multicast(&mut self, from_us: u64, frame: &[u8]) {
        let Ok(frame) = MulticastForces::decode(frame) else {
            self.counts.refused += 1;
            return;
        };
        let first = usize::from(frame.group) * GROUP;
        let mine =
            usize::from(self.make.first_key)..usize::from(self.make.first_key) + self.make.n_keys;
        let shared = first.max(mine.start)..(first + GROUP).min(mine.end);
        if self.forces.packing != ForcePacking::Multicast16 || shared.is_empty() {
            return;
        }
        // The clock determines their age, whatever ticks have not been simulated yet.
        let now_us = self.now_us();
        let is_newer = self.bus_time.accept(frame.group, frame.sequence, now_us);
        let Some(age_us) = self.bus_time.age_us(now_us, frame.stamp_us).filter(|_| is_newer) else {
            self.counts.stale += 1;
            return;
        };
        let taken_us = now_us.saturating_sub(age_us).min(from_us);
        let held = |force| {
            // The flag "no force" concerns the keys of its frame.
            let force = if frame.flag { Millinewtons::default() } else { force };
            Law::here(force, KeySlopes::default(), (0.0, 0.0), from_us)
        };
        match self.interlock.judge(taken_us, from_us) {
            ForceDecision::Stale => self.counts.stale += 1,
            ForceDecision::Unarmed => self.counts.unarmed += 1,
            ForceDecision::Rendered => {
                self.counts.forces += 1;
                self.counts.oldest_us = self.counts.oldest_us.max(age_us);
                let forces = &frame.forces[shared.start - first..shared.end - first];
                let laws = &mut self.rendered.laws.as_mut_slice()[shared.start - mine.start..];
                for (law, force) in laws.iter_mut().zip(forces) {
                    *law = held(*force);
                }
                if let Some(oldest_us) = self.rendered.groups.hear(frame.group, taken_us, &mine) {
                    // If those are stale, none is fed, and the forces expire.
                    let _fed = self.interlock.feed(oldest_us, from_us);
                }
            }
        }
    }
}
