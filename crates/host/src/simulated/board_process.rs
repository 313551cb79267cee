use boards::links::{Link, RecvError, SendError};
use boards::sim::board::{BoardMake, SimulatedBoard};
use boards::{identity::ClaimedKeys, refusal::reason_words};
use firmware_protocol::frame::hello::safe_reason;
use scheduler::time::Nanos;

use super::fault_script::{FaultEvent, FaultScript};
use super::{ExitReport, Placed};

/// Largest force that counts as none (N).
const NONE: f64 = 1e-3;

/// Longest time until motors are without force: the fade of 10 ms, their lag, and a period of
/// this simulation.
const RELEASE_TIME: Nanos = Nanos::from_millis(15);

/// A simulated board that runs by the host's clock.
#[derive(Debug)]
pub struct BoardProcess {
    pub board: SimulatedBoard,
    placed: Option<Placed>,
    pub address: String,
    /// Rate of its clock; 1 is correct.
    rate: f64,
    began: Option<Nanos>,
    armed: Option<Nanos>,
    faults: Vec<FaultScript>,
    next: usize,
    injected: InjectedFaults,
    release: ReleaseWatch,
    was_lit: bool,
    pub lights: u64,
    /// Last time at which it ran, and the longest pause while it was armed.
    ran_until: Option<Nanos>,
    longest_gap: Nanos,
}

/// Check that the motors lose their force when the board may not render.
#[derive(Clone, Copy, Debug, Default)]
struct ReleaseWatch {
    was_armed: bool,
    /// Time at which the board lost its permission, while its motors still push.
    fading: Option<Nanos>,
    /// Longest time from that loss until the motors rest.
    quiet_after: Option<Nanos>,
    /// Largest force without permission (N).
    force_while_safe: f64,
}

#[derive(Clone, Copy, Debug, Default)]
struct InjectedFaults {
    off: Nanos,
    mute: Nanos,
    deaf: Nanos,
    frozen: Nanos,
    babbling: Nanos,
}

impl BoardProcess {
    /// Makes a board that powers on when it first runs; its clock runs `ppm` too fast.
    pub fn new(
        make: BoardMake,
        placed: Placed,
        ppm: f64,
        faults: Vec<FaultScript>,
    ) -> Result<Self, boards::Error> {
        Ok(Self {
            board: SimulatedBoard::new(make)?,
            address: placed.address.to_string(),
            placed: Some(placed),
            rate: 1.0 + ppm * 1e-6,
            began: None,
            armed: None,
            faults,
            next: 0,
            injected: InjectedFaults::default(),
            release: ReleaseWatch::default(),
            was_lit: false,
            lights: 0,
            ran_until: None,
            longest_gap: Nanos::ZERO,
        })
    }

    pub fn keys(&self) -> ClaimedKeys {
        let BoardMake { first_key, n_keys, .. } = *self.board.make();
        ClaimedKeys { first: first_key, n: u8::try_from(n_keys).unwrap_or(u8::MAX) }
    }

    pub fn run(&mut self, now: Nanos) {
        let gap = now.since(self.ran_until.replace(now).unwrap_or(now));
        if self.release.was_armed {
            self.longest_gap = self.longest_gap.max(gap);
        }
        self.inject_faults(now);
        if now < self.injected.off || now < self.injected.frozen {
            return;
        }
        let began = *self.began.get_or_insert(now);
        let Some(placed) = &mut self.placed else { return };
        let passed = now.since(began).as_secs_f64() * self.rate;
        let mut link = FaultyLink {
            link: placed.link.as_mut(),
            is_mute: now < self.injected.mute,
            is_deaf: now < self.injected.deaf,
        };
        if now < self.injected.babbling {
            babble(now, &mut link);
        }
        self.board.advance(ticks(passed / self.board.make().period), &mut link);
        if !self.board.is_safe() {
            self.armed.get_or_insert(now);
        }
        self.release.watch(now, &self.board);
        let is_lit = self.board.is_lit();
        self.lights += u64::from(is_lit && !self.was_lit);
        self.was_lit = is_lit;
    }

    pub fn exit_report(&self) -> ExitReport {
        ExitReport {
            number: self.board.make().id.number(),
            keys: self.keys().to_string(),
            link: self.address.clone(),
            state: reason_words(self.board.safe_reason()),
            force_n: largest_force(&self.board),
            quiet_after_ms: self.release.quiet_after.map(|it| it.as_secs_f64() * 1e3),
            force_while_safe_n: self.release.force_while_safe,
            longest_gap_ms: self.longest_gap.as_secs_f64() * 1e3,
            lights: self.lights,
            counts: self.board.counts(),
        }
    }

    fn inject_faults(&mut self, now: Nanos) {
        let (Some(armed), Some(fault)) = (self.armed, self.faults.get(self.next)) else { return };
        if now.since(armed).as_secs_f64() < fault.at {
            return;
        }
        self.next += 1;
        let until = |seconds: f64| now.after(span(seconds));
        match fault.event {
            FaultEvent::Die => self.placed = None,
            FaultEvent::Restart(it) => self.switch_off(until(it)),
            FaultEvent::Mute(it) => self.injected.mute = until(it),
            FaultEvent::Deaf(it) => self.injected.deaf = until(it),
            FaultEvent::Freeze(it) => self.injected.frozen = until(it),
            FaultEvent::Babble(it) => self.injected.babbling = until(it),
            FaultEvent::Backwards(it) => self.board.set_clock_back(span(it).as_u64() / 1_000),
            FaultEvent::KeyFault => self.board.fail(safe_reason::KEY_FAULT),
        }
    }

    fn switch_off(&mut self, until: Nanos) {
        if let Ok(board) = self.board.restarted() {
            self.board = board;
        }
        self.injected.off = until;
        (self.began, self.release.was_armed, self.release.fading) = (None, false, None);
    }
}

/// Returns the largest force of the motors now (N).
fn largest_force(board: &SimulatedBoard) -> f64 {
    let forces = (0..board.make().n_keys).filter_map(|slot| board.rig(slot));
    forces.fold(0.0, |most, rig| rig.motor_force().abs().max(most))
}

impl ReleaseWatch {
    fn watch(&mut self, now: Nanos, board: &SimulatedBoard) {
        let is_armed = !board.is_safe();
        if is_armed {
            if let Some(since) = self.fading.take() {
                self.quiet_after = self.quiet_after.max(Some(now.since(since)));
            }
        } else if self.was_armed {
            self.fading = Some(now);
        }
        self.was_armed = is_armed;
        let force = largest_force(board);
        match self.fading {
            Some(since) if force < NONE => {
                self.quiet_after = self.quiet_after.max(Some(now.since(since)));
                self.fading = None;
            }
            Some(since) if now.since(since) < RELEASE_TIME => {}
            None if is_armed => {}
            // A repeated force, or one that lasts too long.
            Some(_) | None => self.force_while_safe = self.force_while_safe.max(force),
        }
    }
}

/// A link that loses frames while the board is mute or deaf.
struct FaultyLink<'a> {
    link: &'a mut (dyn Link + Send),
    is_mute: bool,
    is_deaf: bool,
}

impl Link for FaultyLink<'_> {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        if self.is_mute { Ok(()) } else { self.link.try_send(frame) }
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        let received = self.link.try_recv(buffer)?;
        Ok(received.filter(|_| !self.is_deaf))
    }
}

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
    // A link may reject a frame that it cannot carry.
    let _taken = link.try_send(&frame);
}

/// Converts a time that is not negative (s).
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn span(seconds: f64) -> Nanos {
    Nanos::new((seconds * 1e9) as u64)
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn ticks(count: f64) -> u64 {
    count as u64
}
