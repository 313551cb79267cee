//! The methods under test, one per line.

#[macro_export]
macro_rules! every_stepper {
    ($with:ident) => {
        $with! {
            explicit_euler: ExplicitEuler = ExplicitEuler,
            semi_implicit_euler: SemiImplicitEuler = SemiImplicitEuler,
            velocity_verlet: VelocityVerlet = VelocityVerlet,
            heun: Heun = Heun,
            rk4: Rk4 = Rk4,
            bogacki_shampine: BogackiShampine = BogackiShampine,
            tsitouras5: Tsitouras5 = Tsitouras5,
            dop853: Dop853 = Dop853,
            adams_bashforth2: AdamsBashforth2 = AdamsBashforth2,
            adams_bashforth3: AdamsBashforth3 = AdamsBashforth3,
            rodas3: Rodas3 = Rodas3,
            linear_implicit_midpoint: LinearImplicitMidpoint = LinearImplicitMidpoint,
            exact: Exact = Exact,
            by_need: ByNeed = ByNeed::default(),
            controlled_bogacki_shampine: Controlled<BogackiShampine> = Controlled::default(),
            controlled_tsitouras5: Controlled<Tsitouras5> = Controlled::default(),
            controlled_dop853: Controlled<Dop853> = Controlled::default(),
            any_exact: Any = Any::Exact(Exact::default()),
            any_dop853: Any = Any::Dop853(Dop853),
            any_controlled_dop853: Any = Any::ControlledDop853(Controlled::default()),
            controlled_exact: Controlled<Exact> = Controlled::default(),
        }
    };
}
