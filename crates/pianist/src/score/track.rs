//! Events of a track; a byte that begins no event is counted or rejected, never silently lost.

use midi::output::score_timing::meta;

use super::passed_over::{PassedOver, PassedOverCounts};

/// Length of the longest end of a track (bytes): a delta time of four, and `FF 2F 00`. Damage in so
/// few last bytes costs the end of one note at most.
const TAIL: usize = 7;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct TrackEvent<'a> {
    /// Ticks since the start.
    pub(super) tick: u64,
    /// Number of the track, from 1 on.
    pub(super) track: u16,
    pub(super) kind: TrackEventKind<'a>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum TrackEventKind<'a> {
    /// A message of a channel: its status, and two data bytes or one and a zero.
    Message {
        status: u8,
        data: [u8; 2],
    },
    Meta {
        kind: u8,
        data: &'a [u8],
    },
    /// A system message, which moves no key.
    System,
}

/// Reads track `number` from its `bytes`; `missing` is the number of bytes missing at the end.
///
/// Like other players it skips system real-time and system common messages, and its running status
/// outlives meta events and system exclusive messages.
///
/// # Errors
/// The offset of the event that cannot be read, and the number of notes before it.
pub(super) fn read<'a>(
    number: u16,
    (bytes, missing): (&'a [u8], usize),
    events: &mut Vec<TrackEvent<'a>>,
    passed_over: &mut PassedOverCounts,
) -> Result<(), (usize, usize)> {
    let (n_before, mut at) = (events.len(), 0);
    let mut reader = TrackReader { rest: bytes, tick: 0, status: None, skipped: 0 };
    let mut is_over = false;
    while let Some(kind) = (!is_over).then(|| reader.event()).flatten() {
        events.push(TrackEvent { tick: reader.tick, track: number, kind });
        at = bytes.len() - reader.rest.len();
        is_over = matches!(kind, TrackEventKind::Meta { kind: meta::END, .. });
    }
    let skipped = if is_over { reader.rest.len() } else { 0 };
    passed_over.add(PassedOver::SkippedBytes, reader.skipped + skipped);
    let damaged = if is_over { 0 } else { bytes.len() - at + missing };
    passed_over.add(PassedOver::DamagedBytes, damaged);
    if TAIL < damaged {
        return Err((at, events.iter().skip(n_before).filter(|it| is_note_on(it)).count()));
    }
    Ok(())
}

fn is_note_on(event: &TrackEvent<'_>) -> bool {
    matches!(event.kind, TrackEventKind::Message { status: 0x90..=0x9F, data: [_, 1..=0x7F] })
}

#[derive(Debug)]
struct TrackReader<'a> {
    rest: &'a [u8],
    tick: u64,
    /// Status of messages without one.
    status: Option<u8>,
    skipped: usize,
}

impl<'a> TrackReader<'a> {
    /// Returns the next event; `None` if it is damaged, or there is none.
    fn event(&mut self) -> Option<TrackEventKind<'a>> {
        self.tick += u64::from(self.number()?);
        let first = *self.rest.first()?;
        let status = if first < 0x80 { self.status? } else { self.byte()? };
        match status {
            0x80..=0xEF => {
                self.status = Some(status);
                let first = self.data()?;
                let is_short = matches!(status, 0xC0..=0xDF);
                let second = if is_short { 0 } else { self.data()? };
                return Some(TrackEventKind::Message { status, data: [first, second] });
            }
            0xFF => {
                let kind = self.byte()?;
                return Some(TrackEventKind::Meta { kind, data: self.block()? });
            }
            0xF0 | 0xF7 => {
                self.block()?;
                return Some(TrackEventKind::System);
            }
            0xF1 | 0xF3 => self.skip(1)?,
            0xF2 => self.skip(2)?,
            _ => {}
        }
        self.skipped += 1;
        Some(TrackEventKind::System)
    }

    fn byte(&mut self) -> Option<u8> {
        let (first, rest) = self.rest.split_first()?;
        self.rest = rest;
        Some(*first)
    }

    /// Returns the next data byte, after real-time messages, which may be within others.
    fn data(&mut self) -> Option<u8> {
        loop {
            match self.byte()? {
                0xF8..=0xFE => self.skipped += 1,
                data => return Some(data).filter(|data| *data < 0x80),
            }
        }
    }

    fn skip(&mut self, n: usize) -> Option<()> {
        self.rest = self.rest.get(n..)?;
        self.skipped += n;
        Some(())
    }

    /// Returns the next number of variable length, at most four bytes.
    fn number(&mut self) -> Option<u32> {
        let mut number = 0;
        for _ in 0..4 {
            let byte = self.byte()?;
            number = number << 7 | u32::from(byte & 0x7F);
            if byte < 0x80 {
                return Some(number);
            }
        }
        None
    }

    /// Returns the bytes after a number that is their length.
    fn block(&mut self) -> Option<&'a [u8]> {
        let length = self.number()? as usize;
        let (block, rest) = self.rest.split_at_checked(length)?;
        self.rest = rest;
        Some(block)
    }
}
