use mechanism::kane::description::{Bases, read, rendered};

const README: &str = include_str!("../../../LANGUAGE.md");

struct Before<'a>(&'a [(String, &'a str)]);

impl Bases for Before<'_> {
    fn load(&self, base: &str, _from: &str) -> Result<(String, Vec<u8>), String> {
        let found = self.0.iter().find(|(name, _)| name == base);
        let (name, text) = found.ok_or_else(|| "there is no such example".to_owned())?;
        Ok((name.clone(), text.as_bytes().to_vec()))
    }
}

fn examples() -> Vec<&'static str> {
    README.split("```toml\n").skip(1).filter_map(|it| it.split("```").next()).collect()
}

#[test]
fn every_example_is_a_description() {
    let mut before: Vec<(String, &str)> = Vec::new();
    for text in examples() {
        let read = read("example.toml", text, &Before(&before));
        let description =
            read.unwrap_or_else(|mistakes| panic!("{text}\n{}", rendered(&mistakes, &[])));
        before.push((format!("{}.toml", description.mechanism.name), text));
    }
    assert!(before.len() >= 3, "examples were not found");
}
