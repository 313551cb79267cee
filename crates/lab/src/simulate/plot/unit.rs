//! What the curves are measured in.
//!
//! A model names its states, outputs and guards without their units; its README has
//! them. A test asks for every model of the catalogue.

/// The unit of `name` in `model`, if it is known.
pub(super) fn of(model: &str, name: &str) -> Option<&'static str> {
    Some(match (model, name) {
        (_, "F" | "F_KH" | "N" | "off") | ("key-hammer-rigid", "release") => "N",
        ("reduced-grand", name) => of_reduced_grand(name)?,
        (_, "T_KU") => "N·m",
        (_, "theta" | "theta_h" | "theta_k" | "string")
        | ("key-hammer-rigid" | "key-hammer-springs", "s") => "rad",
        (_, "theta_dot" | "theta_h_dot" | "theta_k_dot") => "rad/s",
        (
            _,
            "x" | "y" | "s" | "gap" | "depth" | "q3" | "q4" | "floor" | "land" | "left" | "right"
            | "touch" | "leave",
        )
        | ("key-hammer-springs", "release") => "m",
        (_, "v" | "x_dot") => "m/s",
        (_, "lift") => "m/s²",
        _ => return None,
    })
}

/// The unit of `name` in the reduced grand: all its guards but one are on a place.
fn of_reduced_grand(name: &str) -> Option<&'static str> {
    Some(match name {
        "F_KU" | "F_jack" | "F_lever" | "F_string" | "lift-off" => "N",
        "y" | "z" | "s" | "button" | "button-off" | "trip" | "land" | "string-on"
        | "string-off" | "rep-on" | "rep-off" | "check" | "check-far" | "check-near"
        | "check-off" | "reset" | "jack-in" | "jack-out" => "m",
        "u" | "w" => "m/s",
        _ => return None,
    })
}

/// What is measured in `unit`.
pub(super) fn quantity(unit: &str) -> &'static str {
    match unit {
        "N" => "force",
        "N·m" => "torque",
        "m" => "length",
        "rad" => "angle",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use models::Playable;
    use models::catalogue::{ENTRIES, Visitor, visit};

    use super::*;

    /// The names of whose units nothing is known.
    struct Unknown;

    impl Visitor for Unknown {
        type Output = Vec<&'static str>;

        fn visit<M: Playable>(self) -> Self::Output {
            let model = M::with_values(&[]);
            let guards = M::MODES.iter().flat_map(|(mode, _)| model.guards(*mode));
            let names = guards.map(|spec| spec.name).chain(["s"]);
            let names = names.chain(M::STATES.iter().chain(M::OUTPUTS).copied());
            names.filter(|name| of(M::NAME, name).is_none()).collect()
        }
    }

    #[test]
    fn every_curve_of_every_model_has_a_unit() {
        for entry in ENTRIES {
            assert_eq!(visit(entry.name, Unknown), Some(Vec::new()), "{}", entry.name);
        }
    }
}
