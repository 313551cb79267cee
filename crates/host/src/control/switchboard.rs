//! From a request to voices on their way into the lanes.

use std::sync::Arc;

use super::{Patchbay, Reply, Request, Stop, StopKind, Wish};
use crate::assemble::Assembler;
use crate::config::{Instrument, KeyVoice, Scene, keys_named};
use crate::realtime::clock;
use crate::realtime::pool::{BoxedVoice, Way};
use scheduler::time::Nanos;

/// Builds voices for a running scene and hands them to its lanes.
#[derive(Debug)]
pub struct Switchboard {
    scene: Scene,
    patchbay: Arc<Patchbay>,
}

impl Switchboard {
    /// For the host that runs `scene` and opens `patchbay` while it does.
    pub const fn new(scene: Scene, patchbay: Arc<Patchbay>) -> Self {
        Self { scene, patchbay }
    }

    /// Does what `wish` asks for. It is checked and built as a whole before a voice is
    /// sent; only a host that is flooded with requests may take a part of one.
    pub fn answer(&self, wish: &Wish) -> Reply {
        match wish {
            Wish::Switch(request) => {
                self.switch(request).map_or_else(Reply::Refused, Reply::Switched)
            }
            Wish::Stop(Stop { stop: StopKind::Emergency }) => self.stop(),
        }
    }

    /// Ends the run, and waits until every board was told.
    fn stop(&self) -> Reply {
        /// Looks, and the time between two.
        const LOOKS: u32 = 200;
        const LOOK: Nanos = Nanos::from_millis(5);
        self.patchbay.sound_alarm();
        for _ in 0..LOOKS {
            if self.patchbay.is_stopped() {
                return Reply::Stopped;
            }
            clock::sleep_until(clock::monotonic().after(LOOK));
        }
        Reply::Refused(
            "the host has not told its boards to stop within a second: cut their power".into(),
        )
    }

    fn switch(&self, request: &Request) -> Result<usize, String> {
        let instrument = Instrument::load(&request.instrument).map_err(|it| it.to_string())?;
        let range = keys_named(request.keys.as_deref().unwrap_or("A0..C8"))?;
        let voices = self.voices(&instrument, range)?;
        self.patchbay.send(voices, Way::Replace)
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
            let cell = self.patchbay.new_cell();
            Ok((usize::from(key), assembler.voice(&voice, cell).map_err(|it| it.to_string())? as _))
        };
        sounding.map(voice).collect()
    }
}
