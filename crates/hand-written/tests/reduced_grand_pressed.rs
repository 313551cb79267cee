//! The reduced grand pressed and struck harder than any hand can: its energy is kept all the
//! same.

use hand_written::ReducedGrand;
use hand_written::reduced_grand::Mode;
use models::Described as _;
use pode::Motion;

use crate::stroke::{Books, preset, run, still};

/// The finger goes on at 1 m/s for 1 s, and 1 m below the bed it pushes with 8 kN.
fn pushed_through(h: f64) -> Books<ReducedGrand> {
    let model: ReducedGrand = preset("default", 0, &[]);
    let input = |t: f64| Motion { position: t, rate: 1.0, ..Motion::default() };
    run(model, model.at_rest(&still(0.0)), (h, 1.0), input).0
}

#[test]
fn a_key_pressed_through_its_bed_keeps_its_energy() {
    let books = pushed_through(1e-3);
    let residual = books.audit.integration.abs();
    assert!(books.throughput > 3e3 && residual < 1e-6 * books.throughput, "{residual:e}");
    // The same in steps that no felt is too stiff for.
    let fine = pushed_through(5e-6).audit.dissipated;
    let off = (books.audit.dissipated - fine).abs();
    assert!(off < 1e-4 * fine, "{} J, in fine steps {fine} J", books.audit.dissipated);
}

#[test]
fn a_hammer_thrown_far_too_hard_keeps_its_energy() {
    for speed in [5.0, 20.0, 80.0] {
        let model: ReducedGrand = preset("default", 0, &[]);
        let p = *model.values();
        let x = [0.0, p.string - 1e-3, 0.0, speed];
        let (books, _) = run(model, (Mode::Fla, x), (1e-3, 0.004), |_| still(0.0));
        assert_eq!(books.names()[..2], ["string-on", "string-off"]);
        let blow = 0.5 * p.hammer_mass * speed * speed;
        let residual = books.audit.integration.abs();
        assert!(residual < 1e-4 * blow, "{residual:e} J of {blow} J");
    }
}
