//! Access to the keys of a run: fingers on simulated ones, lights on real ones.

use boards::rt::board_supervisor::LIGHT_S;
use firmware_protocol::key::KeyIndex;
use haptics::HandCommand;
use rtrb::Producer;

use super::{FingerOwner, FingerQueue, NOT_RUNNING};

#[derive(Debug, Default)]
pub(super) enum KeyPort {
    #[default]
    Closed,
    Simulated(FingerQueue),
    Boards(Lights),
}

/// Access to the lights of a run's boards.
#[derive(Debug)]
pub struct Lights {
    /// Boards in the order of the bus.
    pub boards: Vec<IdentifyTarget>,
    /// Ring for indices into `boards`.
    pub requests: Producer<usize>,
}

/// A board with a light.
#[derive(Debug)]
pub struct IdentifyTarget {
    pub line: u32,
    pub name: String,
    pub board: u32,
}

impl std::fmt::Display for IdentifyTarget {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "board {} on {} (link {})", self.board, self.name, self.line)
    }
}

/// Largest force of a finger: its weight plus a blow (N).
const HARDEST: f64 = figures::weight::HEAVIEST;

/// Range of the pull of a gripping hand, in fractions of the key's dip.
const HIGHEST: f64 = -1.0;
const DEEPEST: f64 = 2.0;

impl KeyPort {
    /// Presses a simulated key or grips it for `by`; no weight releases it.
    ///
    /// # Errors
    /// A sentence if the key is missing or real, or the ring is full.
    pub(super) fn press(
        &mut self,
        key: u8,
        hand: HandCommand,
        by: FingerOwner,
    ) -> Result<(), String> {
        let key =
            KeyIndex::new(key).ok_or_else(|| format!("there is no key {key}, give 0 to 87"))?;
        match hand {
            HandCommand::Weight(newtons) if !(0.0..=HARDEST).contains(&newtons) => {
                return Err(format!("a key is pressed with 0 to {HARDEST} N, not {newtons:?}"));
            }
            HandCommand::Grip(depth) if !(HIGHEST..=DEEPEST).contains(&depth) => {
                return Err(format!(
                    "a hand holds a key at {HIGHEST} to {DEEPEST} times its dip, not {depth:?}"
                ));
            }
            HandCommand::Weight(_) | HandCommand::Grip(_) => {}
        }
        match self {
            Self::Closed => Err(NOT_RUNNING.into()),
            Self::Boards(_) => Err("these keys are real: press them yourself".into()),
            Self::Simulated(fingers) => fingers.press(key, hand, by),
        }
    }

    /// Releases all keys pressed by `connection`.
    pub(super) fn leave(&mut self, connection: u64) {
        if let Self::Simulated(fingers) = self {
            fingers.leave(connection);
        }
    }

    /// Switches on a board's light; the error is a sentence.
    pub(super) fn identify(&mut self, line: u32, board: u32) -> Result<String, String> {
        match self {
            Self::Closed => Err(NOT_RUNNING.into()),
            Self::Simulated(_) => Err("these keys are simulated here, and have no lights".into()),
            Self::Boards(lights) => lights.request(line, board),
        }
    }
}

impl Lights {
    fn request(&mut self, line: u32, board: u32) -> Result<String, String> {
        let Self { boards, requests } = self;
        let index = boards.iter().position(|it| (it.line, it.board) == (line, board));
        let index = index.ok_or_else(|| {
            let all: Vec<_> = boards.iter().map(IdentifyTarget::to_string).collect();
            format!("there is no board {board} on link {line}, but {}", all.join(", "))
        })?;
        requests.push(index).map_err(|_full| "too many lights are wanted at once; try again")?;
        Ok(format!("{} is asked to show its light for {LIGHT_S} s", boards[index]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_weight_of_300_digits_is_refused_in_a_few() {
        let refused = KeyPort::default().press(39, HandCommand::Weight(1e300), None).unwrap_err();
        assert!(refused.ends_with(" N, not 1e300"), "{refused}");
    }

    #[test]
    fn a_board_that_is_not_there_is_refused_with_those_that_are() {
        let mut port = KeyPort::default();
        let refused = port.identify(0, 3).unwrap_err();
        assert!(refused.contains("not running yet"), "{refused}");
        let (requests, mut shown) = rtrb::RingBuffer::new(1);
        let target = |line, board| IdentifyTarget { line, name: format!("can{line}"), board };
        port = KeyPort::Boards(Lights { boards: vec![target(0, 3), target(1, 3)], requests });
        let refused = port.identify(0, 4).unwrap_err();
        assert!(refused.contains("board 3 on can1 (link 1)"), "{refused}");
        assert_eq!(
            port.identify(1, 3).unwrap(),
            "board 3 on can1 (link 1) is asked to show its light for 10 s"
        );
        assert_eq!(shown.pop(), Ok(1));
        let refused = port.press(3, HandCommand::Weight(1.0), None).unwrap_err();
        assert!(refused.contains("real"), "{refused}");
    }
}
