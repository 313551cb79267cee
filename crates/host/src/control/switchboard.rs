//! From a request to voices on their way into the lanes.

use std::sync::{Arc, Mutex, PoisonError};

use super::{Reply, Request};
use crate::adapters::audit::AuditCell;
use crate::assemble::Assembler;
use crate::config::{Instrument, KeyVoice, Scene, keys_named};
use crate::realtime::pool::{BoxedVoice, VoiceSwaps};

/// The way into the lanes, while there are any.
pub type Swaps = Arc<Mutex<Option<VoiceSwaps>>>;

/// Builds voices for a running scene and hands them to its lanes.
#[derive(Debug)]
pub struct Switchboard {
    scene: Scene,
    swaps: Swaps,
}

impl Switchboard {
    /// For the host that runs `scene` and fills `swaps` while it does.
    pub const fn new(scene: Scene, swaps: Swaps) -> Self {
        Self { scene, swaps }
    }

    /// Does what `request` asks for, as a whole or not at all.
    pub fn answer(&self, request: &Request) -> Reply {
        self.switch(request).map_or_else(Reply::Refused, Reply::Switched)
    }

    fn switch(&self, request: &Request) -> Result<usize, String> {
        let instrument = Instrument::load(&request.instrument).map_err(|it| it.to_string())?;
        let range = keys_named(request.keys.as_deref().unwrap_or("A0..C8"))?;
        let voices = self.voices(&instrument, range)?;
        let n = voices.len();
        let mut swaps = self.swaps.lock().unwrap_or_else(PoisonError::into_inner);
        let swaps = swaps.as_mut().ok_or("the host is not running yet, or not any more")?;
        for (key, voice) in voices {
            swaps.replace(key, voice).map_err(|refused| format!("key {key}: {refused}"))?;
        }
        Ok(n)
    }

    /// A voice for each key of `range` that has one in the scene.
    fn voices(
        &self,
        instrument: &Instrument,
        range: std::ops::RangeInclusive<u8>,
    ) -> Result<Vec<(usize, BoxedVoice)>, String> {
        let assembler = Assembler::new(&self.scene).map_err(|error| error.to_string())?;
        let sounding = range.filter(|key| self.scene.keys[usize::from(*key)].is_some());
        let voice = |key: u8| {
            let voice = KeyVoice { model: instrument.model(), values: instrument.values(key) };
            let cell = Arc::new(AuditCell::default());
            Ok((usize::from(key), assembler.voice(&voice, cell).map_err(|it| it.to_string())? as _))
        };
        sounding.map(voice).collect()
    }
}
