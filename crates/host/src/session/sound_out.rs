//! Sound and picture of a run, beside its MIDI output.

use std::path::{Path, PathBuf};

use documents::shown;
use figures::plot::color::{CURVES, Color};
use figures::plot::picture::{Picture, PictureArea, PictureAxis, PicturePanel};
use firmware_protocol::key::KeyIndex;
use midi::sound::{Font, LiveSound, Programs, SoundError, WavFile};
use midi::{Message, MidiSendError, Output};

use super::SessionError;
use super::midi_out::{OpenedOutput, refuse_without_folder};
use crate::midi_thread::AnyOutput;
use scene::{Instrument, Scene, SoundConfig};

struct Tee(Vec<AnyOutput>);

impl Tee {
    /// Calls each output; returns the first error.
    fn all(
        &mut self,
        call: impl FnMut(&mut AnyOutput) -> Result<(), MidiSendError>,
    ) -> Result<(), MidiSendError> {
        self.0.iter_mut().map(call).fold(Ok(()), Result::and)
    }
}

impl Output for Tee {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        self.all(|it| it.send(at, message))
    }

    fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        self.all(|it| it.poll(now))
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        self.all(AnyOutput::finish)
    }
}

/// Returns `output` together with the sounds of `scene`, which `midi` reports.
pub(super) fn add(
    scene: &Scene,
    output: AnyOutput,
    midi: &mut OpenedOutput,
) -> Result<AnyOutput, SessionError> {
    let SoundConfig { is_live, wav, picture, font } = &scene.midi.sound;
    let (mut outputs, mut words, mut counters) = (vec![output], Vec::new(), None);
    for path in wav.iter().chain(picture) {
        refuse_without_folder(path)?;
    }
    if *is_live || wav.is_some() {
        let font = Font::find(font.as_deref())?;
        let programs = programs(scene);
        if *is_live {
            match LiveSound::open(&font, &programs) {
                Ok(live) => {
                    words.push(format!("sound: {} with {}", live.name(), font.name()));
                    counters = Some(live.counters());
                    outputs.push(Box::new(live));
                }
                // It is heard from the file.
                Err(SoundError::NoDevice) if wav.is_some() => {
                    words.push("no sound device is here".into());
                }
                Err(error) => return Err(error.into()),
            }
        }
        if let Some(path) = wav {
            words.push(format!("sound: {} with {}", shown(path), font.name()));
            outputs.push(Box::new(WavFile::new(path, font, programs)));
        }
    }
    if let Some(path) = picture {
        words.push(format!("picture: {}", shown(path)));
        outputs.push(Box::new(NotePicture::new(path, scene.name.clone())));
    }
    if outputs.len() == 1 {
        return Ok(outputs.remove(0));
    }
    midi.hear(words.join("; "), counters);
    Ok(Box::new(Tee(outputs)))
}

/// Returns the General MIDI program of each key's model; a piano for a model without one.
fn programs(scene: &Scene) -> Programs {
    let program = |key: usize| {
        let voice = scene.keys.get(key)?.as_ref()?;
        let program = Instrument::of_model(&voice.model).iter().find_map(|it| it.program);
        u8::try_from(program?).ok()
    };
    std::array::from_fn(|key| program(key).unwrap_or(1))
}

struct NotePicture {
    path: PathBuf,
    title: String,
    /// Key, velocity, onset and end (s) of each note.
    notes: Vec<(u8, u8, f64, f64)>,
}

impl NotePicture {
    fn new(path: &Path, title: String) -> Self {
        Self { path: path.into(), title, notes: Vec::new() }
    }

    fn picture(&self) -> Picture {
        let keys = self.notes.iter().map(|note| f64::from(note.0));
        let (low, high) =
            keys.fold((87.0, 0.0), |(low, high), key| (f64::min(low, key), f64::max(high, key)));
        let end = self.notes.iter().map(|note| note.3.min(1e5)).fold(1.0, f64::max);
        let names = (0..=87).filter_map(KeyIndex::new).map(|key| key.to_string()).collect();
        let axis = PictureAxis { names, ..PictureAxis::linear("key") };
        let areas = self.notes.iter().map(|&(key, velocity, onset, end)| PictureArea {
            x: (onset, end),
            y: Some((f64::from(key) - 0.45, f64::from(key) + 0.45)),
            color: shade(velocity),
            name: String::new(),
            text: String::new(),
        });
        let panel = PicturePanel {
            x: PictureAxis::linear("time [s]").between((0.0, end)),
            y: vec![axis.between((low - 1.0, high + 1.0))],
            areas: areas.collect(),
            ..PicturePanel::default()
        };
        let notes =
            vec![format!("{} notes as they sound, the louder the darker", self.notes.len())];
        Picture { notes, size: (1000.0, 420.0), ..Picture::of_panel(&self.title, panel) }
    }
}

fn shade(velocity: u8) -> Color {
    let Color(red, green, blue) = CURVES[0];
    let light = |part: u8| {
        let missing = u16::from(u8::MAX - part) * u16::from(127 - velocity.min(127)) / 150;
        part.saturating_add(u8::try_from(missing).unwrap_or(u8::MAX))
    };
    Color(light(red), light(green), light(blue))
}

impl Output for NotePicture {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        match message {
            Message::NoteOn { note, velocity } => {
                self.notes.push((note.key(), velocity.get(), at, f64::INFINITY));
            }
            Message::NoteOff { note, .. } => {
                let open = self.notes.iter_mut().rfind(|it| it.0 == note.key());
                if let Some(open) = open {
                    open.3 = open.3.min(at);
                }
            }
            Message::ControlChange { .. }
            | Message::KeyPressure { .. }
            | Message::ChannelPressure { .. } => {}
        }
        Ok(())
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        let written = std::fs::write(&self.path, self.picture().svg());
        written.map_err(|source| MidiSendError::Write {
            path: self.path.clone(),
            messages: self.notes.len(),
            source,
        })
    }
}
