use crate::dense::Polynomial;
use crate::state::State;
use crate::stepper::{EndDerivative, Field, Step, Stepper};

/// Order 5 with an embedded estimate of order 4, in 7 evaluations, 6 after the first.
///
/// Dense output: the pair's own interpolant of order 4 from the same stages, so that locating an
/// event costs no derivative; its local error h⁵ keeps event times at order 5. First-same-as-last:
/// the derivative at the end is carried, and void after a reset, a jump of the input, or a change
/// of the mode.
///
/// Stability: h |λ| < 3.5 for damped motion; undamped motion loses amplitude up to h ω = 0.4 and
/// gains it beyond, 1e-4 in a step of 1 rad. Choose it for smooth modes where RK4's step would have
/// to be cut: per evaluation it is the most accurate of the explicit methods here.
///
/// `[Tsi11]` table 1 and the interpolant after it; the weights of the error are those of its
/// fourth-order formula, with the sign that makes their sum zero.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Tsitouras5;

/// Nodes of the stages 2 to 5; the last two are at 1.
const C: [f64; 4] = [0.161, 0.327, 0.9, 0.980_025_540_904_509_7];

/// Weights of the derivatives before each stage, from the second on; the last row ends the step.
const A: [&[f64]; 6] = [
    &[0.161],
    &[-0.008_480_655_492_356_989, 0.335_480_655_492_357],
    &[2.897_153_057_105_493_5, -6.359_448_489_975_075, 4.362_295_432_869_581_5],
    &[
        5.325_864_828_439_257,
        -11.748_883_564_062_828,
        7.495_539_342_889_836_5,
        -0.092_495_066_361_755_25,
    ],
    &[
        5.861_455_442_946_42,
        -12.920_969_317_847_11,
        8.159_367_898_576_159,
        -0.071_584_973_281_401,
        -0.028_269_050_394_068_383,
    ],
    &[
        0.096_460_766_818_065_23,
        0.01,
        0.479_889_650_414_499_6,
        1.379_008_574_103_742,
        -3.290_069_515_436_081,
        2.324_710_524_099_774,
    ],
];

const E: [f64; 7] = [
    -0.001_780_011_052_225_777,
    -0.000_816_434_459_656_746_9,
    0.007_880_878_010_261_995,
    -0.144_711_007_173_262_9,
    0.582_357_165_452_555_2,
    -0.458_082_105_929_186_97,
    1.0 / 66.0,
];

/// Weights of the dense output from τ² on, stage by stage; τ has only the first stage.
const D: [[f64; 3]; 7] = [
    [-2.763_706_197_274_826, 2.913_255_461_821_912_6, -1.053_088_497_729_021_6],
    [0.1317, -0.2234, 0.1017],
    [3.930_296_236_894_751_6, -5.941_033_872_131_505, 2.490_627_285_651_253],
    [-12.411_077_166_933_676, 30.338_188_630_282_32, -16.548_102_889_244_902],
    [37.509_313_416_511_04, -88.178_904_894_766_4, 47.379_521_962_819_28],
    [-27.896_526_289_197_286, 65.091_894_674_793_66, -34.870_657_861_496_61],
    [1.5, -4.0, 2.5],
];

impl Stepper for Tsitouras5 {
    const ORDER: u32 = 5;
    const DENSE: u32 = 4;
    const EVALUATIONS: u32 = 7;
    const NAME: &'static str = "tsitouras5";

    type Memory<S: State> = EndDerivative<S>;
    type Dense<S: State> = Polynomial<S, 5>;

    #[inline]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut EndDerivative<S>,
        h: f64,
    ) -> Step<S, Polynomial<S, 5>> {
        let k1 = memory.0.unwrap_or_else(|| field.derivative(0.0, x0));
        let mut k = [k1; 7];
        for (stage, node) in C.into_iter().chain([1.0]).enumerate() {
            let x = x0.plus(h, &weighted(A[stage], &k));
            k[stage + 1] = field.derivative(node, &x);
        }
        let x1 = x0.plus(h, &weighted(A[5], &k));
        k[6] = field.derivative(1.0, &x1);
        memory.0 = Some(k[6]);
        let [c2, c3, c4] = [0, 1, 2].map(|power| weighted(&D.map(|d| d[power]), &k).times(h));
        let dense = Polynomial::new([*x0, k1.times(h), c2, c3, c4], x1);
        Step::new(dense).with_error(weighted(&E, &k).times(h))
    }
}

#[inline]
fn weighted<S: State>(weights: &[f64], k: &[S; 7]) -> S {
    weights.iter().zip(k).fold(S::ZERO, |sum, (weight, k)| sum.plus(*weight, k))
}
