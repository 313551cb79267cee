//! A piece while it is read: where it is, and what sounds.

use super::curve::Curve;
use super::token::{QUARTER, Token};

/// Pause between lifting the pedal and pressing it again (ticks): the new harmony is there.
const PEDAL_PAUSE: u32 = QUARTER / 4;

/// How much louder the first beat of a bar is than a weak beat, in MIDI units.
const DOWNBEAT: f64 = 4.0;

/// How much louder the middle of a bar is, in MIDI units.
const MIDDLE: f64 = 2.0;

/// How much softer a note off the beat is, in MIDI units.
const OFFBEAT: f64 = -2.0;

/// A note that sounds from one tick to another.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Sound {
    pub(super) pitch: u8,
    pub(super) from: u32,
    pub(super) to: u32,
    pub(super) velocity: u8,
}

/// One line of the music.
#[derive(Clone, PartialEq, Debug)]
struct Voice {
    name: String,
    /// How much louder than the dynamics say, in MIDI units.
    louder: f64,
    /// Indices of the sounds that are held over.
    tied: Vec<usize>,
    /// Where it has come to in this bar (ticks); `None` if it is silent in it.
    filled: Option<u32>,
}

/// A piece as far as it has been read.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Piece {
    pub(super) title: String,
    pub(super) composer: String,
    pub(super) tempo: Curve,
    pub(super) dynamics: Curve,
    pub(super) sounds: Vec<Sound>,
    /// Moves of the pedal: when, and whether down.
    pub(super) pedals: Vec<(u32, bool)>,
    voices: Vec<Voice>,
    /// Beats in a bar, and ticks in a beat.
    meter: (u32, u32),
    /// The bar that is being read, counted from 1; 0 before the first.
    bar: u32,
    /// Where it begins (ticks).
    start: u32,
}

impl Piece {
    pub(super) fn start(&self) -> u32 {
        self.start
    }

    /// Length of a bar (ticks).
    pub(super) fn bar_length(&self) -> u32 {
        self.meter.0 * self.meter.1
    }

    /// Where the piece ends (ticks).
    pub(super) fn end(&self) -> u32 {
        self.sounds.iter().map(|sound| sound.to).max().unwrap_or_default()
    }

    pub(super) fn choose_meter(&mut self, beats: u32, unit: u32) -> Result<(), String> {
        if beats == 0 || !unit.is_power_of_two() || unit > 16 {
            return Err(format!("{beats}/{unit} is not a meter"));
        }
        self.meter = (beats, 4 * QUARTER / unit);
        Ok(())
    }

    pub(super) fn add_voice(&mut self, name: &str, louder: f64) {
        self.voices.push(Voice { name: name.to_owned(), louder, tied: Vec::new(), filled: None });
    }

    /// Begins `bar`, which must be the next.
    pub(super) fn begin_bar(&mut self, bar: u32) -> Result<(), String> {
        self.finish_bar()?;
        if self.bar_length() == 0 {
            return Err("say the meter before the first bar".to_owned());
        }
        if bar != self.bar + 1 {
            return Err(format!("this is bar {}, not {bar}", self.bar + 1));
        }
        if self.bar > 0 {
            self.start += self.bar_length();
        }
        self.bar = bar;
        Ok(())
    }

    /// Checks that every voice that plays in this bar fills it.
    pub(super) fn finish_bar(&mut self) -> Result<(), String> {
        let whole = self.bar_length();
        for voice in &mut self.voices {
            let filled = voice.filled.take();
            if filled.is_some_and(|filled| filled != whole) {
                return Err(format!("voice {} does not fill bar {}", voice.name, self.bar));
            }
            if filled.is_none() {
                voice.tied.clear();
            }
        }
        Ok(())
    }

    /// Lets the voice called `name` go on with `tokens`.
    pub(super) fn play(&mut self, name: &str, tokens: &[Token]) -> Result<(), String> {
        let index = self.voices.iter().position(|voice| voice.name == name);
        let index = index.ok_or_else(|| format!("no voice is called \"{name}\""))?;
        self.play_voice(index, tokens)
    }

    /// Lets voice `index`, in the order in which they were named, go on with `tokens`.
    pub(super) fn play_voice(&mut self, index: usize, tokens: &[Token]) -> Result<(), String> {
        if self.bar == 0 || index >= self.voices.len() {
            return Err("name the voices, and begin a bar, before the notes".to_owned());
        }
        for token in tokens {
            self.sound(index, token);
        }
        Ok(())
    }

    fn sound(&mut self, voice: usize, token: &Token) {
        let filled = self.voices[voice].filled.unwrap_or_default();
        let from = self.start + filled;
        let held = std::mem::take(&mut self.voices[voice].tied);
        let mut sounding = Vec::new();
        for &pitch in &token.pitches {
            let tied = held.iter().copied().find(|index| self.sounds[*index].pitch == pitch);
            let index = tied.unwrap_or(self.sounds.len());
            if tied.is_none() {
                let velocity = self.velocity(from, filled, self.voices[voice].louder);
                self.sounds.push(Sound { pitch, from, to: from, velocity });
            }
            self.sounds[index].to = from + token.length;
            sounding.push(index);
        }
        let voice = &mut self.voices[voice];
        voice.filled = Some(filled + token.length);
        if token.is_tied {
            voice.tied = sounding;
        }
    }

    /// Velocity of a note at tick `at`, which is `filled` ticks after the bar line.
    fn velocity(&self, at: u32, filled: u32, louder: f64) -> u8 {
        let accent = if filled == 0 {
            DOWNBEAT
        } else if 2 * filled == self.bar_length() {
            MIDDLE
        } else if filled.is_multiple_of(self.meter.1) {
            0.0
        } else {
            OFFBEAT
        };
        midi::Velocity::nearest(self.dynamics.at(at) + louder + accent).get()
    }

    /// Lifts the pedal `at` ticks after the bar line if it is down, and presses it soon after.
    pub(super) fn change_pedal(&mut self, at: u32) {
        self.lift_pedal(at);
        self.pedals.push((self.start + at + PEDAL_PAUSE, true));
    }

    /// Lifts the pedal `at` ticks after the bar line if it is down.
    pub(super) fn lift_pedal(&mut self, at: u32) {
        if self.pedals.last().is_some_and(|pedal| pedal.1) {
            self.pedals.push((self.start + at, false));
        }
    }

    /// Ticks from the bar line to `beat`, counted from 1.
    pub(super) fn beat(&self, beat: u32) -> Result<u32, String> {
        let (n_beats, ticks) = self.meter;
        let index = beat.checked_sub(1).filter(|index| *index < n_beats);
        index.map(|index| index * ticks).ok_or_else(|| format!("a bar has no beat {beat}"))
    }
}
