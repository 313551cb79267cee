//! The solver against closed forms, independent programs and its own promises.
#![expect(unreachable_pub, reason = "modules of one program")]
#![expect(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a test may use the heap"
)]
#![expect(clippy::unwrap_used, clippy::panic, reason = "a test fails aloud")]
#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of a test are small"
)]

mod adams_bashforth;
mod any;
mod at_zero;
mod bad_input;
mod bouncing_families;
mod bounded;
mod busy;
mod by_need;
mod common;
mod contacts;
mod driven;
mod exact_flow;
mod exact_zero;
mod forecast;
mod friction;
mod friction_families;
mod grazing;
mod hunt_crossley;
mod impact_oscillator;
mod known;
mod long_run;
mod machinery;
mod maxima;
mod order;
mod parts;
mod pendulum;
mod properties;
mod quantised;
mod rules;
mod run;
mod shaker;
mod simultaneous;
mod sliding;
mod sliding_control;
mod sliding_families;
mod sliding_methods;
mod stability;
mod undeclared;
mod zeno;
