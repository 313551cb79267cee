use boards::sim::keybed::SimulatedKeybed;
use engine::voice::VoiceBuilder;
use keyboard::{KeyIndex, KeyRange};
use scene::{Boards, LinksConfig as SceneLinks, Scene};

use super::key_source::{self, KeySource};
use super::trial::SimulatedKeys;
use super::{RunOptions, SessionError, patiently};
use crate::control::is_absent;
use figures::stability::instabilities;

/// Keys before a run, and the scene that plays on them.
pub struct FoundKeys {
    /// The scene with voices on these keys only, and with the delay of their links.
    pub scene: Box<Scene>,
    pub(super) source: KeySource,
}

impl std::fmt::Debug for FoundKeys {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("FoundKeys").field("scene", &self.scene.name).finish_non_exhaustive()
    }
}

impl FoundKeys {
    /// Simulates the keys of `scene`, or finds the boards that carry them; arms none. Missing or
    /// late boards are tried again for 5 s; in virtual time once, since a retry would be equal.
    ///
    /// # Errors
    /// If links cannot be opened, boards are missing or rejected, or their keys are not stable with
    /// the delay of their links.
    pub fn find(scene: &Scene, options: RunOptions) -> Result<Self, SessionError> {
        let find = || {
            let found = Self::find_now(scene, options)?;
            found.refuse_unstable()?;
            Ok(found)
        };
        if options.virtual_time { find() } else { patiently(find) }
    }

    fn find_now(scene: &Scene, options: RunOptions) -> Result<Self, SessionError> {
        let mut scene = Box::new(scene.clone());
        let period = VoiceBuilder::new(&scene)?.period().as_secs_f64();
        let mut source = match &scene.links {
            SceneLinks::Simulated => {
                let keybed = Box::new(SimulatedKeybed::new(period, scene.rig.parameters())?);
                KeySource::Simulated(SimulatedKeys::new(keybed))
            }
            SceneLinks::Boards(boards) => {
                refuse_other_time(boards, options)?;
                key_source::find(boards, scene.tick_hz)?
            }
        };
        if let Some(delay) = source.loop_delay(period) {
            scene.rig.delay = delay.max(scene.rig.delay);
        }
        for (key, voice) in scene.keys.iter_mut().enumerate() {
            voice.take_if(|_| !source.carries(key));
        }
        Ok(Self { scene, source })
    }

    fn refuse_unstable(&self) -> Result<(), SessionError> {
        if matches!(self.source, KeySource::Simulated(_)) {
            return Ok(());
        }
        let unstable = instabilities(&self.scene)?;
        if unstable.is_empty() {
            return Ok(());
        }
        Err(SessionError::Unstable(unstable.join("\nletoff: ")))
    }

    pub fn notices(&self) -> Vec<String> {
        let keys = KeyIndex::all().filter(|key| is_absent(&self.scene, key.index()));
        let absent = without_board(&keys.collect::<Vec<_>>());
        absent.into_iter().chain(self.source.notices()).collect()
    }
}

fn refuse_other_time(boards: &Boards, options: RunOptions) -> Result<(), SessionError> {
    let (programs, real): (Vec<_>, Vec<_>) =
        boards.buses.iter().map(|bus| &bus.address).partition(|it| it.kind.is_in_lockstep);
    match (options.virtual_time, programs.first(), real.first()) {
        (true, _, Some(_)) => Err(SessionError::RealBoards),
        (false, Some(program), _) => {
            Err(SessionError::VirtualBoards { program: program.place.clone() })
        }
        (true, _, None) | (false, None, _) => Ok(()),
    }
}

fn without_board(keys: &[KeyIndex]) -> Option<String> {
    let rows = keys.chunk_by(|key, next| key.number() + 1 == next.number());
    let ranges = rows.filter_map(|row| KeyRange::new(*row.first()?, *row.last()?));
    let ranges: Vec<_> = ranges.map(|range| range.to_string()).collect();
    let (n, ranges) = (keys.len(), ranges.join(", "));
    let have = if n == 1 { "key of the scene has" } else { "keys of the scene have" };
    (0 < n).then(|| format!("{n} {have} no board: {ranges}"))
}
