//! The way down of a gesture, as if it were never released.
//!
//! ```text
//! position
//!   from ──╮ run-up                     velocity grows to the speed
//!           ╲ cruise                    constant speed, past the key's bottom
//!   hold ─ ─ ╲─ ─ ─ ─ ─ ─ ─ ─ ╭──────   held until the release
//!             ╲ brake       ╱ settle
//!   peak ─ ─ ─ ╰──────────╯ dwell       the deeper the faster: the push of a loud tone
//! ```
//!
//! Until it settles, a faster stroke is never behind a slower one, so it never pushes more slowly.

use super::{Gesture, Touch};
use crate::plant::smooth::{cubic, cubic_integral, quintic, quintic_slope};

/// Range of a stroke's speed (m/s): slower never arrives, faster is no finger.
const SPEEDS: (f64, f64) = (1e-3, 20.0);

/// Minimum hold depth (m), so that a stroke always has a way to go.
const MIN_HOLD: f64 = 1e-3;

/// Depth of a held finger beyond its key's bottom (m): 2 N at 400 N/m.
pub(super) const PUSH: f64 = 2.0 / 400.0;

/// Least fraction of the default run-up. The run-up shrinks with the square of the way, as a
/// repetition from half-way down has no time for more.
const LEAST_RUN_UP: f64 = 0.1;

/// Deepest start, as a fraction of the hold depth: there must be a way to go.
const DEEPEST: f64 = 0.6;

/// Height above the key from which a struck gesture starts (m) (estimate).
const STRIKE_HEIGHT: f64 = 20e-3;

/// Fraction of the way to the hold depth in which a pressed gesture gains its speed: most of the
/// way to let-off, since a sudden start would swing the action and spoil the tone.
const PRESSED_RUN_UP: f64 = 0.5;

/// Fraction of the way to the key in which a struck gesture gains its speed.
const STRUCK_RUN_UP: f64 = 0.75;

/// Overshoot of an infinitely fast stroke (m): 20 N at 400 N/m.
const OVERSHOOT: f64 = 50e-3;

/// Speed at which half of the overshoot is reached (m/s).
const OVERSHOOT_SPEED: f64 = 0.6;

/// Time at the peak (s), for a key that lags behind to arrive.
const DWELL: f64 = 20e-3;

/// Time from the peak to the hold depth (s).
const SETTLE: f64 = 80e-3;

/// Command of a muscle at one instant, down positive (m, m/s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MuscleCommand {
    pub position: f64,
    pub velocity: f64,
}

/// One way down: its depths (m) and the durations of its segments (s).
#[derive(Clone, Copy, Debug)]
pub(super) struct StrokeProfile {
    from: f64,
    hold: f64,
    overshoot: f64,
    speed: f64,
    run_up: f64,
    cruise: f64,
    brake: f64,
}

impl StrokeProfile {
    pub(super) fn of(gesture: &Gesture) -> Self {
        let speed = gesture.speed.max(SPEEDS.0).min(SPEEDS.1);
        let hold = gesture.hold.max(MIN_HOLD);
        let from = gesture.from.max(0.0).min(DEEPEST * hold);
        // Remaining fraction of the way to the key's bottom.
        let part = 1.0 - from / (hold - PUSH).max(MIN_HOLD);
        let (from, run_up) = match gesture.touch {
            Touch::Pressed => (from, PRESSED_RUN_UP * hold * (part * part).max(LEAST_RUN_UP)),
            Touch::Struck => (-STRIKE_HEIGHT, STRUCK_RUN_UP * STRIKE_HEIGHT),
        };
        // The mean speed is half of the full speed.
        let run_up = 2.0 * run_up / speed;
        let overshoot = OVERSHOOT * speed / (speed + OVERSHOOT_SPEED);
        Self {
            from,
            hold,
            overshoot,
            speed,
            run_up,
            cruise: (hold - from) / speed - 0.5 * run_up,
            brake: 2.0 * overshoot / speed,
        }
    }

    /// Returns the time after the start at which the stroke passes the key's rest position (s).
    pub(super) fn arrival(&self) -> f64 {
        if self.from < 0.0 { 0.5 * self.run_up - self.from / self.speed } else { 0.0 }
    }

    /// Returns the time after the start at which the stroke passes `depth` (s) at full speed.
    pub(super) fn passes(&self, depth: f64) -> f64 {
        0.5 * self.run_up + (depth - self.from) / self.speed
    }

    /// Returns the command at `elapsed` (s) after the start.
    pub(super) fn command(&self, elapsed: f64) -> MuscleCommand {
        let cruising = elapsed - self.run_up;
        let braking = cruising - self.cruise;
        let dwelling = braking - self.brake;
        if cruising < 0.0 {
            self.running_up(elapsed / self.run_up)
        } else if braking < 0.0 {
            self.cruising(cruising)
        } else if dwelling < 0.0 {
            self.braking(braking / self.brake)
        } else {
            self.settling((dwelling - DWELL) / SETTLE)
        }
    }

    fn running_up(&self, x: f64) -> MuscleCommand {
        MuscleCommand {
            position: self.from + self.speed * self.run_up * cubic_integral(x),
            velocity: self.speed * cubic(x),
        }
    }

    /// Returns the command `elapsed` (s) after full speed.
    fn cruising(&self, elapsed: f64) -> MuscleCommand {
        let position = self.from + self.speed * (0.5 * self.run_up + elapsed);
        MuscleCommand { position, velocity: self.speed }
    }

    fn braking(&self, x: f64) -> MuscleCommand {
        MuscleCommand {
            position: self.hold + self.speed * self.brake * (x - cubic_integral(x)),
            velocity: self.speed * (1.0 - cubic(x)),
        }
    }

    /// Returns the command at the fraction `x` of the way from the peak to the hold depth.
    fn settling(&self, x: f64) -> MuscleCommand {
        MuscleCommand {
            position: self.hold + self.overshoot * (1.0 - quintic(x)),
            velocity: -self.overshoot * quintic_slope(x) / SETTLE,
        }
    }
}
