//! Bounds over a step, against expressions along random orbits.
//!
//! Steps are random cubics from random states: their properties hold for the dense output of any
//! method.

use instruments::equations::ModeNumber;
use mechanism::kane::graph::{BinaryFunction, Graph, Node};
use pode::input::Cubic;
use pode::{Dense as _, DenseBounds, Enclosure, GuardId, Guarded, Motion, Polynomial, Signal as _};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use crate::expressions::common::UNARY;
use crate::kane::by_hand::{Draft, guard};
use crate::kane::runnable::{Runnable, runnable};

const LOOKS: usize = 64;
pub(super) const SQUARE: f64 = (LOOKS * LOOKS) as f64;

/// Step: a cubic for each entry of the state, and one for the input.
#[derive(Clone, Debug)]
pub(super) struct Motions<const N: usize> {
    h: f64,
    orbit: Polynomial<[f64; N], 4>,
    input: Cubic,
    start: [f64; N],
}

impl<const N: usize> Motions<N> {
    pub(super) fn new(h: f64, terms: [[f64; N]; 4], input: [f64; 4]) -> Self {
        let end = core::array::from_fn(|i| terms.iter().map(|term| term[i]).sum());
        let orbit = Polynomial::new(terms, end);
        Self { h, orbit, input: Cubic::new(input, h), start: terms[0] }
    }

    pub(super) fn enclosure(&self) -> Enclosure<[f64; N], Motion> {
        let DenseBounds { moves, speeds, bends } = self.orbit.bounds().unwrap();
        let (input_start, input) = (self.input.at(0.0), self.input.bound(0.0, 1.0));
        Enclosure { h: self.h, start: self.start, moves, speeds, bends, input_start, input }
    }

    pub(super) fn values<M>(&self, model: &M, mode: M::Mode, id: GuardId) -> Vec<f64>
    where
        M: Guarded<State = [f64; N], Input = Motion>,
    {
        let at = |look: usize| {
            let tau = look as f64 / LOOKS as f64;
            let input = self.input.at(tau);
            let x = model.constrain(mode, &self.orbit.at(tau), &input);
            model.guard(mode, id, &x, &input).value
        };
        (0..=LOOKS).map(at).collect()
    }
}

pub(super) fn seen(values: &[f64]) -> [f64; 3] {
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let second = |w: &[f64]| SQUARE * (w[2] - 2.0 * w[1] + w[0]).abs();
    [
        most(&mut values.iter().map(|value| (value - values[0]).abs())),
        most(&mut values.windows(3).map(second)),
        most(&mut values.iter().map(|value| value.abs())),
    ]
}

/// Instruction of the stack machine: its number and a constant.
type Code = (u8, f64);

/// Builds an expression by a stack machine; results are scaled up and down in turn by `shake`.
fn expression(draft: &mut Draft, codes: &[Code], shake: f64) -> Node {
    let symbols: Vec<Node> = draft.same().into_iter().chain(draft.input()).collect();
    let parameter = draft.parameter("p");
    let graph = draft.graph();
    let mut stack = vec![symbols[0], symbols[1]];
    for (index, (code, number)) in codes.iter().enumerate() {
        let top = stack.pop().unwrap_or(parameter);
        let node = match code {
            0..=9 => {
                stack.push(top);
                [symbols.as_slice(), &[parameter]].concat()[usize::from(*code) % 9]
            }
            10..=39 => one_of(graph, code - 10, top, *number),
            _ => {
                let below = stack.pop().unwrap_or(symbols[2]);
                two_of(graph, code - 40, [below, top], parameter)
            }
        };
        let by = if index % 2 == 0 { 1.0 + shake } else { 1.0 - shake };
        stack.push(graph.scale(node, by));
    }
    let terms: Vec<_> = stack.into_iter().map(|node| (node, 1.0)).collect();
    graph.sum(&terms)
}

fn one_of(graph: &mut Graph, code: u8, x: Node, number: f64) -> Node {
    match code {
        0..=13 => graph.unary(UNARY[usize::from(code)], x),
        14..=17 => graph.power(x, i32::from(code) - 12),
        18 => graph.power(x, -1),
        19 => graph.power(x, -2),
        20..=22 => graph.scale(x, number),
        23 => {
            let exponent = graph.constant(2.5);
            let zero = graph.constant(0.0);
            let above = graph.binary(BinaryFunction::Max, x, zero);
            graph.binary(BinaryFunction::Power, above, exponent)
        }
        24 => {
            let exponent = graph.constant(number);
            graph.binary(BinaryFunction::Power, x, exponent)
        }
        _ => {
            let number = graph.constant(number);
            graph.add(x, number)
        }
    }
}

fn two_of(graph: &mut Graph, code: u8, [x, y]: [Node; 2], parameter: Node) -> Node {
    match code % 10 {
        0 | 1 => graph.add(x, y),
        2 => graph.subtract(x, y),
        3 | 4 => graph.multiply(x, y),
        5 => graph.divide(x, y),
        6 => graph.binary(BinaryFunction::Atan2, x, y),
        7 => graph.binary(BinaryFunction::Hypot, x, y),
        8 => graph.binary([BinaryFunction::Min, BinaryFunction::Max][usize::from(code > 9)], x, y),
        _ => graph.select(x, y, parameter),
    }
}

fn guarded(codes: &[Code]) -> Runnable<4, 2048> {
    shaken(codes, 0.0)
}

fn shaken(codes: &[Code], shake: f64) -> Runnable<4, 2048> {
    let mut draft = Draft::new(&[("p", 0.7)], &["x", "y"]);
    let value = expression(&mut draft, codes, shake);
    let zero = draft.graph().constant(0.0);
    let same = draft.same();
    let mode = draft.mode("only", &[zero; 4]);
    mode.guards = vec![guard("any", [value, zero], Draft::way(0, &same, zero))];
    runnable(draft.program(), &[])
}

fn step() -> impl Strategy<Value = Motions<4>> {
    let number = prop_oneof![1 => Just(0.0), 3 => -1.0..1.0_f64];
    let numbers = prop::collection::vec(number, 20);
    (numbers, -4.0..0.5_f64, -4.0..-2.0_f64).prop_map(|(numbers, wild, h)| {
        let (wild, h) = (10.0_f64.powf(wild), 10.0_f64.powf(h));
        let size = |power: usize| if power == 0 { 1.0 } else { wild };
        let terms = core::array::from_fn(|power| {
            core::array::from_fn(|entry| size(power) * numbers[4 * power + entry])
        });
        let input = core::array::from_fn(|power| size(power) * numbers[16 + power]);
        Motions::new(h, terms, input)
    })
}

/// Returns the error over a step by rounding: 1e-11 for asin(cos(1e-5)), of parts good to 1e-16.
fn rounding(codes: &[Code], step: &Motions<4>) -> f64 {
    let only = (ModeNumber(0), GuardId(0));
    let exact = step.values(&guarded(codes), only.0, only.1);
    let mut most = 0.0_f64;
    for shake in [4.0 * f64::EPSILON, -4.0 * f64::EPSILON] {
        let off = step.values(&shaken(codes, shake), only.0, only.1);
        most = exact.iter().zip(off).map(|(exact, off)| (exact - off).abs()).fold(most, f64::max);
    }
    most
}

fn check(
    model: &Runnable<4, 2048>,
    codes: &[Code],
    step: &Motions<4>,
) -> Result<(), TestCaseError> {
    let values = step.values(model, ModeNumber(0), GuardId(0));
    let [moved, bent, size] = seen(&values);
    // Beyond this it is mostly rounding: 1/softplus(−34) has a single correct digit.
    if size > 1e6 || !values.iter().all(|it| it.is_finite()) {
        return Ok(());
    }
    let bound = model.guard_bound(ModeNumber(0), GuardId(0), &step.enclosure());
    let is_within = |off: f64| {
        moved <= bound.moves * (1.0 + 1e-9) + off
            && bent <= bound.bend * (1.0 + 1e-9) + 4.0 * SQUARE * off
    };
    let off = 1e-12 * (1.0 + size);
    prop_assert!(
        is_within(off) || is_within(off + rounding(codes, step)),
        "{moved:e}, {bent:e}, {bound:?} {codes:?} {:?} {:?}",
        step.orbit,
        step.input
    );
    Ok(())
}

fn expressions() -> impl Strategy<Value = Vec<Code>> {
    prop::collection::vec((0_u8..60, -2.0..2.0_f64), 1..14)
}

proptest! {
    // Every run has the same cases.
    #![proptest_config(ProptestConfig {
        cases: 512,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(1994),
        ..ProptestConfig::default()
    })]

    #[test]
    fn no_expression_goes_or_bends_further_than_its_bound(
        codes in expressions(),
        steps in prop::collection::vec(step(), 4),
    ) {
        let model = guarded(&codes);
        for step in steps {
            check(&model, &codes, &step)?;
        }
    }
}

/// x + asin(cos(u)) is x + π/2 − u, with values of negligible rounding for a u of 1e-5.
#[test]
fn the_bound_of_an_angle_near_its_end_is_that_of_the_angle() {
    let angle = [(18, 0.0), (0, 0.0), (21, 0.0), (26, 0.0), (49, 0.0)];
    let turned = [angle.as_slice(), &[(11, 0.0), (22, 0.0)]].concat();
    let less = [angle.as_slice(), &[(30, -1.0)]].concat();
    let mut terms = [[0.0; 4]; 4];
    (terms[0][0], terms[2][0]) = (-0.986_917_480_247_106_5, -5.764_345_029_859_998e-4);
    let step = Motions::new(0.01, terms, [0.0; 4]);
    let only = (ModeNumber(0), GuardId(0));
    let seen = |codes: &[Code]| seen(&step.values(&guarded(codes), only.0, only.1));
    let [moved, bent, _] = seen(&less);
    let bound = guarded(&turned).guard_bound(only.0, only.1, &step.enclosure());
    assert!(moved <= bound.moves && bound.moves < 1.001 * moved, "{moved:e}, {bound:?}");
    assert!(bent <= bound.bend && bound.bend < 1.001 * bent, "{bent:e}, {bound:?}");
    // The other is off by its rounding, which is known.
    let [_, rough, _] = seen(&turned);
    let off = 4.0 * SQUARE * rounding(&turned, &step);
    assert!((rough - bent).abs() > 1e-8 && (rough - bent).abs() < off, "{rough:e}, {off:e}");
    check(&guarded(&turned), &turned, &step).unwrap();
}
