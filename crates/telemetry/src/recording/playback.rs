//! A recording that a window shows as if it were a live host.

use std::collections::{BTreeSet, VecDeque};
use std::sync::mpsc::{Receiver, channel};
use std::{fmt, sync::Arc, thread, time::Duration};

use documents::shown;

use super::reader::{Recording, update};
use super::{
    error::ReadError, marks::marks, missing::MissingPiece, part_file::PartFile,
    raw_message::RawMessage, walk::Walk,
};
use crate::source::{Mark, Ticket};
use crate::{Arrival, ConnectionState, Log, Request, Source, Timeline, Topic, Update, log::Level};

/// Time before a position that a window gets, too (ns): enough for its scopes.
const BEFORE: u64 = 5_000_000_000;

/// Clock that returns the time since any fixed moment (s).
pub type PlaybackClock = Box<dyn Fn() -> f64 + Send>;

/// A recording that a window shows as if it were a live host.
///
/// It delivers the messages up to its position, which follows the given clock. The catalogue and
/// the voices always come, because all else needs them. A newly followed topic begins with its last
/// seconds, and a key's rows with the last ones before these. A [`Log`] reports unreadable data.
pub struct Playback {
    recording: Arc<Recording>,
    clock: PlaybackClock,
    span: (u64, u64),
    /// Position at the last change (ns since 1970), and the clock's time then (s).
    at: u64,
    since: f64,
    speed: f64,
    /// `true` if it begins again at its end.
    repeats: bool,
    followed: BTreeSet<Topic>,
    /// Followed topics with missing messages before the next one.
    torn: BTreeSet<Topic>,
    arrivals: VecDeque<Arrival>,
    past: VecDeque<PlaybackStream>,
    main: PlaybackStream,
    marks: Vec<Mark>,
    coming: Receiver<Mark>,
    tickets: u64,
}

impl Playback {
    /// Plays `recording` from its beginning, in the time of `clock`; a thread collects its marks.
    pub fn new(recording: Recording, clock: PlaybackClock) -> Self {
        let recording = Arc::new(recording);
        let span = recording.span().unwrap_or((0, 0));
        let mut playback = Self {
            coming: gather(Arc::clone(&recording)),
            since: clock(),
            recording,
            clock,
            span,
            at: span.0,
            speed: 1.0,
            repeats: false,
            followed: BTreeSet::new(),
            torn: BTreeSet::new(),
            arrivals: VecDeque::new(),
            past: VecDeque::new(),
            main: PlaybackStream::new(Walk::new(0, 0, BTreeSet::new())),
            marks: Vec::new(),
            tickets: 0,
        };
        playback.seek(span.0);
        if let Some(tear) = playback.recording.tear().map(ToString::to_string) {
            playback.arrivals.push_back(log(span.0, Level::Warning, tear));
        }
        playback
    }

    #[must_use]
    pub fn repeating(mut self) -> Self {
        self.repeats = true;
        self
    }

    pub fn recording(&self) -> &Recording {
        &self.recording
    }

    /// Sets the position to `at` from the clock's present time on.
    fn anchor(&mut self, at: u64) {
        self.at = at.clamp(self.span.0, self.span.1);
        self.since = (self.clock)();
    }

    fn wanted(&self) -> BTreeSet<Topic> {
        let always = [Topic::Catalogue, Topic::Voices];
        self.followed.iter().copied().chain(always).collect()
    }

    /// Returns the catalogue and the voices at `at` (ns since 1970).
    fn catalogue_and_voices(&self, at: u64) -> Result<Vec<Arrival>, ReadError> {
        let began = self.span.0;
        let catalogue = self.recording.catalogue()?.map(|it| (began, Update::Catalogue(it)));
        let voices = self.recording.voices_at(at)?;
        let voices = voices.into_iter().map(|(at, voice)| (at, Update::Voice(voice)));
        Ok(catalogue.into_iter().chain(voices).map(|(at, update)| arrival(at, update)).collect())
    }

    /// Returns the last rows of keys among `topics` before `from` (ns since 1970): a key that rests
    /// has none in the seconds before a position.
    fn keys_before(&mut self, from: u64, topics: &BTreeSet<Topic>) -> Vec<Arrival> {
        let blocks = topics.iter().filter(|topic| matches!(topic, Topic::Block(_)));
        let recording = Arc::clone(&self.recording);
        let last = blocks.filter_map(|topic| recording.last_before(*topic, from));
        last.map(|raw| self.arrive(Ok(raw))).collect()
    }

    fn next_raw(&mut self) -> Option<Result<RawMessage, MissingPiece>> {
        let (now, parts) = (Timeline::at(self), self.recording.parts());
        for stream in &mut self.past {
            let next = stream.next(parts, now);
            if next.is_some() {
                return next;
            }
        }
        self.past.retain(|stream| stream.due.is_some());
        self.main.next(parts, now)
    }

    fn arrive(&mut self, raw: Result<RawMessage, MissingPiece>) -> Arrival {
        match update(raw, &self.recording) {
            Ok((at, mut update)) => {
                if let Update::Block(block) = &mut update
                    && u8::try_from(block.key).is_ok_and(|key| self.torn.remove(&Topic::Block(key)))
                {
                    block.mark_missing();
                }
                arrival(at, update)
            }
            Err(error) => {
                self.torn.clone_from(&self.followed);
                log(Timeline::at(self), Level::Error, error.to_string())
            }
        }
    }
}

impl Source for Playback {
    fn next(&mut self) -> Option<Arrival> {
        self.marks.extend(self.coming.try_iter());
        if let Some(arrival) = self.arrivals.pop_front() {
            return Some(arrival);
        }
        if let Some(raw) = self.next_raw() {
            return Some(self.arrive(raw));
        }
        let is_over = self.span.0 < self.span.1 && Timeline::at(self) == self.span.1;
        if self.repeats && is_over && 0.0 < self.speed {
            self.seek(self.span.0);
        }
        self.arrivals.pop_front()
    }

    fn follow(&mut self, topics: &BTreeSet<Topic>) {
        let before = std::mem::replace(&mut self.followed, topics.clone());
        let mut anew: BTreeSet<_> = self.followed.difference(&before).copied().collect();
        anew.retain(|topic| !matches!(topic, Topic::Catalogue | Topic::Voices));
        self.main.walk.topics = self.wanted();
        for stream in &mut self.past {
            stream.walk.topics.retain(|topic| topics.contains(topic));
        }
        if !anew.is_empty() {
            let from = Timeline::at(self).saturating_sub(BEFORE);
            // A window that followed them earlier has rows from then.
            self.torn.extend(&anew);
            let before = self.keys_before(from, &anew);
            self.arrivals.extend(before);
            self.past.push_back(PlaybackStream::new(self.main.walk.past(from, anew)));
        }
    }

    fn ask(&mut self, _: Request) -> Ticket {
        let ticket = Ticket(self.tickets);
        self.tickets += 1;
        let refusal = "this is a recording: nothing in it can be changed";
        self.arrivals.push_back(Arrival::Reply { ticket, result: Err(refusal.to_owned()) });
        ticket
    }

    fn standing(&self) -> ConnectionState {
        if self.repeats { ConnectionState::Demonstration } else { ConnectionState::Recording }
    }

    fn name(&self) -> String {
        shown(self.recording.path())
    }

    fn timeline(&mut self) -> Option<&mut dyn Timeline> {
        Some(self)
    }
}

impl Timeline for Playback {
    fn span(&self) -> (u64, u64) {
        self.span
    }

    fn at(&self) -> u64 {
        let gone = ((self.clock)() - self.since).max(0.0) * self.speed;
        let gone = Duration::try_from_secs_f64(gone).unwrap_or(Duration::MAX);
        let gone = u64::try_from(gone.as_nanos()).unwrap_or(u64::MAX);
        self.at.saturating_add(gone).min(self.span.1)
    }

    fn seek(&mut self, at: u64) {
        self.anchor(at);
        self.past.clear();
        self.arrivals.retain(|arrival| matches!(arrival, Arrival::Reply { .. }));
        self.arrivals.push_back(Arrival::Anew);
        let from = self.at.saturating_sub(BEFORE).max(self.span.0);
        match self.catalogue_and_voices(from) {
            Ok(stage) => self.arrivals.extend(stage),
            Err(error) => self.arrivals.push_back(log(self.at, Level::Error, error.to_string())),
        }
        let before = self.keys_before(from, &self.followed.clone());
        self.arrivals.extend(before);
        self.main = PlaybackStream::new(Walk::new(from, u64::MAX, self.wanted()));
    }

    fn speed(&self) -> f64 {
        self.speed
    }

    fn set_speed(&mut self, speed: f64) {
        self.anchor(Timeline::at(self));
        self.speed = if speed.is_finite() { speed.max(0.0) } else { 0.0 };
    }

    fn marks(&self) -> &[Mark] {
        &self.marks
    }
}

impl fmt::Debug for Playback {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Playback").field("recording", &self.recording).finish_non_exhaustive()
    }
}

struct PlaybackStream {
    walk: Walk,
    due: Option<RawMessage>,
}

impl PlaybackStream {
    const fn new(walk: Walk) -> Self {
        Self { walk, due: None }
    }

    /// Returns the next message up to `now` (ns since 1970).
    fn next(&mut self, parts: &[PartFile], now: u64) -> Option<Result<RawMessage, MissingPiece>> {
        let due = self.due.take().filter(|raw| self.walk.topics.contains(&raw.topic));
        let next = due.map(Ok).or_else(|| self.walk.next(parts))?;
        match next {
            Ok(raw) if now < raw.at => {
                self.due = Some(raw);
                None
            }
            Ok(_) | Err(_) => Some(next),
        }
    }
}

fn arrival(at: u64, update: Update) -> Arrival {
    Arrival::Update { at, update: Box::new(update) }
}

fn log(at: u64, level: Level, text: String) -> Arrival {
    arrival(at, Update::Log(Log { level: level.into(), text }))
}

fn gather(recording: Arc<Recording>) -> Receiver<Mark> {
    let (sender, receiver) = channel();
    let gatherer = thread::Builder::new().name("letoff-marks".to_owned());
    // The thread ends by itself: at the end of the recording, or when the receiver is dropped.
    drop(gatherer.spawn(move || marks(&recording).try_for_each(|mark| sender.send(mark))));
    receiver
}
