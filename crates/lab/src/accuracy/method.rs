//! The methods that are compared, with their settings.

use std::sync::LazyLock;

use pode::stepper::{
    Any, ByNeed, Dop853, Exact, LinearImplicitMidpoint, Newmark, Rodas3, Tsitouras5,
};
use pode::{Limits, Stepper as _};

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};

use super::stepped::Stepping;
use crate::scenario::{MS, Plan, offline_limits};

/// A compared method with its name.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NamedMethod {
    pub name: &'static str,
    /// Order of convergence as its authors state it.
    pub order: u32,
    pub kind: MethodKind,
    pub group: MethodGroup,
    stepper: Any,
}

/// Source of a method's steps.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MethodKind {
    Fixed,
    /// The model's longest step within a tick, as an instrument is played.
    Played,
    /// Error estimate and tolerance, in long ticks.
    Controlled,
    /// Error budget per mode, in ticks of 1 ms or less.
    Budgeted,
}

/// Family of a method, by its purpose.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum MethodGroup {
    Explicit,
    LongStep,
    Implicit,
    /// By what a mode's equations need.
    Chosen,
    Played,
}

impl MethodGroup {
    fn of(method: &str) -> Self {
        match method {
            Dop853::NAME => Self::LongStep,
            LinearImplicitMidpoint::NAME | Newmark::NAME | Rodas3::NAME => Self::Implicit,
            ByNeed::NAME | Exact::NAME => Self::Chosen,
            _ => Self::Explicit,
        }
    }
}

/// One point of a method's series of runs.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
pub struct Setting {
    /// Length of a tick (s).
    pub tick: f64,
    /// Tolerance or error budget of methods that choose their steps.
    pub tolerance: Option<f64>,
}

/// Relative and absolute tolerances.
const TOLERANCES: [f64; 7] = [1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13];

/// Errors per radian of a mode's fastest motion.
const BUDGETS: [f64; 7] = [1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Longest tick of methods with a budget, that of a keyboard (s).
const LONGEST_BUDGETED: f64 = 1e-3;

/// Every compared method by group, and the default of instruments with its own steps.
pub static METHODS: LazyLock<Vec<NamedMethod>> = LazyLock::new(|| {
    let all = Any::NAMES.iter().filter_map(|name| Any::named(name)).map(NamedMethod::of);
    let mut methods: Vec<_> = all.collect();
    methods.sort_by_key(|method| method.group);
    methods.push(NamedMethod {
        name: "as-played",
        order: Newmark::ORDER,
        kind: MethodKind::Played,
        group: MethodGroup::Played,
        stepper: Any::Newmark(Newmark::default()),
    });
    methods
});

/// A method beside DOP853, whose difference from it limits what a computed reference shows.
pub(super) static OTHER_METHOD: NamedMethod = NamedMethod {
    name: "tsitouras5-adaptive",
    order: Tsitouras5::ORDER,
    kind: MethodKind::Controlled,
    group: MethodGroup::LongStep,
    stepper: Any::Tsitouras5(Tsitouras5),
};

impl NamedMethod {
    fn of(stepper: Any) -> Self {
        let (name, kind) = match stepper.name() {
            ByNeed::NAME => (ByNeed::NAME, MethodKind::Budgeted),
            Dop853::NAME => ("dop853-adaptive", MethodKind::Controlled),
            name => (name, MethodKind::Fixed),
        };
        let group = MethodGroup::of(stepper.name());
        Self { name, order: stepper.order(), kind, group, stepper }
    }

    /// Returns the setting of a long run, with a tick of 1 ms, or of 50 ms offline.
    pub(super) const fn long_run(&self) -> Setting {
        match self.kind {
            MethodKind::Fixed | MethodKind::Played => Setting { tick: MS, tolerance: None },
            MethodKind::Budgeted => Setting { tick: MS, tolerance: Some(1e-8) },
            MethodKind::Controlled => Setting { tick: 50.0 * MS, tolerance: Some(1e-10) },
        }
    }

    pub(super) fn settings(&self, plan: &Plan) -> Vec<Setting> {
        let Plan { ticks, offline_tick, .. } = *plan;
        match self.kind {
            MethodKind::Fixed | MethodKind::Played => {
                ticks.iter().map(|tick| Setting { tick: *tick, tolerance: None }).collect()
            }
            MethodKind::Budgeted => {
                let tick = ticks.iter().copied().find(|tick| *tick <= LONGEST_BUDGETED);
                let setting = |budget| Some(Setting { tick: tick?, tolerance: Some(budget) });
                BUDGETS.into_iter().filter_map(setting).collect()
            }
            MethodKind::Controlled => {
                let setting =
                    |tolerance| Setting { tick: offline_tick, tolerance: Some(tolerance) };
                TOLERANCES.map(setting).to_vec()
            }
        }
    }

    pub(super) fn stepper(&self, setting: &Setting) -> Any {
        let precise = |tolerance| self.stepper.with_tolerance(tolerance, setting.tick);
        setting.tolerance.and_then(precise).unwrap_or(self.stepper)
    }

    pub(super) const fn stepping(&self) -> Stepping {
        match self.kind {
            MethodKind::Fixed | MethodKind::Controlled => Stepping::Ticks,
            MethodKind::Played | MethodKind::Budgeted => Stepping::Models,
        }
    }

    pub(super) fn limits(&self) -> Limits {
        match self.kind {
            MethodKind::Fixed | MethodKind::Played | MethodKind::Budgeted => Limits::default(),
            MethodKind::Controlled => offline_limits(),
        }
    }
}

impl Serialize for NamedMethod {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name)
    }
}

/// Reads a method by its name.
pub(super) fn by_name<'de, D>(deserializer: D) -> Result<&'static NamedMethod, D::Error>
where
    D: Deserializer<'de>,
{
    let name = String::deserialize(deserializer)?;
    let method = METHODS.iter().find(|method| method.name == name);
    method.ok_or_else(|| D::Error::custom(format_args!("unknown method {name}")))
}
