//! A Standard MIDI File with times to 10 µs.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use midly::num::{u4, u7, u15, u24, u28};
use midly::{Format, Header, MetaMessage, MidiMessage, Timing, TrackEvent, TrackEventKind};

use super::{MidiSendError, Output};
use crate::message::{Controller, Message};

/// Length of a quarter note (µs): 120 a minute, the players' default.
const QUARTER_US: u32 = 500_000;

/// Ticks per quarter note: a tick is 20 µs, so a time is off by at most 10 µs.
const TICKS_PER_QUARTER: u16 = 25_000;

/// Length of a tick (s).
const TICK: f64 = QUARTER_US as f64 * 1e-6 / TICKS_PER_QUARTER as f64;

/// Longest pause between two events (ticks), about 1.5 h; longer ones are split.
const LONGEST_PAUSE: u64 = (1 << 28) - 1;

/// Records messages and writes them as a Standard MIDI File (format 0).
///
/// [`Output::finish`] writes the whole file beside its place and then moves it there: a reader sees
/// the old file or the new one. Regular calls during a long recording bound the loss by a crash.
#[derive(Debug)]
pub struct Smf {
    path: PathBuf,
    messages: Vec<(f64, Message)>,
    /// Number of messages in the file; differs from `messages` while there is work to do.
    written: Option<usize>,
}

impl Smf {
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self { path: path.into(), messages: Vec::new(), written: None }
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the recorded messages, each with its time (s since the host started).
    pub fn messages(&self) -> &[(f64, Message)] {
        &self.messages
    }
}

impl Output for Smf {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        if !at.is_finite() {
            return Err(MidiSendError::NoSuchTime { at });
        }
        // An emergency stop is for a live receiver; in a file it would cut the last notes.
        if let Message::ControlChange {
            controller: Controller::AllNotesOff | Controller::AllSoundOff,
            ..
        } = message
        {
            return Ok(());
        }
        self.messages.push((at, message));
        Ok(())
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        if self.written == Some(self.messages.len()) {
            return Ok(());
        }
        self.messages.sort_by(|a, b| a.0.total_cmp(&b.0));
        let written = encode(&self.messages).and_then(|bytes| write(&self.path, &bytes));
        written.map_err(|source| MidiSendError::Write {
            path: self.path.clone(),
            messages: self.messages.len(),
            source,
        })?;
        self.written = Some(self.messages.len());
        Ok(())
    }
}

/// Encodes a file with `messages`, which are in order of time.
fn encode(messages: &[(f64, Message)]) -> io::Result<Vec<u8>> {
    let mut track = vec![meta(0, MetaMessage::Tempo(u24::new(QUARTER_US)))];
    let mut now = 0;
    for (at, message) in messages {
        let then = ticks(*at);
        rest(&mut track, then - now);
        track.push(event(then - now, *message));
        now = then;
    }
    track.push(meta(0, MetaMessage::EndOfTrack));
    let timing = Timing::Metrical(u15::new(TICKS_PER_QUARTER));
    let mut bytes = Vec::new();
    midly::write_std(&Header::new(Format::SingleTrack, timing), [&track], &mut bytes)?;
    Ok(bytes)
}

/// Fills the part of a pause of `ticks` that one event cannot express with empty texts.
fn rest(track: &mut Vec<TrackEvent<'_>>, ticks: u64) {
    for _ in 0..ticks / (LONGEST_PAUSE + 1) {
        track.push(meta(LONGEST_PAUSE, MetaMessage::Text(b"")));
        track.push(meta(1, MetaMessage::Text(b"")));
    }
}

fn meta(delta: u64, message: MetaMessage<'_>) -> TrackEvent<'_> {
    TrackEvent { delta: pause(delta), kind: TrackEventKind::Meta(message) }
}

fn event(delta: u64, message: Message) -> TrackEvent<'static> {
    let number = |note: crate::Note| u7::from_int_lossy(note.number());
    let message = match message {
        Message::NoteOn { note, velocity } => {
            MidiMessage::NoteOn { key: number(note), vel: u7::from_int_lossy(velocity.get()) }
        }
        Message::NoteOff { note, velocity } => {
            MidiMessage::NoteOff { key: number(note), vel: u7::from_int_lossy(velocity.get()) }
        }
        Message::ControlChange { controller, value } => MidiMessage::Controller {
            controller: u7::from_int_lossy(controller.number()),
            value: u7::from_int_lossy(value),
        },
        Message::KeyPressure { note, value } => {
            MidiMessage::Aftertouch { key: number(note), vel: u7::from_int_lossy(value) }
        }
        Message::ChannelPressure { value } => {
            MidiMessage::ChannelAftertouch { vel: u7::from_int_lossy(value) }
        }
    };
    let channel = u4::new(0);
    TrackEvent { delta: pause(delta), kind: TrackEventKind::Midi { channel, message } }
}

/// Returns the rest of a pause of `ticks` after [`rest`].
fn pause(ticks: u64) -> u28 {
    let left = ticks % (LONGEST_PAUSE + 1);
    u28::from_int_lossy(u32::try_from(left).unwrap_or_default())
}

/// Converts `at` (s) to ticks; a time before the start becomes the start.
fn ticks(at: f64) -> u64 {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "negative times become 0, and no host runs for 10 million years"
    )]
    let ticks = (at / TICK).round() as u64;
    ticks
}

/// Writes `bytes` to `path`: through a file beside it, unless `path` is a device or a pipe.
fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
        return write_through(path, bytes);
    }
    let beside = beside(path);
    write_through(&beside, bytes)?;
    fs::rename(&beside, path)
}

fn write_through(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = File::create(path)?;
    file.write_all(bytes)?;
    // Not every device can be synchronised. A file on a full disk may fail only here.
    match file.sync_all() {
        Err(error) if error.kind() != io::ErrorKind::InvalidInput => Err(error),
        _ => Ok(()),
    }
}

fn beside(path: &Path) -> PathBuf {
    let mut name = OsString::from(path);
    name.push(".part");
    PathBuf::from(name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::note::{Note, Velocity};
    use crate::player::{NoteEvent, NoteEventKind, Player};
    use crate::velocity::VelocityCurve;

    fn note_on(key: u8) -> Message {
        Message::NoteOn { note: Note::from_key(key).unwrap(), velocity: Velocity::UNKNOWN }
    }

    /// Returns the times (s) of all channel events in a file.
    fn times(bytes: &[u8]) -> Vec<f64> {
        let smf = midly::Smf::parse(bytes).unwrap();
        assert_eq!(smf.header.timing, Timing::Metrical(u15::new(TICKS_PER_QUARTER)));
        let mut now = 0_u64;
        let mut times = Vec::new();
        for event in &smf.tracks[0] {
            now += u64::from(event.delta.as_int());
            if let TrackEventKind::Midi { .. } = event.kind {
                times.push(now as f64 * 0.5 / 25_000.0);
            }
        }
        times
    }

    #[test]
    fn a_file_read_back_has_every_time_to_50_us() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("played.mid");
        let mut smf = Smf::new(&path);
        // The last two lie further apart than one event can express.
        let wanted = [0.0, 1.0 / 3.0, 0.333_35, 12.345_678_9, 3_600.000_07, 40_000.5];
        for (key, at) in (0..).zip(wanted) {
            smf.send(at, note_on(key)).unwrap();
        }
        smf.finish().unwrap();
        let read = times(&fs::read(&path).unwrap());
        assert_eq!(read.len(), wanted.len());
        for (read, wanted) in read.iter().zip(wanted) {
            assert!((read - wanted).abs() < 50e-6, "{read} s, wanted {wanted} s");
        }
    }

    #[test]
    fn finishing_again_and_recording_on_keeps_everything() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("played.mid");
        let mut smf = Smf::new(&path);
        smf.send(0.0, note_on(1)).unwrap();
        smf.finish().unwrap();
        smf.finish().unwrap();
        assert_eq!(times(&fs::read(&path).unwrap()).len(), 1);
        smf.send(1.0, note_on(2)).unwrap();
        smf.finish().unwrap();
        assert_eq!(times(&fs::read(&path).unwrap()).len(), 2);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "nothing else is left behind");
    }

    #[test]
    fn a_file_ends_with_its_last_notes_also_in_an_emergency() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("played.mid");
        let mut player = Player::new(Smf::new(&path), VelocityCurve::default());
        let kind = NoteEventKind::Strike { speed: 1.0, velocity: None };
        player.play(NoteEvent { key: 39, at: 0.5, kind }).unwrap();
        player.cut_off().unwrap();
        player.finish().unwrap();
        let sent: Vec<_> =
            player.output().messages().iter().map(|it| it.1.encode().to_vec()).collect();
        assert_eq!(sent.len(), 2, "a note-on and its note-off: {sent:?}");
        assert_eq!(times(&fs::read(&path).unwrap()).len(), 2);
    }

    #[test]
    fn messages_out_of_order_are_written_in_order() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("played.mid");
        let mut smf = Smf::new(&path);
        smf.send(2.0, note_on(1)).unwrap();
        smf.send(1.0, note_on(2)).unwrap();
        smf.finish().unwrap();
        assert_eq!(times(&fs::read(&path).unwrap()), [1.0, 2.0]);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_reported_and_nothing_is_forgotten() {
        use std::os::unix::fs::FileTypeExt as _;

        let mut smf = Smf::new("/dev/full");
        smf.send(0.0, note_on(1)).unwrap();
        for _ in 0..2 {
            let error = smf.finish().unwrap_err().to_string();
            assert!(error.starts_with("/dev/full could not be written"), "{error}");
            assert!(error.contains("its 1 messages are lost with this run: make room"), "{error}");
        }
        assert_eq!(smf.messages().len(), 1);
        assert!(fs::metadata("/dev/full").unwrap().file_type().is_char_device());
    }

    #[test]
    fn a_folder_that_is_not_there_is_reported() {
        let folder = tempfile::tempdir().unwrap();
        let mut smf = Smf::new(folder.path().join("absent/played.mid"));
        assert!(matches!(smf.finish(), Err(MidiSendError::Write { messages: 0, .. })));
    }

    #[test]
    fn a_time_that_is_no_number_is_refused() {
        let mut smf = Smf::new("never-written.mid");
        assert!(smf.send(f64::NAN, note_on(1)).is_err());
        assert!(smf.messages().is_empty());
    }
}
