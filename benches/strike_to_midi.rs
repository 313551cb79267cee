//! Strikes in the ring to MIDI messages: the MIDI thread's work for a chord of ten.
#![expect(clippy::expect_used, reason = "a bench may stop here")]

#[path = "setting/mod.rs"]
mod setting;

use std::hint::black_box;

use criterion::BatchSize;
use host::midi_thread::MidiDispatcher;
use midi::{Message, MidiSendError, NoteEvent, NoteEventKind, Output, VelocityCurve};

const KEYS: [u8; 10] = [3, 15, 27, 31, 34, 39, 43, 46, 51, 63];

struct Port;

impl Output for Port {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        let _sent = black_box((at, message));
        Ok(())
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        Ok(())
    }
}

fn main() {
    let mut criterion = setting::criterion();
    criterion.bench_function("strike_to_midi/chord", |bencher| {
        bencher.iter_batched_ref(waiting, MidiDispatcher::drain, BatchSize::SmallInput);
    });
    criterion.final_summary();
}

fn waiting() -> MidiDispatcher {
    let (mut ring, events) = rtrb::RingBuffer::new(KEYS.len());
    for (order, key) in KEYS.into_iter().rev().enumerate() {
        let kind = NoteEventKind::Strike { speed: 0.5 + 0.1 * order as f64, velocity: None };
        ring.push(NoteEvent { key, at: 1e-4 * f64::from(key), kind }).expect("room");
    }
    MidiDispatcher::new(events, Box::new(Port), VelocityCurve::default())
}
