//! What ends each mode.

use pode::{Enclosure, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Motion};

use super::{Mode, ReducedGrand};

/// The head leaves the jack, which would have to pull it from there on.
pub(super) const LIFT_OFF: GuardId = GuardId(0);
/// The jack meets the let-off button.
pub(super) const BUTTON: GuardId = GuardId(1);
/// It comes back from it.
pub(super) const BUTTON_OFF: GuardId = GuardId(2);
/// Guard of the jack, which trips when it fires.
pub(super) const TRIP: GuardId = GuardId(3);
/// The head lands on the jack.
pub(super) const LAND: GuardId = GuardId(4);
/// The hammer meets the string.
pub(super) const STRING_ON: GuardId = GuardId(5);
/// It leaves the string.
pub(super) const STRING_OFF: GuardId = GuardId(6);
/// The head falls on the repetition lever.
pub(super) const REP_ON: GuardId = GuardId(7);
/// It leaves the lever.
pub(super) const REP_OFF: GuardId = GuardId(8);
/// The check catches the head.
pub(super) const CHECK: GuardId = GuardId(9);
/// The key comes up so far that the check does not reach the head.
pub(super) const CHECK_FAR: GuardId = GuardId(10);
/// It goes down so far that the check does.
pub(super) const CHECK_NEAR: GuardId = GuardId(11);
/// The check lets go.
pub(super) const CHECK_OFF: GuardId = GuardId(12);
/// The jack is free to slip back.
pub(super) const RESET: GuardId = GuardId(13);
/// It is back under the knuckle.
pub(super) const JACK_IN: GuardId = GuardId(14);
/// The key goes down again before it is.
pub(super) const JACK_OUT: GuardId = GuardId(15);

/// A guard on the key's place.
const fn of_key(id: GuardId, name: &'static str) -> GuardSpec {
    GuardSpec::new(id.0, name).scaled(0.01).of_state()
}

/// A guard on the head's place.
const fn of_head(id: GuardId, name: &'static str) -> GuardSpec {
    GuardSpec::new(id.0, name).scaled(0.05).of_state()
}

/// Of the size of what the finger's force would give to the head: mh R/mk of 100 N.
const LIFT_OFF_SPEC: GuardSpec = GuardSpec::new(LIFT_OFF.0, "lift-off").scaled(40.0);
const BUTTON_SPEC: GuardSpec = of_key(BUTTON, "button");
const BUTTON_OFF_SPEC: GuardSpec = of_key(BUTTON_OFF, "button-off");
const TRIP_SPEC: GuardSpec = of_key(TRIP, "trip");
const LAND_SPEC: GuardSpec = of_head(LAND, "land");
const STRING_ON_SPEC: GuardSpec = of_head(STRING_ON, "string-on");
const STRING_OFF_SPEC: GuardSpec = of_head(STRING_OFF, "string-off");
const REP_ON_SPEC: GuardSpec = of_head(REP_ON, "rep-on");
const REP_OFF_SPEC: GuardSpec = of_head(REP_OFF, "rep-off");
/// Not a condition of the mode: it may be entered with the head below the check.
const CHECK_SPEC: GuardSpec = of_head(CHECK, "check").on_crossing();
const RESET_SPEC: GuardSpec = of_key(RESET, "reset");

const ACC: [GuardSpec; 2] = [LIFT_OFF_SPEC, BUTTON_SPEC];
const LO: [GuardSpec; 3] = [LIFT_OFF_SPEC, BUTTON_OFF_SPEC, TRIP_SPEC];
const FLA: [GuardSpec; 3] = [LAND_SPEC, BUTTON_SPEC, STRING_ON_SPEC];
const FLL: [GuardSpec; 4] = [LAND_SPEC, BUTTON_OFF_SPEC, TRIP_SPEC, STRING_ON_SPEC];
const FLT: [GuardSpec; 3] = [STRING_ON_SPEC, REP_ON_SPEC, RESET_SPEC];
const STU: [GuardSpec; 2] = [STRING_OFF_SPEC, TRIP_SPEC];
const STT: [GuardSpec; 2] = [STRING_OFF_SPEC, RESET_SPEC];
const REPH: [GuardSpec; 3] = [REP_OFF_SPEC, CHECK_SPEC, of_key(CHECK_FAR, "check-far")];
const REPL: [GuardSpec; 3] = [REP_OFF_SPEC, of_key(CHECK_NEAR, "check-near"), RESET_SPEC];
const REP0: [GuardSpec; 3] =
    [REP_OFF_SPEC, of_head(JACK_IN, "jack-in"), of_key(JACK_OUT, "jack-out")];
const CHK: [GuardSpec; 1] = [of_key(CHECK_OFF, "check-off")];

impl ReducedGrand {
    /// Height of the head over the jack in the flying mode `mode`, and its rate.
    fn over_jack(&self, mode: Mode, x: &[f64; 4]) -> GuardValue {
        let [y, z, u, w] = *x;
        let p = &self.values;
        let (height, ratio) =
            if mode == Mode::Fll { self.let_off.head(p, y) } else { (p.ratio * y, p.ratio) };
        GuardValue::new(z - height, w - ratio * u)
    }

    /// Height of the head over the repetition lever, and its rate.
    fn over_lever(&self, x: &[f64; 4]) -> GuardValue {
        let lever = self.lever(x[0]);
        GuardValue::new(x[1] - lever.height, x[3] - lever.ratio * x[2])
    }

    /// Height of the head over the place where the check holds it, and its rate.
    fn over_check(&self, x: &[f64; 4]) -> GuardValue {
        let check = self.in_check(x[0]);
        GuardValue::new(x[1] - check.height, x[3] - check.ratio * x[2])
    }
}

/// The same guard the other way round.
const fn turned(guard: GuardValue) -> GuardValue {
    GuardValue::new(-guard.value, -guard.rate)
}

impl Guarded for ReducedGrand {
    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        match mode {
            Mode::Acc => &ACC,
            Mode::Lo => &LO,
            Mode::Fla => &FLA,
            Mode::Fll => &FLL,
            Mode::Flt => &FLT,
            Mode::Stu => &STU,
            Mode::Stt => &STT,
            Mode::RepH => &REPH,
            Mode::RepL => &REPL,
            Mode::Rep0 => &REP0,
            Mode::Chk => &CHK,
        }
    }

    #[inline]
    fn guard_bound(
        &self,
        mode: Mode,
        guard: GuardId,
        over: &Enclosure<[f64; 4], Motion>,
    ) -> GuardBound {
        self.bound_of(mode, guard, over)
    }

    #[inline]
    fn guard(&self, mode: Mode, guard: GuardId, x: &[f64; 4], s: &Motion) -> GuardValue {
        let p = &self.values;
        let [y, z, u, w] = *x;
        let below = |place: f64| GuardValue::new(place - y, -u);
        let beyond = |place: f64| GuardValue::new(y - place, u);
        match guard {
            LIFT_OFF => self.lift_off(mode, x, s),
            BUTTON => below(p.button),
            BUTTON_OFF => beyond(p.button),
            TRIP => below(self.let_off.trip),
            LAND => self.over_jack(mode, x),
            STRING_ON => GuardValue::new(p.string - z, -w),
            STRING_OFF => GuardValue::new(z - p.string, w),
            REP_ON => self.over_lever(x),
            REP_OFF => turned(self.over_lever(x)),
            CHECK => self.over_check(x),
            CHECK_FAR => beyond(p.check_from),
            CHECK_NEAR => below(p.check_from),
            CHECK_OFF => beyond(p.check_off),
            RESET => beyond(p.reset),
            JACK_IN => GuardValue::new(p.ratio * y - z, p.ratio * u - w),
            _ => below(p.reset),
        }
    }
}
