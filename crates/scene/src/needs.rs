//! `[[stable]]`: rates and estimators with which an instrument is stable in a loop with its key.

use std::fmt;

use haptics::EstimatorName;

use super::quantity::number;
use super::read::{self, TableReader};
use super::render::{
    COUPLING_DAMPING, COUPLING_STIFFNESS, ESTIMATORS, InputReconstruction, JERK_DENSITY,
    PassivityMode, RECONSTRUCTIONS, Render, TICK_HZ,
};
use super::setting::TableSetting as _;
use documents::toml::{FindingList, TomlNode};

/// Settings with which an instrument is quiet when its keys are left alone.
///
/// They are measured: `tests/quiet.rs` plays every instrument and leaves it alone. A loop that
/// generates energy is muted while it runs, see [`haptics::PassivityObserver`].
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Needs {
    offline: Option<String>,
    /// Stable combinations, if not all are.
    stable: Vec<Stable>,
}

#[derive(Clone, PartialEq, Debug)]
struct Stable {
    /// Slowest rate of the tick (Hz).
    min_tick_hz: Option<u32>,
    estimator: Option<EstimatorName>,
    reconstruction: Option<InputReconstruction>,
    /// Lower bound of the Kalman filter's jerk density (m²/s⁵): the slowest filter.
    min_jerk_density: Option<f64>,
    /// Upper bound of the Kalman filter's jerk density (m²/s⁵): the quickest filter.
    max_jerk_density: Option<f64>,
    /// Largest stiffness of the coupling between the two keys, which is then required (N/m).
    max_coupling_stiffness: Option<f64>,
    /// Least damping of that coupling (N s/m).
    min_coupling_damping: Option<f64>,
}

/// Need that a scene does not meet, and the remedy.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unmet {
    /// Need, and the value in the scene.
    pub lacks: String,
    pub help: String,
}

impl fmt::Display for Unmet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}; {}", self.lacks, self.help)
    }
}

impl Needs {
    /// Reads `offline` and the tables `stable` of an instrument; one table must be met.
    pub(super) fn read(report: &mut FindingList, instrument: &mut TableReader<'_>) -> Self {
        let offline = instrument.text(report, "offline").map(|(why, _place)| why);
        let Some(entry) = instrument.take("stable") else {
            return Self { offline, stable: Vec::new() };
        };
        let tables = read::tables(report, "stable", &entry.node);
        let stable = tables.iter().filter_map(|node| Stable::read(report, node)).collect();
        Self { offline, stable }
    }

    /// Returns the unmet need of the instrument `name` in ticks at `tick_hz` with `render`; `None`
    /// if it is stable.
    pub fn unmet(&self, name: &str, tick_hz: u32, render: &Render) -> Option<Unmet> {
        if let Some(why) = &self.offline {
            return Some(Unmet {
                lacks: format!("{name} is for letoff simulate only: {why}"),
                help: "choose another instrument".to_owned(),
            });
        }
        // The tables were measured without a controller; its effect is found by trials.
        if render.passivity == PassivityMode::Control {
            return None;
        }
        let lacking = self.stable.iter().map(|it| it.lacking(tick_hz, render));
        let nearest = lacking.min_by_key(Vec::len).filter(|lacking| !lacking.is_empty())?;
        let list = |part: fn(&Lack) -> String| nearest.iter().map(part).collect::<Vec<_>>();
        let (needed, settings) = (list(|it| it.needed.clone()), list(|it| it.setting.clone()));
        Some(Unmet {
            lacks: format!(
                "{name} needs {}, or its keys make energy when they are left alone",
                needed.join(", and ")
            ),
            help: format!(
                "set {} for the whole scene, or choose another instrument",
                settings.join(" and ")
            ),
        })
    }

    /// Returns the needs in a few words for lists; `None` if there are none.
    pub fn summary(&self) -> Option<String> {
        if let Some(why) = &self.offline {
            return Some(format!("letoff simulate only: {why}"));
        }
        let all: Vec<_> = self.stable.iter().map(Stable::summary).collect();
        (!all.is_empty()).then(|| all.join("; or "))
    }
}

impl Stable {
    fn read(report: &mut FindingList, node: &TomlNode) -> Option<Self> {
        let mut reader = TableReader::new(report, "[stable]", node)?;
        let stable = Self {
            min_tick_hz: reader.whole(report, "min_tick_hz", TICK_HZ),
            estimator: ESTIMATORS.read(report, &mut reader, "estimator"),
            reconstruction: RECONSTRUCTIONS.read(report, &mut reader, "reconstruction"),
            min_jerk_density: reader.number(report, "min_jerk_density", JERK_DENSITY),
            max_jerk_density: reader.number(report, "max_jerk_density", JERK_DENSITY),
            max_coupling_stiffness: reader.number(
                report,
                "max_coupling_stiffness",
                COUPLING_STIFFNESS,
            ),
            min_coupling_damping: reader.number(report, "min_coupling_damping", COUPLING_DAMPING),
        };
        reader.finish(report);
        Some(stable)
    }

    fn lacking(&self, tick_hz: u32, render: &Render) -> Vec<Lack> {
        let kalman = render.estimator == EstimatorName::Kalman;
        let rate = self.min_tick_hz.filter(|least| tick_hz < *least).map(|least| Lack {
            needed: format!("tick_hz of at least {least}, not {tick_hz}"),
            setting: format!("tick_hz={least}"),
        });
        let estimator = self.estimator.filter(|it| *it != render.estimator).map(|it| Lack {
            needed: format!("estimator {}, not {}", it.name(), render.estimator.name()),
            setting: format!("render.estimator={:?}", it.name()),
        });
        let reconstruction =
            self.reconstruction.filter(|it| *it != render.reconstruction).map(|it| Lack {
                needed: format!(
                    "reconstruction {}, not {}",
                    it.name(),
                    render.reconstruction.name()
                ),
                setting: format!("render.reconstruction={:?}", it.name()),
            });
        let density = |limit: f64, word: &str| Lack {
            needed: format!(
                "jerk_density of at {word} {}, not {}",
                number(limit),
                number(render.jerk_density)
            ),
            setting: format!("render.jerk_density={}", number(limit)),
        };
        let slow = self.min_jerk_density.filter(|least| kalman && render.jerk_density < *least);
        let quick = self.max_jerk_density.filter(|most| kalman && *most < render.jerk_density);
        let coupling = render.coupling_stiffness;
        let coupled =
            self.max_coupling_stiffness.filter(|most| coupling <= 0.0 || *most < coupling);
        let coupled = coupled.map(|most| Lack {
            needed: format!(
                "a coupling_stiffness of at most {}, not {}",
                number(most),
                if coupling <= 0.0 { "none".to_owned() } else { number(coupling) }
            ),
            setting: format!("render.coupling_stiffness={}", number(most)),
        });
        let damping = render.coupling_damping;
        let damped = self.min_coupling_damping.filter(|least| damping < *least).map(|least| Lack {
            needed: format!(
                "a coupling_damping of at least {}, not {}",
                number(least),
                number(damping)
            ),
            setting: format!("render.coupling_damping={}", number(least)),
        });
        [
            coupled,
            damped,
            rate,
            estimator,
            reconstruction,
            slow.map(|least| density(least, "least")),
            quick.map(|most| density(most, "most")),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    fn summary(&self) -> String {
        let parts = [
            self.min_tick_hz.map(|it| format!("tick_hz >= {it}")),
            self.estimator.map(|it| format!("estimator {}", it.name())),
            self.reconstruction.map(|it| format!("reconstruction {}", it.name())),
            self.min_jerk_density.map(|it| format!("jerk_density >= {}", number(it))),
            self.max_jerk_density.map(|it| format!("jerk_density <= {}", number(it))),
            self.max_coupling_stiffness.map(|it| format!("coupling_stiffness <= {}", number(it))),
            self.min_coupling_damping.map(|it| format!("coupling_damping >= {}", number(it))),
        ];
        parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
    }
}

struct Lack {
    needed: String,
    setting: String,
}

/// Tick rate and estimator of a scene, compared with the needs of its instruments.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoopSettings<'a> {
    pub(super) tick_hz: u32,
    pub(super) render: &'a Render,
}
