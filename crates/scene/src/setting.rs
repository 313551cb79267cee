//! Values of a table that are read and written: a number of some unit, or one of several names.

use toml_edit::Value;

use super::quantity::Quantity;
use super::read::TableReader;
use documents::toml::FindingList;

pub(super) trait TableSetting<T> {
    /// Reads the value called `name`, if it exists and is valid.
    fn read(
        &self,
        report: &mut FindingList,
        reader: &mut TableReader<'_>,
        name: &'static str,
    ) -> Option<T>;

    fn written(&self, value: &T) -> Value;
}

impl TableSetting<f64> for Quantity {
    fn read(
        &self,
        report: &mut FindingList,
        reader: &mut TableReader<'_>,
        name: &'static str,
    ) -> Option<f64> {
        reader.number(report, name, *self)
    }

    fn written(&self, value: &f64) -> Value {
        (*value).into()
    }
}

/// One of several named values.
#[derive(Clone, Copy, Debug)]
pub(super) struct NamedValues<T: 'static> {
    /// Message before an unknown name, as "there is no stepper".
    pub(super) refusal: &'static str,
    /// Returns every value with its name.
    pub(super) all: fn() -> Vec<(&'static str, T)>,
}

impl<T: Copy + PartialEq> TableSetting<T> for NamedValues<T> {
    fn read(
        &self,
        report: &mut FindingList,
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

/// Declares the settings of a table once, each as `name: type = default, how;`, for the struct, its
/// defaults, its reader and its writer.
macro_rules! settings {
    (
        $(#[$about:meta])* pub struct $settings:ident;
        $($(#[$doc:meta])* $name:ident: $type:ty = $default:expr, $how:expr;)+
    ) => {
        $(#[$about])*
        #[derive(Clone, Copy, PartialEq, Debug)]
        pub struct $settings {
            $($(#[$doc])* pub $name: $type,)+
        }

        impl Default for $settings {
            fn default() -> Self {
                Self { $($name: $default,)+ }
            }
        }

        impl $settings {
            /// Replaces settings by those that `reader` has.
            fn read_all(
                &mut self,
                report: &mut documents::toml::FindingList,
                reader: &mut $crate::read::TableReader<'_>,
            ) {
                use $crate::setting::TableSetting as _;
                $(if let Some(read) = $how.read(report, reader, stringify!($name)) {
                    self.$name = read;
                })+
            }

            pub(super) fn written(&self) -> toml_edit::Table {
                use $crate::setting::TableSetting as _;
                let mut table = toml_edit::Table::new();
                $(table[stringify!($name)] = toml_edit::value($how.written(&self.$name));)+
                table
            }
        }
    };
}

pub(super) use settings;
