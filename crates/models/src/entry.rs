//! What is known of a model without building one.

use core::fmt;

use equations::table::is_pose;

/// A parameter of a model, with its unit and range.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Parameter {
    /// Name in scenes, on the command line and in files.
    pub name: &'static str,
    /// Name for people; the same where it needs no other.
    pub title: &'static str,
    /// SI unit; `"1"` for a ratio.
    pub unit: &'static str,
    /// Smallest and largest allowed value.
    pub range: (f64, f64),
    /// What it is, in one line.
    pub doc: &'static str,
}

/// A named set of parameter values, graded over the compass.
#[derive(Clone, Copy)]
pub struct Preset {
    pub name: &'static str,
    /// What it is, in one line.
    pub doc: &'static str,
    /// Value of the parameter with the given index for a key, 0 (A0) ..= 87 (C8).
    pub value: &'static (dyn Fn(usize, u8) -> f64 + Send + Sync),
}

impl fmt::Debug for Preset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Preset").field("name", &self.name).finish_non_exhaustive()
    }
}

/// What is known of a model without building one.
///
/// Each model has one entry, at one place in memory: two entries are of the same model, in the
/// same version, where they are the same place ([`ModelEntry::is`]).
#[derive(Clone, Copy, Debug)]
pub struct ModelEntry {
    /// Name in scenes and on the command line.
    pub name: &'static str,
    /// What it is, in one line.
    pub summary: &'static str,
    /// The file of its description; none of a model that is part of the program.
    pub file: Option<&'static str>,
    /// The parameters, in the order of [`Described::with_values`](crate::Described::with_values).
    pub parameters: &'static [Parameter],
    /// Its presets; the first is the default.
    pub presets: &'static [Preset],
    /// Name of the input.
    pub input: &'static str,
    /// SI unit of the input.
    pub input_unit: &'static str,
    /// Names of its state's entries.
    pub states: &'static [&'static str],
    /// SI unit of each of them.
    pub state_units: &'static [&'static str],
    /// How many leading entries of the state are coordinates.
    pub coordinates: usize,
    /// Its structural modes, in the order of their numbers.
    pub modes: &'static [ModeEntry],
    /// Names of its outputs.
    pub outputs: &'static [&'static str],
    /// SI unit of each of them.
    pub output_units: &'static [&'static str],
}

impl ModelEntry {
    /// Whether this and `other` are the entry of the same model in the same version.
    pub fn is(&self, other: &Self) -> bool {
        core::ptr::eq(self, other)
    }

    /// The unit of the guard called `name`; empty if there is none or it is not known.
    pub fn guard_unit(&self, name: &str) -> &'static str {
        let mut guards = self.modes.iter().flat_map(|mode| mode.guards);
        guards.find(|guard| guard.name == name).map_or("", |guard| guard.unit)
    }

    /// The outputs that are of use to people; behind them are the poses that a drawing follows.
    pub fn quantities(&self) -> &'static [&'static str] {
        let count = self.outputs.iter().take_while(|name| !is_pose(name)).count();
        self.outputs.split_at(count).0
    }

    /// The default preset's value of a parameter for the lowest key.
    pub fn default_value(&self, parameter: usize) -> f64 {
        self.presets.first().map_or(f64::NAN, |preset| (preset.value)(parameter, 0))
    }
}

/// A structural mode: its mechanics, and how it ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ModeEntry {
    pub name: &'static str,
    /// Generalised coordinates of its mechanics. `[GC93]` table 1.
    pub n: u8,
    /// Constraints among these coordinates.
    pub m: u8,
    /// Degrees of freedom, n − m.
    pub p: u8,
    /// The guards, in the order of the model's own list.
    pub guards: &'static [GuardEntry],
}

/// A guard of a mode, and where it leads.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct GuardEntry {
    pub name: &'static str,
    /// SI unit; empty if it is not known.
    pub unit: &'static str,
    /// The modes that may come next.
    pub to: &'static [&'static str],
}
