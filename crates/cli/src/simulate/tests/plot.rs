//! The plot: a whole SVG with every mode and event, of bounded size for any run.

use std::fs;

use super::{Folder, PAPER_MODELS, simulate, summary};

/// `[GC93]` figure 6: a throw, a harder throw that reaches the string, bounces.
const STROKE: &str = "s=0.099*exp(-((t-0.514)/0.079)^2)+0.181*exp(-((t-1.095)/0.109)^2)\
     +0.186*exp(-((t-1.573)/0.059)^2)";

#[track_caller]
fn plot(name: &str, words: &[&str]) -> Svg {
    let folder = Folder::new(name);
    let path = folder.path("plot.svg");
    simulate(&[words, &["--plot", &path]].concat()).expect("a run");
    Svg::read(&path)
}

struct Svg(String);

impl Svg {
    /// Reads a file and asserts that its tags are balanced.
    #[track_caller]
    fn read(path: &str) -> Self {
        let text = fs::read_to_string(path).expect("a plot");
        let mut open = Vec::new();
        for tag in text.split('<').skip(1) {
            let (tag, _) = tag.split_once('>').expect("a closed tag");
            assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
            let name = tag.split_whitespace().next().expect("a name");
            match name.strip_prefix('/') {
                Some(name) => assert_eq!(open.pop(), Some(name)),
                None if tag.ends_with('/') => {}
                None => open.push(name),
            }
        }
        assert!(open.is_empty() && text.starts_with("<svg "), "{open:?}");
        assert!(!text.contains("NaN") && !text.contains("inf"), "every place is a number");
        Self(text)
    }

    fn texts(&self) -> Vec<&str> {
        let bodies = self.0.split("<text").skip(1);
        bodies
            .filter_map(|body| Some(body.split_once('>')?.1.split_once("</text")?.0.trim()))
            .collect()
    }

    fn events(&self) -> usize {
        let lines = self.0.lines().filter(|line| line.starts_with("<polyline"));
        lines.filter(|line| line.contains("stroke=\"#5A5A5A\"")).count()
    }

    fn points(&self) -> usize {
        let lists = self.0.split("points=\"").skip(1);
        lists
            .map(|list| list.split('"').next().map_or(0, |points| points.matches(',').count()))
            .sum()
    }
}

#[test]
fn figure_6_shows_every_event_mode_curve_and_unit() {
    let words = ["key-hammer-springs", "--until", "3", "--step", "1e-3", "--input", STROKE];
    let svg = plot("figure-6", &words);
    assert_eq!(svg.events(), 12);
    assert_eq!(summary(&words)["counts"]["events"], 12);
    let texts = svg.texts();
    let releases = texts.iter().filter(|text| text.starts_with("release ") && text.ends_with(" s"));
    assert_eq!(releases.count(), 6);
    let wanted = ["key-hammer-springs", "rk4", "B1", "B2", "mode B1", "string 1.362 s"];
    let curves = ["s [rad]", "theta_h [rad]", "theta_k [rad]", "F_KH [N], left"];
    let axes = ["force [N]", "torque [N·m]", "guard / its peak [1]", "angle [rad]", "time t [s]"];
    for wanted in wanted.iter().chain(&curves).chain(&axes) {
        assert!(texts.contains(wanted), "{wanted} is not in {texts:?}");
    }
}

#[test]
fn every_model_has_a_plot_with_its_modes_and_both_axes_if_needed() {
    for name in PAPER_MODELS {
        let words = [name, "--until", "0.5", "--step", "1e-3", "--input", "s=0.1*sin(20*t)"];
        let texts = plot(name, &words).texts().join("\n");
        for wanted in ["mode ", "force [N]", "time t [s]", "guard / its peak [1]"] {
            assert!(texts.contains(wanted), "{wanted} of {name} in {texts}");
        }
    }
}

#[test]
fn a_run_of_any_length_gives_a_plot_of_bounded_size() {
    let words = ["bouncing-ball", "--until", "200", "--step", "1e-3"];
    let svg = plot("long", &[&words[..], &["--input", "s=0.01*sin(60*t)"]].concat());
    // Four curves, four points per column; axes, events and their names, two per line.
    assert!(svg.points() < 4 * 4 * 890 + 5000, "{}", svg.points());
    assert!(svg.events() <= 890, "{}", svg.events());
    assert!(svg.0.len() < 500_000, "{}", svg.0.len());
}

#[test]
fn one_long_tick_is_drawn_as_the_curve_that_it_is() {
    let svg = plot("tick", &["bouncing-ball", "--until", "0.4", "--step", "0.4"]);
    assert!(svg.points() > 890, "{}", svg.points());
}

#[test]
fn a_fault_leaves_the_plot_up_to_there() {
    let folder = Folder::new("plot-fault");
    let path = folder.path("plot.svg");
    let words = ["bouncing-ball", "--until", "2", "--step", "0.25", "--input", "s=0.1/(1-t)-1"];
    simulate(&[&words[..], &["--plot", &path]].concat()).expect_err("a fault");
    // On the floor at 0.434 s and at 0.896 s; at 1 s the input is not finite.
    assert_eq!(Svg::read(&path).events(), 2);
}

#[test]
fn extreme_numbers_are_drawn_too() {
    let springs = ["key-hammer-springs", "--until", "0.01", "--step", "1e-3"];
    plot("huge", &["bouncing-ball", "--until", "0.01", "--step", "1e-3", "--initial", "v=1e150"]);
    plot("largest", &[&springs[..], &["--initial", "theta_h=1e308"]].concat());
    plot("tiny", &["bouncing-ball", "--until", "1e-12", "--step", "1e-12"]);
    plot("slow", &["bouncing-ball", "--until", "1e12", "--step", "1e9"]);
}
