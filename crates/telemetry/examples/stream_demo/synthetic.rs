//! A host without keys: two parameters of key 39, and generated messages.

use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
use std::{collections::BTreeMap, f64::consts::TAU};

use telemetry::request::Change;
use telemetry::stream::{Backend, ParameterSetting, Publisher, Who};
use telemetry::{
    Catalogue, KEYS, KeyBlock, Model, Overview, Parameter, Reply, Request, Signal, Update, Voice,
};

pub(crate) const KEY: u8 = 39;

pub(crate) const TICK_HZ: u32 = 1000;

/// Parameters: name, unit, smallest, largest, meaning, and first value.
const PARAMETERS: [(&str, &str, f64, f64, &str, f64); 2] = [
    ("k2", "N/m", 0.0, 1e5, "stiffness of the felt", 500.0),
    ("m", "kg", 0.01, 1.0, "mass of the hammer", 0.1),
];

#[derive(Debug)]
pub(crate) struct Synthetic {
    values: Mutex<BTreeMap<String, f64>>,
    asked: Mutex<Vec<(Request, Who)>>,
    publisher: OnceLock<Publisher>,
    gone: Mutex<Vec<u64>>,
    /// Lock that another instrument waits for, as if it took long to build.
    pub(crate) workshop: Mutex<()>,
}

impl Default for Synthetic {
    fn default() -> Self {
        let values = PARAMETERS.map(|(name, .., first)| (format!("/key/{KEY}/{name}"), first));
        Self {
            values: Mutex::new(values.into()),
            asked: Mutex::default(),
            gone: Mutex::default(),
            publisher: OnceLock::new(),
            workshop: Mutex::new(()),
        }
    }
}

impl Backend for Synthetic {
    fn parameters(&self, names: Option<&[String]>) -> Vec<ParameterSetting> {
        let is_asked = |name: &String| names.is_none_or(|names| names.contains(name));
        let values = locked(&self.values);
        let asked = values.iter().filter(|(name, _)| is_asked(name));
        asked.map(|(name, value)| ParameterSetting { name: name.clone(), value: *value }).collect()
    }

    fn ask(&self, request: Request, who: &Who) -> Result<Reply, String> {
        locked(&self.asked).push((request.clone(), *who));
        match request {
            Request::Set { changes } => self.set(&changes),
            Request::UseInstrument { instrument, .. } => {
                drop(locked(&self.workshop));
                Ok(done(format!("every key is played by {instrument}")))
            }
            Request::Press { key, newtons } => Ok(done(format!("key {key} feels {newtons} N"))),
            Request::Scene {} => Ok(Reply::Scene { toml: "tick_hz = 1000\n".to_owned() }),
            Request::Stop {} => Ok(done("no force on any key".to_owned())),
            Request::Grip { key, .. } => Ok(done(format!("key {key} is held"))),
            Request::Identify { .. }
            | Request::Load { .. }
            | Request::Render { .. }
            | Request::FollowBase { .. }
            | Request::SaveInstrument { .. }
            | Request::Margin { .. }
            | Request::Figures { .. }
            | Request::Record { .. }
            | Request::Where {}
            | Request::Status {} => Err("a synthetic host has neither boards nor files".to_owned()),
        }
    }

    fn disconnected(&self, who: &Who) {
        locked(&self.gone).push(who.number);
    }
}

impl Synthetic {
    pub(crate) fn value(&self, name: &str) -> Option<f64> {
        locked(&self.values).get(&format!("/key/{KEY}/{name}")).copied()
    }

    pub(crate) fn asked(&self) -> Vec<(Request, Who)> {
        locked(&self.asked).clone()
    }

    #[cfg_attr(not(test), expect(dead_code, reason = "tests ask"))]
    pub(crate) fn gone(&self) -> Vec<u64> {
        locked(&self.gone).clone()
    }

    pub(crate) fn tell_by(&self, publisher: Publisher) {
        self.publisher.get_or_init(|| publisher);
    }

    fn set(&self, changes: &[Change]) -> Result<Reply, String> {
        let mut values = locked(&self.values);
        for change in changes {
            check(change)?;
        }
        values.extend(changes.iter().map(|change| (change.name(), change.value)));
        if let Some(publisher) = self.publisher.get() {
            let value = |it: &Change| ParameterSetting { name: it.name(), value: it.value };
            publisher.parameters_changed(&changes.iter().map(value).collect::<Vec<_>>());
        }
        Ok(done(format!("{} set", changes.len())))
    }
}

fn check(change: &Change) -> Result<(), String> {
    let known = PARAMETERS.iter().find(|it| it.0 == change.parameter && change.key == KEY);
    let Some((name, unit, min, max, ..)) = known else {
        return Err(format!("key {} has no parameter {}", change.key, change.parameter));
    };
    if (*min..=*max).contains(&change.value) {
        return Ok(());
    }
    Err(format!("{name} is between {min} and {max} {unit}, and not {}", change.value))
}

fn done(text: String) -> Reply {
    Reply::Done { text }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

pub(crate) fn catalogue() -> Update {
    let parameters = PARAMETERS.map(|(name, unit, min, max, doc, _)| Parameter {
        name: name.to_owned(),
        unit: unit.to_owned(),
        min,
        max,
        doc: doc.to_owned(),
        ..Parameter::default()
    });
    let signal = Signal { name: "hammer".to_owned(), unit: "m".to_owned(), ..Signal::default() };
    let model = Model {
        name: "sine".to_owned(),
        summary: "a key that swings".to_owned(),
        modes: vec!["swinging".to_owned()],
        signals: vec![signal],
        parameters: parameters.into(),
        version: 0,
    };
    Update::Catalogue(Catalogue {
        run: "synthetic".to_owned(),
        tick_hz: TICK_HZ,
        models: vec![model],
        ..Catalogue::default()
    })
}

pub(crate) fn voice(key: u32, revision: u32) -> Update {
    let values = PARAMETERS.map(|it| it.5).into();
    Update::Voice(Voice { key, revision, model: "sine".to_owned(), values, ..Voice::default() })
}

pub(crate) fn block(first: u64, ticks: u32) -> Update {
    let sine = |after: u32| {
        let seconds = (first + u64::from(after)) as f64 / f64::from(TICK_HZ);
        (TAU * seconds).sin()
    };
    let rows = 0..ticks;
    Update::Block(KeyBlock {
        key: KEY.into(),
        tick: first,
        after: rows.clone().collect(),
        position: rows.clone().map(|after| 0.005 * (1.0 + sine(after))).collect(),
        sent: rows.clone().map(|after| 2.0 * sine(after)).collect(),
        force: rows.map(|after| 2.0 * sine(after)).collect(),
        ..KeyBlock::default()
    })
}

#[expect(clippy::cast_possible_truncation, reason = "an overview is as fine as f32")]
pub(crate) fn overview(tick: u64, ticks: u32) -> Update {
    let still = vec![0.0; KEYS];
    let mut position = still.clone();
    if let Some(place) = position.get_mut(usize::from(KEY)) {
        *place = (0.005 * (1.0 + (TAU * tick as f64 / f64::from(TICK_HZ)).sin())) as f32;
    }
    Update::Overview(Overview {
        tick,
        ticks,
        position_min: position.clone(),
        position_max: position,
        force_min: still.clone(),
        force_max: still,
        mode: vec![0; KEYS],
        flags: vec![0; KEYS],
        fault: vec![0; KEYS],
        dropped: 0,
    })
}
