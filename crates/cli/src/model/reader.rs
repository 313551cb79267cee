//! Descriptions become models that run: derived, and compiled to machine code.

use std::path::Path;

use descriptions::{DescriptionFiles, DescriptionReader, ReadModel};
use diagnostics::{Diagnostic, Diagnostics};
use kane::derive_model;

use super::bases::FileBases;

/// Derives and compiles what it reads.
#[derive(Clone, Copy, Debug)]
pub(super) struct CompilingReader;

impl DescriptionReader for CompilingReader {
    fn read(
        &self,
        path: &Path,
        text: &str,
        files: &DescriptionFiles,
    ) -> Result<ReadModel, Diagnostics> {
        let name = path.to_string_lossy().into_owned();
        let model = derive_model(&name, text, &FileBases(files))?;
        let functions = native::compile(model.program.tapes()).map_err(|error| {
            Diagnostics::new(vec![Diagnostic {
                file: name,
                line: None,
                column: None,
                message: format!("the model cannot be compiled, {error}"),
                help: "run it on a machine that the code generator knows".to_owned(),
            }])
        })?;
        Ok(ReadModel {
            table: model.program.table,
            // Kept until the program ends, as the table is: a voice may play it until then.
            functions: Box::leak(Box::new(functions)),
        })
    }
}
