//! The paper's experiment, its section 6 and figure 6, at the paper's own rates. `[GC93]` §6
//!
//! ```text
//! hand ──▶ handle ──▶ encoder ──▶ model B, one step of 2 ms ──▶ motor ──▶ handle ──▶ hand
//!          closed_loop            sampled
//! ```
//!
//! `hand` has the hand that grips, and the rig; `sampled` the paper's step, RK4 with the input
//! held and guards seen once a step; `closed_loop` all of it, in a time of the hand's that is
//! slower than the model's or the same; `located` the same model with its events located.
//! `judge` tells how wrong the paper's step is on the stroke whose events an independent program
//! knows; `picture` draws, `sheet` writes the report.
//!
//! What is the paper's: model B and its Table 2, step, servo cycle, method, encoder, travel, and
//! the story. What is not: the stroke, the rig's masses, frictions and motor, and the hand, which
//! are estimates with which that story is told. The hand is a practised one: it commands what the
//! stroke needs under the force that it expects, and feels what is left as it comes.

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
