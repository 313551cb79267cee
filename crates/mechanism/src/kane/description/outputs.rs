use documents::quoted;
use documents::toml::{KeyReader, TomlEntry, TomlKind, TomlNode};

use super::items::FileExpression;
use super::reader::{MechanismReader, RESULT};
use crate::kane::mechanism::MechanismOutput;
use crate::kane::text::{Dimension, Measured};

impl MechanismReader {
    pub(super) fn outputs(&mut self, root: &mut KeyReader<'_>) {
        for entry in root.table(&mut self.report, "outputs") {
            self.output(entry);
        }
    }

    fn output(&mut self, entry: &TomlEntry) {
        let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { return };
        // Without a value it is the definition of its name.
        let kind = TomlKind::Text(entry.name.clone(), true);
        let named = TomlNode { place: entry.place, kind };
        let value = keys.take("value").map_or(&named, |it| &it.node);
        let value = self.written("value", value);
        let has_unit = keys.take("unit").is_some();
        let unit = self.unit(&mut keys, "unit");
        let others = self.in_modes(&mut keys);
        keys.finish(&mut self.report);
        let Some(file) = value else { return };
        let Some(value) = self.value(&file, RESULT) else { return };
        if has_unit && unit.is_none() {
            return;
        }
        let (unit, dimension) = unit.unwrap_or((value.dimension.to_string(), value.dimension));
        if !self.fits(&entry.name, &file, value, dimension) {
            return;
        }
        let mut values = Vec::new();
        for mode in 0..self.modes.len() {
            let other = others.iter().find(|(at, _)| *at == mode).map(|(_, file)| file);
            values.extend(self.output_value(&file, value, other, dimension, mode));
        }
        if values.len() == self.modes.len() {
            self.mechanism.outputs.push(MechanismOutput { name: entry.name.clone(), unit, values });
        }
    }

    fn output_value(
        &mut self,
        file: &FileExpression,
        value: Measured,
        other: Option<&FileExpression>,
        dimension: Dimension,
        mode: usize,
    ) -> Option<crate::kane::graph::Node> {
        match other {
            Some(other) => self.mode_value("in", other, RESULT, dimension, mode),
            None => Some(self.acting(file, value, mode).node),
        }
    }

    fn in_modes(&mut self, keys: &mut KeyReader<'_>) -> Vec<(usize, FileExpression)> {
        let mut others = Vec::new();
        for entry in keys.table(&mut self.report, "in") {
            let Some(mode) = self.modes.iter().position(|(name, _)| *name == entry.name) else {
                let help = documents::choice(&entry.name, self.modes.iter().map(|(it, _)| it));
                let message = format!("there is no mode {}", quoted(&entry.name));
                self.report.say(entry.place, message, help);
                continue;
            };
            let file = self.written(&entry.name, &entry.node);
            others.extend(file.map(|file| (mode, file)));
        }
        others
    }
}
