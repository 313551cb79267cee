//! What is to happen to a simulated board, and when: `3@1.5:mute=0.2`.

/// What happens to a board.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum FaultEvent {
    /// It is gone, and its link with it.
    Die,
    /// It loses its power for so long (s), and then starts anew.
    Restart(f64),
    /// What it sends does not leave it for so long (s).
    Mute(f64),
    /// What is sent to it does not reach it for so long (s).
    Deaf(f64),
    /// It does nothing for so long (s).
    Freeze(f64),
    /// It sends frames of chance beside its own for so long (s).
    Babble(f64),
    /// Its clock goes back by so much (s).
    Backwards(f64),
    /// One of its keys fails.
    KeyFault,
}

/// A blow, to whom and when.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FaultScript {
    /// Number of the board.
    pub number: u8,
    /// Time after it was armed for the first time (s).
    pub at: f64,
    pub blow: FaultEvent,
}

/// What may be written.
const HELP: &str = "write NUMBER@SECONDS:WHAT, where WHAT is die, key-fault, restart=SECONDS, \
                    mute=SECONDS, deaf=SECONDS, freeze=SECONDS, babble=SECONDS or \
                    backwards=SECONDS";

impl FaultScript {
    /// Reads `3@1.5:mute=0.2`: board 3, a second and a half after it was armed, is mute for a
    /// fifth of a second.
    ///
    /// # Errors
    /// A sentence on what to write.
    pub fn parse(text: &str) -> Result<Self, String> {
        parse(text).ok_or_else(|| format!("\"{text}\" is no fate: {HELP}"))
    }
}

fn parse(text: &str) -> Option<FaultScript> {
    let (number, rest) = text.split_once('@')?;
    let (at, what) = rest.split_once(':')?;
    let (what, value) = what.split_once('=').map_or((what, None), |(what, it)| (what, Some(it)));
    let blow = match (what, value) {
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
    Some(FaultScript { number: number.parse().ok()?, at: seconds(at)?, blow })
}

/// A time that is not negative (s).
fn seconds(text: &str) -> Option<f64> {
    text.parse().ok().filter(|it: &f64| it.is_finite() && 0.0 <= *it)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fate_names_board_time_and_blow() {
        let fate = FaultScript::parse("3@1.5:mute=0.2").unwrap();
        assert_eq!(fate, FaultScript { number: 3, at: 1.5, blow: FaultEvent::Mute(0.2) });
        assert_eq!(FaultScript::parse("0@0:die").unwrap().blow, FaultEvent::Die);
    }

    #[test]
    fn what_is_no_fate_says_what_to_write() {
        for text in ["", "3:die", "3@x:die", "3@1:die=2", "3@1:mute", "3@-1:die", "3@1:fly=2"] {
            assert!(
                FaultScript::parse(text).unwrap_err().contains("write NUMBER@SECONDS"),
                "{text}"
            );
        }
    }
}
