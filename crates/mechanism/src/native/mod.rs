//! Machine code of straight-line programs, compiled at run time.
//!
//! [`compile`] turns each [`Tape`] into a function of this machine by Cranelift, with the bits of
//! [`Tape::evaluate`]: no operation is reordered, and elementary functions are the same Rust
//! functions. Compiling allocates and takes milliseconds, so it is not for the tick; calling is.

mod arithmetic;
mod call;
mod functions;
mod translate;

pub use call::NativeFunctions;

use std::cell::Cell;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::expressions::tape::Tape;
use cranelift_codegen::settings::{self, Configurable as _};
use cranelift_codegen::{Context, ir};
use cranelift_frontend::FunctionBuilderContext;
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{FuncId, Linkage, Module as _, ModuleError};

use self::call::Entry;
use self::functions::Callees;

/// Most instructions of all functions, compiled in about a second; the largest model has a tenth.
pub const MAX_INSTRUCTIONS: usize = 150_000;

/// Instructions of a function from which on registers are allocated in one pass: the time of the
/// better allocation grows with the square of a function's length.
const LONG: usize = 4_096;

/// Reason for missing machine code.
#[derive(Debug, thiserror::Error)]
pub enum NativeError {
    #[error("no machine code can be made for this processor: {0}")]
    Machine(&'static str),
    #[error("a value of function {function} is used before it is computed")]
    Order { function: usize },
    #[error("the code generator failed: {0}")]
    Generator(#[from] Box<ModuleError>),
    #[error("its functions have {found} instructions, more than {MAX_INSTRUCTIONS}")]
    TooMany { found: usize },
    #[error("it was cancelled before its end")]
    Cancelled,
    #[error("a setting of the code generator is unknown: {0}")]
    Setting(#[from] settings::SetError),
}

impl From<ModuleError> for NativeError {
    fn from(error: ModuleError) -> Self {
        Self::Generator(Box::new(error))
    }
}

thread_local! {
    static COMPILED: Cell<usize> = const { Cell::new(0) };
}

/// Returns the number of functions that this thread has compiled so far.
pub fn compiled_functions() -> usize {
    COMPILED.get()
}

/// Returns machine code of `functions`, each under its index.
///
/// # Errors
/// A processor that the code generator does not support, a tape with operands after their use, more
/// than [`MAX_INSTRUCTIONS`], or no memory for code.
pub fn compile(functions: &[Tape]) -> Result<NativeFunctions, NativeError> {
    compile_unless_cancelled(functions, &AtomicBool::new(false))
}

/// Like [`compile`], but ends early once `is_cancelled` is set.
///
/// # Errors
/// Those of [`compile`]; cancellation.
pub fn compile_unless_cancelled(
    functions: &[Tape],
    is_cancelled: &AtomicBool,
) -> Result<NativeFunctions, NativeError> {
    let found = functions.iter().map(|tape| tape.instructions.len()).sum();
    if found > MAX_INSTRUCTIONS {
        return Err(NativeError::TooMany { found });
    }
    let longest = functions.iter().map(|tape| tape.instructions.len()).max();
    let mut module = module(longest.unwrap_or(0))?;
    let callees = Callees::declare(&mut module)?;
    let mut context = module.make_context();
    let mut builder = FunctionBuilderContext::new();
    let mut ids = Vec::with_capacity(functions.len());
    for (function, tape) in functions.iter().enumerate() {
        if is_cancelled.load(Ordering::Relaxed) {
            return Err(NativeError::Cancelled);
        }
        if !tape.is_ordered() {
            return Err(NativeError::Order { function });
        }
        ids.push(define(&mut module, &callees, &mut context, &mut builder, tape)?);
    }
    module.finalize_definitions()?;
    COMPILED.set(COMPILED.get() + functions.len());
    let entries = ids
        .iter()
        .zip(functions)
        .map(|(id, tape)| Entry::new(module.get_finalized_function(*id), tape))
        .collect();
    Ok(NativeFunctions::new(module, entries))
}

fn module(longest: usize) -> Result<JITModule, NativeError> {
    let mut flags = settings::builder();
    flags.set("opt_level", "speed")?;
    if longest > LONG {
        flags.set("regalloc_algorithm", "single_pass")?;
    }
    flags.set("is_pic", "false")?;
    flags.set("use_colocated_libcalls", "false")?;
    flags.set("enable_verifier", if cfg!(debug_assertions) { "true" } else { "false" })?;
    let machine = cranelift_native::builder().map_err(NativeError::Machine)?;
    let machine = machine
        .finish(settings::Flags::new(flags))
        .map_err(|_error| NativeError::Machine("its features do not fit together"))?;
    let mut builder = JITBuilder::with_isa(machine, cranelift_module::default_libcall_names());
    functions::register(&mut builder);
    Ok(JITModule::new(builder))
}

fn define(
    module: &mut JITModule,
    callees: &Callees,
    context: &mut Context,
    builder: &mut FunctionBuilderContext,
    tape: &Tape,
) -> Result<FuncId, NativeError> {
    module.clear_context(context);
    context.func.signature = signature(module);
    translate::translate(tape, module, callees, &mut context.func, builder);
    let id = module.declare_anonymous_function(&context.func.signature)?;
    module.define_function(id, context)?;
    Ok(id)
}

/// Returns the signature: addresses of constants, state, input, extra and out; see [`call`].
fn signature(module: &JITModule) -> ir::Signature {
    let pointer = module.target_config().pointer_type();
    let mut signature = module.make_signature();
    signature.params.extend([ir::AbiParam::new(pointer); 5]);
    signature
}

fn import(
    module: &mut JITModule,
    name: &str,
    signature: &ir::Signature,
) -> Result<FuncId, NativeError> {
    Ok(module.declare_function(name, Linkage::Import, signature)?)
}
