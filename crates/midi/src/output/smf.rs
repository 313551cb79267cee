//! A Standard MIDI File with times to 50 µs, and with the bars of a performance.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write as _};
use std::iter;
use std::path::{Path, PathBuf};

use midly::num::{u4, u7, u15, u28};
use midly::{Format, Header, MetaMessage, MidiMessage, Timing, TrackEvent, TrackEventKind};

use super::score_timing::ScoreTiming;
use super::{MidiSendError, Output};
use crate::message::{Controller, Message};

const PROGRAM: &[u8] = concat!("Played by Letoff ", env!("CARGO_PKG_VERSION")).as_bytes();

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
    timing: ScoreTiming,
    /// Number of messages in the file; differs from `messages` while there is work to do.
    written: Option<usize>,
}

impl Smf {
    pub fn new(path: impl Into<PathBuf>) -> Self {
        let (messages, timing) = (Vec::new(), ScoreTiming::default());
        Self { path: path.into(), messages, timing, written: None }
    }

    /// Writes with the bars of a performance instead of 120 quarter notes a minute.
    #[must_use]
    pub fn with_timing(self, timing: ScoreTiming) -> Self {
        Self { timing, ..self }
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
        let written =
            encode(&self.messages, &self.timing).and_then(|bytes| write(&self.path, &bytes));
        written.map_err(|source| MidiSendError::Write {
            path: self.path.clone(),
            messages: self.messages.len(),
            source,
        })?;
        self.written = Some(self.messages.len());
        Ok(())
    }
}

/// Encodes a file with `messages`, in order of time, and the marks of `timing` up to the last one.
fn encode(messages: &[(f64, Message)], timing: &ScoreTiming) -> io::Result<Vec<u8>> {
    let map = timing.tempo_map();
    let program = (0, TrackEventKind::Meta(MetaMessage::Text(PROGRAM)));
    let end = messages.last().map_or(0, |(at, _)| map.ticks(*at));
    let marks = timing
        .written_marks(&map)
        .filter(|(tick, _)| *tick <= end)
        .map(|(tick, it)| (tick, TrackEventKind::Meta(MetaMessage::Unknown(it.kind, &it.data))));
    let messages = messages.iter().map(|(at, message)| (map.ticks(*at), kind(*message)));
    let mut events: Vec<_> = iter::once(program).chain(marks).chain(messages).collect();
    events.sort_by_key(|(tick, _)| *tick);
    let mut track = Vec::with_capacity(events.len() + 1);
    let mut now = 0;
    for (then, kind) in events {
        rest(&mut track, then - now);
        track.push(TrackEvent { delta: pause(then - now), kind });
        now = then;
    }
    track.push(meta_event(0, MetaMessage::EndOfTrack));
    let timing = Timing::Metrical(u15::new(map.division));
    let mut bytes = Vec::new();
    midly::write_std(&Header::new(Format::SingleTrack, timing), [&track], &mut bytes)?;
    Ok(bytes)
}

/// Fills the part of a pause of `ticks` that one event cannot express with empty texts.
fn rest(track: &mut Vec<TrackEvent<'_>>, ticks: u64) {
    for _ in 0..ticks / (LONGEST_PAUSE + 1) {
        track.push(meta_event(LONGEST_PAUSE, MetaMessage::Text(b"")));
        track.push(meta_event(1, MetaMessage::Text(b"")));
    }
}

fn meta_event(delta: u64, message: MetaMessage<'_>) -> TrackEvent<'_> {
    TrackEvent { delta: pause(delta), kind: TrackEventKind::Meta(message) }
}

fn kind(message: Message) -> TrackEventKind<'static> {
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
    TrackEventKind::Midi { channel: u4::new(0), message }
}

/// Returns the rest of a pause of `ticks` after [`rest`].
fn pause(ticks: u64) -> u28 {
    let left = ticks % (LONGEST_PAUSE + 1);
    u28::from_int_lossy(u32::try_from(left).unwrap_or_default())
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
    use crate::output::score_timing::{ScoreMark, meta};
    use crate::player::{NoteEvent, NoteEventKind, Player};
    use crate::velocity::VelocityCurve;

    fn note_on(key: u8) -> Message {
        Message::NoteOn { note: Note::from_key(key).unwrap(), velocity: Velocity::UNKNOWN }
    }

    /// Returns the times (s) of all channel events in a file.
    fn times(bytes: &[u8]) -> Vec<f64> {
        let smf = midly::Smf::parse(bytes).unwrap();
        let Timing::Metrical(division) = smf.header.timing else { panic!("no quarters") };
        let (mut now, mut tick) = (0.0, 0.0);
        let mut times = Vec::new();
        for event in &smf.tracks[0] {
            now += f64::from(event.delta.as_int()) * tick;
            if let TrackEventKind::Meta(MetaMessage::Tempo(us)) = event.kind {
                tick = f64::from(us.as_int()) * 1e-6 / f64::from(division.as_int());
            } else if let TrackEventKind::Midi { .. } = event.kind {
                times.push(now);
            }
        }
        times
    }

    fn mark(tick: u64, kind: u8, data: &[u8]) -> ScoreMark {
        ScoreMark { tick, kind, data: data.to_vec() }
    }

    fn tempo_mark(tick: u64, us: u32) -> ScoreMark {
        mark(tick, meta::TEMPO, &us.to_be_bytes()[1..])
    }

    #[test]
    fn a_piece_begins_after_the_least_number_of_whole_bars() {
        for (us, beats, power, expected) in [
            (500_000, 4, 2, 2.0),
            (666_000, 3, 2, 1.998),
            (250_000, 2, 2, 1.0),
            (100_000, 6, 3, 1.2),
            // A bar of 24 s, and one that is no whole number of ticks.
            (6_000_000, 4, 2, 1.0),
            (500_000, 1, 200, 1.0),
        ] {
            let signature = mark(0, meta::TIME_SIGNATURE, &[beats, power, 24, 8]);
            let mut timing = ScoreTiming::new(480, vec![tempo_mark(0, us), signature]);
            let found = timing.begin_after(1.0);
            assert!((found - expected).abs() < 1e-9, "{found} s, expected {expected} s");
        }
        let plain = ScoreTiming::new(480, Vec::new()).begin_after(1.0);
        assert_eq!(plain.to_bits(), 2.0_f64.to_bits(), "4/4 at 120 a minute");
    }

    #[test]
    fn a_file_read_back_has_every_time_to_50_us() {
        check_times(ScoreTiming::default());
        for division in [1, 96, 480, 960, 32_767] {
            // 240, 20 and 60 quarter notes a minute.
            let tempi = [(0, 250_000), (100, 3_000_000), (5_000, 1_000_000)];
            let tempi = tempi.map(|(tick, us)| tempo_mark(tick, us));
            let mut timing = ScoreTiming::new(division, tempi.to_vec());
            let _bars = timing.begin_after(1.0);
            check_times(timing);
        }
    }

    #[track_caller]
    fn check_times(timing: ScoreTiming) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("played.mid");
        let mut smf = Smf::new(&path).with_timing(timing);
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
