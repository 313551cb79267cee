//! Machine code gives the bits of its tape.

use instruments::equations::table::{Arguments, Functions as _};
use mechanism::expressions::graph::Graph;
use mechanism::expressions::tape::{self, Instruction, Tape, TapeSlot};
use mechanism::native::{MAX_INSTRUCTIONS, NativeError, compile, compile_unless_cancelled};
use proptest::prelude::*;

use crate::expressions::common::{layout, lever, trees, values};

/// Bits, with a single kind of NaN.
fn bits(all: &[f64]) -> Vec<u64> {
    all.iter().map(|it| if it.is_nan() { f64::NAN.to_bits() } else { it.to_bits() }).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn machine_code_gives_the_tape_s_bits(
        all in prop::collection::vec(trees(), 1..4),
        points in prop::collection::vec(values(), 1..8),
    ) {
        let mut graph = Graph::new();
        let nodes: Vec<_> = all.iter().map(|it| it.build(&mut graph)).collect();
        let tape = Tape::lower(&graph, &layout(), &nodes).unwrap();
        let native = compile(core::slice::from_ref(&tape)).unwrap();
        for [p0, p1, q0, q1, u0, s1] in points {
            let (constants, state, input) = ([p0, p1], [q0, q1, u0], [0.0, s1, 0.0, 0.0]);
            let expected = tape.evaluate(&tape::TapeArguments {
                constants: &constants, state: &state, input, extra: &[],
            });
            let mut out = vec![0.0; nodes.len()];
            let given = Arguments { constants: &constants, state: &state, input: &input, extra: &[] };
            native.call(0, &given, &mut out);
            prop_assert_eq!(bits(&out), bits(&expected));
        }
    }
}

const CONSTANTS: [f64; 8] = [0.4, 0.2, 0.03, 0.01, 6.2, 4e3, 1.0, 2.0];

/// Asserts that tapes and their machine code agree at 500 places, with `extra` arguments there.
#[track_caller]
fn check_model(tapes: &[Tape], extra: impl Fn(f64) -> Vec<f64>) {
    let native = compile(tapes).unwrap();
    assert_eq!(native.len(), tapes.len());
    for n in 0..500_u32 {
        let n = f64::from(n);
        let state = [(0.37 * n).sin(), (0.73 * n).sin() * 0.9, (0.11 * n).sin() * 8.0, 3.0];
        let (input, extra) = ([(0.21 * n).sin(), 0.7, -2.0, 1.0], &extra(n)[..]);
        let given = Arguments { constants: &CONSTANTS, state: &state, input: &input, extra };
        for (number, tape) in (0..).zip(tapes) {
            let constants = &CONSTANTS;
            let of_tape = tape::TapeArguments { constants, state: &state, input, extra };
            let expected = tape.evaluate(&of_tape);
            let mut out = vec![0.0; expected.len()];
            native.call(number, &given, &mut out);
            assert_eq!(bits(&out), bits(&expected), "function {number}");
        }
    }
}

#[test]
fn a_whole_model_gives_the_tapes_bits() {
    check_model(&lever::functions(), |n| vec![n]);
}

#[test]
fn short_arguments_give_no_number_and_read_nothing() {
    let native = compile(&lever::functions()).unwrap();
    let given = Arguments { constants: &CONSTANTS[..3], state: &[], input: &[0.0; 4], extra: &[] };
    let mut out = [0.0; 4];
    native.call(1, &given, &mut out);
    assert!(out.iter().all(|it| it.is_nan()));
    let mut short = [0.0; 1];
    let state = [0.0; 4];
    native.call(1, &Arguments { constants: &CONSTANTS, state: &state, ..given }, &mut short);
    assert!(short[0].is_nan());
    let mut kept = [7.0; 4];
    native.call(999, &given, &mut kept);
    assert_eq!(bits(&kept), bits(&[7.0; 4]));
}

#[test]
fn a_tape_that_is_no_straight_line_is_refused() {
    let loops = Tape {
        instructions: vec![Instruction::Number(1.0), Instruction::Add(TapeSlot(0), TapeSlot(1))],
        outputs: vec![TapeSlot(1)],
    };
    assert!(matches!(compile(&[loops]), Err(NativeError::Order { function: 0 })));
    let beyond = Tape { instructions: vec![], outputs: vec![TapeSlot(0)] };
    assert!(matches!(compile(&[beyond]), Err(NativeError::Order { function: 0 })));
}

#[test]
fn copies_keep_the_code_alive_on_other_threads() {
    let native = compile(&lever::functions()).unwrap();
    let copy = native.clone();
    drop(native);
    let threads: Vec<_> = (0..4_u32)
        .map(|thread| {
            let native = copy.clone();
            std::thread::spawn(move || {
                let state = [f64::from(thread), 0.5, 1.0, 2.0];
                let input = [1.0, 0.0, 0.0, 0.0];
                let given =
                    Arguments { constants: &CONSTANTS, state: &state, input: &input, extra: &[] };
                let mut out = [0.0];
                native.call(2, &given, &mut out);
                out[0]
            })
        })
        .collect();
    drop(copy);
    for (thread, found) in (0..4_u32).zip(threads) {
        let expected = 6.2 * (1.0 - f64::from(thread));
        assert!((found.join().unwrap() - expected).abs() < 1e-12);
    }
}

#[test]
fn more_code_than_can_be_played_is_refused() {
    let of = |length: usize| Tape {
        instructions: (0..length).map(|n| Instruction::Number(n as f64)).collect(),
        outputs: vec![TapeSlot(0)],
    };
    assert!(compile(&[of(MAX_INSTRUCTIONS)]).is_ok());
    let refused = compile(&[of(MAX_INSTRUCTIONS), of(1)]);
    assert!(matches!(refused, Err(NativeError::TooMany { .. })), "{refused:?}");
    let cancelled = compile_unless_cancelled(&[of(1)], &true.into());
    assert!(matches!(cancelled, Err(NativeError::Cancelled)), "{cancelled:?}");
}
