//! Gestures for the simulated fingers of a board, sent before they begin.

use firmware_protocol::acyclic::finger::{self, Finger};
use haptics::plant::{Gesture, Touch};

use crate::clock::ClockModel;

/// Time by which a gesture is sent ahead (us).
const AHEAD_US: u64 = 1_000_000;

/// Gestures to be sent, in the order of their starts.
#[derive(Clone, Debug, Default)]
pub(super) struct GestureQueue {
    /// Each with the slot of its key.
    gestures: Vec<(u8, Gesture)>,
    next: usize,
    /// Length of a pass (s), if the gestures repeat.
    repeat: Option<f64>,
    /// Start of the present pass (s).
    pass: f64,
}

impl GestureQueue {
    /// Adds `gestures` for the key in `slot`; not for the tick.
    pub(super) fn add(&mut self, slot: u8, gestures: &[Gesture]) {
        self.gestures.extend(gestures.iter().map(|gesture| (slot, *gesture)));
        self.gestures.sort_by(|one, other| one.1.start.total_cmp(&other.1.start));
    }

    /// Repeats the gestures with the period `length` (s).
    pub(super) const fn repeat_after(&mut self, length: f64) {
        self.repeat = Some(length);
    }

    /// Returns the next gesture, if it is due and the board's time is known.
    pub(super) fn next(&self, now: u64, origin: u64, clock: &ClockModel) -> Option<Finger> {
        let &(slot, gesture) = self.gestures.get(self.next)?;
        let at = |seconds: f64| origin + microseconds(self.pass + seconds);
        if now + AHEAD_US < at(gesture.start) {
            return None;
        }
        // A hand that never lifts would outlast the board's clock.
        let release = gesture.release.min(gesture.start + 1_800.0);
        Some(Finger {
            slot,
            touch: match gesture.touch {
                Touch::Pressed => finger::PRESSED,
                Touch::Struck => finger::STRUCK,
            },
            start_us: clock.board_us(at(gesture.start))?,
            release_us: clock.board_us(at(release))?,
            speed: micro(gesture.speed),
            hold: micro(gesture.hold),
            from: micro(gesture.from),
            lift: micro(gesture.lift),
        })
    }

    /// Skips the next gesture: the board has accepted it, or never will.
    pub(super) const fn advance(&mut self) {
        self.next += 1;
        if let Some(length) = self.repeat
            && self.next == self.gestures.len()
        {
            (self.next, self.pass) = (0, self.pass + length);
        }
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn microseconds(seconds: f64) -> u64 {
    (seconds * 1e6).round() as u64
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn micro(value: f64) -> u32 {
    (value * 1e6).round() as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gestures_that_repeat_are_handed_over_a_pass_later_and_not_before() {
        const ORIGIN_US: u64 = 5_000_000;
        let mut clock = ClockModel::default();
        let _learned = clock.learn(0, 0, 0);
        let gesture = |start| Gesture { start, release: start + 0.25, ..Gesture::USUAL };
        let mut queue = GestureQueue::default();
        queue.add(3, &[gesture(1.5), gesture(0.5)]);
        queue.repeat_after(4.0);
        for due_us in [500_000, 1_500_000, 4_500_000, 5_500_000, 8_500_000].map(|it| it + ORIGIN_US)
        {
            assert_eq!(queue.next(due_us - AHEAD_US - 1, ORIGIN_US, &clock), None);
            let finger =
                queue.next(due_us - AHEAD_US, ORIGIN_US, &clock).expect("its time is near");
            assert_eq!((finger.slot, u64::from(finger.start_us)), (3, due_us));
            assert_eq!(finger.release_us - finger.start_us, 250_000);
            queue.advance();
        }
    }
}
