//! A valid request for impedances.

use crate::impedance::{
    ForceHold, HeldMode, ImpedanceCurve, RecordedStroke, ShakenVoice, frequencies, linearise,
};
use crate::stability::{LoopQuantity, LoopValues, VoiceOrder};
use documents::{choice, quoted};
use figures::digits::rounded;
use haptics::EstimatorName;
use instruments::ModelEntry;

use super::{ImpedanceArgs, VoiceLoopArgs, recording::read_stroke};
use crate::command::stability::ask::{
    PERIOD, estimators, key_named, set_parameters, set_quantities, voices,
};
use crate::command::stability::quantities::{quantity, range};
use crate::command::stability::voices::InstrumentVoices;
use cli::Failure;

/// Default depth and largest amplitude (m), and the allowed amplitudes.
const DEPTH: f64 = 6e-3;
const AMPLITUDE: f64 = 20e-6;
const AMPLITUDES: (f64, f64) = (1e-9, 1e-3);
/// Allowed and default frequencies (Hz).
const FREQUENCIES: (f64, f64) = (0.1, 100e3);
const USUAL: (f64, f64) = (1.0, 400.0);
/// Default lowest frequency of a recording (Hz): a stroke lasts some tenths of a second.
const RECORDED: f64 = 10.0;

pub(super) struct ImpedanceQuestion {
    pub(super) name: String,
    subject: ImpedanceSubject,
    frequencies: Vec<f64>,
}

enum ImpedanceSubject {
    Stroke(RecordedStroke),
    Instrument(Box<PressedInstrument>),
}

struct PressedInstrument {
    voices: InstrumentVoices,
    parameters: Vec<f64>,
    values: LoopValues,
    modes: Vec<String>,
    estimators: Vec<EstimatorName>,
    depth: f64,
    amplitude: f64,
}

impl ImpedanceQuestion {
    pub(super) fn new(args: &ImpedanceArgs) -> Result<Self, Vec<String>> {
        let mut mistakes = Vec::new();
        let asked = if args.recording.is_some() {
            recorded(args, &mut mistakes)
        } else {
            pressed(args, &mut mistakes)
        };
        let held = asked.as_ref().map(|it| it.1.held());
        let frequencies = asked_frequencies(args, held, &mut mistakes);
        match asked {
            Some((name, subject)) if mistakes.is_empty() => Ok(Self { name, subject, frequencies }),
            _ => Err(mistakes),
        }
    }

    pub(super) fn runs(&self) -> usize {
        let curves = match &self.subject {
            ImpedanceSubject::Stroke(_) => 1,
            ImpedanceSubject::Instrument(it) => it.estimators.len(),
        };
        curves * self.frequencies.len()
    }

    pub(super) fn measure(&self, done: &(dyn Fn() + Sync)) -> Result<Vec<ImpedanceCurve>, Failure> {
        match &self.subject {
            ImpedanceSubject::Stroke(it) => {
                Ok(vec![it.curve(&self.frequencies, done).map_err(Failure::Usage)?])
            }
            ImpedanceSubject::Instrument(it) => {
                it.curves(&self.frequencies, done).map_err(Failure::Running)
            }
        }
    }
}

impl ImpedanceSubject {
    fn held(&self) -> ForceHold {
        match self {
            Self::Stroke(it) => it.held,
            Self::Instrument(it) => ForceHold::of(&it.values),
        }
    }
}

impl PressedInstrument {
    fn curves(
        &self,
        frequencies: &[f64],
        done: &(dyn Fn() + Sync),
    ) -> Result<Vec<ImpedanceCurve>, String> {
        let mut modes: Vec<_> = self.modes.iter().map(|it| Some(it.as_str())).collect();
        if modes.is_empty() {
            modes.push(None);
        }
        let (model, values, depth) = (&*self.voices.model, &self.parameters, self.depth);
        let mut curves = Vec::new();
        for mode in modes {
            let held = HeldMode { model, values, mode, depth };
            curves.push(linearise(&held)?.curve(frequencies));
        }
        let maker = &|order: &VoiceOrder<'_>| self.voices.make(order);
        for estimator in &self.estimators {
            let order = self.order(*estimator);
            let voice = ShakenVoice { maker, order, depth, amplitude: self.amplitude };
            curves.push(voice.curve(frequencies, done)?);
        }
        Ok(curves)
    }

    fn order(&self, estimator: EstimatorName) -> VoiceOrder<'_> {
        VoiceOrder { values: &self.values, estimator, parameters: &self.parameters }
    }
}

type Asked = Option<(String, ImpedanceSubject)>;

fn recorded(args: &ImpedanceArgs, mistakes: &mut Vec<String>) -> Asked {
    let path = args.recording.as_ref()?;
    let delay = args.voice_loop.delay.as_deref().map_or(Ok(0.0), |it| quantity(it, "s"));
    let delay = delay.and_then(|it| {
        let wrong = || format!("{it} is not from 0 to 1 s");
        if (0.0..=1.0).contains(&it) { Ok(it) } else { Err(wrong()) }
    });
    let delay = delay.map_err(|wrong| mistakes.push(format!("--delay {wrong}")));
    let key = key_named(&args.key).map_err(|wrong| mistakes.push(wrong));
    let stroke = read_stroke(path, key.ok()?, delay.ok()?);
    let stroke = stroke.map_err(|wrong| mistakes.push(wrong)).ok()?;
    Some((stroke.name.clone(), ImpedanceSubject::Stroke(stroke)))
}

fn pressed(args: &ImpedanceArgs, mistakes: &mut Vec<String>) -> Asked {
    let found = voices(args.what.as_deref()?, &args.key);
    let found = found.map_err(|wrong| mistakes.extend(wrong)).ok();
    let estimators = estimators(&args.estimator, &[EstimatorName::Kalman], mistakes);
    let amplitude = length("amplitude", args.amplitude.as_deref(), AMPLITUDE, mistakes);
    let (low, high) = AMPLITUDES;
    if !(low..=high).contains(&amplitude) {
        mistakes.push(format!("--amplitude {amplitude} is not from {low} to {high} m"));
    }
    let depth = length("depth", args.depth.as_deref(), DEPTH, mistakes);
    let (name, voices, mut parameters) = found?;
    let rig = voices.rig().map_err(|wrong| mistakes.push(wrong)).ok()?;
    let mut values = LoopValues::of_rig(&rig, PERIOD, haptics::Kalman::KEY_JERK_DENSITY);
    loop_values(&args.voice_loop, &mut values, mistakes);
    let known = &voices.model.parameters;
    set_parameters(known, &args.set, &mut parameters, mistakes);
    check_modes(&voices.model, &args.mode, mistakes);
    let dip = known.iter().position(|it| it.name == "dip");
    let dip = dip.and_then(|it| parameters.get(it).copied());
    let dip = dip.unwrap_or(rig.key.bottom_stop.position);
    if !(0.0..=dip).contains(&depth) {
        let [depth, dip] = [depth, dip].map(|it| rounded(1e3 * it));
        mistakes.push(format!("--depth {depth} mm is not in the key's way; give 0 to {dip} mm"));
    }
    let modes = args.mode.clone();
    let asked =
        PressedInstrument { voices, parameters, values, modes, estimators, depth, amplitude };
    if mistakes.is_empty() {
        // A voice's rejection is a usage error, too.
        let first = asked.estimators.first().copied().unwrap_or(EstimatorName::Kalman);
        mistakes.extend(asked.voices.make(&asked.order(first)).err());
    }
    Some((name, ImpedanceSubject::Instrument(Box::new(asked))))
}

fn loop_values(args: &VoiceLoopArgs, values: &mut LoopValues, mistakes: &mut Vec<String>) {
    let given = [
        (LoopQuantity::Stiffness, &args.stiffness),
        (LoopQuantity::Damping, &args.damping),
        (LoopQuantity::Period, &args.period),
        (LoopQuantity::Delay, &args.delay),
        (LoopQuantity::EncoderStep, &args.encoder_step),
        (LoopQuantity::JerkDensity, &args.jerk_density),
    ];
    let before = mistakes.len();
    set_quantities(&given, values, mistakes);
    if mistakes.len() == before {
        mistakes.extend(values.mistakes());
    }
}

fn check_modes(model: &ModelEntry, named: &[String], mistakes: &mut Vec<String>) {
    for name in named {
        let known = || model.modes.iter().map(|it| it.name);
        if !known().any(|it| it == name) {
            let (model, help) = (model.name, choice(name, known()));
            mistakes.push(format!("{model} has no mode {}: {help}", quoted(name)));
        }
    }
}

fn length(option: &str, text: Option<&str>, usual: f64, mistakes: &mut Vec<String>) -> f64 {
    let read = text.map_or(Ok(usual), |text| quantity(text, "m"));
    read.unwrap_or_else(|wrong| {
        mistakes.push(format!("--{option} {wrong}"));
        usual
    })
}

/// Returns the frequencies asked for, within `held` if it is known.
fn asked_frequencies(
    args: &ImpedanceArgs,
    held: Option<ForceHold>,
    mistakes: &mut Vec<String>,
) -> Vec<f64> {
    let highest = held.map_or(FREQUENCIES.1, |it| it.highest());
    let lowest = if args.recording.is_some() { RECORDED } else { USUAL.0 };
    let usual = Ok((lowest, USUAL.1.min(highest)));
    let ends = args.frequency.as_deref().map_or(usual, |it| range(it, "Hz"));
    let (low, high) = ends.unwrap_or_else(|wrong| {
        mistakes.push(format!("--frequency {wrong}"));
        USUAL
    });
    let (least, most) = FREQUENCIES;
    if low >= high {
        mistakes.push(format!("--frequency goes from {low} to {high} Hz, which is no range"));
    } else if low < least || most < high {
        mistakes.push(format!("--frequency {low}..{high} is not within {least} to {most} Hz"));
    } else if highest * (1.0 + 1e-9) < high {
        let [highest, period] = [highest, 0.45 / highest].map(rounded);
        mistakes.push(format!(
            "--frequency goes to {high} Hz, and a force that is held for {period} s is known up \
             to {highest} Hz; give a lower end or a shorter --period"
        ));
    }
    frequencies((low, high), usize::from(args.points))
}
