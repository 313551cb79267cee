//! Writes a scene as a complete file, with the present values of its keys.

use instruments::ModelEntry;
use keyboard::KeyIndex;
use keyboard::KeyRange;
use toml_edit::{Array, ArrayOfTables, DocumentMut, InlineTable, Item, Table, Value, value};

use super::keys::KeyVoice;
use super::links::{BoardBus, Boards, FORCES, LinksConfig, SAMPLES, bus_at};
use super::overload;
use super::realtime::LaneCount;
use super::scene::{
    Midi, MidiInput, MidiOutput, PerformanceSource, PlayList, RAW, Scene, SoundConfig,
};

/// Returns `scene` as a complete file with the present values; it is read back to the last bit.
pub fn written(scene: &Scene) -> String {
    let mut document = DocumentMut::new();
    document["title"] = value(scene.title.as_str());
    document["tick_hz"] = value(i64::from(scene.tick_hz));
    document["lanes"] = match scene.realtime.lanes {
        LaneCount::Auto => value("auto"),
        LaneCount::Count(count) => value(i64::try_from(count).unwrap_or(1)),
    };
    document["realtime"] = Item::Table(scene.realtime.written());
    document["overload"] = Item::Table(overload::written(&scene.overload));
    document["render"] = Item::Table(scene.render.written());
    document["rig"] = Item::Table(scene.rig.written());
    document["links"] = Item::Table(links(&scene.links));
    document["midi"] = Item::Table(midi(&scene.midi));
    if let Some(list) = &scene.play_list {
        document["pianist"] = Item::Table(pianist(list));
    }
    document["keys"] = Item::ArrayOfTables(keys(&scene.keys));
    document.to_string()
}

fn pianist(list: &PlayList) -> Table {
    let name = |source: &PerformanceSource| match source {
        PerformanceSource::Embedded(name, _bytes) => (*name).to_owned(),
        PerformanceSource::Path(path) => absolute(path),
    };
    let mut table = Table::new();
    table["performance"] = value(list.pieces.iter().map(name).collect::<Array>());
    table["repeat"] = value(list.repeat);
    for (name, numbers) in [
        ("track", list.parts.tracks.iter().map(|it| i64::from(*it)).collect::<Array>()),
        ("channel", list.parts.channels.iter().map(|it| i64::from(*it)).collect()),
    ] {
        if !numbers.is_empty() {
            table[name] = value(numbers);
        }
    }
    table
}

fn absolute(path: &std::path::Path) -> String {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned()).to_string_lossy().into_owned()
}

fn midi(it: &Midi) -> Table {
    let mut table = Table::new();
    table["output"] = value(match &it.output {
        MidiOutput::None => "none".to_owned(),
        MidiOutput::Virtual => "virtual".to_owned(),
        MidiOutput::Port(name) => name.clone(),
        MidiOutput::File(path) => absolute(path),
        MidiOutput::Raw(path) => format!("{RAW}{}", absolute(path)),
    });
    table["curve"] = value(it.curve.name());
    match &it.input {
        MidiInput::None => {}
        MidiInput::Virtual => table["input"] = value("virtual"),
        MidiInput::Port(name) => table["input"] = value(name.as_str()),
    }
    if !it.programs.is_empty() {
        table["programs"] = value(it.programs.iter().map(String::as_str).collect::<Array>());
    }
    let SoundConfig { is_live, wav, picture, font } = &it.sound;
    if *is_live {
        table["sound"] = value(true);
    }
    for (name, path) in [("wav", wav), ("picture", picture), ("font", font)] {
        if let Some(path) = path {
            table[name] = value(absolute(path));
        }
    }
    table
}

fn links(it: &LinksConfig) -> Table {
    let mut table = Table::new();
    let LinksConfig::Boards(boards) = it else {
        table["kind"] = value("simulated");
        return table;
    };
    table["kind"] = value("boards");
    table["samples"] = value(name_of(&SAMPLES, &boards.samples));
    table["forces"] = value(name_of(&FORCES, &boards.forces));
    table["valid"] = value(f64::from(boards.valid_ms) * 1e-3);
    if let Some(folder) = &boards.calibration {
        table["calibration"] = value(absolute(folder));
    }
    table["bus"] = value(buses(boards));
    table
}

fn name_of<T: PartialEq>(names: &[(&'static str, T)], wanted: &T) -> &'static str {
    names.iter().find(|(_name, it)| it == wanted).map_or("", |(name, _it)| name)
}

fn buses(boards: &Boards) -> Array {
    boards.buses.iter().map(bus).collect()
}

fn bus(it: &BoardBus) -> Value {
    let mut table = match bus_at(&it.address).parse() {
        Ok(Value::InlineTable(table)) => table,
        Ok(_) | Err(_) => InlineTable::new(),
    };
    for (key, rate) in [("bit_rate", it.bit_rates.0), ("data_bit_rate", it.bit_rates.1)] {
        if it.address.kind.options.contains(&key) {
            table.insert(key, i64::from(rate).into());
        }
    }
    let boards: Array = it.boards.iter().map(|(number, keys)| board(*number, *keys)).collect();
    table.insert("board", boards.into());
    table.into()
}

fn board(number: u8, keys: KeyRange) -> Value {
    let mut table = InlineTable::new();
    table.insert("number", i64::from(number).into());
    table.insert("keys", format!("{}..{}", keys.first(), keys.last()).into());
    table.into()
}

fn key(number: u8) -> String {
    KeyIndex::new(number).map_or_else(String::new, |key| key.to_string())
}

/// Returns the key ranges; equal neighbours share one.
fn keys(keys: &[Option<KeyVoice>]) -> ArrayOfTables {
    let mut tables = ArrayOfTables::new();
    let mut first = 0;
    while first < keys.len() {
        let alike = |it: &&Option<KeyVoice>| is_alike(it.as_ref(), keys[first].as_ref());
        let n = keys[first..].iter().take_while(alike).count();
        if let Some(voice) = &keys[first] {
            tables.push(entry(voice, first, first + n - 1));
        }
        first += n;
    }
    tables
}

fn is_alike(a: Option<&KeyVoice>, b: Option<&KeyVoice>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => {
            let bits =
                |it: &KeyVoice| -> Vec<u64> { it.values.iter().map(|v| v.to_bits()).collect() };
            a.model.is(&b.model) && bits(a) == bits(b)
        }
        (None, None) => true,
        (Some(_), None) | (None, Some(_)) => false,
    }
}

fn entry(voice: &KeyVoice, first: usize, last: usize) -> Table {
    let name = |index: usize| key(u8::try_from(index).unwrap_or(u8::MAX));
    let mut table = Table::new();
    table["range"] = value(format!("{}..{}", name(first), name(last)));
    table["model"] = value(voice.model.file().unwrap_or(voice.model.name));
    table["parameters"] = value(parameters(&voice.model, &voice.values));
    table
}

fn parameters(model: &ModelEntry, values: &[f64]) -> InlineTable {
    model.parameters.iter().zip(values).map(|(it, value)| (it.name, Value::from(*value))).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::super::embedded::SCENES;
    use super::super::source::SourceText;
    use super::*;
    use mechanism::Library;

    fn again(scene: &Scene) -> Scene {
        let text = written(scene).into_bytes();
        let source = SourceText::from_bytes(Path::new("again.toml"), text).expect("a text");
        Scene::check(&Library::default(), &source, &[]).unwrap_or_else(|wrong| panic!("{wrong}"))
    }

    fn facts(it: &Scene) -> String {
        let keys = it.keys.iter().map(|voice| voice.as_ref().map(|it| (it.model.name, &it.values)));
        let keys: Vec<_> = keys.collect();
        let Scene { title, tick_hz, realtime, render, .. } = it;
        let Scene { links, midi, play_list, .. } = it;
        format!(
            "{title} {tick_hz} {realtime:?} {render:?} {links:?} {midi:?} {play_list:?} {keys:?}"
        )
    }

    #[test]
    fn every_scene_of_ours_comes_back_to_the_bit() {
        // The default scene plays a description, which this crate alone cannot read.
        for name in SCENES.names().filter(|name| *name != "default") {
            let scene = Scene::load(&Library::default(), name, &[]).expect("a scene");
            assert_eq!(facts(&again(&scene)), facts(&scene), "{name}");
        }
    }

    #[test]
    fn values_links_and_outputs_come_back() {
        let changed = [
            ("links.kind", "boards"),
            ("links.samples", "position24-velocity"),
            ("links.forces", "force16-slope"),
            ("links.valid", "30 ms"),
            ("links.calibration", "/somewhere"),
            (
                "links.bus",
                "[{ serial = '/dev/ttyACM0', board = [{ number = 3, keys = 'F#3..E4' }] }, \
                 { can = 'can0' }, { rig = './rig --seed 2' }, \
                 { can = 'can1', mode = 'classic', bit_rate = 500000 }]",
            ),
            ("midi.output", "Synth \"one\""),
            ("lanes", "3"),
            ("realtime.policy", "fifo"),
            ("realtime.cpus", "[2, 3]"),
            ("render.longest_step", "0.3 ms"),
            ("render.force_limit", "12.34567891234567"),
            ("keys.0.parameters.restitution", "0.123456789012345678"),
            ("pianist.performance", "['bach-bwv-846', 'beethoven-ode-to-joy']"),
            ("pianist.repeat", "true"),
        ];
        let changed = changed.map(|(name, value)| (name.to_owned(), value.to_owned()));
        let scene = Scene::load(&Library::default(), "springs", &changed)
            .unwrap_or_else(|wrong| panic!("{wrong}"));
        assert_eq!(facts(&again(&scene)), facts(&scene));
    }

    #[test]
    fn a_midi_device_comes_back() {
        let device = ("midi.output".to_owned(), "raw:/dev/snd/midiC1D0".to_owned());
        let scene = Scene::load(&Library::default(), "springs", &[device])
            .unwrap_or_else(|wrong| panic!("{wrong}"));
        assert_eq!(again(&scene).midi.output, MidiOutput::Raw("/dev/snd/midiC1D0".into()));
    }
}
