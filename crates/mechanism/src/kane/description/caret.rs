use documents::Diagnostics;
use documents::toml::TomlSource;

/// Returns all mistakes as a terminal shows them, each with its line and a caret under the place.
pub fn rendered(mistakes: &Diagnostics, sources: &[TomlSource]) -> String {
    let text_of = |file: &str| {
        let source = sources.iter().find(|source| source.name == file);
        source.map(|source| source.text.clone())
    };
    documents::rendered(mistakes, &text_of)
}
