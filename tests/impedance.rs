//! `letoff lab impedance`: modes, voices and recorded strokes, in files and as JSON.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::letoff::{check_words, folder, run};

fn report(folder: &Path, arguments: &[&str]) -> Value {
    let said = run(folder, &[&["lab", "impedance"], arguments, &["--json"]].concat());
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""), "{said:?}");
    said.report()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn points(curve: &Value) -> &[Value] {
    curve["points"].as_array().expect("points")
}

#[test]
fn a_voice_is_as_passive_as_its_walls_damper_less_what_the_delay_takes() {
    let folder = folder("impedance-wall");
    let (k, b) = (1e3, 0.5);
    let wall = ["--what", "spring-wall", "--depth", "8 mm", "--frequency", "1..10"];
    let estimator = ["--points", "5", "--estimator", "backward-difference"];
    for (delay, late) in [("0", 0.0), ("1 ms", 1e-3), ("2.5 ms", 2.5e-3)] {
        let delay = ["--delay", delay, "--out", "out"];
        let report = report(&folder, &[&wall[..], &estimator[..], &delay[..]].concat());
        let [mode, voice] = [&report["curves"][0], &report["curves"][1]];
        for (exact, rendered) in points(mode).iter().zip(points(voice)) {
            let omega = std::f64::consts::TAU * number(&exact["frequency"]);
            let near = |found: &Value, expected: f64, error: f64| {
                let found = number(found);
                assert!((found - expected).abs() < error, "{found}, expected {expected}");
            };
            near(&exact["real"], b, 1e-6 * k / omega);
            near(&exact["imaginary"], -k / omega, 1e-6 * k / omega);
            // A voice extrapolates the motion over its period, so that holding costs nothing to
            // first order. To second order it is (ω τ)² of K/ω, τ a period and the delay.
            let lag = omega * (1e-3 + late);
            near(&rendered["real"], b - k * late, lag * lag * k / omega);
            near(&rendered["imaginary"], -k / omega, lag * lag * k / omega);
        }
        assert_eq!(mode["not_passive"], serde_json::json!([]));
        let bands = voice["not_passive"].as_array().expect("bands").len();
        assert_eq!(bands, usize::from(b < k * late), "{voice}");
    }
    let file = |name: &str| fs::read_to_string(folder.join("out").join(name)).expect("a file");
    assert_eq!(file("impedance.csv").lines().count(), 11);
    assert!(file("impedance.svg").contains("frequency [Hz]"));
    assert!(file("index.html").contains("Re Z is below zero from 1 to 10 Hz"));
}

#[test]
fn a_recorded_stroke_has_the_impedance_of_the_voice_where_it_is_coherent() {
    let folder = folder("impedance-recording");
    let _none = fs::remove_file(folder.join("a.mcap"));
    let recorded = ["record", "a.mcap", "--virtual-time", "--duration", "8"];
    assert_eq!(run(&folder, &recorded).code, Some(0));
    let range = ["--key", "F#3", "--frequency", "250..440", "--points", "12"];
    let stroke = report(&folder, &[&["--recording", "a.mcap"], &range[..]].concat());
    let voice = report(&folder, &[&["--what", "grand"], &range[..]].concat());
    let [stroke, voice] = [points(&stroke["curves"][0]), points(&voice["curves"][1])];
    let mut compared = 0;
    for (stroke, voice) in stroke.iter().zip(voice) {
        if number(&stroke["coherence"]) < 0.95 {
            continue;
        }
        let part = |name: &str| [stroke, voice].map(|it| number(&it[name]));
        let [[real, real_voice], [imaginary, imaginary_voice]] = [part("real"), part("imaginary")];
        let apart = (real - real_voice).hypot(imaginary - imaginary_voice);
        // A stroke passes through all depths, the voice is shaken at one. Common are the filter and
        // the mass that it feels, so that a wrong hold, sign or unit shows.
        let size = real_voice.hypot(imaginary_voice);
        assert!(apart < 0.4 * size, "{stroke}, the voice has {voice}");
        compared += 1;
    }
    assert!(compared >= 3, "{compared} points are coherent");
    let said =
        run(&folder, &["lab", "impedance", "--recording", "a.mcap", "--key", "C4", "--json"]);
    assert_eq!(said.code, Some(2), "{said:?}");
    check_words(&said, &["C4 of a.mcap moves for", "record more"]);
}

#[test]
fn every_mistake_is_said_in_a_sentence_of_its_own() {
    let folder = folder("impedance-mistakes");
    fs::write(folder.join("text.mcap"), "once upon a time").expect("a file");
    for (arguments, words) in [
        (&["--what", "grnd", "--key", "H4"][..], &["\"grnd\"", "--key \"H4\" is no key"][..]),
        (
            &["--what", "grand-springs", "--mode", "B3", "--depth", "12 mm", "--set", "k9=1"],
            &[
                "has no mode \"B3\": use",
                "--depth 12 mm is not in the key's way",
                "parameter \"k9\"",
            ],
        ),
        (&["--what", "grand", "--frequency", "5..1"], &["goes from 5 to 1 Hz, which is no range"]),
        (
            &["--what", "grand", "--frequency", "1..500"],
            &["held for 0.001 s is known up to 450 Hz"],
        ),
        (
            &["--what", "grand", "--frequency", "1..2 mm"],
            &["--frequency \"2 mm\" is no number of Hz"],
        ),
        (&["--what", "grand", "--frequency", "0..9"], &["not within 0.1 to 100000 Hz"]),
        (&["--what", "grand", "--amplitude", "1"], &["--amplitude 1 is not from"]),
        (&["--what", "grand", "--delay", "20 ms"], &["longer than 16 periods of 0.001 s"]),
        (&["--what", "grand", "--period", "20 ms"], &["a voice runs at 100 to 10000 Hz"]),
        (&["--what", "grand", "--estimator", "kalmann"], &["--estimator \"kalmann\" is none"]),
        (&["--recording", "text.mcap", "--delay", "-1 s"], &["--delay -1 is not from 0 to 1 s"]),
        (&["--recording", "text.mcap"], &["text.mcap"]),
    ] {
        let said = run(&folder, &[&["lab", "impedance"], arguments, &["--json"]].concat());
        assert_eq!((said.code, said.lines().len()), (Some(2), words.len()), "{said:?}");
        check_words(&said, words);
    }
}
