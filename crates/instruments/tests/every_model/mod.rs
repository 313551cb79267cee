//! Does one check with each of the paper's models and their neighbours.

use std::path::Path;
use std::sync::Arc;

use instruments::LoadedModel;
use mechanism::Library;

/// Loads the models whose folders are beside these tests.
pub(crate) fn all() -> impl Iterator<Item = Arc<LoadedModel>> {
    let names = [
        "key-hammer-springs",
        "key-hammer-rigid",
        "reduced-grand",
        "bouncing-ball",
        "cart-pendulum",
        "spring-wall",
    ];
    names.into_iter().map(named)
}

pub(crate) fn named(name: &str) -> Arc<LoadedModel> {
    let model = Library::default().find(name, Path::new(""));
    model.unwrap_or_else(|missing| panic!("{}", missing.rendered()))
}

/// Calls the generic function `check` with each model, with the values of its default preset.
macro_rules! with_all {
    ($check:ident) => {{
        struct Check;
        impl instruments::Visitor for Check {
            type Output = ();
            fn visit<M: instruments::Playable>(self, model: M) {
                $check(model);
            }
        }
        for model in crate::every_model::all() {
            model.visit(Check);
        }
    }};
}

pub(crate) use with_all;
