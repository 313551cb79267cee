//! Descriptions become models that run: derived, and compiled to machine code.

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use descriptions::{DescriptionFiles, DescriptionReader, ReadModel};
use diagnostics::{Diagnostic, Diagnostics};
use kane::derive_unless_cancelled;

use native::NativeError;

use super::bases::FileBases;

/// Derives and compiles what it reads.
#[derive(Clone, Copy, Debug)]
pub(super) struct CompilingReader;

impl DescriptionReader for CompilingReader {
    fn read(
        &self,
        (path, text): (&Path, &str),
        files: &DescriptionFiles,
        is_cancelled: &Arc<AtomicBool>,
    ) -> Result<ReadModel, Diagnostics> {
        let name = path.to_string_lossy().into_owned();
        let model = derive_unless_cancelled(&name, text, &FileBases(files), is_cancelled)?;
        let functions = native::compile_unless_cancelled(model.program.tapes(), is_cancelled);
        let functions = functions.map_err(|error| {
            let help = match &error {
                NativeError::TooMany { .. } | NativeError::Cancelled => "describe a smaller model",
                NativeError::Machine(_)
                | NativeError::Order { .. }
                | NativeError::Generator(_)
                | NativeError::Setting(_) => "run it on a machine that the code generator knows",
            };
            Diagnostics::new(vec![Diagnostic {
                file: name,
                line: None,
                column: None,
                message: format!("the model cannot be compiled, {error}"),
                help: help.to_owned(),
            }])
        })?;
        Ok(ReadModel {
            table: model.program.table,
            // Kept until the program ends, as the table is: a voice may play it until then.
            functions: Box::leak(Box::new(functions)),
        })
    }
}
