//! Contacts that close together, against closed forms and under random matrices.

#![allow(clippy::float_cmp, reason = "what is exact is compared to the bit")]

mod random;

use pode::contacts::restitution::{ContactJacobian, Contacts, ImpactEnding, MOST_IMPACTS};

use crate::common::close;

fn row<const N: usize, const D: usize>(masses: [f64; D]) -> ContactJacobian<N, D> {
    let mut rows = [[0.0; D]; N];
    for (i, row) in rows.iter_mut().enumerate() {
        (row[i], row[i + 1]) = (-1.0, 1.0);
    }
    let inverse = |i: usize, j: usize| if i == j { 1.0 / masses[i] } else { 0.0 };
    let inverse_mass = std::array::from_fn(|i| std::array::from_fn(|j| inverse(i, j)));
    ContactJacobian { rows, inverse_mass }
}

#[track_caller]
fn all_close<const D: usize>(found: [f64; D], expected: [f64; D]) {
    for (i, (found, expected)) in found.into_iter().zip(expected).enumerate() {
        close(format_args!("entry {i}"), found, expected, 1e-14);
    }
}

#[test]
fn a_cradle_passes_its_momentum_through_one_impact_after_another() {
    for arriving in 1..5_u8 {
        let before: [f64; 5] = std::array::from_fn(|i| if i < arriving.into() { 1.0 } else { 0.0 });
        let mirrored = std::array::from_fn(|i| before[4 - i]);
        let cradle = row::<4, 5>([1.0; 5]);
        let resolved = cradle.contacts(&before, [1.0; 4]).sequential();
        assert_eq!(cradle.speeds_after(&before, &resolved.impulses), mirrored, "{arriving} balls");
        let impacts = u32::from(arriving * (5 - arriving));
        assert_eq!((resolved.impacts, resolved.ending), (impacts, ImpactEnding::Law));
    }
}

#[test]
fn a_cradle_hit_all_at_once_keeps_together_behind_the_first_ball() {
    // The first ball meets four that act as one: −3/5 and 2/5.
    let cradle = row::<4, 5>([1.0; 5]);
    let before = [1.0, 0.0, 0.0, 0.0, 0.0];
    for (e, first, rest) in [(1.0, -0.6, 0.4), (0.5, -0.2, 0.3), (0.0, 0.2, 0.2)] {
        let resolved = cradle.contacts(&before, [e; 4]).simultaneous();
        let after = cradle.speeds_after(&before, &resolved.impulses);
        all_close(after, [first, rest, rest, rest, rest]);
        assert_eq!(resolved.ending, ImpactEnding::Law);
    }
}

#[test]
fn a_small_ball_between_a_wall_and_a_large_one_counts_digits_of_pi() {
    // [Gal03]: with 100ⁿ times the mass the impacts' number has the first digits of π.
    for (ratio, digits) in [(1.0, 3), (100.0, 31), (10_000.0, 314)] {
        let balls = ContactJacobian {
            rows: [[1.0, 0.0], [-1.0, 1.0]],
            inverse_mass: [[1.0, 0.0], [0.0, 1.0 / ratio]],
        };
        let before = [0.0, -1.0];
        let resolved = balls.contacts(&before, [1.0; 2]).sequential();
        assert_eq!(
            (resolved.impacts, resolved.ending),
            (digits, ImpactEnding::Law),
            "ratio {ratio}"
        );
        let after = balls.speeds_after(&before, &resolved.impulses);
        let energy = (after[0].powi(2) + ratio * after[1].powi(2)) / ratio;
        close(format_args!("energy, ratio {ratio}"), energy, 1.0, 1e-12);
    }
}

#[test]
fn a_ball_hit_from_both_sides_sends_both_back() {
    let balls = row::<2, 3>([1.0; 3]);
    let before = [1.0, 0.0, -1.0];
    let contacts = balls.contacts(&before, [0.5; 2]);
    // By symmetry the middle stays, and both leave at half their speed.
    for resolved in [contacts.simultaneous(), contacts.sequential()] {
        all_close(balls.speeds_after(&before, &resolved.impulses), [-0.5, 0.0, 0.5]);
    }
    // The faster contact strikes first, then the other, in turn.
    let before = [1.0, 0.0, -0.5];
    let first = balls.contacts(&before, [0.5; 2]).sequential();
    let after = balls.speeds_after(&before, &first.impulses);
    let (mut by_hand, mut a) = (before, 0);
    while by_hand[a] > by_hand[a + 1] {
        let change = 0.75 * (by_hand[a] - by_hand[a + 1]);
        (by_hand[a], by_hand[a + 1]) = (by_hand[a] - change, by_hand[a + 1] + change);
        a = 1 - a;
    }
    all_close(after, by_hand);
}

#[test]
fn a_ball_in_a_wedge_turns_back() {
    // Walls at 45° on both sides; along the normals both contacts close independently with v / √2.
    let s = std::f64::consts::FRAC_1_SQRT_2;
    let wedge = ContactJacobian { rows: [[s, s], [-s, s]], inverse_mass: [[0.5, 0.0], [0.0, 0.5]] };
    let before = [0.3, -2.0];
    for e in [0.0, 0.5, 1.0] {
        let contacts = wedge.contacts(&before, [e; 2]);
        for resolved in [contacts.sequential(), contacts.simultaneous()] {
            let after = wedge.speeds_after(&before, &resolved.impulses);
            all_close(after, before.map(|u| -e * u));
        }
    }
}

#[test]
fn a_narrow_wedge_shares_its_impulse_at_once() {
    // Walls of 60° towards each other, a ball of 1 kg that falls along the middle at 1 m/s.
    let (sin, cos) = (30_f64.to_radians().cos(), 30_f64.to_radians().sin());
    let wedge =
        ContactJacobian { rows: [[sin, cos], [-sin, cos]], inverse_mass: [[1.0, 0.0], [0.0, 1.0]] };
    let resolved = wedge.contacts(&[0.0, -1.0], [0.8; 2]).simultaneous();
    // 2 p cos 60° = m v (1 + e).
    all_close(resolved.impulses, [1.8, 1.8]);
}

#[test]
fn a_contact_that_is_overdetermined_shares_its_impulse() {
    let block = ContactJacobian { rows: [[1.0]; 4], inverse_mass: [[0.5]] };
    let contacts = block.contacts(&[-3.0], [0.5; 4]);
    for resolved in [contacts.sequential(), contacts.simultaneous()] {
        close("sum", resolved.impulses.iter().sum(), 9.0, 1e-14);
        all_close(resolved.velocities, [1.5; 4]);
        assert_eq!(resolved.ending, ImpactEnding::Law);
    }
}

#[test]
fn a_jammed_ball_comes_to_rest() {
    // Between two walls without play the sequence is infinite; Newton's law leaves one wall
    // closing.
    let ball = ContactJacobian { rows: [[1.0], [-1.0]], inverse_mass: [[1.0]] };
    for e in [0.3, 1.0] {
        let contacts = ball.contacts(&[-1.0], [e; 2]);
        for resolved in [contacts.sequential(), contacts.simultaneous()] {
            assert_eq!(resolved.velocities, [0.0; 2]);
            assert_eq!(resolved.ending, ImpactEnding::Plastic);
        }
    }
    let resolved = ball.contacts(&[-1.0], [1.0; 2]).sequential();
    assert_eq!(resolved.impacts, MOST_IMPACTS);
}

#[test]
fn coefficients_that_contradict_each_other_give_way_to_the_smallest() {
    let ball = ContactJacobian { rows: [[1.0], [-1.0]], inverse_mass: [[1.0]] };
    let resolved = ball.contacts(&[-1.0], [1.0, 0.0]).simultaneous();
    assert_eq!(resolved.velocities, [0.0; 2]);
    assert_eq!(resolved.ending, ImpactEnding::SmallestRestitution);
}

#[test]
fn three_balls_that_collapse_leave_together() {
    // Below e = 7 − 4√3 the inner ball bounces forever [Bro16]; the limit has one speed for all.
    let balls = row::<2, 3>([1.0; 3]);
    let before = [1.0, 0.0, -0.5];
    let resolved = balls.contacts(&before, [0.05; 2]).sequential();
    assert_eq!((resolved.ending, resolved.velocities), (ImpactEnding::Plastic, [0.0; 2]));
    all_close(balls.speeds_after(&before, &resolved.impulses), [1.0 / 6.0; 3]);
    assert!(resolved.impacts < 40, "{} impacts", resolved.impacts);
}

#[test]
fn contacts_that_do_not_touch_take_no_part() {
    let cradle = row::<4, 5>([1.0; 5]);
    let before = [1.0, 0.0, 0.0, -1.0, 0.0];
    let contacts = cradle.contacts(&before, [1.0; 4]).among([true, true, false, false]);
    let after = cradle.speeds_after(&before, &contacts.sequential().impulses);
    assert_eq!(after, [0.0, 0.0, 1.0, -1.0, 0.0]);
}

#[test]
fn velocities_of_no_bodies_are_said_to_be_contradictions() {
    let contacts = Contacts {
        delassus: [[1.0, -1.0], [-1.0, 1.0]],
        velocities: [-1.0, -1.0],
        restitution: [0.5; 2],
    };
    let nan = Contacts { velocities: [f64::NAN, 1.0], ..contacts };
    for resolved in [contacts.sequential(), contacts.simultaneous(), nan.sequential()] {
        assert_eq!(resolved.ending, ImpactEnding::Contradiction);
    }
}
