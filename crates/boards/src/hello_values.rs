//! Valid ranges of the numbers in a hello.

use std::{fmt, ops::RangeInclusive};

use firmware_protocol::frame::hello::Hello;

/// A number in a hello that no board can have.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ImpossibleValue {
    field: &'static str,
    value: u32,
    possible: RangeInclusive<u32>,
}

impl fmt::Display for ImpossibleValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { field, value, possible } = self;
        write!(f, "{field} = {value}, and {} to {} is possible", possible.start(), possible.end())
    }
}

pub fn impossible_values(hello: &Hello) -> Vec<ImpossibleValue> {
    let any = 1..=u32::from(u16::MAX);
    let values = [
        ("max_sample_hz", hello.max_sample_hz.into(), any.clone()),
        ("max_force_hz", hello.max_force_hz.into(), any.clone()),
        ("law_hz", hello.law_hz.into(), any.clone()),
        ("quantum_nm", hello.quantum_nm, 1..=1_000_000),
        ("max_force_mn", hello.max_force_mn.into(), any),
    ];
    let impossible = values.into_iter().filter(|(_, value, possible)| !possible.contains(value));
    impossible.map(|(field, value, possible)| ImpossibleValue { field, value, possible }).collect()
}

#[cfg(test)]
mod tests {
    use firmware_protocol::Record as _;

    use super::*;

    #[test]
    fn each_impossible_number_is_named_with_what_is_possible() {
        let zeros = Hello::take(&[0; Hello::LEN]).unwrap();
        let said: Vec<_> = impossible_values(&zeros).iter().map(ToString::to_string).collect();
        assert_eq!(said.len(), 5, "{said:?}");
        assert_eq!(said[3], "quantum_nm = 0, and 1 to 1000000 is possible");
        let (max_sample_hz, max_force_hz, law_hz) = (1, 1, 1);
        let least = Hello { max_sample_hz, max_force_hz, law_hz, max_force_mn: 1, ..zeros };
        assert_eq!(impossible_values(&Hello { quantum_nm: 1, ..least }), []);
        assert_eq!(impossible_values(&Hello { quantum_nm: u32::MAX, ..least }).len(), 1);
    }
}
