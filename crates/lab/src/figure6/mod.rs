//! The paper's experiment, its section 6 and figure 6, at the paper's own rates. `[GC93]` §6
//!
//! ```text
//! hand ──▶ handle ──▶ encoder ──▶ model B, one step of 2 ms ──▶ motor ──▶ handle ──▶ hand
//!          closed_loop            sampled
//! ```
//!
//! `sampled` is the paper's step: RK4 with the input held, guards checked once a step.
//! `closed_loop` is all of it, with model time slower than the hand's or equal. `located` locates
//! the events. `judge` measures the step's error on a stroke with independently known events.
//!
//! From the paper: model B and its Table 2, step, servo cycle, method, encoder, travel, story.
//! Estimates that reproduce the story: the stroke, the rig's masses, frictions and motor, and the
//! hand, which commands the stroke under the expected force.

mod closed_loop;
mod hand;
mod judge;
mod located;
mod model_run;
mod outcome;
mod picture;
mod sampled;
mod sheet;
#[cfg(test)]
mod tests;

pub use closed_loop::{ClosedLoop, Pace, RigRow, SERVO, STEP, TIME_SCALES};
pub use judge::{StepErrors, StepKind, Truth};
pub use model_run::{ModelRun, RunEvent, RunRow};
pub use outcome::{Figure6, Figure6Summary, figure6};
pub use sheet::write_figure6;
