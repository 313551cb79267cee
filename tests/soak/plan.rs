//! The music and the faults of a trial, all from one seed.

use std::ops::Range;

use boards::links::faulty::{Chance, Direction, FaultPlan, LinkFault, Scripted};
use boards::links::random::Random;
use firmware_protocol::key::{BoardId, KeyIndex};
use haptics::Gesture;
use scheduler::motion::KEYS;

use crate::music;

/// Time at the start and at the end without faults (s).
const CALM: (f64, f64) = (1.0, 3.0);

/// Longest absence of the MIDI port (s).
pub(crate) const LONGEST_AWAY: f64 = 2.0;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum BadValues {
    NotANumber,
    /// Much too large, too small or of the wrong sign: the seed of the factors.
    Wild(u64),
}

impl BadValues {
    const fn number(n: usize, seed: u64) -> Self {
        if n.is_multiple_of(2) { Self::NotANumber } else { Self::Wild(seed) }
    }
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct KeyTrouble<T> {
    pub(crate) key: usize,
    pub(crate) ticks: Range<u64>,
    pub(crate) what: T,
}

#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Tuning {
    pub(crate) key: usize,
    pub(crate) tick: u64,
    /// Index of the parameter, as a share of their number.
    pub(crate) parameter: f64,
    /// Factor of its value, possibly NaN.
    pub(crate) factor: f64,
}

#[derive(Clone, PartialEq, Debug)]
pub(crate) struct SoakPlan {
    pub(crate) ticks: u64,
    pub(crate) music: Vec<(KeyIndex, Vec<Gesture>)>,
    pub(crate) wires: Vec<(BoardId, FaultPlan)>,
    pub(crate) silences: Vec<(BoardId, Vec<Range<u64>>)>,
    pub(crate) sensors: Vec<KeyTrouble<()>>,
    pub(crate) voices: Vec<KeyTrouble<BadValues>>,
    pub(crate) tunings: Vec<Tuning>,
    pub(crate) away: Vec<Range<u64>>,
    pub(crate) full: Range<u64>,
    pub(crate) first: [u64; KEYS],
}

struct PlanDraw {
    random: Random,
    hz: f64,
    span: Range<f64>,
}

impl PlanDraw {
    fn tick(&self, seconds: f64) -> u64 {
        engine::realtime::clock::nearest_integer(seconds * self.hz)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.random.unit()
    }

    fn spans(&mut self, pauses: (f64, f64), lengths: (f64, f64)) -> Vec<Range<u64>> {
        let mut spans = Vec::new();
        let mut at = self.span.start + self.between(0.0, pauses.1);
        loop {
            let length = self.between(lengths.0, lengths.1);
            if self.span.end < at + length {
                return spans;
            }
            spans.push(self.tick(at)..self.tick(at + length).max(self.tick(at) + 1));
            at += length + self.between(pauses.0, pauses.1);
        }
    }

    fn shuffled<T>(&mut self, mut items: Vec<T>) -> Vec<T> {
        for end in (1..items.len()).rev() {
            let share = self.random.unit() * (end + 1) as f64;
            items.swap(
                end,
                usize::try_from(engine::realtime::clock::nearest_integer(share.floor()))
                    .unwrap_or(0)
                    .min(end),
            );
        }
        items
    }
}

impl SoakPlan {
    pub(crate) fn new(seed: u64, seconds: f64, tick_hz: u32) -> Self {
        let mut random = Random(seed);
        let music = KeyIndex::all().map(|key| (key, music::strokes(&mut random, seconds - 1.5)));
        let music = music.collect();
        let span = CALM.0..(seconds - CALM.1).max(CALM.0);
        let mut draw = PlanDraw { random, hz: f64::from(tick_hz), span };
        let mut plan = Self {
            ticks: draw.tick(seconds),
            music,
            wires: Vec::new(),
            silences: Vec::new(),
            sensors: Vec::new(),
            voices: Vec::new(),
            tunings: Vec::new(),
            away: draw.spans((1.0, 8.0), (0.05, LONGEST_AWAY)),
            full: draw.tick(seconds * 0.4)..draw.tick(seconds * 0.5),
            first: [u64::MAX; KEYS],
        };
        let boards = draw.shuffled(BoardId::all().collect());
        let (disturbed, clean) = boards.split_at(3);
        plan.disturb_wires(&mut draw, disturbed);
        let keys = clean.iter().flat_map(|board| board.keys()).collect();
        plan.disturb_keys(&mut draw, keys);
        plan
    }

    fn disturb_wires(&mut self, draw: &mut PlanDraw, boards: &[BoardId]) {
        let chance = |probability, fault| Chance { probability, fault };
        let noise = vec![
            chance(0.01, LinkFault::Drop),
            chance(0.005, LinkFault::FlipBit),
            chance(0.01, LinkFault::Delay(1)),
            chance(0.003, LinkFault::Delay(3)),
            chance(0.003, LinkFault::Duplicate),
        ];
        let seed = draw.random.next();
        let silences = draw.spans((1.0, 5.0), (0.005, 0.4));
        let lost = draw.spans((0.2, 2.0), (0.001, 0.06));
        let unheard = draw.spans((0.2, 2.0), (0.001, 0.06));
        let [noisy, silent, gappy] = boards else { return };
        let both = |fault, ranges: &[Range<u64>]| -> Vec<Scripted> {
            let of = |direction| {
                ranges.iter().cloned().map(move |exchanges| Scripted {
                    exchanges,
                    direction,
                    fault,
                })
            };
            of(Direction::Receive).chain(of(Direction::Send)).collect()
        };
        let one = |direction, ranges: Vec<Range<u64>>| {
            let fault = LinkFault::Drop;
            ranges.into_iter().map(move |exchanges| Scripted { exchanges, direction, fault })
        };
        let gaps = one(Direction::Receive, lost).chain(one(Direction::Send, unheard)).collect();
        let scripted = |script| FaultPlan { script, ..FaultPlan::default() };
        self.wires = vec![
            (*noisy, FaultPlan { seed, chances: noise, script: Vec::new() }),
            (*silent, scripted(both(LinkFault::Down, &silences))),
            (*gappy, scripted(gaps)),
        ];
        self.silences = vec![(*silent, silences)];
        for key in boards.iter().flat_map(|board| board.keys()) {
            self.first[key] = 0;
        }
    }

    fn disturb_keys(&mut self, draw: &mut PlanDraw, keys: Vec<usize>) {
        let mut keys = draw.shuffled(keys).into_iter();
        for key in keys.by_ref().take(4) {
            let spans = draw.spans((1.0, 6.0), (0.001, 0.2));
            let trouble = |ticks| KeyTrouble { key, ticks, what: () };
            self.sensors.extend(spans.into_iter().map(trouble));
        }
        for (n, key) in keys.by_ref().take(12).enumerate() {
            for ticks in draw.spans((1.0, 6.0), (0.5, 2.0)) {
                let seed = draw.random.next();
                self.voices.push(KeyTrouble { key, ticks, what: BadValues::number(n, seed) });
            }
        }
        for key in keys.by_ref().take(10) {
            for ticks in draw.spans((0.2, 3.0), (0.0, 0.1)) {
                let parameter = draw.random.unit();
                // A NaN factor gives an invalid value, and one of ten may be out of range.
                let factor = match draw.random.next() % 8 {
                    0 => f64::NAN,
                    1 => 1e9,
                    _ => draw.between(0.7, 1.4),
                };
                self.tunings.push(Tuning { key, tick: ticks.start, parameter, factor });
            }
        }
        let starts = self.sensors.iter().map(|it| (it.key, it.ticks.start));
        let starts = starts.chain(self.voices.iter().map(|it| (it.key, it.ticks.start)));
        let starts: Vec<_> =
            starts.chain(self.tunings.iter().map(|it| (it.key, it.tick))).collect();
        for (key, start) in starts {
            self.first[key] = self.first[key].min(start);
        }
    }

    pub(crate) fn spared(&self) -> impl Iterator<Item = usize> {
        (0..KEYS).filter(|key| self.first[*key] == u64::MAX)
    }

    pub(crate) fn undisturbed(&self) -> Self {
        Self {
            wires: Vec::new(),
            silences: Vec::new(),
            sensors: Vec::new(),
            voices: Vec::new(),
            tunings: Vec::new(),
            away: Vec::new(),
            full: 0..0,
            ..self.clone()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_gives_one_plan_in_which_some_keys_are_spared() {
        let plan = SoakPlan::new(1, 60.0, 1000);
        assert_eq!(format!("{plan:?}"), format!("{:?}", SoakPlan::new(1, 60.0, 1000)));
        assert_ne!(format!("{plan:?}"), format!("{:?}", SoakPlan::new(2, 60.0, 1000)));
        assert!(20 <= plan.spared().count(), "{}", plan.spared().count());
        let disturbed = [plan.sensors.len(), plan.voices.len(), plan.tunings.len()];
        assert!(disturbed.iter().all(|n| 10 < *n), "{disturbed:?}");
        assert_eq!(plan.undisturbed().music, plan.music);
    }
}
