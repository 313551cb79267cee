use std::sync::Arc;

use crate::stability::{LoopQuantity, TrialAnswer, TrialVoice, VoiceOrder};
use engine::voice::{AnyVoice, VoiceBuilder};
use haptics::RigParameters;
use instruments::LoadedModel;
use scene::{KeyVoice, Library, Scene};
use scheduler::motion::KeySample;
use scheduler::voice::{VoiceFault, VoiceOutput};

/// Allowed rates of a voice (Hz), as in scenes.
const RATES: (f64, f64) = (100.0, 10_000.0);

/// Encoder step for a filter if the encoder has none (m).
const FINEST_STEP: f64 = 1e-9;

/// Makes voices of one model, rendered as scenes do by default.
#[derive(Debug)]
pub(crate) struct InstrumentVoices {
    pub(crate) model: Arc<LoadedModel>,
    scene: Scene,
}

impl InstrumentVoices {
    pub(crate) fn new(model: &Arc<LoadedModel>) -> Result<Self, String> {
        let scene = Scene::load(&Library::default(), "springs", &[]);
        let scene = scene.map_err(|wrong| mechanism::rendered(&wrong))?;
        Ok(Self { model: Arc::clone(model), scene })
    }

    pub(crate) fn rig(&self) -> Result<RigParameters, String> {
        let builder = VoiceBuilder::new(&self.scene).map_err(|error| error.to_string())?;
        Ok(builder.rig())
    }

    pub(crate) fn make(&self, order: &VoiceOrder<'_>) -> Result<Box<dyn TrialVoice>, String> {
        let hz = (1.0 / order.values.get(LoopQuantity::Period)).round();
        if !(RATES.0..=RATES.1).contains(&hz) {
            return Err(format!("a voice runs at {} to {} Hz, not at {hz}", RATES.0, RATES.1));
        }
        let mut scene = self.scene.clone();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in range")]
        {
            scene.tick_hz = hz as u32;
        }
        scene.render.estimator = order.estimator;
        let damping = order.values.get(LoopQuantity::Damping);
        if damping < 0.0 {
            return Err(format!("a coupling's damping is {damping} N·s/m; give at least 0"));
        }
        scene.render.coupling_stiffness = order.values.get(LoopQuantity::Stiffness);
        scene.render.coupling_damping = damping;
        scene.rig.encoder_step = order.values.get(LoopQuantity::EncoderStep).max(FINEST_STEP);
        scene.render.jerk_density = order.values.get(LoopQuantity::JerkDensity);
        let key = KeyVoice {
            model: Arc::clone(&self.model),
            values: order.parameters.to_vec(),
            file: None,
        };
        let builder = VoiceBuilder::new(&scene).map_err(|error| error.to_string())?;
        let voice = builder.voice(&key, Arc::default()).map_err(|error| error.to_string())?;
        Ok(Box::new(TriedVoice { voice, turn: VoiceOutput::default(), is_new: true }))
    }
}

struct TriedVoice {
    voice: AnyVoice,
    turn: VoiceOutput,
    is_new: bool,
}

impl TrialVoice for TriedVoice {
    fn answer(&mut self, tick: u64, position: f64) -> TrialAnswer {
        let sample = KeySample::fresh(position);
        if self.is_new {
            self.voice.reset(&sample);
            self.is_new = false;
        }
        self.turn.begin();
        self.voice.tick(tick, &sample, &mut self.turn);
        match self.turn.fault {
            None => TrialAnswer::Force(self.turn.force),
            Some(VoiceFault::MakesEnergy) => TrialAnswer::Muted,
            Some(_) => TrialAnswer::Failed,
        }
    }
}
