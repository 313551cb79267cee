//! Boards on one bus, and their share of its time.

use std::{ops::Range, slice};

use firmware_protocol::Record as _;
use firmware_protocol::acyclic::{REPLY_HEAD, REQUEST_HEAD, counters::Counters, ping::Pong};
use firmware_protocol::frame::multicast_forces::{self, GROUP, GROUPS};
use keyboard::KeyRange;

use super::response::{Periodic, worst_response};
use super::{ForcePacking, Medium, SamplePacking, can::Stuffing};
use crate::periods::{COUNTERS_US, HEALTH_US, PING_US, SYNC_US};
use crate::topology::{self, BoardPlace};

/// Bus time: kind, number, and 4 bytes of time (bytes).
const SYNC: usize = 6;
const REQUEST: usize = REQUEST_HEAD;
const PONG: usize = REPLY_HEAD + Pong::LEN;
const COUNTERS: usize = REPLY_HEAD + Counters::LEN;

/// Planned load of a bus, with the rates for every key (Hz).
#[derive(Clone, PartialEq, Debug)]
pub struct BusPlan {
    pub name: String,
    pub medium: Medium,
    pub boards: Vec<KeyRange>,
    pub samples: SamplePacking,
    pub forces: ForcePacking,
    pub sample_rate: f64,
    pub force_rate: f64,
    pub extras: Extras,
}

/// Returns the keys of the standard boards with these numbers.
pub fn standard(boards: Range<usize>) -> Vec<KeyRange> {
    let all = topology::standard();
    let places = all.iter().skip(boards.start).take(boards.len());
    places.filter_map(BoardPlace::key_range).collect()
}

/// Traffic of a bus besides samples and forces: requests of `rt::board_supervisor` to each armed
/// board, and the bus time where `rt::multicast` sends forces.
///
/// Not planned are the second of the bring-up, repeated requests, and simulated fingers' gestures.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Extras {
    /// Rate of the host's time, if forces are for all boards (Hz).
    pub sync_rate: f64,
    /// Rate of requests for each board's time (Hz).
    pub ping_rate: f64,
    /// Rate of requests for each board's counts, and for its health (Hz).
    pub counters_rate: f64,
}

impl Extras {
    pub const NONE: Self = Self { sync_rate: 0.0, ping_rate: 0.0, counters_rate: 0.0 };
}

impl Default for Extras {
    fn default() -> Self {
        let [sync_rate, ping_rate, counters_rate, health_rate] =
            [SYNC_US, PING_US, COUNTERS_US, HEALTH_US].map(|period_us| 1e6 / period_us as f64);
        // The health of a board and of a key are shorter, and counted as if they were as long.
        Self { sync_rate, ping_rate, counters_rate: counters_rate + 2.0 * health_rate }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum TrafficKind {
    Sync,
    Forces,
    Samples,
    Request,
    Reply,
}

#[derive(Clone, Copy, PartialEq, Debug)]
struct Traffic {
    kind: TrafficKind,
    /// Length before framing (bytes).
    bytes: usize,
    rate: f64,
}

impl Traffic {
    const fn is_cyclic(&self) -> bool {
        matches!(self.kind, TrafficKind::Forces | TrafficKind::Samples)
    }

    const fn goes_down(&self) -> bool {
        matches!(self.kind, TrafficKind::Sync | TrafficKind::Forces | TrafficKind::Request)
    }

    fn load(&self, medium: Medium) -> f64 {
        self.rate * medium.time(self.bytes, Stuffing::Most) * 1e-6
    }
}

impl BusPlan {
    /// Returns the largest share of the bus's time, of the busier direction if there are two.
    pub fn load(&self) -> f64 {
        let loads = self.lanes().map(|lane| self.sum(&lane, |_| true));
        loads.into_iter().fold(0.0, f64::max)
    }

    pub(super) fn stretch(&self, limit: f64) -> f64 {
        let factors = self.lanes().map(|lane| {
            let cyclic = self.sum(&lane, Traffic::is_cyclic);
            (limit - self.sum(&lane, |it| !it.is_cyclic())) / cyclic
        });
        // The empty lane's factor is infinite, and no factor is negative.
        factors.into_iter().fold(f64::INFINITY, f64::min).max(0.0)
    }

    /// Returns the longest wait of the most urgent frame for one on its way (us).
    pub fn blocking(&self) -> f64 {
        let lanes = self.lanes();
        lanes.iter().map(|lane| self.blocking_in(lane)).fold(0.0, f64::max)
    }

    /// Returns the longest time to the arrival of the least urgent force frame (us), if bounded.
    pub fn force_response(&self) -> Option<f64> {
        let [down, _] = self.lanes();
        let last = down.iter().rposition(|it| it.kind == TrafficKind::Forces)?;
        let time = |it: &Traffic| self.medium.time(it.bytes, Stuffing::Most);
        let higher: Vec<_> = down
            .iter()
            .take(last)
            .filter(|it| 0.0 < it.rate)
            .map(|it| Periodic { period: 1e6 / it.rate, time: time(it) })
            .collect();
        worst_response(self.blocking_in(&down), &higher, time(down.get(last)?))
    }

    /// Returns the longest time in which nothing else can be sent (us).
    fn blocking_in(&self, lane: &[Traffic]) -> f64 {
        let sent = lane.iter().filter(|it| 0.0 < it.rate);
        sent.map(|it| self.medium.blocking(it.bytes)).fold(0.0, f64::max)
    }

    fn sum(&self, lane: &[Traffic], count: impl Fn(&Traffic) -> bool) -> f64 {
        // Not `sum`, which makes -0 of nothing, and a factor of -infinity of that.
        let loads = lane.iter().filter(|it| count(it)).map(|it| it.load(self.medium));
        loads.fold(0.0, |sum, load| sum + load)
    }

    /// Returns frames that share turns, most urgent first: down (and up, if shared), and the rest.
    fn lanes(&self) -> [Vec<Traffic>; 2] {
        let shared = self.medium.is_shared();
        let (down, up) = self.traffic().into_iter().partition(|it| shared || it.goes_down());
        [down, up]
    }

    fn traffic(&self) -> Vec<Traffic> {
        let of = |kind, bytes, rate| Traffic { kind, bytes, rate };
        let mut all: Vec<_> = self
            .force_frames()
            .into_iter()
            .map(|bytes| of(TrafficKind::Forces, bytes, self.force_rate))
            .collect();
        let Extras { sync_rate, ping_rate, counters_rate } = self.extras;
        for keys in &self.boards {
            all.push(of(
                TrafficKind::Samples,
                self.samples.frame_len(keys.numbers().len()),
                self.sample_rate,
            ));
            for (reply, rate) in [(PONG, ping_rate), (COUNTERS, counters_rate)] {
                all.extend([
                    of(TrafficKind::Request, REQUEST, rate),
                    of(TrafficKind::Reply, reply, rate),
                ]);
            }
        }
        if self.is_for_all() {
            let listeners = if self.medium.reaches_all() { 1 } else { self.boards.len() };
            all.extend(vec![of(TrafficKind::Sync, SYNC, sync_rate); listeners]);
        }
        all.sort_by_key(|it| it.kind);
        all
    }

    fn is_for_all(&self) -> bool {
        self.forces == ForcePacking::Multicast16
    }

    /// Returns the lengths of the force frames of a cycle (bytes).
    fn force_frames(&self) -> Vec<usize> {
        if !self.is_for_all() {
            let len = |keys: &KeyRange| self.forces.frame_len(keys.numbers().len());
            return self.boards.iter().map(len).collect();
        }
        let frames = if self.medium.reaches_all() {
            groups(&self.boards)
        } else {
            self.boards.iter().map(|keys| groups(slice::from_ref(keys))).sum()
        };
        vec![multicast_forces::LEN; frames]
    }
}

/// Returns the number of key groups of these boards: each takes a whole frame, with 1 key or 30.
fn groups(boards: &[KeyRange]) -> usize {
    let has = |keys: &KeyRange, group: usize| {
        keys.first().index() < (group + 1) * GROUP && group * GROUP <= keys.last().index()
    };
    (0..GROUPS).filter(|group| boards.iter().any(|keys| has(keys, *group))).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{identity::ClaimedKeys, plan::uart::Wiring};

    fn plan(medium: Medium) -> BusPlan {
        BusPlan {
            name: "bus".to_owned(),
            medium,
            boards: standard(0..8),
            samples: SamplePacking::Position16,
            forces: ForcePacking::Force16,
            sample_rate: 1_000.0,
            force_rate: 500.0,
            extras: Extras::default(),
        }
    }

    const FD: Medium = Medium::CanFd { nominal: 1_000_000, data: 5_000_000 };

    #[test]
    fn a_bus_is_told_the_forces_of_each_group_of_thirty_that_it_has_keys_of() {
        let range = |first, n| ClaimedKeys { first, n }.range().unwrap();
        let of = |first, n| groups(&[range(first, n)]);
        assert_eq!((groups(&standard(0..8)), groups(&[])), (3, 0));
        assert_eq!((of(0, 11), of(22, 11), of(29, 1), of(30, 1), of(29, 2)), (1, 2, 1, 1, 2));
        // The outermost boards have nothing in the middle.
        assert_eq!(groups(&[range(0, 11), range(77, 11)]), 2);
        // Separate links carry the groups of their own boards.
        let usb = BusPlan { forces: ForcePacking::Multicast16, ..plan(Medium::UsbFullSpeed) };
        assert_eq!(usb.force_frames(), [64; 6 + 2 * 2]);
    }

    #[test]
    fn the_time_of_the_bus_is_as_long_as_planned_and_told_where_forces_are_for_all() {
        use firmware_protocol::frame::broadcast::{Broadcast, MAX_LEN};
        assert_eq!(Broadcast::BusTime { host_us: u32::MAX }.encode(&mut [0; MAX_LEN]), SYNC);
        let syncs =
            |plan: BusPlan| plan.traffic().iter().filter(|it| it.kind == TrafficKind::Sync).count();
        assert_eq!(syncs(plan(FD)), 0);
        assert_eq!(syncs(BusPlan { forces: ForcePacking::Multicast16, ..plan(FD) }), 1);
    }

    #[test]
    fn a_link_each_way_is_as_loaded_as_its_busier_way() {
        let line = Medium::Uart { baud: 1_000_000, wiring: Wiring::FullDuplex };
        let mut one = BusPlan { boards: standard(0..1), extras: Extras::NONE, ..plan(line) };
        assert!((one.load() - 0.3).abs() < 1e-12, "{}", one.load());
        one.force_rate = 2_000.0;
        assert!((one.load() - 0.6).abs() < 1e-12, "{}", one.load());
    }

    #[test]
    fn the_last_force_frame_waits_for_all_others_and_the_longest() {
        // A board's counts take 48 bytes, its forces 32.
        let expected = 136.8 + 7.0 * 104.8 + 104.8;
        let response = plan(FD).force_response().unwrap();
        assert!((response - expected).abs() < 1e-9, "{response} us");
        assert!((plan(FD).blocking() - 136.8).abs() < 1e-9);
        let cyclic = BusPlan { extras: Extras::NONE, ..plan(FD) };
        assert!((cyclic.blocking() - 104.8).abs() < 1e-9);
    }

    #[test]
    fn a_bus_without_boards_carries_any_rate() {
        let empty = BusPlan { boards: Vec::new(), extras: Extras::NONE, ..plan(FD) };
        assert!(empty.load().abs() < f64::EPSILON && empty.max_rate().is_infinite());
        assert_eq!(empty.force_response(), None);
    }
}
