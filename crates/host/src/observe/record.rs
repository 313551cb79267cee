//! Sinks that keep messages: a recording, and the black box.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError, mpsc};
use std::time::Duration;

use documents::shown;
use telemetry::recording::{
    BlackBox, RecordError, Recorder, RecordingLimits, RecordingSettings, RecordingStatus,
};
use telemetry::{Log, Topic, Update, event::Kind, log};

use super::telemetry_thread::{Attention, MessageSink, TelemetryMessage};
use crate::report::RecordingReport;

/// A recording that a sink writes.
#[derive(Clone, Debug)]
pub struct RecordingHandle {
    report: Arc<Mutex<RecordingReport>>,
    stop: Arc<AtomicBool>,
}

impl RecordingHandle {
    /// Begins to record into `file`, through the telemetry thread behind `sender`. The error is a
    /// sentence.
    ///
    /// If the recording ends early, the host's log contains the reason.
    pub fn begin(
        file: &Path,
        limits: RecordingLimits,
        sender: &mpsc::Sender<TelemetryMessage>,
    ) -> Result<Self, RecordError> {
        let settings =
            RecordingSettings { limits, ..RecordingSettings::new(file, super::run_id()) };
        let recorder = Recorder::create(settings)?;
        let file = shown(file);
        let report = Arc::new(Mutex::new(RecordingReport { file, ..RecordingReport::default() }));
        let it = Self { report, stop: Arc::default() };
        let (recorder, log) = (Some(recorder), sender.clone());
        let sink = Box::new(RecordSink { recorder, recording: it.clone(), log });
        // A thread that has ended has nothing to record.
        let _gone = sender.send(TelemetryMessage::Sink(sink));
        Ok(it)
    }

    pub fn stop(&self) {
        self.stop.store(true, Ordering::Release);
    }

    pub fn report(&self) -> RecordingReport {
        self.report.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

struct RecordSink {
    recorder: Option<Recorder>,
    recording: RecordingHandle,
    log: mpsc::Sender<TelemetryMessage>,
}

impl RecordSink {
    fn note(&mut self, result: Result<(), RecordError>) {
        let Err(error) = result else { return };
        if matches!(error, RecordError::NoSuchKey { .. }) {
            return;
        }
        self.finish();
        let text = error.to_string();
        let mut report = self.recording.report.lock().unwrap_or_else(PoisonError::into_inner);
        report.trouble.get_or_insert_with(|| text.clone());
        drop(report);
        let entry = Update::Log(Log { level: log::Level::Error.into(), text });
        // At the run's end the log is closed, and the report contains the reason.
        let _gone = self.log.send(TelemetryMessage::Update(Box::new(entry)));
    }

    fn finish(&mut self) {
        let Some(recorder) = self.recorder.take() else { return };
        let finished = recorder.finish();
        let mut report = self.recording.report.lock().unwrap_or_else(PoisonError::into_inner);
        match finished {
            Ok(RecordingStatus { files, bytes, messages, .. }) => {
                (report.files, report.bytes, report.messages) =
                    (u64::try_from(files.len()).unwrap_or(u64::MAX), bytes, messages);
            }
            Err(error) => {
                report.trouble.get_or_insert_with(|| error.to_string());
            }
        }
    }
}

impl MessageSink for RecordSink {
    fn take(&mut self, at: u64, update: &Update) {
        if let Some(recorder) = &mut self.recorder {
            let written = recorder.write(at, update);
            self.note(written);
        }
    }

    fn wants(&self, topic: Topic) -> bool {
        !matches!(topic, Topic::State(_))
    }

    fn attend(&mut self, now: u64) -> Attention {
        if self.recording.stop.load(Ordering::Acquire) {
            self.finish();
        } else if let Some(recorder) = &mut self.recorder {
            let attended = recorder.attend(now);
            self.note(attended);
        }
        if self.recorder.is_some() { Attention::Goes } else { Attention::Over }
    }
}

impl Drop for RecordSink {
    fn drop(&mut self) {
        self.finish();
    }
}

const KEPT: Duration = Duration::from_secs(30);

/// Memory limit of the black box (bytes).
const MOST_BYTES: usize = 64 << 20;

/// Time from a fault to writing, so that the consequences are included (ns).
const AFTER: u64 = 2_000_000_000;

/// Maximum number of boxes of one run, since faults repeat.
const MOST_BOXES: u32 = 5;

/// Number of boxes of all runs that stay in a folder.
const MOST_KEPT: usize = 20;

fn remove_oldest(folder: &Path) -> std::io::Result<()> {
    let entries = std::fs::read_dir(folder)?.filter_map(Result::ok);
    let boxes = entries.filter_map(|entry| {
        let name = entry.file_name();
        let is_box = name.to_str().is_some_and(|name| name.starts_with("black-box-"));
        let written = entry.metadata().and_then(|it| it.modified()).ok()?;
        is_box.then(|| (written, entry.path()))
    });
    let mut boxes: Vec<_> = boxes.collect();
    boxes.sort();
    let surplus = boxes.len().saturating_sub(MOST_KEPT);
    boxes.iter().take(surplus).try_for_each(|(_, path)| std::fs::remove_file(path))
}

/// Keeps the last 30 s of messages, and writes them when a voice fails.
pub struct BlackBoxSink {
    kept: BlackBox,
    folder: PathBuf,
    due: Option<u64>,
    written: u32,
    say: fn(&str),
}

impl std::fmt::Debug for BlackBoxSink {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("BlackBoxSink").field("folder", &self.folder).finish_non_exhaustive()
    }
}

impl BlackBoxSink {
    /// Writes into `folder`, which is made when needed, and reports by `say`.
    pub fn new(folder: PathBuf, say: fn(&str)) -> Self {
        Self { kept: BlackBox::new(KEPT, MOST_BYTES), folder, due: None, written: 0, say }
    }

    fn write(&mut self) {
        self.due = None;
        self.written += 1;
        let run = super::run_id();
        let path = self.folder.join(format!("black-box-{run}-{}.mcap", self.written));
        let made = std::fs::create_dir_all(&self.folder).map_err(|error| error.to_string());
        let dumped =
            made.and_then(|()| self.kept.dump(&path, &run).map_err(|error| error.to_string()));
        // A box that cannot be removed costs room only.
        let _kept = remove_oldest(&self.folder);
        (self.say)(&match dumped {
            Ok(_bytes) => format!(
                "a voice failed; the seconds around it are in {}: see `letoff dash`",
                shown(&path)
            ),
            Err(error) => format!("a voice failed, and the black box cannot be written: {error}"),
        });
    }
}

impl MessageSink for BlackBoxSink {
    fn take(&mut self, at: u64, update: &Update) {
        // A message that is too large is left out, and the rest is kept.
        let _left_out = self.kept.keep(at, update);
        let is_fault = matches!(update, Update::Event(event) if event.kind() == Kind::Fault);
        if is_fault && self.due.is_none() && self.written < MOST_BOXES {
            self.due = Some(at.saturating_add(AFTER));
        }
    }

    fn wants(&self, topic: Topic) -> bool {
        !matches!(topic, Topic::State(_))
    }

    fn attend(&mut self, now: u64) -> Attention {
        if self.due.is_some_and(|due| due <= now) {
            self.write();
        }
        Attention::Goes
    }
}

impl Drop for BlackBoxSink {
    fn drop(&mut self) {
        if self.due.is_some() {
            self.write();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_oldest_boxes_go_and_other_files_stay() {
        let folder = std::env::temp_dir().join(format!("letoff-boxes-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let begun = std::time::SystemTime::now();
        for n in 0..MOST_KEPT + 3 {
            let file = std::fs::File::create(folder.join(format!("black-box-{n}.mcap"))).unwrap();
            let age = Duration::from_secs(n as u64);
            file.set_modified(begun.checked_sub(age).unwrap()).unwrap();
        }
        std::fs::write(folder.join("recording.mcap"), "").unwrap();
        remove_oldest(&folder).unwrap();
        let left = |name: &str| folder.join(name).exists();
        assert!(left("black-box-0.mcap") && left(&format!("black-box-{}.mcap", MOST_KEPT - 1)));
        assert!(!left(&format!("black-box-{MOST_KEPT}.mcap")) && left("recording.mcap"));
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
