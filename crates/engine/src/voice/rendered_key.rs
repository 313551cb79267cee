//! A pode model as the scheduler's voice: sample in, force out.

use std::{fmt, sync::Arc};

use haptics::{DeviceCompensation, ForceGate, KeyMotion, PassivityController, PassivityObserver};
use instruments::{ModelEntry, Playable, hammer_speed};
use pode::input::Cubic;
use pode::{
    Advance, Auditor, Cap, EnergyAudit, Event, Limits, Motion, Piece, Signal, Simulator,
    State as _, Stepper, Tick, Watch, Work, WorkLimit,
};
use scheduler::motion::{KeyEvent, KeySample, KeySlope, Loudness, Moment};
use scheduler::observation::{Switch, Switches, VoiceObservation};
use scheduler::overload::{Simplification, Simplifications};
use scheduler::values::ModelValues;
use scheduler::voice::{
    Events, TurnRules, Voice, VoiceFault, VoiceInternals, VoiceOutput, VoiceWork,
};
use scheduler::work::VoiceKind;

use crate::voice::aftertouch::PressureTracker;
use crate::voice::audit::AuditCell;
use crate::voice::carried::{KeyMemory, carry, same_mode};
use crate::voice::coupling::{CoupledTick, Coupling};
use crate::voice::damper::DamperTracker;
use crate::voice::input::{Followed, InputPath};
use crate::voice::rest::{RestDetector, SleepTime};
use crate::voice::shift::InputShift;

/// A voice that can be copied, for rehearsals.
pub trait RehearsableVoice: Voice + Send {
    /// Returns a copy with the same bits.
    fn copy(&self) -> Box<dyn RehearsableVoice>;

    /// Ends the energy audit, unless forces depend on it. A motion that diverges then goes unseen.
    fn end_audit(&mut self);
}

/// A rehearsable voice by value: its clones are copies.
pub struct CopiedVoice(pub Box<dyn RehearsableVoice>);

impl fmt::Debug for CopiedVoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("CopiedVoice").finish_non_exhaustive()
    }
}

impl Clone for CopiedVoice {
    fn clone(&self) -> Self {
        Self(self.0.copy())
    }
}

impl Voice for CopiedVoice {
    fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        self.0.tick(tick, sample, turn);
    }

    fn observe(&self, seen: &mut VoiceObservation) {
        self.0.observe(seen);
    }

    fn restrict(&mut self, rules: TurnRules) {
        self.0.restrict(rules);
    }

    fn reset(&mut self, sample: &KeySample) {
        self.0.reset(sample);
    }
}

/// A key's model in motion, between its sensor and its motor.
#[derive(Clone, Debug)]
pub struct RenderedKey<M: Playable, T: Stepper> {
    constants: VoiceConstants,
    simulator: Simulator<M, T>,
    memory: KeyMemory,
    gate: ForceGate,
    pressure: PressureTracker,
    rest: RestDetector<M::State>,
    energy: EnergyChecks<M>,
    /// Rest with the key up; `None` after a change of values, since a search takes too long.
    up: Option<(M::Mode, M::State)>,
    has_failed: bool,
    simplified: Simplifications,
    revision: u32,
    signal: Cubic,
    switches: Switches,
}

/// Settings that outlast a change of the model's values.
#[derive(Clone, Copy, Debug)]
struct VoiceConstants {
    gains: Gains,
    device: Option<DeviceCompensation>,
    slopes: SlopeOutput,
    kind: VoiceKind,
    /// Tick period (s).
    h: f64,
}

/// Energy audits of a voice: of its model, and of the loop through the player's finger.
#[derive(Clone, Debug)]
struct EnergyChecks<M: Playable> {
    auditor: Auditor<M>,
    is_audited: bool,
    passivity: PassivityObserver,
    controller: Option<PassivityController>,
    cell: Arc<AuditCell>,
    /// Energy of the model at rest with the key up (J).
    at_rest: f64,
}

/// Returns the kind of voices with the model `name` and the method `T`: a hash, 32-bit FNV-1a.
fn kind_of<T>(name: &str) -> VoiceKind {
    let bytes = name.bytes().chain(std::any::type_name::<T>().bytes());
    VoiceKind(
        bytes.fold(0x811c_9dc5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)),
    )
}

/// Bound on a key's motion in a tick (m): twice its dip.
const LONGEST_WAY: f64 = 0.02;

/// Parts of a voice besides its model.
#[derive(Clone, Debug)]
pub struct VoiceSettings {
    pub input: InputPath,
    pub coupling: Option<Coupling>,
    pub gains: Gains,
    /// Compensation of the device's own mechanics, if any.
    pub device: Option<DeviceCompensation>,
    pub gate: ForceGate,
    pub passivity: PassivityObserver,
    pub controller: Option<PassivityController>,
    pub limits: Limits,
    pub cell: Arc<AuditCell>,
    /// Tick period (s).
    pub h: f64,
    pub slopes: SlopeOutput,
    /// Number among all voices of a run.
    pub revision: u32,
}

/// Gains between a key and its model, beyond the model's own scale.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Gains {
    pub motion: f64,
    pub force: f64,
}

impl Default for Gains {
    fn default() -> Self {
        Self { motion: 1.0, force: 1.0 }
    }
}

/// Use of the slopes of a voice's force between two ticks.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum SlopeOutput {
    #[default]
    Unused,
    Rendered,
}

impl<M: Playable, T: Stepper> RenderedKey<M, T> {
    pub fn new(model: M, stepper: T, settings: VoiceSettings) -> Self {
        let VoiceSettings { input, coupling, gains, device, slopes, h, .. } = settings;
        let (mode, state) = model.at_rest(&Motion::default());
        let damper = DamperTracker::new(model.damper(), 0.0);
        let parts = Arc::clone(model.shared());
        let energy = EnergyChecks {
            auditor: Auditor::default(),
            is_audited: true,
            passivity: settings.passivity,
            controller: settings.controller,
            cell: settings.cell,
            at_rest: model.energy(mode, &state, &Motion::default()),
        };
        Self {
            constants: VoiceConstants { gains, device, slopes, kind: kind_of::<T>(parts.name), h },
            simulator: Simulator::new(model, stepper, settings.limits, mode, state),
            memory: KeyMemory {
                model: parts,
                input,
                damper,
                coupling,
                shift: InputShift::default(),
            },
            gate: settings.gate,
            pressure: PressureTracker::default(),
            rest: RestDetector::new(state, h),
            energy,
            up: Some((mode, state)),
            has_failed: false,
            simplified: Simplifications::NONE,
            revision: settings.revision,
            signal: Cubic::ballistic(0.0, 0.0, 0.0, h),
            switches: Switches::default(),
        }
    }

    /// Returns mode and state at rest under `input`, and the displacement to the model key's start.
    /// Takes hundreds of steps; after a failed turn the model begins with its key up instead.
    fn rest_under(&self, input: &Motion) -> (M::Mode, M::State, f64) {
        match self.up {
            Some((mode, state)) if self.has_failed || *input == Motion::default() => {
                (mode, state, -input.position)
            }
            Some(_) | None => {
                let (mode, state) = self.simulator.model().at_rest(input);
                (mode, state, 0.0)
            }
        }
    }

    fn scale(&self) -> f64 {
        self.simulator.model().input_per_metre() * self.constants.gains.motion
    }

    /// Returns the force at the key's front per readout of the model (N).
    fn per_readout(&self) -> f64 {
        self.simulator.model().input_per_metre() * self.constants.gains.force
    }

    /// Returns the slope of the mean force of a tick without events around the middle of that tick,
    /// at whose start the newest sample was `late` (s).
    ///
    /// # Real-time
    /// At most four readouts.
    fn slope(&self, middle: &Motion, late: f64) -> KeySlope {
        let scale = self.scale();
        let (stiffness, damping) = if let Some(coupling) = &self.memory.coupling {
            let (constants, gain) = (coupling.constants(), self.constants.gains.force);
            (constants.stiffness * gain, constants.damping * gain)
        } else {
            let model = self.simulator.model();
            let slopes = model.slopes(self.simulator.mode(), self.simulator.state(), middle);
            let per_slope = self.per_readout() * scale;
            (slopes.per_position * per_slope, slopes.per_rate * per_slope)
        };
        KeySlope {
            stiffness: -stiffness,
            damping: -damping,
            position: middle.position / scale,
            velocity: middle.rate / scale,
            ahead: late + 0.5 * self.constants.h,
        }
    }

    fn renders_slopes(&self) -> bool {
        self.constants.slopes == SlopeOutput::Rendered
            && !self.simplified.contains(Simplification::Slopes)
    }

    fn sleep_time(&self) -> SleepTime {
        let is_short = self.simplified.contains(Simplification::Rest);
        if is_short { SleepTime::Short } else { SleepTime::Usual }
    }

    /// Returns `true` if the energy error of the integration since `before` is less than the work
    /// of the strongest force over [`LONGEST_WAY`]. Finger and model have equal energies.
    fn is_explained(&self, before: &EnergyAudit) -> bool {
        let most = self.gate.limit() * LONGEST_WAY;
        (self.energy.auditor.sums.integration - before.integration).abs() <= most
    }

    fn coupled(&mut self, key: &Cubic) -> Option<CoupledTick> {
        let scale = self.scale();
        let simulator = &self.simulator;
        let played = (simulator.model(), simulator.mode(), simulator.state());
        Some(self.memory.coupling.as_mut()?.follow(played, key, scale, self.constants.h))
    }

    /// Returns the compensation of the device's resistance (N) in the middle of the tick of `key`.
    fn compensation(&self, key: &Cubic) -> f64 {
        let Some(device) = &self.constants.device else { return 0.0 };
        let (key, scale) = (key.at(0.5), self.scale());
        device.force(&KeyMotion {
            position: key.position / scale,
            velocity: key.rate / scale,
            acceleration: key.acceleration / scale,
        })
    }

    fn press(&mut self, tick: u64, turn: &mut VoiceOutput) {
        let Some(table) = self.simulator.model().midi().pressure else { return };
        if let Some(event) = self.pressure.follow(table, turn.force, self.constants.h) {
            turn.events.push(Moment { tick, theta: 1.0 }, event);
        }
    }

    /// Returns the passive share of `force` (N) for the key at `position` (m).
    fn passive(&mut self, tick: u64, position: f64, force: f64) -> f64 {
        let Some(controller) = &mut self.energy.controller else { return force };
        controller.follow(tick, position);
        let passive = controller.limit(tick, position, force);
        self.gate.go_on_from(passive);
        passive
    }

    /// Reports the model's energy since `before` and the coupling's (J, finger) to the controller.
    fn account(&mut self, before: &EnergyAudit, coupling: f64) {
        let Some(controller) = &mut self.energy.controller else { return };
        let EnergyAudit { dissipated, jumps, stored, .. } = self.energy.auditor.sums;
        let lost = (dissipated - before.dissipated) - (jumps - before.jumps);
        let per_energy = self.constants.gains.force / self.constants.gains.motion;
        controller.take(per_energy * (stored - before.stored + coupling), per_energy * lost);
    }

    fn begin_account(&mut self) {
        self.energy.passivity.reset();
        let stored = self.stored();
        if let Some(controller) = &mut self.energy.controller {
            controller.reset();
            controller.take(stored, 0.0);
        }
    }

    /// Returns the stored energy of the action beyond its rest, at the finger (J).
    fn stored(&self) -> f64 {
        let simulator = &self.simulator;
        let (model, mode, state) = (simulator.model(), simulator.mode(), simulator.state());
        let in_model = model.energy(mode, state, &self.memory.key()) - self.energy.at_rest;
        let in_coupling = self.memory.coupling.map_or(0.0, |it| it.stored());
        (in_model + in_coupling) * self.constants.gains.force / self.constants.gains.motion
    }

    fn advance(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        let is_passive = self.energy.passivity.is_passive(tick, sample.position);
        let Followed { signal, position, late, back } = self.memory.input.follow(tick, sample);
        if let Some(back) = back {
            self.memory.shift = InputShift::after_pause(self.memory.shift.now() + back);
        }
        let signal = self.memory.shift.follow(signal, self.constants.h);
        let damped = self.memory.damper.follow(tick, position, self.constants.h);
        if let Some((at, event)) = damped {
            turn.events.push(at, event);
        }
        let (before, sums) = (*self.simulator.state(), self.energy.auditor.sums);
        let (done, coupled) = self.advance_model(tick, &signal, &mut turn.events);
        let readout = coupled.map_or(done.mean_readout, |it| it.force);
        let is_free = self.render(tick, sample.position, (readout, &signal), turn);
        self.account(&sums, coupled.map_or(0.0, |it| it.stored));
        if self.renders_slopes() && is_free && done.work.events == 0 {
            turn.slope = self.slope(&signal.at(0.5), late);
        }
        turn.work = voice_work(&done.work);
        turn.limit = limit_reached(done.advance);
        turn.fault = fault(done.advance, done.work.events)
            .or_else(|| (!self.is_explained(&sums)).then_some(VoiceFault::Diverged))
            .or((!is_passive).then_some(VoiceFault::MakesEnergy));
        self.has_failed = turn.fault.is_some();
        if turn.fault.is_none() {
            self.energy.cell.publish(&self.energy.auditor.sums);
            self.energy.passivity.hold(tick, sample.position, turn.force);
        } else {
            // A model that diverges must neither play notes nor spoil the sums.
            self.energy.auditor.sums = sums;
            self.energy.auditor.forget();
            turn.events.clear();
            if let Some((at, event)) = damped {
                turn.events.push(at, event);
            }
        }
        self.press(tick, turn);
        let moved = (&before, self.simulator.state());
        self.rest.observe((sample.position, turn.force), self.memory.model.coordinates, moved);
    }

    /// Moves the model and its coupling while the player's key moves as `signal`; adds strikes.
    fn advance_model(
        &mut self,
        tick: u64,
        signal: &Cubic,
        events: &mut Events,
    ) -> (Tick, Option<CoupledTick>) {
        let coupled = self.coupled(signal);
        self.signal = coupled.map_or(*signal, |it| it.signal);
        let mut strikes = Strikes { tick, events, switches: &mut self.switches, impulse: 0.0 };
        let auditor = self.energy.is_audited.then_some(&mut self.energy.auditor);
        let mut watch = (auditor, &mut strikes);
        let done = self.simulator.advance(self.constants.h, &self.signal, &mut watch);
        let impulse = strikes.impulse;
        if let Some(coupling) = &mut self.memory.coupling {
            coupling.strike(impulse);
        }
        (done, coupled)
    }

    /// Converts the mean readout of a tick to the force on the key at `position` (m). Returns
    /// `true` if no limit has changed that force.
    fn render(
        &mut self,
        tick: u64,
        position: f64,
        (readout, signal): (f64, &Cubic),
        turn: &mut VoiceOutput,
    ) -> bool {
        let force = readout * self.per_readout() + self.compensation(signal);
        let gated = self.gate.apply(force, self.constants.h);
        turn.force = self.passive(tick, position, gated.force);
        let is_whole = gated.finite && !gated.limited && !gated.slewed;
        is_whole && turn.force.to_bits() == gated.force.to_bits()
    }
}

impl<M: Playable, T: Stepper + 'static> Voice for RenderedKey<M, T> {
    fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        self.switches.clear();
        if let Some(force) = self.rest.force_at(sample.position, self.sleep_time()) {
            self.memory.input.go_on(tick, sample);
            (turn.force, turn.idle) = (self.passive(tick, sample.position, force), true);
            if let Some(controller) = &mut self.energy.controller {
                controller.take(0.0, 0.0);
            }
        } else if sample.is_finite() {
            self.advance(tick, sample, turn);
        } else {
            turn.fault = Some(VoiceFault::BadSample);
        }
    }

    fn observe(&self, seen: &mut VoiceObservation) {
        let Motion { position, rate, acceleration, jerk } = self.signal.at(1.0);
        let snapshot = &mut seen.snapshot;
        snapshot.revision = self.revision;
        snapshot.mode = self.simulator.model().mode_code(self.simulator.mode()).0;
        snapshot.show(self.simulator.state().entries());
        snapshot.input = [position, rate, acceleration, jerk];
        if !self.switches.is_empty() {
            seen.switches = self.switches;
        }
    }

    fn restrict(&mut self, TurnRules { simplified, limit }: TurnRules) {
        self.simplified = simplified;
        let is_coarse = simplified.contains(Simplification::Steps);
        self.simulator.set_stretch(if is_coarse { 2.0 } else { 1.0 });
        self.simulator.limit_work(WorkLimit { early: limit.early, most: limit.most });
    }

    fn internals(&self) -> VoiceInternals<'_> {
        VoiceInternals { kind: self.constants.kind, memory: Some(&self.memory) }
    }

    fn reset(&mut self, sample: &KeySample) {
        let input = self.memory.input.reset(sample.position);
        let (mode, state, displacement) = self.rest_under(&input);
        self.has_failed = false;
        let is_there = displacement == 0.0;
        self.memory.shift =
            if is_there { InputShift::default() } else { InputShift::new(displacement) };
        if let Some(coupling) = &mut self.memory.coupling {
            coupling.place(&Motion { position: input.position + displacement, ..input });
        }
        self.simulator.place(mode, state);
        self.energy.auditor.forget();
        self.memory.damper = DamperTracker::new(self.simulator.model().damper(), sample.position);
        self.begin_account();
        self.rest = RestDetector::new(*self.simulator.state(), self.constants.h);
    }

    fn retune(&mut self, values: &ModelValues) -> bool {
        if values.model() != self.memory.model.id() {
            return false;
        }
        let model = self.simulator.model().with_values(values.as_slice());
        self.up = self.energy.controller.is_some().then(|| model.at_rest(&Motion::default()));
        if let Some((mode, state)) = &self.up {
            self.energy.at_rest = model.energy(*mode, state, &Motion::default());
        }
        self.simulator.set_model(model);
        self.energy.auditor.forget();
        self.revision = values.revision();
        // The state may no longer be at rest, and the stored energy differs.
        self.rest = RestDetector::new(*self.simulator.state(), self.constants.h);
        self.begin_account();
        true
    }

    fn take_over(&mut self, before: &dyn Voice) -> bool {
        let memory = before.internals().memory.and_then(|it| it.downcast_ref::<KeyMemory>());
        let Some(memory) = memory else { return false };
        let entry: &ModelEntry = &memory.model;
        let mut seen = VoiceObservation::default();
        before.observe(&mut seen);
        let model = self.simulator.model();
        // It has not begun: it is at rest, as it was built.
        let structure = seen.snapshot.structure();
        let Some(mode) = same_mode(model, entry, structure) else { return false };
        let mut state = *self.simulator.state();
        carry(state.as_mut(), model.entry(), (entry, &seen.snapshot));
        self.memory.damper = memory.damper.with_damper(model.damper());
        if model.entry().is(entry) {
            self.memory.succeed(memory);
        } else {
            // The input of another version may have another meaning.
            self.memory.input.succeed(&memory.input);
            let newest = self.memory.input.newest();
            if let Some(coupling) = &mut self.memory.coupling {
                coupling.place(&newest);
            }
        }
        let (mode, state) = self.simulator.model().begin(mode, &state, &self.memory.key());
        self.simulator.place(mode, state);
        self.begin_account();
        true
    }
}

impl<M, T> RehearsableVoice for RenderedKey<M, T>
where
    M: Playable,
    T: Stepper + Send + 'static,
{
    fn copy(&self) -> Box<dyn RehearsableVoice> {
        let mut copy = Box::new(self.clone());
        copy.energy.cell = Arc::default();
        copy
    }

    fn end_audit(&mut self) {
        self.energy.is_audited = self.energy.controller.is_some();
    }
}

struct Strikes<'a> {
    tick: u64,
    events: &'a mut Events,
    switches: &'a mut Switches,
    /// Impulse of the events so far on the model's key (readout s).
    impulse: f64,
}

impl<M: Playable> Watch<M> for Strikes<'_> {
    fn piece<S: Signal<Motion>>(&mut self, _model: &M, _piece: &Piece<'_, M, S>) {}

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        self.impulse += event.impulse;
        let guard =
            if let pode::EventCause::Guard(spec) = event.cause { spec.id.0 } else { u8::MAX };
        self.switches.push(Switch {
            theta: event.theta,
            from: model.mode_code(event.before.0).structure(),
            to: model.mode_code(event.after.0).structure(),
            guard,
        });
        let pode::EventCause::Guard(spec) = event.cause else { return };
        let sounding = model.sounding(spec.id, &event.before.1);
        if let Some(sounding) = sounding.filter(|it| it.speed >= model.softest_tone()) {
            let at = Moment { tick: self.tick, theta: event.theta };
            self.events.push(at, strike(model, sounding.speed));
        }
    }
}

/// Returns a strike at `speed` (m/s), with the loudness of the instrument.
fn strike<M: Playable>(model: &M, speed: f64) -> KeyEvent {
    let midi = model.midi();
    let loudness = Loudness { hammer_speed: hammer_speed(&midi, speed), velocity: midi.velocity };
    KeyEvent::Strike { speed, loudness }
}

const fn voice_work(work: &Work) -> VoiceWork {
    VoiceWork {
        units: work.evaluations(),
        derivatives: work.derivatives,
        guards: work.guards,
        events: work.events,
        certain: work.certain,
        unknown: work.unknown,
    }
}

const fn limit_reached(advance: Advance) -> u32 {
    match advance {
        Advance::Capped(Cap::Work(limit)) => limit,
        Advance::Capped(_) | Advance::Completed | Advance::Faulty(_) => 0,
    }
}

const fn fault(advance: Advance, handled: u32) -> Option<VoiceFault> {
    match advance {
        Advance::Completed => None,
        Advance::Capped(_) => Some(VoiceFault::Capped { handled }),
        Advance::Faulty(_) => Some(VoiceFault::NotFinite),
    }
}

#[cfg(test)]
mod tests {
    use haptics::{AnyEstimator, EnergyBound, Kalman};
    use instruments::SmallModel;
    use scene::Library;

    use super::*;

    fn weightless(h: f64) -> RenderedKey<SmallModel, pode::stepper::Rk4> {
        let estimator = AnyEstimator::Kalman(Kalman::new(h, 1e-6, 10.0));
        let settings = VoiceSettings {
            input: InputPath::new(estimator, None, -5.0, h),
            coupling: None,
            gains: Gains::default(),
            device: None,
            gate: ForceGate::new(25.0, 2e4).unwrap(),
            passivity: PassivityObserver::new(EnergyBound::of_force_limit(25.0, 10e-3), h),
            controller: None,
            limits: Limits::default(),
            cell: Arc::default(),
            h,
            slopes: SlopeOutput::Unused,
            revision: 0,
        };
        let values = [0.0, 0.5, 0.01, 0.1, -5.0];
        let model = Library::default().find("bouncing-ball", "".as_ref()).expect("the ball");
        let model = model.small().expect("a small model").with_values(&values);
        let mut voice = RenderedKey::new(model, pode::stepper::Rk4, settings);
        voice.reset(&KeySample::fresh(0.0));
        voice
    }

    fn first_idle(voice: &mut impl Voice, ticks: u32) -> Option<u64> {
        let mut turn = VoiceOutput::default();
        (0..u64::from(ticks)).find(|tick| {
            turn.begin();
            voice.tick(*tick, &KeySample::fresh(0.0), &mut turn);
            turn.idle
        })
    }

    #[test]
    fn a_ball_that_hovers_sleeps_after_20_ms_and_one_that_drifts_never_does() {
        for hz in [1000_u32, 10_000] {
            let h = 1.0 / f64::from(hz);
            let idle = |voice: &mut _| first_idle(voice, hz);
            assert_eq!(idle(&mut weightless(h)), Some(u64::from(hz) / 50), "{hz} Hz");
            let mut drifting = weightless(h);
            let mode = drifting.simulator.mode();
            drifting.simulator.place(mode, [0.1, 20e-3, 0.0, 0.0]);
            assert_eq!(idle(&mut drifting), None, "{hz} Hz");
        }
    }
}
