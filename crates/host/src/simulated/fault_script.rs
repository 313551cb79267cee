//! Faults to inject into simulated boards: `3@1.5:mute=0.2`.

/// A fault of a simulated board; each number is its length (s) unless noted.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum FaultEvent {
    Die,
    /// The board loses its power, then restarts.
    Restart(f64),
    /// Frames from the board are lost.
    Mute(f64),
    /// Frames to the board are lost.
    Deaf(f64),
    /// The board does nothing.
    Freeze(f64),
    /// The board sends random frames beside its own.
    Babble(f64),
    /// The board's clock jumps back by this time (s).
    Backwards(f64),
    KeyFault,
}

/// A fault with its board and time.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FaultScript {
    pub number: u8,
    /// Time after the first arming of the board (s).
    pub at: f64,
    pub event: FaultEvent,
}

const HELP: &str = "write NUMBER@SECONDS:WHAT, where WHAT is die, key-fault, restart=SECONDS, \
                    mute=SECONDS, deaf=SECONDS, freeze=SECONDS, babble=SECONDS or \
                    backwards=SECONDS";

impl FaultScript {
    /// Parses `3@1.5:mute=0.2`: board 3 is mute for 0.2 s, 1.5 s after it was armed.
    ///
    /// # Errors
    /// A sentence with the expected syntax.
    pub fn parse(text: &str) -> Result<Self, String> {
        parse(text).ok_or_else(|| format!("\"{text}\" is no fate: {HELP}"))
    }
}

fn parse(text: &str) -> Option<FaultScript> {
    let (number, rest) = text.split_once('@')?;
    let (at, what) = rest.split_once(':')?;
    let (what, value) = what.split_once('=').map_or((what, None), |(what, it)| (what, Some(it)));
    let event = match (what, value) {
        ("die", None) => FaultEvent::Die,
        ("key-fault", None) => FaultEvent::KeyFault,
        ("restart", Some(it)) => FaultEvent::Restart(seconds(it)?),
        ("mute", Some(it)) => FaultEvent::Mute(seconds(it)?),
        ("deaf", Some(it)) => FaultEvent::Deaf(seconds(it)?),
        ("freeze", Some(it)) => FaultEvent::Freeze(seconds(it)?),
        ("babble", Some(it)) => FaultEvent::Babble(seconds(it)?),
        ("backwards", Some(it)) => FaultEvent::Backwards(seconds(it)?),
        _ => return None,
    };
    Some(FaultScript { number: number.parse().ok()?, at: seconds(at)?, event })
}

fn seconds(text: &str) -> Option<f64> {
    text.parse().ok().filter(|it: &f64| it.is_finite() && 0.0 <= *it)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fault_names_board_time_and_event() {
        let fault = FaultScript::parse("3@1.5:mute=0.2").unwrap();
        assert_eq!(fault, FaultScript { number: 3, at: 1.5, event: FaultEvent::Mute(0.2) });
        assert_eq!(FaultScript::parse("0@0:die").unwrap().event, FaultEvent::Die);
    }

    #[test]
    fn what_is_no_fault_says_what_to_write() {
        for text in ["", "3:die", "3@x:die", "3@1:die=2", "3@1:mute", "3@-1:die", "3@1:fly=2"] {
            assert!(
                FaultScript::parse(text).unwrap_err().contains("write NUMBER@SECONDS"),
                "{text}"
            );
        }
    }
}
