//! A SoundFont player that begins each note at its own frame.

use crate::message::Message;
use crate::note::Note;
use keyboard::KEYS;
use rustysynth::{Synthesizer, SynthesizerSettings};

use super::{Font, SoundError};

/// Frames between two polls of a synthesizer for messages.
const BLOCK: usize = 64;

/// Status of a program change.
const PROGRAM: i32 = 0xC0;

/// Channel of drums, counted from 0 as all channels.
const DRUMS: u8 = 9;

const LAST: u8 = 15;

/// Program of General MIDI of each key, 1 ..= 128.
pub type Programs = [u8; KEYS];

/// Notes of a synthesizer; a font may need two for a key.
const POLYPHONY: usize = 32;

/// Plays messages with a font, in stereo.
///
/// A synthesizer begins its notes at the start of its block of 64 frames only. So there is
/// one for each phase of the block, and each note is given to that whose block begins with it.
/// Controllers and the ends of notes go to all of them, and are up to a block late.
#[derive(Debug)]
pub struct Sampler {
    phases: Vec<Synthesizer>,
    /// Channel of each key; keys of one program share one.
    channels: [u8; KEYS],
    now: u64,
    part: [Vec<f32>; 2],
}

impl Sampler {
    /// Returns a silent sampler of `rate` (frames per second), with the sounds of `programs`.
    pub fn new(font: &Font, rate: u32, programs: &Programs) -> Result<Self, SoundError> {
        let wrong = || SoundError::Rate(rate);
        let mut settings = SynthesizerSettings::new(rate.try_into().map_err(|_large| wrong())?);
        settings.block_size = BLOCK;
        settings.maximum_polyphony = POLYPHONY;
        // Each phase would have its own.
        settings.enable_reverb_and_chorus = false;
        let channels = channels(programs);
        let phases = (0..BLOCK).map(|phase| {
            let mut synthesizer = Synthesizer::new(&font.font, &settings).ok()?;
            let (mut left, mut right) = ([0.0; BLOCK], [0.0; BLOCK]);
            let before = (BLOCK - phase) % BLOCK;
            synthesizer.render(&mut left[..before], &mut right[..before]);
            for (channel, program) in channels.iter().zip(programs) {
                let program = i32::from(program.saturating_sub(1));
                synthesizer.process_midi_message(i32::from(*channel), PROGRAM, program, 0);
            }
            Some(synthesizer)
        });
        let phases = phases.collect::<Option<_>>().ok_or_else(wrong)?;
        Ok(Self { phases, channels, now: 0, part: [vec![0.0; BLOCK], vec![0.0; BLOCK]] })
    }

    /// Returns the number of frames rendered so far.
    pub const fn now(&self) -> u64 {
        self.now
    }

    /// Plays `message` with the next frame.
    pub fn play(&mut self, message: Message) {
        // A pressure has two bytes, and is ignored as pedals beside the sustain pedal are.
        let bytes = message.encode();
        let [status, first, second] =
            [0, 1, 2].map(|index| i32::from(bytes.get(index).copied().unwrap_or(0)));
        let status = status & 0xF0;
        let (begins, channels) = match message {
            Message::NoteOn { note, .. } => (true, self.channels_of(note)),
            Message::NoteOff { note, .. } | Message::KeyPressure { note, .. } => {
                (false, self.channels_of(note))
            }
            Message::ControlChange { .. } | Message::ChannelPressure { .. } => (false, 0..=LAST),
        };
        let mine = usize::try_from(self.now % BLOCK as u64).unwrap_or(0);
        let all = self.phases.iter_mut().enumerate();
        for (_, synthesizer) in all.filter(|(phase, _)| !begins || *phase == mine) {
            for channel in channels.clone() {
                synthesizer.process_midi_message(channel.into(), status, first, second);
            }
        }
    }

    fn channels_of(&self, note: Note) -> std::ops::RangeInclusive<u8> {
        let channel = self.channels[usize::from(note.key())];
        channel..=channel
    }

    /// Renders the next frames into `left` and `right`, which have the same length.
    pub fn render(&mut self, left: &mut [f32], right: &mut [f32]) {
        for (left, right) in left.chunks_mut(BLOCK).zip(right.chunks_mut(BLOCK)) {
            left.fill(0.0);
            right.fill(0.0);
            let n = left.len().min(right.len());
            let [part_left, part_right] = self.part.each_mut().map(|it| &mut it[..n]);
            for synthesizer in &mut self.phases {
                synthesizer.render(part_left, part_right);
                add(left, part_left);
                add(right, part_right);
            }
            self.now += n as u64;
        }
    }
}

/// Returns a channel for each program, except that of drums; excess programs share the last.
fn channels(programs: &Programs) -> [u8; KEYS] {
    let mut known = Vec::new();
    programs.map(|program| {
        let index = known.iter().position(|it| *it == program).unwrap_or_else(|| {
            known.push(program);
            known.len() - 1
        });
        let channel = u8::try_from(index).unwrap_or(LAST);
        if channel < DRUMS { channel } else { (channel + 1).min(LAST) }
    })
}

fn add(sum: &mut [f32], part: &[f32]) {
    for (sum, part) in sum.iter_mut().zip(part) {
        *sum += part;
    }
}
