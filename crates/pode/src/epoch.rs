//! Stand of a guard when an epoch, a tick or a step begins: the rule at g = 0.
//!
//! Both guards of the paper's figure 6 start at zero, which it names as a source of faulty
//! transitions. Nothing is nudged here; the guard's rates decide:
//!
//! | g | g' | g'' | stands | and then |
//! |---|---|---|---|---|
//! | + | | | `Armed` | fires when it falls through zero |
//! | 0 | + | | `Departing` | silent until it has been positive |
//! | 0 | − | | `Leaving` | fires at once |
//! | 0 | 0 | + | `Departing` | |
//! | 0 | 0 | − | `Leaving` | |
//! | 0 | 0 | 0 | `Resting` | silent while it stays zero; fires where it turns negative |
//! | − | | | `Leaving` | fires at once; `Disarmed` if it fires on crossings only |
//!
//! Zero means within rounding at the guard's size or, right after an event, within the guard's rate
//! times the width to which that event was located.
//!
//! A guard that its own reset map leaves at zero or below is `Spent`, and silent like a disarmed
//! one. If it then sinks, and the reset map would turn it there, as an impact turns a body at rest
//! on a floor, it fires again where it leaves zero.
//!
//! So is the guard of a contact that has opened since its force vanished, where the error of its
//! constraint leaves it below zero ([`Reset::released`](crate::Reset::released)).
//!
//! A guard that fires on crossings only is also `Leaving` if it crossed at the instant of another
//! one that fired first, or in a jump of the input.

use crate::guard::{Fires, GuardSpec, GuardValue};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Stand {
    Armed,
    Departing,
    Resting,
    Disarmed,
    Spent,
    /// Spent, but its reset map would turn it: it fires where it leaves zero.
    Sinking,
    Leaving,
    Unwatched,
}

/// Returns the stand of a guard by its value and rate, over the `h` (s) ahead. `since_event` is the
/// width (s) to which the event just before was located, or 0.
#[inline]
pub(crate) fn stand(spec: &GuardSpec, guard: GuardValue, h: f64, since_event: f64) -> Stand {
    let zero = spec.band() + guard.rate.abs() * since_event;
    let drift = guard.rate * h;
    if guard.value > zero {
        Stand::Armed
    } else if guard.value < -zero {
        below(spec)
    } else if drift > spec.band() {
        Stand::Departing
    } else if drift < -spec.band() {
        below(spec)
    } else {
        Stand::Resting
    }
}

const fn below(spec: &GuardSpec) -> Stand {
    match spec.fires {
        Fires::WhileNegative => Stand::Leaving,
        Fires::OnCrossing => Stand::Disarmed,
    }
}

impl Stand {
    /// Returns the stand after `before`: a disarmed guard stays so until it has been positive.
    #[inline]
    pub(crate) fn again(self, before: Self) -> Self {
        let is_off = matches!(before, Self::Disarmed | Self::Spent);
        if is_off && self != Self::Armed { before } else { self }
    }

    /// Returns the stand of a guard that crossed, unfired: another one fired, or the input jumped.
    #[inline]
    pub(crate) fn crossed(self) -> Self {
        if self == Self::Disarmed { Self::Leaving } else { self }
    }
}

#[inline]
pub(crate) fn stand_after(before: Stand, spec: &GuardSpec, end: GuardValue, h: f64) -> Stand {
    if end.value > spec.band() {
        return Stand::Armed;
    }
    match before {
        Stand::Armed | Stand::Departing if end.value > 0.0 => Stand::Armed,
        Stand::Disarmed | Stand::Spent | Stand::Unwatched => before,
        Stand::Departing if end.rate > 0.0 => Stand::Departing,
        Stand::Armed | Stand::Departing | Stand::Resting | Stand::Leaving | Stand::Sinking => {
            if end.rate * h > spec.band() { Stand::Departing } else { Stand::Resting }
        }
    }
}
