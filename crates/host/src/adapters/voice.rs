//! A pode model as the scheduler's voice: sample in, force out.

use std::any::Any;
use std::sync::Arc;

use haptics::ForceGate;
use models::Playable;
use pode::{Advance, EnergyAudit, Event, Limits, Motion, Piece, Signal, Simulator, Stepper, Watch};
use scheduler::look::{Look, MAX_STATES, Switch, Switches};
use scheduler::motion::{KeyEvent, KeySample, KeySlope, Moment};
use scheduler::voice::{Events, Turn, Voice, VoiceFault, Work};

use super::audit::AuditCell;
use super::damper::Damper;
use super::input::{Followed, InputPath};

/// A voice that can be copied, for rehearsals.
pub trait RehearsableVoice: Voice + Send {
    /// A copy with the same bits.
    fn copy(&self) -> Box<dyn RehearsableVoice>;
}

/// A key's model in motion, between its sensor and its motor.
#[derive(Clone, Debug)]
pub struct RenderedKey<M: Playable, T: Stepper> {
    simulator: Simulator<M, T>,
    input: InputPath,
    gate: ForceGate,
    damper: Damper,
    rest: Rest,
    audit: EnergyAudit,
    cell: Arc<AuditCell>,
    /// Tick [s].
    h: f64,
    slopes: Slopes,
    revision: u32,
}

/// Hammer speed below which a string is touched but does not sound [m/s].
///
/// Grands were measured to give no tone below 0.18 m/s (piano-facts); a little less, so
/// that the limit lies below the softest MIDI velocity of the Disklavier's curve.
const SOFTEST_TONE: f64 = 0.15;

/// Farther than a key moves in a tick [m]: twice its dip.
const LONGEST_WAY: f64 = 0.02;

/// What a voice is built from, besides its model.
#[derive(Clone, Debug)]
pub struct Fittings {
    /// From samples to the model's input.
    pub input: InputPath,
    /// Force and slew limits.
    pub gate: ForceGate,
    /// Work limits and step.
    pub limits: Limits,
    /// Where the energy audit is published.
    pub cell: Arc<AuditCell>,
    /// Tick [s].
    pub h: f64,
    /// Whether the boards render slopes.
    pub slopes: Slopes,
    /// Its number among all voices of a run.
    pub revision: u32,
}

/// Whether a voice works out how its force goes on between two ticks.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Slopes {
    /// Nobody would use it.
    #[default]
    Unused,
    /// The boards render it.
    Rendered,
}

impl<M: Playable, T: Stepper> RenderedKey<M, T> {
    /// A voice at rest with its key up.
    pub fn new(model: M, stepper: T, fittings: Fittings) -> Self {
        let Fittings { input, gate, limits, cell, h, slopes, revision } = fittings;
        let (mode, state) = model.at_rest(&Motion::default());
        Self {
            simulator: Simulator::new(model, stepper, limits, mode, state),
            input,
            gate,
            damper: Damper::new(0.0),
            rest: Rest::default(),
            audit: EnergyAudit::default(),
            cell,
            h,
            slopes,
            revision,
        }
    }

    /// What the model is like under `input`.
    fn look(&self, input: &Motion) -> Look {
        const { assert!(M::STATES.len() <= MAX_STATES, "raise MAX_STATES of scheduler::look") }
        let mut look = Look {
            revision: self.revision,
            mode: number::<M>(self.simulator.mode()),
            input: [input.position, input.rate, input.acceleration, input.jerk],
            ..Look::default()
        };
        look.show(pode::State::entries(self.simulator.state()));
        look
    }

    /// How the mean force of a tick without events goes on around the middle of that tick, at
    /// whose start the newest sample was `late` [s].
    ///
    /// # Real-time
    /// At most four readouts.
    fn slope(&self, middle: &Motion, late: f64) -> KeySlope {
        let model = self.simulator.model();
        let slopes = model.slopes(self.simulator.mode(), self.simulator.state(), middle);
        let scale = model.input_per_metre();
        KeySlope {
            stiffness: -slopes.per_position * scale * scale,
            damping: -slopes.per_rate * scale * scale,
            position: middle.position / scale,
            velocity: middle.rate / scale,
            ahead: late + 0.5 * self.h,
        }
    }

    /// Whether the model accounts for the energy that it gained or lost in this tick, but for
    /// less than the strongest force does over [`LONGEST_WAY`].
    ///
    /// Energies are the same at the finger and in the model, whatever its input is measured in.
    fn is_explained(&self, audit: &EnergyAudit) -> bool {
        let most = self.gate.limit() * LONGEST_WAY;
        (audit.residual() - self.audit.residual()).abs() <= most
    }

    fn advance(&mut self, tick: u64, sample: &KeySample, turn: &mut Turn) {
        turn.begin();
        let Followed { signal, position, late } = self.input.follow(tick, sample);
        if let Some((at, event)) = self.damper.follow(tick, position, self.h) {
            turn.events.push(at, event);
        }
        let before = *self.simulator.state();
        // What a tick says counts only if it ends well: a model that diverges must neither
        // play notes nor spoil the sums.
        let (mut audit, mut events) = (self.audit, turn.events);
        let mut strikes = Strikes { tick, events: &mut events, switches: &mut turn.switches };
        let mut watch = (&mut audit, &mut strikes);
        let done = self.simulator.advance(self.h, &signal, &mut watch);
        turn.look = self.look(&signal.at(1.0));
        let per_metre = self.simulator.model().input_per_metre();
        let gated = self.gate.apply(done.mean_readout * per_metre, self.h);
        turn.force = gated.force;
        let is_free = gated.finite && !gated.limited && !gated.slewed && done.work.events == 0;
        if self.slopes == Slopes::Rendered && is_free {
            turn.slope = self.slope(&signal.at(0.5), late);
        }
        turn.work = Work {
            derivatives: done.work.derivatives,
            guards: done.work.guards,
            events: done.work.events,
        };
        turn.fault = fault(done.advance, done.work.events);
        if turn.fault.is_none() && self.is_explained(&audit) {
            (self.audit, turn.events) = (audit, events);
            self.cell.publish(&self.audit);
        } else if turn.fault.is_none() {
            turn.fault = Some(VoiceFault::Diverged);
        }
        let moved = largest_change::<M>(&before, self.simulator.state());
        self.rest.observe(sample.position, turn.force, moved);
    }
}

impl<M: Playable, T: Stepper + 'static> Voice for RenderedKey<M, T> {
    fn tick(&mut self, tick: u64, sample: &KeySample) -> Turn {
        let mut turn = Turn::default();
        self.tick_into(tick, sample, &mut turn);
        turn
    }

    fn tick_into(&mut self, tick: u64, sample: &KeySample, turn: &mut Turn) {
        if let Some(force) = self.rest.force_at(sample.position) {
            self.input.go_on(tick, sample);
            turn.rest_at(force);
        } else if sample.position.is_finite() && sample.taken.is_finite() {
            self.advance(tick, sample, turn);
        } else {
            *turn = Turn::faulty(VoiceFault::BadSample);
        }
    }

    fn reset(&mut self, sample: &KeySample) {
        let input = self.input.reset(sample.position);
        let (mode, state) = self.simulator.model().at_rest(&input);
        self.simulator.place(mode, state);
        self.damper = Damper::new(sample.position);
        self.rest = Rest::default();
    }

    fn retune(&mut self, donor: &mut dyn Any) -> bool {
        let Some(donor) = donor.downcast_mut::<Self>() else { return false };
        let (mine, its) = (*self.simulator.model(), *donor.simulator.model());
        self.simulator.set_model(its);
        donor.simulator.set_model(mine);
        std::mem::swap(&mut self.revision, &mut donor.revision);
        // What was at rest may not be any more.
        self.rest = Rest::default();
        true
    }

    fn as_donor(&mut self) -> Option<&mut dyn Any> {
        Some(self)
    }
}

impl<M, T> RehearsableVoice for RenderedKey<M, T>
where
    M: Playable,
    T: Stepper + Send + 'static,
{
    fn copy(&self) -> Box<dyn RehearsableVoice> {
        Box::new(Self { cell: Arc::default(), ..self.clone() })
    }
}

/// Whether a voice has come to rest, so that its equations can be skipped.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Rest {
    position: f64,
    force: f64,
    /// Ticks for which neither key nor model has moved.
    still: u32,
}

impl Rest {
    /// Ticks without any movement after which a voice sleeps.
    const PATIENCE: u32 = 20;
    /// State change in a tick that counts as none: of a hammer it means 0.1 mN at the
    /// finger, a tenth of what the wire resolves.
    const STILL: f64 = 2e-5;

    fn observe(&mut self, position: f64, force: f64, moved: f64) {
        // Bits, not a tolerance: the encoder says whether the key has moved.
        let same = self.position.to_bits() == position.to_bits() && moved < Self::STILL;
        self.still = if same { self.still.saturating_add(1) } else { 0 };
        (self.position, self.force) = (position, force);
    }

    /// The force to hold if the voice sleeps and the key is still at `position` [m].
    fn force_at(&self, position: f64) -> Option<f64> {
        let asleep = self.still >= Self::PATIENCE;
        (asleep && self.position.to_bits() == position.to_bits()).then_some(self.force)
    }
}

/// The number of `mode` among the model's; 255 if it is not among them.
fn number<M: Playable>(mode: M::Mode) -> u8 {
    let index = M::MODES.iter().position(|(other, _name)| *other == mode);
    index.and_then(|index| u8::try_from(index).ok()).unwrap_or(u8::MAX)
}

/// Turns the guard that sounds into a strike, and notes changes of mode.
struct Strikes<'a> {
    tick: u64,
    events: &'a mut Events,
    switches: &'a mut Switches,
}

impl<M: Playable> Watch<M> for Strikes<'_> {
    fn piece<S: Signal<Motion>>(&mut self, _model: &M, _piece: &Piece<'_, M, S>) {}

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        let guard = if let pode::Cause::Guard(spec) = event.cause { spec.id.0 } else { u8::MAX };
        self.switches.push(Switch {
            theta: event.theta,
            from: number::<M>(event.before.0),
            to: number::<M>(event.after.0),
            guard,
        });
        let pode::Cause::Guard(spec) = event.cause else { return };
        let sounding = model.sounding(spec.id, &event.before.1);
        if let Some(sounding) = sounding.filter(|it| it.speed >= SOFTEST_TONE) {
            let at = Moment { tick: self.tick, theta: event.theta };
            self.events.push(at, KeyEvent::Strike { speed: sounding.speed });
        }
    }
}

const fn fault(advance: Advance, handled: u32) -> Option<VoiceFault> {
    match advance {
        Advance::Completed => None,
        Advance::Capped(_) => Some(VoiceFault::Capped { handled }),
        Advance::Faulty(_) => Some(VoiceFault::NotFinite),
    }
}

fn largest_change<M: Playable>(before: &M::State, after: &M::State) -> f64 {
    use pode::State as _;
    let pairs = before.entries().iter().zip(after.entries());
    pairs.fold(0.0, |most, (a, b)| (a - b).abs().max(most))
}
