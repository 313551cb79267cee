//! Settings of `[render]` that change while the host plays.
//!
//! They are checked like a scene's and tried on simulated keys, and voices are built with them, all
//! off the tick. Each voice then continues from the state of the one before.

use std::collections::BTreeSet;

use documents::shortened;
use scene::{Instrument, Render};
use telemetry::request::RenderSetting;

use super::RequestHandler;
use super::current_voices::{CurrentVoices, single};
use super::new_voice::{NewVoice, VoiceHandover};
use figures::stability::{examine_keys, instabilities};
use figures::weight::WeightError;

impl RequestHandler {
    /// Computes all voices by `settings` from now on.
    ///
    /// # Errors
    /// A sentence on each mistake or unstable key.
    pub(super) fn change_settings(
        &self,
        settings: &[RenderSetting],
        who: &str,
    ) -> Result<String, String> {
        let tried = {
            let playing = self.playing();
            let render = self.changed(&playing, settings)?;
            playing.computed_by(render)
        };
        self.refuse_unstable_settings(&tried)?;
        let mut playing = self.playing();
        if self.changed(&playing, settings)? != tried.render {
            return Err("other settings were changed meanwhile; try again".to_owned());
        }
        let mut next = playing.computed_by(tried.render);
        let voices = (0..).zip(&playing.keys).filter_map(|(key, voice)| {
            let voice = voice.clone()?;
            Some((key, NewVoice { voice, handover: VoiceHandover::Settings }))
        });
        let catalogue = self.catalogue(tried.render, &playing.models(), &self.states());
        self.put_in(&mut next, voices.collect(), Some(catalogue), who)?;
        *playing = next;
        let named = |it: &RenderSetting| format!("{}={}", it.name, shortened(&it.value));
        let text = settings.iter().map(named).collect::<Vec<_>>().join(" ");
        self.tell(&text, who);
        Ok(text)
    }

    /// Tries `key` as it plays now; returns gain margin and weights. The error is a sentence.
    pub(super) fn margin(&self, key: u8) -> Result<String, String> {
        let keys = single(key)?;
        let scene = {
            let playing = self.playing();
            playing.voice(key)?;
            self.scene_of(&playing)
        };
        let found = examine_keys(&scene, keys).map_err(WeightError::from);
        let found = found.and_then(|found| found.with_figures(&scene));
        found.map(|it| it.to_string()).map_err(|it| it.to_string())
    }

    fn changed(
        &self,
        playing: &CurrentVoices,
        settings: &[RenderSetting],
    ) -> Result<Render, String> {
        let named = |it: &RenderSetting| (it.name.clone(), it.value.clone());
        let changes: Vec<_> = settings.iter().map(named).collect();
        let changed = playing.render.changed(self.scene.tick_hz, &changes);
        changed.map_err(|wrong| {
            let said = wrong.into_vec().into_iter();
            let said = said.map(|it| format!("{}: {}; {}", it.file, it.message, it.help));
            said.collect::<Vec<_>>().join("\n")
        })
    }

    fn refuse_unstable_settings(&self, tried: &CurrentVoices) -> Result<(), String> {
        let scene = self.scene_of(tried);
        let names: BTreeSet<_> = tried.instruments.iter().flatten().collect();
        for name in names {
            // The file of a name that loads no instrument was renamed.
            let Ok(instrument) = Instrument::load(&self.scene.library, name) else { continue };
            if let Some(unmet) = instrument.needs.unmet(name, scene.tick_hz, &scene.render) {
                return Err(unmet.to_string());
            }
        }
        let said = instabilities(&scene).map_err(|it| it.to_string())?;
        if said.is_empty() { Ok(()) } else { Err(said.join("\n")) }
    }
}
