//! Messages from key events, with memory of the held notes.

use keyboard::{KEYS, KeyIndex};
use rtrb::Consumer;

use crate::message::{Controller, Message};
use crate::note::{Note, Velocity};
use crate::output::{MidiSendError, Output};
use crate::pedal::{Pedal, PedalValues};
use crate::velocity::{VelocityCurve, release_velocity};

/// Length of a note that was struck with its damper down (s): the hammer of a short, sharp touch
/// may arrive after its damper has fallen again.
pub const UNDAMPED: f64 = 0.05;

/// Audible event at a key.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NoteEvent {
    /// Key, 0 ..= 87; any for a pedal.
    pub key: u8,
    /// Time since the host started (s).
    pub at: f64,
    pub kind: NoteEventKind,
}

/// Kind of an audible event.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum NoteEventKind {
    Strike {
        /// Speed of a grand's hammer (m/s) that is as loud.
        speed: f64,
        /// Fixed velocity of an instrument without dynamics.
        velocity: Option<Velocity>,
    },
    DamperFall {
        /// Speed of the rising key (m/s).
        speed: f64,
    },
    /// The damper leaves the string.
    DamperLift,
    /// The force on the held key changes; 0 (none) to 127.
    Pressure { value: u8, scope: PressureTarget },
    /// A pedal is at this depth, for all keys.
    Pedal {
        pedal: Pedal,
        /// Depth from 0 (up) to 1 (down).
        depth: f64,
    },
}

/// Notes that a pressure applies to.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PressureTarget {
    /// All notes: the greatest pressure of all keys is sent.
    Channel,
    Key,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum DamperState {
    /// Its lifts are not reported, or none has happened yet.
    Unreported,
    Up,
    Down,
}

#[derive(Clone, Copy, PartialEq, Debug)]
struct NoteState {
    sounding: bool,
    damper: DamperState,
    /// Time when it ends by itself (s), if struck with its damper down.
    until: Option<f64>,
}

const SILENT: NoteState =
    NoteState { sounding: false, damper: DamperState::Unreported, until: None };

/// Turns key events into messages, and leaves no note sounding.
///
/// Dropping a player silences what it holds. A host that may be interrupted or panic calls
/// [`Player::silence`] from the thread that owns the player.
#[derive(Debug)]
pub struct Player<O: Output> {
    output: O,
    curve: VelocityCurve,
    held: [NoteState; KEYS],
    /// Latest sent values of the pedals' controllers.
    pedals: PedalValues,
    /// Pressure of each key that applies to the channel.
    pressed: [u8; KEYS],
    /// Latest time of an event (s).
    now: f64,
    /// `true` if anything was sent since the last silence.
    stirred: bool,
}

impl<O: Output> Player<O> {
    pub fn new(output: O, curve: VelocityCurve) -> Self {
        let held = [SILENT; KEYS];
        let pedals = PedalValues::default();
        Self { output, curve, held, pedals, pressed: [0; KEYS], now: 0.0, stirred: false }
    }

    pub fn output(&self) -> &O {
        &self.output
    }

    pub fn choose_curve(&mut self, curve: VelocityCurve) {
        self.curve = curve;
    }

    /// Returns `true` if the note of `key` sounds, as far as this player knows.
    pub fn is_sounding(&self, key: u8) -> bool {
        self.held.get(usize::from(key)).is_some_and(|held| held.sounding)
    }

    /// Sends the messages of `event`; events come in order of time.
    ///
    /// # Errors
    /// A message is lost, but is followed all the same.
    pub fn play(&mut self, event: NoteEvent) -> Result<(), MidiSendError> {
        let fallen = self.advance(event.at);
        let played = self.respond(event);
        fallen.and(played)
    }

    /// Plays all waiting `events`; returns their number.
    ///
    /// # Errors
    /// The first loss of a message, after all events have been played.
    pub fn drain(&mut self, events: &mut Consumer<NoteEvent>) -> Result<usize, MidiSendError> {
        let mut outcome = Ok(());
        let n_events = events.slots();
        for _ in 0..n_events {
            let Ok(event) = events.pop() else { break };
            let played = self.play(event);
            outcome = outcome.and(played);
        }
        outcome.map(|()| n_events)
    }

    /// Does what is due at time `now` (s) without an event; to be called a few times a second.
    pub fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        let fallen = self.advance(now);
        let polled = self.output.poll(now);
        fallen.and(polled)
    }

    /// Ends held notes, pressure and pedals, as if the player lifted hands and feet.
    ///
    /// # Errors
    /// The first loss of a message, after all have been tried.
    pub fn silence(&mut self) -> Result<(), MidiSendError> {
        let mut outcome = Ok(());
        for key in KeyIndex::all().map(KeyIndex::number) {
            let released = self.release(key, self.now, Velocity::UNKNOWN);
            outcome = outcome.and(released);
        }
        if self.pressed.iter().any(|value| *value > 0) {
            self.pressed = [0; KEYS];
            let sent = self.send(self.now, Message::ChannelPressure { value: 0 });
            outcome = outcome.and(sent);
        }
        for lifted in std::mem::take(&mut self.pedals).lifted() {
            let sent = self.send(self.now, lifted);
            outcome = outcome.and(sent);
        }
        self.stirred = false;
        outcome
    }

    /// Silences the receiver at once, in an emergency: after [`Player::silence`] also notes of
    /// other senders, and decaying ones.
    ///
    /// # Errors
    /// The first loss of a message, after all have been tried.
    pub fn cut_off(&mut self) -> Result<(), MidiSendError> {
        let mut outcome = self.silence();
        for controller in [Controller::AllNotesOff, Controller::AllSoundOff] {
            let sent = self.send(self.now, Message::ControlChange { controller, value: 0 });
            outcome = outcome.and(sent);
        }
        self.stirred = false;
        outcome
    }

    /// Silences everything and makes the output durable.
    pub fn finish(&mut self) -> Result<(), MidiSendError> {
        let silenced = if self.stirred { self.silence() } else { Ok(()) };
        let finished = self.output.finish();
        silenced.and(finished)
    }

    fn respond(&mut self, event: NoteEvent) -> Result<(), MidiSendError> {
        let NoteEvent { key, at, kind } = event;
        match kind {
            NoteEventKind::Strike { speed, velocity } => {
                self.strike(key, at, velocity.unwrap_or_else(|| self.curve.velocity(speed)))
            }
            NoteEventKind::Pressure { value, scope } => self.touch(key, at, (value, scope)),
            NoteEventKind::DamperFall { speed } => {
                self.lay_damper(key);
                self.release(key, at, release_velocity(speed))
            }
            NoteEventKind::DamperLift => {
                self.lift_damper(key);
                Ok(())
            }
            NoteEventKind::Pedal { pedal, depth } => self.press(at, pedal, depth),
        }
    }

    fn strike(&mut self, key: u8, at: f64, velocity: Velocity) -> Result<(), MidiSendError> {
        let Some(note) = Note::from_key(key) else { return Ok(()) };
        let released = self.release(key, at, Velocity::UNKNOWN);
        let held = &mut self.held[usize::from(key)];
        held.sounding = true;
        held.until = (held.damper == DamperState::Down).then_some(at + UNDAMPED);
        let sent = self.send(at, Message::NoteOn { note, velocity });
        released.and(sent)
    }

    fn release(&mut self, key: u8, at: f64, velocity: Velocity) -> Result<(), MidiSendError> {
        let Some(note) = Note::from_key(key) else { return Ok(()) };
        let held = &mut self.held[usize::from(key)];
        if !held.sounding {
            return Ok(());
        }
        held.sounding = false;
        held.until = None;
        self.send(at, Message::NoteOff { note, velocity })
    }

    fn touch(
        &mut self,
        key: u8,
        at: f64,
        (value, scope): (u8, PressureTarget),
    ) -> Result<(), MidiSendError> {
        let Some(note) = Note::from_key(key) else { return Ok(()) };
        if scope == PressureTarget::Key {
            return self.send(at, Message::KeyPressure { note, value });
        }
        let greatest = |keys: &[u8; KEYS]| keys.iter().copied().max().unwrap_or(0);
        let before = greatest(&self.pressed);
        self.pressed[usize::from(key)] = value;
        let value = greatest(&self.pressed);
        if value == before {
            return Ok(());
        }
        self.send(at, Message::ChannelPressure { value })
    }

    fn lay_damper(&mut self, key: u8) {
        if let Some(held) = self.held.get_mut(usize::from(key))
            && held.damper == DamperState::Up
        {
            held.damper = DamperState::Down;
        }
    }

    fn lift_damper(&mut self, key: u8) {
        if let Some(held) = self.held.get_mut(usize::from(key)) {
            held.damper = DamperState::Up;
            held.until = None;
        }
    }

    fn press(&mut self, at: f64, pedal: Pedal, depth: f64) -> Result<(), MidiSendError> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped to 0 ..= 127 before; NaN becomes 0, a pedal that is up"
        )]
        let value = (depth.clamp(0.0, 1.0) * 127.0).round() as u8;
        if !self.pedals.set(pedal, value) {
            return Ok(());
        }
        self.send(at, Message::ControlChange { controller: pedal.controller(), value })
    }

    /// Moves to time `now` (s), and ends the notes that are due by then.
    fn advance(&mut self, now: f64) -> Result<(), MidiSendError> {
        let mut outcome = Ok(());
        for key in KeyIndex::all().map(KeyIndex::number) {
            let due = self.held[usize::from(key)].until;
            if let Some(at) = due.filter(|at| *at <= now) {
                let released = self.release(key, at, Velocity::UNKNOWN);
                outcome = outcome.and(released);
            }
        }
        self.now = self.now.max(now);
        outcome
    }

    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        self.stirred = true;
        self.output.send(at, message)
    }
}

impl<O: Output> Drop for Player<O> {
    /// Silences what is held; a lost message cannot be reported.
    fn drop(&mut self) {
        if self.stirred && self.silence().is_err() {
            self.stirred = false;
        }
    }
}
