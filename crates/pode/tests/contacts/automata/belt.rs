//! A block on a belt before a rigid stop: friction and a wall in one model.
//!
//! The reference joins closed forms: a harmonic motion about F_k/k while it slips, the belt's
//! motion while it sticks, and v⁺ = −e v⁻ at the stop.

use pode::contacts::ContactState;
use pode::stepper::Exact;
use pode::{EnergyAudit, Motion};

use crate::common::block::{Block, belt};
use crate::common::{all_completed, close, each_step_and_phase};
use crate::driven::{root, run_driven};

#[derive(Clone, Copy, Debug, PartialEq)]
enum Ends {
    Slips,
    Sticks,
    Hits,
}

fn swing(it: &Block, x: [f64; 2], t: f64) -> [f64; 2] {
    let (w, c) = (it.omega(), it.kinetic / it.k);
    let (sin, cos) = (w * t).sin_cos();
    [c + (x[0] - c) * cos + x[1] / w * sin, x[1] * cos - w * (x[0] - c) * sin]
}

/// Returns the first `n` ends of pieces from a stick at `x0`, with time (s), and the state after.
fn pieces(it: &Block, x0: f64, belt: f64, n: usize) -> Vec<(f64, Ends, [f64; 2])> {
    const SAMPLES: u32 = 20_000;
    let (mut t, mut x, mut sticks, mut out) = (0.0, [x0, belt], true, vec![]);
    while out.len() < n {
        let (after, end) = if sticks {
            let [slips, hits] = [it.stiction / it.k, it.stop].map(|place| (place - x[0]) / belt);
            if slips < hits { (slips, Ends::Slips) } else { (hits, Ends::Hits) }
        } else {
            let over = |t: f64| swing(it, x, t)[1] - belt;
            let beyond = |t: f64| swing(it, x, t)[0] - it.stop;
            let step = std::f64::consts::TAU / it.omega() / f64::from(SAMPLES);
            let mut times = (2..SAMPLES).map(|i| f64::from(i) * step);
            let late = times.find(|t| over(*t) >= 0.0 || beyond(*t) >= 0.0).unwrap();
            let low = late - step;
            if over(late) >= 0.0 {
                (root(low, late, over), Ends::Sticks)
            } else {
                (root(low, late, beyond), Ends::Hits)
            }
        };
        x = if sticks { [x[0] + belt * after, belt] } else { swing(it, x, after) };
        if end == Ends::Hits {
            x = [it.stop, -it.restitution * x[1]];
        }
        sticks = end == Ends::Sticks;
        t += after;
        out.push((t, end, x));
    }
    out
}

#[track_caller]
fn check(it: Block, expected: &[Ends], (h, phase): (f64, f64)) {
    let speed = 0.15;
    let belt = |t: f64| Motion { position: speed * t, rate: speed, ..Motion::default() };
    let pieces = pieces(&it, 0.0, speed, expected.len());
    let mut simulator = it.start(Exact, [0.0, speed], &belt(0.0));
    assert_eq!(simulator.mode().contacts.state(0), ContactState::Stick);
    let until = pieces[pieces.len() - 1].0 + 1e-3;
    let (recorder, ticks) = run_driven(&mut simulator, (h, phase), until, belt);
    all_completed(&ticks);
    assert_eq!(
        recorder.events().len(),
        pieces.len(),
        "h {h}, phase {phase}: {:?}",
        recorder.events()
    );
    for ((found, (t, end, x)), expected) in recorder.events().iter().zip(&pieces).zip(expected) {
        let what = format!("{end:?} at {t}, h {h}, phase {phase}");
        assert_eq!(end, expected, "{what}");
        assert_eq!(found.name, if *end == Ends::Hits { "stop" } else { "belt" }, "{what}");
        let state = found.to.contacts.state(0);
        let sticks = *end == Ends::Sticks;
        assert_eq!(state, if sticks { ContactState::Stick } else { ContactState::SlideDown });
        close(&what, found.t, *t, 1e-11);
        close(&what, found.after[0], x[0], 1e-11);
        close(&what, found.after[1], x[1], 1e-11);
    }
}

fn block() -> Block {
    let contacts = vec![belt("belt", 0.1)];
    Block { contacts, stop: 0.03, ..Block::new(0.5, 80.0, [2.0, 1.2]) }
}

#[test]
fn a_block_on_a_belt_is_carried_to_a_stop_thrown_back_and_carried_again() {
    use Ends::{Hits, Slips, Sticks};
    each_step_and_phase(|at, phase| {
        check(Block { stop: 0.02, ..block() }, &[Hits; 4], (at, phase));
        // The belt loses it at 0.025 m, and it slips on to a stop at 0.03 m …
        check(block(), &[Slips, Hits, Sticks, Slips, Hits, Sticks], (at, phase));
        // … or turns before one at 0.04 m.
        let far = Block { stop: 0.04, ..block() };
        check(far, &[Slips, Sticks, Slips, Sticks, Slips, Sticks], (at, phase));
    });
}

#[test]
fn belt_friction_and_stop_keep_the_books_of_the_energy() {
    let belt = |t: f64| Motion { position: 0.15 * t, rate: 0.15, ..Motion::default() };
    let mut it = block().start(Exact, [0.0, 0.15], &belt(0.0));
    let mut audit = EnergyAudit::default();
    for n in 0..2000 {
        let t = f64::from(n) * 1e-3;
        let _ = it.advance(1e-3, &|theta: f64| belt(t + theta * 1e-3), &mut audit);
    }
    assert!(audit.dissipated > 0.05 && audit.jumps < -1e-3, "{audit:?}");
    // Friction's power is a sine: Simpson's rule errs by (ωh)⁴/2880 of it.
    close("residual", audit.integration, 0.0, 1e-9);
}
