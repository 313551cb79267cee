//! Builds a voice of any model from a scene's values.

use std::sync::Arc;

use firmware_protocol::frame::key_forces::ForcePacking;
use firmware_protocol::quantity::SpeedCode;
use haptics::{
    DeviceCompensation, EnergyBound, ForceGate, PassivityController, PassivityObserver,
    RigParameters,
};
use instruments::{ModelEntry, Playable, Visitor};
use pode::Limits;
use pode::stepper::{self, Any};
use scheduler::observation::MAX_STATES;
use scheduler::time::Period;
use scheduler::values::MAX_VALUES;

use crate::voice::audit::AuditCell;
use crate::voice::coupling::{Coupling, CouplingConstants};
use crate::voice::input::InputPath;
use crate::voice::rendered_key::{
    Gains, RehearsableVoice, RenderedKey, SlopeOutput, VoiceSettings,
};
use scene::{InputReconstruction, KeyVoice, LinksConfig, PassivityMode, Render, Scene};

/// A voice of any model.
pub type AnyVoice = Box<dyn RehearsableVoice>;

/// Reason why a scene's values yield no voice.
#[derive(Debug, thiserror::Error)]
pub enum BuildError {
    #[error("model `{model}` has {found} {what}, more than the {most} that a voice can have")]
    TooLarge {
        model: &'static str,
        /// Plural noun of the entities above the limit.
        what: &'static str,
        found: usize,
        most: usize,
    },
    #[error("the scene's force limits cannot be kept: {0}")]
    Limits(#[from] haptics::LimitError),
    #[error("no tick can have {0} Hz")]
    Rate(u32),
}

/// Builder of the voices and keys of one scene.
#[derive(Clone, Debug)]
pub struct VoiceBuilder<'a> {
    scene: &'a Scene,
    period: Period,
    rig: RigParameters,
}

impl<'a> VoiceBuilder<'a> {
    pub fn new(scene: &'a Scene) -> Result<Self, BuildError> {
        let period = Period::from_hz(scene.tick_hz).ok_or(BuildError::Rate(scene.tick_hz))?;
        Ok(Self { scene, period, rig: scene.rig.parameters() })
    }

    pub const fn period(&self) -> Period {
        self.period
    }

    pub const fn rig(&self) -> RigParameters {
        self.rig
    }

    /// Returns the keys with a voice, each with its settings in the scene.
    pub fn keys(&self) -> impl Iterator<Item = (usize, &'a KeyVoice)> {
        self.scene.keys.iter().enumerate().filter_map(|(key, voice)| Some((key, voice.as_ref()?)))
    }

    /// Returns the slew limit of all forces (N/s).
    pub const fn slew_limit(&self) -> f64 {
        self.scene.render.slew_limit
    }

    /// Returns the voice of one key, which publishes its energy audit in `cell`.
    pub fn voice(&self, voice: &KeyVoice, cell: Arc<AuditCell>) -> Result<AnyVoice, BuildError> {
        self.numbered(voice, cell, 0)
    }

    /// Like [`Self::voice`], with the number `revision`, which its observations contain.
    pub fn numbered(
        &self,
        voice: &KeyVoice,
        cell: Arc<AuditCell>,
        revision: u32,
    ) -> Result<AnyVoice, BuildError> {
        refuse_large(&voice.model)?;
        let h = self.period.as_secs_f64();
        let builder = Builder {
            render: &self.scene.render,
            values: &voice.values,
            h,
            rig: self.rig,
            delay: self.scene.rig.delay,
            cell,
            slopes: slopes(&self.scene.links),
            speed_step: speed_step(&self.scene.links),
            revision,
        };
        voice.model.visit(builder)
    }
}

fn refuse_large(model: &ModelEntry) -> Result<(), BuildError> {
    let counts = [
        ("states", model.states.len(), MAX_STATES),
        ("parameters", model.parameters.len(), MAX_VALUES),
    ];
    for (what, found, most) in counts {
        if most < found {
            return Err(BuildError::TooLarge { model: model.name, what, found, most });
        }
    }
    Ok(())
}

fn slopes(links: &LinksConfig) -> SlopeOutput {
    match links {
        LinksConfig::Boards(boards) if boards.forces == ForcePacking::Force16Slope => {
            SlopeOutput::Rendered
        }
        LinksConfig::Boards(_) | LinksConfig::Simulated => SlopeOutput::Unused,
    }
}

/// Returns the steps of the speeds (m/s) measured by the boards of `links`, if any.
fn speed_step(links: &LinksConfig) -> Option<f64> {
    let LinksConfig::Boards(boards) = links else { return None };
    let step = 1e-6 * f64::from(SpeedCode::MICROMETRES_PER_SECOND);
    boards.samples.has_velocity().then_some(step)
}

struct Builder<'a> {
    render: &'a Render,
    values: &'a [f64],
    h: f64,
    rig: RigParameters,
    /// Time from a force's arrival to its effect (s).
    delay: f64,
    cell: Arc<AuditCell>,
    slopes: SlopeOutput,
    /// Steps of the speeds (m/s) measured by boards, if any.
    speed_step: Option<f64>,
    revision: u32,
}

impl Visitor for Builder<'_> {
    type Output = Result<AnyVoice, BuildError>;

    /// One voice type per model size for the method of most scenes, and one for all others, so that
    /// a further model compiles no code.
    fn visit<M: Playable>(self, model: M) -> Self::Output {
        let model = model.with_values(self.values);
        let by_need = stepper::ByNeed::new(self.render.error_budget, self.h);
        let asked = self.render.stepper;
        let settings = self.settings(model.input_per_metre())?;
        if let Any::Newmark(newmark) = asked {
            return Ok(Box::new(RenderedKey::new(model, newmark, settings)));
        }
        let stepper = if let Any::ByNeed(_) = asked { Any::ByNeed(by_need) } else { asked };
        Ok(Box::new(RenderedKey::new(model, stepper, settings)))
    }
}

impl Builder<'_> {
    fn settings(self, scale: f64) -> Result<VoiceSettings, BuildError> {
        let Self { render, h, rig, delay, cell, slopes, speed_step, revision, .. } = self;
        let estimator = render.estimator(h, rig.quantum);
        let estimator = speed_step.map_or(estimator, |step| estimator.with_measured_speed(step));
        let reconstruction = match render.reconstruction {
            InputReconstruction::Estimate => None,
            InputReconstruction::Samples(kind) => Some(kind),
        };
        let limits = Limits {
            longest_step: render.longest_step,
            event_tolerance: render.event_tolerance,
            ..Limits::default()
        };
        let scale = scale * render.motion_gain;
        let input = InputPath::new(estimator, reconstruction, scale, h).with_lead(render.lead);
        let gate = ForceGate::new(render.force_limit, render.slew_limit)?;
        let dip = rig.key.bottom_stop.position;
        let bound = EnergyBound::of_force_limit(gate.limit(), dip);
        let passivity = PassivityObserver::new(bound, h);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some ticks")]
        let late = (delay / h).round() as usize;
        let controller = match render.passivity {
            PassivityMode::Observe => None,
            PassivityMode::Control => {
                let controller = PassivityController::new(render.energy_tank, dip, h);
                Some(controller.with_delay(late))
            }
        };
        let constants = CouplingConstants {
            stiffness: render.coupling_stiffness,
            damping: render.coupling_damping,
        };
        let coupling = (0.0 < constants.stiffness).then(|| Coupling::new(constants));
        let parts = (render.inertia_compensation, render.friction_compensation);
        let device =
            (parts != (0.0, 0.0)).then(|| DeviceCompensation::new(rig.key, parts.0, parts.1));
        let gains = Gains { motion: render.motion_gain, force: render.force_gain };
        Ok(VoiceSettings {
            input,
            coupling,
            gains,
            device,
            gate,
            passivity,
            controller,
            limits,
            cell,
            h,
            slopes,
            revision,
        })
    }
}

#[cfg(test)]
mod tests {
    use scene::Library;
    use scheduler::motion::KeySample;
    use scheduler::values::ModelValues;
    use scheduler::voice::VoiceOutput;

    use super::*;

    fn forces(voice: &mut AnyVoice) -> Vec<u64> {
        voice.reset(&KeySample::fresh(0.0));
        let position = |tick: u64| 1e-4 * (100.0 - (tick as f64 - 100.0).abs()).max(0.0);
        let force = |tick| {
            let mut turn = VoiceOutput::default();
            voice.tick(tick, &KeySample::fresh(position(tick)), &mut turn);
            turn.force.to_bits()
        };
        (0..300).map(force).collect()
    }

    fn pressed(tick: u64) -> f64 {
        let part = (tick as f64 / 60.0).min(1.0);
        9e-3 * part * part * (3.0 - 2.0 * part)
    }

    fn strikes(renders: &[(u64, Render)]) -> usize {
        let scene = Scene::load(&Library::default(), "springs", &[]).unwrap();
        let key = scene.keys[39].as_ref().unwrap();
        let voice = |render| {
            let scene = Scene { render, ..scene.clone() };
            VoiceBuilder::new(&scene).unwrap().voice(key, Arc::default()).unwrap()
        };
        let mut playing = voice(scene.render);
        playing.reset(&KeySample::fresh(0.0));
        let mut strikes = 0;
        for tick in 0..600 {
            for (_, render) in renders.iter().filter(|(at, _)| *at == tick) {
                let mut next = voice(*render);
                assert!(next.take_over(&*playing));
                playing = next;
            }
            let mut turn = VoiceOutput::default();
            playing.tick(tick, &KeySample::fresh(pressed(tick)), &mut turn);
            assert_eq!(turn.fault, None, "tick {tick} of {renders:?}");
            strikes += turn.events.strikes();
        }
        strikes
    }

    #[test]
    fn settings_that_change_while_a_key_is_played_sound_no_other_note() {
        let before = Scene::load(&Library::default(), "springs", &[]).unwrap().render;
        assert_eq!(strikes(&[]), 1);
        let control = Render { passivity: PassivityMode::Control, ..before };
        let coupled = Render { coupling_stiffness: 2e3, coupling_damping: 4.0, ..control };
        let levant = Render { estimator: haptics::EstimatorName::Levant, ..coupled };
        let longer = Render { motion_gain: 1.2, ..before };
        for at in (5..200).step_by(5) {
            let all = [control, coupled, levant, before, longer, before];
            let changes: Vec<_> = (0..).map(|n| at + 7 * n).zip(all).collect();
            assert_eq!(strikes(&changes), 1, "from tick {at} on");
        }
    }

    #[test]
    fn a_retuned_voice_is_the_voice_that_is_built_with_those_values() {
        let scene = Scene::load(&Library::default(), "springs", &[]).unwrap();
        let builder = VoiceBuilder::new(&scene).unwrap();
        let key = scene.keys[39].as_ref().unwrap();
        let stiffness = key.model.parameters.iter().position(|it| it.name == "k2").unwrap();
        let mut other = key.clone();
        other.values[stiffness] *= 1.5;
        let mut voices = [key, &other, key].map(|it| builder.voice(it, Arc::default()).unwrap());
        let values = ModelValues::new(key.model.id(), 7, &other.values).unwrap();
        assert!(voices[2].retune(&values));
        assert!(!voices[2].retune(&ModelValues::new(0, 8, &[]).unwrap()));
        let [first, built, retuned] = voices.each_mut().map(forces);
        assert_ne!(first, built);
        assert_eq!(built, retuned);
    }
}
