//! The exact flow through places where an entry of the state vanishes.
//!
//! The terms of a Taylor series are compared with its largest term, not with its sum: an entry that
//! reaches zero within rounding would have terms that count for ever.

use pode::stepper::Exact;
use pode::{Advance, EquationKind, Nature, Silent};

use crate::common::head::{CONTACTS, Head};
use crate::common::{OneMode, close, no_input};

#[test]
fn a_step_that_ends_at_zero_ends() {
    let nature = Nature::new(EquationKind::Affine, 1.0);
    let swing = OneMode { nature, ..OneMode::new((), |(), x| [x[1], -x[0]]) };
    for n in 1..=1000 {
        let h = f64::from(n) * 1e-3;
        for (x, v) in [(-h.sin(), h.cos()), (h.cos(), h.sin())] {
            for x in [x, x.next_up(), x.next_down()] {
                let mut it = swing.start(Exact, [x, v]);
                let tick = it.advance(h, &no_input, &mut Silent);
                assert_eq!(tick.advance, Advance::Completed, "h {h}, from {x}, {v}");
                let [x1, v1] = *it.state();
                close("x", x1, x * h.cos() + v * h.sin(), 1e-15);
                close("v", v1, v * h.cos() - x * h.sin(), 1e-15);
            }
        }
    }
}

#[test]
fn millions_of_steps_end_at_any_stiffness() {
    for [k, ..] in CONTACTS {
        let mut head = Head { k }.dropped(Exact);
        for n in 0..1_500_000_u32 {
            let advance = head.advance(7e-3, &no_input, &mut Silent).advance;
            assert_eq!(advance, Advance::Completed, "k {k}, tick {n}");
        }
    }
}
