//! The keys that a scene asks for, and whether they are stable on the links that they were found on.

use hardware::sim::keybed::SimulatedKeybed;
use scene::{LinksConfig as SceneLinks, Scene};

use super::key_source::{self, KeySource};
use super::trial::SimulatedKeys;
use super::{RunOptions, SessionError};
use crate::control::RunHandle;
use crate::stability::instabilities;

/// Returns the keys of a scene with ticks of `period` (s); and the scene with the delay of their
/// links, if there are any.
pub(super) fn find(
    scene: &Scene,
    period: f64,
    options: RunOptions,
    handle: &RunHandle,
) -> Result<(KeySource, Option<Scene>), SessionError> {
    let mut keys = match &scene.links {
        SceneLinks::Simulated => {
            let keybed = Box::new(SimulatedKeybed::new(period, scene.rig.parameters())?);
            KeySource::Simulated(SimulatedKeys::new(keybed))
        }
        SceneLinks::Boards(_) if options.virtual_time => return Err(SessionError::RealBoards),
        SceneLinks::Boards(boards) => key_source::find(boards, scene.tick_hz)?,
    };
    let measured = keys.loop_delay(period).map(|delay| on_links(scene, delay));
    if let Some(measured) = &measured {
        refuse_unstable(measured, &keys)?;
        handle.set_loop_delay(measured.rig.delay);
    }
    Ok((keys, measured))
}

/// Returns `scene` on links with this delay (s), or with its own if that is longer.
fn on_links(scene: &Scene, delay: f64) -> Scene {
    let mut measured = scene.clone();
    measured.rig.delay = delay.max(scene.rig.delay);
    measured
}

/// Tries the keys of `scene` that boards carry, with the delay that was measured on their links.
fn refuse_unstable(scene: &Scene, keys: &KeySource) -> Result<(), SessionError> {
    let mut carried = scene.clone();
    for (key, voice) in carried.keys.iter_mut().enumerate() {
        voice.take_if(|_| !keys.carries(key));
    }
    let unstable = instabilities(&carried)?;
    if unstable.is_empty() {
        return Ok(());
    }
    Err(SessionError::Unstable(unstable.join("\nletoff: ")))
}
