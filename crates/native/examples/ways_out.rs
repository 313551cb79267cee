//! Times one function three ways: interpreted tape, emitted Rust, machine code.
//!
//! `cargo run --release -p native --example ways_out`
#![allow(clippy::print_stdout, reason = "a program for people")]
#![allow(clippy::unwrap_used, reason = "a measurement that fails aloud")]

// Its table has types of `contacts` as well.
#[path = "../../kane/tests/emitted/example.rs"]
mod emitted;
#[path = "../../expressions/tests/common/lever.rs"]
pub mod lever;

use std::hint::black_box;
use std::time::Instant;

use equations::table::{Arguments, Functions};
use expressions::tape;

const CONSTANTS: [f64; 8] = [0.4, 0.2, 0.03, 0.01, 6.2, 4e3, 1.0, 2.0];

/// The shortest of several runs, in ns per call.
fn time(mut call: impl FnMut(f64)) -> f64 {
    const CALLS: u32 = 100_000;
    let run = |call: &mut dyn FnMut(f64)| {
        let start = Instant::now();
        for n in 0..CALLS {
            call(f64::from(n % 128) * 1e-3);
        }
        start.elapsed().as_secs_f64() * 1e9 / f64::from(CALLS)
    };
    (0..30).map(|_| run(&mut call)).fold(f64::INFINITY, f64::min)
}

fn main() {
    let tapes = lever::functions();
    let start = Instant::now();
    let native = native::compile(&tapes).unwrap();
    println!(
        "{}: {} functions compiled in {:?}",
        emitted::TABLE.name,
        tapes.len(),
        start.elapsed()
    );
    let dynamic: Box<dyn Functions> = Box::new(emitted::LeverWithHammerFunctions);
    for (number, name) in [(1, "derivative"), (5, "jacobian"), (2, "readout")] {
        let tape = &tapes[usize::from(number)];
        let mut out = [0.0; 16];
        let mut of = |functions: &dyn Functions| {
            time(|n| {
                let state = [n, 0.5 - n, 1.0, 2.0];
                let input = [0.2, 0.7, 0.0, 0.0];
                let given =
                    Arguments { constants: &CONSTANTS, state: &state, input: &input, extra: &[] };
                functions.call(number, black_box(&given), &mut out);
                black_box(&out);
            })
        };
        let (emitted, native) = (of(&*dynamic), of(&native));
        let interpreted = time(|n| {
            let state = [n, 0.5 - n, 1.0, 2.0];
            let given = tape::TapeArguments {
                constants: &CONSTANTS,
                state: &state,
                input: [0.2, 0.7, 0.0, 0.0],
                extra: &[],
            };
            black_box(tape.evaluate(black_box(&given)));
        });
        println!(
            "{name:10} {:3} operations: tape {interpreted:6.1} ns, emitted {emitted:6.1} ns, native {native:6.1} ns",
            tape.instructions.len()
        );
    }
}
