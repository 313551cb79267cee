//! Model descriptions through the command: checked, derived, simulated, played.

use std::path::{Path, PathBuf};

use crate::letoff::{Said, folder, run};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn shipped() -> Vec<PathBuf> {
    let mut all: Vec<PathBuf> = Vec::new();
    let listed = |folder: PathBuf| std::fs::read_dir(folder).expect("a folder").flatten();
    all.extend(listed(root().join("configs/models")).map(|entry| entry.path()));
    let models =
        listed(root().join("crates/instruments/src")).map(|it| it.path().join("model.toml"));
    all.extend(models.filter(|file| file.exists()));
    all.sort();
    all
}

fn good(folder: &Path, arguments: &[&str]) -> Said {
    let said = run(folder, arguments);
    assert_eq!(said.code, Some(0), "{said:?}");
    said
}

#[test]
fn every_shipped_description_is_good_and_shows_its_modes() {
    let folder = folder("descriptions-shipped");
    let files = shipped();
    assert!(files.len() >= 10, "{files:?}");
    for file in files {
        let file = file.to_str().expect("a path");
        let said = good(&folder, &["check", file]);
        assert!(said.out.contains("a good model"), "{said:?}");
        let said = good(&folder, &["instruments", file]);
        assert!(said.out.contains("mode ") && said.out.contains("p = "), "{said:?}");
    }
}

#[test]
fn mistakes_are_told_all_at_once_with_a_caret() {
    let folder = folder("descriptions-wrong");
    let file = folder.join("wrong.toml");
    let text = std::fs::read_to_string(root().join("configs/models/double-pendulum.toml"));
    let text =
        text.expect("the file").replace("m1*l1^2/12", "m1*l1^3/12").replace("s - phi1", "s - phi9");
    std::fs::write(&file, text).expect("a file");
    let said = run(&folder, &["check", "wrong.toml"]);
    assert_eq!(said.code, Some(2), "{said:?}");
    assert!(said.err.contains("\"phi9\"") && said.err.contains("phi1"), "{}", said.err);
    assert!(said.err.contains("kg·m²"), "{}", said.err);
    assert_eq!(said.err.lines().filter(|line| line.trim() == "^").count(), 2, "{}", said.err);
}

#[test]
fn equations_are_printed_and_a_first_file_is_written() {
    let folder = folder("descriptions-out");
    let said = good(&folder, &["model", "derive", "key-hammer-springs", "--mode", "B2"]);
    assert!(said.out.contains("theta_h_dot' = -cos(theta_h)*M2*g*L2/JH"), "{}", said.out);
    let clavichord = root().join("configs/models/clavichord.toml").display().to_string();
    let said = good(&folder, &["model", "derive", &clavichord, "--mode", "motion"]);
    assert!(
        said.out.contains("string leads to motion+string where its rebounds end"),
        "{}",
        said.out
    );
    let said = good(&folder, &["model", "derive", "bouncing-ball", "--notation", "latex"]);
    assert!(said.out.contains('\\'), "{}", said.out);
    let _left_from_an_earlier_run = std::fs::remove_file(folder.join("mine.toml"));
    good(&folder, &["model", "new", "mine.toml", "--from", "cart-pendulum"]);
    good(&folder, &["check", "mine.toml"]);
    let said = run(&folder, &["model", "new", "mine.toml"]);
    assert_eq!(said.code, Some(2), "a file that is there is left alone: {said:?}");
}

fn play(name: &str, file: &str, preset: &str) {
    let folder = folder(name);
    let file = root().join(file);
    let scene = format!(
        "title = \"Described\"\ntick_hz = 1000\n[[keys]]\nrange = \"A0..C8\"\nmodel = {:?}\n\
         preset = {preset:?}\n[midi]\noutput = \"none\"\n[pianist]\n\
         performance = \"beethoven-ode-to-joy\"\n",
        file.to_str().expect("a path")
    );
    std::fs::write(folder.join("scene.toml"), scene).expect("a file");
    let arguments = ["run", "scene.toml", "--virtual-time", "--duration", "3", "--json", "--quiet"];
    let said = good(&folder, &arguments);
    let report: serde_json::Value = serde_json::from_str(&said.out).expect("JSON");
    assert_eq!(report["faults"], 0, "{}", said.out);
    let notes = &report["notes"];
    assert!(notes["played"].as_u64().is_some_and(|played| played > 0), "{notes}");
    assert_eq!((&notes["struck"], &notes["missed"]), (&notes["played"], &0.into()), "{notes}");
}

#[test]
fn eighty_eight_keys_play_a_description() {
    play("descriptions-played", "crates/instruments/src/key_hammer_springs/model.toml", "playable");
}

#[test]
fn a_grand_sounds_where_its_hammers_meet_the_strings() {
    play("descriptions-grand", "configs/models/grand.toml", "default");
}
