//! The catalogue of signals and parameters, as a message.

use std::path::PathBuf;

use descriptions::version_of;
use models::catalogue::{self, ModelEntry};
use scheduler::motion::KEYS;
use telemetry::{Catalogue, Description, DescriptionFile, Instrument, Model, Parameter};

use super::model_probe::{modes, signals};
use scene::{self, LinksConfig, Scene};

/// Returns the catalogue of a host that runs `scene` and plays the models of `described`, which
/// are no part of the program; when it began is not known yet.
pub fn catalogue(scene: &Scene, described: &[&'static ModelEntry]) -> Catalogue {
    let program = of_program(scene);
    let instruments = instruments(&program);
    let models = program.into_iter().chain(described.iter().copied());
    Catalogue {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scene: scene.name.clone(),
        tick_hz: scene.tick_hz,
        force_limit: scene.render.force_limit,
        slew_limit: scene.render.slew_limit,
        models: models.map(model).collect(),
        instruments,
        fingers: scene.links == LinksConfig::Simulated,
        scene_text: scene::written(scene),
        descriptions: described.iter().filter_map(|entry| description(entry)).collect(),
        ..Catalogue::default()
    }
}

/// Returns the models that the program contains as Rust, then those that it has as descriptions and
/// `scene` plays, each once: to derive the others would hold up the start.
fn of_program(scene: &Scene) -> Vec<&'static ModelEntry> {
    let mut models: Vec<_> = catalogue::built_ins().collect();
    for voice in scene.keys.iter().flatten().filter(|voice| voice.model.file.is_none()) {
        if !models.iter().any(|known| known.is(voice.model)) {
            models.push(voice.model);
        }
    }
    models
}

/// Returns those of `models` that were read from files, each once.
pub fn described(models: impl Iterator<Item = &'static ModelEntry>) -> Vec<&'static ModelEntry> {
    let mut described: Vec<&'static ModelEntry> = Vec::new();
    for model in models.filter(|model| model.file.is_some()) {
        if !described.iter().any(|known| known.is(model)) {
            described.push(model);
        }
    }
    described
}

/// Returns the number of the version of a description that `entry` is; 0 of a model of the
/// program.
pub fn version(entry: &ModelEntry) -> u32 {
    version_of(entry).map_or(0, |version| version.number)
}

/// Returns the version of a description that `entry` is, with the text of its files.
fn description(entry: &ModelEntry) -> Option<Description> {
    let version = version_of(entry)?;
    let texts = version.contents.texts().into_iter();
    let file = |(path, text): (PathBuf, String)| DescriptionFile {
        path: path.display().to_string(),
        text,
    };
    Some(Description {
        version: version.number,
        model: entry.name.to_owned(),
        files: texts.map(file).collect(),
        ..Description::default()
    })
}

fn model(entry: &ModelEntry) -> Model {
    Model {
        version: version(entry),
        name: entry.name.to_owned(),
        summary: entry.summary.to_owned(),
        modes: modes(entry),
        signals: signals(entry),
        parameters: entry.parameters.iter().map(parameter).collect(),
    }
}

fn parameter(it: &models::Parameter) -> Parameter {
    Parameter {
        name: it.name.to_owned(),
        unit: it.unit.to_owned(),
        min: it.range.0,
        max: it.range.1,
        doc: it.doc.to_owned(),
    }
}

/// Returns the embedded instruments of `models`, with their values on every key.
fn instruments(models: &[&'static ModelEntry]) -> Vec<Instrument> {
    let keys = || (0..=u8::MAX).take(KEYS);
    let all = models.iter().flat_map(|model| scene::Instrument::of_model(model));
    all.map(|it| Instrument {
        values: keys().flat_map(|key| it.values(key)).collect(),
        model: it.model().name.to_owned(),
        doc: it.doc.clone(),
        name: it.name.clone(),
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instruments_have_a_value_for_each_parameter_on_each_key() {
        let scene = Scene::load("springs", &[]).expect("a scene of ours");
        let catalogue = catalogue(&scene, &[]);
        assert!(!catalogue.instruments.is_empty());
        for it in &catalogue.instruments {
            let model = catalogue.models.iter().find(|model| model.name == it.model);
            let parameters = model.expect("a model that is listed").parameters.len();
            assert_eq!(it.values.len(), KEYS * parameters, "{}", it.name);
        }
    }
}
