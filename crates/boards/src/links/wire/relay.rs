use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

use rustix::event::{PollFd, PollFlags, Timespec, poll};

use super::{WireControl, WirePlan, direction::WireDirection};
use crate::links::serial::{Disconnected, NonBlockingFd, PtyPair};

const CHUNK: usize = 1_024;
/// Longest sleep of the relay, and so the interval of checks of its stop flag (ns).
const LONGEST_SLEEP: u64 = 5_000_000;
/// Shortest sleep of the relay (ns).
const SHORTEST_SLEEP: u64 = 20_000;

pub(super) fn run(host: &PtyPair, board: &PtyPair, plan: WirePlan, control: &WireControl) {
    let (mut down, mut up) = (WireDirection::new(plan, 0), WireDirection::new(plan, 1));
    let clock = WireClock::start();
    while !control.stop.load(Ordering::Relaxed) {
        let (host, board) = (&host.stream, &board.stream);
        let moved = carry(&mut down, host, board, clock.now(), control)
            .and_then(|()| carry(&mut up, board, host, clock.now(), control));
        if moved.is_err() {
            return;
        }
        control.publish(&down, &up);
        let now = clock.now();
        let next = [down.next(), up.next()].into_iter().flatten().min();
        let sleep = next
            .map_or(LONGEST_SLEEP, |next| next.saturating_sub(now))
            .clamp(SHORTEST_SLEEP, LONGEST_SLEEP);
        wait(&[(host, down.room()), (board, up.room())], sleep);
    }
}

fn carry(
    direction: &mut WireDirection,
    from: &NonBlockingFd,
    to: &NonBlockingFd,
    now: u64,
    control: &WireControl,
) -> Result<(), Disconnected> {
    let mut bytes = [0; CHUNK];
    let room = direction.room().min(CHUNK);
    if 0 < room {
        let n = from.read(&mut bytes[..room])?;
        let cut = control.cut.load(Ordering::Relaxed);
        if cut { direction.lose(n) } else { direction.take(now, &bytes[..n]) }
    }
    let arrived = direction.arrived(now, &mut bytes);
    let handed = if arrived == 0 { 0 } else { to.write(&bytes[..arrived])? };
    direction.hand_on(handed);
    Ok(())
}

/// Sleeps until one of the streams with room has bytes, or for `nanos`.
fn wait(streams: &[(&NonBlockingFd, usize); 2], nanos: u64) {
    let interest = |room| if 0 < room { PollFlags::IN } else { PollFlags::empty() };
    let mut streams = streams.map(|(stream, room)| PollFd::new(stream, interest(room)));
    let timeout = Timespec { tv_sec: 0, tv_nsec: nanos.cast_signed() };
    // Whatever ended the sleep, the next turn handles it.
    let _why = poll(&mut streams, Some(&timeout));
}

impl WireControl {
    fn publish(&self, down: &WireDirection, up: &WireDirection) {
        let (down, up) = (down.counts(), up.counts());
        let set = |count: &AtomicU64, value| count.store(value, Ordering::Relaxed);
        set(&self.passed, down.passed + up.passed);
        set(&self.lost, down.lost + up.lost);
        set(&self.flipped, down.flipped + up.flipped);
        set(&self.stalls, down.stalls + up.stalls);
    }
}

struct WireClock(Instant);

#[expect(
    clippy::disallowed_methods,
    reason = "the wire is no part of the tick: it is what takes time"
)]
impl WireClock {
    fn start() -> Self {
        Self(Instant::now())
    }

    /// Returns the time since the start (ns).
    fn now(&self) -> u64 {
        u64::try_from(self.0.elapsed().as_nanos()).unwrap_or(u64::MAX)
    }
}
