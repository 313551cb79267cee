//! Contacts of random bodies under all laws.

use pode::contacts::restitution::{ContactJacobian, Contacts, ImpactEnding, Resolved};
use proptest::prelude::*;

/// Bodies with D speeds and N contacts; some rows repeat, so that contacts depend on each other,
/// and some have the opposite sign, so that bodies jam.
fn bodies<const N: usize, const D: usize>()
-> impl Strategy<Value = (ContactJacobian<N, D>, [f64; D], [f64; D], [f64; N], bool)> {
    let entry = prop_oneof![2 => -1.0..1.0_f64, 1 => Just(0.0), 1 => Just(1.0), 1 => Just(-1.0)];
    let row = proptest::collection::vec(entry, D);
    let rows = proptest::collection::vec((row, 0..N, -2..=2_i8), N);
    let masses = proptest::collection::vec(-1.5..1.5_f64, D);
    let speeds = proptest::collection::vec(-1.0..1.0_f64, D);
    let e = proptest::collection::vec(prop_oneof![Just(0.0), 0.0..1.0_f64, Just(1.0)], N);
    (rows, masses, speeds, e, any::<bool>()).prop_map(|(rows, masses, speeds, e, same)| {
        let own: Vec<[f64; D]> =
            rows.iter().map(|(row, ..)| std::array::from_fn(|j| row[j])).collect();
        let rows = std::array::from_fn(|i| match rows[i] {
            (_, other, 2) if other < i => own[other],
            (_, other, -2) if other < i => own[other].map(|entry| -entry),
            _ => own[i],
        });
        let masses: [f64; D] = std::array::from_fn(|j| 10_f64.powf(masses[j]));
        let inverse = |i: usize, j: usize| if i == j { 1.0 / masses[i] } else { 0.0 };
        let inverse_mass = std::array::from_fn(|i| std::array::from_fn(|j| inverse(i, j)));
        let e = std::array::from_fn(|i| if same { e[0] } else { e[i] });
        let speeds = std::array::from_fn(|j| speeds[j]);
        (ContactJacobian { rows, inverse_mass }, masses, speeds, e, same)
    })
}

fn energy<const D: usize>(masses: &[f64; D], speeds: &[f64; D]) -> f64 {
    masses.iter().zip(speeds).map(|(m, u)| 0.5 * m * u * u).sum()
}

fn check<const N: usize, const D: usize>(
    jacobian: &ContactJacobian<N, D>,
    (masses, speeds): (&[f64; D], &[f64; D]),
    resolved: &Resolved<N>,
) -> Result<(), TestCaseError> {
    prop_assert_ne!(resolved.ending, ImpactEnding::Contradiction, "{:?}", resolved);
    prop_assert!(resolved.impulses.iter().all(|p| *p >= 0.0), "a pull: {:?}", resolved);
    prop_assert!(resolved.velocities.iter().all(|v| *v >= 0.0), "closes: {:?}", resolved);
    let after = jacobian.speeds_after(speeds, &resolved.impulses);
    let delassus = jacobian.contacts(speeds, [0.0; N]).delassus;
    let (before, after_all) = (energy(masses, speeds), energy(masses, &after));
    let passed: f64 = (0..N).map(|i| resolved.impulses[i].powi(2) * delassus[i][i]).sum();
    let rounding = 1e-12 * before + 1e-13 * passed;
    prop_assert!(after_all <= before + rounding, "{before} J to {after_all} J");
    for (i, row) in jacobian.rows.iter().enumerate() {
        let rate: f64 = row.iter().zip(after).map(|(a, u)| a * u).sum();
        let passed = delassus[i].iter().zip(resolved.impulses).map(|(g, p)| (g * p).abs());
        let off = (rate - resolved.velocities[i]).abs();
        prop_assert!(off < 1e-12 + 1e-9 * passed.sum::<f64>(), "contact {i}: off by {off:e}");
    }
    Ok(())
}

fn check_newton<const N: usize>(
    contacts: &Contacts<N>,
    resolved: &Resolved<N>,
) -> Result<(), TestCaseError> {
    for i in 0..N {
        let w = resolved.velocities[i] + contacts.restitution[i] * contacts.velocities[i];
        let size = contacts.delassus[i].iter().zip(resolved.impulses).map(|(g, p)| (g * p).abs());
        let rounding = 1e-10 * (contacts.velocities[i].abs() + size.sum::<f64>());
        prop_assert!(w >= -rounding, "contact {i}: {w:e}");
        let is_free = resolved.impulses[i] == 0.0 || w <= rounding;
        prop_assert!(is_free, "contact {i} has {w:e} with {:e}", resolved.impulses[i]);
    }
    Ok(())
}

macro_rules! random_contacts {
    ($($name:ident: $n:literal contacts, $d:literal speeds;)+) => {
        proptest! {
            #![proptest_config(ProptestConfig {
                cases: 2000,
                failure_persistence: None,
                ..ProptestConfig::default()
            })]
            $(
                #[test]
                fn $name((jacobian, masses, speeds, e, same) in bodies::<$n, $d>()) {
                    let contacts = jacobian.contacts(&speeds, e);
                    let (sequence, at_once) = (contacts.sequential(), contacts.simultaneous());
                    check(&jacobian, (&masses, &speeds), &sequence)?;
                    check(&jacobian, (&masses, &speeds), &at_once)?;
                    check(&jacobian, (&masses, &speeds), &contacts.in_phases())?;
                    if at_once.ending == ImpactEnding::Law {
                        check_newton(&contacts, &at_once)?;
                    }
                    prop_assert!(!same || at_once.ending != ImpactEnding::SmallestRestitution);
                }
            )+
        }
    };
}

random_contacts! {
    one_contact_of_random_bodies: 1 contacts, 2 speeds;
    three_contacts_of_random_bodies: 3 contacts, 3 speeds;
    five_contacts_of_few_random_bodies: 5 contacts, 2 speeds;
    eight_contacts_of_random_bodies: 8 contacts, 6 speeds;
}
