//! The paper's models and their neighbours.

use std::path::Path;
use std::sync::Arc;

use instruments::{LoadedModel, SmallModel};
use mechanism::Library;

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

pub(crate) fn small() -> impl Iterator<Item = SmallModel> {
    all().map(|it| it.small().expect("a small model"))
}
