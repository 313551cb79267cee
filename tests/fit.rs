//! `letoff lab fit`: a measured action becomes an instrument that plays.

use std::fs;
use std::path::Path;

use crate::letoff::{check_words, folder, run};

/// Allowed root mean square deviation of `grand` from the published curve (N).
///
/// The published one is flat between its corners; an action's curve has the slopes of its levers,
/// and from 6.3 mm on the spring of the repetition lever.
const PUBLISHED: f64 = 0.15;

fn published() -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fit/published.csv").display().to_string()
}

fn press(folder: &Path) -> String {
    let truth = ["t_pin=0.015", "leads=0.045", "button=0.0613"];
    let mut arguments = vec!["simulate", "grand", "--key", "39", "--until", "0.8"];
    arguments.extend(["--step", "1e-3", "--input", "s=0.01*sin(pi*t/0.8)^2", "--out", "t.csv"]);
    arguments.push("--set");
    arguments.extend(truth);
    let said = run(folder, &arguments);
    assert_eq!(said.code, Some(0), "{said:?}");
    let text = fs::read_to_string(folder.join("t.csv")).expect("a file");
    let mut rows = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = rows.next().expect("a header");
    let place = |name| header.iter().position(|it| *it == name).expect("a column");
    let [t, s, force] = ["t", "s", "F_KU"].map(place);
    let mut state = 1_u64;
    let rows = rows.step_by(4).map(|row| {
        // Noise of 10 mN, spread evenly.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let noise = ((state >> 40) as f64 / (1_u64 << 24) as f64 - 0.5) * 12.0_f64.sqrt() * 0.01;
        let force: f64 = row[force].parse().expect("a force");
        format!("{},{},{}\n", row[t], row[s], force + noise)
    });
    ["time_s,travel_m,force_n\n".to_owned()].into_iter().chain(rows).collect()
}

#[test]
fn a_grand_with_other_values_is_found_again_and_its_file_plays() {
    let folder = folder("fit-grand");
    fs::write(folder.join("press.csv"), press(&folder)).expect("a file");
    let fit = ["--fit", "t_pin,leads,button,Ks", "--out", "out", "--json"];
    let said = run(&folder, &[&["lab", "fit", "grand", "press.csv"][..], &fit].concat());
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""), "{said:?}");
    let report = said.report();
    for (at, truth) in [(0, 0.015), (1, 0.045), (2, 0.0613)] {
        let interval = &report["parameters"][at]["interval"];
        let end = |end: usize| interval[end].as_f64().expect("an end");
        assert!((end(0)..=end(1)).contains(&truth), "{truth} in {interval}");
        assert!((end(1) - end(0)) / truth < 0.1, "{truth} in {interval}");
    }
    assert!(report["remarks"].to_string().contains("(Ks) has no influence"), "{report}");
    for file in ["index.html", "parameters.csv", "force-1.svg", "residual-1.svg"] {
        assert!(folder.join("out").join(file).is_file(), "no {file}");
    }
    let said = run(&folder, &["check", "out/grand-fitted.toml"]);
    assert_eq!(said.code, Some(0), "{said:?}");
}

#[test]
fn a_grand_comes_near_to_the_published_curve() {
    let folder = folder("fit-published");
    let fit = ["--fit", "leads,button", "--speed", "20", "--out", "out", "--json"];
    let said = run(&folder, &[&["lab", "fit", "grand", &published()][..], &fit].concat());
    assert_eq!(said.code, Some(0), "{said:?}");
    let report = said.report();
    let error = |when: &str| report["strokes"][0][when].as_f64().expect("a number");
    assert!(error("after") < PUBLISHED && error("after") < error("before"), "{report}");
    assert!(report["remarks"].to_string().contains("cannot follow all of the data"), "{report}");
}

#[test]
fn every_mistake_is_told_at_once_and_nothing_is_written() {
    let folder = folder("fit-mistakes");
    fs::write(folder.join("few.csv"), "travel_m,force_n\n0,0.5\n").expect("a file");
    fs::write(folder.join("cell.csv"), "travel_m,force\n0,0.5\n").expect("a file");
    let data = ["few.csv", "cell.csv", "nowhere.csv"];
    let rest =
        ["--fit", "t_pn,leads", "--key", "H9", "--noise", "0", "--speed", "0", "--out", "out"];
    let said = run(&folder, &[&["lab", "fit", "grand"][..], &data, &rest].concat());
    assert_eq!((said.code, said.lines().len()), (Some(2), 8), "{said:?}");
    check_words(&said, &["no parameter \"t_pn\": use \"t_pin\"", "--key \"H9\" is no key"]);
    check_words(&said, &["--noise 0 is no spread", "--speed 0 is not from 0.01 to 1000 mm/s"]);
    check_words(&said, &["few.csv: 1 rows are no stroke", "no column \"force\": use \"force_n\""]);
    check_words(&said, &["nowhere.csv: cannot be read", "the column force_n is missing"]);
    let data = published();
    let said = run(&folder, &["lab", "fit", "grand", &data, "--out", "out"]);
    assert_eq!(said.code, Some(2), "{said:?}");
    check_words(&said, &["--fit must name the parameters", "t_pin            key friction [N·m]"]);
    assert!(!folder.join("out").exists());
}
