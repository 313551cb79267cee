//! What is wanted of each key: strokes without gestures yet.

use haptics::plant::{Gesture, Touch};
use keyboard::KEYS;
use midi::{Velocity, VelocityCurve};

use crate::score::{Score, ScoreNote};

/// How the pianist plays.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Technique {
    /// Hammer speed above which a key is struck from above instead of pressed (m/s).
    ///
    /// A pressed touch reaches about 4 m/s and gets heavy long before.
    pub struck_above: f64,
    /// A key that is wanted again within this time is struck (s): a press would take too long.
    pub quick: f64,
    /// Least time from a damper's fall to the next onset of its key (s), for the key to come up.
    pub gap: f64,
    /// Time that a key should have from its release to the start of the next gesture (s).
    ///
    /// A grand's key returns from bottom in 35 ms, lifting the finger takes 50 ms, and the rest
    /// is room for a slower stroke than was foreseen; none begins before the finger is lifted.
    pub rise: f64,
    /// Depth to which a finger holds a key (m).
    pub hold: f64,
    /// Silence before the first onset of the score (s), for the first gesture to begin in.
    pub lead_in: f64,
}

impl Default for Technique {
    fn default() -> Self {
        Self {
            struck_above: 2.5,
            quick: 0.2,
            gap: 0.1,
            rise: 0.07,
            hold: Gesture::HOLD,
            lead_in: 1.0,
        }
    }
}

/// Shortest time from an onset to the wanted fall of the damper (s).
const SHORTEST: f64 = 0.03;

/// What is wanted of a key.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PlannedStroke {
    /// Which key, 0 ..= 87.
    pub key: u8,
    /// When the hammer is to strike (s).
    pub onset: f64,
    /// When the damper is to fall (s).
    pub end: f64,
    /// How fast the hammer is to strike (m/s).
    pub speed: f64,
    /// The MIDI velocity that this gives.
    pub velocity: Velocity,
    /// How the finger should meet the key.
    pub touch: Touch,
}

/// Plans the strokes of every key, 88 lists in order of onset.
///
/// Onsets are later than the score's by the technique's lead-in; an end that leaves the key too
/// little time to come up for its next stroke is moved earlier.
pub fn plan(score: &Score, curve: VelocityCurve, technique: &Technique) -> Vec<Vec<PlannedStroke>> {
    let mut keys = vec![Vec::new(); KEYS];
    for note in &score.notes {
        if let Some(strokes) = keys.get_mut(usize::from(note.key)) {
            strokes.push(wanted(note, curve, technique));
        }
    }
    for strokes in &mut keys {
        strokes.sort_by(|a, b| a.onset.total_cmp(&b.onset));
        make_room(strokes, technique);
    }
    keys
}

fn wanted(note: &ScoreNote, curve: VelocityCurve, technique: &Technique) -> PlannedStroke {
    let velocity = Velocity::nearest(f64::from(note.velocity));
    let speed = curve.speed(velocity);
    let touch = if speed > technique.struck_above { Touch::Struck } else { Touch::Pressed };
    let onset = note.onset + technique.lead_in;
    let end = note.end + technique.lead_in;
    PlannedStroke { key: note.key, onset, end, speed, velocity, touch }
}

/// Shortens strokes whose key is wanted again soon, and strikes where a press takes too long.
fn make_room(strokes: &mut [PlannedStroke], technique: &Technique) {
    let mut previous: Option<&mut PlannedStroke> = None;
    for stroke in strokes {
        if let Some(previous) = previous {
            previous.end = previous.end.min(stroke.onset - technique.gap);
            previous.end = previous.end.max(previous.onset + SHORTEST);
            if stroke.onset - previous.onset < technique.quick {
                stroke.touch = Touch::Struck;
            }
        }
        previous = Some(stroke);
    }
    if let Some(last) = previous {
        last.end = last.end.max(last.onset + SHORTEST);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn note(onset: f64, end: f64, velocity: u8) -> ScoreNote {
        ScoreNote { key: 39, onset, end, velocity }
    }

    fn planned(notes: &[ScoreNote]) -> Vec<PlannedStroke> {
        let score = Score { notes: notes.to_vec(), ..Score::default() };
        plan(&score, VelocityCurve::Disklavier, &Technique::default()).swap_remove(39)
    }

    #[test]
    fn a_lone_soft_note_is_pressed_as_written() {
        let strokes = planned(&[note(0.0, 1.0, 58)]);
        assert_eq!((strokes[0].onset, strokes[0].end), (1.0, 2.0));
        assert_eq!(strokes[0].touch, Touch::Pressed);
        assert!((strokes[0].speed - 1.0).abs() < 0.01, "58 is 1 m/s");
    }

    #[test]
    fn a_loud_note_is_struck() {
        assert_eq!(planned(&[note(0.0, 1.0, 100)])[0].touch, Touch::Struck);
    }

    #[test]
    fn a_note_repeated_soon_ends_earlier() {
        let strokes = planned(&[note(0.0, 0.5, 58), note(0.5, 1.0, 58)]);
        assert!((strokes[0].end - 1.4).abs() < 1e-12);
        assert_eq!(strokes[1].touch, Touch::Pressed);
    }

    #[test]
    fn a_note_repeated_at_once_is_struck_and_still_sounds() {
        let strokes = planned(&[note(0.0, 0.1, 58), note(0.1, 1.0, 58)]);
        assert!((strokes[0].end - 1.03).abs() < 1e-12);
        assert_eq!(strokes[1].touch, Touch::Struck);
    }

    #[test]
    fn a_key_that_does_not_exist_is_left_out() {
        let score = Score {
            notes: vec![ScoreNote { key: 88, onset: 0.0, end: 1.0, velocity: 60 }],
            ..Score::default()
        };
        let keys = plan(&score, VelocityCurve::Disklavier, &Technique::default());
        assert!(keys.iter().all(Vec::is_empty));
    }
}
