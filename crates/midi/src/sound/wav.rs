//! Messages rendered into a WAV file.

use std::io;
use std::path::{Path, PathBuf};

use crate::message::Message;
use crate::output::{MidiSendError, Output};
use hound::{SampleFormat, WavSpec, WavWriter};

use super::{Font, Programs, Sampler, SoundError};

/// Frames per second.
const RATE: u32 = 48_000;

const CHUNK: usize = 480;

/// Longest sound after the last message (frames).
const LONGEST_TAIL: u64 = 10 * RATE as u64;

/// Amplitude that counts as silence, 80 dB below the loudest.
const SILENCE: f32 = 1e-4;

/// Output that renders its messages into a WAV file (stereo, 16 bits) when it is finished.
///
/// A message of time `t` (s) plays with frame `48000 t`, rounded.
#[derive(Debug)]
pub struct WavFile {
    path: PathBuf,
    font: Font,
    programs: Programs,
    messages: Vec<(f64, Message)>,
}

impl WavFile {
    pub fn new(path: &Path, font: Font, programs: Programs) -> Self {
        Self { path: path.into(), font, programs, messages: Vec::new() }
    }

    fn write(&self, path: &Path) -> io::Result<()> {
        let spec = WavSpec {
            channels: 2,
            sample_rate: RATE,
            bits_per_sample: 16,
            sample_format: SampleFormat::Int,
        };
        let mut file = WavWriter::create(path, spec).map_err(from_hound)?;
        let failed = |error: SoundError| io::Error::other(error.to_string());
        let mut sampler = Sampler::new(&self.font, RATE, &self.programs).map_err(failed)?;
        for (at, message) in &self.messages {
            let frame = frame(*at);
            while sampler.now() < frame {
                render(&mut sampler, frame, &mut file)?;
            }
            sampler.play(*message);
        }
        let end = sampler.now() + LONGEST_TAIL;
        while sampler.now() < end && SILENCE < render(&mut sampler, end, &mut file)? {}
        file.finalize().map_err(from_hound)
    }
}

/// Renders up to [`CHUNK`] frames before frame `until`; returns the largest amplitude.
fn render<W: io::Write + io::Seek>(
    sampler: &mut Sampler,
    until: u64,
    file: &mut WavWriter<W>,
) -> io::Result<f32> {
    let (mut left, mut right) = ([0.0; CHUNK], [0.0; CHUNK]);
    let n = usize::try_from(until - sampler.now()).map_or(CHUNK, |left| left.min(CHUNK));
    sampler.render(&mut left[..n], &mut right[..n]);
    let mut largest = 0.0_f32;
    for amplitude in left[..n].iter().zip(&right[..n]).flat_map(|(left, right)| [*left, *right]) {
        largest = largest.max(amplitude.abs());
        #[expect(clippy::cast_possible_truncation, reason = "clamped to the range of 16 bits")]
        let sample = (amplitude * 32_767.0).round().clamp(-32_768.0, 32_767.0) as i16;
        file.write_sample(sample).map_err(from_hound)?;
    }
    Ok(largest)
}

/// Returns the frame of time `at` (s); times before the start become the start.
fn frame(at: f64) -> u64 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
    let frame = (at * f64::from(RATE)).round() as u64;
    frame
}

fn from_hound(error: hound::Error) -> io::Error {
    match error {
        hound::Error::IoError(error) => error,
        hound::Error::FormatError(_)
        | hound::Error::TooWide
        | hound::Error::UnfinishedSample
        | hound::Error::Unsupported
        | hound::Error::InvalidSampleFormat => io::Error::other(error.to_string()),
    }
}

impl Output for WavFile {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        if !at.is_finite() {
            return Err(MidiSendError::NoSuchTime { at });
        }
        self.messages.push((at, message));
        Ok(())
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        self.messages.sort_by(|a, b| a.0.total_cmp(&b.0));
        let beside = self.path.with_extension("wav.part");
        let written = self.write(&beside).and_then(|()| std::fs::rename(&beside, &self.path));
        written.map_err(|source| MidiSendError::Write {
            path: self.path.clone(),
            messages: self.messages.len(),
            source,
        })
    }
}
