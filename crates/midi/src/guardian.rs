//! Plays what a host says, and ends what it holds when the host says nothing any more.
//!
//! ```text
//!              begin               no sign for SILENT_AFTER, something held
//!   no host ──────────▶ follows ───────────────────────────────────────────▶ interrupted
//!      ▲                   ▲   ◀───────────────── sign: the pedals again ────────┘
//!      └────── leave: silence, from everywhere
//! ```
//!
//! Time is an argument: a process of its own calls this with its clock, so that it outlives the
//! host.

use crate::held::HeldNotes;
use crate::message::Message;
use crate::output::{MidiSendError, Output};

/// Time without a sign of the host after which its notes are ended (s).
pub const SILENT_AFTER: f64 = 0.5;

/// What is known of the host.
#[derive(Clone, PartialEq, Debug)]
enum HostSign {
    /// There is no host.
    Absent,
    /// The time of its last sign (s).
    Heard(f64),
    /// It says nothing, and what it held was ended: this.
    Interrupted(HeldNotes),
}

/// An output with a memory of what it holds for a host that may die at any time.
#[derive(Debug)]
pub struct NoteGuardian<O: Output> {
    output: O,
    held: HeldNotes,
    sign: HostSign,
    n_interruptions: u64,
}

impl<O: Output> NoteGuardian<O> {
    /// Guards what is sent to `output`, which holds nothing yet.
    pub fn new(output: O) -> Self {
        Self { output, held: HeldNotes::default(), sign: HostSign::Absent, n_interruptions: 0 }
    }

    /// Returns the output that is guarded.
    pub fn output(&self) -> &O {
        &self.output
    }

    /// Returns how often a host was interrupted since it began.
    pub fn n_interruptions(&self) -> u64 {
        self.n_interruptions
    }

    /// Follows a new host from time `now` (s) on; ends what another one left here.
    ///
    /// # Errors
    /// If a message is lost.
    pub fn begin(&mut self, now: f64) -> Result<(), MidiSendError> {
        let left = self.leave(now);
        self.sign = HostSign::Heard(now);
        self.n_interruptions = 0;
        left
    }

    /// Takes a sign of the host's life at time `now` (s); one that was interrupted goes on with
    /// the pedals that it holds, and without its notes.
    ///
    /// # Errors
    /// If a message is lost.
    pub fn hear(&mut self, now: f64) -> Result<(), MidiSendError> {
        match std::mem::replace(&mut self.sign, HostSign::Heard(now)) {
            HostSign::Interrupted(before) => {
                let pedals = before.pedals();
                for pedal in &pedals {
                    self.held.follow(*pedal);
                }
                self.send_all(now, pedals)
            }
            HostSign::Absent | HostSign::Heard(_) => Ok(()),
        }
    }

    /// Sends `message` of the host at time `now` (s), if it says anything new.
    ///
    /// # Errors
    /// If a message is lost; what is held is known all the same.
    pub fn play(&mut self, now: f64, message: Message) -> Result<(), MidiSendError> {
        let heard = self.hear(now);
        let is_news = self.held.follow(message);
        let sent = if is_news { self.output.send(now, message) } else { Ok(()) };
        heard.and(sent)
    }

    /// Ends what is held if the host has said nothing for too long, and looks after the output;
    /// to be called a few times a second.
    ///
    /// # Errors
    /// If a message is lost, or the output is away.
    pub fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        let is_overdue = matches!(self.sign, HostSign::Heard(at) if SILENT_AFTER < now - at);
        let silenced = if is_overdue && !self.held.is_silent() {
            self.n_interruptions += 1;
            self.sign = HostSign::Interrupted(self.held.clone());
            self.silence(now)
        } else {
            Ok(())
        };
        let polled = self.output.poll(now);
        silenced.and(polled)
    }

    /// Ends what the host held, which is gone at time `now` (s).
    ///
    /// # Errors
    /// If a message is lost.
    pub fn leave(&mut self, now: f64) -> Result<(), MidiSendError> {
        self.sign = HostSign::Absent;
        if self.held.is_silent() { Ok(()) } else { self.silence(now) }
    }

    fn silence(&mut self, now: f64) -> Result<(), MidiSendError> {
        let messages = self.held.release();
        self.send_all(now, messages)
    }

    /// Sends `messages`; returns the first loss, after all have been tried.
    fn send_all(&mut self, now: f64, messages: Vec<Message>) -> Result<(), MidiSendError> {
        let sent = messages.into_iter().map(|message| self.output.send(now, message));
        sent.fold(Ok(()), Result::and)
    }
}
