//! Planned strokes of each key, without gestures yet.

use haptics::plant::{Gesture, Touch};
use keyboard::KEYS;
use midi::{Velocity, VelocityCurve};

use crate::score::{Score, ScoreNote};

/// Playing technique of the pianist.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Technique {
    /// Hammer speed above which a key is struck from above instead of pressed (m/s). A pressed
    /// touch reaches about 4 m/s and gets heavy long before.
    pub struck_above: f64,
    /// Depth to which a finger holds a key (m).
    pub hold: f64,
    /// Silence before the first onset of the score (s), in which the first gesture begins.
    pub lead_in: f64,
}

impl Default for Technique {
    fn default() -> Self {
        Self { struck_above: 2.5, hold: Gesture::HOLD, lead_in: 1.0 }
    }
}

/// Shortest time from an onset to the wanted fall of the damper (s).
const SHORTEST: f64 = 0.03;

/// A wanted stroke of key 0 ..= 87: times of strike and damper's fall (s), hammer speed (m/s), its
/// MIDI velocity, and a release velocity, if wanted.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PlannedStroke {
    pub key: u8,
    pub onset: f64,
    pub end: f64,
    pub speed: f64,
    pub velocity: Velocity,
    pub touch: Touch,
    pub release: Option<Velocity>,
}

/// Plans the strokes of every key, 88 lists in order of onset. Onsets are later than the score's by
/// the technique's lead-in; no note ends after the next onset on its key.
pub fn plan(score: &Score, curve: VelocityCurve, technique: &Technique) -> Vec<Vec<PlannedStroke>> {
    let mut keys = vec![Vec::new(); KEYS];
    for note in &score.notes {
        if let Some(strokes) = keys.get_mut(usize::from(note.key)) {
            strokes.push(wanted(note, curve, technique));
        }
    }
    for strokes in &mut keys {
        strokes.sort_by(|a, b| a.onset.total_cmp(&b.onset));
        part(strokes);
    }
    keys
}

fn wanted(note: &ScoreNote, curve: VelocityCurve, technique: &Technique) -> PlannedStroke {
    let velocity = Velocity::nearest(f64::from(note.velocity));
    let speed = curve.speed(velocity);
    let touch = if speed > technique.struck_above { Touch::Struck } else { Touch::Pressed };
    let onset = note.onset + technique.lead_in;
    let end = note.end + technique.lead_in;
    PlannedStroke { key: note.key, onset, end, speed, velocity, touch, release: note.release }
}

/// Ends each stroke at the latest when the next on its key begins.
fn part(strokes: &mut [PlannedStroke]) {
    let mut previous: Option<&mut PlannedStroke> = None;
    for stroke in strokes {
        if let Some(previous) = previous {
            previous.end = previous.end.min(stroke.onset).max(previous.onset + SHORTEST);
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
        ScoreNote { key: 39, onset, end, velocity, release: None }
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
    fn a_note_repeated_soon_ends_as_written() {
        let strokes = planned(&[note(0.0, 0.45, 58), note(0.5, 1.2, 58), note(1.0, 1.3, 58)]);
        let ends: Vec<f64> = strokes.iter().map(|stroke| stroke.end).collect();
        assert_eq!(ends, [1.45, 2.0, 2.3], "and not after the next onset");
    }

    #[test]
    fn the_shortest_note_still_sounds() {
        assert!((planned(&[note(0.0, 0.001, 58)])[0].end - 1.03).abs() < 1e-12);
    }
}
