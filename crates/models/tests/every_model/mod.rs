//! Does one check with every model of the catalogue.

/// Calls the generic function `check` with each model.
macro_rules! with_all {
    ($check:ident) => {{
        struct Check;
        impl models::catalogue::Visitor for Check {
            type Output = ();
            fn visit<M: models::Playable>(self) {
                $check::<M>();
            }
        }
        for entry in models::catalogue::ENTRIES {
            let visited = models::catalogue::visit(entry.name, Check);
            assert!(visited.is_some(), "what is listed can be visited: {}", entry.name);
        }
    }};
}

pub(crate) use with_all;
