//! The crate `diffsol`: tsit45, BDF, TR-BDF2 and ESDIRK34, with its root functions.
//!
//! - default: the builder's tolerances, 1e-6 both, and tsit45;
//! - best: its book ("Stiff vs non-stiff") advises the explicit tsit45 for smooth problems
//!   that are not stiff, and ESDIRK34 beside BDF where there are many events ("Events and
//!   multistep solvers"); all four are swept. nalgebra's dense types, as in the book.
//!
//! A cell beside the equations holds the mode, so that one solver serves the whole run. After a
//! reset the state is put clearly above the floor, as in the book's bouncing ball (see `probes`).

mod events;

use std::cell::Cell;
use std::hint::black_box;
use std::rc::Rc;

use diffsol::{
    NalgebraContext, NalgebraLU, NalgebraMat, NalgebraVec, OdeBuilder, OdeEquationsImplicit,
    OdeSolverProblem, Op as _,
};

use crate::entry::{Entry, Setting, tolerances};
use crate::log::Log;
use crate::problem::Problem;

const CODE: &str = "diffsol";

type Matrix = NalgebraMat<f64>;
type Lu = NalgebraLU<f64>;
type V = NalgebraVec<f64>;
type C = NalgebraContext;

#[derive(Clone, Copy)]
enum Method {
    Tsit45,
    Bdf,
    TrBdf2,
    Esdirk34,
}

impl Method {
    /// Methods with name and the tightest tolerance 10^-k that ends within a second.
    const ALL: [(Self, &'static str, i32); 4] = [
        (Self::Tsit45, "tsit45", 13),
        (Self::Bdf, "BDF", 11),
        (Self::Esdirk34, "ESDIRK34", 10),
        (Self::TrBdf2, "TR-BDF2", 9),
    ];

    const fn note(self) -> &'static str {
        match self {
            Self::Tsit45 => "root functions; the state nudged above the floor after a reset",
            Self::Bdf | Self::TrBdf2 | Self::Esdirk34 => {
                "root functions; Jacobian by differences; the state nudged above the floor"
            }
        }
    }
}

pub(crate) fn entries<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: P,
    t_end: f64,
) -> Vec<Entry> {
    let default = entry(problem, t_end, Setting::Default, Method::ALL[0], 1e-6);
    let sweep = Method::ALL.into_iter().flat_map(|method| {
        tolerances(method.2)
            .map(move |tolerance| entry(problem, t_end, Setting::Best("sweep"), method, tolerance))
    });
    std::iter::once(default).chain(sweep).collect()
}

fn entry<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: P,
    t_end: f64,
    setting: Setting,
    (method, name, _): (Method, &'static str, i32),
    tolerance: f64,
) -> Entry {
    let run = move || {
        let mode = Rc::new(Cell::new(problem.start().0));
        match build(problem, Rc::clone(&mode), tolerance) {
            Ok(ode) => runner(problem, t_end, mode, ode, method),
            Err(error) => Box::new(move |_: &mut Log| Err(error.clone())),
        }
    };
    Entry { code: CODE, method: name, setting, knob: tolerance, note: method.note(), run: run() }
}

fn build<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: P,
    mode: Rc<Cell<P::Mode>>,
    tolerance: f64,
) -> Result<OdeSolverProblem<impl OdeEquationsImplicit<T = f64, V = V, M = Matrix, C = C>>, String>
{
    let (mode, again, roots) = (Rc::clone(&mode), Rc::clone(&mode), mode);
    let rhs = move |x: &[f64], _: &[f64], t: f64, dx: &mut [f64]| {
        dx.copy_from_slice(&problem.derivative(mode.get(), t, state(x)));
    };
    let jacobian = move |x: &[f64], _: &[f64], t: f64, v: &[f64], jv: &mut [f64]| {
        const STEP: f64 = 1e-6;
        let moved = |by: f64| {
            let x: [f64; N] = std::array::from_fn(|i| x[i] + by * v[i]);
            problem.derivative(again.get(), t, &x)
        };
        let (up, down) = (moved(STEP), moved(-STEP));
        jv.iter_mut().enumerate().for_each(|(i, jv)| *jv = (up[i] - down[i]) / (2.0 * STEP));
    };
    let root = move |x: &[f64], _: &[f64], _: f64, g: &mut [f64]| {
        g.copy_from_slice(&problem.guards(roots.get(), state(x)));
    };
    OdeBuilder::<Matrix>::new()
        .rtol(tolerance)
        .atol([tolerance])
        .rhs_implicit(rhs, jacobian)
        .init(move |_: &[f64], _: f64, x: &mut [f64]| x.copy_from_slice(&problem.start().1), N)
        .root(root, G)
        .build()
        .map_err(|error| error.to_string())
}

fn runner<const N: usize, const G: usize, P, E>(
    problem: P,
    t_end: f64,
    mode: Rc<Cell<P::Mode>>,
    ode: OdeSolverProblem<E>,
    method: Method,
) -> crate::entry::Run
where
    P: Problem<N, G>,
    E: OdeEquationsImplicit<T = f64, V = V, M = Matrix, C = C> + 'static,
{
    Box::new(move |log| {
        mode.set(problem.start().0);
        let before = ode.eqn.rhs().statistics().number_of_calls;
        let way = (&black_box(problem), black_box(t_end), &*mode);
        let fail = |error: diffsol::error::DiffsolError| error.to_string();
        match method {
            Method::Tsit45 => events::drive(ode.tsit45().map_err(fail)?, way, log),
            Method::Bdf => events::drive(ode.bdf::<Lu>().map_err(fail)?, way, log),
            Method::TrBdf2 => events::drive(ode.tr_bdf2::<Lu>().map_err(fail)?, way, log),
            Method::Esdirk34 => events::drive(ode.esdirk34::<Lu>().map_err(fail)?, way, log),
        }?;
        log.count((ode.eqn.rhs().statistics().number_of_calls - before) as u64);
        Ok(())
    })
}

#[inline]
fn state<const N: usize>(x: &[f64]) -> &[f64; N] {
    x.first_chunk().unwrap_or(&[0.0; N])
}
