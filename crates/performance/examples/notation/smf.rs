//! A piece as a Standard MIDI File, format 0.

use std::io;

use midly::num::{u4, u7, u15, u24, u28};
use midly::{Format, Header, MetaMessage, MidiMessage, Timing, TrackEvent, TrackEventKind};

use super::piece::Piece;
use super::token::QUARTER;

/// CC64.
const SUSTAIN: u8 = 64;

/// The bytes of `piece`.
pub(super) fn encode(piece: &Piece) -> io::Result<Vec<u8>> {
    let events = in_order(piece);
    let mut now = 0;
    let mut track: Vec<_> = events
        .into_iter()
        .map(|(at, kind)| {
            let delta = u28::from_int_lossy(at - now);
            now = at;
            TrackEvent { delta, kind }
        })
        .collect();
    let kind = TrackEventKind::Meta(MetaMessage::EndOfTrack);
    track.push(TrackEvent { delta: u28::new(QUARTER), kind });
    let ticks = u16::try_from(QUARTER).map_err(io::Error::other)?;
    let header = Header::new(Format::SingleTrack, Timing::Metrical(u15::new(ticks)));
    let mut bytes = Vec::new();
    midly::write_std(&header, [&track], &mut bytes)?;
    Ok(bytes)
}

/// All events with their ticks; of those of one tick, note-offs before note-ons.
fn in_order(piece: &Piece) -> Vec<(u32, TrackEventKind<'_>)> {
    let mut events = tempo(piece);
    let named = [
        MetaMessage::TrackName(piece.title.as_bytes()),
        MetaMessage::Text(piece.composer.as_bytes()),
    ];
    events.extend(named.map(|meta| (0, TrackEventKind::Meta(meta))));
    events.extend(piece.sounds.iter().map(|sound| {
        let key = u7::from_int_lossy(sound.pitch);
        (sound.to, midi(MidiMessage::NoteOff { key, vel: u7::new(64) }))
    }));
    events.extend(piece.pedals.iter().map(|&(at, is_down)| {
        let value = u7::new(if is_down { 127 } else { 0 });
        (at, midi(MidiMessage::Controller { controller: u7::new(SUSTAIN), value }))
    }));
    events.push((piece.end(), pedal_up()));
    events.extend(piece.sounds.iter().map(|sound| {
        let key = u7::from_int_lossy(sound.pitch);
        (sound.from, midi(MidiMessage::NoteOn { key, vel: u7::from_int_lossy(sound.velocity) }))
    }));
    events.sort_by_key(|(at, _)| *at);
    events
}

/// The tempo at every quarter at which it has changed.
fn tempo(piece: &Piece) -> Vec<(u32, TrackEventKind<'_>)> {
    let mut events = Vec::new();
    let mut last = 0;
    for tick in (0..piece.end()).step_by(QUARTER as usize) {
        let us = microseconds(piece.tempo.at(tick));
        if us != last {
            events.push((tick, TrackEventKind::Meta(MetaMessage::Tempo(u24::from_int_lossy(us)))));
        }
        last = us;
    }
    events
}

/// Length of a quarter (µs) at so many a minute; 120 where none are given.
fn microseconds(per_minute: f64) -> u32 {
    let per_minute = if per_minute > 0.0 { per_minute } else { 120.0 };
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "positive, and a tempo beyond the range is limited by the conversion"
    )]
    let us = (60e6 / per_minute).round() as u32;
    us
}

fn pedal_up() -> TrackEventKind<'static> {
    midi(MidiMessage::Controller { controller: u7::new(SUSTAIN), value: u7::new(0) })
}

fn midi(message: MidiMessage) -> TrackEventKind<'static> {
    TrackEventKind::Midi { channel: u4::new(0), message }
}
