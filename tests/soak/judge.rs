//! The verdicts: promises of the host, and observations.

use scheduler::motion::KEYS;

use crate::music;
use crate::plan::{LONGEST_AWAY, SoakPlan};
use crate::report::PromiseVerdict;
use crate::trial::{PlayedTrial, SoakChoice, SoakTime};
use crate::watch::BrokenPromise;

/// Time beyond the end of its key and port after which a note is stuck (s): the port is polled once
/// a second, a process is stopped for less, and a damper falls a little after its key is let go.
const LATE: f64 = 2.0;

pub(crate) fn judge(
    choice: &SoakChoice,
    plan: &SoakPlan,
    played: &PlayedTrial,
    undisturbed: Option<&PlayedTrial>,
) -> Vec<PromiseVerdict> {
    let mut verdicts = vec![
        no_stuck_note(choice, played),
        forces("no force is above its limit", choice, &played.seen.over_limit, played.seen.sent),
        forces(
            "no force outlasts its sample or voice",
            choice,
            &played.seen.untrusted,
            played.seen.sent,
        ),
        forces(
            "no motor pushes whose board is not reached",
            choice,
            &played.seen.unreached,
            played.seen.given,
        ),
    ];
    verdicts.push(match undisturbed {
        Some(undisturbed) => others_felt_the_same(plan, played, undisturbed),
        None => others_had_no_fault(plan, played),
    });
    verdicts.extend([
        frames_are_counted(plan, played),
        voices_are_told_of(plan, played),
        faults_are_logged(played),
        wrong_values_are_refused(played),
        recordings_survive(played),
    ]);
    if choice.time == SoakTime::Real {
        verdicts.push(late_ticks_have_a_cause(played));
    }
    verdicts
}

fn no_stuck_note(choice: &SoakChoice, played: &PlayedTrial) -> PromiseVerdict {
    let (sounding, notes) = (played.sounds.sounding(), played.sounds.notes);
    let longest = played.sounds.longest as f64 / f64::from(choice.scene.tick_hz);
    PromiseVerdict {
        promise: "no note is stuck",
        is_kept: sounding == 0 && 0 < notes && longest < music::LONGEST + LONGEST_AWAY + LATE,
        seen: format!(
            "{sounding} of {notes} notes sound at the end, the longest for {longest:.1} s"
        ),
    }
}

fn forces(
    promise: &'static str,
    choice: &SoakChoice,
    broken: &BrokenPromise,
    most: f64,
) -> PromiseVerdict {
    let seen = match broken.first {
        None => format!("{most:.1} N at most of {} N", choice.scene.render.force_limit),
        Some((tick, key, force)) => {
            format!("{} times, first {force} N on key {key} in tick {tick}", broken.times)
        }
    };
    PromiseVerdict { promise, is_kept: broken.times == 0, seen }
}

fn others_felt_the_same(
    plan: &SoakPlan,
    played: &PlayedTrial,
    undisturbed: &PlayedTrial,
) -> PromiseVerdict {
    let felt = |key: &usize| played.seen.before[*key] == undisturbed.seen.before[*key];
    let other: Vec<_> = (0..KEYS).filter(|key| !felt(key)).collect();
    let spared = plan.spared().count();
    let seen = if other.is_empty() {
        format!("{spared} keys to the end, the others until their own fault, to the last bit")
    } else {
        format!("keys {other:?} felt something else before anything befell them")
    };
    PromiseVerdict {
        promise: "keys feel nothing of faults on others",
        is_kept: other.is_empty(),
        seen,
    }
}

fn others_had_no_fault(plan: &SoakPlan, played: &PlayedTrial) -> PromiseVerdict {
    let failed: Vec<_> = plan.spared().filter(|key| played.told.faults.contains_key(key)).collect();
    PromiseVerdict {
        promise: "keys have no fault of others",
        is_kept: failed.is_empty(),
        seen: format!("{} spared keys, {} of them failed", plan.spared().count(), failed.len()),
    }
}

fn frames_are_counted(plan: &SoakPlan, played: &PlayedTrial) -> PromiseVerdict {
    let wires = played.seen.wires;
    let links = played.report.links;
    // A flipped bit may cut a frame in two, or join two.
    let is_near = wires.refused.abs_diff(wires.flipped) <= 10 + wires.flipped / 5;
    let has_gaps = plan.wires.is_empty() || (0 < wires.missing && 0 < links.gaps);
    PromiseVerdict {
        promise: "what is wrong with frames is counted",
        is_kept: is_near && has_gaps,
        seen: format!(
            "{} damaged and {} refused, {} samples missing, boards armed again {} times",
            wires.flipped, wires.refused, wires.missing, wires.rearmed
        ),
    }
}

fn voices_are_told_of(plan: &SoakPlan, played: &PlayedTrial) -> PromiseVerdict {
    let sensors = plan.sensors.iter().map(|it| it.key);
    let voices = plan.voices.iter();
    let voices = voices.filter(|it| it.what == crate::plan::BadValues::NotANumber).map(|it| it.key);
    let failing: std::collections::BTreeSet<_> = sensors.chain(voices).collect();
    let silent = failing.iter().filter(|key| !played.told.faults.contains_key(key)).count();
    let faults: u64 = played.told.faults.values().sum();
    PromiseVerdict {
        promise: "every voice and sensor that fails is told of",
        is_kept: silent == 0 && 0 < played.told.recoveries && 0 < played.report.totals.faults,
        seen: format!(
            "{} keys failed, {silent} of them unsaid; {faults} faults, {} recoveries",
            failing.len(),
            played.told.recoveries
        ),
    }
}

fn faults_are_logged(played: &PlayedTrial) -> PromiseVerdict {
    let told: u64 = played.told.faults.values().sum::<u64>() + played.told.recoveries;
    let lines = played.told.lines_on_voices();
    let seen = format!("{lines} lines on {told} faults and recoveries");
    PromiseVerdict { promise: "what fails is logged", is_kept: lines == told, seen }
}

fn wrong_values_are_refused(played: &PlayedTrial) -> PromiseVerdict {
    let acted = &played.acted;
    let undone = acted.failed.first().map_or_else(String::new, |why| format!("; {why}"));
    PromiseVerdict {
        promise: "wrong values are refused",
        is_kept: acted.wrong_taken == 0 && acted.failed.is_empty(),
        seen: format!(
            "{} of {} were taken; {} of {} right ones were refused{undone}",
            acted.wrong_taken,
            acted.wrong,
            acted.refused.len(),
            acted.asked
        ),
    }
}

fn recordings_survive(played: &PlayedTrial) -> PromiseVerdict {
    let said = played.told.lines.iter().find(|line| line.contains("cannot be written any further"));
    let seen = match (played.recordings.first(), said) {
        (Some(wrong), _) => wrong.clone(),
        (None, None) => "the log does not say that the recording ended".to_owned(),
        (None, Some(_)) => {
            "it ended its recording with a line in the log, what was there is saved, and the next \
             one is complete"
                .to_owned()
        }
    };
    let is_kept = played.recordings.is_empty() && said.is_some();
    PromiseVerdict { promise: "a full disk ends a recording and not the run", is_kept, seen }
}

fn late_ticks_have_a_cause(played: &PlayedTrial) -> PromiseVerdict {
    let deadline = &played.report.deadline;
    PromiseVerdict {
        promise: "what was too late is counted",
        is_kept: 0 < played.report.extent.skipped,
        seen: format!(
            "{} ticks skipped, most of them while the process was stopped; {} missed: {} by own \
             work, {} woken late, {} preempted",
            played.report.extent.skipped,
            deadline.missed,
            deadline.missed_own_work,
            deadline.missed_woken_late,
            deadline.missed_preempted
        ),
    }
}
