//! Derived bounds of guards certify at least the steps that those stated by hand do.
#![expect(
    clippy::print_stdout,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "what was compared is shown, and counts of ticks are small"
)]

use hand_written::{
    BouncingBall, CartPendulum, KeyHammerRigid, KeyHammerSprings, ReducedGrand, SpringWall,
};
use models::Described;
use pode::input::Cubic;
use pode::stepper::Rk4;
use pode::{Advance, Limits, Motion, Resets, Silent, Simulator, Work};

use crate::evaluation::Derived;

/// A key that goes down at 0.15 s and comes up at 0.5 s, each within some 40 ms.
fn stroke(t: f64, travel: f64) -> Motion {
    let mut motion = Motion::default();
    for (size, at) in [(travel, 0.15), (-travel, 0.5)] {
        let tanh = ((t - at) / 0.02_f64).tanh();
        motion.position += 0.5 * size * (1.0 + tanh);
        motion.rate += 0.5 * size * (1.0 - tanh * tanh) / 0.02;
    }
    motion
}

/// The work of all ticks of `h` without an event.
fn quiet<M>(model: M, start: (M::Mode, M::State), h: f64, travel: f64) -> Work
where
    M: Resets<Input = Motion> + Copy,
{
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), start.0, start.1);
    let mut quiet = Work::default();
    for tick in 0..(1.0 / h).round() as u32 {
        let [from, to] = [0, 1].map(|next| stroke(f64::from(tick + next) * h, travel));
        let signal = Cubic::hermite(from.position, from.rate, to.position, to.rate, h);
        let done = simulator.advance(h, &signal, &mut Silent);
        assert_eq!(done.advance, Advance::Completed);
        if done.work.events == 0 {
            quiet = quiet.plus(done.work);
        }
    }
    quiet
}

/// Plays the described model, whose state has N entries, and the one by hand.
#[track_caller]
fn check<M, const N: usize>(folder: &str, written: M)
where
    M: Described + Resets<Input = Motion> + Copy,
{
    let presets = Derived::built_in(folder, 0).system.mechanism.presets.len();
    for preset in 0..presets {
        let derived = Derived::built_in(folder, preset);
        let written = written.with_values(&derived.values);
        let described = derived.model::<N>();
        let travel = 0.0098 * described.input_per_metre();
        for h in [1e-3, 2.5e-4] {
            let begin = stroke(0.0, travel);
            let found = quiet(described, described.at_rest(&begin), h, travel);
            let by_hand = quiet(written, written.at_rest(&begin), h, travel);
            let label = format!("{folder}, preset {preset}, {h} s");
            let of = |work: &Work| {
                let all = work.certain + work.unknown;
                format!("{} of {all} steps, {} guards", work.certain, work.guards)
            };
            println!("{label}: derived {}, by hand {}", of(&found), of(&by_hand));
            assert!(by_hand.certain > 500, "{label}: {by_hand:?}");
            assert!(found.unknown <= by_hand.unknown, "{label}: {found:?}, not {by_hand:?}");
        }
    }
}

#[test]
fn model_a() {
    check::<_, 2>("key_hammer_rigid", KeyHammerRigid::default());
}

#[test]
fn model_b() {
    check::<_, 4>("key_hammer_springs", KeyHammerSprings::default());
}

#[test]
fn model_c() {
    check::<_, 4>("reduced_grand", ReducedGrand::default());
}

#[test]
fn cart_with_pendulum() {
    check::<_, 4>("cart_pendulum", CartPendulum::default());
}

#[test]
fn ball_on_floor() {
    check::<_, 2>("bouncing_ball", BouncingBall::default());
}

#[test]
fn spring_behind_wall() {
    check::<_, 1>("spring_wall", SpringWall::default());
}
