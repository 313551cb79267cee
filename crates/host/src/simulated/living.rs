//! One simulated board in real time, and what befalls it.

use firmware_protocol::frame::hello::safe_reason;
use hardware::identity::ClaimedKeys;
use hardware::refusal::reason_words;
use hardware::sim::board::{BoardMake, SimulatedBoard};
use links::{Link, RecvError, SendError};
use scheduler::time::Nanos;

use super::fate::{FaultEvent, FaultScript};
use super::{ExitReport, Placed};

/// Force that counts as none (N).
const NONE: f64 = 1e-3;

/// How long motors may take to let go: the fade of 10 ms, their lag, and a look of ours.
const LETTING_GO: Nanos = Nanos::from_millis(15);

/// A board that lives by the host's clock.
#[derive(Debug)]
pub struct BoardProcess {
    make: BoardMake,
    board: SimulatedBoard,
    placed: Option<Placed>,
    address: String,
    /// How fast its clock runs, 1 for right.
    rate: f64,
    /// When it was switched on.
    began: Option<Nanos>,
    /// When it was armed for the first time.
    armed: Option<Nanos>,
    fates: Vec<FaultScript>,
    next: usize,
    trouble: InjectedFault,
    /// When it lost its right to render, and its motors still pushed.
    fading: Option<Nanos>,
    quiet_after: Option<Nanos>,
    force_while_safe: f64,
    was_armed: bool,
    was_lit: bool,
    lights: u64,
    /// When it was last looked after, and the longest time between two such while armed.
    looked_after: Option<Nanos>,
    longest_gap: Nanos,
}

/// What is wrong for a while, until when.
#[derive(Clone, Copy, Debug, Default)]
struct InjectedFault {
    off: Nanos,
    mute: Nanos,
    deaf: Nanos,
    frozen: Nanos,
    babbling: Nanos,
}

impl BoardProcess {
    /// A board that is switched on when it first lives; its clock runs `ppm` too fast.
    ///
    /// # Errors
    /// Refuses what no board can be.
    pub fn new(
        make: BoardMake,
        placed: Placed,
        ppm: f64,
        fates: Vec<FaultScript>,
    ) -> Result<Self, hardware::Error> {
        Ok(Self {
            board: SimulatedBoard::new(make)?,
            make,
            address: placed.address.to_string(),
            placed: Some(placed),
            rate: 1.0 + ppm * 1e-6,
            began: None,
            armed: None,
            fates,
            next: 0,
            trouble: InjectedFault::default(),
            fading: None,
            quiet_after: None,
            force_while_safe: 0.0,
            was_armed: false,
            was_lit: false,
            lights: 0,
            looked_after: None,
            longest_gap: Nanos::ZERO,
        })
    }

    /// What a host has to open.
    pub fn address(&self) -> &str {
        &self.address
    }

    /// The board.
    pub const fn board(&self) -> &SimulatedBoard {
        &self.board
    }

    /// Its keys.
    pub fn keys(&self) -> ClaimedKeys {
        let n = u8::try_from(self.make.n_keys).unwrap_or(u8::MAX);
        ClaimedKeys { first: self.make.first_key, n }
    }

    /// Lives until `now`.
    pub fn live(&mut self, now: Nanos) {
        let gap = now.since(self.looked_after.replace(now).unwrap_or(now));
        if self.was_armed {
            self.longest_gap = self.longest_gap.max(gap);
        }
        self.suffer(now);
        if now < self.trouble.off || now < self.trouble.frozen {
            return;
        }
        let began = *self.began.get_or_insert(now);
        let Some(placed) = &mut self.placed else { return };
        let passed = now.since(began).as_secs_f64() * self.rate;
        let mut link = Troubled {
            link: placed.link.as_mut(),
            is_mute: now < self.trouble.mute,
            is_deaf: now < self.trouble.deaf,
        };
        if now < self.trouble.babbling {
            babble(now, &mut link);
        }
        self.board.advance(ticks(passed / self.make.period), &mut link);
        self.watch(now);
        let is_lit = self.board.is_lit();
        self.lights += u64::from(is_lit && !self.was_lit);
        self.was_lit = is_lit;
    }

    /// Times that its light went on.
    pub const fn lights(&self) -> u64 {
        self.lights
    }

    /// What is left to be said of it.
    pub fn epitaph(&self) -> ExitReport {
        ExitReport {
            number: self.make.id.number(),
            keys: self.keys().to_string(),
            link: self.address.clone(),
            state: reason_words(self.board.safe_reason()),
            force_n: self.force(),
            quiet_after_ms: self.quiet_after.map(|it| it.as_secs_f64() * 1e3),
            force_while_safe_n: self.force_while_safe,
            longest_gap_ms: self.longest_gap.as_secs_f64() * 1e3,
            lights: self.lights,
            counts: self.board.counts(),
        }
    }

    /// Largest force of its motors now (N).
    fn force(&self) -> f64 {
        let forces = (0..self.make.n_keys).filter_map(|slot| self.board.rig(slot));
        forces.fold(0.0, |most, rig| rig.motor_force().abs().max(most))
    }

    /// Watches that its motors fall silent when it has no right to render.
    fn watch(&mut self, now: Nanos) {
        let is_armed = !self.board.is_safe();
        if is_armed {
            self.armed.get_or_insert(now);
            if let Some(since) = self.fading.take() {
                self.quiet_after = self.quiet_after.max(Some(now.since(since)));
            }
        } else if self.was_armed {
            self.fading = Some(now);
        }
        self.was_armed = is_armed;
        let force = self.force();
        match self.fading {
            Some(since) if force < NONE => {
                self.quiet_after = self.quiet_after.max(Some(now.since(since)));
                self.fading = None;
            }
            Some(since) if now.since(since) < LETTING_GO => {}
            None if is_armed => {}
            // Silent once, or for too long not.
            Some(_) | None => self.force_while_safe = self.force_while_safe.max(force),
        }
    }

    /// Lets the next blow fall if its time has come.
    fn suffer(&mut self, now: Nanos) {
        let (Some(armed), Some(fate)) = (self.armed, self.fates.get(self.next)) else { return };
        if now.since(armed).as_secs_f64() < fate.at {
            return;
        }
        self.next += 1;
        let until = |seconds: f64| now.after(span(seconds));
        match fate.blow {
            FaultEvent::Die => self.placed = None,
            FaultEvent::Restart(it) => self.switch_off(until(it)),
            FaultEvent::Mute(it) => self.trouble.mute = until(it),
            FaultEvent::Deaf(it) => self.trouble.deaf = until(it),
            FaultEvent::Freeze(it) => self.trouble.frozen = until(it),
            FaultEvent::Babble(it) => self.trouble.babbling = until(it),
            FaultEvent::Backwards(it) => self.board.set_clock_back(span(it).as_u64() / 1_000),
            FaultEvent::KeyFault => self.board.fail(safe_reason::KEY_FAULT),
        }
    }

    /// Takes its power away until then; what it knew is lost.
    fn switch_off(&mut self, until: Nanos) {
        if let Ok(board) = SimulatedBoard::new(self.make) {
            self.board = board;
        }
        self.trouble.off = until;
        (self.began, self.was_armed, self.fading) = (None, false, None);
    }
}

/// A link as a board in trouble has it.
struct Troubled<'a> {
    link: &'a mut (dyn Link + Send),
    is_mute: bool,
    is_deaf: bool,
}

impl Link for Troubled<'_> {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        if self.is_mute { Ok(()) } else { self.link.try_send(frame) }
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        let received = self.link.try_recv(buffer)?;
        Ok(received.filter(|_| !self.is_deaf))
    }
}

/// Sends a frame of chance.
fn babble(now: Nanos, link: &mut impl Link) {
    let mut state = now.as_u64() | 1;
    let mut frame = [0; 40];
    for byte in &mut frame {
        // Xorshift, G. Marsaglia, 2003.
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        [*byte, ..] = state.to_le_bytes();
    }
    // Frames that no link can carry are refused by it, which is babble enough.
    let _taken = link.try_send(&frame);
}

/// A span that is not negative (s).
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn span(seconds: f64) -> Nanos {
    Nanos::new((seconds * 1e9) as u64)
}

/// Whole ticks in a number of them that is not negative.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn ticks(count: f64) -> u64 {
    count as u64
}
