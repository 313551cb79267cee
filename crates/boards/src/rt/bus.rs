//! The host's end of all boards: samples in, forces out, once a tick.
//!
//! ```text
//! begin(tick)                       every sample grows older
//! for each line   receive(link)     frames → newer ones → metres
//! samples()                         to the voices
//! for each line   send(link)        newtons → a frame for each board
//! ```
//!
//! Latest wins: all frames since the last tick are read, the newest counts, and no frame waits.

use crate::links::{Health, Link, RecvError};
use firmware_protocol::frame::{FrameKind, board_of};
use firmware_protocol::{MAX_FRAME, key::BoardId};
use scheduler::motion::{KEYS, KeySample, KeySlope};

use super::board::{BoardEnd, BoardStatistics, BoardTerms};
use super::{key_fault::KeyFault, multicast::Multicast};
use crate::plan::{LinkMeter, Medium, MeterWindow};

/// Frames to read from one line in one tick; the rest waits for the next.
const MAX_FRAMES: usize = 128;

/// Age of a missing sample.
pub const NEVER: u32 = u32::MAX;

const NUMBERS: usize = BoardId::MAX.index() + 1;

/// Statistics of a line, beside those of its boards.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct LineStatistics {
    /// Receptions that were no frame.
    pub corrupt: u64,
    /// Frames of unknown boards, or of kinds that boards do not send.
    pub foreign: u64,
    pub down: u64,
    /// Bytes of frames in both directions.
    pub bytes: u64,
    pub health: Health,
}

/// The host's end of the boards, with the newest sample of every key.
#[derive(Clone, Debug)]
pub struct KeybedBus {
    tick: Option<u64>,
    samples: [KeySample; KEYS],
    boards: Vec<BoardEnd>,
    lines: Vec<LineEnd>,
    /// Change of a board's share of the forces per tick.
    share_step: f64,
}

#[derive(Clone, Debug, Default)]
struct LineEnd {
    /// Board index by number on this line.
    boards: [Option<usize>; NUMBERS],
    statistics: LineStatistics,
    multicast: Multicast,
    meter: Option<LinkMeter>,
}

impl LineEnd {
    fn saw_down(&mut self, len: usize) {
        self.statistics.bytes += len as u64;
        if let Some(meter) = &mut self.meter {
            meter.saw_down(len);
        }
    }

    /// Sends the forces of all keys on `boards` as multicast; `true` if the link accepted them.
    fn send_to_all(
        &mut self,
        now_us: u64,
        boards: &mut dyn Iterator<Item = &BoardTerms>,
        forces: &[f64; KEYS],
        link: &mut (impl Link + ?Sized),
    ) -> bool {
        let mut is_whole = true;
        for (frame, len) in self.multicast.frames(now_us, boards, forces).into_iter().flatten() {
            if link.try_send(&frame[..len]).is_ok() {
                self.saw_down(len);
            } else {
                is_whole = false;
            }
        }
        is_whole
    }

    fn saw_up(&mut self, len: usize) {
        self.statistics.bytes += len as u64;
        if let Some(meter) = &mut self.meter {
            meter.saw_up(len);
        }
    }
}

/// Receiver of acyclic frames: replies and hellos.
pub trait AcyclicHandler {
    fn take(&mut self, line: usize, frame: &[u8]);
}

/// Drops acyclic frames.
#[derive(Clone, Copy, Debug)]
pub struct IgnoreAcyclic;

impl AcyclicHandler for IgnoreAcyclic {
    fn take(&mut self, _line: usize, _frame: &[u8]) {}
}

impl KeybedBus {
    /// Returns a bus without samples of `boards`: all keys up, samples never taken. Keys without a
    /// board do not age. No two boards on a line may have the same number.
    pub fn new(boards: &[BoardTerms]) -> Self {
        let n_lines = boards.iter().map(|it| it.place.line + 1).max().unwrap_or(0);
        let mut lines = vec![LineEnd::default(); n_lines];
        let mut samples = [KeySample::fresh(0.0); KEYS];
        for (index, terms) in boards.iter().enumerate() {
            lines[terms.place.line].boards[terms.place.board.index()] = Some(index);
            samples[terms.place.keys()].iter_mut().for_each(|sample| sample.age = NEVER);
        }
        Self {
            tick: None,
            samples,
            boards: boards.iter().copied().map(BoardEnd::new).collect(),
            lines,
            share_step: 1.0,
        }
    }

    /// Fades forces in and out over `ticks` when a board starts or stops rendering; else at once.
    pub fn fade_over(&mut self, ticks: u32) {
        self.share_step = 1.0 / f64::from(ticks.max(1));
    }

    /// Guards readings, forces and motors in exchanges every `period_us`; not for the tick.
    pub(crate) fn guard(&mut self, period_us: u64) {
        self.boards.iter_mut().for_each(|board| board.guard(period_us));
    }

    pub(crate) fn demand_proof(&mut self) {
        self.boards.iter_mut().for_each(BoardEnd::demand_proof);
    }

    pub(crate) fn is_proving(&self) -> bool {
        self.boards.iter().any(BoardEnd::is_proving)
    }

    pub(crate) fn mute(&mut self, board: usize, slot: usize, fault: KeyFault) {
        if let Some(board) = self.boards.get_mut(board) {
            board.mute(slot, fault);
        }
    }

    pub fn limit_share(&mut self, board: usize, most: f64) {
        if let Some(board) = self.boards.get_mut(board) {
            board.limit_share(most);
        }
    }

    pub fn meter(&mut self, line: usize, medium: Medium) {
        if let Some(line) = self.lines.get_mut(line) {
            line.meter = Some(LinkMeter::new(medium));
        }
    }

    pub const fn n_lines(&self) -> usize {
        self.lines.len()
    }

    pub fn boards(&self) -> &[BoardEnd] {
        &self.boards
    }

    /// Starts `tick`: ages every sample by the ticks that have passed.
    ///
    /// # Real-time
    /// One addition for each key.
    pub fn begin(&mut self, tick: u64) {
        let passed = self.tick.map_or(0, |last| tick.saturating_sub(last));
        let passed = u32::try_from(passed).unwrap_or(u32::MAX);
        self.tick = Some(tick);
        for board in &self.boards {
            for sample in &mut self.samples[board.terms().place.keys()] {
                sample.age = sample.age.saturating_add(passed);
                sample.taken += f64::from(passed);
            }
        }
    }

    /// Reads the frames of `line`, and hands the acyclic ones on.
    ///
    /// # Real-time
    /// At most 128 receptions of 64 bytes for each board; no heap.
    pub fn receive(
        &mut self,
        line: usize,
        link: &mut (impl Link + ?Sized),
        acyclic: &mut impl AcyclicHandler,
    ) {
        let n_boards = self.lines[line].boards.iter().flatten().count().max(1);
        for _ in 0..MAX_FRAMES * n_boards {
            let mut frame = [0; MAX_FRAME];
            match link.try_recv(&mut frame) {
                Ok(Some(len)) => self.read(line, &frame[..len.min(MAX_FRAME)], acyclic),
                Ok(None) => break,
                Err(RecvError::Corrupt | RecvError::BufferTooShort { .. }) => {
                    self.lines[line].statistics.corrupt += 1;
                }
                Err(RecvError::Down) => {
                    self.lines[line].statistics.down += 1;
                    break;
                }
            }
        }
        self.lines[line].statistics.health = link.health();
    }

    /// Returns `true` if samples of this board have arrived in this tick.
    pub fn has_news(&self, board: usize) -> bool {
        let tick = self.tick.unwrap_or_default();
        self.boards.get(board).is_some_and(|it| it.has_news(tick))
    }

    /// Sets the age of a board's newest samples at this tick (ticks), as in [`KeySample::taken`].
    pub fn date(&mut self, board: usize, taken: f64) {
        let Some(end) = self.boards.get(board) else { return };
        let samples = self.samples[end.terms().place.keys()].iter_mut();
        // Older samples were not used this time.
        for sample in samples.filter(|it| it.age == 0) {
            sample.taken = taken;
        }
    }

    pub const fn samples(&self) -> &[KeySample; KEYS] {
        &self.samples
    }

    /// Sends the boards on `line` their shares of the forces (N, up positive) at `now_us`.
    ///
    /// A board without samples gets none, except by multicast, since there is nothing to answer.
    /// A board that renders no force, or shall not, gets none.
    ///
    /// # Real-time
    /// One frame for each board, or four for a line with multicast; no heap.
    pub fn send(
        &mut self,
        line: usize,
        now_us: u64,
        forces: &[f64; KEYS],
        slopes: &[KeySlope; KEYS],
        link: &mut (impl Link + ?Sized),
    ) {
        let end = &mut self.lines[line];
        let numbers = end.boards;
        let of_line = || numbers.iter().flatten().copied();
        for index in of_line() {
            self.boards[index].move_share(self.share_step);
        }
        if of_line().any(|index| self.boards[index].takes_multicast()) {
            let mut forces = *forces;
            for index in of_line() {
                let board = &mut self.boards[index];
                let rendered = board.rendered(now_us, &forces);
                let keys = board.terms().place.keys();
                forces[keys].iter_mut().zip(rendered).for_each(|(it, rendered)| *it = rendered);
            }
            let mut terms = of_line().map(|index| self.boards[index].terms());
            let is_whole = end.send_to_all(now_us, &mut terms, &forces, link);
            for index in of_line() {
                self.boards[index].count_sent(is_whole);
            }
            return;
        }
        for index in of_line() {
            let board = &mut self.boards[index];
            // A frame that the link rejects is lost; the next one makes it worthless.
            let rendered = board.rendered(now_us, forces);
            let sent = board.answer(&rendered, slopes);
            let sent = sent.filter(|(frame, len)| link.try_send(&frame[..*len]).is_ok());
            board.count_sent(sent.is_some());
            if let Some((_, len)) = sent {
                end.saw_down(len);
            }
        }
    }

    /// Counts a frame of `len` bytes that was sent over `line` beside the forces.
    ///
    /// # Real-time
    /// As [`LinkMeter::saw_down`].
    pub fn saw_sent(&mut self, line: usize, len: usize) {
        if let Some(line) = self.lines.get_mut(line) {
            line.saw_down(len);
        }
    }

    /// Returns the load of `line` over the metered `seconds`; `None` if its medium is unknown.
    pub fn load(&self, line: usize, seconds: f64) -> Option<MeterWindow> {
        Some(self.lines.get(line)?.meter.as_ref()?.seen(seconds))
    }

    pub fn line_meter(&self, line: usize) -> Option<LinkMeter> {
        self.lines.get(line)?.meter
    }

    pub fn forget(&mut self, board: usize) {
        if let Some(board) = self.boards.get_mut(board) {
            board.forget();
        }
    }

    pub fn unmute(&mut self, board: usize) {
        if let Some(board) = self.boards.get_mut(board) {
            board.unmute();
        }
    }

    pub fn statistics(&self, board: usize) -> BoardStatistics {
        self.boards.get(board).map_or_else(BoardStatistics::default, BoardEnd::statistics)
    }

    pub fn line(&self, line: usize) -> LineStatistics {
        self.lines.get(line).map_or_else(LineStatistics::default, |it| it.statistics)
    }

    pub fn board_on(&self, line: usize, frame: &[u8]) -> Option<usize> {
        self.lines.get(line)?.boards.get(board_of(frame)?.index()).copied().flatten()
    }

    fn read(&mut self, line: usize, frame: &[u8], acyclic: &mut impl AcyclicHandler) {
        self.lines[line].saw_up(frame.len());
        match (FrameKind::of(frame), self.board_on(line, frame)) {
            (Some(FrameKind::KeySamples), Some(index)) => {
                let board = &mut self.boards[index];
                if board.hear(frame, self.tick.unwrap_or_default()) {
                    board.publish(&mut self.samples);
                }
            }
            (Some(FrameKind::Reply | FrameKind::Hello), Some(_)) => acyclic.take(line, frame),
            _ => self.lines[line].statistics.foreign += 1,
        }
    }
}
