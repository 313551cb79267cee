//! The stream's two ends in the host: what it tells, and what it is asked.

use std::collections::BTreeMap;
use std::net::SocketAddr;
use std::sync::Arc;

use telemetry::request::Change;
use telemetry::stream::{Backend, ParameterSetting, Publisher, Who};
use telemetry::{Reply, Request, Topic, Update};

use super::{Folders, VoiceSwitcher};
use crate::observe::MessageSink;

/// Gives what the pump makes to those who follow.
#[derive(Debug)]
pub struct StreamSink {
    publisher: Publisher,
    /// The values of each key's voice, as those who follow parameters know them.
    told: BTreeMap<u32, Vec<ParameterSetting>>,
    /// How often somebody had begun to follow something.
    followings: u64,
}

impl StreamSink {
    /// For those who follow what `publisher` sends.
    pub const fn new(publisher: Publisher) -> Self {
        Self { publisher, told: BTreeMap::new(), followings: 0 }
    }

    /// Tells which values are others now; whoever changed them, it comes by here once.
    fn tell_changed(&mut self, voice: &telemetry::Voice) {
        let values = values_of(voice);
        let before = self.told.get(&voice.key);
        let is_new =
            |value: &&ParameterSetting| before.is_none_or(|before| !before.contains(value));
        let changed: Vec<_> = values.iter().filter(is_new).cloned().collect();
        if !changed.is_empty() {
            self.publisher.parameters_changed(&changed);
        }
        self.told.insert(voice.key, values);
    }
}

impl MessageSink for StreamSink {
    fn take(&mut self, at: u64, update: &Update) {
        self.publisher.publish(at, update);
        if let Update::Voice(voice) = update {
            self.tell_changed(voice);
        }
    }

    fn wants(&self, topic: Topic) -> bool {
        // Kept for whoever comes later.
        matches!(topic, Topic::Catalogue | Topic::Voices) || self.publisher.is_followed(topic)
    }

    fn has_newcomers(&mut self) -> bool {
        let now = self.publisher.followings();
        std::mem::replace(&mut self.followings, now) != now
    }
}

/// The values of a voice as the stream's parameters.
fn values_of(voice: &telemetry::Voice) -> Vec<ParameterSetting> {
    let Some(model) = models::catalogue::find(&voice.model) else { return Vec::new() };
    let key = u8::try_from(voice.key).unwrap_or(u8::MAX);
    let value = |(parameter, value): (&models::Parameter, &f64)| {
        let change = Change { key, parameter: parameter.name.to_owned(), value: *value };
        ParameterSetting { name: change.name(), value: *value }
    };
    model.parameters.iter().zip(&voice.values).map(value).collect()
}

/// Answers what clients of the stream ask.
#[derive(Debug)]
pub struct RequestHandler {
    switchboard: Arc<VoiceSwitcher>,
    folders: Folders,
}

impl RequestHandler {
    /// Asks `switchboard`; files that clients name are in `folders`.
    pub const fn new(switchboard: Arc<VoiceSwitcher>, folders: Folders) -> Self {
        Self { switchboard, folders }
    }

    /// What `request` asks of the host itself: with files that the client may name.
    fn confined(&self, request: Request) -> Result<Request, String> {
        Ok(match request {
            Request::UseInstrument { instrument, keys } => {
                Request::UseInstrument { instrument: self.folders.instrument(&instrument)?, keys }
            }
            Request::Record { file: Some(file) } => {
                Request::Record { file: Some(self.folders.recording(&file)?) }
            }
            Request::Record { file: None }
            | Request::Set { .. }
            | Request::Stop {}
            | Request::Press { .. }
            | Request::Identify { .. }
            | Request::Scene {}
            | Request::Where {} => request,
        })
    }
}

impl Backend for RequestHandler {
    fn parameters(&self, names: Option<&[String]>) -> Vec<ParameterSetting> {
        let all = self.switchboard.values();
        let value = |it: &Change| ParameterSetting { name: it.name(), value: it.value };
        let Some(names) = names else { return all.iter().map(value).collect() };
        let wanted = names.iter().filter_map(|name| Change::named(name, 0.0));
        let find = |wanted: Change| {
            all.iter().find(|it| it.key == wanted.key && it.parameter == wanted.parameter)
        };
        wanted.filter_map(find).map(value).collect()
    }

    fn ask(&self, request: Request, who: &Who) -> Result<Reply, String> {
        let request = self.confined(request)?;
        if let Request::Press { key, newtons } = request {
            let text = self.switchboard.press(key, newtons, Some(who.number))?;
            return Ok(Reply::Done { text });
        }
        self.switchboard.answer(&request, &who.to_string())
    }

    fn connected(&self, who: &Who) {
        self.switchboard.patchbay().log(format!("{who} has come"));
    }

    fn disconnected(&self, who: &Who) {
        let patchbay = self.switchboard.patchbay();
        patchbay.leave(who.number);
        patchbay.log(format!("{who} has gone"));
    }

    fn refused(&self, address: SocketAddr, why: &str) {
        let text = format!("a client at {} was turned away: {why}", address.ip());
        self.switchboard.patchbay().log(text);
    }
}
