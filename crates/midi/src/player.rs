//! Key events to messages, with the notes that are held.

use keyboard::{KEYS, KeyIndex};
use rtrb::Consumer;

use crate::message::{Controller, Message};
use crate::note::{Note, Velocity};
use crate::output::{MidiSendError, Output};
use crate::pedal::{Pedal, PedalValues};
use crate::velocity::{VelocityCurve, release_velocity};

/// How long a note sounds that was struck with its damper down (s).
///
/// The hammer of a short, sharp touch may arrive after its damper has fallen again.
pub const UNDAMPED: f64 = 0.05;

/// Something that happened at a key and can be heard.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NoteEvent {
    /// Which key, 0 ..= 87; any for a pedal.
    pub key: u8,
    /// When (s since the host started).
    pub at: f64,
    pub kind: NoteEventKind,
}

/// What can be heard of a key.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum NoteEventKind {
    /// The hammer meets the string.
    Strike {
        /// Speed of a grand's hammer (m/s) that is as loud.
        speed: f64,
        /// The velocity whatever the speed, of an instrument without dynamics.
        velocity: Option<Velocity>,
    },
    /// The damper reaches the string.
    DamperFall {
        /// Speed at which the key rises (m/s).
        speed: f64,
    },
    /// The damper leaves the string.
    DamperLift,
    /// The key is held down with another force, 0 (none) to 127.
    Pressure { value: u8, scope: PressureTarget },
    /// A pedal is at this depth; concerns all keys.
    Pedal {
        /// Which of the three pedals.
        pedal: Pedal,
        /// How deep it is, from 0 (up) to 1 (down).
        depth: f64,
    },
}

/// Whom a pressure concerns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PressureTarget {
    /// All notes: the greatest of all keys is sent.
    Channel,
    /// The key's own note.
    Key,
}

/// Where a damper is, as far as it was reported.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum DamperState {
    /// Its lifts are not reported, or none has happened yet.
    Unreported,
    Up,
    Down,
}

/// What is known of a note.
#[derive(Clone, Copy, PartialEq, Debug)]
struct NoteState {
    sounding: bool,
    damper: DamperState,
    /// When it falls silent by itself (s): it was struck with its damper down.
    until: Option<f64>,
}

const SILENT: NoteState =
    NoteState { sounding: false, damper: DamperState::Unreported, until: None };

/// Turns key events into messages, and leaves no note hanging.
///
/// Dropping a player silences what it holds; a host that may be interrupted or panic calls
/// [`Player::silence`] from the thread that owns the player.
#[derive(Debug)]
pub struct Player<O: Output> {
    output: O,
    curve: VelocityCurve,
    held: [NoteState; KEYS],
    /// Values of the pedals' controllers that were sent last.
    pedals: PedalValues,
    /// Pressure of each key that concerns the channel.
    pressed: [u8; KEYS],
    /// Latest time that was seen (s).
    now: f64,
    /// Whether anything was sent since all was silenced.
    stirred: bool,
}

impl<O: Output> Player<O> {
    /// A player that sends to `output`, with velocities by `curve`.
    pub fn new(output: O, curve: VelocityCurve) -> Self {
        let held = [SILENT; KEYS];
        let pedals = PedalValues::default();
        Self { output, curve, held, pedals, pressed: [0; KEYS], now: 0.0, stirred: false }
    }

    /// Where the messages go.
    pub fn output(&self) -> &O {
        &self.output
    }

    /// The curve from now on.
    pub fn choose_curve(&mut self, curve: VelocityCurve) {
        self.curve = curve;
    }

    /// Whether the note of `key` sounds, as far as this player knows.
    pub fn is_sounding(&self, key: u8) -> bool {
        self.held.get(usize::from(key)).is_some_and(|held| held.sounding)
    }

    /// Sends what `event` asks for; events come in order of time.
    ///
    /// # Errors
    ///
    /// If a message is lost; what is held is known all the same.
    pub fn play(&mut self, event: NoteEvent) -> Result<(), MidiSendError> {
        let fallen = self.advance(event.at);
        let played = self.respond(event);
        fallen.and(played)
    }

    /// Plays every event that waits in `events`, and returns how many there were.
    ///
    /// # Errors
    ///
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
    ///
    /// # Errors
    ///
    /// If the output is away.
    pub fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        let fallen = self.advance(now);
        let polled = self.output.poll(now);
        fallen.and(polled)
    }

    /// Ends everything as a player would who lifts hands and feet: held notes, pressure, pedals.
    ///
    /// # Errors
    ///
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

    /// Silences the receiver at once, in an emergency: after [`Player::silence`] also what others
    /// have left, and what still decays.
    ///
    /// # Errors
    ///
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

    /// Silences everything and brings the output to safety.
    ///
    /// # Errors
    ///
    /// If a message is lost or a recording cannot be written.
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

    /// Sends the note-off of `key` if its note sounds.
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

    /// Moves to time `now` (s), ending the notes that fall silent by themselves until then.
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
    /// Silences what is held; an output that is away cannot be told.
    fn drop(&mut self) {
        if self.stirred && self.silence().is_err() {
            self.stirred = false;
        }
    }
}
