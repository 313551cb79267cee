//! The choice by need meets its budget, and no other line of its menu is cheaper.

use pode::stepper::{ByNeed, Given, Heun, MENU, NeededMethod, Rk4, VelocityVerlet};
use pode::{Dense as _, EquationKind, Nature, Silent, Stepper};

use crate::common::head::{CONTACTS, Head};
use crate::common::no_input;

/// Relative error after 20 rad of x'' = −ω² x in steps of `h` (s), and its evaluations.
fn oscillate<T: Stepper>(stepper: T, kind: EquationKind, omega: f64, h: f64) -> (f64, f64) {
    let mut evaluations = 0.0;
    let f = |_: f64, x: &[f64; 2]| {
        evaluations += 1.0;
        [x[1], -omega * omega * x[0]]
    };
    let mut field = Given { coords: 1, nature: Nature::new(kind, omega), f };
    let (mut x, mut memory) = ([1.0, 0.0], T::Memory::default());
    let n = (20.0 / (omega * h)).ceil();
    let mut k = 0.0;
    while k < n {
        x = *stepper.step(&mut field, &x, &mut memory, h).dense.end();
        k += 1.0;
    }
    let (sin, cos) = (omega * n * h).sin_cos();
    ((x[0] - cos).hypot(x[1] / omega + sin), evaluations / n)
}

fn oscillate_with(method: NeededMethod, omega: f64, h: f64) -> (f64, f64) {
    match method {
        NeededMethod::Heun => oscillate(Heun, EquationKind::Smooth, omega, h),
        NeededMethod::VelocityVerlet => oscillate(VelocityVerlet, EquationKind::Smooth, omega, h),
        NeededMethod::Rk4 => oscillate(Rk4, EquationKind::Smooth, omega, h),
        NeededMethod::Exact | NeededMethod::Rodas3 => unreachable!("not on the menu"),
    }
}

const BUDGETS: [f64; 6] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-7, 1e-9];

const RATES: [f64; 4] = [5.0, 100.0, 900.0, 5000.0];

#[test]
fn the_budget_is_met_by_the_cheapest_on_the_menu() {
    const TICK: f64 = 1e-3;
    for kind in [EquationKind::Smooth, EquationKind::Conservative] {
        for (budget, omega) in BUDGETS.into_iter().flat_map(|b| RATES.map(|omega| (b, omega))) {
            let what = format!("{kind:?}, budget {budget:e}, {omega} rad/s");
            let choice = ByNeed::new(budget, TICK).choice(&Nature::new(kind, omega), f64::INFINITY);
            let steps = |step: f64| (TICK / step).ceil().max(1.0);
            let (error, evaluations) =
                oscillate_with(choice.method, omega, TICK / steps(choice.step));
            // 20 rad; the phase's next term is a tenth of the first.
            assert!(error < 20.0 * 1.2 * budget, "{what}: {error:e} with {choice:?}");
            assert!(choice.error <= budget, "{what}: {choice:?}");
            let cost = steps(choice.step) * evaluations;
            for offer in
                MENU.iter().filter(|it| it.is_for_damped || kind == EquationKind::Conservative)
            {
                let reach = (budget / offer.constant).powf(1.0 / offer.order).min(1.0) / omega;
                let others = steps(reach) * offer.evaluations;
                assert!(cost <= others, "{what}: {choice:?} costs {cost}, {offer:?} {others}");
            }
        }
    }
}

#[test]
fn a_tighter_budget_never_costs_less() {
    let cost = |budget: f64, omega: f64| {
        let choice =
            ByNeed::new(budget, 1e-3).choice(&Nature::new(EquationKind::Smooth, omega), 1.0);
        let offer = MENU.iter().find(|it| it.method == choice.method).expect("on the menu");
        (1e-3 / choice.step).ceil().max(1.0) * offer.evaluations
    };
    for omega in RATES {
        let costs = BUDGETS.map(|budget| cost(budget, omega));
        assert!(costs.is_sorted(), "{omega}: {costs:?}");
    }
    assert!(cost(1e-3, 5.0) < cost(1e-9, 5.0), "Heun where it will do, RK4 where it must be");
}

#[test]
fn each_kind_gets_its_method() {
    let choice = |kind, rate| ByNeed::default().choice(&Nature::new(kind, rate), 1e-3);
    assert_eq!(choice(EquationKind::Affine, 1e4).method, NeededMethod::Exact);
    assert_eq!(choice(EquationKind::Linear, 0.0).method, NeededMethod::Exact);
    assert_eq!(choice(EquationKind::Stiff, 1e6).method, NeededMethod::Rodas3);
    assert_eq!(choice(EquationKind::Conservative, 20.0).method, NeededMethod::VelocityVerlet);
    assert_eq!(choice(EquationKind::Smooth, 20.0).method, NeededMethod::Heun);
    // Unknown rate: the model's own step with the safest of the menu.
    let unknown = choice(EquationKind::Smooth, 0.0);
    assert_eq!((unknown.method, unknown.step), (NeededMethod::Rk4, 1e-3));
}

#[test]
fn a_model_of_linear_modes_moves_on_its_exact_flow() {
    let [k, ..] = CONTACTS[2];
    let mut head = Head { k }.dropped(ByNeed::new(1e-2, 1e-3));
    for _ in 0..2000 {
        let _ = head.advance(1e-3, &no_input, &mut Silent);
    }
    let [x, v] = *head.state();
    crate::common::close("energy", v * v + 2.0 * crate::common::G * x, 1.0, 1e-12);
}
