//! Settings of `[render]` that change while a host plays.

use documents::toml::{FindingList, SourcePlace};
use documents::{Diagnostics, quoted};

use super::overrides;
use super::read::TableReader;
use super::render::{self, Render};
use super::source::{Override, SourceText, typed_place};

/// Limits that safety and boards keep for the whole run.
const FIXED: [&str; 2] = ["force_limit", "slew_limit"];

impl Render {
    /// Returns these settings, of ticks at `tick_hz`, with `changes`: names and values as in
    /// [`Scene::load`](super::Scene::load), `render.passivity` and `control`.
    ///
    /// # Errors
    /// All mistakes in them.
    pub fn changed(&self, tick_hz: u32, changes: &[(String, String)]) -> Result<Self, Diagnostics> {
        let mut present = toml_edit::DocumentMut::new();
        present["render"] = toml_edit::Item::Table(self.written());
        let source = SourceText {
            file: "the scene that plays".to_owned(),
            name: String::new(),
            folder: std::path::PathBuf::new(),
            text: present.to_string(),
            is_embedded: false,
        };
        let typed = |(name, value): &(String, String)| Override {
            name: name.clone(),
            value: value.clone(),
            typed: format!("{name}={value}"),
        };
        let changes: Vec<_> = changes.iter().map(typed).collect();
        let (mut report, root) = source.parsed(&changes);
        refuse_fixed(&mut report, &changes);
        let read = root.and_then(|mut root| {
            let settings = changes.iter().enumerate().filter(|(_, it)| setting(it).is_some());
            for (index, change) in settings {
                overrides::apply(&mut report, &mut root, index, change);
            }
            let mut reader = TableReader::new(&mut report, "the scene", &root)?;
            Some(render::read(&mut report, &mut reader, tick_hz))
        });
        report.verdict(read)
    }
}

fn setting(change: &Override) -> Option<&str> {
    change.name.strip_prefix("render.")
}

/// Reports names outside `[render]`, and fixed ones.
fn refuse_fixed(report: &mut FindingList, changes: &[Override]) {
    if changes.is_empty() {
        let help = "give one or more, as render.passivity=control";
        report.say(SourcePlace::default(), "no setting is given", help);
    }
    for (index, change) in changes.iter().enumerate() {
        if setting(change).is_some_and(|name| !FIXED.contains(&name)) {
            continue;
        }
        let message = format!("{} does not change while the host plays", quoted(&change.name));
        let help = if change.name.starts_with("keys.") {
            "change instruments by `letoff instruments use`"
        } else {
            "give settings of [render] but its limits, as render.passivity=control"
        };
        report.say(typed_place(index), message, help);
    }
}

#[cfg(test)]
mod tests {
    use super::super::PassivityMode;
    use super::*;

    fn changed(changes: &[(&str, &str)]) -> Result<Render, Vec<String>> {
        let owned = |(name, value): &(&str, &str)| ((*name).to_owned(), (*value).to_owned());
        let changes: Vec<_> = changes.iter().map(owned).collect();
        let before = Render { lead: 1e-3, ..Render::default() };
        let mistakes = |all: Diagnostics| all.into_vec().into_iter().map(|it| it.message).collect();
        before.changed(1000, &changes).map_err(mistakes)
    }

    #[test]
    fn settings_are_changed_as_a_scene_gives_them_and_the_others_stay() {
        let settings = changed(&[
            ("render.passivity", "control"),
            ("render.coupling_stiffness", "\"0.4 kN/m\""),
            ("render.jerk_density", "1e4"),
        ]);
        let wanted = Render {
            passivity: PassivityMode::Control,
            coupling_stiffness: 400.0,
            jerk_density: 1e4,
            lead: 1e-3,
            ..Render::default()
        };
        assert_eq!(settings, Ok(wanted));
    }

    #[test]
    fn all_that_is_wrong_is_said_at_once() {
        let wrong = changed(&[
            ("render.passivty", "control"),
            ("render.coupling_stiffness", "-1"),
            ("render.estimator", "guess"),
            ("render.force_limit", "30"),
            ("tick_hz", "4000"),
            ("keys.0.instrument", "grand"),
            ("render.longest_step", "1e-6"),
        ]);
        let wrong = wrong.expect_err("a mistake for each change");
        let said = ["passivty", "-1", "\"guess\"", "force_limit", "tick_hz", "keys.0", "may take"];
        assert_eq!(wrong.len(), said.len(), "{wrong:?}");
        assert!(said.iter().all(|word| wrong.iter().any(|it| it.contains(word))), "{wrong:?}");
        assert!(changed(&[]).is_err());
    }
}
