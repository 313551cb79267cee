//! Messages that a player sends.

#![expect(clippy::expect_used, reason = "a test that cannot be set up fails")]

use std::cell::RefCell;
use std::rc::Rc;

mod common;

use midi::{
    Message, MidiSendError, NoteEvent, NoteEventKind, Output, Pedal, Player, PressureTarget,
    Velocity, VelocityCurve,
};

use common::MessageRecorder;

/// Middle C, note 60.
const KEY: u8 = 39;

fn strike(at: f64, speed: f64) -> NoteEvent {
    NoteEvent { key: KEY, at, kind: NoteEventKind::Strike { speed, velocity: None } }
}

fn fall(at: f64) -> NoteEvent {
    NoteEvent { key: KEY, at, kind: NoteEventKind::DamperFall { speed: 0.2 } }
}

fn lift(at: f64) -> NoteEvent {
    NoteEvent { key: KEY, at, kind: NoteEventKind::DamperLift }
}

fn sustain(at: f64, depth: f64) -> NoteEvent {
    NoteEvent { key: 0, at, kind: NoteEventKind::Pedal { pedal: Pedal::Sustain, depth } }
}

fn on(at: f64, velocity: u8) -> (f64, [u8; 3]) {
    (at, [0x90, 60, velocity])
}

fn off(at: f64, velocity: u8) -> (f64, [u8; 3]) {
    (at, [0x80, 60, velocity])
}

fn sent(player: &Player<MessageRecorder>) -> Vec<(f64, [u8; 3])> {
    player
        .output()
        .messages()
        .iter()
        .map(|(at, message)| (*at, *message.encode().first_chunk().expect("three bytes")))
        .collect()
}

fn press(at: f64, pedal: Pedal, depth: f64) -> NoteEvent {
    NoteEvent { key: 0, at, kind: NoteEventKind::Pedal { pedal, depth } }
}

type Row<'a> = (&'a str, &'a [NoteEvent], &'a [(f64, [u8; 3])]);

#[test]
fn each_sequence_of_events_gives_these_messages() {
    let pedals = [(1.0, Pedal::Sostenuto, 1.0), (1.1, Pedal::UnaCorda, 0.5)]
        .into_iter()
        .chain([(1.2, Pedal::Sustain, 0.0), (1.3, Pedal::Sostenuto, 0.0)]);
    let pedals: Vec<_> = pedals.map(|(at, pedal, depth)| press(at, pedal, depth)).collect();
    let beyond = NoteEvent { key: 88, ..strike(0.0, 1.0) };
    let kind = NoteEventKind::Strike { speed: 5.0, velocity: Velocity::new(64) };
    let without_dynamics = NoteEvent { key: KEY, at: 1.0, kind };
    let rows: [Row<'_>; 10] = [
        (
            "a note begins at the strike and ends when the damper falls",
            &[lift(0.9), strike(1.0, 1.0), fall(2.0)],
            &[on(1.0, 58), off(2.0, 64)],
        ),
        (
            "a key struck again before its damper falls ends the first note",
            &[lift(0.9), strike(1.0, 1.0), strike(1.2, 2.0), fall(2.0)],
            &[on(1.0, 58), off(1.2, 64), on(1.2, 79), off(2.0, 64)],
        ),
        ("a silent press sends nothing", &[lift(0.9), fall(2.0)], &[]),
        (
            "a strike after the damper fell sounds and does not hang",
            &[lift(0.9), fall(1.0), strike(1.002, 1.0), sustain(1.2, 1.0)],
            &[on(1.002, 58), off(1.052, 64), (1.2, [0xB0, 64, 127])],
        ),
        (
            "a damper that lifts again under a late strike keeps it",
            &[lift(0.9), fall(1.0), strike(1.002, 1.0), lift(1.01), fall(2.0)],
            &[on(1.002, 58), off(2.0, 64)],
        ),
        (
            "an action that reports no lifts holds its notes",
            &[strike(1.0, 1.0), fall(2.0), strike(3.0, 1.0), sustain(3.5, 0.0), fall(4.0)],
            &[on(1.0, 58), off(2.0, 64), on(3.0, 58), off(4.0, 64)],
        ),
        (
            "the pedal is sent when its value changes",
            &[sustain(1.0, 0.5), sustain(1.1, 0.501), sustain(1.2, f64::NAN)],
            &[(1.0, [0xB0, 64, 64]), (1.2, [0xB0, 64, 0])],
        ),
        (
            "each pedal has its controller and moves by itself",
            &pedals,
            &[(1.0, [0xB0, 66, 127]), (1.1, [0xB0, 67, 64]), (1.3, [0xB0, 66, 0])],
        ),
        ("a key that does not exist is silent", &[beyond], &[]),
        (
            "an instrument without dynamics has one velocity",
            &[lift(0.9), without_dynamics],
            &[on(1.0, 64)],
        ),
    ];
    for (label, events, expected) in rows {
        let mut player = Player::new(MessageRecorder::default(), VelocityCurve::default());
        for event in events {
            player.play(*event).expect("memory takes everything");
        }
        assert_eq!(sent(&player), expected, "{label}");
    }
}

#[test]
fn silence_releases_what_is_held_and_resets_the_rest() {
    let mut player = Player::new(MessageRecorder::default(), VelocityCurve::default());
    player.play(strike(1.0, 1.0)).expect("memory");
    player.play(sustain(1.5, 1.0)).expect("memory");
    player.silence().expect("memory");
    assert!(!player.is_sounding(KEY));
    let lifted = (1.5, [0xB0, 64, 0]);
    assert_eq!(sent(&player)[2..], [off(1.5, 64), lifted]);
    player.cut_off().expect("memory");
    assert_eq!(sent(&player)[4..], [123, 120].map(|number| (1.5, [0xB0, number, 0])));
}

#[test]
fn events_from_the_tick_are_drained_from_their_ring() {
    let (mut tick, mut events) = rtrb::RingBuffer::new(8);
    for event in [lift(0.9), strike(1.0, 1.0), fall(2.0)] {
        tick.push(event).expect("room");
    }
    let mut player = Player::new(MessageRecorder::default(), VelocityCurve::default());
    assert_eq!(player.drain(&mut events).expect("memory"), 3);
    assert_eq!(sent(&player), [on(1.0, 58), off(2.0, 64)]);
}

/// Output that the test still reads when the player is gone.
#[derive(Clone, Default)]
struct Shared {
    sent: Rc<RefCell<Vec<[u8; 3]>>>,
    broken: bool,
}

impl Output for Shared {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        self.sent.borrow_mut().push(*message.encode().first_chunk().expect("three bytes"));
        if self.broken { Err(MidiSendError::NoSuchTime { at }) } else { Ok(()) }
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        Ok(())
    }
}

#[test]
fn a_player_that_goes_away_leaves_no_note_hanging() {
    let output = Shared::default();
    let sent = Rc::clone(&output.sent);
    let mut player = Player::new(output, VelocityCurve::default());
    player.play(strike(1.0, 1.0)).expect("accepted");
    drop(player);
    assert_eq!(sent.borrow()[1..], [[0x80, 60, 64]]);
}

#[test]
fn a_player_that_has_finished_sends_nothing_more() {
    let output = Shared::default();
    let sent = Rc::clone(&output.sent);
    let mut player = Player::new(output, VelocityCurve::default());
    player.play(strike(1.0, 1.0)).expect("accepted");
    player.finish().expect("accepted");
    let n_sent = sent.borrow().len();
    player.finish().expect("accepted");
    drop(player);
    assert_eq!(sent.borrow().len(), n_sent);
}

#[test]
fn silence_tries_every_message_even_if_all_are_lost() {
    let output = Shared { broken: true, ..Shared::default() };
    let sent = Rc::clone(&output.sent);
    let mut player = Player::new(output, VelocityCurve::default());
    assert!(player.play(strike(1.0, 1.0)).is_err());
    assert!(player.cut_off().is_err());
    assert_eq!(sent.borrow().len(), 1 + 3);
}

#[test]
fn the_channel_has_the_greatest_pressure_of_all_keys_and_none_when_all_is_silenced() {
    let press = |key, value, scope| NoteEvent {
        key,
        at: 1.0,
        kind: NoteEventKind::Pressure { value, scope },
    };
    let mut player = Player::new(MessageRecorder::default(), VelocityCurve::default());
    for (key, value) in [(3, 40), (5, 20), (3, 10), (5, 20)] {
        player.play(press(key, value, PressureTarget::Channel)).expect("memory takes everything");
    }
    player.play(press(KEY, 7, PressureTarget::Key)).expect("memory takes everything");
    player.silence().expect("memory takes everything");
    let pressure: Vec<_> = player
        .output()
        .messages()
        .iter()
        .map(|(_, message)| message.encode().to_vec())
        .filter(|bytes| matches!(bytes[0], 0xA0 | 0xD0))
        .collect();
    let expected: [&[u8]; 5] = [&[0xD0, 40], &[0xD0, 20], &[0xA0, 60, 7], &[0xD0, 0], &[]];
    assert_eq!(pressure, expected[..4]);
}
