//! Piecewise-continuous ordinary differential equations (PODEs) at a deadline.
//!
//! A model has modes, and each mode has its own equations:
//!
//! ```text
//! x' = f_i(x, u(t))          derivative      [GC93] eq. 6
//! y  = r_i(x, u(t))          readout         [GC93] eq. 7
//! g_i(x, u(t)) > 0           guards          [GC93] eq. 8, 10
//! x⁺ = H_i(x⁻, u)            reset map       [GC93] eq. 9, 12 (which writes y for x)
//! ```
//!
//! [`Simulator::advance`] moves a model over one tick: it steps, watches the guards, locates
//! crossings inside the step, applies reset maps and continues, with a fixed maximum of every kind
//! of work. Time is (tick, θ), never a sum of steps.
//!
//! # Glossary
//!
//! | term | meaning | in the paper |
//! |---|---|---|
//! | model | constant description: parameters and equations | model |
//! | mode | one contact configuration with its own equations | sub-model, index *i* |
//! | state | coordinates, then speeds | *x* (eq. 1) |
//! | input | measured motion | *u(t)* (eq. 2) |
//! | derivative | right-hand side | *f_i* |
//! | readout | force as a function of state and input | *r_i* |
//! | guard | function positive while the mode is valid | indicator *g_i* |
//! | crossing | a guard reaching zero from above within a step | eq. 11 |
//! | reset map | state before → state after, and the next mode | transition *h_i* |
//! | epoch | interval during which one mode holds | simulation epoch |
//! | step | one move of a stepper, length `h` (s) | |
//! | dense output | continuous solution inside a step | |
//! | locate | find the time of a crossing | root finder, §2.2 |
//! | tick | one period of the control loop | servo step |
//!
//! # What is not here
//!
//! No clock, no heap, no thread, no key, no file, no unsafe.
#![cfg_attr(not(any(test, feature = "std")), no_std)]
#![forbid(unsafe_code)]

mod audit;
pub mod contacts;
mod crossing;
mod cubic;
mod dense;
mod dip;
mod enclosure;
mod epoch;
mod forecast;
mod guard;
mod impacts;
mod isolate;
mod limits;
mod locate;
mod mechanical;
mod model;
mod nature;
mod outcome;
mod part;
mod quadrature;
mod reached;
#[cfg(feature = "std")]
mod recorder;
mod run;
mod simulator;
mod slopes;
mod state;
mod watch;

pub mod input;
pub mod math;
pub mod stepper;

pub use audit::{Auditor, Energetic, EnergyAudit, EnergyBalance};
pub use dense::{Cubic, Dense, DenseBounds, Polynomial};
pub use enclosure::{Enclosure, GuardBound};
pub use guard::{Fires, GuardId, GuardSpec, GuardValue, MAX_GUARDS, Reads};
pub use input::{Motion, Signal};
pub use limits::{Limits, WorkLimit};
pub use locate::{Bracket, Located, locate};
pub use mechanical::{
    MAX_SPEEDS, Mechanical, MechanicalEnd, MechanicalOutcome, MechanicalStep, PressedContact,
};

pub use model::{Guarded, Model, Reset, Resets, Settling};
pub use nature::{EquationKind, Nature};
pub use outcome::{Advance, Cap, Fault, Tick, Work};
pub use part::{MAX_PARTS, Part};
pub use reached::ReachedMaximum;
#[cfg(feature = "std")]
pub use recorder::{RecordedEvent, RunRecorder, Sample};
pub use simulator::{RunOutcome, Simulator};
pub use slopes::{ReadoutSlopes, Sloped, differenced_slopes};
pub use state::{Factors, Matrix, State};
pub use stepper::{Field, Step, Stepper};
pub use watch::{Event, EventCause, Piece, Silent, Watch};

#[cfg(all(doctest, feature = "std"))]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(all(doctest, feature = "std"))]
#[doc = include_str!("../GUIDE.md")]
struct Guide;
