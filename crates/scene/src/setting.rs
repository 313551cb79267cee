//! Reading and writing of a value of a table: a number of some unit, or one of several names.

use toml_edit::Value;

use super::quantity::Quantity;
use super::read::TableReader;
use super::report::MistakeList;

/// Reads and writes a value of a table.
pub(super) trait TableSetting<T> {
    /// Reads the value called `name`, if it is there and right.
    fn read(
        &self,
        report: &mut MistakeList<'_>,
        reader: &mut TableReader<'_>,
        name: &'static str,
    ) -> Option<T>;

    /// Returns `value` as TOML.
    fn written(&self, value: &T) -> Value;
}

impl TableSetting<f64> for Quantity {
    fn read(
        &self,
        report: &mut MistakeList<'_>,
        reader: &mut TableReader<'_>,
        name: &'static str,
    ) -> Option<f64> {
        reader.number(report, name, *self)
    }

    fn written(&self, value: &f64) -> Value {
        (*value).into()
    }
}

/// One of several values that have names.
#[derive(Clone, Copy, Debug)]
pub(super) struct NamedValues<T: 'static> {
    /// The message before an unknown name, as "there is no stepper".
    pub(super) refusal: &'static str,
    /// Returns every value with its name.
    pub(super) all: fn() -> Vec<(&'static str, T)>,
}

impl<T: Copy + PartialEq> TableSetting<T> for NamedValues<T> {
    fn read(
        &self,
        report: &mut MistakeList<'_>,
        reader: &mut TableReader<'_>,
        name: &'static str,
    ) -> Option<T> {
        reader.choice(report, name, self.refusal, &(self.all)())
    }

    fn written(&self, value: &T) -> Value {
        let all = (self.all)();
        let named = all.iter().find(|(_name, it)| it == value);
        named.map_or("", |(name, _it)| name).into()
    }
}
