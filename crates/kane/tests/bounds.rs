//! Bounds over a step, against what expressions do along random orbits.
//!
//! Steps are random cubics from random places: what holds along them holds along any method's
//! dense output.
#![expect(
    clippy::unwrap_used,
    clippy::float_cmp,
    clippy::large_stack_frames,
    clippy::print_stdout,
    reason = "a test fails aloud, and bits are what is compared"
)]

use equations::ModeNumber;
use kane::graph::{BinaryFunction, Graph, Node, UnaryFunction};
use pode::input::Cubic;
use pode::{
    Dense as _, DenseBounds, Enclosure, GuardBound, GuardId, GuardSpec, Guarded, Motion,
    Polynomial, Signal as _,
};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use hand_written::{KeyHammerSprings, ReducedGrand};
use models::Described as _;

use crate::by_hand::{Described, Draft, guard, key_hammer, lift_off, model};

/// Looks at each guard over one step.
const LOOKS: usize = 64;

/// A step: a cubic for each entry of the state, and one for the input.
#[derive(Clone, Debug)]
struct Motions<const N: usize> {
    h: f64,
    orbit: Polynomial<[f64; N], 4>,
    input: Cubic,
    start: [f64; N],
}

impl<const N: usize> Motions<N> {
    fn new(h: f64, terms: [[f64; N]; 4], input: [f64; 4]) -> Self {
        let end = core::array::from_fn(|i| terms.iter().map(|term| term[i]).sum());
        let orbit = Polynomial::new(terms, end);
        Self { h, orbit, input: Cubic::new(input, h), start: terms[0] }
    }

    fn enclosure(&self) -> Enclosure<[f64; N], Motion> {
        let DenseBounds { moves, speeds, bends } = self.orbit.bounds().unwrap();
        let (input_start, input) = (self.input.at(0.0), self.input.bound(0.0, 1.0));
        Enclosure { h: self.h, start: self.start, moves, speeds, bends, input_start, input }
    }

    /// What a guard is at each look.
    fn values<M>(&self, model: &M, mode: M::Mode, id: GuardId) -> Vec<f64>
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

    /// How far a guard goes and bends, as it is seen; none where it is no number.
    fn seen<M>(&self, model: &M, mode: M::Mode, id: GuardId) -> Option<[f64; 3]>
    where
        M: Guarded<State = [f64; N], Input = Motion>,
    {
        let values = self.values(model, mode, id);
        let square = (LOOKS * LOOKS) as f64;
        let moved = values.iter().map(|value| (value - values[0]).abs()).fold(0.0, f64::max);
        let second = |w: &[f64]| square * (w[2] - 2.0 * w[1] + w[0]).abs();
        let bent = values.windows(3).map(second).fold(0.0, f64::max);
        let size = values.iter().map(|value| value.abs()).fold(0.0, f64::max);
        values.iter().all(|it| it.is_finite()).then_some([moved, bent, size])
    }
}

/// What is put on a stack of expressions, by its number and a constant.
type Code = (u8, f64);

/// An expression from a list of codes: a stack machine that always has operands. What each code
/// gives is larger and smaller in turn by the fraction `shake`.
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

/// A function of one node.
fn one_of(graph: &mut Graph, code: u8, x: Node, number: f64) -> Node {
    use UnaryFunction::{
        Abs, Acos, Asin, Cos, Exp, Ln, Logistic, Sign, Sin, Softplus, SoftplusArea,
        SoftplusSquareArea, Sqrt, Tanh,
    };
    let all = [
        Sin,
        Cos,
        Tanh,
        Exp,
        Ln,
        Sqrt,
        Abs,
        Sign,
        Softplus,
        Logistic,
        SoftplusArea,
        SoftplusSquareArea,
        Asin,
        Acos,
    ];
    match code {
        0..=13 => graph.unary(all[usize::from(code)], x),
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

/// A function of two nodes.
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

/// A model whose only guard is the expression.
fn guarded(codes: &[Code]) -> Described<4, 2048> {
    shaken(codes, 0.0)
}

/// The same with each of its parts off by a fraction.
fn shaken(codes: &[Code], shake: f64) -> Described<4, 2048> {
    let mut draft = Draft::new(&[("p", 0.7)], &["x", "y"]);
    let value = expression(&mut draft, codes, shake);
    let zero = draft.graph().constant(0.0);
    let same = draft.same();
    let mode = draft.mode("only", &[zero; 4]);
    mode.guards = vec![guard("any", [value, zero], Draft::way(0, &same, zero))];
    model(draft.program(), &[])
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

/// How far rounding may put the values of an expression off over a step: what small errors of all
/// its parts make of them. It is 1e-11 for asin(cos(1e-5)), each of which is good to 1e-16.
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

/// Checks that an expression goes and bends no further over a step than `model`'s bound of it.
fn check(
    model: &Described<4, 2048>,
    codes: &[Code],
    step: &Motions<4>,
) -> Result<(), TestCaseError> {
    let Some([moved, bent, size]) = step.seen(model, ModeNumber(0), GuardId(0)) else {
        return Ok(());
    };
    // Beyond this it is mostly rounding: 1/softplus(−34), whose value has but one digit.
    if size > 1e6 {
        return Ok(());
    }
    let bound = model.guard_bound(ModeNumber(0), GuardId(0), &step.enclosure());
    let square = (LOOKS * LOOKS) as f64;
    let is_within = |off: f64| {
        moved <= bound.moves * (1.0 + 1e-9) + off
            && bent <= bound.bend * (1.0 + 1e-9) + 4.0 * square * off
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

/// Lists of codes of expressions.
fn expressions() -> impl Strategy<Value = Vec<Code>> {
    prop::collection::vec((0_u8..60, -2.0..2.0_f64), 1..14)
}

proptest! {
    // The same cases in each run.
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

proptest! {
    #[test]
    #[ignore = "other cases in each run, as many as PROPTEST_CASES says"]
    fn no_other_expression_goes_or_bends_further_than_its_bound(
        codes in expressions(),
        steps in prop::collection::vec(step(), 4),
    ) {
        let model = guarded(&codes);
        for step in steps {
            check(&model, &codes, &step)?;
        }
    }
}

/// x + asin(cos(u)) is x + π/2 − u, whose values have no rounding to speak of, for a u of 1e-5.
#[test]
fn the_bound_of_an_angle_near_its_end_is_that_of_the_angle() {
    let angle = [(18, 0.0), (0, 0.0), (21, 0.0), (26, 0.0), (49, 0.0)];
    let turned = [angle.as_slice(), &[(11, 0.0), (22, 0.0)]].concat();
    let less = [angle.as_slice(), &[(30, -1.0)]].concat();
    let mut terms = [[0.0; 4]; 4];
    (terms[0][0], terms[2][0]) = (-0.986_917_480_247_106_5, -5.764_345_029_859_998e-4);
    let step = Motions::new(0.01, terms, [0.0; 4]);
    let only = (ModeNumber(0), GuardId(0));
    let [moved, bent, _] = step.seen(&guarded(&less), only.0, only.1).unwrap();
    let bound = guarded(&turned).guard_bound(only.0, only.1, &step.enclosure());
    assert!(moved <= bound.moves && bound.moves < 1.001 * moved, "{moved:e}, {bound:?}");
    assert!(bent <= bound.bend && bound.bend < 1.001 * bent, "{bent:e}, {bound:?}");
    // What is seen of the other is off by its rounding, which is known.
    let [_, rough, _] = step.seen(&guarded(&turned), only.0, only.1).unwrap();
    let off = 4.0 * (LOOKS * LOOKS) as f64 * rounding(&turned, &step);
    assert!((rough - bent).abs() > 1e-8 && (rough - bent).abs() < off, "{rough:e}, {off:e}");
    check(&guarded(&turned), &turned, &step).unwrap();
}

/// The middle of a list.
fn median(mut list: Vec<f64>) -> f64 {
    list.sort_by(f64::total_cmp);
    list[list.len() / 2]
}

/// A number in −1 .. 1 that looks random and is the same in every run.
fn next(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// A step near `x` as a key is played: all entries move, none of them wildly.
fn played(x: [f64; 4], travel: f64, seed: &mut u64) -> Motions<4> {
    let h = 10.0_f64.powf(-3.5 + 0.8 * next(seed));
    let wild = 10.0_f64.powf(-1.25 + 0.75 * next(seed));
    let input = core::array::from_fn(|power| {
        let fast = (100.0 * h).powi(i32::try_from(power).unwrap());
        travel * fast * (0.25 + 0.75 * next(seed)) * if power > 0 { wild } else { 1.0 }
    });
    let terms = core::array::from_fn(|power| {
        core::array::from_fn(|entry| {
            let fast = if entry < 2 { 1.0 } else { 30.0 };
            let steps = (100.0 * h).powi(i32::try_from(power).unwrap());
            let near = if power == 0 { x[entry] } else { 0.0 };
            near + fast * wild * steps * 0.01 * (0.25 + 0.75 * next(seed))
        })
    });
    Motions::new(h, terms, input)
}

/// How much wider than what is seen, and than the hand-written ones, bounds are in the middle.
#[test]
fn the_bounds_of_model_b_are_as_tight_as_the_hand_written_ones() {
    let mut seed = 5;
    for preset in [0, 2] {
        let of =
            |index: usize| (KeyHammerSprings::default().entry().presets[preset].value)(index, 30);
        let values: Vec<f64> = (0..key_hammer::NAMES.len()).map(of).collect();
        let described: Described<4> = model(key_hammer::program(), &values);
        let written = KeyHammerSprings::default().with_values(&values);
        for ((mode, name), number) in written.modes().zip(0..) {
            for spec in written.guards(mode) {
                let label = format!("{preset} {name} {}", spec.name);
                let own = (&described, ModeNumber(number));
                check_tight(&label, own, (&written, mode), spec, &mut seed);
            }
        }
    }
}

/// Compares the bounds of one guard with the hand-written ones, and with what is seen.
fn check_tight(
    label: &str,
    (described, number): (&Described<4>, ModeNumber),
    (written, mode): (&KeyHammerSprings, hand_written::key_hammer_springs::Mode),
    spec: &GuardSpec,
    seed: &mut u64,
) {
    let own = described.guards(number).iter().find(|it| it.name == spec.name).unwrap();
    let rest = described.at_rest(&Motion::default()).1;
    let travel = 0.01 * described.input_per_metre();
    let mut ratios = [const { Vec::new() }; 4];
    for _ in 0..2000 {
        let step = played(rest, travel, seed);
        let over = step.enclosure();
        let GuardBound { moves, bend } = described.guard_bound(number, own.id, &over);
        let hand = written.guard_bound(mode, spec.id, &over);
        let [moved, bent, _] = step.seen(written, mode, spec.id).unwrap();
        let all = [moves / hand.moves, bend / hand.bend, moves / moved, bend / bent];
        ratios.iter_mut().zip(all).for_each(|(ratios, ratio)| ratios.push(ratio));
    }
    let found = ratios.map(median);
    println!("{label}: {found:.2?}");
    assert!(found[0] < 1.05 && found[1] < 1.05, "{label}: {found:?}");
    assert!(found[2] < 4.0 && found[3] < 4.0, "{label}: {found:?}");
}

#[test]
fn the_bound_of_a_force_of_felts_is_as_tight_as_the_hand_written_one() {
    let mut seed = 7;
    let entry = ReducedGrand::default().entry();
    let of = |index: usize| (entry.presets[0].value)(index, 40);
    let values: Vec<f64> = (0..entry.parameters.len()).map(of).collect();
    let described: Described<4, 256> = model(lift_off::program(), &values);
    let written = ReducedGrand::default().with_values(&values);
    let (mode, _) = written.at_rest(&Motion::default());
    let mut ratios = [const { Vec::new() }; 4];
    for place in [-1e-4, 0.004, 0.008, 0.0102] {
        for _ in 0..2000 {
            let step = played([place, 0.0, 0.0, 0.0], place, &mut seed);
            let over = step.enclosure();
            let [moved, bent, _] = step.seen(&described, ModeNumber(0), GuardId(0)).unwrap();
            let [same, _, _] = step.seen(&written, mode, GuardId(0)).unwrap();
            assert!((moved - same).abs() < 1e-9 * (1.0 + same), "{moved} is not {same}");
            let GuardBound { moves, bend } =
                described.guard_bound(ModeNumber(0), GuardId(0), &over);
            let hand = written.guard_bound(mode, GuardId(0), &over);
            assert!(moved <= moves * (1.0 + 1e-9), "{moved} beyond {moves}");
            ratios[0].push(moves / hand.moves);
            ratios[1].push(if bend == hand.bend { 1.0 } else { bend / hand.bend });
            ratios[2].push(moves / moved);
            ratios[3].push(bend / bent);
        }
    }
    let found = ratios.map(median);
    println!("lift-off: {found:.2?}");
    assert!(found[0] < 1.05 && found[1] < 1.05 && found[2] < 4.0 && found[3] < 6.0, "{found:?}");
}
