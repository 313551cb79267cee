//! One list of a model's parameters: field, name, unit, range and meaning.

/// Defines the struct of a model's parameter values, the list of its parameters, their number,
/// and the struct's construction from an array in the order of the list.
macro_rules! parameters {
    (
        $(#[$doc:meta])*
        $vis:vis struct $values:ident, $count_vis:vis $count:ident, $list_vis:vis $list:ident;
        $($(#[$field_doc:meta])* $field:ident = $parameter:expr;)+
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Debug)]
        $vis struct $values {
            $($(#[$field_doc])* pub $field: f64,)+
        }

        /// Number of parameters of the model.
        $count_vis const $count: usize = [$(stringify!($field)),+].len();

        /// The parameters with unit, range and meaning.
        $list_vis const $list: [models::Parameter; $count] = [$($parameter),+];

        impl $values {
            /// Returns the values in the order of the list.
            $count_vis const fn from_array(values: &[f64; $count]) -> Self {
                let [$($field),+] = *values;
                Self { $($field),+ }
            }
        }
    };
}

pub(crate) use parameters;
