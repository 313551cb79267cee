//! What is to happen to a simulated board, and when: `3@1.5:mute=0.2`.

/// What happens to a board.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Blow {
    /// It is gone, and its link with it.
    Die,
    /// It loses its power for so long [s], and then starts anew.
    Restart(f64),
    /// What it sends does not leave it for so long [s].
    Mute(f64),
    /// What is sent to it does not reach it for so long [s].
    Deaf(f64),
    /// It does nothing for so long [s].
    Freeze(f64),
    /// It sends frames of chance beside its own for so long [s].
    Babble(f64),
    /// Its clock goes back by so much [s].
    Backwards(f64),
    /// One of its keys fails.
    KeyFault,
}

/// A blow, to whom and when.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Fate {
    /// Number of the board.
    pub number: u8,
    /// Time after it was armed for the first time [s].
    pub at: f64,
    /// What happens.
    pub blow: Blow,
}

/// What may be written.
const HELP: &str = "write NUMBER@SECONDS:WHAT, where WHAT is die, key-fault, restart=SECONDS, \
                    mute=SECONDS, deaf=SECONDS, freeze=SECONDS, babble=SECONDS or \
                    backwards=SECONDS";

impl Fate {
    /// Reads `3@1.5:mute=0.2`: board 3, a second and a half after it was armed, is mute for a
    /// fifth of a second.
    ///
    /// # Errors
    /// A sentence on what to write.
    pub fn parse(text: &str) -> Result<Self, String> {
        parse(text).ok_or_else(|| format!("\"{text}\" is no fate: {HELP}"))
    }
}

fn parse(text: &str) -> Option<Fate> {
    let (number, rest) = text.split_once('@')?;
    let (at, what) = rest.split_once(':')?;
    let (what, value) = what.split_once('=').map_or((what, None), |(what, it)| (what, Some(it)));
    let blow = match (what, value) {
        ("die", None) => Blow::Die,
        ("key-fault", None) => Blow::KeyFault,
        ("restart", Some(it)) => Blow::Restart(seconds(it)?),
        ("mute", Some(it)) => Blow::Mute(seconds(it)?),
        ("deaf", Some(it)) => Blow::Deaf(seconds(it)?),
        ("freeze", Some(it)) => Blow::Freeze(seconds(it)?),
        ("babble", Some(it)) => Blow::Babble(seconds(it)?),
        ("backwards", Some(it)) => Blow::Backwards(seconds(it)?),
        _ => return None,
    };
    Some(Fate { number: number.parse().ok()?, at: seconds(at)?, blow })
}

/// A time that is not negative [s].
fn seconds(text: &str) -> Option<f64> {
    text.parse().ok().filter(|it: &f64| it.is_finite() && 0.0 <= *it)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fate_names_board_time_and_blow() {
        let fate = Fate::parse("3@1.5:mute=0.2").unwrap();
        assert_eq!(fate, Fate { number: 3, at: 1.5, blow: Blow::Mute(0.2) });
        assert_eq!(Fate::parse("0@0:die").unwrap().blow, Blow::Die);
    }

    #[test]
    fn what_is_no_fate_says_what_to_write() {
        for text in ["", "3:die", "3@x:die", "3@1:die=2", "3@1:mute", "3@-1:die", "3@1:fly=2"] {
            assert!(Fate::parse(text).unwrap_err().contains("write NUMBER@SECONDS"), "{text}");
        }
    }
}
