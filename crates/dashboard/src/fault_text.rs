//! Explanations of faults, with remedies.

use telemetry::event::Kind;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Explanation {
    pub(crate) name: &'static str,
    pub(crate) what: &'static str,
    pub(crate) advice: &'static str,
}

/// Explains the fault of a key: see `KeyBlock.fault`.
pub(crate) const fn fault(code: u8) -> Option<Explanation> {
    let (name, what, advice) = match code {
        0 => return None,
        1 => (
            "not finite",
            "The model's force was no number. The key feels no force, and its voice begins anew at rest.",
            "Look at what was changed last: take it back, or make stiff springs softer.",
        ),
        2 => (
            "bad sample",
            "The key's position was no number, or too old to be followed.",
            "Look at the key's board and cable in Links: gaps and refused frames are counted there.",
        ),
        3 => (
            "capped",
            "The model wanted more work than a tick may do, so the tick was ended at its last good state.",
            "Softer springs, more damping, or a higher tick rate; or impacts that pile up want a mode of rest.",
        ),
        4 => (
            "diverged",
            "The model made energy out of nothing, so its force cannot be trusted.",
            "Take the last change back; with rigid contacts, raise the tick rate or filter less.",
        ),
        5 => (
            "panicked",
            "The model's program failed. Its voice is not run until it is replaced.",
            "Use another instrument on this key, and report what was changed before.",
        ),
        6 => (
            "makes energy",
            "The key gave back more energy than was put into it, as an unstable loop does. It is muted.",
            "Raise the tick rate, lower jerk_density, or make stiff springs softer.",
        ),
        _ => (
            "muted",
            "The key made energy or failed again and again. It feels no force.",
            "Change its values or its instrument: it is tried again then.",
        ),
    };
    Some(Explanation { name, what, advice })
}

pub(crate) const fn event(kind: Kind) -> Option<Explanation> {
    let (name, what, advice) = match kind {
        Kind::Fault => (
            "voice failed",
            "A key's voice could not be trusted: its force faded to zero in 20 ms.",
            "See which fault it is at the key itself.",
        ),
        Kind::Recovery => {
            ("voice is back", "A key's voice can be trusted again.", "Nothing to do.")
        }
        Kind::Miss => (
            "deadline missed",
            "Forces of a tick came too late; keys felt the force of the tick before.",
            "Deadlines says whether the machine was late or the tick too long.",
        ),
        Kind::Skip => (
            "ticks skipped",
            "The tick was so late that the next one was due; ticks between were never run.",
            "Give the host real-time priority and processors of its own.",
        ),
        Kind::Disarm => (
            "forces fade",
            "No voice is felt any more; all forces fade in 20 ms.",
            "The run is ending, or was stopped.",
        ),
        Kind::Overload => (
            "overload",
            "A tick has more work than time, so something is left out, in the order of the scene.",
            "Give a lower rate, more lanes, or fewer or simpler instruments.",
        ),
        Kind::Starved => (
            "voices starved",
            "Voices waited although the tick had time, so their keys felt an old force.",
            "This is an error of the host: report it with a recording.",
        ),
        Kind::Board => ("board or link", "A board or a link changed its state.", "See Links."),
        Kind::Unknown
        | Kind::Switch
        | Kind::Strike
        | Kind::DamperLift
        | Kind::Pressure
        | Kind::DamperFall
        | Kind::Change
        | Kind::Pedal
        | Kind::Arm => return None,
    };
    Some(Explanation { name, what, advice })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_fault_is_explained() {
        assert_eq!(fault(0), None);
        for code in 1..=7 {
            let explanation = fault(code).expect("a fault");
            assert!(explanation.what.ends_with('.') && explanation.advice.ends_with('.'));
        }
    }
}
