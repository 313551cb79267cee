//! The methods' promises on energy and on motion much faster than the step.

use pode::stepper::{ExplicitEuler, Given, LinearImplicitMidpoint, Rodas3, VelocityVerlet};
use pode::{Dense as _, EquationKind, Nature, State, Stepper};

fn step<T: Stepper, S: State>(
    kind: EquationKind,
    coords: usize,
    f: impl FnMut(f64, &S) -> S,
    x: &S,
    h: f64,
) -> T::Dense<S> {
    let mut field = Given { coords, nature: Nature::new(kind, 0.0), f };
    T::default().step(&mut field, x, &mut T::Memory::default(), h).dense
}

/// Two unit masses between springs, and a damper between them; positions, then speeds.
#[derive(Clone, Copy, Debug)]
struct Chain {
    /// Stiffness to the wall and between the masses (N/m).
    k: [f64; 2],
    c: f64,
}

impl Chain {
    fn derivative(&self, [a, b, u, v]: &[f64; 4]) -> [f64; 4] {
        let between = self.k[1] * (b - a) + self.c * (v - u);
        [*u, *v, between - self.k[0] * a, -between]
    }

    fn energy(&self, [a, b, u, v]: &[f64; 4]) -> f64 {
        0.5 * (u * u + v * v + self.k[0] * a * a + self.k[1] * (b - a) * (b - a))
    }

    /// Returns the rounding of the energy in a step of [`H`]: of the entries, and of the stiff
    /// spring's force at the positions' rounding, by ε in each of some dozen operations per entry.
    fn rounding(&self, x: &[f64; 4]) -> f64 {
        let ([a, b, u, v], energy) = (x.map(f64::abs), self.energy(x));
        let way = a + b + H * (u + v);
        32.0 * f64::EPSILON * (2.0 * energy + (2.0 * energy * self.k[1]).sqrt() * way)
    }
}

const H: f64 = 1e-3;

fn chains() -> impl Iterator<Item = Chain> {
    let rates = (-4..=8).map(|n| 10_f64.powf(0.5 * f64::from(n)) / H);
    rates.flat_map(|rate| {
        [0.0, 0.02, 2.0, 200.0].map(|loss| Chain { k: [1e4, rate * rate], c: loss * rate })
    })
}

#[test]
fn the_linear_implicit_midpoint_never_makes_energy_at_any_stiffness() {
    for chain in chains() {
        let mut x = [1e-4, -1e-4, 0.1, 0.3];
        let (start, mut before, mut rounding) = (chain.energy(&x), chain.energy(&x), 0.0);
        for n in 0..2000 {
            let f = |_: f64, x: &[f64; 4]| chain.derivative(x);
            let step = step::<LinearImplicitMidpoint, _>(EquationKind::Linear, 2, f, &x, H);
            for part in 1..=10 {
                let growth = chain.energy(&step.at(f64::from(part) / 10.0)) - before;
                assert!(growth <= chain.rounding(&x), "{chain:?}, step {n}: {growth:e}");
            }
            rounding += chain.rounding(&x);
            x = *step.end();
            before = chain.energy(&x);
        }
        let lost = start - before;
        if chain.c > 0.0 {
            assert!(lost > 1e3 * rounding, "{chain:?} lost {lost:e} only");
        } else {
            assert!(lost.abs() <= rounding, "{chain:?} lost {lost:e}, and may {rounding:e}");
        }
    }
}

/// Returns x1/x0 of x' = λ x for hλ = `re` + i `im`, as a rotation's x and y; and ten inner places.
fn response<T: Stepper>(re: f64, im: f64) -> Vec<f64> {
    let f = |_: f64, x: &[f64; 2]| [re * x[0] - im * x[1], im * x[0] + re * x[1]];
    let step = step::<T, _>(EquationKind::Linear, 0, f, &[1.0, 0.0], 1.0);
    (1..=10).map(|part| step.at(f64::from(part) / 10.0)).map(|[x, y]| x.hypot(y)).collect()
}

#[test]
fn what_is_much_faster_than_the_step_is_gone_after_it() {
    fn check<T: Stepper>(left: f64) {
        for exponent in 2..=8 {
            let rate = 10_f64.powi(exponent);
            for [re, im] in [[-rate, 0.0], [-0.6 * rate, 0.8 * rate], [-1e-3 * rate, rate]] {
                let inside = response::<T>(re, im);
                let what = format_args!("{} at {re:e} + {im:e} i", T::NAME);
                assert!(inside[9] <= left / rate, "{what}: {:e}", inside[9] * rate);
                assert!(inside.iter().all(|it| *it <= 1.0 + 1e-9), "{what}: {inside:?}");
            }
        }
    }
    // The first term of each R(z) at infinity, with a tenth more at |z| = 100.
    check::<Rodas3>(1.1 * 2.67);
}

#[test]
fn undamped_motion_of_any_rate_does_not_grow() {
    fn check<T: Stepper>() {
        for n in -20..=60 {
            let radians = 10_f64.powf(0.1 * f64::from(n));
            let growth = response::<T>(0.0, radians)[9] - 1.0;
            assert!(growth <= 16.0 * f64::EPSILON, "{}, {radians} rad: {growth:e}", T::NAME);
        }
    }
    check::<LinearImplicitMidpoint>();
    check::<Rodas3>();
}

/// Returns the largest error over 5 s of x' = λ (x − sin t) + cos t, λ = −1e6 / s, in steps of `h`
/// (s). `[HW96]` IV.15, eq. 15.1
fn prothero_robinson<T: Stepper>(h: f64) -> f64 {
    const RATE: f64 = -1e6;
    let (mut x, mut t, mut worst): (_, f64, f64) = ([0.0], 0.0, 0.0);
    while t < 5.0 {
        let f = |tau: f64, x: &[f64; 1]| {
            let (sin, cos) = (t + tau * h).sin_cos();
            [RATE * (x[0] - sin) + cos]
        };
        x = *step::<T, _>(EquationKind::Linear, 0, f, &x, h).end();
        t += h;
        worst = worst.max((x[0] - t.sin()).abs());
    }
    worst
}

#[test]
fn a_stiff_mode_follows_what_it_is_forced_to() {
    /// The errors are those of one step with 1/(h |λ|) → 0, and do not add up.
    fn check<T: Stepper>(limit: fn(f64) -> f64) {
        for h in [0.1, 0.05, 0.025] {
            let error = prothero_robinson::<T>(h);
            assert!(error < limit(h), "{} at {h} s: {error:e}", T::NAME);
            assert!(error > 0.5 * limit(h), "{} at {h} s: {error:e} is too good", T::NAME);
        }
    }
    // An eighth of h² x'', as of a chord: it alternates.
    check::<LinearImplicitMidpoint>(|h| 1.1 * h * h / 8.0);
    // Stiffly accurate: a fraction of the step times the fast motion's time.
    check::<Rodas3>(|h| 0.4 * h / 1e6);
    let explicit = prothero_robinson::<ExplicitEuler>(0.05);
    assert!(explicit.is_nan() || explicit > 1e10, "{explicit:e}");
}

/// Returns the largest energy error of q'' = −sin q over `steps` steps of 0.1 s, from 2.5 rad.
fn pendulum<T: Stepper>(steps: u32) -> f64 {
    let f = |_: f64, x: &[f64; 2]| [x[1], -x[0].sin()];
    let energy = |x: &[f64; 2]| 0.5 * x[1] * x[1] - x[0].cos();
    let mut x = [2.5, 0.0];
    let (start, mut worst) = (energy(&x), 0.0_f64);
    for _ in 0..steps {
        x = *step::<T, _>(EquationKind::Conservative, 1, f, &x, 0.1).end();
        worst = worst.max((energy(&x) - start).abs());
    }
    worst
}

#[test]
fn verlet_keeps_a_pendulum_s_energy_where_euler_does_not() {
    // H + h² (q'² cos q / 12 − sin² q / 24) is kept but for h⁴. [HLW06] IX.3
    let limit = 0.1 * 0.1 * (2.0 * (1.0 - 2.5_f64.cos()) / 12.0 + 2.5_f64.sin().powi(2) / 24.0);
    let worst = pendulum::<VelocityVerlet>(100_000);
    assert!((worst / limit - 1.0).abs() < 0.01, "{worst:e}, not {limit:e}");
    let euler = pendulum::<ExplicitEuler>(1000);
    assert!(euler > 1.0, "{euler:e}");
}
