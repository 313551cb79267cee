use crate::expressions::graph::{BinaryFunction, UnaryFunction};
use cranelift_codegen::ir::{AbiParam, Signature, types::F64};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{FuncId, Module as _};
use instruments::equations::functions;
use pode::math;

use crate::native::NativeError;

type UnaryCallee = extern "C" fn(f64) -> f64;
type BinaryCallee = extern "C" fn(f64, f64) -> f64;

macro_rules! unary {
    ($($name:ident = $function:path;)+) => {$(
        extern "C" fn $name(x: f64) -> f64 {
            $function(x)
        }
    )+};
}

macro_rules! binary {
    ($($name:ident = $function:path;)+) => {$(
        extern "C" fn $name(x: f64, y: f64) -> f64 {
            $function(x, y)
        }
    )+};
}

unary! {
    tanh = math::tanh;
    exp = math::exp;
    ln = math::ln;
    asin = math::asin;
    acos = math::acos;
    softplus = functions::softplus;
    logistic = functions::logistic;
    softplus_area = functions::softplus_area;
    softplus_square_area = functions::softplus_square_area;
}

binary! {
    atan2 = math::atan2;
    hypot = math::hypot;
    powf = math::powf;
}

extern "C" fn sin_cos(x: f64, out: &mut [f64; 2]) {
    let (sine, cosine) = math::sin_cos(x);
    *out = [sine, cosine];
}

extern "C" fn sin_cos_of_two(x: f64, y: f64, out: &mut [f64; 4]) {
    let ([a, b], [c, d]) = math::sin_cos_of_two([x, y]);
    *out = [a, b, c, d];
}

const UNARY: [(UnaryFunction, &str, UnaryCallee); 9] = [
    (UnaryFunction::Tanh, "tanh", tanh),
    (UnaryFunction::Exp, "exp", exp),
    (UnaryFunction::Ln, "ln", ln),
    (UnaryFunction::Asin, "asin", asin),
    (UnaryFunction::Acos, "acos", acos),
    (UnaryFunction::Softplus, "softplus", softplus),
    (UnaryFunction::Logistic, "logistic", logistic),
    (UnaryFunction::SoftplusArea, "softplus_area", softplus_area),
    (UnaryFunction::SoftplusSquareArea, "softplus_square_area", softplus_square_area),
];

const BINARY: [(BinaryFunction, &str, BinaryCallee); 3] = [
    (BinaryFunction::Atan2, "atan2", atan2),
    (BinaryFunction::Hypot, "hypot", hypot),
    (BinaryFunction::Power, "powf", powf),
];

const SIN_COS: &str = "sin_cos";
const SIN_COS_OF_TWO: &str = "sin_cos_of_two";

pub(crate) fn register(builder: &mut JITBuilder) {
    for (_, name, function) in UNARY {
        builder.symbol(name, function as *const u8);
    }
    for (_, name, function) in BINARY {
        builder.symbol(name, function as *const u8);
    }
    builder.symbol(SIN_COS, sin_cos as *const u8);
    builder.symbol(SIN_COS_OF_TWO, sin_cos_of_two as *const u8);
}

#[derive(Debug)]
pub(crate) struct Callees {
    unary: Vec<(UnaryFunction, FuncId)>,
    binary: Vec<(BinaryFunction, FuncId)>,
    /// Sine and cosine of one angle, and of two.
    pub(crate) sin_cos: [FuncId; 2],
}

impl Callees {
    pub(crate) fn declare(module: &mut JITModule) -> Result<Self, NativeError> {
        let mut unary = Vec::new();
        for (function, name, _) in UNARY {
            let signature = returning(module, 1);
            unary.push((function, crate::native::import(module, name, &signature)?));
        }
        let mut binary = Vec::new();
        for (function, name, _) in BINARY {
            let signature = returning(module, 2);
            binary.push((function, crate::native::import(module, name, &signature)?));
        }
        let (one, two) = (writing(module, 1), writing(module, 2));
        let sin_cos = [
            crate::native::import(module, SIN_COS, &one)?,
            crate::native::import(module, SIN_COS_OF_TWO, &two)?,
        ];
        Ok(Self { unary, binary, sin_cos })
    }

    pub(crate) fn unary(&self, function: UnaryFunction) -> Option<FuncId> {
        self.unary.iter().find(|it| it.0 == function).map(|it| it.1)
    }

    pub(crate) fn binary(&self, function: BinaryFunction) -> Option<FuncId> {
        self.binary.iter().find(|it| it.0 == function).map(|it| it.1)
    }
}

fn returning(module: &JITModule, arguments: usize) -> Signature {
    let mut signature = module.make_signature();
    signature.params.extend(core::iter::repeat_n(AbiParam::new(F64), arguments));
    signature.returns.push(AbiParam::new(F64));
    signature
}

/// Returns the signature of a function of numbers that writes through its last argument.
fn writing(module: &JITModule, arguments: usize) -> Signature {
    let mut signature = module.make_signature();
    signature.params.extend(core::iter::repeat_n(AbiParam::new(F64), arguments));
    signature.params.push(AbiParam::new(module.target_config().pointer_type()));
    signature
}
