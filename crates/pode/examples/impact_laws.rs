//! A ball strikes two that touch, by each law of impacts.
#![allow(clippy::disallowed_macros, clippy::print_stdout, reason = "an example prints")]

use pode::contacts::restitution::{ContactJacobian, ImpactLaw};

fn main() {
    let row = ContactJacobian {
        rows: [[-1.0, 1.0, 0.0], [0.0, -1.0, 1.0]],
        inverse_mass: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    };
    let before = [1.0, 0.0, 0.0];
    for law in [ImpactLaw::Sequential, ImpactLaw::Newton, ImpactLaw::Poisson] {
        let resolved = row.contacts(&before, [1.0; 2]).resolved(law);
        let after = row.speeds_after(&before, &resolved.impulses);
        println!("{law:?}: {after:.3?}, {:?}", resolved.ending);
    }
}
