//! Re-reads a scene while it plays: all its changes are applied live, or none.

use std::collections::BTreeMap;

use scene::{KeyVoice, LinksConfig, MidiInput, Render, Scene};

use super::RequestHandler;
use super::current_voices::{CurrentVoices, is_absent};
use super::new_voice::{NewVoice, VoiceHandover};
use figures::stability::instabilities;

impl RequestHandler {
    /// Plays `scene`, read again from its file: its instruments, values and settings of `[render]`
    /// replace all later changes.
    ///
    /// # Errors
    /// A sentence if a difference needs a restart, or a key would not be stable; nothing changes.
    pub fn reload(&self, mut scene: Scene, who: &str) -> Result<String, String> {
        self.put_on_same_keys(&mut scene);
        let fixed = self.fixed_differences(&scene);
        if !fixed.is_empty() {
            return Err(format!(
                "the scene was not taken, since {} cannot change while it plays: start the host \
                 anew for that",
                fixed.join(", ")
            ));
        }
        keep_fidelity(&mut scene, &self.playing());
        let mut next = CurrentVoices::new(&scene);
        let said = instabilities(&self.scene_of(&next)).map_err(|it| it.to_string())?;
        if !said.is_empty() {
            return Err(said.join("\n"));
        }
        let mut playing = self.playing();
        let voices = playing.differences(&next);
        let n = voices.len();
        if 0 < n {
            let catalogue = self.catalogue(next.render, &next.models(), &self.states());
            self.put_in(&mut next, voices, Some(catalogue), who)?;
        }
        *playing = next;
        let text = format!("the scene was read again: {n} keys changed");
        self.tell(&text, who);
        Ok(text)
    }

    /// Omits the keys of `scene` without a board, and sets the delay of the links.
    fn put_on_same_keys(&self, scene: &mut Scene) {
        if matches!(scene.links, LinksConfig::Simulated) {
            return;
        }
        scene.rig.delay = scene.rig.delay.max(self.scene.rig.delay);
        for (key, voice) in scene.keys.iter_mut().enumerate() {
            voice.take_if(|_| is_absent(&self.scene, key));
        }
    }

    fn fixed_differences(&self, scene: &Scene) -> Vec<&'static str> {
        let old = &self.scene;
        let has_voice =
            |scene: &Scene| -> Vec<bool> { scene.keys.iter().map(Option::is_some).collect() };
        let limits = |render: &Render| [render.force_limit, render.slew_limit].map(f64::to_bits);
        let hears_programs = scene.midi.input != MidiInput::None;
        let differs = [
            ("tick_hz", old.tick_hz != scene.tick_hz),
            ("lanes", old.realtime.lanes != scene.realtime.lanes),
            ("[overload]", old.overload != scene.overload),
            ("[links]", old.links != scene.links),
            ("[rig]", old.rig != scene.rig),
            ("[midi]", old.midi != scene.midi),
            ("[pianist]", old.play_list != scene.play_list),
            ("force_limit or slew_limit", limits(&old.render) != limits(&scene.render)),
            ("which keys have a voice", has_voice(old) != has_voice(scene)),
            // Ranges are the channels of program changes.
            ("the ranges of [[keys]]", hears_programs && old.ranges != scene.ranges),
        ];
        differs.into_iter().filter_map(|(name, differs)| differs.then_some(name)).collect()
    }
}

/// Gives ranges of `scene` without a fixed fidelity the playing one.
fn keep_fidelity(scene: &mut Scene, playing: &CurrentVoices) {
    for range in std::mem::take(&mut scene.fidelity.ranges) {
        let voice = range.keys.numbers().find_map(|key| playing.keys[usize::from(key)].as_ref());
        let plays =
            |model: &instruments::ModelEntry| voice.is_some_and(|voice| voice.model.is(model));
        let chosen = range.levels.iter().find(|level| plays(&level.voicing.model));
        if let Some(level) = chosen.or_else(|| range.levels.first()) {
            scene.set_fidelity(range.keys, level);
        }
    }
}

impl CurrentVoices {
    fn differences(&self, next: &Self) -> BTreeMap<u8, NewVoice> {
        let pairs = (0..).zip(self.keys.iter().zip(&next.keys));
        let other = |(key, (old, new)): (u8, (&Option<KeyVoice>, &Option<KeyVoice>))| {
            let (old, new) = (old.as_ref()?, new.as_ref()?);
            let handover = self.handover(next, key, (old, new))?;
            Some((key, NewVoice { voice: new.clone(), handover }))
        };
        pairs.filter_map(other).collect()
    }

    /// Returns the handover of `key` to its voice in `next`; `None` if they are equal.
    fn handover(
        &self,
        next: &Self,
        key: u8,
        (old, new): (&KeyVoice, &KeyVoice),
    ) -> Option<VoiceHandover> {
        if !old.model.is(&new.model) {
            let voicing = next.voicings[usize::from(key)].clone()?;
            if old.model.file().is_some() && old.model.file() == new.model.file() {
                return Some(VoiceHandover::Version(voicing));
            }
            let name = next.instruments[usize::from(key)].clone();
            let name = name.unwrap_or_else(|| new.model.name.to_owned());
            return Some(VoiceHandover::Anew(voicing, name));
        }
        if self.render != next.render {
            return Some(VoiceHandover::Settings);
        }
        let bits =
            |voice: &KeyVoice| -> Vec<u64> { voice.values.iter().map(|it| it.to_bits()).collect() };
        (bits(old) != bits(new)).then_some(VoiceHandover::Values)
    }
}
