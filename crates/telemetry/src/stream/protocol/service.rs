//! Services: requests other than those of parameters.

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::Request;

/// A service; the [`Request`] of the same name describes it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Service {
    UseInstrument,
    FollowBase,
    SaveInstrument,
    Stop,
    Press,
    Grip,
    Margin,
    Figures,
    Identify,
    Scene,
    Record,
    Load,
    Render,
}

impl Service {
    pub const ALL: [Self; 13] = [
        Self::UseInstrument,
        Self::FollowBase,
        Self::SaveInstrument,
        Self::Stop,
        Self::Press,
        Self::Grip,
        Self::Margin,
        Self::Figures,
        Self::Identify,
        Self::Scene,
        Self::Record,
        Self::Load,
        Self::Render,
    ];

    pub const fn of(request: &Request) -> Option<Self> {
        match request {
            // A client knows its connection, and follows the status.
            Request::Set { .. } | Request::Where {} | Request::Status {} => None,
            Request::UseInstrument { .. } => Some(Self::UseInstrument),
            Request::FollowBase { .. } => Some(Self::FollowBase),
            Request::SaveInstrument { .. } => Some(Self::SaveInstrument),
            Request::Stop {} => Some(Self::Stop),
            Request::Press { .. } => Some(Self::Press),
            Request::Grip { .. } => Some(Self::Grip),
            Request::Margin { .. } => Some(Self::Margin),
            Request::Figures { .. } => Some(Self::Figures),
            Request::Identify { .. } => Some(Self::Identify),
            Request::Scene {} => Some(Self::Scene),
            Request::Record { .. } => Some(Self::Record),
            Request::Load { .. } => Some(Self::Load),
            Request::Render { .. } => Some(Self::Render),
        }
    }

    /// Returns the service's number.
    pub const fn id(self) -> u32 {
        match self {
            Self::UseInstrument => 1,
            Self::Stop => 2,
            Self::Press => 3,
            Self::Identify => 4,
            Self::Scene => 5,
            Self::Record => 6,
            Self::Load => 7,
            Self::Render => 8,
            Self::Grip => 9,
            Self::Margin => 10,
            Self::FollowBase => 11,
            Self::SaveInstrument => 12,
            Self::Figures => 13,
        }
    }

    pub fn numbered(id: u32) -> Option<Self> {
        Self::ALL.into_iter().find(|service| service.id() == id)
    }

    /// Returns the name without `/letoff/`, as [`Request`] writes it.
    pub const fn word(self) -> &'static str {
        match self {
            Self::UseInstrument => "use_instrument",
            Self::FollowBase => "follow_base",
            Self::SaveInstrument => "save_instrument",
            Self::Stop => "stop",
            Self::Press => "press",
            Self::Grip => "grip",
            Self::Margin => "margin",
            Self::Figures => "figures",
            Self::Identify => "identify",
            Self::Scene => "scene",
            Self::Record => "record",
            Self::Load => "load",
            Self::Render => "render",
        }
    }

    pub fn name(self) -> String {
        format!("/letoff/{}", self.word())
    }

    /// Decodes a request of this service: JSON with its fields.
    pub fn request(self, payload: &[u8]) -> Result<Request, String> {
        let refused =
            |cause: serde_json::Error| format!("{} was asked wrongly: {cause}", self.name());
        let mut fields: serde_json::Map<String, Value> = match payload {
            [] => serde_json::Map::new(),
            _ => serde_json::from_slice(payload).map_err(refused)?,
        };
        fields.insert("service".to_owned(), self.word().into());
        serde_json::from_value(Value::Object(fields)).map_err(refused)
    }

    pub fn payload(request: &Request) -> Vec<u8> {
        let mut fields = serde_json::to_value(request).unwrap_or_default();
        if let Some(fields) = fields.as_object_mut() {
            fields.remove("service");
        }
        fields.to_string().into_bytes()
    }

    pub fn advertised(self) -> AdvertisedService {
        let word = self.word();
        AdvertisedService {
            id: self.id(),
            name: self.name(),
            kind: format!("letoff.{word}"),
            request: Some(ServiceSchema::json(format!("letoff.{word}.request"), &self.fields())),
            response: Some(ServiceSchema::json("letoff.reply".to_owned(), &reply())),
        }
    }

    fn fields(self) -> Value {
        let key = json!({"type": "integer", "minimum": 0, "maximum": 87});
        let (properties, required) = match self {
            Self::UseInstrument | Self::FollowBase => (
                json!({
                    "instrument": {"type": "string", "description": "its name or file"},
                    "keys": {"type": ["string", "null"], "description": "as C4..B5; all without"},
                }),
                json!(["instrument"]),
            ),
            Self::SaveInstrument => saved_instrument(),
            Self::Stop | Self::Scene => (json!({}), json!([])),
            Self::Press => {
                (json!({"key": key, "newtons": {"type": "number"}}), json!(["key", "newtons"]))
            }
            Self::Margin | Self::Figures => (json!({"key": key}), json!(["key"])),
            Self::Grip => (
                json!({
                    "key": key,
                    "depth": {
                        "type": ["number", "null"],
                        "description": "as a part of the dip; lets go without",
                    },
                }),
                json!(["key"]),
            ),
            Self::Identify => (
                json!({
                    "line": {"type": "integer", "minimum": 0},
                    "board": {"type": "integer", "minimum": 0},
                }),
                json!(["line", "board"]),
            ),
            Self::Record => (
                json!({
                    "file": {"type": ["string", "null"], "description": "ends without"},
                }),
                json!([]),
            ),
            Self::Load => (
                json!({
                    "description": {"type": "string", "description": "its file"},
                    "keys": {
                        "type": ["string", "null"],
                        "description": "as C4..B5; without, those that play it",
                    },
                }),
                json!(["description"]),
            ),
            Self::Render => {
                (json!({"settings": {"type": "array", "items": setting()}}), json!(["settings"]))
            }
        };
        json!({
            "type": "object",
            "properties": properties,
            "required": required,
            "additionalProperties": false,
        })
    }
}

fn saved_instrument() -> (Value, Value) {
    let keys = json!({
        "type": "array",
        "items": {"type": "array", "description": "as [39, {\"offset\": 1e-4}]"},
    });
    let differences = json!({
        "type": "object",
        "properties": {"parameter": {"type": "string"}, "keys": keys},
        "required": ["parameter", "keys"],
    });
    let properties = json!({
        "name": {"type": "string", "description": "its file without folder and ending"},
        "base": {"type": "string", "description": "the instrument that is changed"},
        "differences": {"type": "array", "items": differences},
        "overwrite": {"type": "boolean"},
    });
    (properties, json!(["name", "base", "differences", "overwrite"]))
}

fn setting() -> Value {
    json!({
        "type": "object",
        "properties": {
            "name": {"type": "string", "description": "as render.passivity"},
            "value": {"type": "string", "description": "as in a scene"},
        },
        "required": ["name", "value"],
    })
}

fn reply() -> Value {
    json!({
        "type": "object",
        "properties": {
            "reply": {"type": "string", "enum": ["done", "stopped", "scene", "figures"]},
            "text": {"type": "string", "description": "what was done"},
            "told": {"type": "integer", "description": "boards that were told to stop"},
            "boards": {"type": "integer", "description": "boards that were armed"},
            "toml": {"type": "string", "description": "the scene as a file"},
            "key": {"type": "integer", "description": "the measured key"},
            "figures": {"type": "array", "items": {"type": "object"}},
            "warnings": {"type": "array", "items": {"type": "string"}},
        },
        "required": ["reply"],
    })
}

/// A service, as it is advertised.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct AdvertisedService {
    pub id: u32,
    pub name: String,
    #[serde(rename = "type")]
    pub kind: String,
    #[serde(default)]
    pub request: Option<ServiceSchema>,
    #[serde(default)]
    pub response: Option<ServiceSchema>,
}

/// Schema of a request or a reply.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct ServiceSchema {
    /// Encoding of the payload: `json`.
    pub encoding: String,
    pub schema_name: String,
    /// Encoding of the schema: `jsonschema`.
    pub schema_encoding: String,
    pub schema: String,
}

impl ServiceSchema {
    fn json(schema_name: String, schema: &Value) -> Self {
        Self {
            encoding: "json".to_owned(),
            schema_name,
            schema_encoding: "jsonschema".to_owned(),
            schema: schema.to_string(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::request::{ParameterDifferences, RenderSetting};
    use keyboard::Difference;

    fn requests() -> Vec<Request> {
        let passivity = RenderSetting { name: "render.passivity".into(), value: "control".into() };
        vec![
            Request::UseInstrument { instrument: "grand".to_owned(), keys: None },
            Request::FollowBase { instrument: "mine".to_owned(), keys: None },
            Request::SaveInstrument {
                name: "mine".to_owned(),
                base: "grand".to_owned(),
                differences: vec![ParameterDifferences {
                    parameter: "mh".to_owned(),
                    keys: vec![(39, Difference::Factor(1.1))],
                }],
                overwrite: false,
            },
            Request::Stop {},
            Request::Press { key: 39, newtons: 2.5 },
            Request::Grip { key: 39, depth: Some(0.5) },
            Request::Margin { key: 39 },
            Request::Figures { key: 39 },
            Request::Identify { line: 1, board: 2 },
            Request::Scene {},
            Request::Record { file: Some("a.mcap".to_owned()) },
            Request::Load { description: "a.toml".to_owned(), keys: None },
            Request::Render { settings: vec![passivity] },
        ]
    }

    #[test]
    fn every_request_but_set_has_a_service_and_comes_back_as_it_went() {
        let mut seen = Vec::new();
        for request in requests() {
            let service = Service::of(&request).expect("a service");
            assert_eq!(Service::numbered(service.id()), Some(service));
            assert_eq!(service.request(&Service::payload(&request)), Ok(request));
            seen.push(service);
        }
        assert_eq!(seen, Service::ALL);
        assert_eq!(Service::of(&Request::Set { changes: vec![] }), None);
        assert_eq!(Service::numbered(0), None);
    }

    #[test]
    fn a_schema_names_the_fields_that_a_request_has() {
        for request in requests() {
            let service = Service::of(&request).expect("a service");
            let sent: Value =
                serde_json::from_slice(&Service::payload(&request)).expect("an object");
            let schema = service.fields();
            let names = schema["properties"].as_object().expect("properties");
            assert!(sent.as_object().expect("fields").keys().eq(names.keys()), "{service:?}");
        }
    }

    #[test]
    fn a_wrong_request_is_refused_in_a_sentence() {
        let wrong =
            [&b"{"[..], b"[]", b"{\"key\":39}", b"{\"key\":39,\"newtons\":\"much\"}", &[255]];
        for payload in wrong {
            let refused = Service::Press.request(payload).expect_err("wrong");
            assert!(refused.starts_with("/letoff/press was asked wrongly: "), "{refused}");
        }
        assert_eq!(Service::Scene.request(br#"{"service":"stop"}"#), Ok(Request::Scene {}));
    }
}
