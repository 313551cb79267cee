//! Stick and slip with every method: the same modes, and times as good as its order.
//!
//! Error model: with r = ω h, a method of order p keeps the phase of a slip of 5 rad to some 5 rᵖ,
//! and its dense output, of order p at least, the landing. 8 rᵖ / ω covers both.

use pode::filippov::{Filippov, Mode};
use pode::stepper::{
    AdamsBashforth2, AdamsBashforth3, BogackiShampine, ByNeed, Controlled, Dop853, Exact,
    ExplicitEuler, Heun, LinearImplicitMidpoint, Rk4, Rodas3, SemiImplicitEuler, Tsitouras5,
    VelocityVerlet,
};
use pode::{Limits, Nature, Simulator, Stepper};

use crate::common::stick_slip::StickSlip;
use crate::common::{all_completed, close, run};

#[track_caller]
fn check<T: Stepper>() {
    let slip = (std::f64::consts::TAU - 2.0 * 0.5_f64.atan()) / 10.0;
    for h in [1e-4, 1e-3] {
        let model = Filippov(StickSlip { nature: Nature::default() });
        let (mode, state) = model.start(&[0.0, 0.1], &());
        let mut it = Simulator::new(model, T::default(), Limits::default(), mode, state);
        let (recorder, ticks) = run(&mut it, h, 0.0, 2.5);
        all_completed(&ticks);
        let modes: Vec<_> = recorder.events().iter().map(|seen| seen.to).collect();
        let cycle = [Mode::Below, Mode::Sliding];
        assert_eq!(modes, cycle.repeat(4)[..modes.len()], "{}, h {h}", T::NAME);
        assert!(modes.len() >= 7, "{}, h {h}: {modes:?}", T::NAME);
        let tolerance = 8.0 * (10.0 * h).powf(f64::from(T::ORDER)) / 10.0 + 1e-12;
        for (n, seen) in recorder.events().iter().enumerate() {
            let cycles = (n / 2) as f64;
            let expected = 0.15 + cycles * (slip + 0.1) + if n % 2 == 0 { 0.0 } else { slip };
            let what = format_args!("{}, h {h}, event {n}", T::NAME);
            close(what, seen.t, expected, (cycles + 1.0) * tolerance);
        }
    }
}

macro_rules! methods {
    ($($test:ident: $method:ty;)+) => {$(
        #[test]
        fn $test() {
            check::<$method>();
        }
    )+};
}

methods! {
    explicit_euler: ExplicitEuler;
    semi_implicit_euler: SemiImplicitEuler;
    velocity_verlet: VelocityVerlet;
    heun: Heun;
    rk4: Rk4;
    bogacki_shampine: BogackiShampine;
    tsitouras5: Tsitouras5;
    adams_bashforth2: AdamsBashforth2;
    adams_bashforth3: AdamsBashforth3;
    rodas3: Rodas3;
    linear_implicit_midpoint: LinearImplicitMidpoint;
    exact: Exact;
    dop853: Dop853;
    controlled: Controlled<Tsitouras5>;
    by_need: ByNeed;
}
