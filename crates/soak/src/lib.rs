//! A trial of the whole host: dense random music on all keys, and faults in everything around it.
//!
//! | module | contents |
//! |---|---|
//! | `plan` | what will be played and what will go wrong, all of it from one seed |
//! | `music` | the strokes of the fingers |
//! | `watch` | between scheduler and keys: spoils samples, checks forces |
//! | `actions` | what a tuner, failing models and a full disk do at which tick |
//! | `synthesizer` | the destination of MIDI, whose port vanishes |
//! | `telling` | what telemetry and the log say |
//! | `recordings` | what became of the recordings |
//! | `strangers` | in real time: clients that stall or send rubbish, busy processors, a stopped process |
//! | `killed` | in real time: a supervised host in processes of its own, which is killed |
//! | `host_files` | the files of that host |
//! | `trial` | what is tried, and what came of one run |
//! | `judge` | the verdicts |
//! | `report` | what is said of them |
//! | `run` | plays the plan, and the same music without faults |
//!
//! In virtual time the same music is played a second time without any fault: keys that nothing
//! befell must have felt the same to the last bit.

#![forbid(unsafe_code)]

mod actions;
mod host_files;
mod judge;
mod killed;
mod music;
mod plan;
mod recordings;
mod report;
mod run;
mod strangers;
mod synthesizer;
mod telling;
mod trial;
mod watch;

pub use host_files::{HostFiles, SupervisedProgram};
pub use report::{PromiseVerdict, SoakReport};
pub use run::{SoakError, soak};
pub use trial::{SoakChoice, SoakTime};
