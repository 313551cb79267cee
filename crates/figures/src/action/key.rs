use instruments::{ModelEntry, Playable, Visitor};
use pode::stepper::Any;
use pode::{
    Advance, EnergyAudit, Event, EventCause, Limits, Motion, Piece, Signal, Simulator, Watch,
};

/// Method and tolerance of every run: errors stay a thousand times below reported digits.
const METHOD: (&str, f64) = ("tsitouras5", 1e-8);

/// State of a key.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ActionSample {
    /// Time (s).
    pub t: f64,
    /// Travel of the key's front (m).
    pub travel: f64,
    /// Height of the hammer above its rest (m), if the model has it.
    pub head: Option<f64>,
    /// Force of the action on the hammer (N), if the model has it.
    pub push: Option<f64>,
    /// Force on the finger (N), up positive.
    pub force: f64,
}

/// Contact of hammer and string.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StringContact {
    /// Time (s).
    pub t: f64,
    /// Speed of the hammer (m/s).
    pub speed: f64,
    pub sounds: bool,
}

/// A key with its action, driven by position.
pub trait DrivenKey {
    /// Advances by `h` (s), with `input` as the front's motion in metres at a fraction of it, 0 to
    /// 1. Returns `false` if the model fails.
    fn advance(&mut self, h: f64, input: &dyn Fn(f64) -> Motion) -> bool;

    fn sample(&self) -> ActionSample;

    fn strikes(&self) -> &[StringContact];

    /// Energy so far (J).
    fn audit(&self) -> EnergyAudit;

    /// Returns the travel at which the damper leaves the string (m).
    fn damper_lift(&self) -> f64;
}

/// Opens a key at rest with these parameter values.
#[derive(Debug)]
pub struct Opener<'a> {
    pub values: &'a [f64],
}

impl Visitor for Opener<'_> {
    type Output = Box<dyn DrivenKey>;

    fn visit<M: Playable>(self, model: M) -> Self::Output {
        let model = model.with_values(self.values);
        let (mode, state) = model.at_rest(&Motion::default());
        let stepper = Any::named(METHOD.0).unwrap_or_default();
        let stepper = stepper.with_tolerance(METHOD.1, 1e-3).unwrap_or(stepper);
        let limits = Limits { longest_step: 1e-3, ..Limits::default() };
        let places = OutputPlaces::of(model.entry());
        let scale = model.input_per_metre();
        let simulator = Simulator::new(model, stepper, limits, mode, state);
        let log = Log { t: 0.0, h: 0.0, strikes: Vec::new(), audit: EnergyAudit::default() };
        Box::new(SimulatedAction { simulator, places, scale, input: Motion::default(), log })
    }
}

#[derive(Clone, Copy, Debug)]
struct OutputPlaces {
    travel: Option<usize>,
    head: Option<usize>,
    push: Option<usize>,
    count: usize,
}

impl OutputPlaces {
    fn of(entry: &ModelEntry) -> Self {
        let place = |name| entry.outputs.iter().position(|it| *it == name);
        Self {
            travel: place("travel"),
            head: place("head"),
            push: place("push"),
            count: entry.outputs.len(),
        }
    }
}

struct SimulatedAction<M: Playable> {
    simulator: Simulator<M, Any>,
    places: OutputPlaces,
    scale: f64,
    input: Motion,
    log: Log,
}

impl<M: Playable> DrivenKey for SimulatedAction<M> {
    fn advance(&mut self, h: f64, input: &dyn Fn(f64) -> Motion) -> bool {
        let scale = self.scale;
        let scaled = |theta| {
            let Motion { position, rate, acceleration, jerk } = input(theta);
            Motion {
                position: scale * position,
                rate: scale * rate,
                acceleration: scale * acceleration,
                jerk: scale * jerk,
            }
        };
        self.log.h = h;
        let tick = self.simulator.advance(h, &scaled, &mut self.log);
        self.log.t += h;
        self.input = scaled(1.0);
        !matches!(tick.advance, Advance::Faulty(_))
    }

    fn sample(&self) -> ActionSample {
        let (model, mode, state) =
            (self.simulator.model(), self.simulator.mode(), self.simulator.state());
        let mut outputs = vec![0.0; self.places.count];
        model.outputs(mode, state, &self.input, &mut outputs);
        let value = |place: Option<usize>| place.and_then(|place| outputs.get(place).copied());
        ActionSample {
            t: self.log.t,
            travel: value(self.places.travel).unwrap_or(self.input.position / self.scale),
            head: value(self.places.head),
            push: value(self.places.push),
            force: model.readout(mode, state, &self.input) * self.scale,
        }
    }

    fn strikes(&self) -> &[StringContact] {
        &self.log.strikes
    }

    fn audit(&self) -> EnergyAudit {
        self.log.audit
    }

    fn damper_lift(&self) -> f64 {
        self.simulator.model().damper().lift
    }
}

struct Log {
    /// Start of the tick (s).
    t: f64,
    /// Length of the tick (s).
    h: f64,
    strikes: Vec<StringContact>,
    audit: EnergyAudit,
}

impl<M: Playable> Watch<M> for Log {
    fn piece<S: Signal<Motion>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        self.audit.piece(model, piece);
    }

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        self.audit.event(model, event);
        let EventCause::Guard(spec) = event.cause else { return };
        if let Some(sounding) = model.sounding(spec.id, &event.before.1) {
            let (t, speed) = (self.t + event.theta * self.h, sounding.speed);
            self.strikes.push(StringContact { t, speed, sounds: speed >= model.softest_tone() });
        }
    }
}
