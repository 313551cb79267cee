//! Gestures for the simulated fingers of a board, handed over before they begin.

use firmware_protocol::acyclic::finger::{self, Finger};
use haptics::plant::{Gesture, Touch};

use crate::clock::ClockModel;

/// How long before its time a gesture is handed over (us).
const AHEAD_US: u64 = 1_000_000;

/// Gestures that wait to be handed over, in the order of their starts.
#[derive(Clone, Debug, Default)]
pub(super) struct GestureQueue {
    /// Each with the slot of its key.
    gestures: Vec<(u8, Gesture)>,
    next: usize,
}

impl GestureQueue {
    /// Adds `gestures` for the key in `slot`; not for the tick.
    pub(super) fn add(&mut self, slot: u8, gestures: &[Gesture]) {
        self.gestures.extend(gestures.iter().map(|gesture| (slot, *gesture)));
        self.gestures.sort_by(|one, other| one.1.start.total_cmp(&other.1.start));
    }

    /// Returns the next gesture, if its time is near and the board's time is known.
    pub(super) fn next(&self, now: u64, origin: u64, clock: &ClockModel) -> Option<Finger> {
        let &(slot, gesture) = self.gestures.get(self.next)?;
        let at = |seconds: f64| origin + microseconds(seconds);
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

    /// Goes on to the next gesture: the board has taken this one, or never will.
    pub(super) const fn advance(&mut self) {
        self.next += 1;
    }
}

/// Returns whole microseconds in a time that is not negative (s).
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn microseconds(seconds: f64) -> u64 {
    (seconds * 1e6).round() as u64
}

/// Returns whole millionths of a value of the wire.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn micro(value: f64) -> u32 {
    (value * 1e6).round() as u32
}
