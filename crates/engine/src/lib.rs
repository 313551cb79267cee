//! What plays: a model as the voice of one key, and the loop that advances 88 of them.
//!
//! [`voice`] builds a voice: input path, coupling, model, force path. [`realtime`] has the lanes,
//! their priorities and the tick's loop, in real and in virtual time.
#![forbid(unsafe_code)]

pub mod realtime;
pub mod voice;
