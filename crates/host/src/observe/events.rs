use midi::{Pedal, PedalMove};
use scheduler::motion::{KeyEvent, Moment};
use scheduler::{observation::Switch, overload::Simplification, voice::VoiceFault};
use telemetry::{Event, event::Kind};

use super::ModelProbe;
use super::pulses::{PulseRow, words};
use crate::adapters::tick_recorder::{KeyRow, TickRow};

/// Key number of events without a key.
pub const NO_KEY: u32 = 255;

fn at(kind: Kind, key: u8, Moment { tick, theta }: Moment) -> Event {
    Event { kind: kind.into(), tick, theta, key: key.into(), ..Event::default() }
}

pub(super) fn switch(tick: u64, key: u8, it: &Switch, probe: Option<&dyn ModelProbe>) -> Event {
    let guard = probe.and_then(|probe| probe.guard(it.from, it.guard)).unwrap_or_default();
    Event {
        from: it.from.into(),
        to: it.to.into(),
        guard: guard.to_owned(),
        ..at(Kind::Switch, key, Moment { tick, theta: it.theta })
    }
}

pub(super) fn note(key: u8, moment: Moment, event: KeyEvent) -> Event {
    match event {
        KeyEvent::Strike { speed, .. } => Event { speed, ..at(Kind::Strike, key, moment) },
        KeyEvent::Pressure { value, .. } => {
            Event { speed: f64::from(value) / 127.0, ..at(Kind::Pressure, key, moment) }
        }
        KeyEvent::DamperLift => at(Kind::DamperLift, key, moment),
        KeyEvent::DamperFall { speed } => Event { speed, ..at(Kind::DamperFall, key, moment) },
    }
}

/// Returns the change of trust in a key's voice since the fault `known`, which is updated.
///
/// A late turn reports nothing: a voice that fails in each turn for which it does not have to wait
/// fails all the time.
pub(super) fn trust(row: &KeyRow, known: &mut Option<VoiceFault>) -> Option<Event> {
    if row.stands.late {
        return None;
    }
    let before = std::mem::replace(known, row.fault);
    let start = Moment { tick: row.tick, theta: 0.0 };
    match (before, row.fault) {
        (_, Some(now)) if before.map(kind) != Some(kind(now)) => {
            let text = explained(now);
            Some(Event { text, ..at(Kind::Fault, row.key, start) })
        }
        (Some(_), None) => Some(at(Kind::Recovery, row.key, start)),
        (_, Some(_)) | (None, None) => None,
    }
}

/// Groups faults: those of one kind count as one.
const fn kind(fault: VoiceFault) -> u8 {
    super::block::fault_number(Some(fault))
}

fn explained(fault: VoiceFault) -> String {
    match fault {
        VoiceFault::NotFinite => {
            "its model's numbers grew beyond all bounds; take a stiffer method or a faster tick"
                .into()
        }
        VoiceFault::BadSample => {
            "its sensor said what is no number; look at the board and its calibration".into()
        }
        VoiceFault::Capped { handled } => format!(
            "its model needed more than a tick may take, after {handled} events; it chatters, \
             so give it more damping"
        ),
        VoiceFault::Diverged => "its model gained energy from nowhere; its force comes too late \
            for its stiffness, so take a faster tick or softer springs"
            .into(),
        VoiceFault::Panicked => {
            "its voice panicked, which is a bug: put in another instrument, and report it".into()
        }
        VoiceFault::MakesEnergy => "it gave back more energy than was put into it, so the key is \
            muted; take a faster tick, a slower estimator (jerk_density) or softer springs"
            .into(),
        VoiceFault::Muted => "it made energy or failed again and again, so the key is muted until \
            its values are changed or another instrument is put in"
            .into(),
    }
}

pub(super) fn miss(pulse: &PulseRow) -> Option<Event> {
    words(pulse.outcome).map(|text| of_none(Kind::Miss, pulse.tick, text.to_owned()))
}

pub(super) fn starved(tick: u64) -> Event {
    let text = "voices waited although the tick had time, which is an error of the host: report it";
    of_none(Kind::Starved, tick, text.to_owned())
}

/// Announces the move of a pedal; repeated every `pass` ticks, if any.
pub fn pedal(PedalMove { pedal, at, depth }: PedalMove, pass: Option<u64>) -> Event {
    let (controller, every) = (pedal.controller().number().into(), pass.unwrap_or_default());
    Event { at, speed: depth, controller, every, ..of_none(Kind::Pedal, 0, String::new()) }
}

/// Returns the move of a pedal in `event`, unless this host does not know the pedal.
///
/// Recordings without controller numbers contain the sustain pedal only.
pub fn pedal_move(event: &Event) -> Option<PedalMove> {
    let pedal = match event.controller {
        0 => Pedal::Sustain,
        number => Pedal::of_number(u8::try_from(number).ok()?)?,
    };
    Some(PedalMove { pedal, at: event.at, depth: event.speed })
}

pub(super) fn skip(tick: u64, skipped: u64) -> Event {
    of_none(Kind::Skip, tick, format!("{skipped} ticks before this one were not run"))
}

pub(super) fn board(tick: u64, text: String) -> Event {
    of_none(Kind::Board, tick, text)
}

pub(super) fn armed(row: &TickRow) -> Event {
    let (kind, text) =
        if row.armed { (Kind::Arm, "voices are felt") } else { (Kind::Disarm, "all forces fade") };
    of_none(kind, row.tick, text.to_owned())
}

pub(super) fn overload(row: &TickRow) -> Event {
    let names: Vec<_> = row.simplified.iter().map(Simplification::name).collect();
    let text = if names.is_empty() {
        "the load has fallen: nothing is left out any more".to_owned()
    } else {
        format!("a tick has more work than time: {} left out", names.join(", "))
    };
    let simplified = row.simplified.bits().into();
    Event { simplified, ..of_none(Kind::Overload, row.tick, text) }
}

fn of_none(kind: Kind, tick: u64, text: String) -> Event {
    Event { kind: kind.into(), tick, key: NO_KEY, text, ..Event::default() }
}

#[cfg(test)]
mod tests {
    use scheduler::{motion::KeySample, observation::ModelSnapshot};

    use super::*;
    use crate::adapters::tick_recorder::RowFlags;

    #[test]
    fn a_voice_that_has_to_wait_between_its_faults_fails_once() {
        let row = |tick, fault, late| KeyRow {
            tick,
            key: 3,
            sample: KeySample::fresh(0.0),
            force: 0.0,
            sent: 0.0,
            look: ModelSnapshot::default(),
            fault,
            stands: RowFlags { idle: false, late, waited: false, fresh: false, followed: false },
            ran: 1,
            events: 0,
            limit: 0,
            late_limit: 0,
        };
        let (capped, mut known) = (Some(VoiceFault::Capped { handled: 64 }), None);
        let turns = [(capped, false), (None, true), (capped, false), (None, true), (None, false)];
        let told = (0..).zip(turns).filter_map(|(tick, (fault, late))| {
            trust(&row(tick, fault, late), &mut known).map(|it| (it.tick, it.kind()))
        });
        assert_eq!(told.collect::<Vec<_>>(), [(0, Kind::Fault), (4, Kind::Recovery)]);
    }

    #[test]
    fn a_move_of_each_pedal_is_told_and_read_again() {
        for pedal in Pedal::ALL {
            let moved = PedalMove { pedal, at: 1.5, depth: 0.25 };
            assert_eq!(pedal_move(&super::pedal(moved, None)), Some(moved));
        }
        let old = Event { at: 2.0, speed: 1.0, ..of_none(Kind::Pedal, 0, String::new()) };
        let sustain = PedalMove { pedal: Pedal::Sustain, at: 2.0, depth: 1.0 };
        assert_eq!(pedal_move(&old), Some(sustain), "as in recordings of before");
        assert_eq!(pedal_move(&Event { controller: 1, ..old }), None);
    }
}
