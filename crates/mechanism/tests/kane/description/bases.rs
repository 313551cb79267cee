use mechanism::kane::description::{Bases, read};

use super::{WEIGHT, mistakes_of};

struct Shelf(Vec<(&'static str, String)>);

impl Bases for Shelf {
    fn load(&self, base: &str, _from: &str) -> Result<(String, Vec<u8>), String> {
        let found = self.0.iter().find(|(name, _)| *name == base);
        let (name, text) = found.ok_or_else(|| "there is no such file".to_owned())?;
        Ok(((*name).to_owned(), text.clone().into_bytes()))
    }
}

fn shelf(text: &str) -> Shelf {
    Shelf(vec![("weight.toml", WEIGHT.to_owned()), ("other.toml", text.to_owned())])
}

#[test]
fn a_description_changes_its_base_key_by_key() {
    let text = r#"
name = "heavier"
base = "weight.toml"
remove = ["presets.light", "outputs.top"]
[parameters]
m = { value = "3 kg" }
[presets.steel]
doc = "a weight of steel"
"#;
    let description = read("test.toml", text, &shelf("")).expect("it is good");
    let mechanism = &description.mechanism;
    assert_eq!(mechanism.name, "heavier");
    assert_eq!(mechanism.instrument.summary, "a weight on a spring");
    assert_eq!(mechanism.parameters[1].range, (0.001, 10.0));
    let presets: Vec<_> = mechanism.instrument.presets.iter().map(|it| it.name.as_str()).collect();
    assert_eq!(presets, ["heavy", "steel"]);
    assert_eq!(mechanism.graph.number(mechanism.instrument.presets[1].values[1]), Some(3.0));
    assert_eq!(mechanism.outputs.len(), 1);
    let names: Vec<_> = description.sources.iter().map(|it| it.name.as_str()).collect();
    assert_eq!(names, ["test.toml", "weight.toml"]);
}

#[track_caller]
fn says(text: &str, other: &str, part: &str) {
    let mistakes = mistakes_of(text, &shelf(other));
    assert!(mistakes.iter().any(|it| it.contains(part)), "{part:?} is not in {mistakes:?}");
}

#[test]
fn circles_of_bases_end() {
    let text = "name = \"a\"\nbase = \"other.toml\"";
    says(text, "base = \"test.toml\"", "cannot be read, there is no such file");
    says(text, "base = \"other.toml\"", "starts from this description itself");
}

#[test]
fn what_is_wrong_with_a_base_is_said() {
    says("base = \"none.toml\"", "", "\"none.toml\" cannot be read");
    says("base = 3", "", "\"base\" is a number, not text");
    says("base = \"weight.toml\"\nremove = [\"springs.k9\"]", "", "the base has no \"springs.k9\"");
    let mistakes = mistakes_of("name = \"a\"\nbase = \"other.toml\"", &shelf("x = ="));
    assert!(mistakes.iter().any(|it| it.starts_with("other.toml:1:5")), "{mistakes:?}");
}

#[test]
fn a_mistake_in_a_base_is_shown_there() {
    let other = WEIGHT.replacen("\"y - s\"", "\"y - zz\"", 1);
    let mistakes = mistakes_of("name = \"a\"\nbase = \"other.toml\"", &shelf(&other));
    assert_eq!(mistakes.len(), 1, "{mistakes:?}");
    assert!(mistakes[0].starts_with("other.toml:26:16: there is no \"zz\""), "{mistakes:?}");
}

#[test]
fn a_chain_of_bases_has_an_end() {
    struct Endless;
    impl Bases for Endless {
        fn load(&self, base: &str, _from: &str) -> Result<(String, Vec<u8>), String> {
            Ok((base.to_owned(), format!("base = \"{base}x\"").into_bytes()))
        }
    }
    let mistakes = mistakes_of("base = \"x\"", &Endless);
    assert!(mistakes.iter().any(|it| it.contains("more than 8 descriptions")), "{mistakes:?}");
}
