//! The catalogue of signals and parameters, as a message.

use std::path::PathBuf;
use std::sync::Arc;

use instruments::{LoadedModel, ModelEntry};
use scheduler::motion::KEYS;
use telemetry::{Catalogue, Description, DescriptionFile, Instrument, Model, Parameter};

use super::model_probe::{modes, signals};
use scene::{self, InstrumentHead, LinksConfig, Scene};

/// Returns the catalogue of a host that runs `scene` and plays `models`, without its start time.
pub fn catalogue(scene: &Scene, models: &[Arc<LoadedModel>]) -> Catalogue {
    Catalogue {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scene: scene.name.clone(),
        tick_hz: scene.tick_hz,
        force_limit: scene.render.force_limit,
        slew_limit: scene.render.slew_limit,
        instruments: instruments(models),
        models: models.iter().map(|it| model(it)).collect(),
        fingers: scene.links == LinksConfig::Simulated,
        scene_text: scene::written(scene),
        descriptions: models.iter().filter_map(|it| description(it)).collect(),
        ..Catalogue::default()
    }
}

pub fn distinct<'a, I>(models: I) -> Vec<Arc<LoadedModel>>
where
    I: IntoIterator<Item = &'a Arc<LoadedModel>>,
{
    let mut distinct: Vec<Arc<LoadedModel>> = Vec::new();
    for model in models {
        if !distinct.iter().any(|known| known.is(model)) {
            distinct.push(Arc::clone(model));
        }
    }
    distinct
}

/// Returns the description behind `entry`, with the text of its files.
fn description(entry: &ModelEntry) -> Option<Description> {
    let source = entry.source.as_ref()?;
    let texts = source.contents.texts().into_iter();
    let file = |(path, text): (PathBuf, String)| DescriptionFile {
        path: path.to_string_lossy().into_owned(),
        text,
    };
    Some(Description {
        version: source.version,
        model: entry.name.to_owned(),
        files: texts.map(file).collect(),
        ..Description::default()
    })
}

fn model(entry: &ModelEntry) -> Model {
    Model {
        version: entry.version(),
        name: entry.name.to_owned(),
        summary: entry.summary.to_string(),
        modes: modes(entry),
        signals: signals(entry),
        parameters: entry.parameters.iter().map(parameter).collect(),
    }
}

fn parameter(it: &instruments::Parameter) -> Parameter {
    Parameter {
        name: it.name.to_owned(),
        unit: it.unit.to_owned(),
        min: it.range.0,
        max: it.range.1,
        doc: it.doc.to_string(),
        title: it.title.to_string(),
    }
}

/// Returns all embedded instruments; those of `models` with their values on every key. The others
/// are not read, since deriving their models would delay the start.
fn instruments(models: &[Arc<LoadedModel>]) -> Vec<Instrument> {
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
        let scene = Scene::load(&scene::Library::default(), "springs", &[]).expect("a scene");
        let models = distinct(scene.keys.iter().flatten().map(|voice| &voice.model));
        let catalogue = catalogue(&scene, &models);
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
