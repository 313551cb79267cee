use crate::dense::Cubic;
use crate::state::State;
use crate::stepper::rosenbrock::{Tableau, weighted};
use crate::stepper::time_slope::time_slope;
use crate::stepper::{Field, Step, Stepper};

/// Order 4, linearly implicit: 9 evaluations, one Jacobian, one LU, an estimate of order 3.
///
/// Six evaluations are for the stages and three for ∂f/∂t, by a difference of third order. Dense
/// output: the pair's own of order 3 from the same stages; its local error h⁴ keeps event times at
/// order 4. Nothing is carried to the next step.
///
/// Stability: L-stable and stiffly accurate, as its embedded method is. Choose it for stiff modes
/// that must be followed closely: at an error of 1e-4 and below it is the cheapest implicit method
/// here. `[HW96]` VI.4, and its code RODAS: coefficients of METH 1 and the dense output.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Rodas4;

const TABLEAU: Tableau<6> = Tableau {
    gamma: 0.25,
    nodes: [0.0, 0.386, 0.21, 0.63, 1.0, 1.0],
    a: [
        [0.0; 6],
        [1.544, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.946_678_528_081_582_6, 0.255_701_169_898_328_4, 0.0, 0.0, 0.0, 0.0],
        [3.314_825_187_068_521, 2.896_124_015_972_201, 0.998_641_913_997_781_7, 0.0, 0.0, 0.0],
        [A5[0], A5[1], A5[2], A5[3], 0.0, 0.0],
        [A5[0], A5[1], A5[2], A5[3], 1.0, 0.0],
    ],
    c: [
        [0.0; 6],
        [-5.6688, 0.0, 0.0, 0.0, 0.0, 0.0],
        [-2.430_093_356_833_875, -0.206_359_915_709_191_5, 0.0, 0.0, 0.0, 0.0],
        [-0.107_352_905_815_137_5, -9.594_562_251_023_355, -20.470_286_148_096_16, 0.0, 0.0, 0.0],
        [
            7.496_443_313_967_647,
            -10.246_804_314_643_52,
            -33.999_903_528_199_05,
            11.708_908_932_061_6,
            0.0,
            0.0,
        ],
        [
            8.083_246_795_921_522,
            -7.981_132_988_064_893,
            -31.521_594_328_743_71,
            16.319_305_431_231_36,
            -6.058_818_238_834_054,
            0.0,
        ],
    ],
    d: [0.25, -0.1043, 0.1035, -0.0362, 0.0, 0.0],
    at_start: 1,
};

/// Weights of the fifth stage's argument, reused by the end of the step.
const A5: [f64; 4] =
    [1.221_224_509_226_641, 6.019_134_481_288_629, 12.537_083_329_320_87, -0.687_886_036_105_895];

/// Weights of the dense output's bends, at τ (1 − τ) and at τ² (1 − τ).
const BENDS: [[f64; 6]; 2] = [
    [
        10.126_235_083_445_86,
        -7.487_995_877_610_167,
        -34.800_918_615_557_47,
        -7.992_771_707_568_823,
        1.025_137_723_295_662,
        0.0,
    ],
    [
        -0.676_280_339_280_125_3,
        6.087_714_651_680_015,
        16.430_843_208_924_78,
        24.767_225_114_183_86,
        -6.594_389_125_716_872,
        0.0,
    ],
];

impl Stepper for Rodas4 {
    const ORDER: u32 = 4;
    const DENSE: u32 = 3;
    const EVALUATIONS: u32 = 9;
    const JACOBIANS: u32 = 1;
    const NAME: &'static str = "rodas4";

    type Memory<S: State> = ();
    type Dense<S: State> = Cubic<S>;

    #[inline]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        _memory: &mut (),
        h: f64,
    ) -> Step<S, Cubic<S>> {
        let f0 = field.derivative(0.0, x0);
        let slope = time_slope::<S, 3>(field, x0, &f0);
        let u = TABLEAU.stages(field, (x0, &f0), &slope, h);
        let rise = weighted(&TABLEAU.a[5], &u).plus(1.0, &u[5]);
        let [bend, skew] = BENDS.map(|weights| weighted(&weights, &u));
        let (c1, c2, c3) = (rise.plus(1.0, &bend), skew.plus(-1.0, &bend), skew.times(-1.0));
        let dense = Cubic::cubic(*x0, c1, c2, c3, x0.plus(1.0, &rise));
        Step::new(dense).with_error(u[5])
    }
}
