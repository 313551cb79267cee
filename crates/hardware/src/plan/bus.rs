//! Boards on one bus, and the share of its time that they take.

use super::can::Stuffing;
use super::packing::MULTICAST_KEYS;
use super::response::{Periodic, worst_response};
use super::verdict::REFUSE;
use super::{ForcePacking, Medium, SamplePacking};

/// Time of the host: header and 4 bytes of time [bytes].
const SYNC: usize = 8;
/// A board's voltages, temperature and counters [bytes].
const STATUS: usize = 16;

/// What a bus shall carry.
#[derive(Clone, PartialEq, Debug)]
pub struct BusPlan {
    /// What it is called in sentences.
    pub name: String,
    /// What carries the frames.
    pub medium: Medium,
    /// How many keys each of its boards has.
    pub boards: Vec<usize>,
    /// What the boards tell.
    pub samples: SamplePacking,
    /// What they are told.
    pub forces: ForcePacking,
    /// How often every key is sampled [Hz].
    pub sample_rate: f64,
    /// How often every key is given a force [Hz].
    pub force_rate: f64,
    /// What goes besides.
    pub extras: Extras,
}

/// What goes over a bus besides samples and forces.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Extras {
    /// How often the host tells its time [Hz].
    pub sync_rate: f64,
    /// How often each board tells its status [Hz].
    pub status_rate: f64,
}

impl Extras {
    /// Samples and forces only.
    pub const NONE: Self = Self { sync_rate: 0.0, status_rate: 0.0 };
}

impl Default for Extras {
    fn default() -> Self {
        Self { sync_rate: 50.0, status_rate: 10.0 }
    }
}

/// What a frame is for; the first is the most urgent.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Kind {
    Sync,
    Forces,
    Samples,
    Status,
}

/// A frame that comes again and again.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Traffic {
    kind: Kind,
    /// Before it is framed [bytes].
    bytes: usize,
    /// How often [Hz].
    rate: f64,
}

impl Traffic {
    const fn is_cyclic(&self) -> bool {
        matches!(self.kind, Kind::Forces | Kind::Samples)
    }

    const fn goes_down(&self) -> bool {
        matches!(self.kind, Kind::Sync | Kind::Forces)
    }

    /// Share of the medium's time.
    fn load(&self, medium: Medium) -> f64 {
        self.rate * medium.time(self.bytes, Stuffing::Most) * 1e-6
    }
}

impl BusPlan {
    /// Share of the bus's time that is taken at worst; of the busier direction, if the two
    /// do not take turns.
    pub fn load(&self) -> f64 {
        let loads = self.lanes().map(|lane| self.sum(&lane, |_| true));
        loads.into_iter().fold(0.0, f64::max)
    }

    /// The rate at which all keys can be sampled and given a force, both in each cycle, if
    /// the bus is taken as far as it may be [Hz]; infinite without boards.
    pub fn max_rate(&self) -> f64 {
        let one = Self { sample_rate: 1.0, force_rate: 1.0, ..self.clone() };
        one.stretch(REFUSE)
    }

    /// By how much both rates can be multiplied until the load is `limit`.
    pub(super) fn stretch(&self, limit: f64) -> f64 {
        let factors = self.lanes().map(|lane| {
            let cyclic = self.sum(&lane, Traffic::is_cyclic);
            (limit - self.sum(&lane, |it| !it.is_cyclic())) / cyclic
        });
        // The empty lane's factor is infinite; nothing goes slower than not at all.
        factors.into_iter().fold(f64::INFINITY, f64::min).max(0.0)
    }

    /// How long the most urgent frame waits for one that is on its way, at worst [us].
    pub fn blocking(&self) -> f64 {
        let lanes = self.lanes();
        lanes.iter().map(|lane| self.blocking_in(lane)).fold(0.0, f64::max)
    }

    /// How long the least urgent of the force frames takes to arrive, at worst [us].
    ///
    /// None if it may wait for ever, or if there is none.
    pub fn force_response(&self) -> Option<f64> {
        let [down, _] = self.lanes();
        let last = down.iter().rposition(|it| it.kind == Kind::Forces)?;
        let time = |it: &Traffic| self.medium.time(it.bytes, Stuffing::Most);
        let higher: Vec<_> = down
            .iter()
            .take(last)
            .filter(|it| 0.0 < it.rate)
            .map(|it| Periodic { period: 1e6 / it.rate, time: time(it) })
            .collect();
        worst_response(self.blocking_in(&down), &higher, time(down.get(last)?))
    }

    /// The longest time for which nothing else can be sent [us].
    fn blocking_in(&self, lane: &[Traffic]) -> f64 {
        lane.iter().map(|it| self.medium.blocking(it.bytes)).fold(0.0, f64::max)
    }

    /// Share of the bus's time that those of `lane` take that `count`.
    fn sum(&self, lane: &[Traffic], count: impl Fn(&Traffic) -> bool) -> f64 {
        // Not `sum`, which makes -0 of nothing, and a factor of -infinity of that.
        let loads = lane.iter().filter(|it| count(it)).map(|it| it.load(self.medium));
        loads.fold(0.0, |sum, load| sum + load)
    }

    /// What does not take turns with one another, most urgent first: what goes down, with
    /// or without what comes up, and the rest.
    fn lanes(&self) -> [Vec<Traffic>; 2] {
        let shared = self.medium.is_shared();
        let (down, up) = self.traffic().into_iter().partition(|it| shared || it.goes_down());
        [down, up]
    }

    /// All that goes over the bus, most urgent first.
    fn traffic(&self) -> Vec<Traffic> {
        let of = |kind, bytes, rate| Traffic { kind, bytes, rate };
        let mut all: Vec<_> = self
            .force_frames()
            .into_iter()
            .map(|keys| of(Kind::Forces, self.forces.frame_len(keys), self.force_rate))
            .collect();
        for keys in &self.boards {
            all.push(of(Kind::Samples, self.samples.frame_len(*keys), self.sample_rate));
            all.push(of(Kind::Status, STATUS, self.extras.status_rate));
        }
        let listeners = if self.medium.reaches_all() { 1 } else { self.boards.len() };
        all.extend(vec![of(Kind::Sync, SYNC, self.extras.sync_rate); listeners]);
        all.sort_by_key(|it| it.kind);
        all
    }

    /// How many keys each of the force frames of a cycle is for.
    fn force_frames(&self) -> Vec<usize> {
        let for_all = self.forces == ForcePacking::Multicast16;
        match (for_all, self.medium.reaches_all()) {
            (false, _) => self.boards.clone(),
            (true, true) => in_frames(self.boards.iter().sum()),
            (true, false) => self.boards.iter().flat_map(|keys| in_frames(*keys)).collect(),
        }
    }
}

/// How many keys each of the frames has that are for all boards.
fn in_frames(keys: usize) -> Vec<usize> {
    let starts = (0..keys).step_by(MULTICAST_KEYS);
    starts.map(|start| (keys - start).min(MULTICAST_KEYS)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::uart::Wiring;

    fn plan(medium: Medium) -> BusPlan {
        BusPlan {
            name: "bus".to_owned(),
            medium,
            boards: vec![11; 8],
            samples: SamplePacking::Position16,
            forces: ForcePacking::Force16,
            sample_rate: 1_000.0,
            force_rate: 500.0,
            extras: Extras::default(),
        }
    }

    const FD: Medium = Medium::CanFd { nominal: 1_000_000, data: 5_000_000 };

    #[test]
    fn keys_are_told_their_forces_thirty_at_a_time() {
        assert_eq!(in_frames(88), [30, 30, 28]);
        assert_eq!(in_frames(30), [30]);
        assert_eq!(in_frames(0), [0; 0]);
    }

    #[test]
    fn a_link_each_way_is_as_loaded_as_its_busier_way() {
        let line = Medium::Uart { baud: 1_000_000, wiring: Wiring::FullDuplex };
        let mut one = BusPlan { boards: vec![11], extras: Extras::NONE, ..plan(line) };
        assert!((one.load() - 0.3).abs() < 1e-12, "{}", one.load());
        one.force_rate = 2_000.0;
        assert!((one.load() - 0.6).abs() < 1e-12, "{}", one.load());
    }

    #[test]
    fn the_last_force_frame_waits_for_all_others_and_the_clock() {
        // The longest is one of 32 bytes; the clock's has 8.
        let expected = 104.8 + 7.0 * 104.8 + 55.8 + 104.8;
        let response = plan(FD).force_response().unwrap();
        assert!((response - expected).abs() < 1e-9, "{response} us");
        assert!((plan(FD).blocking() - 104.8).abs() < 1e-9);
    }

    #[test]
    fn a_bus_without_boards_carries_any_rate() {
        let empty = BusPlan { boards: Vec::new(), extras: Extras::NONE, ..plan(FD) };
        assert!(empty.load().abs() < f64::EPSILON && empty.max_rate().is_infinite());
        assert_eq!(empty.force_response(), None);
    }
}
