use std::{collections::VecDeque, fs, path::PathBuf};

use super::error::RecordError;
use super::format::{Labels, part_path};
use super::latest::Latest;
use super::part::RecordingPart;
use super::raw_message::RawMessage;
use super::settings::RecordingSettings;
use crate::Update;

/// Writes a recording, file after file, for a thread beside the tick: it allocates, compresses and
/// waits for the disk. Only [`Recorder::finish`] reports whether the last file is complete.
#[derive(Debug)]
pub struct Recorder {
    settings: RecordingSettings,
    /// The open file; `None` after the end.
    part: Option<RecordingPart>,
    number: u32,
    /// Time of the first message that is not repeated in it (ns since 1970).
    part_began: u64,
    /// Number of repeated messages at its beginning.
    repeated: u64,
    latest: Latest,
    /// Complete files, the oldest first, with their sizes (B).
    complete: VecDeque<(PathBuf, u64)>,
    messages: u64,
    removed: u32,
    /// Times of the last flush, by messages' time and by the caller's (ns).
    flushed: Option<u64>,
    attended: Option<u64>,
    /// Times of the next repetition, and of the last message (ns since 1970).
    again: u64,
    last: u64,
}

/// Time between two repetitions of catalogue, voices and labels, against damage (ns).
const AGAIN: u64 = 30_000_000_000;

/// Repetitions take at most one part in this many of a file.
const SHARE: u64 = 8;

/// Files and counts of a recording.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RecordingStatus {
    pub files: Vec<PathBuf>,
    pub bytes: u64,
    /// Recorded messages, including those in removed files.
    pub messages: u64,
    /// Files removed to limit the total size.
    pub removed: u32,
}

impl Recorder {
    /// Begins a recording; fails on an existing file or an almost full disk.
    pub fn create(settings: RecordingSettings) -> Result<Self, RecordError> {
        if let Err(RecordError::LowDisk { path, free, lowest }) =
            check_room(&settings, &settings.path)
        {
            return Err(RecordError::NoRoom { path, free, lowest });
        }
        let second = part_path(&settings.path, 2);
        if second.exists() {
            return Err(RecordError::Exists(second));
        }
        let labels = Labels::new(&settings.run, 1);
        let part = RecordingPart::create(&settings.path, &labels)?;
        Ok(Self {
            settings,
            part: Some(part),
            number: 1,
            part_began: 0,
            repeated: 0,
            latest: Latest::default(),
            complete: VecDeque::new(),
            messages: 0,
            removed: 0,
            flushed: None,
            attended: None,
            again: 0,
            last: 0,
        })
    }

    /// Writes `update` from `at` (ns since 1970). After an error the recording has ended, but for
    /// [`RecordError::NoSuchKey`].
    pub fn write(&mut self, at: u64, update: &Update) -> Result<(), RecordError> {
        let raw = RawMessage::of(at, update)?;
        let part = self.part.as_ref().ok_or(RecordError::Ended)?;
        let again = if self.repeats() { self.repeated_bytes() } else { 0 };
        let limits = &self.settings.limits;
        let is_full = part.size_with(&raw) + again > limits.file_limit()
            || at.saturating_sub(self.part_began) >= limits.file_ns();
        if is_full && part.messages() > self.repeated {
            self.rotate(at)?;
        } else if part.messages() == 0 {
            self.part_began = at;
        }
        self.add(&raw)?;
        self.latest.note(&raw);
        self.last = at;
        self.messages += 1;
        self.flush_by_message(at)
    }

    /// Passes waiting messages to the system, if they have waited for long enough at `now` (ns).
    /// After an error the recording has ended.
    ///
    /// `now` is of any running clock. Call it some times a second, so that the last messages before
    /// a silence do not wait for the next one.
    pub fn attend(&mut self, now: u64) -> Result<(), RecordError> {
        let since = now.saturating_sub(*self.attended.get_or_insert(now));
        if since < self.settings.flush_ns() {
            return Ok(());
        }
        match &self.part {
            Some(part) if part.is_pending() => self.flush(),
            Some(_) | None => Ok(()),
        }
    }

    /// Ends the recording. [`super::recover`] can read a last file left incomplete by an error.
    pub fn finish(mut self) -> Result<RecordingStatus, RecordError> {
        self.end()?;
        let bytes = self.complete.iter().map(|(_, bytes)| bytes).sum();
        let files = self.complete.into_iter().map(|(path, _)| path).collect();
        Ok(RecordingStatus { files, bytes, messages: self.messages, removed: self.removed })
    }

    fn add(&mut self, raw: &RawMessage) -> Result<(), RecordError> {
        let added = self.part.as_mut().ok_or(RecordError::Ended)?.add(raw);
        self.or_end(added)
    }

    fn flush_by_message(&mut self, at: u64) -> Result<(), RecordError> {
        let since = at.saturating_sub(*self.flushed.get_or_insert(at));
        let is_full = self.part.as_ref().is_some_and(RecordingPart::is_chunk_full);
        if since < self.settings.flush_ns() && !is_full {
            return Ok(());
        }
        self.flushed = Some(at);
        self.flush()?;
        if self.again <= at && self.repeats() {
            self.again = at.saturating_add(AGAIN);
            self.repeat(at)?;
        }
        Ok(())
    }

    fn repeats(&self) -> bool {
        let bytes = self.repeated_bytes();
        0 < self.latest.bytes() && bytes.saturating_mul(SHARE) <= self.settings.limits.file_limit()
    }

    /// Returns the largest size of a repetition (B).
    fn repeated_bytes(&self) -> u64 {
        // Each message has its own head, and there are 88 voices; labels come twice.
        self.latest.bytes() as u64 + 100 * 64 + 2 * 256
    }

    fn repeat(&mut self, at: u64) -> Result<(), RecordError> {
        let labels = Labels::new(&self.settings.run, self.number);
        let part = self.part.as_mut().ok_or(RecordError::Ended)?;
        let repeated = part.repeat(&labels, &self.latest, at);
        self.or_end(repeated)
    }

    fn write_trailer(&mut self) -> Result<(), RecordError> {
        let repeats = self.repeats();
        let Some(part) = self.part.as_mut().filter(|_| repeats) else { return Ok(()) };
        let labels = Labels::new(&self.settings.run, self.number);
        let repeated = part.write_trailer(&labels, &self.latest, self.last);
        self.or_end(repeated)
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        let flushed = self.part.as_mut().ok_or(RecordError::Ended)?.flush();
        self.or_end(flushed)?;
        // Messages from now on have not waited yet.
        self.attended = None;
        let room = check_room(&self.settings, &part_path(&self.settings.path, self.number));
        if room.is_err() {
            self.end()?;
        }
        room
    }

    /// Completes the file and continues in the next, which can be understood alone. Does not wait
    /// for the disk, or the queue of messages to here would overflow.
    fn rotate(&mut self, at: u64) -> Result<(), RecordError> {
        self.write_trailer()?;
        self.again = 0;
        let part = self.part.take().ok_or(RecordError::Ended)?;
        let path = part.path().to_owned();
        let (bytes, _) = part.close()?;
        self.complete.push_back((path, bytes));
        self.make_room()?;
        self.number += 1;
        self.part_began = at;
        let path = part_path(&self.settings.path, self.number);
        let labels = Labels::new(&self.settings.run, self.number);
        self.part = Some(RecordingPart::create(&path, &labels)?);
        let again: Vec<RawMessage> = self.latest.repeated(at).collect();
        self.repeated = u64::try_from(again.len()).unwrap_or(u64::MAX);
        again.iter().try_for_each(|raw| self.add(raw))
    }

    fn make_room(&mut self) -> Result<(), RecordError> {
        loop {
            let bytes: u64 = self.complete.iter().map(|(_, bytes)| bytes).sum();
            if bytes + self.settings.limits.file_limit() <= self.settings.limits.largest_total {
                return Ok(());
            }
            let Some((path, _)) = self.complete.pop_front() else { return Ok(()) };
            fs::remove_file(&path).map_err(|cause| RecordError::Remove { path, cause })?;
            self.removed += 1;
        }
    }

    fn end(&mut self) -> Result<(), RecordError> {
        self.write_trailer()?;
        let Some(part) = self.part.take() else { return Ok(()) };
        let path = part.path().to_owned();
        self.complete.push_back((path, part.finish()?));
        Ok(())
    }

    /// Closes the file if `result` is an error.
    fn or_end(&mut self, result: Result<(), RecordError>) -> Result<(), RecordError> {
        if result.is_err() {
            self.part = None;
        }
        result
    }
}

fn check_room(settings: &RecordingSettings, path: &std::path::Path) -> Result<(), RecordError> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    match free(folder.unwrap_or_else(|| ".".as_ref())) {
        Some(free) if free < settings.limits.lowest_free => {
            let lowest = settings.limits.lowest_free;
            Err(RecordError::LowDisk { path: path.to_owned(), free, lowest })
        }
        Some(_) | None => Ok(()),
    }
}

/// Returns the free space of the disk of `folder` (B), if known.
#[cfg(unix)]
fn free(folder: &std::path::Path) -> Option<u64> {
    let disk = rustix::fs::statvfs(folder).ok()?;
    Some(disk.f_bavail.saturating_mul(disk.f_frsize))
}

#[cfg(not(unix))]
const fn free(_: &std::path::Path) -> Option<u64> {
    None
}
