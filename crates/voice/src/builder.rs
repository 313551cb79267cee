//! From a scene's values to a voice of whichever model they are of.

use std::sync::Arc;

use firmware_protocol::frame::key_forces::ForcePacking;
use haptics::{BackwardDifference, ForceGate, Kalman, RigParameters};
use models::Playable;
use models::catalogue::{self, Visitor};
use pode::{Limits, stepper};
use scheduler::time::Period;

use crate::audit::AuditCell;
use crate::input::{AnyEstimator, InputPath};
use crate::rendered_key::{RehearsableVoice, RenderedKey, SlopeOutput, VoiceSettings};
use scene::{
    EstimatorName, InputReconstruction, KeyVoice, LinksConfig, Render, Scene, StepperName,
};

/// A voice of any model.
pub type AnyVoice = Box<dyn RehearsableVoice>;

/// Why a scene's values make no voice.
#[derive(Debug, thiserror::Error)]
pub enum BuildError {
    #[error("model `{0}` is not in the catalogue; `letoff instruments` lists those that are")]
    NoSuchModel(&'static str),
    #[error("the scene's force limits cannot be kept: {0}")]
    Limits(#[from] haptics::LimitError),
    #[error("no tick can have {0} Hz")]
    Rate(u32),
}

/// Builds voices and keys of one scene.
#[derive(Clone, Debug)]
pub struct VoiceBuilder<'a> {
    scene: &'a Scene,
    period: Period,
    rig: RigParameters,
}

impl<'a> VoiceBuilder<'a> {
    /// Returns a builder for `scene`, on the simulated keybed's default rig.
    ///
    /// # Errors
    /// If the scene's rate cannot be kept.
    pub fn new(scene: &'a Scene) -> Result<Self, BuildError> {
        let period = Period::from_hz(scene.tick_hz).ok_or(BuildError::Rate(scene.tick_hz))?;
        Ok(Self { scene, period, rig: RigParameters::default() })
    }

    /// Returns the period of ticks.
    pub const fn period(&self) -> Period {
        self.period
    }

    /// Returns what every key of the simulated keybed is made of.
    pub const fn rig(&self) -> RigParameters {
        self.rig
    }

    /// Returns the keys that have a voice, each with what the scene says of it.
    pub fn keys(&self) -> impl Iterator<Item = (usize, &'a KeyVoice)> {
        self.scene.keys.iter().enumerate().filter_map(|(key, voice)| Some((key, voice.as_ref()?)))
    }

    /// Returns the slew limit of all forces (N/s).
    pub const fn slew_limit(&self) -> f64 {
        self.scene.render.slew_limit
    }

    /// Returns the voice of one key; its energy audit is published in `cell`.
    ///
    /// # Errors
    /// If its model or limits are refused.
    pub fn voice(&self, voice: &KeyVoice, cell: Arc<AuditCell>) -> Result<AnyVoice, BuildError> {
        self.numbered(voice, cell, 0)
    }

    /// Returns the same voice with the number `revision`, which its observations show.
    ///
    /// # Errors
    /// If its model or limits are refused.
    pub fn numbered(
        &self,
        voice: &KeyVoice,
        cell: Arc<AuditCell>,
        revision: u32,
    ) -> Result<AnyVoice, BuildError> {
        let name = voice.model.name;
        let h = self.period.as_secs_f64();
        let builder = Builder {
            render: &self.scene.render,
            values: &voice.values,
            h,
            quantum: self.rig.quantum,
            cell,
            slopes: slopes(&self.scene.links),
            revision,
        };
        catalogue::visit(name, builder).ok_or(BuildError::NoSuchModel(name))?
    }
}

/// Whether the boards of `links` render slopes.
fn slopes(links: &LinksConfig) -> SlopeOutput {
    match links {
        LinksConfig::Boards(boards) if boards.forces == ForcePacking::Force16Slope => {
            SlopeOutput::Rendered
        }
        LinksConfig::Boards(_) | LinksConfig::Simulated => SlopeOutput::Unused,
    }
}

/// Makes a voice of whichever model the catalogue finds.
struct Builder<'a> {
    render: &'a Render,
    values: &'a [f64],
    h: f64,
    /// Encoder step (m).
    quantum: f64,
    cell: Arc<AuditCell>,
    slopes: SlopeOutput,
    revision: u32,
}

impl Visitor for Builder<'_> {
    type Output = Result<AnyVoice, BuildError>;

    fn visit<M: Playable>(self) -> Self::Output {
        let model = M::with_values(self.values);
        let name = self.render.stepper;
        let by_need = stepper::ByNeed::new(self.render.error_budget, self.h);
        let fittings = self.fittings(model.input_per_metre())?;
        // The usual ones are compiled into the voice; the others cost it a choice per step.
        Ok(if name == StepperName::Rk4 {
            Box::new(RenderedKey::new(model, stepper::Rk4, fittings))
        } else if name == StepperName::ByNeed {
            Box::new(RenderedKey::new(model, by_need, fittings))
        } else {
            let any = stepper::Any::named(name.name()).unwrap_or_default();
            Box::new(RenderedKey::new(model, any, fittings))
        })
    }
}

impl Builder<'_> {
    fn fittings(self, scale: f64) -> Result<VoiceSettings, BuildError> {
        let Self { render, h, quantum, cell, slopes, revision, .. } = self;
        let estimator = match render.estimator {
            EstimatorName::Kalman => {
                AnyEstimator::Kalman(Kalman::new(h, quantum, render.jerk_density))
            }
            EstimatorName::BackwardDifference => {
                AnyEstimator::BackwardDifference(BackwardDifference::new(h))
            }
        };
        let reconstruction = match render.reconstruction {
            InputReconstruction::Estimate => None,
            InputReconstruction::Samples(kind) => Some(kind),
        };
        let limits = Limits {
            longest_step: render.longest_step,
            event_tolerance: render.event_tolerance,
            ..Limits::default()
        };
        let input = InputPath::new(estimator, reconstruction, scale, h);
        let gate = ForceGate::new(render.force_limit, render.slew_limit)?;
        Ok(VoiceSettings { input, gate, limits, cell, h, slopes, revision })
    }
}
