//! Plays the messages of a host, and ends held notes when the host falls silent.
//!
//! ```text
//!              begin               no sign for SILENT_AFTER, something held
//!   no host ──────────▶ follows ───────────────────────────────────────────▶ interrupted
//!      ▲                   ▲   ◀───────────────── sign: the pedals again ────────┘
//!      └────── leave: silence, from everywhere
//! ```
//!
//! Time is an argument: a separate process, which outlives the host, calls this with its clock.

use crate::held::HeldNotes;
use crate::message::Message;
use crate::output::{MidiSendError, Output};

/// Time without a sign of the host after which its notes end (s).
pub const SILENT_AFTER: f64 = 0.5;

#[derive(Clone, PartialEq, Debug)]
enum HostSign {
    Absent,
    /// Time of its last sign (s).
    Heard(f64),
    /// The host is silent, and these notes and pedals of its were ended.
    Interrupted(HeldNotes),
}

/// An output that remembers what it holds for a host that may die at any time.
#[derive(Debug)]
pub struct NoteGuardian<O: Output> {
    output: O,
    held: HeldNotes,
    sign: HostSign,
    n_interruptions: u64,
}

impl<O: Output> NoteGuardian<O> {
    /// Guards the messages to `output`, which holds nothing yet.
    pub fn new(output: O) -> Self {
        Self { output, held: HeldNotes::default(), sign: HostSign::Absent, n_interruptions: 0 }
    }

    pub fn output(&self) -> &O {
        &self.output
    }

    /// Returns the number of interruptions of the present host.
    pub fn n_interruptions(&self) -> u64 {
        self.n_interruptions
    }

    /// Follows a new host from time `now` (s) on; ends what another host left.
    pub fn begin(&mut self, now: f64) -> Result<(), MidiSendError> {
        let left = self.leave(now);
        self.sign = HostSign::Heard(now);
        self.n_interruptions = 0;
        left
    }

    /// Accepts a sign of life at `now` (s); an interrupted host regains its pedals, not its notes.
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

    /// Sends `message` at time `now` (s), if it changes anything for the receiver.
    ///
    /// # Errors
    /// The message is lost, but is followed all the same.
    pub fn play(&mut self, now: f64, message: Message) -> Result<(), MidiSendError> {
        let heard = self.hear(now);
        let is_news = self.held.follow(message);
        let sent = if is_news { self.output.send(now, message) } else { Ok(()) };
        heard.and(sent)
    }

    /// Ends what an overdue host holds, and polls the output; to be called a few times a second.
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
    pub fn leave(&mut self, now: f64) -> Result<(), MidiSendError> {
        self.sign = HostSign::Absent;
        if self.held.is_silent() { Ok(()) } else { self.silence(now) }
    }

    fn silence(&mut self, now: f64) -> Result<(), MidiSendError> {
        let messages = self.held.release();
        self.send_all(now, messages)
    }

    /// Sends all `messages`; returns the first loss.
    fn send_all(&mut self, now: f64, messages: Vec<Message>) -> Result<(), MidiSendError> {
        let sent = messages.into_iter().map(|message| self.output.send(now, message));
        sent.fold(Ok(()), Result::and)
    }
}
