//! Does one check with every model of the catalogue.

/// Calls the generic function `check` with each model, which has the values of its default preset.
macro_rules! with_all {
    ($check:ident) => {{
        struct Check;
        impl models::catalogue::Visitor for Check {
            type Output = ();
            fn visit<M: models::Playable>(self, model: M) {
                $check(model);
            }
        }
        for entry in models::catalogue::built_ins() {
            let visited = models::catalogue::visit(entry, Check);
            assert!(visited.is_some(), "what is listed can be visited: {}", entry.name);
        }
    }};
}

pub(crate) use with_all;
