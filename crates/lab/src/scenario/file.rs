//! Reads the references of other programs: a JSON and a CSV file each.

use instruments::Described;
use serde::Deserialize;
use serde_json::{Map, Value};

use super::{ExpectedEvent, ReferenceSample};

/// Least distance of a sample from every event (s).
const AWAY: f64 = 0.005;

#[derive(Clone, Copy, Debug)]
pub(super) struct ReferenceFile {
    pub(super) name: &'static str,
    pub(super) json: &'static str,
    pub(super) csv: &'static str,
}

macro_rules! file {
    ($folder:literal, $name:literal) => {
        $crate::scenario::file::ReferenceFile {
            name: $name,
            json: include_str!(concat!($folder, $name, ".json")),
            csv: include_str!(concat!($folder, $name, ".csv")),
        }
    };
}
pub(super) use file;

/// A reference that cannot be read.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("the reference {name} cannot be read: {what}")]
pub struct BadFile {
    name: &'static str,
    what: String,
}

impl BadFile {
    pub(crate) fn missing(name: &'static str, what: &str) -> Self {
        Self { name, what: format!("{what} is missing") }
    }
}

impl ReferenceFile {
    pub(super) fn wrong(&self, what: impl std::fmt::Display) -> BadFile {
        BadFile { name: self.name, what: what.to_string() }
    }
}

#[derive(Debug, Deserialize)]
pub(super) struct ReferenceCase {
    parameters: Map<String, Value>,
    input: InputTerms,
    t_end: Value,
    events: Vec<ReferenceEvent>,
}

#[derive(Debug, Deserialize)]
struct InputTerms {
    #[serde(rename = "A_tc_w")]
    terms: Vec<[Value; 3]>,
}

#[derive(Debug, Deserialize)]
struct ReferenceEvent {
    t: Value,
    guard: String,
    to: String,
}

fn number(value: &Value) -> Option<f64> {
    value.as_f64().or_else(|| value.as_str()?.parse().ok())
}

impl ReferenceCase {
    pub(super) fn read(file: &ReferenceFile) -> Result<Self, BadFile> {
        serde_json::from_str(file.json).map_err(|error| file.wrong(error))
    }

    pub(super) fn model<M: Described>(&self, model: &M) -> M {
        let given = |name: &str| self.parameters.get(name).and_then(number);
        model.with_values(&model.entry().values(given))
    }

    pub(super) fn input_terms(&self, file: &ReferenceFile) -> Result<Vec<[f64; 3]>, BadFile> {
        let term = |[a, tc, w]: &[Value; 3]| Some([number(a)?, number(tc)?, number(w)?]);
        let terms: Option<_> = self.input.terms.iter().map(term).collect();
        terms.ok_or_else(|| file.wrong("a term of the input is no number"))
    }

    /// Returns the end (s).
    pub(super) fn until(&self, file: &ReferenceFile) -> Result<f64, BadFile> {
        number(&self.t_end).ok_or_else(|| file.wrong("t_end is no number"))
    }

    pub(super) fn events<M: Described>(
        &self,
        model: &M,
        file: &ReferenceFile,
    ) -> Result<Vec<ExpectedEvent<M>>, BadFile> {
        let event = |event: &ReferenceEvent| {
            let t = number(&event.t).ok_or_else(|| file.wrong("an event without a time"))?;
            Ok(ExpectedEvent { t, guard: event.guard.clone(), to: mode(model, file, &event.to)? })
        };
        self.events.iter().map(event).collect()
    }

    pub(super) fn samples<M: Described>(
        &self,
        model: &M,
        file: &ReferenceFile,
        readout: &str,
    ) -> Result<Vec<ReferenceSample<M::State>>, BadFile> {
        let events: Vec<f64> = self.events.iter().filter_map(|event| number(&event.t)).collect();
        let rows = TrajectoryRows::read(model, file, readout)?;
        let is_away = |t: f64| t > 0.0 && events.iter().all(|event| (event - t).abs() > AWAY);
        Ok(rows.0.into_iter().filter(|sample| is_away(sample.t)).collect())
    }
}

fn mode<M: Described>(model: &M, file: &ReferenceFile, name: &str) -> Result<M::Mode, BadFile> {
    let known = model.modes().find(|(_, known)| *known == name);
    known.map(|(mode, _)| mode).ok_or_else(|| file.wrong(format_args!("no mode {name}")))
}

struct TrajectoryRows<M: Described>(Vec<ReferenceSample<M::State>>);

impl<M: Described> TrajectoryRows<M> {
    fn read(model: &M, file: &ReferenceFile, readout: &str) -> Result<Self, BadFile> {
        let mut lines = file.csv.lines();
        let header: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
        let column = |name: &str| {
            let index = header.iter().position(|known| *known == name);
            index.ok_or_else(|| file.wrong(format_args!("no column {name}")))
        };
        let names = &model.entry().states;
        let states = names.iter().map(|name| column(name)).collect::<Result<Vec<_>, _>>()?;
        let (t, force) = (column("t")?, column(readout)?);
        let row = |line: &str| {
            let fields: Vec<&str> = line.split(',').collect();
            let number = |index: usize| fields.get(index)?.parse().ok();
            let mut state = <M::State as pode::State>::ZERO;
            for (entry, index) in state.as_mut().iter_mut().zip(&states) {
                *entry = number(*index)?;
            }
            Some(ReferenceSample { t: number(t)?, state, force: number(force)? })
        };
        let rows: Option<Vec<_>> = lines.map(row).collect();
        rows.map(Self).ok_or_else(|| file.wrong("a row is incomplete"))
    }
}
