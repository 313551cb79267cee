use scheduler::time::Nanos;

use crate::rig::Rig;

#[test]
fn a_tick_runs_once_and_not_before_it_is_due() {
    let mut rig = Rig::new();
    assert_eq!(rig.poll_at(0).map(|report| report.tick), Some(0));
    assert_eq!(rig.poll_at(0), None);
    assert_eq!(rig.poll_at(999), None);
    assert_eq!(rig.poll_at(1000).map(|report| report.tick), Some(1));
    assert_eq!(rig.observer.ticks, 2);
}

#[test]
fn a_tick_that_is_late_by_less_than_a_period_is_run_and_the_next_stays_on_time() {
    let mut rig = Rig::new();
    rig.poll_at(0);
    let late = rig.poll_at(1999).unwrap();
    assert_eq!((late.tick, late.skipped), (1, 0));
    let next = rig.poll_at(2000).unwrap();
    assert_eq!((next.tick, next.due, next.skipped), (2, Nanos::from_millis(2), 0));
}

#[test]
fn ticks_that_were_slept_through_are_skipped_and_counted_never_run_two_to_catch_up() {
    let mut rig = Rig::new();
    rig.poll_at(0);
    let report = rig.poll_at(5500).unwrap();
    assert_eq!((report.tick, report.skipped), (5, 4));
    assert_eq!((rig.bus.received, rig.observer.ticks), (Some(5), 2));
    assert_eq!(rig.poll_at(5999), None);
    assert_eq!(rig.poll_at(6000).map(|report| (report.tick, report.skipped)), Some((6, 0)));
}

#[test]
fn the_deadline_is_known_before_the_tick_is_run() {
    let mut rig = Rig::new();
    for microseconds in [0, 1700, 5500, 5999, 9000] {
        let foreseen = rig.scheduler.deadline(Nanos::from_micros(microseconds));
        if let Some(report) = rig.poll_at(microseconds) {
            assert_eq!(report.deadline, foreseen);
        } else {
            assert_eq!(foreseen, rig.scheduler.timetable().deadline(6));
        }
    }
}

#[test]
fn a_host_that_slept_resumes_without_skipping() {
    let mut rig = Rig::new();
    rig.poll_at(0);
    rig.scheduler.resume_at(Nanos::from_millis(9_000));
    assert_eq!(rig.poll_at(8_999_999), None);
    let report = rig.poll_at(9_000_000).unwrap();
    assert_eq!((report.tick, report.skipped, report.due), (1, 0, Nanos::from_millis(9_000)));
}
