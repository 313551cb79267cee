//! User errors and the answer of the `letoff` command itself: exit code 2 for wrong usage or a
//! wrong file, 1 for a failure of the run; one sentence on stderr for each mistake; never a panic.

mod lab;
mod limits;
mod midi_files;
mod output;
mod parameters;
mod scenes;
mod signals;
