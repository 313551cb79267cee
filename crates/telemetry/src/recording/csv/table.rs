use std::{fs::File, io, path::PathBuf};

use csv::Writer;

use crate::recording::error::ExportError;

pub(super) struct CsvTable {
    path: PathBuf,
    writer: Writer<File>,
}

impl CsvTable {
    pub(super) fn create(path: PathBuf, header: &[String]) -> Result<Self, ExportError> {
        let file = match File::options().write(true).create_new(true).open(&path) {
            Ok(file) => file,
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                return Err(ExportError::Exists(path));
            }
            Err(error) => return Err(ExportError::Write { path, cause: error.to_string() }),
        };
        let mut table = Self { path, writer: Writer::from_writer(file) };
        table.row(header)?;
        Ok(table)
    }

    pub(super) fn row<S: AsRef<[u8]>>(&mut self, row: &[S]) -> Result<(), ExportError> {
        let written = self.writer.write_record(row);
        written.map_err(|error| self.failed(&error.to_string()))
    }

    fn failed(&self, cause: &str) -> ExportError {
        ExportError::Write { path: self.path.clone(), cause: cause.to_owned() }
    }

    pub(super) fn finish(mut self) -> Result<PathBuf, ExportError> {
        let written = self.writer.flush();
        written.map_err(|error| self.failed(&error.to_string()))?;
        Ok(self.path)
    }
}
