//! Where each guard leads.
//!
//! The guard that fired fixes the next mode. Where there is a choice, it is on a coordinate
//! that this guard has not placed on its threshold.

use pode::{GuardId, Motion, Reset, Resets};

use super::guards::{
    BUTTON, BUTTON_OFF, CHECK, CHECK_NEAR, JACK_IN, LAND, LIFT_OFF, REP_OFF, REP_ON, RESET,
    STRING_OFF, STRING_ON, TRIP,
};
use super::{Mode, ReducedGrand};

impl ReducedGrand {
    /// The head meets something that moves with the key at `ratio`, and stays there.
    ///
    /// u⁺ = (mk u + mh r w)/(mk + r² mh), w⁺ = r u⁺.
    fn caught(&self, mode: Mode, ratio: f64, x: &[f64; 4]) -> Reset<Self> {
        let p = &self.values;
        let [y, z, u, w] = *x;
        let carried = p.hammer_mass * ratio;
        let speed = (p.key_mass * u + carried * w) / (p.key_mass + carried * ratio);
        Reset::to(mode, [y, z, speed, ratio * speed])
    }

    /// The head lands on the jack, which is on its button in FLL.
    fn landed(&self, mode: Mode, x: &[f64; 4]) -> Reset<Self> {
        if mode == Mode::Fll {
            self.caught(Mode::Lo, self.let_off.head(&self.values, x[0]).1, x)
        } else {
            self.caught(Mode::Acc, self.values.ratio, x)
        }
    }

    /// The tripped jack is free: under the knuckle at once if the head leaves room.
    fn with_jack_free(&self, mode: Mode, x: &[f64; 4]) -> Mode {
        if mode == Mode::Stt {
            Mode::Stu
        } else if x[1] > self.values.ratio * x[0] {
            Mode::Fla
        } else {
            Mode::Rep0
        }
    }

    /// Off the string: where the jack is by then.
    fn off_string(&self, mode: Mode, x: &[f64; 4]) -> Mode {
        if mode == Mode::Stt {
            Mode::Flt
        } else if x[0] < self.values.button {
            Mode::Fla
        } else {
            Mode::Fll
        }
    }

    /// On the repetition lever: with the check near or far.
    pub(super) fn on_lever(&self, x: &[f64; 4]) -> Mode {
        if x[0] > self.values.check_from { Mode::RepH } else { Mode::RepL }
    }
}

/// The mode that follows when `guard` fires in `mode` and keeps the state.
const fn plain(mode: Mode, guard: GuardId) -> Mode {
    let is_apart = matches!(mode, Mode::Fla | Mode::Fll);
    match guard {
        LIFT_OFF if matches!(mode, Mode::Lo) => Mode::Fll,
        BUTTON if is_apart => Mode::Fll,
        BUTTON => Mode::Lo,
        BUTTON_OFF if is_apart => Mode::Fla,
        BUTTON_OFF => Mode::Acc,
        TRIP if matches!(mode, Mode::Stu) => Mode::Stt,
        TRIP => Mode::Flt,
        REP_OFF if !matches!(mode, Mode::Rep0) => Mode::Flt,
        CHECK_NEAR => Mode::RepH,
        LIFT_OFF | REP_OFF | JACK_IN => Mode::Fla,
        // The key leaves the check's range, the check lets go, or the jack is out again.
        _ => Mode::RepL,
    }
}

impl Resets for ReducedGrand {
    /// Landing and check are plastic, the string is met exactly; all else keeps the state.
    fn reset(&self, mode: Mode, guard: GuardId, x: &[f64; 4], _s: &Motion) -> Reset<Self> {
        match guard {
            LAND => self.landed(mode, x),
            CHECK => self.caught(Mode::Chk, self.values.check_ratio, x),
            STRING_ON => {
                let next = if mode == Mode::Flt { Mode::Stt } else { Mode::Stu };
                Reset::to(next, [x[0], self.values.string, x[2], x[3]])
            }
            STRING_OFF => Reset::to(self.off_string(mode, x), *x),
            REP_ON => Reset::to(self.on_lever(x), *x),
            RESET => Reset::to(self.with_jack_free(mode, x), *x),
            _ => Reset::to(plain(mode, guard), *x),
        }
    }
}
