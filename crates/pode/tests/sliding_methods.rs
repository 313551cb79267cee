//! Stick and slip with every method: the same modes, and times as good as its order.
//!
//! Error model: with r = ω h, a method of order p keeps the phase of a slip of 5 rad to some 5 rᵖ,
//! and its dense output, of order p at least, the landing. 8 rᵖ / ω covers both.

use pode::contacts::ContactState::{SlideDown, Stick};
use pode::stepper::Any;
use pode::{Motion, Nature};

use crate::common::block::Block;
use crate::common::two_sided::states;
use crate::common::{all_completed, close};
use crate::driven::run_driven;

#[track_caller]
fn check(method: Any) {
    let slip = (std::f64::consts::TAU - 2.0 * 0.5_f64.atan()) / 10.0;
    let belt = Motion { rate: 0.1, ..Motion::default() };
    for h in [1e-4, 1e-3] {
        let block = Block { nature: Nature::default(), ..Block::new(1.0, 100.0, [1.5, 1.0]) };
        let mut it = block.start(method, [0.0, 0.1], &belt);
        let (recorder, ticks) = run_driven(&mut it, (h, 0.0), 2.5, |_| belt);
        all_completed(&ticks);
        let modes = states(recorder.events());
        let cycle = [SlideDown, Stick];
        assert_eq!(modes, cycle.repeat(4)[..modes.len()], "{}, h {h}", method.name());
        assert!(modes.len() >= 7, "{}, h {h}: {modes:?}", method.name());
        let tolerance = 8.0 * (10.0 * h).powf(f64::from(method.order())) / 10.0 + 1e-12;
        for (n, seen) in recorder.events().iter().enumerate() {
            let cycles = (n / 2) as f64;
            let expected = 0.15 + cycles * (slip + 0.1) + if n % 2 == 0 { 0.0 } else { slip };
            let what = format_args!("{}, h {h}, event {n}", method.name());
            close(what, seen.t, expected, (cycles + 1.0) * tolerance);
        }
    }
}

#[test]
fn every_method_sticks_and_slips_as_its_order_allows() {
    for name in Any::NAMES {
        check(Any::named(name).unwrap());
    }
    check(Any::named("tsitouras5").and_then(|it| it.with_tolerance(1e-9, 1e-3)).unwrap());
}
