//! Simulated fingers on keys, each released when its connection ends.

use std::collections::BTreeMap;

use firmware_protocol::key::KeyIndex;
use haptics::HandCommand;
use rtrb::Producer;

/// Connection of a client; `None` for requests without one, whose keys stay pressed.
pub type FingerOwner = Option<u64>;

/// Sends simulated hands into the tick.
///
/// The ring keeps room for the release of each pressed key, so that a release never fails.
#[derive(Debug)]
pub struct FingerQueue {
    hands: Producer<(KeyIndex, HandCommand)>,
    pressed: BTreeMap<u8, (KeyIndex, FingerOwner)>,
}

impl FingerQueue {
    pub const fn new(hands: Producer<(KeyIndex, HandCommand)>) -> Self {
        Self { hands, pressed: BTreeMap::new() }
    }

    /// Presses `key` or grips it for `by`; no weight releases it.
    ///
    /// # Errors
    /// A sentence if the ring is full.
    pub fn press(
        &mut self,
        key: KeyIndex,
        hand: HandCommand,
        by: FingerOwner,
    ) -> Result<(), String> {
        if hand == HandCommand::AWAY {
            self.release(key);
            return Ok(());
        }
        let n_others = self.pressed.len() - usize::from(self.pressed.contains_key(&key.number()));
        if self.hands.slots() < n_others + 2 || self.hands.push((key, hand)).is_err() {
            return Err("too many keys are pressed at once; try again".to_owned());
        }
        self.pressed.insert(key.number(), (key, by));
        Ok(())
    }

    /// Releases all keys last pressed by `connection`.
    pub fn leave(&mut self, connection: u64) {
        let its = |(_, by): &&(KeyIndex, FingerOwner)| *by == Some(connection);
        let keys: Vec<_> = self.pressed.values().filter(its).map(|(key, _)| *key).collect();
        for key in keys {
            self.release(key);
        }
    }

    fn release(&mut self, key: KeyIndex) {
        if self.pressed.remove(&key.number()).is_some() {
            // Its room was reserved; a ring without a run has no reader.
            let _kept = self.hands.push((key, HandCommand::AWAY));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rtrb::{Consumer, RingBuffer};

    fn fingers(room: usize) -> (FingerQueue, Consumer<(KeyIndex, HandCommand)>) {
        let (hands, laid) = RingBuffer::new(room);
        (FingerQueue::new(hands), laid)
    }

    const AWAY: HandCommand = HandCommand::AWAY;

    fn key(number: u8) -> KeyIndex {
        KeyIndex::new(number).expect("a key")
    }

    fn all(laid: &mut Consumer<(KeyIndex, HandCommand)>) -> Vec<(u8, HandCommand)> {
        std::iter::from_fn(|| laid.pop().ok()).map(|(key, hand)| (key.number(), hand)).collect()
    }

    #[test]
    fn the_fingers_of_a_client_that_goes_are_taken_away_and_no_others() {
        let (mut fingers, mut laid) = fingers(16);
        for (number, by) in [(1, Some(7)), (2, Some(8)), (3, None), (4, Some(7)), (4, Some(8))] {
            fingers.press(key(number), HandCommand::Grip(0.5), by).expect("room");
        }
        all(&mut laid);
        fingers.leave(7);
        assert_eq!(all(&mut laid), [(1, AWAY)], "key 4 is client 8's by now");
        fingers.leave(7);
        assert_eq!(all(&mut laid), []);
        fingers.leave(8);
        assert_eq!(all(&mut laid), [(2, AWAY), (4, AWAY)]);
    }

    #[test]
    fn there_is_always_room_to_let_go() {
        let (mut fingers, mut laid) = fingers(8);
        let pressed = (0..8)
            .filter(|n| fingers.press(key(*n), HandCommand::Weight(1.0), Some(1)).is_ok())
            .count();
        assert_eq!(pressed, 4, "half of the ring is kept for letting go");
        for _ in 0..100 {
            fingers.press(key(9), AWAY, Some(2)).expect("nobody presses it");
        }
        fingers.leave(1);
        let all = all(&mut laid);
        assert_eq!(all[4..], [(0, AWAY), (1, AWAY), (2, AWAY), (3, AWAY)]);
    }
}
