//! The reduced grand, pressed and struck harder than by any hand, keeps its energy.

use pode::Motion;

use crate::kane::runnable::{GRAND, Runnable, mode, value};
use crate::kane::stroke::{AuditedRun, run, still};

/// Runs a finger that moves on at 1 m/s for 1 s, and pushes with 8 kN 1 m below the bed.
fn pushed_through(h: f64) -> AuditedRun<Runnable<4>> {
    let model = GRAND.model::<4>("default", 0, &[]);
    let input = |t: f64| Motion { position: t, rate: 1.0, ..Motion::default() };
    run(&model, model.at_rest(&still(0.0)), (h, 1.0), input).0
}

#[test]
fn a_key_pressed_through_its_bed_keeps_its_energy() {
    let audited = pushed_through(1e-3);
    let residual = audited.audit.integration.abs();
    assert!(audited.throughput > 3e3 && residual < 1e-6 * audited.throughput, "{residual:e}");
    // Again in steps that are short enough for every felt.
    let fine = pushed_through(5e-6).audit.dissipated;
    let off = (audited.audit.dissipated - fine).abs();
    assert!(off < 1e-4 * fine, "{} J, in fine steps {fine} J", audited.audit.dissipated);
}

#[test]
fn a_hammer_thrown_far_too_hard_keeps_its_energy() {
    for speed in [5.0, 20.0, 80.0] {
        let model = GRAND.model::<4>("default", 0, &[]);
        let x = [0.0, value(&model, "zs") - 1e-3, 0.0, speed];
        let (audited, _) = run(&model, (mode(&model, "FLA"), x), (1e-3, 0.004), |_| still(0.0));
        assert_eq!(audited.names()[..2], ["string-on", "string-off"]);
        let blow = 0.5 * value(&model, "mh") * speed * speed;
        let residual = audited.audit.integration.abs();
        assert!(residual < 1e-4 * blow, "{residual:e} J of {blow} J");
    }
}
