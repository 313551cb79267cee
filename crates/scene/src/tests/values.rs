use mechanism::Library;
use std::path::Path;

use pianist::ChosenParts;
use pode::stepper::{self, Any};

use super::*;

/// Compares a parameter's value on a key by its bits: no arithmetic happens on the way.
#[track_caller]
fn check_value(scene: &Scene, key: usize, parameter: &str, expected: f64) {
    let voice = scene.keys[key].as_ref().unwrap();
    let index = voice.model.parameters.iter().position(|p| p.name == parameter).unwrap();
    let value = voice.values[index];
    assert_eq!(value.to_bits(), expected.to_bits(), "{parameter} is {value}, not {expected}");
}

#[track_caller]
fn check_models(scene: &Scene, lowest: &str, highest: &str) {
    let model = |key: usize| scene.keys[key].as_ref().unwrap().model.name;
    assert_eq!([model(0), model(87)], [lowest, highest]);
}

#[test]
fn a_scene_of_three_lines_has_a_default_for_all_else() {
    let scene = load(MINIMAL, &[]);
    assert_eq!([scene.name, scene.title], ["scene", "scene"]);
    assert_eq!((scene.tick_hz, scene.realtime.lanes), (1000, LaneCount::Auto));
    assert_eq!(scene.render, Render::default());
    assert_eq!(scene.links, LinksConfig::Simulated);
    assert_eq!(scene.midi.output, MidiOutput::None);
    assert_eq!(scene.play_list, None);
    assert_eq!(scene.keys.iter().flatten().count(), 88);
}

#[test]
fn keys_outside_every_range_are_silent() {
    let scene = load("[[keys]]\nrange = 60\nmodel = \"key-hammer-springs\"\n", &[]);
    let sounding: Vec<usize> = (0..88).filter(|key| scene.keys[*key].is_some()).collect();
    assert_eq!(sounding, [39]);
    // Without a named preset the first is used, with the paper's ideal string.
    check_value(&scene, 39, "restitution", 1.0);
}

#[test]
fn a_parameter_overrides_the_instrument_s_over_the_whole_compass() {
    let graded = "M2 = \"9 g\"\nrestitution = { bass = 0.2, treble = 0.1 }\n";
    let scene = load(&format!("{MINIMAL}[keys.parameters]\n{graded}"), &[]);
    for key in [0, 40, 87] {
        check_value(&scene, key, "M2", 0.009);
        check_value(&scene, key, "L1", 0.1385);
    }
    check_value(&scene, 0, "restitution", 0.2);
    check_value(&scene, 87, "restitution", 0.1);
}

#[test]
fn a_performance_is_embedded_or_lies_beside_the_scene() {
    let bach = Scene::load(&Library::default(), "bach", &[]).unwrap().play_list.unwrap();
    let [PerformanceSource::Embedded(name, bytes)] = &bach.pieces[..] else { panic!("{bach:?}") };
    assert_eq!((*name, &bytes[..4], bach.repeat), ("bach-bwv-846", b"MThd".as_slice(), false));

    let folder = Folder::new("performance");
    folder.write("mine.mid", bytes);
    let text = format!("{MINIMAL}[pianist]\nperformance = \"mine.mid\"\n");
    let path = folder.write("scene.toml", text.as_bytes());
    let scene = Scene::load(&Library::default(), &path, &[]).unwrap();
    let mine = PerformanceSource::Path(folder.0.join("mine.mid"));
    let (pieces, parts) = (vec![mine.clone()], ChosenParts::default());
    assert_eq!(scene.play_list, Some(PlayList { pieces, repeat: false, parts }));
    let chosen = format!("{text}track = 1\nchannel = [1, 2]\n");
    let chosen = folder.write("chosen.toml", chosen.as_bytes());
    let chosen = Scene::load(&Library::default(), &chosen, &[]).unwrap();
    let parts = ChosenParts { tracks: vec![1], channels: vec![1, 2] };
    assert_eq!(chosen.play_list.as_ref().map(|it| &it.parts), Some(&parts));
    let again = Scene::from_text(&Library::default(), "written", written(&chosen)).unwrap();
    assert_eq!(again.play_list.map(|it| it.parts), Some(parts));
    let list = "performance = [\"mine.mid\", \"bach-bwv-846\", \"mine.mid\"]\nrepeat = true\n";
    let list = folder.write("list.toml", format!("{MINIMAL}[pianist]\n{list}").as_bytes());
    let list = Scene::load(&Library::default(), &list, &[]).unwrap().play_list.unwrap();
    assert_eq!((&list.pieces[0], &list.pieces[2], list.pieces.len()), (&mine, &mine, 3));
    assert!(list.repeat && matches!(list.pieces[1], PerformanceSource::Embedded(..)), "{list:?}");
    let silenced = Scene::load_as_typed(
        &Library::default(),
        &path,
        &owned(&[("pianist.performance", "none")]),
    )
    .unwrap();
    assert_eq!(silenced.play_list, None);
}

#[test]
fn midi_goes_to_a_port_a_file_or_nowhere() {
    #[track_caller]
    fn check(output: &str, expected: &MidiOutput) {
        assert_eq!(load(MINIMAL, &[("midi.output", output)]).midi.output, *expected);
    }
    check("none", &MidiOutput::None);
    check("virtual", &MidiOutput::Virtual);
    check("FLUID Synth", &MidiOutput::Port("FLUID Synth".to_owned()));
    check("raw:/dev/snd/midiC1D0", &MidiOutput::Raw("/dev/snd/midiC1D0".into()));
    check("takes/one.MID", &MidiOutput::File("takes/one.MID".into()));
    let set = [("midi.sound", "true"), ("midi.wav", "/a.wav"), ("midi.font", "/a.sf2")];
    let heard = load(MINIMAL, &set).midi.sound;
    assert!(heard.is_live && heard.picture.is_none(), "{heard:?}");
    assert_eq!((heard.wav, heard.font), (Some("/a.wav".into()), Some("/a.sf2".into())));

    for (output, reason) in [
        ("x2.smf", "has the ending of another kind of file"),
        ("x.midi2", "has the ending of another kind of file"),
        ("x2.mid,none", "is a list, and there is one MIDI output"),
        ("a.mid,b.mid", "is a list, and there is one MIDI output"),
        ("/dev/snd/midiC1D0", "is a path of no MIDI file, and no port"),
    ] {
        let changes = owned(&[("midi.output", output)]);
        let refused = Scene::check(&Library::default(), &source(MINIMAL), &changes).unwrap_err();
        let expected = format!("\"{output}\" {reason}; give one of: a file that ends in .mid");
        assert!(refused.to_string().contains(&expected), "{refused}");
    }
}

#[test]
fn an_instrument_of_one_s_own_lies_beside_the_scene() {
    let folder = Folder::new("instrument");
    let soft = folder.write("soft.toml", b"model = \"spring-wall\"\nparameters.K = \"0.2 kN/m\"\n");
    let scene = MINIMAL.replace("grand-springs", "soft.toml");
    let scene = folder.write("scene.toml", scene.as_bytes());
    check_value(&Scene::load(&Library::default(), &scene, &[]).unwrap(), 0, "K", 200.0);
    assert_eq!(check_file(&Library::default(), Path::new(&soft)), Ok(FileKind::Instrument));
    assert_eq!(check_file(&Library::default(), Path::new(&scene)), Ok(FileKind::Scene));

    // A mistake in the instrument is reported once, in the instrument's file.
    folder.write("soft.toml", b"model = \"spring-wall\"\nparameters.K = \"0.2 N/s\"\n");
    let expected =
        format!("{soft}:2:16: \"K\" has the wrong unit \"N/s\"; give it in N/m, 0 to 1e9 N/m");
    assert_eq!(Scene::load(&Library::default(), &scene, &[]).unwrap_err().to_string(), expected);
}

#[test]
fn the_last_override_of_a_name_wins_over_the_file() {
    let text = format!("tick_hz = 2000\n{MINIMAL}");
    assert_eq!(load(&text, &[]).tick_hz, 2000);
    assert_eq!(load(&text, &[("tick_hz", "4000")]).tick_hz, 4000);
    assert_eq!(load(&text, &[("tick_hz", "4000"), ("tick_hz", "5 kHz")]).tick_hz, 5000);
    assert_eq!(load(&text, &[("tick_hz", "4 khz")]).tick_hz, 4000);
    // An invalid value in the file does not matter then.
    assert_eq!(load(&text.replace("2000", "2"), &[("tick_hz", "600")]).tick_hz, 600);
}

#[test]
fn an_override_reaches_every_table() {
    let overrides = [
        ("title", "1984"),
        ("lanes", "3"),
        ("render.stepper", "heun"),
        ("render.force_limit", "20 N"),
        ("midi.curve", "linear"),
        ("pianist.performance", "beethoven-ode-to-joy"),
    ];
    let scene = load(MINIMAL, &overrides);
    assert_eq!((scene.title.as_str(), scene.realtime.lanes), ("1984", LaneCount::Count(3)));
    let heun = Any::Heun(stepper::Heun);
    let expected = Render { stepper: heun, force_limit: 20.0, ..Render::default() };
    assert_eq!(scene.render, expected);
    assert_eq!(scene.midi.curve.name(), "linear");
    let pieces = format!("{:?}", scene.play_list.unwrap().pieces);
    assert_eq!(pieces, "[Embedded(\"beethoven-ode-to-joy\")]");
}

#[test]
fn an_override_of_keys_reaches_all_ranges() {
    let scene = load(TWO_RANGES, &[("keys.parameters.restitution", "0.2")]);
    check_value(&scene, 0, "restitution", 0.2);
    check_value(&scene, 87, "restitution", 0.2);
    check_value(&scene, 87, "k1", 400.0);
}

#[test]
fn an_override_of_a_numbered_range_reaches_it_alone() {
    let scene = load(TWO_RANGES, &[("keys.1.parameters.restitution", "0.2")]);
    check_value(&scene, 0, "restitution", 1.0);
    check_value(&scene, 87, "restitution", 0.2);
}

#[test]
fn a_new_voice_replaces_what_the_file_says_of_the_old_one() {
    let scene = load(TWO_RANGES, &[("keys.0.instrument", "cart-pendulum")]);
    check_models(&scene, "cart-pendulum", "key-hammer-springs");
    let stable = [("tick_hz", "4000"), ("render.jerk_density", "10")];
    let model = [("keys.model", "key-hammer-rigid"), ("keys.preset", "literal")];
    let overrides = [stable, model].concat();
    let scene = load(TWO_RANGES, &overrides);
    check_models(&scene, "key-hammer-rigid", "key-hammer-rigid");
    check_value(&scene, 0, "L1", 4.0);
    check_value(&scene, 87, "k1", 400.0);
}

#[test]
fn a_number_in_an_override_is_a_place_in_a_list() {
    let text = format!(
        "{MINIMAL}[links]\nkind = \"boards\"\n[[links.bus]]\ncan = \"can0\"\n[[links.bus]]\n\
         can = \"can1\"\nmode = \"classic\"\n"
    );
    let LinksConfig::Boards(boards) = load(&text, &[("links.bus.1.bit_rate", "500000")]).links
    else {
        panic!("these are boards");
    };
    let rates: Vec<_> = boards.buses.iter().map(|bus| bus.bit_rates.0).collect();
    assert_eq!(rates, [1_000_000, 500_000]);
}

#[test]
fn boards_exchange_every_whole_number_of_100_us() {
    let all = [(100, Some(10_000)), (1_000, Some(1_000)), (10_000, Some(100)), (3_000, None)];
    for (hz, period) in all {
        assert_eq!(period_us(hz), period, "{hz} Hz");
    }
}
