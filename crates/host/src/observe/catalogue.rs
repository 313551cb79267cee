//! The catalogue of signals and parameters, as a message.

use std::{path::PathBuf, sync::Arc};

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
    const MIDDLE: u8 = 39;
    let usual = entry.presets.first().map(|it| it.values(MIDDLE)).unwrap_or_default();
    Model {
        version: entry.version(),
        name: entry.name.to_owned(),
        summary: entry.summary.to_string(),
        modes: modes(entry),
        signals: signals(entry),
        parameters: entry
            .parameters
            .iter()
            .zip(usual)
            .map(|(it, usual)| parameter(it, usual))
            .collect(),
    }
}

fn parameter(it: &instruments::Parameter, usual: f64) -> Parameter {
    Parameter {
        name: it.name.to_owned(),
        unit: it.unit.to_owned(),
        min: it.range.0,
        max: it.range.1,
        doc: it.doc.to_string(),
        title: it.title.to_string(),
        reading_per: it.reading.per,
        reading_offset: it.reading.offset,
        step: it.reading.step.unwrap_or_else(|| usual_step(it, usual)),
    }
}

/// Returns the entry of an instrument of the user, with its values on every key.
pub fn instrument(it: &scene::Instrument) -> Instrument {
    let keys = (0..=u8::MAX).take(KEYS);
    Instrument {
        name: it.name.clone(),
        model: it.model().name.to_owned(),
        doc: it.doc.clone(),
        values: keys.flat_map(|key| it.values(key)).collect(),
        is_own: true,
        base: it.based.as_ref().map(|based| based.base.clone()).unwrap_or_default(),
        base_changed: it.based.as_ref().is_some_and(|based| based.has_changed),
    }
}

/// Returns the step of a hand for a parameter of this usual value: 0.1 mm and 0.1 g, less for small
/// parts, and 1 % of anything else; 0 if the value has no size.
fn usual_step(parameter: &instruments::Parameter, usual: f64) -> f64 {
    let (part, largest) = match parameter.unit {
        "m" | "kg" => (0.05, 1e-4),
        _ => (0.01, f64::INFINITY),
    };
    let (low, high) = parameter.range;
    let size = if usual == 0.0 { 0.1 * low.abs().max(high.abs()) } else { usual.abs() };
    rounded_down((part * size).min(largest))
}

/// Returns the largest of 1, 2 and 5 times a power of ten up to `x`; 0 if there is none.
fn rounded_down(x: f64) -> f64 {
    let ten = 10_f64.powf(x.log10().floor());
    // A product of the decimal fractions above may be a bit smaller than its digits.
    let found = [5.0, 2.0, 1.0].map(|it| it * ten).into_iter().find(|it| *it <= 1.000_001 * x);
    found.filter(|it| it.is_finite()).unwrap_or(0.0)
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
        let InstrumentHead { name, doc, model, .. } = head;
        let values = values.unwrap_or_default();
        Instrument { name, model, doc, values, ..Instrument::default() }
    };
    scene::instruments().into_iter().map(listed).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_is_what_a_hand_moves_at_once() {
        let step = |unit, range, usual| {
            let parameter = instruments::Parameter {
                name: "x",
                title: "".into(),
                unit,
                range,
                doc: "".into(),
                reading: instruments::Reading::default(),
            };
            usual_step(&parameter, usual)
        };
        for (unit, usual, expected) in [
            ("m", 0.2595, 1e-4),
            ("m", 6.3e-5, 2e-6),
            ("m", 0.0, 1e-5),
            ("kg", 8.7e-3, 1e-4),
            ("N/m", 95_100.0, 500.0),
            ("N·m", -0.0127, 1e-4),
            ("1", 0.4, 2e-3),
        ] {
            let found = step(unit, (-2e-3, 2e-3), usual);
            assert!((found / expected - 1.0).abs() < 1e-9, "{usual} {unit}: {found}");
        }
        let unlimited = step("N", (0.0, f64::INFINITY), 0.0);
        assert!(unlimited == 0.0, "{unlimited}");
    }

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
