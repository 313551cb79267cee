//! The catalogue of signals and parameters, as a message.

use std::path::PathBuf;

use descriptions::version_of;
use models::catalogue::{self, ModelEntry};
use scheduler::motion::KEYS;
use telemetry::{Catalogue, Description, DescriptionFile, Instrument, Model, Parameter};

use super::model_probe::{modes, signals};
use scene::{self, InstrumentHead, LinksConfig, Scene};

/// Returns the catalogue of a host that runs `scene` and plays the models of `described`, which
/// are no Rust; when it began is not known yet.
pub fn catalogue(scene: &Scene, described: &[&'static ModelEntry]) -> Catalogue {
    let models: Vec<_> = catalogue::built_ins().chain(described.iter().copied()).collect();
    Catalogue {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scene: scene.name.clone(),
        tick_hz: scene.tick_hz,
        force_limit: scene.render.force_limit,
        slew_limit: scene.render.slew_limit,
        instruments: instruments(&models),
        models: models.into_iter().map(model).collect(),
        fingers: scene.links == LinksConfig::Simulated,
        scene_text: scene::written(scene),
        descriptions: described.iter().filter_map(|entry| description(entry)).collect(),
        ..Catalogue::default()
    }
}

/// Returns those of `models` that are derived from descriptions, each once.
pub fn described(models: impl Iterator<Item = &'static ModelEntry>) -> Vec<&'static ModelEntry> {
    let mut described: Vec<&'static ModelEntry> = Vec::new();
    for model in models {
        let is_known =
            catalogue::built_ins().chain(described.iter().copied()).any(|it| it.is(model));
        if !is_known {
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
        path: path.to_string_lossy().into_owned(),
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
        title: it.title.to_owned(),
    }
}

/// Returns all embedded instruments; those of `models` with their values on every key. The others
/// are not read, since to derive their models would hold up the start.
fn instruments(models: &[&'static ModelEntry]) -> Vec<Instrument> {
    let keys = || (0..=u8::MAX).take(KEYS);
    let known: Vec<_> =
        models.iter().flat_map(|model| scene::Instrument::of_model(model)).collect();
    let listed = |head: InstrumentHead| {
        let known = known.iter().find(|it| it.name == head.name);
        let values = known.map(|it| keys().flat_map(|key| it.values(key)).collect());
        let InstrumentHead { name, doc, model } = head;
        Instrument { name, model, doc, values: values.unwrap_or_default() }
    };
    scene::instrument_heads().into_iter().map(listed).collect()
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
            let parameters = model.map_or(0, |model| model.parameters.len());
            assert_eq!(it.values.len(), KEYS * parameters, "{}", it.name);
        }
        let has_values = |name: &str| {
            catalogue.instruments.iter().any(|it| it.name == name && !it.values.is_empty())
        };
        assert!(has_values("grand-springs") && !has_values("organ"));
        assert!(catalogue.instruments.iter().any(|it| it.name == "organ"), "listed all the same");
    }
}
