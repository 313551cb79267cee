//! Calls of machine code: the only unsafe code of described models.
//!
//! The contract of an [`Entry`]: [`compile`](crate::native::compile) made its code from a tape, so
//! that it reads at most `counts` numbers behind each address, writes `outputs` numbers behind the
//! last, and does nothing else. The caller compares these lengths with its slices first.
#![expect(unsafe_code, reason = "machine code made at run time cannot be called without it")]

use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use crate::expressions::tape::{ArgumentCounts, Tape};
use cranelift_jit::JITModule;
use instruments::equations::table::{Arguments, FunctionId, Functions};

/// Function of the addresses of constants, state, input, extra and out.
type Code = unsafe extern "C" fn(*const f64, *const f64, *const f64, *const f64, *mut f64);

#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry {
    code: Code,
    counts: ArgumentCounts,
    outputs: usize,
}

impl Entry {
    pub(crate) fn new(code: *const u8, tape: &Tape) -> Self {
        // SAFETY: `compile` made the code with this signature, and gives no null address.
        let code = unsafe { core::mem::transmute::<*const u8, Code>(code) };
        Self { code, counts: tape.argument_counts(), outputs: tape.outputs.len() }
    }

    const fn fits(&self, arguments: &Arguments<'_>, out: &[f64]) -> bool {
        arguments.constants.len() >= self.counts.constants
            && arguments.state.len() >= self.counts.state
            && arguments.input.len() >= self.counts.input
            && arguments.extra.len() >= self.counts.extra
            && out.len() >= self.outputs
    }

    fn call(&self, arguments: &Arguments<'_>, out: &mut [f64]) {
        if !self.fits(arguments, out) {
            out.fill(f64::NAN);
            return;
        }
        // SAFETY: the lengths were compared just now, the memory of the code lives as long as
        // `NativeFunctions`, which alone calls this, and `out` overlaps nothing.
        unsafe {
            (self.code)(
                arguments.constants.as_ptr(),
                arguments.state.as_ptr(),
                arguments.input.as_ptr(),
                arguments.extra.as_ptr(),
                out.as_mut_ptr(),
            );
        }
    }
}

/// Functions of a model in machine code.
///
/// Copies share the code, and each keeps it alive: it is freed with the last one, which should not happen in the tick. A model at run time holds one for
/// as long as it can be stepped; no address leaves this type.
#[derive(Clone)]
pub struct NativeFunctions {
    // Before the memory, so that no freed code can be called.
    entries: Arc<[Entry]>,
    _memory: Arc<CodeMemory>,
}

impl NativeFunctions {
    pub(crate) fn new(module: JITModule, entries: Arc<[Entry]>) -> Self {
        Self { entries, _memory: Arc::new(CodeMemory { module: Mutex::new(Some(module)) }) }
    }

    pub fn len(&self) -> usize {
        self.entries.len()
    }

    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }
}

impl Functions for NativeFunctions {
    #[inline]
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        if let Some(entry) = self.entries.get(usize::from(function)) {
            entry.call(arguments, out);
        }
    }
}

impl fmt::Debug for NativeFunctions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("NativeFunctions").field("len", &self.len()).finish_non_exhaustive()
    }
}

/// Memory of the code; the lock only satisfies the compiler, since only drop takes it.
struct CodeMemory {
    module: Mutex<Option<JITModule>>,
}

impl Drop for CodeMemory {
    fn drop(&mut self) {
        let module = self.module.get_mut().unwrap_or_else(PoisonError::into_inner).take();
        if let Some(module) = module {
            // SAFETY: every entry that could call the code is gone: each copy of
            // `NativeFunctions` holds this memory, and addresses do not leave it.
            unsafe { module.free_memory() };
        }
    }
}
