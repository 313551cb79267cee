//! Slots: the place of one key's voice in a lane.

use crate::motion::{KEYS, KeyEvent, KeySample, Moment};
use crate::observation::{FollowedKeys, VoiceObservation};
use crate::overload::Simplifications;
use crate::port::TickRules;
use crate::values::ModelValues;
use crate::voice::{TurnRules, Voice, VoiceFault, VoiceOutput};
use crate::work::{TurnLimit, VoiceKind};

const OCTAVE: usize = 12;

/// Returns the lane that runs `key` when there are `n_lanes`.
///
/// Neighbours and octaves are on different lanes, so that a chord does not load one lane.
///
/// # Panics
/// If there are no lanes.
pub const fn lane_of(key: usize, n_lanes: usize) -> usize {
    (key + key / OCTAVE) % n_lanes
}

/// Failed turns of the last second that a voice may have; one more mutes it. A voice that fails
/// every 16 ms is muted after 48 ms; one that fails once a second is never muted.
const MAX_FAULTS: u32 = 3;

/// Failed turns of a voice.
///
/// Each counts, whatever lies between: alternating fault and recovery are felt as a buzz.
#[derive(Clone, Copy, Debug, Default)]
struct Lockout {
    /// Ticks until all failed turns are forgotten; each counts for a second.
    level: u32,
    muted: bool,
}

impl Lockout {
    /// Counts a turn that came `passed` ticks of 1/`hz` (s) after the previous one.
    ///
    /// A failing sensor does not count as a fault of the voice, which returns with the sensor.
    fn note(&mut self, fault: Option<VoiceFault>, passed: u32, hz: u32) {
        self.level = self.level.saturating_sub(passed);
        match fault {
            None | Some(VoiceFault::BadSample | VoiceFault::Panicked) => {}
            Some(VoiceFault::MakesEnergy | VoiceFault::Muted) => self.muted = true,
            Some(VoiceFault::NotFinite | VoiceFault::Capped { .. } | VoiceFault::Diverged) => {
                self.level = self.level.saturating_add(hz);
                self.muted |= MAX_FAULTS * hz < self.level;
            }
        }
    }

    const fn is_suspicious(self) -> bool {
        0 < self.level
    }
}

/// Returns the limit to send to a voice that may take `wanted`, if `told` is too high, or a quarter
/// too low: not every drift is worth a call.
fn new_limit(wanted: TurnLimit, told: Option<TurnLimit>) -> Option<TurnLimit> {
    let is_near = |told: u32, wanted: u32| (wanted - wanted / 4..=wanted).contains(&told);
    let is_known = told
        .is_some_and(|told| is_near(told.early, wanted.early) && is_near(told.most, wanted.most));
    let less = |units: u32| units - units / 8;
    (!is_known).then(|| TurnLimit { early: less(wanted.early), most: less(wanted.most) })
}

/// One key's voice, in the order in which its lane runs it.
#[derive(Clone, Debug)]
pub struct Slot<V> {
    key: usize,
    voice: V,
    /// `true` if the voice must be reset before its next tick.
    fresh: bool,
    retuned: bool,
    lockout: Lockout,
    /// `true` if the damper is off the string, as far as was reported.
    lifted: bool,
    /// Ticks in which the voice was run, one bit each: `last` is bit 0, the tick before it bit 1.
    ran: u32,
    last: u64,
    /// Value of `ran` for observers after the last turn, even if that turn waited.
    told_ran: u32,
    rules: TickRules,
    limit: SlotLimit,
    told: Option<TurnRules>,
    kind: Option<VoiceKind>,
    last_turn: LastTurn,
}

#[derive(Clone, Copy, Debug, Default)]
struct LastTurn {
    /// Force (N), held while the voice waits.
    force: f64,
    idle: bool,
    units: u32,
}

#[derive(Clone, Copy, Debug)]
enum SlotLimit {
    /// Units that fit into the turn's fraction of the lane's time.
    Budget(u32),
    /// Limit at which a recorded run cut the turn off, if it did.
    Recorded(TurnLimit),
}

/// Rules of a slot before the first tick sets them.
const NO_RULES: TickRules = TickRules { simplified: Simplifications::NONE, hz: 1000 };

impl<V> Slot<V> {
    /// Assigns `voice` to `key`, in `0 ..= 87`.
    ///
    /// # Panics
    /// If there is no such key.
    pub const fn new(key: usize, voice: V) -> Self {
        assert!(key < KEYS, "no such key");
        let lockout = Lockout { level: 0, muted: false };
        Self {
            key,
            voice,
            fresh: true,
            retuned: false,
            lockout,
            lifted: false,
            ran: 0,
            last: 0,
            told_ran: 0,
            rules: NO_RULES,
            limit: SlotLimit::Recorded(TurnLimit::NONE),
            told: None,
            kind: None,
            last_turn: LastTurn { force: 0.0, idle: false, units: 0 },
        }
    }

    pub const fn key(&self) -> usize {
        self.key
    }

    /// Returns the ticks before `tick` with runs, as in [`VoiceObservation::ran`] of a late turn.
    pub fn ran_before(&self, tick: u64) -> u32 {
        let passed = u32::try_from(tick.saturating_sub(self.last)).unwrap_or(u32::MAX);
        self.ran.checked_shl(passed).unwrap_or(0) | 1
    }

    pub const fn replace(&mut self, voice: V) -> V {
        self.fresh = true;
        self.lockout = Lockout { level: 0, muted: false };
        (self.told, self.kind) = (None, None);
        core::mem::replace(&mut self.voice, voice)
    }
}

impl<V: Voice> Slot<V> {
    /// Replaces the voice by one that continues with a fresh force, and returns the old one. The
    /// new one begins at rest if it cannot take over, or if the old one failed or has not begun.
    ///
    /// # Real-time
    /// As [`Voice::take_over`].
    pub fn succeed(&mut self, mut voice: V) -> V {
        let is_going = !(self.fresh || self.lockout.muted);
        self.retuned = is_going && voice.take_over(&self.voice);
        let old = self.replace(voice);
        self.fresh = !self.retuned;
        old
    }

    /// Changes the voice's values; returns `false` if the voice is of another model or panicked.
    ///
    /// A retuned voice continues from its state with a fresh force; a muted one restarts at rest.
    ///
    /// # Real-time
    /// As [`Voice::retune`].
    pub fn retune(&mut self, values: &ModelValues) -> bool {
        let is_retuned = self.voice.retune(values);
        if is_retuned {
            self.retuned = true;
            self.fresh |= self.lockout.muted;
            self.lockout = Lockout::default();
        }
        is_retuned
    }

    #[inline]
    pub fn kind(&mut self) -> VoiceKind {
        *self.kind.get_or_insert_with(|| self.voice.internals().kind)
    }

    /// Returns the expected work of the next turn: the units of the last one.
    #[inline]
    pub(crate) const fn expected_units(&self) -> u32 {
        self.last_turn.units
    }

    /// Sets the rules of the next turns, and the `units` of work that the lane allows in each.
    pub fn allow(&mut self, rules: TickRules, units: u32) {
        (self.rules, self.limit) = (rules, SlotLimit::Budget(units));
    }

    /// Like [`Self::allow`], but with the limit of a recorded turn, if it was cut off there.
    pub fn allow_recorded(&mut self, rules: TickRules, limit: Option<u32>) {
        let limit = limit.map_or(TurnLimit::NONE, TurnLimit::of);
        (self.rules, self.limit) = (rules, SlotLimit::Recorded(limit));
    }

    fn tell(&mut self) {
        let told = self.told.map(|told| told.limit);
        let limit = match self.limit {
            SlotLimit::Budget(units) if self.lockout.is_suspicious() => {
                new_limit(TurnLimit::of_suspect(units), told)
            }
            SlotLimit::Budget(units) => {
                new_limit(TurnLimit::of_trusted(units, self.rules.hz), told)
            }
            SlotLimit::Recorded(limit) => Some(limit).filter(|_| told != Some(limit)),
        };
        let is_simplified = self.told.is_some_and(|told| told.simplified != self.rules.simplified);
        if is_simplified || limit.is_some() {
            // A voice that was told nothing yet has a new limit.
            let limit = limit.or(told).unwrap_or(TurnLimit::NONE);
            let rules = TurnRules { simplified: self.rules.simplified, limit };
            self.told = Some(rules);
            self.voice.restrict(rules);
        }
    }

    /// Runs the voice for `tick`; a force that is not finite becomes a fault.
    ///
    /// A voice that failed is reset at the next sample with a fresh force; one that generated
    /// energy or fails repeatedly is muted. A key without samples for half a second has no turns
    /// and resumes as after a fault. The damper of a key that failed or has no samples falls.
    pub fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        let passed = u32::try_from(tick.saturating_sub(self.last)).unwrap_or(u32::MAX);
        self.told_ran = self.ran_before(tick);
        self.tell();
        turn.begin();
        let is_lost = self.rules.hz / 2 < sample.age;
        if is_lost {
            turn.idle = true;
        } else if self.lockout.muted {
            turn.fault = Some(VoiceFault::Muted);
        } else if sample.position.is_finite() {
            if self.fresh {
                self.voice.reset(sample);
            }
            self.voice.tick(tick, sample, turn);
        } else {
            turn.fault = Some(VoiceFault::BadSample);
        }
        if turn.fault.is_none() && !turn.force.is_finite() {
            turn.fault = Some(VoiceFault::NotFinite);
        }
        turn.fresh = self.fresh || self.retuned;
        self.retuned = false;
        let is_gone = is_lost || turn.fault.is_some();
        if self.fresh || is_gone {
            self.begin_damper(tick, turn);
        } else {
            self.follow_damper(turn);
        }
        self.fresh = is_gone;
        let units = turn.work.units;
        self.last_turn = LastTurn { force: turn.force, idle: turn.idle, units };
        self.lockout.note(turn.fault, passed, self.rules.hz);
        // All earlier ticks are known, so bit 0 states that this one was run.
        (self.ran, self.last) = (self.told_ran, tick);
    }

    /// Holds the voice's force in `tick`, like that of a late lane.
    pub fn wait(&mut self, tick: u64, turn: &mut VoiceOutput) {
        self.told_ran = self.ran_before(tick);
        turn.wait(self.last_turn.force);
        turn.idle = self.last_turn.idle;
    }

    fn follow_damper(&mut self, turn: &VoiceOutput) {
        for (_at, event) in turn.events.as_slice() {
            match event {
                KeyEvent::DamperLift => self.lifted = true,
                KeyEvent::DamperFall { .. } => self.lifted = false,
                KeyEvent::Strike { .. } | KeyEvent::Pressure { .. } => {}
            }
        }
    }

    /// Updates the damper of a voice that restarts or rests: it falls unless `turn` has it lifted.
    fn begin_damper(&mut self, tick: u64, turn: &mut VoiceOutput) {
        let was_lifted = core::mem::take(&mut self.lifted);
        self.follow_damper(turn);
        if was_lifted && !self.lifted {
            turn.events.push(Moment { tick, theta: 0.0 }, KeyEvent::DamperFall { speed: 0.0 });
        }
    }

    /// Writes the observation of a voice that was put in or changed, before it is run.
    pub fn show(&self, seen: &mut VoiceObservation) {
        self.voice.observe(seen);
        seen.switches.clear();
    }

    /// Writes the observation of the voice after `turn`, its last one, if its key is followed.
    #[inline]
    pub fn observe(&self, followed: FollowedKeys, turn: &VoiceOutput, seen: &mut VoiceObservation) {
        seen.pass(self.told_ran);
        if turn.is_seen(self.key, followed) {
            self.voice.observe(seen);
            if !turn.was_run() {
                // The voice still holds the changes of an earlier tick.
                seen.switches.clear();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observation::Switch;
    use crate::voice::VoiceInternals;

    #[test]
    fn neighbours_and_octaves_are_on_different_lanes() {
        for n_lanes in 2..=8 {
            for key in 0..KEYS - OCTAVE {
                let lane = lane_of(key, n_lanes);
                assert_ne!(lane, lane_of(key + OCTAVE, n_lanes), "octave above key {key}");
                let neighbour = lane_of(key + 1, n_lanes);
                let octave_begins = (key + 1) % OCTAVE == 0;
                assert!(lane != neighbour || octave_begins && n_lanes == 2, "key {key}");
            }
        }
    }

    #[test]
    fn lanes_share_the_keys_evenly() {
        for n_lanes in 1..=8 {
            let keys_on = |lane| (0..KEYS).filter(|&key| lane_of(key, n_lanes) == lane).count();
            let most = (0..n_lanes).map(keys_on).max().unwrap();
            let fewest = (0..n_lanes).map(keys_on).min().unwrap();
            assert!(most - fewest <= 2, "{n_lanes} lanes: {fewest} to {most} keys");
        }
    }

    /// Has the force that it was last reset to, or NaN once it must fail.
    #[derive(Default)]
    struct Spy {
        rest: f64,
        resets: u32,
        fails_at: u64,
    }

    impl Voice for Spy {
        fn tick(&mut self, tick: u64, _sample: &KeySample, turn: &mut VoiceOutput) {
            turn.force = if tick == self.fails_at { f64::NAN } else { self.rest };
        }

        fn observe(&self, seen: &mut VoiceObservation) {
            seen.snapshot.show(&[self.rest]);
            seen.switches.push(Switch::default());
        }

        fn reset(&mut self, sample: &KeySample) {
            self.rest = sample.position;
            self.resets += 1;
        }
    }

    fn turn_of(slot: &mut Slot<Spy>, tick: u64, position: f64) -> VoiceOutput {
        let mut turn = VoiceOutput::default();
        slot.tick(tick, &at(position), &mut turn);
        turn
    }

    fn at(position: f64) -> KeySample {
        KeySample::fresh(position)
    }

    #[test]
    fn an_observation_says_in_which_of_the_last_ticks_its_voice_was_run() {
        let mut slot = Slot::new(3, Spy { fails_at: 99, ..Spy::default() });
        let (mut turn, mut seen) = (VoiceOutput::default(), VoiceObservation::default());
        for (tick, ran) in [(7, 0b1), (8, 0b11), (11, 0b11001), (12, 0b11_0011), (60, 0b1)] {
            slot.tick(tick, &at(0.0), &mut turn);
            slot.observe(FollowedKeys::ALL, &turn, &mut seen);
            assert_eq!(seen.ran, ran, "tick {tick}");
        }
    }

    #[test]
    fn a_voice_that_was_not_called_is_seen_as_it_was_and_nothing_happened_to_it() {
        let mut slot = Slot::new(3, Spy { fails_at: 99, ..Spy::default() });
        let (mut turn, mut seen) = (VoiceOutput::default(), VoiceObservation::default());
        for (tick, position, switches) in [(0, 0.004, 1), (1, f64::NAN, 0), (2, 0.004, 1)] {
            slot.tick(tick, &at(position), &mut turn);
            slot.observe(FollowedKeys::ALL, &turn, &mut seen);
            assert_eq!(seen.switches.as_slice().len(), switches, "tick {tick}");
            assert!((seen.snapshot.state[0] - 0.004).abs() == 0.0, "tick {tick}");
        }
        slot.tick(3, &at(f64::NAN), &mut turn);
        let (mut new, first) = (VoiceObservation::default(), FollowedKeys::new(1 << 3, 1 << 3));
        slot.observe(first, &turn, &mut new);
        assert!((new.snapshot.state[0] - 0.004).abs() == 0.0, "what is new is shown");
        assert_eq!(new.switches.as_slice(), []);
    }

    struct Failing {
        fails: fn(u64) -> bool,
        calls: u64,
    }

    impl Voice for Failing {
        fn tick(&mut self, tick: u64, _sample: &KeySample, turn: &mut VoiceOutput) {
            self.calls += 1;
            turn.force = if (self.fails)(tick) { f64::NAN } else { 1.0 };
        }

        fn reset(&mut self, _sample: &KeySample) {}
    }

    /// Counts the calls, in `ticks`, of a voice that fails in the ticks of `fails`.
    fn calls(ticks: u64, fails: fn(u64) -> bool) -> u64 {
        calls_at(1000, ticks, fails)
    }

    fn calls_at(hz: u32, ticks: u64, fails: fn(u64) -> bool) -> u64 {
        let mut slot = Slot::new(3, Failing { fails, calls: 0 });
        let mut turn = VoiceOutput::default();
        for tick in 0..ticks {
            let before = slot.voice.calls;
            slot.allow(TickRules { hz, ..NO_RULES }, 1000);
            slot.tick(tick, &at(0.0), &mut turn);
            let was_called = before < slot.voice.calls;
            assert_eq!(!was_called, turn.fault == Some(VoiceFault::Muted), "tick {tick}");
        }
        slot.voice.calls
    }

    /// Has its damper off the string where its key is down; its force is its key's position.
    #[derive(Default)]
    struct Damped {
        lifted: bool,
        resets: u32,
    }

    impl Voice for Damped {
        fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
            turn.force = sample.position;
            let is_down = 0.0 < sample.position;
            let event =
                if is_down { KeyEvent::DamperLift } else { KeyEvent::DamperFall { speed: 1.0 } };
            if is_down != core::mem::replace(&mut self.lifted, is_down) {
                turn.events.push(Moment { tick, theta: 0.5 }, event);
            }
        }

        fn reset(&mut self, _sample: &KeySample) {
            (self.lifted, self.resets) = (false, self.resets + 1);
        }
    }

    /// Asserts the damper's moves while a key has `samples`: u for up, d for down, a point for no
    /// report; returns how often its voice was reset.
    fn resets_of(samples: impl IntoIterator<Item = (KeySample, char)>) -> u32 {
        let (mut slot, mut turn) = (Slot::new(3, Damped::default()), VoiceOutput::default());
        for (tick, (sample, expected)) in (0..).zip(samples) {
            slot.tick(tick, &sample, &mut turn);
            let said = match turn.events.as_slice() {
                [] => '.',
                [(_at, KeyEvent::DamperLift)] => 'u',
                [(_at, KeyEvent::DamperFall { .. })] => 'd',
                events => panic!("{events:?}"),
            };
            assert_eq!(said, expected, "tick {tick}");
        }
        slot.voice.resets
    }

    #[test]
    fn the_damper_of_a_voice_that_fails_falls_and_is_up_again_if_the_key_is_still_down() {
        let held = [0.0, 0.004, 0.004, f64::NAN, f64::NAN, 0.004, 0.0].map(at);
        assert_eq!(resets_of(held.into_iter().zip(".u.d.ud".chars())), 2);
        // Released while no samples arrived.
        let released = [0.004, f64::NAN, 0.0, 0.0].map(at);
        assert_eq!(resets_of(released.into_iter().zip("ud..".chars())), 2);
    }

    #[test]
    fn the_damper_of_a_muted_voice_falls_and_so_does_that_of_one_that_takes_its_place() {
        let (mut slot, mut turn) = (Slot::new(3, Damped::default()), VoiceOutput::default());
        slot.tick(0, &at(0.004), &mut turn);
        slot.lockout.muted = true;
        slot.tick(1, &at(0.004), &mut turn);
        assert!(matches!(turn.events.as_slice(), [(_at, KeyEvent::DamperFall { .. })]), "{turn:?}");
        slot.replace(Damped::default());
        slot.tick(2, &at(0.004), &mut turn);
        assert!(matches!(turn.events.as_slice(), [(_at, KeyEvent::DamperLift)]), "{turn:?}");
        slot.replace(Damped::default());
        slot.tick(3, &at(0.0), &mut turn);
        assert!(matches!(turn.events.as_slice(), [(_at, KeyEvent::DamperFall { .. })]), "{turn:?}");
    }

    #[test]
    fn a_key_that_is_not_heard_for_long_has_no_turns_and_its_note_ends() {
        let silent = |age| KeySample { age, ..at(0.004) };
        let bridged = (1..=500).map(|age| (silent(age), '.'));
        let lost = [(silent(501), 'd'), (silent(502), '.')];
        let back = [(silent(0), 'u'), (silent(1), '.')];
        let all = [(silent(0), 'u')].into_iter().chain(bridged).chain(lost).chain(back);
        assert_eq!(resets_of(all), 2);
    }

    #[test]
    fn a_voice_that_flips_between_fault_and_recovery_is_muted() {
        // A fault, 20 ms of fading, 20 ms of return: 250 of them in 10 s.
        let called = calls(10_000, |tick| tick % 40 == 0);
        assert!((120..=400).contains(&called), "called {called} times");
    }

    #[test]
    fn a_voice_that_keeps_failing_is_muted_within_50_ms_in_any_pattern_at_any_rate() {
        let patterns: [fn(u64) -> bool; 5] = [
            |_tick| true,
            |tick| tick % 2 == 0,
            |tick| tick % 7 < 2,
            |tick| tick % 16 == 0,
            |tick| tick % 13 < 5,
        ];
        for fails in patterns {
            let calls = calls(1000, fails);
            assert!(calls <= 50, "called {calls} times");
        }
        assert_eq!(calls_at(500, 1000, |_tick| true), 4);
        assert_eq!(calls_at(10_000, 10_000, |tick| tick % 160 == 0), 481, "48 ms");
    }

    #[test]
    fn a_voice_that_fails_now_and_then_is_not_muted() {
        assert_eq!(calls(20_000, |tick| tick % 1000 == 0), 20_000);
        assert_eq!(calls(40_000, |tick| tick % 10_000 == 0), 40_000, "once in 10 s");
        assert_eq!(calls_at(10_000, 200_000, |tick| tick % 100_000 == 0), 200_000);
        assert_eq!(
            calls(20_000, |tick| (100..103).contains(&tick)),
            20_000,
            "three turns in a row"
        );
    }

    #[derive(Default)]
    struct Limited {
        told: Option<TurnLimit>,
        calls: u32,
    }

    impl Voice for Limited {
        fn tick(&mut self, _tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
            if sample.position < 0.0 {
                turn.fail(VoiceFault::Capped { handled: 0 });
            }
        }

        fn restrict(&mut self, rules: TurnRules) {
            (self.told, self.calls) = (Some(rules.limit), self.calls + 1);
        }

        fn reset(&mut self, _sample: &KeySample) {}
    }

    #[test]
    fn a_voice_is_told_its_limit_when_that_changed_by_much_and_never_a_higher_one() {
        let mut slot = Slot::new(3, Limited::default());
        let mut turn = VoiceOutput::default();
        for units in [1000, 1001, 1100, 990, 890, 870, 860, 1200] {
            slot.allow(NO_RULES, units);
            slot.tick(0, &at(0.0), &mut turn);
            let told = slot.voice.told.unwrap().early;
            assert!(told <= units && units <= 2 * told, "{told} of {units}");
        }
        assert_eq!((slot.voice.told, slot.voice.calls), (Some(TurnLimit::of(1050)), 3));
    }

    #[test]
    fn a_voice_may_take_what_a_strike_takes_until_it_fails() {
        let mut slot = Slot::new(3, Limited::default());
        let mut turn = VoiceOutput::default();
        let mut told = |position| {
            slot.allow(NO_RULES, 8);
            slot.tick(0, &at(position), &mut turn);
            slot.voice.told
        };
        let trusted = Some(TurnLimit { early: 56, most: 448 });
        assert_eq!([told(0.0), told(-1.0)], [trusted; 2]);
        assert_eq!(told(0.0), Some(TurnLimit::of(56)), "an ordinary turn's work");
    }

    #[test]
    fn a_muted_voice_is_called_again_when_it_is_changed_or_replaced() {
        let mut slot = Slot::new(3, Tunable { value: 1.0, ticks: 0 });
        slot.lockout.muted = true;
        let mut turn = VoiceOutput::default();
        slot.tick(0, &at(0.0), &mut turn);
        assert_eq!((turn.fault, slot.voice.ticks), (Some(VoiceFault::Muted), 0));
        assert!(slot.retune(&values(TUNABLE, 2.0)));
        slot.tick(1, &at(0.0), &mut turn);
        assert_eq!((turn.fault, turn.fresh, slot.voice.ticks), (None, true, 1));
        slot.lockout.muted = true;
        slot.replace(Tunable { value: 3.0, ticks: 70 });
        slot.tick(2, &at(0.0), &mut turn);
        assert_eq!((turn.fault, turn.fresh, slot.voice.ticks), (None, true, 1));
    }

    #[test]
    fn a_sensor_that_fails_again_and_again_mutes_nobody() {
        let mut slot = Slot::new(3, Spy { fails_at: u64::MAX, ..Spy::default() });
        for tick in 0..2000 {
            turn_of(&mut slot, tick, if tick % 2 == 0 { f64::NAN } else { 0.0 });
        }
        assert_eq!(turn_of(&mut slot, 2001, 0.0).fault, None);
    }

    struct Tunable {
        value: f64,
        ticks: u32,
    }

    impl Voice for Tunable {
        fn tick(&mut self, _tick: u64, _sample: &KeySample, turn: &mut VoiceOutput) {
            self.ticks += 1;
            turn.force = self.value;
        }

        fn reset(&mut self, _sample: &KeySample) {
            self.ticks = 0;
        }

        fn take_over(&mut self, before: &dyn Voice) -> bool {
            let ticks = before.internals().memory.and_then(|it| it.downcast_ref::<u32>());
            self.ticks = ticks.copied().unwrap_or(0);
            ticks.is_some()
        }

        fn internals(&self) -> VoiceInternals<'_> {
            VoiceInternals { memory: Some(&self.ticks), ..VoiceInternals::default() }
        }

        fn retune(&mut self, values: &ModelValues) -> bool {
            let is_mine = values.model() == TUNABLE;
            if is_mine {
                self.value = values.as_slice()[0];
            }
            is_mine
        }
    }

    const TUNABLE: u64 = 7;

    fn values(model: u64, value: f64) -> ModelValues {
        ModelValues::new(model, 1, &[value]).unwrap()
    }

    #[test]
    fn a_voice_that_is_retuned_goes_on_in_its_state_with_a_fresh_force() {
        let mut slot = Slot::new(3, Tunable { value: 1.0, ticks: 0 });
        let mut turn = VoiceOutput::default();
        for tick in 0..3 {
            slot.tick(tick, &at(0.0), &mut turn);
        }
        assert!(!turn.fresh);
        assert!(slot.retune(&values(TUNABLE, 2.0)));
        slot.tick(3, &at(0.0), &mut turn);
        assert!((turn.force - 2.0).abs() < f64::EPSILON && turn.fresh);
        assert_eq!(slot.voice.ticks, 4, "it was not put at rest");
        slot.tick(4, &at(0.0), &mut turn);
        assert!(!turn.fresh);
    }

    #[test]
    fn a_voice_that_succeeds_another_goes_on_where_it_is_unless_that_has_not_begun_or_failed() {
        let mut slot = Slot::new(3, Tunable { value: 1.0, ticks: 0 });
        let mut turn = VoiceOutput::default();
        let next = || Tunable { value: 2.0, ticks: 70 };
        slot.succeed(next());
        slot.tick(0, &at(0.0), &mut turn);
        assert_eq!((slot.voice.ticks, turn.fresh), (1, true), "at rest");
        slot.tick(1, &at(0.0), &mut turn);
        let old = slot.succeed(next());
        slot.tick(2, &at(0.0), &mut turn);
        assert_eq!((old.ticks, slot.voice.ticks, turn.fresh), (2, 3, true));
        slot.tick(3, &at(0.0), &mut turn);
        assert!(!turn.fresh);
        slot.lockout.muted = true;
        slot.succeed(next());
        slot.tick(4, &at(0.0), &mut turn);
        assert_eq!((turn.fault, slot.voice.ticks), (None, 1), "at rest");
    }

    #[test]
    fn a_voice_that_waits_is_as_it_was() {
        let mut slot = Slot::new(3, Spy { fails_at: 9, ..Spy::default() });
        turn_of(&mut slot, 0, 0.004);
        slot.tick(1, &KeySample { age: 501, ..at(0.004) }, &mut VoiceOutput::default());
        let mut turn = VoiceOutput { force: 7.0, ..VoiceOutput::default() };
        slot.wait(2, &mut turn);
        let expected = VoiceOutput { idle: true, late: true, waited: true, ..turn };
        assert_eq!(turn, expected);
        assert!(turn.force.abs() == 0.0, "not that of another key's turn: {turn:?}");
    }

    #[test]
    fn a_voice_never_sees_a_sample_that_is_not_finite() {
        let mut slot = Slot::new(3, Spy { fails_at: 9, ..Spy::default() });
        assert_eq!(turn_of(&mut slot, 0, f64::NAN).fault, Some(VoiceFault::BadSample));
        assert_eq!(slot.voice.resets, 0);
    }
}
