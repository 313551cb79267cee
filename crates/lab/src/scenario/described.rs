//! Shipped models under a stroke of their key; the reference is DOP853 at a tight tolerance.

use std::path::Path;
use std::sync::OnceLock;

use instruments::{Described, Playable, Visitor};
use mechanism::Library;
use pode::stepper::{Controlled, Dop853, Tolerance};
use pode::{Motion, RecordedEvent, RunRecorder, Sample, Simulator};

use super::input::{Presses, TermInput as _};
use super::{BadFile, ExpectedEvent, ForceKind, MS, ModeOf, Plan, Reference, Scenario};
use super::{ReferenceSample, ScenarioVisitor, StateOf, offline_limits};

/// A press of a key to its dip: s(t) = dip (1 + tanh((t − tc)/w))/2.
#[derive(Clone, Copy, Debug)]
pub(super) struct KeyStroke {
    pub(super) model: &'static str,
    /// Exponent of the force of the model's least smooth contact, if it is not whole.
    pub(super) exponent: Option<f64>,
    /// tc and w (s).
    press: [f64; 2],
    /// End (s).
    until: f64,
}

#[derive(Debug)]
pub(super) struct DescribedScenario<M: Described> {
    model: M,
    stroke: KeyStroke,
    input: Presses<1>,
    reference: OnceLock<Reference<M>>,
}

/// Time between samples, and tick of methods that choose their steps (s).
const ROW: f64 = 10.0 * MS;
/// Key travel of a model without the parameter `dip` (m).
const USUAL_DIP: f64 = 10.0 * MS;

impl KeyStroke {
    /// Presses at up to 0.17 m/s for a dip of 10 mm.
    pub(super) const fn soft(model: &'static str, exponent: Option<f64>) -> Self {
        Self { model, exponent, press: [0.15, 0.03], until: 0.35 }
    }

    /// Presses at up to 0.5 m/s for a dip of 10 mm.
    pub(super) const fn forte(model: &'static str, exponent: Option<f64>) -> Self {
        Self { model, exponent, press: [0.06, 0.01], until: 0.2 }
    }

    pub(super) fn visit<V: ScenarioVisitor>(self, visitor: V) -> Result<V::Output, BadFile> {
        let model = Library::default().find(self.model, Path::new(""));
        let model = model.map_err(|_why| BadFile::missing(self.model, "the model"))?;
        Ok(model.visit(OfModel { stroke: self, visitor }))
    }
}

struct OfModel<V> {
    stroke: KeyStroke,
    visitor: V,
}

impl<V: ScenarioVisitor> Visitor for OfModel<V> {
    type Output = V::Output;

    fn visit<M: Playable>(self, model: M) -> V::Output {
        let Self { stroke, visitor } = self;
        let entry = model.entry();
        let dip = entry.parameters.iter().position(|it| it.name == "dip");
        let dip = dip.map_or(USUAL_DIP, |index| entry.default_value(index));
        let input = Presses::one(dip * model.input_per_metre(), stroke.press);
        visitor.visit(DescribedScenario { model, stroke, input, reference: OnceLock::new() })
    }
}

impl<M: Described> DescribedScenario<M> {
    fn answered(&self) -> Reference<M> {
        let (model, mode, state) = self.start();
        let mut run = RunRecorder::new(ROW).sampled(ROW);
        let dop853 = Controlled { method: Dop853, tolerance: Tolerance::both(1e-13) };
        let mut simulator = Simulator::new(model, dop853, offline_limits(), mode, state);
        let _outcome = simulator.run(self.stroke.until, ROW, |t| self.input(t), &mut run);
        let event =
            |it: &RecordedEvent<M>| ExpectedEvent { t: it.t, guard: it.name.to_owned(), to: it.to };
        let sample =
            |it: &Sample<M>| ReferenceSample { t: it.t, state: it.state, force: it.readout };
        Reference {
            events: run.events().iter().map(event).collect(),
            is_whole: true,
            rest: None,
            names: self.model.modes().collect(),
            samples: run.samples().iter().skip(1).map(sample).collect(),
        }
    }
}

impl<M: Described> Scenario for DescribedScenario<M> {
    type Model = M;

    fn plan(&self) -> Plan {
        const TICKS: &[f64] =
            &[5.0 * MS, 2.0 * MS, MS, 0.5 * MS, 0.2 * MS, 0.1 * MS, 0.05 * MS, 0.02 * MS];
        let KeyStroke { until, exponent, .. } = self.stroke;
        let order_bound = exponent.map(|exponent| exponent + 1.0);
        Plan {
            until,
            ticks: TICKS,
            offline_tick: ROW,
            felt: ForceKind::Readout,
            order_bound,
            is_computed: true,
        }
    }

    fn start(&self) -> (M, ModeOf<Self>, StateOf<Self>) {
        let (mode, state) = self.model.at_rest(&Motion::default());
        (self.model.clone(), mode, state)
    }

    fn input(&self, t: f64) -> Motion {
        self.input.at(t)
    }

    fn reference(&self) -> &Reference<M> {
        self.reference.get_or_init(|| self.answered())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct FirstEvent;

    impl ScenarioVisitor for FirstEvent {
        type Output = (f64, f64);

        /// Returns the time (s) of the first event, and the angle at the end.
        fn visit<S: Scenario + 'static>(self, scenario: S) -> (f64, f64) {
            let Reference { events, samples, .. } = scenario.reference();
            (events[0].t, pode::State::entries(&samples[samples.len() - 1].state)[0])
        }
    }

    #[test]
    fn the_strokes_of_a_key_are_those_of_another_program() {
        // references/synth_stroke.py
        let soft = (KeyStroke::soft("synth", None), (0.167_055_900_396_495, 0.055_086_346_709_559));
        let loud =
            (KeyStroke::forte("synth", None), (0.065_533_099_685_592, 0.055_086_435_537_571));
        for (stroke, (t, angle)) in [soft, loud] {
            let found = stroke.visit(FirstEvent).expect("the model");
            let apart = ((found.0 - t).abs(), (found.1 - angle).abs());
            assert!(apart.0 < 1e-12 && apart.1 < 1e-11, "{found:?} and {apart:?}");
        }
    }
}
