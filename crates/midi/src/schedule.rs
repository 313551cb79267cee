//! Key events in order of time, until each one is due.

use std::collections::VecDeque;

use crate::player::{NoteEvent, NoteEventKind};

/// Waiting key events, the earliest first.
///
/// Simultaneous events go out in the usual order of MIDI: note-offs (dampers that fall), dampers
/// that lift, pedals, then note-ons (strikes); keys in order of insertion. Simultaneous events of
/// one key keep their own order.
#[derive(Clone, Debug, Default)]
pub struct Schedule {
    waiting: VecDeque<ScheduledEvent>,
}

#[derive(Clone, Copy, Debug)]
struct ScheduledEvent {
    rank: u8,
    event: NoteEvent,
}

impl ScheduledEvent {
    fn is_behind(&self, at: f64, rank: u8) -> bool {
        self.event.at.total_cmp(&at).then(self.rank.cmp(&rank)).is_gt()
    }

    fn is_of(&self, event: &NoteEvent) -> bool {
        let is_pedal = |event: &NoteEvent| matches!(event.kind, NoteEventKind::Pedal { .. });
        self.event.at.total_cmp(&event.at).is_eq()
            && self.event.key == event.key
            && is_pedal(&self.event) == is_pedal(event)
    }
}

impl Schedule {
    /// Inserts `event` behind all that happen before it.
    pub fn insert(&mut self, event: NoteEvent) {
        // No later event overtakes a simultaneous event of its own key.
        let own = self.waiting.iter().filter(|entry| entry.is_of(&event)).map(|entry| entry.rank);
        let rank = own.fold(rank(event.kind), u8::max);
        let place = self.waiting.partition_point(|entry| !entry.is_behind(event.at, rank));
        self.waiting.insert(place, ScheduledEvent { rank, event });
    }

    pub fn first(&self) -> Option<&NoteEvent> {
        self.waiting.front().map(|entry| &entry.event)
    }

    pub fn pop(&mut self) -> Option<NoteEvent> {
        self.waiting.pop_front().map(|entry| entry.event)
    }
}

/// Returns the rank among simultaneous events: the smaller, the earlier.
const fn rank(kind: NoteEventKind) -> u8 {
    match kind {
        NoteEventKind::DamperFall { .. } => 0,
        NoteEventKind::DamperLift => 1,
        NoteEventKind::Pedal { .. } => 2,
        NoteEventKind::Strike { .. } => 3,
        NoteEventKind::Pressure { .. } => 4,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pedal::Pedal;

    const STRIKE: NoteEventKind = NoteEventKind::Strike { speed: 1.0, velocity: None };
    const FALL: NoteEventKind = NoteEventKind::DamperFall { speed: 0.1 };

    fn order(events: &[(u8, f64, NoteEventKind)]) -> Vec<(u8, NoteEventKind)> {
        let mut schedule = Schedule::default();
        for (key, at, kind) in events.iter().copied() {
            schedule.insert(NoteEvent { key, at, kind });
        }
        std::iter::from_fn(|| schedule.pop()).map(|event| (event.key, event.kind)).collect()
    }

    #[test]
    fn a_chord_comes_in_order_of_time_whatever_its_keys() {
        let chord = [(3, 0.9, STRIKE), (40, 0.1, STRIKE), (87, 0.5, FALL)];
        assert_eq!(order(&chord), [(40, STRIKE), (87, FALL), (3, STRIKE)]);
    }

    #[test]
    fn at_one_time_notes_end_before_others_begin_and_keys_keep_their_order() {
        let pedal = NoteEventKind::Pedal { pedal: Pedal::Sostenuto, depth: 1.0 };
        let at_once = [
            (1, 0.5, STRIKE),
            (0, 0.5, pedal),
            (2, 0.5, STRIKE),
            (5, 0.5, NoteEventKind::DamperLift),
            (4, 0.5, FALL),
            (3, 0.5, FALL),
        ];
        let wanted = [
            (4, FALL),
            (3, FALL),
            (5, NoteEventKind::DamperLift),
            (0, pedal),
            (1, STRIKE),
            (2, STRIKE),
        ];
        assert_eq!(order(&at_once), wanted);
    }

    #[test]
    fn what_happens_to_one_key_at_one_time_stays_in_its_order() {
        let touched = [(7, 0.5, STRIKE), (7, 0.5, FALL), (8, 0.5, FALL)];
        assert_eq!(order(&touched), [(8, FALL), (7, STRIKE), (7, FALL)]);
    }
}
