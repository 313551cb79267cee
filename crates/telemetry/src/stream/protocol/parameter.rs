//! Parameters: names and numbers.

use serde::{Deserialize, Serialize};

use crate::request::Change;

/// A parameter, with its value.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct ParameterValue {
    /// Its name, as `/key/39/k2`.
    pub name: String,
    #[serde(default)]
    pub value: serde_json::Value,
    /// Type of the value: without it, 1 would read as an integer.
    #[serde(default, rename = "type", skip_serializing_if = "Option::is_none")]
    pub kind: Option<String>,
}

impl ParameterValue {
    pub fn new(name: impl Into<String>, value: f64) -> Self {
        Self { name: name.into(), value: value.into(), kind: Some("float64".to_owned()) }
    }

    pub fn change(&self) -> Result<Change, ParameterError> {
        let value = self.value.as_f64().filter(|value| value.is_finite());
        let value = value.ok_or_else(|| ParameterError::NoNumber(shortened(&self.name)))?;
        let change = Change::named(&self.name, value);
        change.ok_or_else(|| ParameterError::NoName(shortened(&self.name)))
    }
}

/// Reason why a parameter cannot be set.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum ParameterError {
    #[error("the value for {0} is no finite number: send a number in the parameter's unit")]
    NoNumber(String),
    #[error("there is no parameter {0}: names are as /key/39/k2, keys 0 (A0) to 87 (C8)")]
    NoName(String),
}

fn shortened(name: &str) -> String {
    const MOST: usize = 80;
    let short: String = name.chars().take(MOST).collect();
    if short.len() < name.len() { format!("{short:?}…") } else { format!("{short:?}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(text: &str) -> String {
        let parameter: ParameterValue = serde_json::from_str(text).expect("a parameter");
        parameter.change().expect_err("refused").to_string()
    }

    #[test]
    fn no_number_is_refused() {
        let no_number = "the value for \"/key/39/k2\" is no finite number: \
                         send a number in the parameter's unit";
        assert_eq!(refused(r#"{"name":"/key/39/k2"}"#), no_number);
        for value in ["null", "\"1\"", "true", "[1.0]", "{}"] {
            assert_eq!(refused(&format!(r#"{{"name":"/key/39/k2","value":{value}}}"#)), no_number);
        }
        assert_eq!(ParameterValue::new("/key/39/k2", f64::NAN).value, serde_json::Value::Null);
    }

    #[test]
    fn no_name_is_refused() {
        let unknown = refused(r#"{"name":"volume","value":1}"#);
        assert!(unknown.starts_with("there is no parameter \"volume\": "), "{unknown}");
        let long = refused(&format!(r#"{{"name":"{}","value":1}}"#, "ä".repeat(5000)));
        assert!(long.chars().count() < 200, "{long}");
    }
}
