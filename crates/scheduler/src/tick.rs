//! The tick, top to bottom.

use crate::lane::LaneReport;
use crate::motion::{KEYS, KeySample, KeySlope};
use crate::observation::VoiceObservation;
use crate::overload::{OverloadController, OverloadRules, Simplifications};
use crate::port::{FinishedTick, KeyBus, Lanes, TickInput, TickObserver, TickOutput, TickRules};
use crate::safety::{SAFE_FORCE, Safety, SafetyReport};
use crate::time::{Nanos, Timetable};
use crate::voice::VoiceOutput;

/// Outcome of one tick, in numbers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TickReport {
    pub tick: u64,
    pub due: Nanos,
    pub deadline: Nanos,
    /// Ticks before this one that were never run.
    pub skipped: u64,
    pub voices: LaneReport,
    pub safety: SafetyReport,
}

/// Runs all keys, one tick at a time.
///
/// A scheduler owns all memory of a tick: [`SCHEDULER_KB`] where pointers have 64 bits.
#[derive(Debug)]
pub struct Scheduler {
    timetable: Timetable,
    next: u64,
    samples: [KeySample; KEYS],
    turns: [VoiceOutput; KEYS],
    observed: [VoiceObservation; KEYS],
    forces: [f64; KEYS],
    slopes: [KeySlope; KEYS],
    safety: Safety,
    overload: OverloadController,
}

/// Memory of a [`Scheduler`] (kB, rounded up): for each key its sample (24 bytes), turn (432),
/// observation (216), force, slope and safety state (40).
pub const SCHEDULER_KB: usize = 87;

#[cfg(target_pointer_width = "64")]
const _: () = {
    assert!(size_of::<Scheduler>().div_ceil(1000) == SCHEDULER_KB, "correct SCHEDULER_KB");
};

impl Scheduler {
    /// Returns a scheduler that begins at the timetable's start, with `slew` (N/s) towards a voice.
    #[expect(
        clippy::large_stack_frames,
        clippy::large_stack_arrays,
        reason = "once, at set-up; without a heap the memory comes from the caller"
    )]
    pub fn new(timetable: Timetable, slew: f64) -> Self {
        Self {
            timetable,
            next: 0,
            samples: [KeySample::default(); KEYS],
            turns: [VoiceOutput { idle: true, ..VoiceOutput::default() }; KEYS],
            observed: [VoiceObservation::default(); KEYS],
            forces: [SAFE_FORCE; KEYS],
            slopes: [KeySlope::HELD; KEYS],
            safety: Safety::new(timetable.period(), slew),
            overload: OverloadController::new(OverloadRules::OFF, timetable.period()),
        }
    }

    pub fn set_overload(&mut self, rules: OverloadRules) {
        self.overload = OverloadController::new(rules, self.timetable.period());
    }

    /// Leaves out `simplified` from the next tick on, whatever the load, as a recorded run did.
    pub const fn simplify(&mut self, simplified: Simplifications) {
        self.overload.set(simplified);
    }

    pub fn note_work(&mut self, work: Nanos) {
        self.overload.note_load(work.as_secs_f64() / self.timetable.period().as_secs_f64());
    }

    /// Runs the newest tick that is due at `now`, if it has not been run yet.
    ///
    /// Reads no clock, sleeps, allocates and locks nothing; bounded by what the ports promise. A
    /// tick whose successor is due as well is skipped, never run to catch up: no voice sees its
    /// number, due times do not move, and every key treats the gap as an outage.
    pub fn poll(
        &mut self,
        now: Nanos,
        bus: &mut impl KeyBus,
        lanes: &mut impl Lanes,
        observer: &mut impl TickObserver,
    ) -> Option<TickReport> {
        let tick = self.timetable.newest(now).filter(|&newest| self.next <= newest)?;
        let skipped = tick - self.next;
        self.next = tick + 1;

        bus.receive(tick, &mut self.samples);
        let followed = observer.followed();
        let rules =
            TickRules { simplified: self.overload.decide(), hz: self.timetable.period().hz() };
        lanes.run(
            &TickInput { tick, samples: &self.samples, followed, rules },
            &mut TickOutput { turns: &mut self.turns, observed: &mut self.observed },
        );
        let safety = self.safety.apply(skipped, &self.samples, &self.turns, &mut self.forces);
        self.safety.slopes(&self.turns, &mut self.slopes);
        bus.send(tick, &self.forces, &self.slopes);
        observer.observe(&FinishedTick {
            tick,
            skipped,
            armed: self.safety.is_armed(),
            simplified: rules.simplified,
            samples: &self.samples,
            turns: &self.turns,
            forces: &self.forces,
            followed,
            observed: &self.observed,
        });

        let voices = LaneReport::of(&self.turns);
        self.overload.note_evaluations(voices.work.evaluations());
        if 0 < voices.late {
            // Late lanes mean full load.
            self.overload.note_load(1.0);
        }
        Some(TickReport {
            tick,
            due: self.timetable.due(tick),
            deadline: self.timetable.deadline(tick),
            skipped,
            voices,
            safety,
        })
    }

    /// Moves the timetable so that the next tick is due at `due`, without a gap.
    pub const fn resume_at(&mut self, due: Nanos) {
        self.timetable = self.timetable.moved(self.next, due);
    }

    pub const fn next_due(&self) -> Nanos {
        self.timetable.due(self.next)
    }

    /// Returns the deadline of the tick that [`Scheduler::poll`] would run at `now`.
    pub fn deadline(&self, now: Nanos) -> Nanos {
        let newest = self.timetable.newest(now).unwrap_or(0);
        self.timetable.deadline(newest.max(self.next))
    }

    pub const fn timetable(&self) -> Timetable {
        self.timetable
    }

    /// Lets the keys follow their voices again.
    pub const fn arm(&mut self) {
        self.safety.arm();
    }

    /// Lets all keys hold for one tick and then fade to the safe force, from the next tick on.
    pub const fn disarm(&mut self) {
        self.safety.disarm();
    }

    /// Returns the forces sent last (N).
    pub const fn forces(&self) -> &[f64; KEYS] {
        &self.forces
    }
}
