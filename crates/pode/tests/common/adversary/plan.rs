//! A whole session with an adversary, from arbitrary bytes.

use pode::{Limits, WorkLimit};

use super::bytes::Bytes;
use super::wave::Wave;
use super::{Adversary, Calls, MODES, STATE};

pub const TICKS: usize = 8;

#[derive(Clone, Copy, Debug)]
pub struct Deed {
    pub h: f64,
    pub wave: Wave,
    pub placed: Option<(u8, [f64; STATE])>,
    pub is_changed: bool,
}

#[derive(Debug)]
pub struct Plan<'a> {
    pub model: Adversary<'a>,
    pub limits: Limits,
    pub tick: u64,
    pub start: (u8, [f64; STATE]),
    pub is_read: bool,
    pub deeds: [Deed; TICKS],
}

impl<'a> Plan<'a> {
    pub fn from_bytes(bytes: &[u8], calls: &'a Calls) -> Self {
        let bytes = &mut Bytes::new(bytes);
        // First the settings of all ticks, so that few bytes make a session.
        let limits = limits(bytes);
        let tick = if bytes.is_one_in(16) { u64::MAX - 2 } else { 0 };
        let is_read = !bytes.is_one_in(4);
        let start = placed(bytes);
        let h = period(bytes);
        let mut samples = Wave::samples(bytes);
        let model = Adversary::from_bytes(bytes, calls);
        let deeds = std::array::from_fn(|_| {
            let h = if bytes.is_one_in(4) { period(bytes) } else { h };
            Deed {
                h,
                wave: Wave::from_bytes(bytes, h, &mut samples),
                placed: bytes.is_one_in(12).then(|| placed(bytes)),
                is_changed: bytes.is_one_in(12),
            }
        });
        Self { model, limits, tick, start, is_read, deeds }
    }
}

fn period(bytes: &mut Bytes<'_>) -> f64 {
    bytes.odd(|it| it.sized(1e-5, 1e-1))
}

fn placed(bytes: &mut Bytes<'_>) -> (u8, [f64; STATE]) {
    let mode = bytes.byte() % MODES;
    let height = bytes.odd(|it| it.sized(1e-9, 1.0));
    let rate = bytes.odd(|it| it.signed(1e-3, 10.0));
    (mode, [0.0, 0.0, height, rate])
}

fn limits(bytes: &mut Bytes<'_>) -> Limits {
    if bytes.is_one_in(4) {
        return Limits { forecast: bytes.is_true(), ..Limits::default() };
    }
    Limits {
        events: u32::from(bytes.byte() % 40),
        cascade: u32::from(bytes.byte() % 10),
        followed: u32::from(bytes.byte() % 10),
        guards: 8 * u32::from(bytes.byte()),
        pieces: u32::from(bytes.byte() % 80),
        work: WorkLimit::NONE,
        longest_step: bytes.odd(|it| it.sized(1e-4, 1.0)),
        forecast: bytes.is_true(),
        event_tolerance: bytes.odd(|it| it.sized(1e-15, 0.1)),
        stretch: bytes.odd(|it| it.sized(0.1, 10.0)),
    }
}
