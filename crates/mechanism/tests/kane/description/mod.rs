mod bases;
mod drawing;
mod foreign;
mod keys;
mod limits;
mod meaning;
mod mistakes;
mod readme;
mod units;

use documents::toml::TomlSource;
use mechanism::kane::description::{Bases, Description, read, rendered};

/// Weight on a spring, with a wall on which it can lean.
pub(crate) const WEIGHT: &str = r#"
name = "weight"
summary = "a weight on a spring"
gravity = ["0", "-g"]
requires = ["m > 0.1*m0"]

[input]
name = "s"
unit = "m"
per_metre = "1"

[parameters]
g = { value = "9.81 m/s^2", range = [0, 1000], doc = "gravity" }
m = { value = "100 g", range = ["1 g", "10 kg"], title = "weight", doc = "the weight" }
m0 = { value = "0.1 kg", range = ["1 g", "10 kg"], doc = "a reference" }
k = { value = "20 N/m", range = ["1 N/m", "1 kN/m"], doc = "the spring" }
e = { value = 0.5, range = [0, 1], doc = "restitution" }

[presets.light]
values = { m = "20 g + 0.1 g * key" }

[presets.heavy]
values = { m = "2 kg" }

[definitions]
stretch = "y - s"
fall = "stretch'"

[coordinates]
y = { unit = "m", range = ["-2 m", "2 m"], speed_range = ["-10 m/s", "10 m/s"] }

[frames]
W = { in = "ground", origin = ["0 m", "y"] }

[points]
P = { in = "W", at = ["0 m", "1 cm"] }

[bodies]
weight = { frame = "W", mass = "m" }

[springs]
spring = { stretch = "stretch", stiffness = "k", damping = "1 N*s/m" }

[constraints]
wall = { zero = "y - 1 m" }

[modes.free]
constraints = []
[[modes.free.guards]]
name = "wall"
positive = "1 m - y"
to = "leaning"
set = { "y'" = "0 m/s" }

[modes.leaning]
[[modes.leaning.guards]]
name = "leave"
positive = "reaction(wall)"
to = "free"

[outputs]
F = { unit = "N", value = "force(spring)" }
top = { unit = "m", value = "y(P)" }

[rest]
mode = "free"
y = "s - m*g/k"
"#;

#[track_caller]
pub(crate) fn good(text: &str) -> Description {
    match read("test.toml", text, &()) {
        Ok(description) => description,
        Err(mistakes) => {
            let name = "test.toml".to_owned();
            panic!("{}", rendered(&mistakes, &[TomlSource { name, text: text.to_owned() }]))
        }
    }
}

/// Reads a text with mistakes; returns each as `line:column: message; help`.
#[track_caller]
pub(crate) fn mistakes_of(text: &str, bases: &dyn Bases) -> Vec<String> {
    let mistakes = read("test.toml", text, bases).expect_err("there are mistakes");
    let shown = mistakes.as_slice().iter().map(ToString::to_string);
    shown.map(|it| it.trim_start_matches("test.toml:").trim().to_owned()).collect()
}

#[track_caller]
pub(crate) fn mistake(old: &str, new: &str) -> String {
    assert!(WEIGHT.contains(old), "{old:?} is not there");
    let mistakes = mistakes_of(&WEIGHT.replacen(old, new, 1), &());
    assert_eq!(mistakes.len(), 1, "{mistakes:#?}");
    mistakes.into_iter().next().unwrap_or_default()
}
