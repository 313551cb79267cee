//! Aftertouch: the force on a key that is held down, as MIDI pressure.

use instruments::{PressureKind, PressureTable};
use scheduler::motion::{KeyEvent, PressureScope};

/// Shortest time between two values (s): 100 per second are as smooth as a synthesizer accepts.
const SPACING: f64 = 10e-3;

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PressureTracker {
    value: u8,
    age: u32,
}

impl PressureTracker {
    /// Follows the key's force (N) in ticks of `h` (s); returns the pressure if it changed.
    pub(crate) fn follow(
        &mut self,
        PressureTable { kind, range: (from, to) }: PressureTable,
        force: f64,
        h: f64,
    ) -> Option<KeyEvent> {
        self.age = self.age.saturating_add(1);
        let part = ((force - from) / (to - from)).clamp(0.0, 1.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 127")]
        let value = (127.0 * part).round() as u8;
        if value == self.value || f64::from(self.age) * h < SPACING {
            return None;
        }
        *self = Self { value, age: 0 };
        let scope = match kind {
            PressureKind::Channel => PressureScope::Channel,
            PressureKind::Key => PressureScope::Key,
        };
        Some(KeyEvent::Pressure { value, scope })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_force_is_told_when_it_is_another_and_not_too_often() {
        let table = PressureTable { kind: PressureKind::Channel, range: (5.0, 15.0) };
        let mut tracker = PressureTracker::default();
        let told: Vec<_> = (0..40)
            .filter_map(|tick| {
                let force = if tick < 20 { f64::from(tick) } else { 2.0 };
                Some((tick, tracker.follow(table, force, 1e-3)?))
            })
            .collect();
        let pressure = |value| KeyEvent::Pressure { value, scope: PressureScope::Channel };
        assert_eq!(told, [(9, pressure(51)), (19, pressure(127)), (29, pressure(0))]);
        assert_eq!(tracker.follow(table, f64::NAN, 1e-3), None);
    }
}
