use instruments::ModelEntry;

use super::source::CurveSource;

/// Returns the unit of a curve; `None` if the model has no such signal.
pub(super) fn of(model: &ModelEntry, source: CurveSource) -> Option<&'static str> {
    match source {
        CurveSource::Input => Some(model.input_unit),
        CurveSource::State(index) => model.state_units.get(index).copied(),
        CurveSource::Output(index) => model.output_units.get(index).copied(),
        CurveSource::Guard(name) => Some(model.guard_unit(name)),
    }
}

pub(super) fn quantity(unit: &str) -> &'static str {
    match unit {
        "N" => "force",
        "N·m" => "torque",
        "m" => "length",
        "rad" => "angle",
        _ => "",
    }
}
