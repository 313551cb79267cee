//! Forces for all boards on a line at once, and the time by which they expire.

use firmware_protocol::frame::broadcast::{self, Broadcast};
use firmware_protocol::frame::multicast_forces::{GROUP, GROUPS, MulticastForces};
use firmware_protocol::{MAX_FRAME, quantity::Millinewtons, sequence::SequenceNumber};
use scheduler::motion::KEYS;

use super::board::BoardTerms;
use crate::{clock::low, periods::SYNC_US};

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Multicast {
    sequences: [SequenceNumber; GROUPS],
    next_sync: u64,
}

/// Frames of one exchange: bus time, and each group.
type Frames = [Option<([u8; MAX_FRAME], usize)>; 1 + GROUPS];

impl Multicast {
    pub(super) fn frames(
        &mut self,
        now_us: u64,
        boards: &mut dyn Iterator<Item = &BoardTerms>,
        forces: &[f64; KEYS],
    ) -> Frames {
        let mut frames: Frames = [None; 1 + GROUPS];
        if self.next_sync <= now_us {
            self.next_sync = now_us + SYNC_US;
            frames[0] = Some(bus_time(now_us));
        }
        let mut groups: [Option<[Millinewtons; GROUP]>; GROUPS] = [None; GROUPS];
        for terms in boards {
            for (key, calibration) in terms.place.keys().zip(terms.calibration.as_slice()) {
                let group = groups[key / GROUP].get_or_insert_default();
                group[key % GROUP] = terms.millinewtons(calibration, forces[key]);
            }
        }
        let [a, b, ..] = now_us.to_le_bytes();
        for ((place, forces), group) in frames[1..].iter_mut().zip(groups).zip(0..) {
            let Some(forces) = forces else { continue };
            let sequence = &mut self.sequences[usize::from(group)];
            *sequence = sequence.next();
            let (sequence, stamp_us) = (*sequence, u16::from_le_bytes([a, b]));
            let frame = MulticastForces { group, sequence, stamp_us, flag: false, forces };
            *place = Some((frame.encode(), MAX_FRAME));
        }
        frames
    }
}

fn bus_time(now_us: u64) -> ([u8; MAX_FRAME], usize) {
    let mut short = [0; broadcast::MAX_LEN];
    let len = Broadcast::BusTime { host_us: low(now_us) }.encode(&mut short);
    let mut frame = [0; MAX_FRAME];
    frame[..broadcast::MAX_LEN].copy_from_slice(&short);
    (frame, len)
}
